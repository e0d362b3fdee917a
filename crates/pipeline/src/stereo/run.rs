//! Pairs of files to files.

use std::collections::BTreeSet;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

use super::StereoError;
use super::files::PairFiles;
use super::grey::read_pair;
use super::matcher::{Matcher, PairOf, Seen};
use crate::render::OutputFolder;
use crate::sense::positions;
use crate::sensor::{FixedDisparity, SensorOptions};
use oaktwin_camera::{Camera, ImageSize};
use oaktwin_depth::rectify::Method;
use oaktwin_diagnostic::{Finding, Level};
use oaktwin_files::{FileError, WrittenFile};
use oaktwin_image::annotation::Annotator;
use oaktwin_image::{CodecError, Image, ZDepth, millimetres, npy, ply, png, preview};

/// What to make of pairs.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StereoOptions {
    /// Preset, filters, parameters.
    pub sensor: SensorOptions,
    /// Disparity too: `disparity` NPY, float32 px, 0 where nothing was measured.
    pub disparity: bool,
    /// How sure the matcher is: `confidence` NPY, uint8, higher is surer.
    pub confidence: bool,
    /// What was matched: `rectified_left` and `rectified_right` PNG.
    pub rectified: bool,
    /// Depth as 16-bit PNG in millimetres too.
    pub png16: bool,
    /// Depth as a picture for people too.
    pub preview: bool,
    /// The points as PLY too: x right, y down, z forward.
    pub ply: bool,
}

/// What was matched and written.
#[derive(Clone, Debug, PartialEq)]
pub struct Matched {
    /// Whole ones.
    pub files: Vec<WrittenFile>,
    /// Of each pair the share (0 to 1) of pixels that were measured.
    pub fill: Vec<f64>,
    /// What is wrong with the images, and what was chosen; each kind once, of the first pair that has it.
    pub findings: Vec<Finding>,
    /// The rectified left camera.
    pub camera: Camera,
    /// m
    pub baseline_m: f64,
    /// How the images were rectified: `homography`, `mesh` or `full`; `None` where they were.
    pub method: Option<&'static str>,
    /// Whether the caller asked to stop before the end.
    pub is_interrupted: bool,
}

/// Matches pairs of files, one after the other, and writes what is measured into a folder. `watch` is asked before each,
/// with how many are done.
///
/// # Errors
/// A file that cannot be read or written, images that are no pair, options that make no matcher.
pub fn stereo(
    pairs: &[PairFiles],
    of: &PairOf<'_>,
    options: &StereoOptions,
    output: &Path,
    watch: &mut dyn FnMut(u64) -> ControlFlow<()>,
) -> Result<Option<Matched>, StereoError> {
    let Some(first) = pairs.first() else {
        return Ok(None);
    };
    let mut writer = Writer::new(pairs, output)?;
    let images = read_pair(&first.left, &first.right)?;
    let size = ImageSize::new(images[0].width(), images[0].height());
    let mut matcher = Matcher::new(of, size, &options.sensor)?;
    let mut matched = Matched {
        files: Vec::new(),
        fill: Vec::new(),
        findings: matcher.findings().to_vec(),
        camera: matcher.camera(),
        baseline_m: matcher.baseline_m(),
        method: matcher.method().map(Method::name),
        is_interrupted: false,
    };
    let mut given = Some(images);
    let mut before = first;
    for (pair, done) in pairs.iter().zip(0..) {
        if watch(done).is_break() {
            matched.is_interrupted = true;
            break;
        }
        let [left, right] = match given.take() {
            Some(images) => images,
            None => read_pair(&pair.left, &pair.right)?,
        };
        if !pair.goes_on(before) {
            matcher.reset();
        }
        before = pair;
        let of_files = |error: StereoError| match error {
            StereoError::Pair(error) => {
                let message = format!("and {}: {}", pair.right.display(), error.what);
                FileError::new(&pair.left, message, error.remedy).into()
            }
            error => error,
        };
        let seen = matcher.look(left, right).map_err(of_files)?;
        let ZDepth(metres) = &seen.capture.distance;
        let measured = metres.pixels().iter().filter(|z| **z > 0.0).count();
        let is_strange = measured == 0 && seen.findings.is_empty();
        for finding in seen
            .findings
            .iter()
            .chain(is_strange.then_some(&nothing_measured()))
        {
            if !matched.findings.iter().any(|known| known.code == finding.code) {
                let place = format!("{}: {}", pair.left.display(), finding.place);
                matched.findings.push(Finding {
                    place,
                    ..finding.clone()
                });
            }
        }
        matched
            .fill
            .push(measured as f64 / metres.pixels().len().max(1) as f64);
        let products = products(&seen, &matcher.camera(), options);
        for (what, extension, bytes) in products.map_err(|error| FileError::codec(&pair.left, &error))? {
            matched
                .files
                .push(writer.put(&pair.result(what, extension), &bytes)?);
        }
    }
    Ok(Some(matched))
}

