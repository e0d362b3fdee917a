use std::io::Write;
use std::ops::ControlFlow;
use std::path::PathBuf;
use std::sync::mpsc::{Receiver, sync_channel};
use std::thread;

use rayon::prelude::*;

use super::image_sensor::check_engine;
use super::images::{self, Images};
use super::picture::Pictures;
use super::plan::{self, DepthFile, Sequence};
use super::shot::OutputContext;
use super::stream::StreamWriter;
use super::{FieldOfView, SenseError, SenseInput, SenseOptions, camera};
use crate::align;
use crate::input::check_depth_scale;
use crate::input::reader::DepthImageReader;
use crate::limits;
use crate::progress::Watch;
use crate::sensor::{self, Engine, Sensor};
use crate::write::{Producer, write_while};
use oaktwin_base::diagnostic::{Finding, add_new, message, opt};
use oaktwin_camera::{Camera, ImageSize, RigidTransform, UsdOptics};
use oaktwin_catalog::{Twin, TwinCamera, TwinDepthSensor};
use oaktwin_dataset::{self as dataset, Extras, FlatWriter, FrameCamera, InputName, Shot, Writer};
use oaktwin_files::{FileError, OutputFiles, WrittenFile};
use oaktwin_image::Image;
use oaktwin_image::annotation::Annotator;

/// The number of pixels that are processed at once.
const PIXELS_AT_ONCE: usize = 1 << 24;

/// The destination of the results.
#[expect(missing_debug_implementations, reason = "a stream does not implement it")]
pub enum SenseOutput<'a> {
    /// Files in the folders that the inputs name.
    Files,
    /// The distances of a single input, or the aligned ones, as one NPY array.
    Stream(&'a mut (dyn Write + Send)),
}

/// The result of sensing depth images.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sensed {
    /// The number of images with complete results.
    pub images: u64,
    /// The complete files.
    pub files: Vec<WrittenFile>,
    /// The findings, without duplicates.
    pub findings: Vec<Finding>,
    /// The prims of the sensors, and the names of their engines.
    pub sensors: Vec<(String, String)>,
    /// Whether the task was interrupted.
    pub is_interrupted: bool,
}

/// Simulates a twin's depth sensor on depth images and writes the results. If `watch` interrupts the task, the file in progress
/// is discarded.
///
/// A few images are in memory at a time, not a whole batch, except for arrays in Fortran order.
///
/// # Errors
/// Returns an error if an input cannot be read, an option is invalid or a file cannot be written.
pub fn sense(
    twin: &Twin,
    inputs: &[SenseInput],
    options: &SenseOptions,
    output: SenseOutput<'_>,
    watch: &Watch<'_>,
) -> Result<Sensed, SenseError> {
    check_depth_scale(options.depth_scale).map_err(SenseError::option)?;
    check_engine(options)?;
    let mut sensed = Sensed::default();
    let sequences = plan::sequences(twin, inputs, options, &mut sensed.findings)?;
    let files = || sequences.iter().flat_map(|sequence| &sequence.files);
    let mut output_files = OutputFiles::default();
    output_files.protect(files().map(|file| file.path.as_path()));
    output_files.protect(files().flat_map(|file| &file.rgb).map(PathBuf::as_path));
    let mut writer: Box<dyn Writer + '_> = match output {
        SenseOutput::Files => Box::new(FlatWriter::new(dataset::WriterOptions {
            extras: Extras {
                ply: false,
                ..options.extras
            },
            ..dataset::WriterOptions::default()
        })),
        SenseOutput::Stream(stream) => Box::new(StreamWriter {
            stream,
            has_begun: false,
        }),
    };
    let mut findings = Vec::new();
    let total = files().count() as u64;
    let written = write_while(&mut [&mut *writer], &mut output_files, total, watch, |producer| {
        let mut run = Run {
            twin,
            options,
            producer,
            findings: &mut findings,
            sensors: &mut sensed.sensors,
        };
        for sequence in &sequences {
            if run.sequence(sequence)?.is_break() {
                return Ok(ControlFlow::Break(()));
            }
        }
        Ok::<_, SenseError>(ControlFlow::Continue(()))
    })?;
    add_new(&mut sensed.findings, findings);
    sensed.images = written.complete;
    sensed.is_interrupted = written.is_interrupted;
    sensed.files = output_files.files().to_vec();
    Ok(sensed)
}

struct Run<'a, 'b, 'c> {
    twin: &'a Twin,
    options: &'a SenseOptions,
    producer: &'b mut Producer<'c>,
    findings: &'b mut Vec<Finding>,
    sensors: &'b mut Vec<(String, String)>,
}

