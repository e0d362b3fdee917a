//! From files of pairs to files of depth.

use std::collections::BTreeSet;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

use super::StereoError;
use super::files::PairFiles;
use super::grey::read_pair;
use super::matcher::{Matcher, PairOf, Seen};
use crate::geometry::{measured_only, positions};
use crate::progress::Watch;
use crate::sensor::{FixedDisparity, SensorOptions};
use crate::write::write_while;
use oaktwin_camera::{Camera, ImageSize};
use oaktwin_dataset::{self as dataset, CloudAxes, Extras, FlatWriter, Layer, LayerData, Shot};
use oaktwin_depth::rectify::Method;
use oaktwin_diagnostic::{Finding, Level};
use oaktwin_files::{FileError, OutputFiles, WrittenFile};
use oaktwin_image::annotation::{Annotator, Frame};
use oaktwin_image::{Image, ZDepth};

/// The outputs of stereo matching.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StereoOptions {
    /// The preset, filters and parameters.
    pub sensor: SensorOptions,
    /// The outputs to write; the distance is always written.
    pub outputs: Vec<StereoOutput>,
    /// The additional files of each depth image.
    pub extras: Extras,
    /// Whether the point cloud is also written, as PLY: x right, y down, z forward.
    pub ply: bool,
}

/// An output of stereo matching.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StereoOutput {
    /// `depth_sensor_distance`: NPY, `float32` metres, 0 where nothing was measured.
    Distance,
    /// `depth_sensor_point_cloud_position`: NPY, `float32`, metres in the camera's frame with USD's axes, and 1.
    Positions,
    /// `depth_sensor_point_cloud_color`: NPY, `uint8` RGBA.
    Colors,
    /// `disparity`: NPY, `float32` px, 0 where nothing was measured.
    Disparity,
    /// `confidence`: NPY, `uint8`, 255 is the highest.
    Confidence,
    /// `rectified_left` and `rectified_right`: PNG.
    Rectified,
}

impl StereoOutput {
    /// The names of all outputs.
    pub const NAMES: [(&'static str, Self); 6] = [
        ("depth_sensor_distance", Self::Distance),
        ("depth_sensor_point_cloud_position", Self::Positions),
        ("depth_sensor_point_cloud_color", Self::Colors),
        ("disparity", Self::Disparity),
        ("confidence", Self::Confidence),
        ("rectified", Self::Rectified),
    ];
}

/// The result of stereo matching.
#[derive(Clone, Debug, PartialEq)]
pub struct Matched {
    /// The complete files.
    pub files: Vec<WrittenFile>,
    /// The fill rate of each pair, 0 to 1.
    pub fill: Vec<f64>,
    /// The findings; of each code the first one.
    pub findings: Vec<Finding>,
    /// The rectified left camera.
    pub camera: Camera,
    /// The baseline in metres.
    pub baseline_m: f64,
    /// The rectification method (`homography`, `mesh` or `full`); `None` for rectified images.
    pub method: Option<&'static str>,
    /// Whether the task was interrupted.
    pub is_interrupted: bool,
}

/// Matches pairs of files and writes the results into a folder.
///
/// # Errors
/// Returns an error if a file cannot be read or written, the images are not a pair, or an option is invalid.
pub fn stereo(
    pairs: &[PairFiles],
    of: &PairOf<'_>,
    options: &StereoOptions,
    output: &Path,
    watch: &Watch<'_>,
) -> Result<Option<Matched>, StereoError> {
    let Some(first) = pairs.first() else {
        return Ok(None);
    };
    let mut output = output_files(pairs, output)?;
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
    let mut writer = FlatWriter::new(dataset::Options {
        extras: Extras {
            ply: false,
            ..options.extras
        },
        ..dataset::Options::default()
    });
    let (mut given, mut before) = (Some(images), first);
    let total = pairs.len() as u64;
    let written = write_while(&mut [&mut writer], &mut output, total, watch, |producer| {
        for pair in pairs {
            if producer.proceed().is_break() {
                return Ok(ControlFlow::Break(()));
            }
            let [left, right] = match given.take() {
                Some(images) => images,
                None => read_pair(&pair.left, &pair.right)?,
            };
            if !pair.goes_on(before) {
                matcher.reset();
            }
            before = pair;
            let seen = matcher.look(left, right).map_err(|error| in_files(error, pair))?;
            matched.add(&seen, pair);
            let shot = shot(seen, &matcher.camera(), options, pair);
            if producer.write(shot).is_break() || producer.finish().is_break() {
                return Ok(ControlFlow::Break(()));
            }
        }
        Ok::<_, StereoError>(ControlFlow::Continue(()))
    })?;
    matched.is_interrupted = written.is_interrupted;
    matched
        .fill
        .truncate(usize::try_from(written.frames).unwrap_or(usize::MAX));
    matched.files = output.files().to_vec();
    Ok(Some(matched))
}

/// The folder of the results, if no two pairs have results of one name.
fn output_files(pairs: &[PairFiles], folder: &Path) -> Result<OutputFiles, FileError> {
    let inputs = || pairs.iter().flat_map(|pair| [&pair.left, &pair.right]);
    if let Some(path) = inputs().find(|path| !path.exists()) {
        return Err(FileError::new(path, "there is no such file", "check the path"));
    }
    let mut names = BTreeSet::new();
    for pair in pairs {
        let path = pair.results().path("", "depth_sensor_distance", "npy");
        if !names.insert(path.clone()) {
            return Err(FileError::new(
                &folder.join(path),
                "is the result of several pairs",
                "rename the images so that their names differ",
            ));
        }
    }
    let mut output = OutputFiles::in_folder(folder)?;
    output.protect(inputs().map(PathBuf::as_path));
    Ok(output)
}

/// An error about the images of a pair, with their paths.
fn in_files(error: StereoError, pair: &PairFiles) -> StereoError {
    match error {
        StereoError::Pair(error) => {
            let message = format!("and {}: {}", pair.right.display(), error.what);
            FileError::new(&pair.left, message, error.remedy).into()
        }
        error => error,
    }
}

impl Matched {
    /// Adds the fill rate and the findings of a pair.
    fn add(&mut self, seen: &Seen, pair: &PairFiles) {
        let ZDepth(metres) = &seen.capture.distance;
        let measured = metres.pixels().iter().filter(|z| **z > 0.0).count();
        self.fill
            .push(measured as f64 / metres.pixels().len().max(1) as f64);
        let nothing = (measured == 0 && seen.findings.is_empty()).then(nothing_measured);
        for finding in seen.findings.iter().chain(&nothing) {
            if !self.findings.iter().any(|known| known.code == finding.code) {
                let place = format!("{}: {}", pair.left.display(), finding.place);
                self.findings.push(Finding {
                    place,
                    ..finding.clone()
                });
            }
        }
    }

