//! Frame after frame: rendered, encoded and written, the next one rendered while the last is written.

use std::ops::ControlFlow;
use std::path::Path;
use std::sync::mpsc;
use std::thread;

use oaktwin_render::{AnnotateOptions, Backend, Renderer, View};
use rayon::prelude::*;

use super::camera::PlacedCamera;
use super::depth_sensor::{self, scene_annotators};
use super::output_folder::OutputFolder;
use super::recorder::FrameRecorder;
use super::sweep::SweptSensors;
use super::trajectory::TimedPose;
use crate::pair::{Pair, PairCameras};
use crate::recording::RecordingFileError;
use crate::sensor::{EngineInput, Sensor};
use oaktwin_camera::RigidTransform;
use oaktwin_dataset::{self as dataset, BasicWriter, CameraParams, DatasetError, Extras, Shot};
use oaktwin_diagnostic::{Finding, Level, message, opt};
use oaktwin_files::{FileError, WrittenFile};
use oaktwin_image::annotation::{Annotator, Frame};
use oaktwin_image::{CodecError, Image, png};

/// What to render, and into which files.
#[derive(Clone, Copy, Debug)]
pub struct FrameOptions<'a> {
    /// What to write.
    pub annotators: &'a [Annotator],
    /// The depth sensor of each camera that has one, as [`depth_sensors`](super::depth_sensors) makes them: fresh ones.
    /// Without one a camera has none of a depth sensor's annotations.
    pub sensors: &'a [Option<Sensor>],
    /// What takes the pairs of engines that match one; without it they measure nothing.
    pub pair: Option<&'a PairCameras>,
    /// The sensors of a sweep, fresh ones: a sheet for each frame of each depth sensor's camera.
    pub sweep: Option<&'a SweptSensors>,
    /// How to find what a pixel sees.
    pub backend: Backend,
    /// What is written beside the files of Replicator's `BasicWriter`.
    pub extras: Extras,
    /// Whether what a [`pair`](Self::pair) records is written too, PNG: `left`, `right`, `rectified_left`,
    /// `rectified_right`, each with the frame's number.
    pub writes_pair: bool,
    /// Whether a warning of the renderer is an error.
    pub strict: bool,
    /// Whether [`Written::files`] is wanted: it grows with every frame.
    pub list_files: bool,
}

/// Where frames go.
#[derive(Debug)]
pub struct Outputs<'a> {
    /// A folder for the files of Replicator's `BasicWriter`.
    pub folder: Option<&'a mut OutputFolder>,
    /// A recording of all frames.
    pub recorder: Option<FrameRecorder>,
}

/// What was written.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Written {
    /// Frames of which every camera's files are there.
    pub frames: usize,
    /// The files, in the order of frames, then cameras, where they were [asked for](FrameOptions::list_files).
    pub files: Vec<WrittenFile>,
    /// The recording, which is there only when all frames are in it.
    pub recording: Option<WrittenFile>,
    /// What the renderer had to say, each once.
    pub findings: Vec<Finding>,
    /// Whether the caller asked to stop before the end.
    pub is_interrupted: bool,
}

/// How far it is: images that are rendered, of all.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Done {
    /// So many are rendered.
    pub images: u64,
    /// Of so many.
    pub of: u64,
}

