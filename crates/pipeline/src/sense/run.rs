use std::io::Write;
use std::ops::ControlFlow;
use std::path::PathBuf;

use rayon::prelude::*;

use super::geometry::{places, positions, resample, z_of_range};
use super::options::ImageCamera;
use super::picture::Pictures;
use super::plan::{self, DepthFile, Sequence};
use super::product::{Look, Product, reported};
use super::writer::{Place, Writer};
use super::{FieldOfView, Input, InputKind, SenseError, SenseOptions, camera, rig};
use crate::input::source::Source;
use crate::sensor::{Engine, EngineInput, Sensor, SensorOptions, Shot, needs_a_pair, sensor};
use oaktwin_camera::{Camera, ImageSize, LensModel};
use oaktwin_catalog::Twin;
use oaktwin_diagnostic::{Finding, Level, message, opt};
use oaktwin_files::{FileError, WrittenFile};
use oaktwin_image::Image;
use oaktwin_image::annotation::Annotator;

/// Pixels that are worked on at once.
const PIXELS_AT_ONCE: usize = 1 << 24;

/// Where results go.
#[expect(missing_debug_implementations, reason = "a stream has none")]
pub enum Output<'a> {
    /// To files in the folders that the inputs name.
    Files,
    /// The distances, or what is aligned of them, as one NPY; for one input.
    Stream(&'a mut dyn Write),
}

/// How far it is: images that are written, of those that are known of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Done {
    /// So many are written.
    pub images: u64,
    /// Of so many.
    pub of: u64,
}

/// What was written.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sensed {
    /// Images whose results are whole.
    pub images: u64,
    /// Whole ones.
    pub files: Vec<WrittenFile>,
    /// What is not as the model says, and what was chosen, each once.
    pub findings: Vec<Finding>,
    /// The prims of the sensors, and the names of their engines.
    pub sensors: Vec<(String, &'static str)>,
    /// Whether the caller asked to stop before the end.
    pub is_interrupted: bool,
}

/// Shows depth images to the sensor of a twin and writes what it reports. `watch` is asked before each part; where it
/// breaks, the file that is being written is dropped.
///
/// Memory is that of some images, not of a batch, but for arrays whose first axis is the fastest, which are read whole.
///
/// # Errors
/// An input that cannot be read or understood, options that make no sensor, a file that cannot be written.
pub fn sense(
    twin: &Twin,
    inputs: &[Input],
    options: &SenseOptions,
    output: Output<'_>,
    watch: &mut dyn FnMut(Done) -> ControlFlow<()>,
) -> Result<Sensed, SenseError> {
    if !(options.depth_scale.is_finite() && options.depth_scale > 0.0) {
        return Err(SenseError::option(message![
            opt("depth-scale"),
            format!(
                ": must be a finite number > 0 (got {}); give metres per integer depth unit",
                options.depth_scale
            )
        ]));
    }
    if let Some(engine) = options
        .sensor
        .engine
        .filter(|kind| kind.input == EngineInput::Pair)
    {
        return Err(needs_a_pair(engine, "the input is a depth image").into());
    }
    let mut sensed = Sensed::default();
    let sequences = plan::sequences(twin, inputs, options, &mut sensed.findings)?;
    let files = || sequences.iter().flat_map(|sequence| &sequence.files);
    let pictures = files().flat_map(|file| &file.rgb);
    let writer = Writer::new(
        output,
        files()
            .map(|file| file.path.as_path())
            .chain(pictures.map(PathBuf::as_path)),
    );
    let mut run = Run {
        twin,
        options,
        writer,
        watch,
        images: 0,
        whole: 0,
        of: files().count() as u64,
        findings: Vec::new(),
        sensors: Vec::new(),
    };
    for sequence in &sequences {
        match run.sequence(sequence) {
            Ok(ControlFlow::Continue(())) => {}
            Ok(ControlFlow::Break(())) => {
                sensed.is_interrupted = true;
                break;
            }
            Err(error) => return Err(error),
        }
    }
    sensed.images = run.whole;
    sensed.findings.append(&mut run.findings);
    let mut seen = Vec::new();
    sensed.findings.retain(|finding| {
        let is_new = !seen.contains(finding);
        if is_new {
            seen.push(finding.clone());
        }
        is_new
    });
    sensed.sensors = run.sensors;
    sensed.files = run.writer.files;
    Ok(sensed)
}

struct Run<'a, 'b, 'c> {
    twin: &'a Twin,
    options: &'a SenseOptions,
    writer: Writer<'b>,
    watch: &'c mut dyn FnMut(Done) -> ControlFlow<()>,
    images: u64,
    /// Of files that are finished.
    whole: u64,
    of: u64,
    findings: Vec<Finding>,
    sensors: Vec<(String, &'static str)>,
}