    /// Whether there are warnings about the images.
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
        "no pixel was measured",
        "check that the images are a rectified pair, or relax confidenceThreshold, leftRightCheckThreshold and the filters",
    )
}

/// The frame of a matched pair.
fn shot(seen: Seen, camera: &Camera, options: &StereoOptions, pair: &PairFiles) -> Shot {
    let wants = |output: StereoOutput| options.outputs.contains(&output);
    let Seen {
        capture, rectified, ..
    } = seen;
    let ZDepth(metres) = &capture.distance;
    let size = ImageSize::new(metres.width(), metres.height());
    let needs_cloud = options.ply || wants(StereoOutput::Positions) || wants(StereoOutput::Colors);
    let cloud = needs_cloud.then(|| {
        let camera = Camera::new(camera.intrinsics.resized(size, false), camera.lens);
        let [left, _] = &rectified;
        let colors = (left.width() == size.width && left.height() == size.height)
            .then(|| left.to_eight().map(|&grey| [grey, grey, grey, 255]));
        (positions(&camera, metres), colors)
    });
    let mut layers = Vec::new();
    let mut add = |name: &'static str, data| {
        layers.push(Layer {
            folder: name,
            name: name.to_owned(),
            data,
        });
    };
    let disparity = capture.extra::<FixedDisparity>(Annotator::Disparity);
    if let Some(disparity) = disparity.filter(|_| wants(StereoOutput::Disparity)) {
        add("disparity", LayerData::Float(disparity.to_px()));
    }
    let confidence = capture.extra::<Image<u8>>(Annotator::Confidence);
    if let Some(confidence) = confidence.filter(|_| wants(StereoOutput::Confidence)) {
        add("confidence", LayerData::Byte(confidence.clone()));
    }
    if wants(StereoOutput::Rectified) {
        for (name, image) in ["rectified_left", "rectified_right"].into_iter().zip(rectified) {
            add(name, LayerData::Png(Box::new(move || image.to_png())));
        }
    }
    let mut frame = Frame::default();
    if let Some((positions, colors)) = cloud {
        if options.ply {
            let data = LayerData::Cloud {
                positions: positions.clone(),
                colors: colors.clone(),
                axes: CloudAxes::Optical,
            };
            add("depth_sensor_point_cloud", data);
        }
        frame.depth_sensor_point_cloud_color = colors
            .filter(|_| wants(StereoOutput::Colors))
            .map(|colors| measured_only(colors, metres));
        frame.depth_sensor_point_cloud_position = Some(positions).filter(|_| wants(StereoOutput::Positions));
    }
    frame.depth_sensor_distance = Some(capture.distance);
    Shot {
        layers,
        input: pair.results(),
        ..Shot::new(frame, 0)
    }
}