/// Why frames could not be written. The files before it are whole, and stay.
#[derive(Debug, thiserror::Error)]
pub enum FramesError {
    /// A file could not be written.
    #[error(transparent)]
    File(#[from] FileError),
    /// A recording could not be written.
    #[error(transparent)]
    Recording(#[from] RecordingFileError),
    /// A file could not be encoded.
    #[error("{0}")]
    Dataset(#[from] DatasetError),
    /// A warning of the renderer, with [`FrameOptions::strict`].
    #[error("{0}")]
    Strict(Finding),
}

/// An image on its way to its files.
struct Rendered<'a> {
    camera: &'a PlacedCamera,
    /// Which camera it is.
    at: usize,
    number: usize,
    mount: RigidTransform,
    view: View,
    frame: Frame,
    sheet: Option<Image<[u8; 3]>>,
    /// Where it is to be written.
    pair: Option<Pair>,
}

/// Renders a frame for each pose of `path`, or the one where the cameras stand where `path` is empty, with every camera,
/// lets the cameras' depth sensors look at it, and writes it. `watch` is asked before each image and after it; where it breaks, what is rendered then is dropped.
///
/// The files are those of Replicator's `BasicWriter`: one camera's in the folder itself, those of several in folders by
/// camera and annotator. A recording is there when it is whole, or not at all.
///
/// # Errors
/// A file cannot be written, or there is a warning where none may be.
pub fn write_frames(
    renderer: &Renderer,
    cameras: &[PlacedCamera],
    path: &[TimedPose],
    options: &FrameOptions<'_>,
    outputs: Outputs<'_>,
    watch: &mut dyn FnMut(Done) -> ControlFlow<()>,
) -> Result<Written, FramesError> {
    let poses: Vec<Option<&RigidTransform>> = if path.is_empty() {
        vec![None]
    } else {
        path.iter().map(|pose| Some(&pose.world_from_mount)).collect()
    };
    let jobs = poses
        .iter()
        .enumerate()
        .flat_map(|(number, pose)| (0..cameras.len()).map(move |at| (number, *pose, at)));
    let mut stations: Vec<Station<'_>> = cameras
        .iter()
        .enumerate()
        .map(|(at, camera)| Station::new(camera, at, options))
        .collect();
    let mut done = Done {
        images: 0,
        of: poses.len() as u64 * cameras.len() as u64,
    };
    let meters_per_unit = renderer.scene().meters_per_unit.0;
    let mut findings = cast_instead(cameras, options.backend);
    let mut stop = None;
    // The writer takes an image when it has written the one before: never more than two are there.
    let (sender, receiver) = mpsc::sync_channel::<Rendered<'_>>(0);
    let Outputs { folder, mut recorder } = outputs;
    let in_folders = cameras.len() > 1;
    let (files, images) = thread::scope(|scope| {
        let writer = scope.spawn(|| {
            let mut writer =
                folder.map(|folder| FolderWriter::new(folder, in_folders, meters_per_unit, options));
            let mut count = 0usize;
            for image in receiver {
                if let Some(writer) = &mut writer {
                    writer.write(&image)?;
                }
                if let Some(recorder) = &mut recorder {
                    recorder.record(image.at, image.number, &image.mount, &image.frame)?;
                }
                count += 1;
            }
            let files = writer.map(|writer| writer.files).unwrap_or_default();
            Ok::<_, FramesError>((files, count))
        });
        let mut sweep = options.sweep.cloned();
        for (number, pose, at) in jobs {
            let Some(station) = stations.get_mut(at) else {
                continue;
            };
            if watch(done).is_break() {
                stop = Some(Ok(()));
                break;
            }
            let (rendered, more) = station.look(renderer, (number, pose), sweep.as_mut(), options);
            done.images += 1;
            if let Some(warning) = more
                .iter()
                .find(|one| options.strict && one.level >= Level::Warning)
            {
                stop = Some(Err(FramesError::Strict(warning.clone())));
                break;
            }
            for finding in more {
                if !findings.contains(&finding) {
                    findings.push(finding);
                }
            }
            let is_interrupted = watch(done).is_break() && done.images < done.of;
            if is_interrupted {
                stop = Some(Ok(()));
                break;
            }
            // The writer is gone only when it failed, which it says below.
            if sender.send(rendered).is_err() {
                break;
            }
        }
        drop(sender);
        writer
            .join()
            .unwrap_or_else(|panic| std::panic::resume_unwind(panic))
    })?;
    let is_interrupted = match stop {
        Some(Err(error)) => return Err(error),
        Some(Ok(())) => true,
        None => false,
    };
    let recording = match recorder.filter(|_| !is_interrupted) {
        Some(recorder) => {
            let (path, bytes) = recorder.finish()?;
            Some(WrittenFile { path, bytes })
        }
        None => None,
    };
    Ok(Written {
        frames: images.checked_div(cameras.len()).unwrap_or(0),
        files,
        recording,
        findings,
        is_interrupted,
    })
}

/// A camera while frames are made: its sensor remembers those before.
struct Station<'a> {
    camera: &'a PlacedCamera,
    index: usize,
    sensor: Option<Sensor>,
    /// Whether it, or one of a sweep, matches a pair.
    matches: bool,
    needed: Vec<Annotator>,
}

impl<'a> Station<'a> {
    fn new(camera: &'a PlacedCamera, index: usize, options: &FrameOptions<'_>) -> Self {
        let is_asked = options.annotators.iter().any(|one| one.is_depth_sensor());
        let sensor = options.sensors.get(index).cloned().flatten();
        let sensor = sensor.filter(|_| is_asked);
        let is_swept = options.sweep.is_some_and(|sweep| sweep.has(index));
        let is_matching = (sensor.iter()).any(|sensor| sensor.engine().kind().input == EngineInput::Pair);
        let needed = scene_annotators(options.annotators, sensor.is_some() || is_swept);
        Self {
            camera,
            index,
            matches: is_matching || options.sweep.is_some_and(|sweep| sweep.matches(index)),
            sensor,
            needed,
        }
    }

