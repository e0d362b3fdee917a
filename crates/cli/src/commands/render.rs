mod imu;
mod report;
mod request;
mod sensors;

use std::ops::ControlFlow;

use oaktwin::camera::ImageSize;
use oaktwin::dataset::{self, FormatKind, FormatWriter, Writer};
use oaktwin::diagnostic::{Finding, Level};
use oaktwin::files::OutputFiles;
use oaktwin::image::annotation::Annotator;
use oaktwin::memory;
use oaktwin::render::trajectory::{self, TimedPose};
use oaktwin::render::{
    self, FrameOptions, OakOptions, PlacedCamera, Renderer, SceneCameraOptions, SceneFile,
};
use oaktwin::scene::Up;

use oaktwin::usd::asset::LensChoice;

use crate::args::RenderArgs;
use crate::context::{Context, Exit, Result};
use crate::{progress, size};
use report::Report;
use sensors::Sensors;

pub(crate) fn run(context: &Context, args: &RenderArgs) -> Result<Exit> {
    let output = request::output(args)?;
    let annotators = request::annotators(args)?;
    let size = size::parse("--resolution", args.resolution.as_deref())?;
    let path = args.trajectory.as_deref().map(trajectory::read);
    let path = path.transpose()?.unwrap_or_default();
    args.threads.apply();
    let oak = Oak::new(context, args)?;
    let mut scene = SceneFile::open(&args.scene, &args.scene_options.open_options()?)?;
    let mut findings = std::mem::take(&mut scene.findings);
    findings.extend(request::unused(args, &annotators));
    let (mut cameras, more) = match &oak {
        Some(oak) => oak.cameras(args, size, scene.scene.up)?,
        None => own_cameras(&scene, args, size, &path)?,
    };
    findings.extend(more);
    let pair = sensors::pair(args, &mut cameras, oak.as_ref(), size)?;
    let pair = noted(pair, &mut findings);
    let twin = oak.as_ref().map(|oak| &oak.twin);
    let samples = imu::simulation(context, args, twin, &path, scene.scene.up)?;
    let samples = noted(samples, &mut findings);
    let mut sensors = Sensors::new(args, &annotators, &cameras, oak.as_ref())?;
    findings.append(&mut sensors.findings);
    let is_alone = output.is_none();
    let record =
        |file| render::FrameRecorder::create(file, &cameras, &sensors.own, &path, &annotators, is_alone);
    let recorder = args.record.as_deref().map(record).transpose()?;
    let mut recorder = noted(recorder, &mut findings);
    if let (Some(recorder), Some(samples)) = (&mut recorder, &samples) {
        recorder.add_imu(samples);
    }
    if args.strict {
        reject_warnings(args, &findings)?;
    }
    check_memory(&cameras, &annotators, &sensors, recorder.is_some())?;
    let ControlFlow::Continue(imu_report) = imu::write(samples, args)? else {
        return Ok(Exit::Interrupted);
    };
    let mut files = output.as_deref().map(OutputFiles::in_folder).transpose()?;
    let mut writer = writer(args)?;
    let outputs = render::Outputs {
        dataset: files.as_mut().map(|files| (&mut *writer as _, files)),
        recorder,
    };
    let renderer = Renderer::new(scene.scene);
    let options = FrameOptions {
        annotators: &annotators,
        sensors: &sensors.own,
        pair: pair.as_ref(),
        sweep: sensors.swept.as_ref(),
        backend: args.backend,
        strict: args.strict,
        writes_pair: args.writes_pair,
        describes_pair: false,
    };
    let mut written = progress::watched(|watch| {
        render::write_frames(&renderer, &cameras, &path, &options, outputs, watch)
    })?;
    findings.append(&mut written.findings);

    let calibration_findings = oak.map(|oak| oak.calibration_findings).unwrap_or_default();
    let frames = path.len().max(1);
    let report = Report::new(
        (args, output.as_deref()),
        &annotators,
        (&cameras, &sensors.own),
        (
            written,
            files.as_ref().map(|files| files.files().to_vec()),
            imu_report,
        ),
        frames,
        findings,
        calibration_findings,
    );
    report.print(args)?;
    Ok(if report.is_interrupted {
        Exit::Interrupted
    } else {
        Exit::Success
    })
}

