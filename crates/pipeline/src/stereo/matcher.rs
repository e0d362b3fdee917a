//! From two images to depth.

use std::sync::Arc;

use rayon::prelude::*;

use super::StereoError;
use crate::pair::{PairCameras, PairOptions};
use crate::sense::FieldOfView;
use crate::sensor::{
    Capture, Input, OutputCamera, ParameterError, Sensor, SensorOptions, foreign_processing,
    stereo_matching as sensor,
};
use oaktwin_base::diagnostic::{Finding, Level, message, opt};
use oaktwin_camera::{Camera, ImageSize, Intrinsics, LensModel, RigidTransform, StereoGeometry};
use oaktwin_catalog::{Role, Twin};
use oaktwin_depth::filter::Chain;
use oaktwin_depth::imager::Recorded;
use oaktwin_depth::preset::Platform;
use oaktwin_depth::rectify::{Method, RectifyOptions, RemainingDistortion, StereoRectify};
use oaktwin_depth::stereo_matching::{self, RectifiedPair, VERTICAL_OFFSET};
use oaktwin_image::annotation::Annotator;
use oaktwin_usd::asset::LensChoice;

/// The share of distorted pixels above which they are reported.
const MAX_DISTORTED: f64 = 0.05;

/// The cameras of a pair.
#[derive(Clone, Copy, Debug)]
#[expect(clippy::large_enum_variant, reason = "a run has only one")]
pub enum PairOf<'a> {
    /// The cameras of a twin.
    Twin {
        /// The device.
        twin: &'a Twin,
        /// The left and the right camera.
        cameras: (Role, Role),
        /// The lens of the wide models' nominal cameras.
        lens: LensChoice,
        /// Whether the images are raw, not rectified.
        is_raw: bool,
        /// The rectification of raw images; by default as on the device's processor.
        rectify: Option<RectifyOptions>,
        /// The processor whose defaults and presets apply; by default the device's.
        platform: Option<Platform>,
    },
    /// Any cameras with rectified images.
    Rectified {
        /// The field of view of the images.
        field_of_view: FieldOfView,
        /// The baseline in metres.
        baseline_m: f64,
        /// The processor whose defaults and presets apply.
        platform: Platform,
    },
}

/// Matches pairs of images. Its temporal filters depend on earlier frames.
#[derive(Debug)]
pub struct Matcher {
    size: ImageSize,
    rectify: Option<StereoRectify>,
    intrinsics: Intrinsics,
    body_from_camera: RigidTransform,
    baseline_m: f64,
    sensor: Sensor,
    /// The filters of each rig of batches, with their memory.
    rigs: Vec<Chain>,
    findings: Vec<Finding>,
}

/// The result of matching a pair.
#[derive(Debug)]
pub struct MatchedPair {
    /// The depth, disparity and confidence.
    pub capture: Capture,
    /// The rectified images, left and right.
    pub rectified: [Recorded; 2],
    /// Findings about the pair.
    pub findings: Vec<Finding>,
}

impl Matcher {
    /// Creates a matcher for images of a size.
    ///
    /// # Errors
    /// Returns an error if the cameras are not a stereo pair or an option is invalid.
    pub fn new(of: &PairOf<'_>, size: ImageSize, options: &SensorOptions) -> Result<Self, StereoError> {
        let (rectify, intrinsics, body_from_camera, stereo, platform, place) = match *of {
            PairOf::Twin {
                twin,
                cameras,
                lens,
                is_raw,
                rectify,
                platform: chosen,
            } => {
                let pair = PairOptions {
                    cameras,
                    rectify,
                    lens,
                    size: Some(size),
                    ..PairOptions::default()
                };
                let cameras = PairCameras::new(twin, &pair)?;
                let rectify = cameras.rectify().clone();
                let geometry = *rectify.geometry();
                (
                    is_raw.then_some(rectify),
                    geometry.left,
                    cameras.body_from_rectified_left(),
                    StereoGeometry {
                        baseline_m: twin.depth_baseline_m(pair.cameras).unwrap_or(geometry.baseline),
                        ..geometry.stereo_geometry()
                    },
                    chosen.or_else(|| twin.platform()),
                    twin.device.name.as_str(),
                )
            }
            PairOf::Rectified {
                field_of_view,
                baseline_m,
                platform,
            } => {
                let intrinsics = ideal(size, field_of_view)?;
                let stereo = StereoGeometry {
                    focal_length_px: intrinsics.fx,
                    baseline_m,
                };
                let place = RigidTransform::IDENTITY;
                (None, intrinsics, place, stereo, Some(platform), "stereo pair")
            }
        };
        let platform = platform.unwrap_or(Platform::Rvc2);
        let (sensor, mut findings) = sensor(platform, stereo, size.width, place, options)?;
        if let PairOf::Twin { twin, .. } = *of {
            findings.extend(foreign_processing(twin, sensor.engine().kind(), place));
        }
        findings.extend(
            rectify
                .as_ref()
                .and_then(|rectify| still_distorted(rectify, place)),
        );
        Ok(Self {
            size,
            rectify,
            intrinsics,
            body_from_camera,
            baseline_m: stereo.baseline_m,
            sensor,
            rigs: Vec::new(),
            findings,
        })
    }

