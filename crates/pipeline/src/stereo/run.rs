//! From files of pairs to files of depth.

use std::collections::BTreeSet;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

use super::StereoError;
use super::files::PairFiles;
use super::grey::read_pair;
use super::matcher::{MatchedPair, Matcher, PairOf};
use crate::align::{self, AlignTo, Measuring};
use crate::limits;
use crate::progress::Watch;
use crate::sensor::{FixedDisparity, SensorOptions, frame, sensor_view};
use crate::write::write_while;
use oaktwin_base::diagnostic::{Finding, Level, message, opt};
use oaktwin_camera::{Camera, ImageSize, RigidTransform, UsdOptics};
use oaktwin_dataset::{
    self as dataset, CameraParams, CloudAxes, Extras, FlatWriter, FrameCamera, LayerData, Shot, ShotLayer,
};
use oaktwin_depth::align::Align;
use oaktwin_depth::rectify::Method;
use oaktwin_files::{FileError, OutputFiles, WrittenFile};
use oaktwin_image::annotation::Annotator;
use oaktwin_image::{Image, ZDepth};

/// The pixel size of the OV9282, µm.
const PIXEL_SIZE_UM: f64 = 3.0;

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
    /// The camera of the twin that depth is also aligned to.
    pub align: Option<AlignTo>,
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
pub struct MatchingResult {
    /// The complete files.
    pub files: Vec<WrittenFile>,
    /// The fill rate of each pair, 0 to 1.
    pub fill: Vec<f64>,
    /// The findings; of each code the first one.
    pub findings: Vec<Finding>,
    /// The camera of the depth images; see [`Matcher::camera`].
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
) -> Result<Option<MatchingResult>, StereoError> {
    let Some(first) = pairs.first() else {
        return Ok(None);
    };
    let mut output = output_files(pairs, output)?;
    let images = read_pair(&first.left, &first.right)?;
    let size = ImageSize::new(images[0].width(), images[0].height());
    limits::check_memory(&first.left, size, limits::match_bytes(size))?;
    let mut matcher = Matcher::new(of, size, &options.sensor)?;
    let align = aligner(of, &matcher, options.align.as_ref())?;
    let mut matched = MatchingResult {
        files: Vec::new(),
        fill: Vec::new(),
        findings: matcher.findings().to_vec(),
        camera: matcher.camera().camera,
        baseline_m: matcher.baseline_m(),
        method: matcher.method().map(Method::name),
        is_interrupted: false,
    };
    let mut writer = FlatWriter::new(dataset::WriterOptions {
        extras: Extras {
            ply: false,
            ..options.extras
        },
        ..dataset::WriterOptions::default()
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
            let seen = matcher
                .match_pair(left, right)
                .map_err(|error| in_files(error, pair))?;
            matched.add(&seen, pair);
            let shot = shot(seen, &matcher, align.as_ref(), options, pair);
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

/// The alignment of the depth to a camera of the twin that the pair is from.
fn aligner(of: &PairOf<'_>, matcher: &Matcher, to: Option<&AlignTo>) -> Result<Option<Align>, StereoError> {
    let Some(to) = to else {
        return Ok(None);
    };
    let PairOf::Twin { twin, lens, .. } = *of else {
        let unknown = message![opt("align"), ": the other cameras are unknown; set --model"];
        return Err(StereoError::Option(unknown));
    };
    let from = Measuring {
        body_from_camera: matcher.body_from_camera(),
        reported: &matcher.camera(),
        is_stereo: true,
    };
    align::aligner(twin, &from, to, lens)
        .map(Some)
        .map_err(StereoError::Option)
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

impl MatchingResult {
    /// Adds the fill rate and the findings of a pair.
    fn add(&mut self, seen: &MatchedPair, pair: &PairFiles) {
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
fn shot(
    seen: MatchedPair,
    matcher: &Matcher,
    align: Option<&Align>,
    options: &StereoOptions,
    pair: &PairFiles,
) -> Shot {
    let wants = |output: StereoOutput| options.outputs.contains(&output);
    let MatchedPair {
        capture, rectified, ..
    } = seen;
    let request = [
        (true, Annotator::DepthSensorDistance),
        (
            options.ply || wants(StereoOutput::Positions),
            Annotator::DepthSensorPointCloudPosition,
        ),
        (
            options.ply || wants(StereoOutput::Colors),
            Annotator::DepthSensorPointCloudColor,
        ),
    ];
    let request: Vec<Annotator> = request
        .into_iter()
        .filter(|(wanted, _)| *wanted)
        .map(|(_, one)| one)
        .collect();
    let mut layers: Vec<ShotLayer> = align
        .zip(options.align.as_ref())
        .and_then(|(align, to)| align::layer(align, to, &capture.distance.0))
        .into_iter()
        .collect();
    let mut add = |name: &'static str, data| {
        layers.push(ShotLayer {
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
    let needs_colors = request.contains(&Annotator::DepthSensorPointCloudColor);
    let grey = needs_colors.then(|| rectified[0].to_eight().map(|&grey| [grey, grey, grey, 255]));
    let grey = grey.as_ref().map(Into::into);
    let camera = matcher.rectified_camera();
    let mut frame = frame(matcher.sensor(), &camera, capture, grey, &request);
    if let Some(positions) = frame
        .depth_sensor_point_cloud_position
        .as_ref()
        .filter(|_| options.ply)
    {
        let data = LayerData::Cloud {
            positions: positions.clone(),
            colors: frame.depth_sensor_point_cloud_color.clone(),
            axes: CloudAxes::Optical,
        };
        add("depth_sensor_point_cloud", data);
    }
    if wants(StereoOutput::Rectified) {
        for (name, image) in ["rectified_left", "rectified_right"].into_iter().zip(rectified) {
            add(name, LayerData::Png(Box::new(move || image.to_png())));
        }
    }
    if !wants(StereoOutput::Positions) {
        frame.depth_sensor_point_cloud_position = None;
    }
    if !wants(StereoOutput::Colors) {
        frame.depth_sensor_point_cloud_color = None;
    }
    Shot {
        layers,
        sensor_params: Some(CameraParams::new(&sensor_view(&matcher.camera(), &view(&camera)))),
        input: pair.results(),
        ..Shot::new(frame, 0)
    }
}

/// The view of the rectified left camera, which is at the origin. The size of its pixels is unknown; it does not affect the
/// projection.
fn view(camera: &Camera) -> FrameCamera {
    FrameCamera {
        optics: UsdOptics::from_intrinsics(&camera.intrinsics, PIXEL_SIZE_UM, Default::default()),
        camera: *camera,
        world_from_camera: RigidTransform::IDENTITY,
        clipping_range: [0.01, 1e7],
        meters_per_unit: 1.0,
        focus_distance: 0.0,
        f_stop: 0.0,
    }
}