/// The state of a sequence that does not change from frame to frame.
struct Session<'a> {
    /// The first file, and its size.
    first: PathBuf,
    size: ImageSize,
    images: Images,
    /// Whether the image's camera was read from its file's `camera_params`.
    is_by_params: bool,
    output: OutputContext<'a>,
}

/// An input image.
struct InputImage {
    z: Image<f32>,
    rgb: Option<Image<[u8; 4]>>,
    frame: u64,
    item: u32,
}

impl<'a> Run<'a, '_, '_> {
    /// Processes the files of a sequence. Each is read while the one before it is measured.
    fn sequence(&mut self, sequence: &Sequence<'a>) -> Result<ControlFlow<()>, SenseError> {
        let scale = self.options.depth_scale;
        thread::scope(|scope| {
            let (sender, sources) = sync_channel(1);
            scope.spawn(move || {
                for file in &sequence.files {
                    let source = open(file, scale);
                    let is_last = source.is_err();
                    if sender.send(source).is_err() || is_last {
                        return;
                    }
                }
            });
            self.sources(sequence, sources)
        })
    }

    fn sources(
        &mut self,
        sequence: &Sequence<'a>,
        sources: Receiver<Result<DepthImageReader, FileError>>,
    ) -> Result<ControlFlow<()>, SenseError> {
        let mut current: Option<(Session<'a>, Sensor)> = None;
        for (file, source) in sequence.files.iter().zip(sources) {
            let source = source?;
            limits::check_memory(&file.path, source.size, limits::sense_bytes(source.size))?;
            let count = source.batch.unwrap_or(1);
            self.producer.expect_more(count as u64 - 1);
            let pictures = Pictures::open(&file.rgb, &file.path, count)?;
            let has_rgb = pictures.is_some();
            let (session, sensor) = match &mut current {
                Some(current) => {
                    current.0.check_same(file, source.size)?;
                    current
                }
                None => current.insert(self.session(sequence, file, source.size)?),
            };
            check_outputs(self.options, &**sensor.engine(), has_rgb, file)?;
            if self.file(session, sensor, file, source, pictures)?.is_break() {
                return Ok(ControlFlow::Break(()));
            }
        }
        Ok(ControlFlow::Continue(()))
    }

    /// Creates the session and the sensor of a sequence.
    fn session(
        &mut self,
        sequence: &Sequence<'a>,
        file: &DepthFile,
        size: ImageSize,
    ) -> Result<(Session<'a>, Sensor), SenseError> {
        let (options, prim) = (self.options, &sequence.sensor.spec.prim);
        let given = images::ImageInput {
            size,
            kind: file.kind,
            params: file.params.as_deref(),
            name: sequence.name.clone(),
        };
        let (images, sensor) = Images::open(self.twin, sequence.sensor, given, options, self.findings)?;
        let looked = images.measured;
        let engine = sensor.engine().kind().name.to_string();
        let used = (prim.clone(), engine);
        if !self.sensors.contains(&used) {
            self.sensors.push(used);
        }
        let reported = sensor.output_camera(&looked);
        let align = options
            .align
            .as_ref()
            .map(|to| align::of_sensor(self.twin, sequence.sensor, &reported, to, options.lens))
            .transpose()
            .map_err(SenseError::option)?;
        let session = Session {
            first: file.path.clone(),
            size,
            is_by_params: options.field_of_view == FieldOfView::Known && file.params.is_some(),
            output: OutputContext {
                options,
                camera: looked,
                view: view(&images.own, sequence.sensor, looked),
                reported,
                align,
            },
            images,
        };
        Ok((session, sensor))
    }

    /// Processes one file.
    fn file(
        &mut self,
        session: &Session<'a>,
        sensor: &mut Sensor,
        file: &DepthFile,
        mut source: DepthImageReader,
        mut pictures: Option<Pictures>,
    ) -> Result<ControlFlow<()>, SenseError> {
        let is_sequence = source.batch.is_none() || self.options.is_sequence;
        let pixels = (source.size.width as usize * source.size.height as usize).max(1);
        let at_once = if is_sequence {
            1
        } else {
            (PIXELS_AT_ONCE / pixels).clamp(1, 4096)
        };
        let mut item = 0usize;
        loop {
            if self.producer.proceed().is_break() {
                return Ok(ControlFlow::Break(()));
            }
            let mut given = Vec::new();
            while given.len() < at_once {
                let Some(z) = source.next_image()? else { break };
                let rgb = match &mut pictures {
                    Some(pictures) => Some(pictures.next(&file.path, source.size)?),
                    None => None,
                };
                let number = item + given.len();
                let (frame, item) = if self.options.is_sequence {
                    (file.frame + number as u64, 0)
                } else {
                    (file.frame, u32::try_from(number).unwrap_or(u32::MAX))
                };
                given.push(InputImage { z, rgb, frame, item });
            }
            if given.is_empty() {
                return Ok(self.producer.finish());
            }
            let input = |index: usize| InputName {
                batch: source.batch,
                item: item + index,
                ..file.results.clone()
            };
            let shots: Vec<Result<Shot, SenseError>> = if is_sequence {
                let shots = given.into_iter().enumerate();
                shots
                    .map(|(index, one)| session.capture(sensor, one, file, input(index)))
                    .collect()
            } else {
                let fresh = &*sensor;
                given
                    .into_par_iter()
                    .enumerate()
                    .map(|(index, one)| session.capture(&mut fresh.clone(), one, file, input(index)))
                    .collect()
            };
            for shot in shots {
                if self.producer.write(shot?).is_break() {
                    return Ok(ControlFlow::Break(()));
                }
                item += 1;
            }
        }
    }
}

impl Session<'_> {
    /// Rejects an image of another size or camera.
    fn check_same(&self, file: &DepthFile, size: ImageSize) -> Result<(), FileError> {
        let differs = |message: String| {
            Err(FileError::new(
                &file.path,
                message,
                "give images of one camera in a sequence",
            ))
        };
        let first = self.first.display();
        if size != self.size {
            return differs(format!("is {size}, but {first} before it is {}", self.size));
        }
        match &file.params {
            Some(params) if self.is_by_params && camera::read_params(params, size)? != self.images.given => {
                differs(format!(
                    "has another camera ({}) than {first} before it",
                    params.display()
                ))
            }
            _ => Ok(()),
        }
    }