    /// The findings about the cameras and options.
    #[must_use]
    pub fn findings(&self) -> &[Finding] {
        &self.findings
    }

    /// The size of its images.
    #[must_use]
    pub fn size(&self) -> ImageSize {
        self.size
    }

    /// The rectified left camera.
    #[must_use]
    pub fn rectified_camera(&self) -> Camera {
        Camera::new(self.intrinsics, LensModel::Pinhole)
    }

    /// The camera that depth, disparity and confidence are images of: the rectified left camera, whose image
    /// [decimation](oaktwin_depth::filter::Decimation) makes smaller.
    #[must_use]
    pub fn camera(&self) -> OutputCamera {
        self.sensor.output_camera(&self.rectified_camera())
    }

    /// The pose of the rectified left camera in the device's body, metres; the identity for other pairs.
    #[must_use]
    pub fn body_from_camera(&self) -> RigidTransform {
        self.body_from_camera
    }

    /// The baseline in metres.
    #[must_use]
    pub fn baseline_m(&self) -> f64 {
        self.baseline_m
    }

    /// The rectification method; `None` for rectified images.
    #[must_use]
    pub fn method(&self) -> Option<Method> {
        self.rectify.as_ref().map(StereoRectify::method)
    }

    /// The engine and its filters.
    #[must_use]
    pub fn sensor(&self) -> &Sensor {
        &self.sensor
    }

    /// Forgets all earlier frames.
    pub fn reset(&mut self) {
        self.sensor.reset();
        self.rigs.clear();
    }

    /// Forgets the earlier frames of some rigs.
    pub fn reset_rigs(&mut self, numbers: &[usize]) {
        for number in numbers {
            if let Some(filters) = self.rigs.get_mut(*number) {
                filters.reset();
            }
        }
    }

    /// Matches a pair.
    ///
    /// # Errors
    /// Returns an error if the images differ in size or bit depth, or have another size than the matcher.
    pub fn match_pair(&mut self, left: Recorded, right: Recorded) -> Result<MatchedPair, StereoError> {
        let rectified = self.rectified(left, right)?;
        let is_raw = self.rectify.is_some();
        match_rectified(&mut self.sensor, rectified, is_raw)
    }

    /// Matches simultaneous pairs of many rigs, each as the next frame of its rig, whose numbers count from `first`. Each thread
    /// matches one pair; the threads share the last ones. Findings name the pair's number.
    ///
    /// # Errors
    /// Returns the error of the first pair that has one, as [`Matcher::match_pair`] does.
    pub fn match_pairs(
        &mut self,
        pairs: Vec<[Recorded; 2]>,
        first: usize,
    ) -> Result<Vec<MatchedPair>, StereoError> {
        let end = first + pairs.len();
        if self.rigs.len() < end {
            let mut fresh = self.sensor.filters().clone();
            fresh.reset();
            self.rigs.resize(end, fresh);
        }
        let mut rigs = std::mem::take(&mut self.rigs);
        let seen = self.match_each(pairs, rigs.get_mut(first..end).unwrap_or_default(), first);
        self.rigs = rigs;
        seen
    }

    /// Matches a pair of each rig.
    fn match_each(
        &self,
        pairs: Vec<[Recorded; 2]>,
        rigs: &mut [Chain],
        first: usize,
    ) -> Result<Vec<MatchedPair>, StereoError> {
        let threads = rayon::current_num_threads().max(1);
        let mut all = Vec::with_capacity(pairs.len());
        let mut pairs = pairs.into_iter().zip(rigs);
        loop {
            let some: Vec<([Recorded; 2], &mut Chain)> = pairs.by_ref().take(threads).collect();
            if some.is_empty() {
                return Ok(all);
            }
            let match_next = |([left, right], filters): ([Recorded; 2], &mut Chain)| {
                let rectified = self.rectified(left, right)?;
                let mut sensor = self.sensor.with_filters(std::mem::take(filters));
                let seen = match_rectified(&mut sensor, rectified, self.rectify.is_some());
                *filters = sensor.into_filters();
                seen
            };
            let some: Vec<Result<MatchedPair, StereoError>> = some.into_par_iter().map(match_next).collect();
            for seen in some {
                let (mut seen, number) = (seen?, first + all.len());
                for finding in &mut seen.findings {
                    finding.place = format!("pair {number}: {}", finding.place);
                }
                all.push(seen);
            }
        }
    }