    fn look(
        &mut self,
        renderer: &Renderer,
        (number, pose): (usize, Option<&RigidTransform>),
        sweep: Option<&mut SweptSensors>,
        options: &FrameOptions<'_>,
    ) -> (Rendered<'a>, Vec<Finding>) {
        let mount = *pose.unwrap_or(&self.camera.world_from_mount);
        let view = self.camera.view(&mount);
        let pair = options.pair.filter(|_| self.matches);
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
        let rendered = Rendered {
            camera: self.camera,
            at: self.index,
            number,
            mount,
            view,
            frame,
            sheet,
            pair: pair.filter(|_| options.writes_pair),
        };
        (rendered, findings)
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

/// Cameras that are not rasterized although somebody asked for it.
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
                "its lens bends rays, which the rasterizer cannot: rays are cast instead",
                "",
            )
        })
        .collect()
}

/// Writes images into the folder.
struct FolderWriter<'a> {
    folder: &'a mut OutputFolder,
    in_folders: bool,
    meters_per_unit: f64,
    options: &'a FrameOptions<'a>,
    writer: BasicWriter,
    has_metadata: bool,
    files: Vec<WrittenFile>,
}

impl<'a> FolderWriter<'a> {
    fn new(
        folder: &'a mut OutputFolder,
        in_folders: bool,
        meters_per_unit: f64,
        options: &'a FrameOptions<'a>,
    ) -> Self {
        Self {
            folder,
            in_folders,
            meters_per_unit,
            options,
            writer: BasicWriter::new(dataset::Options {
                extras: options.extras,
                ..dataset::Options::default()
            }),
            has_metadata: false,
            files: Vec::new(),
        }
    }

    fn put(&mut self, path: &str, bytes: &[u8]) -> Result<(), FramesError> {
        let path = self.folder.write(Path::new(path), bytes)?;
        if self.options.list_files {
            let bytes = bytes.len() as u64;
            self.files.push(WrittenFile { path, bytes });
        }
        Ok(())
    }

    fn write(&mut self, image: &Rendered<'_>) -> Result<(), FramesError> {
        if !std::mem::replace(&mut self.has_metadata, true) {
            let metadata = self.writer.metadata();
            self.put(metadata.path(), &metadata.bytes()?)?;
        }
        let params = self
            .options
            .annotators
            .contains(&Annotator::CameraParams)
            .then(|| image.params(self.meters_per_unit));
        let shot = Shot {
            frame: &image.frame,
            camera_params: params.as_ref(),
            number: image.number as u64,
            render_product: self.in_folders.then_some(&image.camera.folder),
        };
        let listed = self.writer.files(&shot);
        let encoded: Vec<Result<Vec<u8>, DatasetError>> =
            listed.par_iter().map(dataset::DatasetFile::bytes).collect();
        for (file, bytes) in listed.iter().zip(encoded) {
            self.put(file.path(), &bytes?)?;
        }
        if let Some(sheet) = &image.sheet {
            self.put_png(image, "sweep", "sweep", png::encode(sheet))?;
        }
        if let Some(pair) = &image.pair {
            let images = [
                ("left", &pair.left),
                ("right", &pair.right),
                ("rectified_left", &pair.rectified_left),
                ("rectified_right", &pair.rectified_right),
            ];
            for (name, image_of_pair) in images {
                self.put_png(image, "pair", name, image_of_pair.to_png())?;
            }
        }
        Ok(())
    }

    /// Puts a picture into the folder, or, where cameras have folders, into one of this camera's.
    fn put_png(
        &mut self,
        image: &Rendered<'_>,
        folder: &str,
        name: &str,
        bytes: Result<Vec<u8>, CodecError>,
    ) -> Result<(), FramesError> {
        let file = format!("{name}_{:04}.png", image.number);
        let path = if self.in_folders {
            format!("{}/{folder}/{file}", image.camera.folder)
        } else {
            file
        };
        match bytes {
            Ok(bytes) => self.put(&path, &bytes),
            Err(source) => Err(DatasetError::Codec { path, source }.into()),
        }
    }
}

impl Rendered<'_> {
    fn params(&self, meters_per_unit: f64) -> CameraParams {
        let attributes = &self.camera.attributes;
        let clip = &self.camera.clip;
        CameraParams::new(&dataset::View {
            optics: attributes.optics,
            camera: self.view.camera,
            world_from_camera: self.view.world_from_camera,
            clipping_range: [clip.near_m, clip.far_m].map(|metres| metres / meters_per_unit),
            meters_per_unit,
            focus_distance: attributes.focus_distance,
            f_stop: attributes.f_stop,
        })
    }
}
