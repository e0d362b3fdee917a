//! Rendering of frames and writing of their files.

use std::ops::ControlFlow;

use oaktwin_render::{AnnotateOptions, Backend, Renderer, View};

use super::camera::PlacedCamera;
use super::depth_sensor::{self, scene_annotators};
use super::recorder::{FRAME_RATE, FrameRecorder};
use super::sweep::SweptSensors;
use super::trajectory::TimedPose;
use crate::pair::{Pair, PairCameras};
use crate::progress::Watch;
use crate::recording::RecordingFileError;
use crate::sensor::{EngineInput, Sensor, sensor_view};
use crate::write::{Producer, write_while};
use oaktwin_base::diagnostic::{Finding, Level, message, opt};
use oaktwin_camera::RigidTransform;
use oaktwin_dataset::{self as dataset, CameraParams, Layer, LayerData, Shot, WriteError, Writer};
use oaktwin_files::{FileError, OutputFiles, WrittenFile};
use oaktwin_image::annotation::Annotator;
use oaktwin_image::png;

/// The frames to render.
#[derive(Clone, Copy, Debug)]
pub struct FrameOptions<'a> {
    /// The annotators to write.
    pub annotators: &'a [Annotator],
    /// The depth sensor of each camera, fresh from [`depth_sensors`](super::depth_sensors). Without one, a camera has no
    /// depth sensor annotations.
    pub sensors: &'a [Option<Sensor>],
    /// The stereo pair, for engines that match one; without it they measure nothing.
    pub pair: Option<&'a PairCameras>,
    /// The fresh sensors of a sweep, which writes a sheet for each frame of each depth camera.
    pub sweep: Option<&'a SweptSensors>,
    /// The visibility backend.
    pub backend: Backend,
    /// Whether the images of the [`pair`](Self::pair) are written as PNG: `left`, `right`, `rectified_left`,
    /// `rectified_right`.
    pub writes_pair: bool,
    /// Whether shots describe the [`pair`](Self::pair) for formats that have one.
    pub describes_pair: bool,
    /// Whether a warning is an error.
    pub strict: bool,
}

/// The outputs of rendered frames.
#[expect(missing_debug_implementations, reason = "writers have none")]
pub struct Outputs<'a> {
    /// The writer of a data set, and its folder.
    pub dataset: Option<(&'a mut dyn Writer, &'a mut OutputFiles)>,
    /// A recording of all frames.
    pub recorder: Option<FrameRecorder>,
}

/// The result of writing frames.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Written {
    /// The number of frames with the files of every camera.
    pub frames: usize,
    /// The recording, if it is complete.
    pub recording: Option<WrittenFile>,
    /// The renderer's findings, without duplicates.
    pub findings: Vec<Finding>,
    /// Whether the task was interrupted.
    pub is_interrupted: bool,
}

