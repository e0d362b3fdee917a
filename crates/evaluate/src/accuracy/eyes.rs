//! The two cameras of a stereo pair before the board.

use oaktwin_depth::ParameterError;
use oaktwin_depth::imager::{Imager, Parameters, Recorded};
use oaktwin_depth::random::{Stage, Stream};

use super::board::Board;
use oaktwin_camera::Intrinsics;
use oaktwin_image::{Image, ImageView};
use oaktwin_pipeline::pair::shifted;

/// A rectified pair as its sensors record it: both cameras have the same intrinsics, so there is nothing to rectify.
#[derive(Debug)]
pub(super) struct Eyes {
    baseline_m: f64,
    imager: Imager,
    random: [Stream; 2],
}

impl Eyes {
    /// With image sensors as by default, of which a pixel is `scale` px of the images, their noise of this seed.
    pub(super) fn new(baseline_m: f64, scale: f64, seed: u64) -> Result<Self, ParameterError> {
        Ok(Self {
            baseline_m,
            imager: Imager::new(Parameters::default())?.scaled(scale),
            random: ["left", "right"].map(|name| Stream::new(seed, name)),
        })
    }

    /// The light on the left camera, the same for every unit.
    pub(super) fn left(&self, board: &Board, intrinsics: Intrinsics) -> Image<f32> {
        board.light(intrinsics, 0.0)
    }

    /// The light on the right camera of a unit whose disparities are `bias_px` too large: its image lies so much farther
    /// left than its calibration says. It is rendered so, not shifted afterwards, since where a pixel's edges are has a say
    /// in what subpixel interpolation makes of it.
    pub(super) fn right(&self, board: &Board, intrinsics: Intrinsics, bias_px: f64) -> Image<f32> {
        board.light(shifted(intrinsics, -bias_px), self.baseline_m)
    }

    /// What both record of their light.
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
            let noise = random.plane(Stage::Exposure, frame, item);
            self.imager.record(light.into(), intrinsics, exposure, &noise)
        })
    }
}