    fn capture(
        &self,
        sensor: &mut Sensor,
        given: InputImage,
        file: &DepthFile,
        input: InputName,
    ) -> Result<Shot, SenseError> {
        let InputImage { z, rgb, frame, item } = given;
        let (z, rgb) = self.images.convert(z, rgb);
        let request = self.output.request();
        let mut shot = sensor::DepthShot::new((&z).into());
        shot.frame = frame;
        shot.item = item;
        let of_one_size = |error: oaktwin_depth::ShotError| {
            FileError::new(&file.path, error.to_string(), "give images of the same size")
        };
        if let Some(rgb) = &rgb {
            shot = shot.with_rgb(rgb.into()).map_err(of_one_size)?;
        }
        let capture = sensor::capture(sensor, &self.output.camera, shot.into(), &request)?;
        let params = self.output.params(file.params.as_deref());
        Ok(self.output.shot(sensor, capture, rgb.as_ref(), params, input))
    }
}

fn open(file: &DepthFile, scale: f64) -> Result<DepthImageReader, FileError> {
    if file.is_standard_input {
        DepthImageReader::read(&file.path, Box::new(std::io::stdin()), None, scale)
    } else {
        DepthImageReader::open(&file.path, scale)
    }
}

/// The view of the images of a sensor, at the origin: the numbers of the model's camera, whose focal length in
/// millimetres does not depend on the image.
fn view(own: &TwinCamera, sensor: &TwinDepthSensor, images: Camera) -> FrameCamera {
    let focal_length_um = own.pixel_size_um * own.intrinsics.mean_focal_length();
    let pixel_size_um = focal_length_um / images.intrinsics.mean_focal_length();
    let (near, far) = sensor.spec.clipping_range_m;
    FrameCamera {
        optics: UsdOptics::from_intrinsics(&images.intrinsics, pixel_size_um, Default::default()),
        camera: images,
        world_from_camera: RigidTransform::IDENTITY,
        clipping_range: [near, far],
        meters_per_unit: 1.0,
        focus_distance: sensor.spec.focus_distance,
        f_stop: own.spec.f_stop,
    }
}

/// Rejects annotators that the engine does not support, or that require a missing colour image.
fn check_outputs(
    options: &SenseOptions,
    engine: &dyn Engine,
    has_rgb: bool,
    file: &DepthFile,
) -> Result<(), SenseError> {
    for annotator in &options.annotators {
        let name = annotator.name();
        let is_isaac_only = matches!(
            annotator,
            Annotator::DepthSensorImager | Annotator::DepthSensorOutputVisualization
        );
        if is_isaac_only && !engine.outputs().contains(annotator) {
            return Err(SenseError::option(message![
                opt("annotators").with(name),
                format!(": not supported by {}; remove it, or set ", engine.kind()),
                opt("engine").with("single-view")
            ]));
        }
        if engine.needs_rgb(*annotator) && !has_rgb {
            let remedy = message!["give it as ", opt("rgb"), ", or remove the annotator"];
            let message = format!("no colour image, which {name} requires");
            return Err(FileError::new(&file.path, message, remedy).into());
        }
    }
    Ok(())
}