impl Matched {
    /// Whether something is wrong with the images.
    #[must_use]
    pub fn has_warnings(&self) -> bool {
        self.findings
            .iter()
            .any(|finding| finding.level >= Level::Warning)
    }
}

fn nothing_measured() -> Finding {
    Finding::new(
        "nothing-measured",
        Level::Warning,
        "stereo pair",
        "not one pixel was measured",
        "check that the two are a rectified pair, or loosen confidenceThreshold, leftRightCheckThreshold and the filters",
    )
}

type Product = (&'static str, &'static str, Vec<u8>);

fn products(seen: &Seen, camera: &Camera, options: &StereoOptions) -> Result<Vec<Product>, CodecError> {
    let ZDepth(metres) = &seen.capture.distance;
    let mut products = vec![("depth_sensor_distance", "npy", array(metres)?)];
    if options.png16 {
        let bytes = png::encode(&millimetres::from_metres(metres))?;
        products.push(("depth_sensor_distance_millimetres", "png", bytes));
    }
    if options.preview {
        let bytes = png::encode(&preview::depth(metres, &preview::Options::default()))?;
        products.push(("depth_sensor_distance_preview", "png", bytes));
    }
    let disparity = seen.capture.extra::<FixedDisparity>(Annotator::Disparity);
    if let Some(disparity) = disparity.filter(|_| options.disparity) {
        products.push(("disparity", "npy", array(&disparity.to_px())?));
    }
    let confidence = seen.capture.extra::<Image<u8>>(Annotator::Confidence);
    if let Some(confidence) = confidence.filter(|_| options.confidence) {
        products.push(("confidence", "npy", array(confidence)?));
    }
    if options.rectified {
        for (name, image) in ["rectified_left", "rectified_right"]
            .into_iter()
            .zip(&seen.rectified)
        {
            products.push((name, "png", image.to_png()?));
        }
    }
    if options.ply {
        products.push(("depth_sensor_point_cloud", "ply", points(seen, camera)?));
    }
    Ok(products)
}

fn array<T: npy::Element>(image: &Image<T>) -> Result<Vec<u8>, CodecError> {
    npy::encode(&[image.height() as usize, image.width() as usize], image.pixels())
}

fn points(seen: &Seen, camera: &Camera) -> Result<Vec<u8>, CodecError> {
    let ZDepth(metres) = &seen.capture.distance;
    let size = ImageSize::new(metres.width(), metres.height());
    let camera = Camera::new(camera.intrinsics.resized(size, false), camera.lens);
    let [left, _] = &seen.rectified;
    let colors = (left.width() == size.width && left.height() == size.height)
        .then(|| left.to_eight().map(|&grey| [grey, grey, grey, 255]));
    ply::encode_measured(&positions(&camera, metres), colors.as_ref(), |[x, y, z]| {
        [x, -y, -z]
    })
}

/// Never over an input, and no result over another.
struct Writer {
    folder: OutputFolder,
    /// Real paths.
    inputs: BTreeSet<PathBuf>,
    written: BTreeSet<String>,
}

impl Writer {
    fn new(pairs: &[PairFiles], output: &Path) -> Result<Self, FileError> {
        let inputs = pairs.iter().flat_map(|pair| [&pair.left, &pair.right]);
        let mut real = BTreeSet::new();
        for path in inputs {
            if !path.exists() {
                return Err(FileError::new(path, "there is no such file", "check the path"));
            }
            real.extend(path.canonicalize());
        }
        Ok(Self {
            folder: OutputFolder::prepare(output)?,
            inputs: real,
            written: BTreeSet::new(),
        })
    }

    fn put(&mut self, name: &str, bytes: &[u8]) -> Result<WrittenFile, FileError> {
        let path = self.folder.path().join(name);
        if path.canonicalize().is_ok_and(|path| self.inputs.contains(&path)) {
            return Err(FileError::new(
                &path,
                "is an input of this command",
                "choose another place",
            ));
        }
        if !self.written.insert(name.to_owned()) {
            return Err(FileError::new(
                &path,
                "is the result of another pair too",
                "give the images names that differ",
            ));
        }
        let path = self.folder.write(Path::new(name), bytes)?;
        let bytes = bytes.len() as u64;
        Ok(WrittenFile { path, bytes })
    }
}