    fn rectified(&self, left: Recorded, right: Recorded) -> Result<[Recorded; 2], StereoError> {
        // Checked first, so that errors refer to the images before rectification.
        RectifiedPair::new(&left, &right)?;
        let rectified = match (&self.rectify, &left, &right) {
            (None, ..) => None,
            (Some(rectify), Recorded::Eight(left), Recorded::Eight(right)) => rectify
                .rectify(left.into(), right.into())
                .map(|pair| pair.map(Recorded::Eight)),
            (Some(rectify), Recorded::Ten(left), Recorded::Ten(right)) => rectify
                .rectify(left.into(), right.into())
                .map(|pair| pair.map(Recorded::Ten)),
            _ => None,
        };
        let size = ImageSize::new(left.width(), left.height());
        if size != self.size {
            return Err(stereo_matching::RectifiedPairError {
                what: format!("its images are {size}, but the first ones are {}", self.size),
                remedy: "give images of the same size",
            }
            .into());
        }
        Ok(rectified.unwrap_or([left, right]))
    }
}

/// Reports the lens distortion that a homography leaves in the images.
fn still_distorted(rectify: &StereoRectify, place: &str) -> Option<Finding> {
    let RemainingDistortion { share, max_px } = rectify.remaining();
    (share > MAX_DISTORTED).then(|| {
        Finding::new(
            "rectified-distortion",
            Level::Note,
            place,
            format!(
                "the homography with which RVC2 rectifies leaves lens distortion: {:.0} % of the pixels are off by more than 1 px, at most \
                 {max_px:.1} px, so that depth is wrong there, as on the device",
                100.0 * share
            ),
            message!["rectify with ", opt("rectify").with("mesh"), ", and set a mesh on the device"],
        )
    })
}

/// Matches a rectified pair. If the matcher has rectified it, findings do not advise to do so.
fn match_rectified(
    sensor: &mut Sensor,
    rectified: [Recorded; 2],
    is_raw: bool,
) -> Result<MatchedPair, StereoError> {
    let [left, right] = &rectified;
    let pair = RectifiedPair::new(left, right)?;
    let input = Input::Pair(pair);
    let engine = Arc::clone(sensor.engine());
    let (capture, mut findings) = rayon::join(
        || sensor.capture(input, &[Annotator::Disparity, Annotator::Confidence]),
        || engine.inspect(&input),
    );
    for finding in findings
        .iter_mut()
        .filter(|found| is_raw && found.code == VERTICAL_OFFSET)
    {
        finding.remedy = "check that the calibration is this unit's, and that the images are raw".into();
    }
    Ok(MatchedPair {
        capture: capture?,
        rectified,
        findings,
    })
}

fn ideal(size: ImageSize, field_of_view: FieldOfView) -> Result<Intrinsics, ParameterError> {
    let wrong = |name: &str, value: f64, remedy: &str| ParameterError {
        name: name.to_owned(),
        what: format!("{value} is out of range"),
        remedy: remedy.to_owned(),
    };
    match field_of_view {
        FieldOfView::FocalLength(fx) if fx.is_finite() && fx > 0.0 => {
            let mut own = Intrinsics::from_hfov(size, 1.0);
            (own.fx, own.fy) = (fx, fx);
            Ok(own)
        }
        FieldOfView::FocalLength(fx) => Err(wrong("fx", fx, "give pixels above 0")),
        FieldOfView::Degrees(hfov) if hfov > 0.0 && hfov < 180.0 => {
            Ok(Intrinsics::from_hfov(size, hfov.to_radians()))
        }
        FieldOfView::Degrees(hfov) => Err(wrong("hfov", hfov, "give degrees above 0 and below 180")),
        FieldOfView::Camera(camera) if camera.intrinsics.size == size => Ok(camera.intrinsics),
        FieldOfView::Camera(camera) => Err(ParameterError {
            name: "camera".to_owned(),
            what: format!("its images are {} instead of {size}", camera.intrinsics.size),
            remedy: "give a camera of the images' size".to_owned(),
        }),
        FieldOfView::Known => Err(ParameterError {
            name: "fx".to_owned(),
            what: "the field of view is unknown".to_owned(),
            remedy: "give the focal length or the field of view".to_owned(),
        }),
    }
}