/// Takes the findings out of a result.
fn noted<T>(made: Option<(T, Vec<Finding>)>, findings: &mut Vec<Finding>) -> Option<T> {
    made.map(|(made, more)| {
        findings.extend(more);
        made
    })
}

/// Returns an error for the first warning.
fn reject_warnings(args: &RenderArgs, findings: &[Finding]) -> Result<()> {
    match findings.iter().find(|finding| finding.level >= Level::Warning) {
        Some(finding) => Err(format!("{}: {finding}", args.scene.display()).into()),
        None => Ok(()),
    }
}

/// The writer of the format that is named.
fn writer(args: &RenderArgs) -> Result<Box<dyn Writer>> {
    let format = FormatKind::find(&args.writer)
        .map_err(|remedy| format!("--writer: unknown format '{}'; {remedy}", args.writer))?;
    let options = dataset::Options {
        extras: args.outputs.extras(),
        ..dataset::Options::default()
    };
    // A format that describes objects is for `generate`.
    let format = (format.create)(options, &[]);
    Ok(Box::new(FormatWriter::new(format)))
}

/// The OAK in the scene.
struct Oak {
    twin: oaktwin::catalog::Twin,
    calibration_findings: Vec<Finding>,
}

impl Oak {
    fn new(context: &Context, args: &RenderArgs) -> Result<Option<Self>> {
        let Some(model) = &args.model else {
            let needs = |option: &str| Err(format!("{option} requires --model").into());
            return match &args.unit {
                unit if unit.calibration.is_some() => needs("--calibration"),
                unit if unit.lens == LensChoice::Fisheye => needs("--lens"),
                _ => Ok(None),
            };
        };
        if args.place.is_none() && args.trajectory.is_none() {
            return Err(format!(
                "--model {model} requires a pose: --look-at EYE TARGET, --pose or --trajectory"
            )
            .into());
        }
        let (twin, calibration_findings) = context.twin_with_axes(model, &args.unit, &args.imu.axes)?;
        Ok(Some(Self {
            twin,
            calibration_findings,
        }))
    }

    fn cameras(
        &self,
        args: &RenderArgs,
        size: Option<ImageSize>,
        up: Up,
    ) -> Result<(Vec<PlacedCamera>, Vec<Finding>)> {
        let options = OakOptions {
            cameras: &args.camera,
            lens: args.unit.lens,
            size,
        };
        Ok(render::oak_cameras(
            &self.twin,
            &request::place(args, up)?,
            &options,
        )?)
    }
}

fn own_cameras(
    scene: &SceneFile,
    args: &RenderArgs,
    size: Option<ImageSize>,
    path: &[TimedPose],
) -> Result<(Vec<PlacedCamera>, Vec<Finding>)> {
    let options = SceneCameraOptions {
        cameras: &args.camera,
        size,
        projection: args.projection,
    };
    let (cameras, findings) = render::scene_cameras(scene, &options)?;
    if let ([first, second, ..], [_, ..]) = (&cameras[..], path) {
        return Err(format!(
            "--trajectory moves one camera, but there are {} ({}, {}{}); choose one with --camera",
            cameras.len(),
            first.path,
            second.path,
            if cameras.len() > 2 { ", …" } else { "" }
        )
        .into());
    }
    Ok((cameras, findings))
}

/// Rejects images that need more memory than is available, if that is known.
fn check_memory(
    cameras: &[PlacedCamera],
    annotators: &[Annotator],
    sensors: &Sensors,
    is_recorded: bool,
) -> Result<()> {
    let mut made = render::scene_annotators(annotators, !sensors.own.is_empty());
    made.extend(annotators.iter().filter(|one| one.is_depth_sensor()));
    let needs = |camera: &&PlacedCamera| {
        let size = camera.camera.intrinsics.size;
        let recorded = if is_recorded {
            render::record_bytes(size)
        } else {
            0
        };
        render::frame_bytes(size, &made) + recorded
    };
    let Some(largest) = cameras.iter().max_by_key(needs) else {
        return Ok(());
    };
    let needed = needs(&largest);
    memory::check(needed).map_err(|shortage| {
        format!(
            "{}: images of {}: {}; choose a smaller --resolution or fewer --annotators, or {}",
            largest.path,
            largest.camera.intrinsics.size,
            shortage.what(),
            shortage.remedy()
        )
        .into()
    })
}
