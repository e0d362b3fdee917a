//! The two cameras of a stereo pair in front of the board.

use oaktwin_depth::ParameterError;
use oaktwin_depth::imager::{Imager, Parameters, Recorded};
use oaktwin_depth::random::{NoiseStage, Stream};

use super::board::Board;
use oaktwin_camera::math::{DMat3, DVec3};
use oaktwin_camera::{BaselineAxis, Intrinsics, RigidTransform, StereoDrift};
use oaktwin_image::{Image, ImageView};
use oaktwin_pipeline::pair::shifted;

/// A rectified pair as its image sensors record it. Both cameras have the same intrinsics, so no rectification is required. A drifted
/// pair is not rectified again.
#[derive(Debug)]
pub(super) struct StereoCamera {
    baseline_m: f64,
    drift: StereoDrift,
    imager: Imager,
    random: [Stream; 2],
}

impl StereoCamera {
    /// Creates a pair with default image sensors, one pixel of which is `scale` pixels of the images.
    pub(super) fn new(
        (baseline_m, drift): (f64, StereoDrift),
        scale: f64,
        seed: u64,
    ) -> Result<Self, ParameterError> {
        Ok(Self {
            baseline_m,
            drift,
            imager: Imager::new(Parameters::default())?.scaled(scale),
            random: ["left", "right"].map(|name| Stream::new(seed, name)),
        })
    }

    /// Returns the light on the left camera, the same for every unit.
    pub(super) fn left(&self, board: &Board, intrinsics: Intrinsics) -> Image<f32> {
        board.light(self.drift.intrinsics(&intrinsics), &RigidTransform::IDENTITY)
    }

    /// Returns the light on the right camera of a unit whose disparities are `bias_px` too large: its image is that much farther
    /// left than its calibration states. The image is rendered there rather than shifted afterwards, because the positions of
    /// pixel edges affect subpixel interpolation.
    pub(super) fn right(&self, board: &Board, intrinsics: Intrinsics, bias_px: f64) -> Image<f32> {
        let calibrated = RigidTransform::new(DMat3::IDENTITY, DVec3::new(self.baseline_m, 0.0, 0.0));
        let actual = self
            .drift
            .right_camera(&calibrated, DMat3::IDENTITY, BaselineAxis::Horizontal);
        board.light(self.drift.intrinsics(&shifted(intrinsics, -bias_px)), &actual)
    }

    /// Records the light on both cameras.
    pub(super) fn record(
        &self,
        lights: [&Image<f32>; 2],
        intrinsics: &Intrinsics,
        (frame, item): (u64, u32),
    ) -> [Recorded; 2] {
        let exposure = self
            .imager
            .expose(&lights.map(|light| (ImageView::from(light), intrinsics)));
        let [left, right] = lights;
        [(left, &self.random[0]), (right, &self.random[1])].map(|(light, random)| {
            let noise = random.plane(NoiseStage::Exposure, frame, item);
            self.imager.record(light.into(), intrinsics, exposure, &noise)
        })
    }
}