/// An error while frames are rendered or written. Files that are complete are kept.
#[derive(Debug, thiserror::Error)]
pub enum FramesError {
    /// A file cannot be encoded or written.
    #[error(transparent)]
    Write(#[from] WriteError),
    /// A recording cannot be written.
    #[error(transparent)]
    Recording(#[from] RecordingFileError),
    /// A warning, with [`FrameOptions::strict`].
    #[error("{0}")]
    Strict(Finding),
}

impl From<FileError> for FramesError {
    fn from(error: FileError) -> Self {
        Self::Write(error.into())
    }
}

/// Renders a frame for each pose of `path`, or one at the cameras' own poses if `path` is empty, simulates the depth sensors
/// and writes the results.
///
/// A data set has the files of a single camera in the folder itself, and the files of several cameras in folders by camera and
/// annotator. A recording is written as a whole or not at all.
///
/// # Errors
/// Returns an error if a file cannot be written, or for a warning if those are errors.
pub fn write_frames(
    renderer: &Renderer,
    cameras: &[PlacedCamera],
    path: &[TimedPose],
    options: &FrameOptions<'_>,
    outputs: Outputs<'_>,
    watch: &Watch<'_>,
) -> Result<Written, FramesError> {
    let Outputs {
        dataset,
        mut recorder,
    } = outputs;
    let mut no_files = OutputFiles::default();
    let mut writers: Vec<&mut dyn Writer> = Vec::new();
    let output = match dataset {
        Some((writer, output)) => {
            writers.push(writer);
            output
        }
        None => &mut no_files,
    };
    writers.extend(recorder.as_mut().map(|recorder| recorder as &mut dyn Writer));
    let mut findings = cast_instead(cameras, options.backend);
    let total = path.len().max(1) as u64 * cameras.len() as u64;
    let written = write_while(&mut writers, output, total, watch, |producer| {
        render_all(renderer, cameras, path, options, &mut findings, producer)
    })?;
    findings.extend(writers.iter_mut().flat_map(|writer| writer.findings()));
    Ok(Written {
        frames: usize::try_from(written.frames)
            .unwrap_or(usize::MAX)
            .checked_div(cameras.len())
            .unwrap_or(0),
        recording: recorder.and_then(FrameRecorder::into_written),
        findings,
        is_interrupted: written.is_interrupted,
    })
}

/// Renders one frame of the camera with this index at its own pose, with its depth sensor: what [`write_frames`] writes for one pose.
///
/// The sensor must not remember earlier frames. Sweeps are not supported.
#[must_use]
pub fn render_shot(
    renderer: &Renderer,
    cameras: &[PlacedCamera],
    index: usize,
    number: usize,
    options: &FrameOptions<'_>,
) -> (Shot, Vec<Finding>) {
    let mut station = Station::new(&cameras[index], index, cameras.len() > 1, options);
    station.look(renderer, (number, None), None, options)
}

fn render_all(
    renderer: &Renderer,
    cameras: &[PlacedCamera],
    path: &[TimedPose],
    options: &FrameOptions<'_>,
    findings: &mut Vec<Finding>,
    producer: &mut Producer<'_>,
) -> Result<ControlFlow<()>, FramesError> {
    let mut sweep = options.sweep.cloned();
    let stations = cameras.iter().enumerate();
    let mut stations: Vec<Station<'_>> = stations
        .map(|(at, camera)| Station::new(camera, at, cameras.len() > 1, options))
        .collect();
    for number in 0..path.len().max(1) {
        let pose = path.get(number).map(|pose| &pose.world_from_mount);
        for station in &mut stations {
            if producer.proceed().is_break() {
                return Ok(ControlFlow::Break(()));
            }
            let (mut shot, more) = station.look(renderer, (number, pose), sweep.as_mut(), options);
            shot.time_ns = time_ns(path, number);
            let warning = more.iter().find(|one| one.level >= Level::Warning);
            if let Some(warning) = warning.filter(|_| options.strict) {
                return Err(FramesError::Strict(warning.clone()));
            }
            for finding in more {
                if !findings.contains(&finding) {
                    findings.push(finding);
                }
            }
            if producer.write(shot).is_break() {
                return Ok(ControlFlow::Break(()));
            }
        }
    }
    Ok(producer.finish())
}

/// The time of a frame: its pose's, or 30 frames per second from 0 if a pose has none.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    clippy::cast_precision_loss,
    reason = "times of files; the cast saturates"
)]
fn time_ns(path: &[TimedPose], number: usize) -> u64 {
    let has_times = path.iter().all(|pose| pose.time_s.is_some());
    let own = path
        .get(number)
        .and_then(|pose| pose.time_s)
        .filter(|_| has_times);
    (own.unwrap_or(number as f64 / FRAME_RATE) * 1e9).round() as u64
}

/// A camera with its sensor, which remembers earlier frames.
struct Station<'a> {
    camera: &'a PlacedCamera,
    index: usize,
    sensor: Option<Sensor>,
    /// Whether its sensor, or one of a sweep's, matches a pair.
    matches: bool,
    needed: Vec<Annotator>,
    /// Whether its files have their own folder, because there are several cameras.
    has_folder: bool,
}

impl<'a> Station<'a> {
    fn new(camera: &'a PlacedCamera, index: usize, has_folder: bool, options: &FrameOptions<'_>) -> Self {
        let is_requested = options.annotators.iter().any(|one| one.is_depth_sensor());
        let sensor = options.sensors.get(index).cloned().flatten();
        let sensor = sensor.filter(|_| is_requested);
        let is_swept = options.sweep.is_some_and(|sweep| sweep.has(index));
        let is_matching = (sensor.iter()).any(|sensor| sensor.engine().kind().input == EngineInput::Pair);
        let needed = scene_annotators(options.annotators, sensor.is_some() || is_swept);
        Self {
            camera,
            index,
            matches: is_matching || options.sweep.is_some_and(|sweep| sweep.matches(index)),
            sensor,
            needed,
            has_folder,
        }
    }

