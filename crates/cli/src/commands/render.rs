mod imu;
mod oak;
mod opened;
mod report;
mod request;
mod wanted;

use std::ops::ControlFlow;

use oaktwin::dataset::{self, FormatKind, FormatWriter, Writer};
use oaktwin::diagnostic::{Finding, Level};
use oaktwin::files::OutputFiles;
use oaktwin::render::trajectory;
use oaktwin::render::{self, Rig, RigError};

use crate::args::RenderArgs;
use crate::context::{Context, Exit, Result};
use opened::Opened;
use report::RenderReport;

pub(crate) fn run(context: &Context, args: &RenderArgs) -> Result<Exit> {
    let output = request::output(args)?;
    let spec = request::spec(args)?;
    let path = args.trajectory.as_deref().map(trajectory::read);
    let path = path.transpose()?.unwrap_or_default();
    args.threads.apply();
    let oak = oak::of(context, args)?;
    let mut opened = Opened::new(args)?;
    let mut findings = std::mem::take(&mut opened.scene.findings);
    findings.extend(opened.finding.take());
    findings.extend(wanted::unused(args, &spec.annotators));
    let path = opened.in_world(path);
    let scene = &opened.scene;
    let (rig, more) = match &oak {
        Some((twin, _)) => {
            let world_from_body = opened.place(request::place(args, scene.scene.up)?);
            let (rig, more) = Rig::new(twin, &spec).map_err(|error| in_scene(args, error))?;
            let rig = rig.at(&world_from_body);
            match args.shutter.twist()? {
                Some(twist) => (rig.moving(twist), more),
                None => (rig, more),
            }
        }
        None => {
            let (rig, more) = Rig::of_stage(scene, &spec).map_err(|error| in_scene(args, error))?;
            oak::alone(&rig, &path)?;
            (rig, more)
        }
    };
    findings.extend(more);
    let twin = oak.as_ref().map(|(twin, _)| twin);
    let samples = imu::simulation(context, args, twin, &path, scene.scene.up)?;
    let samples = take_findings(samples, &mut findings);
    let is_alone = output.is_none();
    let times_s = opened.times_s(args, &path);
    let record = |file| render::FrameRecorder::create(file, &rig, &times_s, is_alone);
    let recorder = args.record.as_deref().map(record).transpose()?;
    let mut recorder = take_findings(recorder, &mut findings);
    if let (Some(recorder), Some(samples)) = (&mut recorder, &samples) {
        recorder.add_imu(samples);
    }
    if args.strict {
        reject_warnings(args, &findings)?;
    }
    rig.check_memory(recorder.is_some())?;
    let ControlFlow::Continue(imu_report) = imu::write(samples, args)? else {
        return Ok(Exit::Interrupted);
    };
    let mut files = output.as_deref().map(OutputFiles::in_folder).transpose()?;
    let mut writer = writer(args)?;
    let outputs = render::Outputs {
        dataset: files.as_mut().map(|files| (&mut *writer as _, files)),
        recorder,
    };
    let wanted = times_s.len().max(1);
    let mut written = opened.write(args, (&rig, &spec), &path, outputs)?;
    findings.append(&mut written.findings);

    let report = RenderReport::new(
        (args, output.as_deref()),
        &rig,
        (
            written,
            files.as_ref().map(|files| files.files().to_vec()),
            imu_report,
        ),
        wanted,
        findings,
        oak.map(|(_, findings)| findings).unwrap_or_default(),
    );
    report.print(args)?;
    Ok(if report.is_interrupted {
        Exit::Interrupted
    } else {
        Exit::Success
    })
}

/// Names the scene in an error about the depth sensors of its cameras.
fn in_scene(args: &RenderArgs, error: RigError) -> Box<dyn std::error::Error> {
    match error {
        RigError::Sensor(_) | RigError::NoDepthSensor(_) => {
            format!("{}: {error}", args.scene.display()).into()
        }
        error => error.into(),
    }
}

/// Takes the findings out of a result.
fn take_findings<T>(made: Option<(T, Vec<Finding>)>, findings: &mut Vec<Finding>) -> Option<T> {
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
    let options = dataset::WriterOptions {
        extras: args.outputs.extras(),
        ..dataset::WriterOptions::default()
    };
    // A format that describes objects is for `generate`.
    let format = (format.create)(options, &[]);
    Ok(Box::new(FormatWriter::new(format)))
}