/// What does not change within a sequence.
struct Eye<'a> {
    /// The first file, and its size.
    first: PathBuf,
    size: ImageSize,
    image: Camera,
    /// Whether the image's camera was read from its file's `camera_params`.
    is_by_params: bool,
    /// Of distances from the optical centre.
    z_of_range: Option<Vec<f32>>,
    /// Where the model's pixels lie in the images.
    places: Option<Vec<Option<usize>>>,
    look: Look<'a>,
}

/// One image on its way.
struct Given {
    z: Image<f32>,
    rgb: Option<Image<[u8; 4]>>,
    frame: u64,
    item: u32,
}

impl<'a> Run<'a, '_, '_> {
    fn sequence(&mut self, sequence: &Sequence<'a>) -> Result<ControlFlow<()>, SenseError> {
        let mut seeing: Option<(Eye<'a>, Sensor)> = None;
        for file in &sequence.files {
            let scale = self.options.depth_scale;
            let source = if file.is_standard_input {
                Source::read(&file.path, Box::new(std::io::stdin()), None, scale)?
            } else {
                Source::open(&file.path, scale)?
            };
            let count = source.batch.unwrap_or(1);
            self.of += count as u64 - 1;
            let pictures = Pictures::open(&file.rgb, &file.path, count)?;
            let has_pictures = pictures.is_some();
            let (eye, sensor) = match &mut seeing {
                Some(seeing) => {
                    seeing.0.check_same(file, source.size)?;
                    seeing
                }
                None => seeing.insert(self.eye(sequence, file, source.size)?),
            };
            check_outputs(self.options, &**sensor.engine(), has_pictures, file)?;
            if self.file(eye, sensor, file, source, pictures)?.is_break() {
                return Ok(ControlFlow::Break(()));
            }
        }
        Ok(ControlFlow::Continue(()))
    }

    /// What a sequence of images of this size is looked at with, nothing being remembered yet.
    fn eye(
        &mut self,
        sequence: &Sequence<'a>,
        file: &DepthFile,
        size: ImageSize,
    ) -> Result<(Eye<'a>, Sensor), SenseError> {
        let (options, prim) = (self.options, &sequence.sensor.spec.prim);
        let own = self.twin.camera(sequence.sensor.spec.camera).ok_or_else(|| {
            SenseError::option(format!("the camera of {prim} is not known; choose another model"))
        })?;
        let ImageCamera {
            camera: image,
            is_models,
        } = camera::of_images(
            size,
            options.field_of_view,
            file.params.as_deref(),
            own.intrinsics,
            &mut self.findings,
        )?;
        let resampled = options.resample && !is_models;
        let looked = if resampled {
            self.findings
                .retain(|finding| !matches!(finding.code, "own-size" | "image-lens"));
            self.findings.push(Finding::new(
                "resampled",
                Level::Note,
                prim,
                format!(
                    "images of {size}, focal length {:.2} px, become the model's of {}, {:.2} px: the nearest samples",
                    image.intrinsics.fx, own.intrinsics.size, own.intrinsics.fx
                ),
                "",
            ));
            Camera::new(own.intrinsics, LensModel::Pinhole)
        } else {
            image
        };
        let settings = SensorOptions {
            image: Some(looked.intrinsics),
            name: sequence.name.clone(),
            ..options.sensor.clone()
        };
        let (sensor, findings) = sensor(self.twin, sequence.sensor, &settings)?;
        self.findings.extend(findings);
        let engine = sensor.engine().kind().name;
        let used = (prim.clone(), engine);
        if !self.sensors.contains(&used) {
            self.sensors.push(used);
        }
        let shift_m = sensor.engine().lateral_shift_m(&looked.intrinsics);
        let looked_size = looked.intrinsics.size;
        let (width, height) = sensor.filters().size(looked_size.width, looked_size.height);
        let smaller = reported(&looked, ImageSize::new(width, height));
        let align = options
            .align
            .as_ref()
            .map(|to| rig::aligner(self.twin, sequence.sensor, smaller, shift_m, to, options.lens))
            .transpose()?;
        let eye = Eye {
            first: file.path.clone(),
            size,
            image,
            is_by_params: options.field_of_view == FieldOfView::Known && file.params.is_some(),
            z_of_range: (file.kind == InputKind::Range).then(|| z_of_range(&image)),
            places: resampled.then(|| places(&image, &looked)),
            look: Look {
                options,
                camera: looked,
                shift_m,
                align,
            },
        };
        Ok((eye, sensor))
    }

    /// Senses one file.
    fn file(
        &mut self,
        eye: &Eye<'a>,
        sensor: &mut Sensor,
        file: &DepthFile,
        mut source: Source,
        mut pictures: Option<Pictures>,
    ) -> Result<ControlFlow<()>, SenseError> {
        let is_sequence = source.batch.is_none() || self.options.is_sequence;
        let pixels = (source.size.width as usize * source.size.height as usize).max(1);
        let at_once = if is_sequence {
            1
        } else {
            (PIXELS_AT_ONCE / pixels).clamp(1, 4096)
        };
        let mut place = Place::new(&file.results, source.batch);
        let mut item = 0usize;
        loop {
            let (images, of) = (self.images, self.of);
            if (self.watch)(Done { images, of }).is_break() {
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
                given.push(Given { z, rgb, frame, item });
            }
            if given.is_empty() {
                self.writer.finish(place)?;
                self.whole = self.images;
                return Ok(ControlFlow::Continue(()));
            }
            let made: Vec<Result<Vec<Product>, SenseError>> = if is_sequence {
                given.into_iter().map(|one| eye.see(sensor, one, file)).collect()
            } else {
                let fresh = &*sensor;
                given
                    .into_par_iter()
                    .map(|one| eye.see(&mut fresh.clone(), one, file))
                    .collect()
            };
            for products in made {
                self.writer.put(&mut place, item, products?)?;
                item += 1;
                self.images += 1;
            }
        }
    }
}

impl Eye<'_> {
    /// Refuses an image of another size or camera in a sequence.
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
            return differs(format!("is {size}, and {first} before it is {}", self.size));
        }
        match &file.params {
            Some(params) if self.is_by_params && camera::read_params(params, size)? != self.image => {
                differs(format!(
                    "is by another camera ({}) than {first} before it",
                    params.display()
                ))
            }
            _ => Ok(()),
        }
    }

    fn see(&self, sensor: &mut Sensor, given: Given, file: &DepthFile) -> Result<Vec<Product>, SenseError> {
        let Given {
            mut z,
            mut rgb,
            frame,
            item,
        } = given;
        if let Some(factors) = &self.z_of_range {
            for (z, factor) in z.pixels_mut().iter_mut().zip(factors) {
                *z *= factor;
            }
        }
        let size = self.look.camera.intrinsics.size;
        if let Some(places) = &self.places {
            z = resample(&z, places, size, f32::INFINITY);
            rgb = rgb.map(|rgb| resample(&rgb, places, size, [0, 0, 0, 255]));
        }
        let request = self.look.request();
        let position = Annotator::DepthSensorPointCloudPosition;
        let needs_positions = request.contains(&position) && sensor.engine().outputs().contains(&position);
        let seen = needs_positions.then(|| positions(&self.look.camera, &z));
        let mut shot = Shot::new((&z).into());
        shot.frame = frame;
        shot.item = item;
        let of_one_size = |error: oaktwin_depth::ShotError| {
            FileError::new(&file.path, error.to_string(), "give both in one size")
        };
        if let Some(rgb) = &rgb {
            shot = shot.with_rgb(rgb.into()).map_err(of_one_size)?;
        }
        if let Some(seen) = &seen {
            shot = shot.with_positions(seen.into()).map_err(of_one_size)?;
        }
        let capture = sensor.capture(shot, &request)?;
        let products = self.look.products(&**sensor.engine(), &capture, rgb.as_ref());
        products.map_err(|error| FileError::codec(&file.path, &error).into())
    }
}

/// Refuses what an engine does not make, or makes of a picture that is not there.
fn check_outputs(
    options: &SenseOptions,
    engine: &dyn Engine,
    has_pictures: bool,
    file: &DepthFile,
) -> Result<(), SenseError> {
    for annotator in &options.annotators {
        let name = annotator.name();
        let is_isaacs = matches!(
            annotator,
            Annotator::DepthSensorImager | Annotator::DepthSensorOutputVisualization
        );
        if is_isaacs && !engine.outputs().contains(annotator) {
            return Err(SenseError::option(message![
                opt("annotators").with(name),
                format!(": not supported by {}; remove it, or set ", engine.kind()),
                opt("engine").with("single-view")
            ]));
        }
        if engine.needs_rgb(*annotator) && !has_pictures {
            let remedy = message!["give it as ", opt("rgb"), ", or remove the annotator"];
            let message = format!("no colour image, which {name} requires");
            return Err(FileError::new(&file.path, message, remedy).into());
        }
    }
    Ok(())
}