    fn look(
        &mut self,
        renderer: &Renderer,
        (number, pose): (usize, Option<&RigidTransform>),
        sweep: Option<&mut SweptSensors>,
        options: &FrameOptions<'_>,
    ) -> (Shot, Vec<Finding>) {
        let mount = *pose.unwrap_or(&self.camera.world_from_mount);
        let view = self.camera.view(&mount);
        let pair = options.pair.filter(|_| self.matches || options.describes_pair);
        let pair = pair.map(|pair| pair.look(renderer, &mount, number as u64));
        let (mut frame, mut findings) =
            renderer.annotate(&view, &self.needed, options.backend, &AnnotateOptions::default());
        let sheet = sweep.and_then(|sweep| sweep.sheet(self.index, &frame, number as u64, pair.as_ref()));
        if let Some(sensor) = &mut self.sensor {
            let (camera, number) = (&view.camera, number as u64);
            let missing = depth_sensor::sense_frame(
                sensor,
                camera,
                number,
                pair.as_ref(),
                options.annotators,
                &mut frame,
            );
            findings.extend(not_produced(&self.camera.path, sensor, &missing));
        }
        frame.rgb = frame.rgb.filter(|_| options.annotators.contains(&Annotator::Rgb));
        frame.distance_to_image_plane = frame
            .distance_to_image_plane
            .filter(|_| options.annotators.contains(&Annotator::DistanceToImagePlane));
        findings.extend(pair.iter().flat_map(|pair| pair.findings.clone()));
        let stereo =
            (pair.as_ref().filter(|_| options.describes_pair)).map(|pair| pair.images(renderer, &view));
        let mut layers: Vec<Layer> = sheet.into_iter().map(sheet_layer).collect();
        if let Some(pair) = pair.filter(|_| options.writes_pair) {
            layers.extend(pair_layers(pair));
        }
        let wants_params = options.annotators.contains(&Annotator::CameraParams);
        let described = described(self.camera, &view, renderer.scene().meters_per_unit.0);
        let sensor_view =
            (self.sensor.as_ref()).map(|sensor| sensor_view(&sensor.output_camera(&view.camera), &described));
        let shot = Shot {
            layers,
            camera_params: wants_params.then(|| CameraParams::new(&described)),
            sensor_params: sensor_view
                .as_ref()
                .filter(|_| wants_params)
                .map(CameraParams::new),
            view: Some(described),
            stereo,
            sensor_view,
            camera: self.index,
            world_from_mount: mount,
            render_product: self.has_folder.then(|| self.camera.folder.clone()),
            ..Shot::new(frame, number as u64)
        };
        (shot, findings)
    }
}

/// A warning about sensor outputs that this sensor cannot produce.
fn not_produced(place: &str, sensor: &Sensor, missing: &[Annotator]) -> Option<Finding> {
    let names: Vec<&str> = missing.iter().map(|annotator| annotator.name()).collect();
    (!names.is_empty()).then(|| {
        let engine = sensor.engine().kind();
        let filters = match sensor.filters().is_empty() {
            true => "",
            false => " with its filters",
        };
        Finding::new(
            "sensor-output-missing",
            Level::Warning,
            place,
            format!(
                "not supported by {engine}{filters}, skipped: {}",
                names.join(", ")
            ),
            message![
                "remove them from ",
                opt("annotators"),
                ", or choose another ",
                opt("engine")
            ],
        )
    })
}

/// Notes about cameras that the rasterizer does not support.
fn cast_instead(cameras: &[PlacedCamera], backend: Backend) -> Vec<Finding> {
    let cameras = cameras.iter().filter(|camera| {
        let view = camera.view(&camera.world_from_mount);
        backend == Backend::Raster && backend.for_view(&view) != Backend::Raster
    });
    cameras
        .map(|camera| {
            Finding::new(
                "cast-instead",
                Level::Note,
                &camera.path,
                "lens distortion is not supported by the rasterizer; using the ray caster",
                "",
            )
        })
        .collect()
}

fn sheet_layer(sheet: oaktwin_image::Image<[u8; 3]>) -> Layer {
    Layer {
        folder: "sweep",
        name: "sweep".to_owned(),
        data: LayerData::Png(Box::new(move || png::encode(&sheet))),
    }
}

fn pair_layers(pair: Pair) -> impl Iterator<Item = Layer> {
    let images = [
        ("left", pair.left),
        ("right", pair.right),
        ("rectified_left", pair.rectified_left),
        ("rectified_right", pair.rectified_right),
    ];
    images.into_iter().map(|(name, image)| Layer {
        folder: "pair",
        name: name.to_owned(),
        data: LayerData::Png(Box::new(move || image.to_png())),
    })
}

fn described(camera: &PlacedCamera, view: &View, meters_per_unit: f64) -> dataset::View {
    let (attributes, clip) = (&camera.attributes, &camera.clip);
    dataset::View {
        optics: attributes.optics,
        camera: view.camera,
        world_from_camera: view.world_from_camera,
        clipping_range: [clip.near_m, clip.far_m].map(|metres| metres / meters_per_unit),
        meters_per_unit,
        focus_distance: attributes.focus_distance,
        f_stop: attributes.f_stop,
    }
}
