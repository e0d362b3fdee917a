use oaktwin_camera::StereoGeometry;

use super::rvc4::{AdaptiveMedian, ConfidenceMetrics, HoleFilling};
use crate::ParameterError;
use crate::disparity::{DepthRounding, Fixed, Subpixel};
use crate::preset::Platform;
use oaktwin_parameter::choice;

choice! {
    /// The window of the census transform, rows × columns.
    CensusKernel {
        /// 5×5. What the device takes is not published.
        Auto = "AUTO",
        /// 25 pixels.
        Kernel5x5 = "KERNEL_5x5",
        /// 49 pixels.
        Kernel7x7 = "KERNEL_7x7",
        /// 63 pixels, 7 rows of 9.
        Kernel7x9 = "KERNEL_7x9",
    }
}

choice! {
    /// How many disparities are searched.
    DisparityWidth {
        /// 0 to 95.
        Disparity96 = "DISPARITY_96",
        /// 0 to 63.
        Disparity64 = "DISPARITY_64",
    }
}

choice! {
    /// Where between whole disparities the least cost is taken to be, from the sums around. What the device does is not
    /// published, but that it looks at two neighbours on each side.
    Interpolation {
        /// Where two lines of one slope meet, through three sums.
        Lines = "LINES",
        /// The vertex of the parabola that fits the five sums around best; of three beside the ends of the range.
        Parabola5 = "PARABOLA_5",
        /// The vertex of the parabola through three sums.
        Parabola = "PARABOLA",
    }
}

/// A path's penalty for a change of disparity, of RVC4.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct AdaptivePenalty {
    /// `enableAdaptive`: whether it depends on the picture.
    pub adaptive: bool,
    /// `defaultValue`
    pub default: u32,
    /// `edgeValue`: where neighbours differ by more than `edgeThreshold`.
    pub edge: u32,
    /// `smoothValue`: where they differ by less than `smoothThreshold`.
    pub smooth: u32,
}

/// How a pair is matched, under `DepthAI`'s names. Lengths in pixels are in matcher pixels.
///
/// [`Parameters::set`] and [`Parameters::get`] reach each by its name in [`NAMES`](super::NAMES).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters {
    /// `focalLength`, matcher px, and `baseline`, m.
    pub stereo: StereoGeometry,
    /// `width`: of the images that the focal length is for, px. Of a pair of another width, it is scaled.
    pub width_px: u32,
    /// `subpixelFractionalBits`, `subpixel`: the step of disparity.
    pub subpixel: Subpixel,
    /// `subpixelInterpolation`: what fractions are made of. Not `DepthAI`'s: [`Interpolation`].
    pub interpolation: Interpolation,
    /// `extendedDisparity`: whether images of half the size are matched too, for what is near.
    pub extended_disparity: bool,
    /// `disparityShift`: where the search begins, px.
    pub disparity_shift_px: u32,
    /// `leftRightCheck`: whether the two directions of matching must agree.
    pub left_right_check: bool,
    /// `leftRightCheckThreshold`: by how much they may differ, px.
    pub left_right_check_threshold_px: u32,
    /// `confidenceThreshold` of `DepthAI` 3, 0 to 255: what is below is lost, 0 keeps all.
    /// [`Parameters::confidence_threshold_v2`] is that of older versions.
    pub confidence_threshold: u8,
    /// `numInvalidateEdgePixels`: columns at the left border that are lost, px.
    pub invalid_edge_px: u32,
    /// `kernelSize` of the census transform.
    pub kernel_size: CensusKernel,
    /// `kernelMask`: which pixels of the window count, row by row without the middle, the first in the highest bit; 0 for
    /// `DepthAI`'s choice: every other one of images wider than 640 px, all of others.
    pub kernel_mask: u64,
    /// `enableMeanMode`: whether pixels are compared with the window's mean, or with its middle.
    pub mean_mode: bool,
    /// `censusTransform.threshold`: by how much more a pixel must have, grey levels of 8 bits.
    pub census_threshold: u32,
    /// `noiseThresholdOffset` of RVC4: added to that.
    pub noise_threshold_offset: i32,
    /// `noiseThresholdScale` of RVC4: added to that for each 4096 grey levels. What it is for each is an estimate.
    pub noise_threshold_scale: i32,
    /// `disparityWidth`: how many disparities are searched.
    pub disparity_width: DisparityWidth,
    /// `enableCompanding`: whether the last are spread: of 96, 48 in steps of 1 px, 32 of 2, 16 of 4; of 64,
    /// 32, 16 and 16.
    pub companding: bool,
    /// `alpha`: how much the difference of grey levels counts.
    pub alpha: u8,
    /// `beta`: how much the difference of census transforms counts.
    pub beta: u8,
    /// `linearEquationParameters.threshold`: the largest cost, to 127.
    pub cost_threshold: u8,
    /// `blockSize`: over how many rows and columns a candidate's cost is averaged, 1, 3, 5 or 7. Not `DepthAI`'s, which calls
    /// its aggregation semi-global *block* matching and does not publish the block: [`Parameters::new`].
    pub block_size_px: u32,
    /// `divisionFactor`: what sums of costs are divided by.
    pub division_factor: u8,
    /// `platform`: whose penalties and steps count, RVC2's or RVC4's. What is the other's has no effect.
    pub platform: Platform,
    /// `horizontalPenaltyCostP1` of RVC2: along rows, for a step of one disparity.
    pub horizontal_p1: u32,
    /// `horizontalPenaltyCostP2` of RVC2: for a larger step.
    pub horizontal_p2: u32,
    /// `verticalPenaltyCostP1` of RVC2: of all other paths.
    pub vertical_p1: u32,
    /// `verticalPenaltyCostP2` of RVC2
    pub vertical_p2: u32,
    /// `penaltyShift`: RVC2's penalties are divided by 2 to the power of it. Not `DepthAI`'s: [`Parameters::new`].
    pub penalty_shift: u32,
    /// `p1Config` of RVC4
    pub p1: AdaptivePenalty,
    /// `p2Config` of RVC4
    pub p2: AdaptivePenalty,
    /// `edgeThreshold` of RVC4, grey levels of 8 bits.
    pub edge_threshold: u32,
    /// `smoothThreshold` of RVC4, grey levels of 8 bits.
    pub smooth_threshold: u32,
    /// `confidenceMetrics` of RVC4
    pub confidence_metrics: ConfidenceMetrics,
    /// `holeFilling` of RVC4
    pub hole_filling: HoleFilling,
    /// `adaptiveMedianFilter` of RVC4
    pub adaptive_median: AdaptiveMedian,
    /// `paths`: how many there are, 3, 4, 5, 6 or 8. Not `DepthAI`'s, whose number is not published. 3: along rows, and
    /// from above; 4: from below too; 5: along rows, and from above straight and aslant; 6: from straight below too; 8: all.
    pub paths: u32,
    /// `depthRounding`: how depth becomes whole millimetres.
    pub depth_rounding: DepthRounding,
}

impl Parameters {
    /// `DepthAI`'s defaults. What it does not have or does not publish:
    /// * `subpixelInterpolation`: chosen by fit to the vendor's error curve of an 800P unit (f 794 px, bias −0.22 px, beyond 2.5 m,
    ///   two captures). R² is 0.94 with `LINES`, 0.87 with `PARABOLA_5`, 0.79 with `PARABOLA`; the board's detail was chosen by the
    ///   same curve, with `LINES`.
    /// * `paths`: 4. By that curve any number would do (0.92 with 3, 0.94 with 5, 0.95 with 8); with 8 surfaces aslant come out
    ///   in steps, and it takes longer.
    /// * `blockSize` and `penaltyShift`: 5 and 4. Of rendered pairs with noise no more is wrong then than `OpenCV` has wrong; with a
    ///   block of 1 half as much again.
    /// * `kernelSize`: 5×5.
    #[must_use]
    pub fn new(platform: Platform, stereo: StereoGeometry, width_px: u32) -> Self {
        let is_rvc4 = platform == Platform::Rvc4;
        Self {
            stereo,
            width_px,
            subpixel: Subpixel::default(),
            interpolation: Interpolation::default(),
            extended_disparity: false,
            disparity_shift_px: 0,
            left_right_check: true,
            left_right_check_threshold_px: 10,
            confidence_threshold: 55,
            invalid_edge_px: 0,
            kernel_size: CensusKernel::Auto,
            kernel_mask: 0,
            mean_mode: true,
            census_threshold: 0,
            noise_threshold_offset: i32::from(is_rvc4),
            noise_threshold_scale: i32::from(is_rvc4),
            disparity_width: DisparityWidth::Disparity96,
            companding: false,
            alpha: 0,
            beta: 2,
            cost_threshold: 127,
            block_size_px: 5,
            division_factor: 1,
            platform,
            horizontal_p1: 250,
            horizontal_p2: 500,
            vertical_p1: 250,
            vertical_p2: 500,
            penalty_shift: 4,
            p1: AdaptivePenalty {
                adaptive: true,
                default: 11,
                edge: 10,
                smooth: 22,
            },
            p2: AdaptivePenalty {
                adaptive: true,
                default: 33,
                edge: 22,
                smooth: 63,
            },
            edge_threshold: 15,
            smooth_threshold: 5,
            confidence_metrics: ConfidenceMetrics::default(),
            hole_filling: HoleFilling::default(),
            adaptive_median: AdaptiveMedian::default(),
            paths: 4,
            depth_rounding: DepthRounding::default(),
        }
    }

    /// The confidence threshold of `DepthAI` 2, whose confidence counts down: what is above is lost, 255 keeps all.
    #[must_use]
    pub const fn confidence_threshold_v2(&self) -> u8 {
        255 - self.confidence_threshold
    }

    /// Changes the confidence threshold by that of `DepthAI` 2.
    pub const fn set_confidence_threshold_v2(&mut self, threshold: u8) {
        self.confidence_threshold = 255 - threshold;
    }

    /// How many disparities are searched.
    #[must_use]
    pub const fn candidates(&self) -> u32 {
        match self.disparity_width {
            DisparityWidth::Disparity96 => 96,
            DisparityWidth::Disparity64 => 64,
        }
    }

    /// The largest disparity that is found, px; extended, twice that of one pass.
    #[must_use]
    pub const fn max_disparity_px(&self) -> u32 {
        let last = match (self.disparity_width, self.companding) {
            (DisparityWidth::Disparity96, false) => 95,
            (DisparityWidth::Disparity96, true) => 175,
            (DisparityWidth::Disparity64, false) => 63,
            (DisparityWidth::Disparity64, true) => 127,
        };
        let most = last + self.disparity_shift_px;
        if self.extended_disparity { 2 * most } else { most }
    }

    /// The largest value of a disparity image: the range that is searched, in steps.
    #[must_use]
    pub const fn max_fixed_disparity(&self) -> u32 {
        (self.max_disparity_px() - self.disparity_shift_px) << self.subpixel.bits()
    }

    /// What its disparity images count in.
    pub(crate) fn fixed(&self) -> Fixed {
        Fixed {
            stereo: self.stereo,
            subpixel: self.subpixel,
            shift_px: self.disparity_shift_px,
            rounding: self.depth_rounding,
        }
    }

    /// Whether these make a matcher.
    ///
    /// # Errors
    /// One that is out of its range, or no number.
    pub fn check(&self) -> Result<(), ParameterError> {
        let (f, b) = (self.stereo.focal_length_px, self.stereo.baseline_m);
        let ranges = [
            ("focalLength", f, 1.0, 1e5, "px"),
            ("baseline", b, 1e-4, 2.0, "m: 75 mm are 0.075"),
            ("width", self.width_px.into(), 1.0, 16384.0, "px"),
            (
                "disparityShift",
                self.disparity_shift_px.into(),
                0.0,
                1024.0,
                "px",
            ),
            (
                "leftRightCheckThreshold",
                self.left_right_check_threshold_px.into(),
                0.0,
                128.0,
                "px",
            ),
            (
                "numInvalidateEdgePixels",
                self.invalid_edge_px.into(),
                0.0,
                16384.0,
                "px",
            ),
            (
                "censusTransform.threshold",
                self.census_threshold.into(),
                0.0,
                255.0,
                "grey levels",
            ),
            (
                "noiseThresholdOffset",
                self.noise_threshold_offset.into(),
                0.0,
                127.0,
                "grey levels",
            ),
            (
                "noiseThresholdScale",
                self.noise_threshold_scale.into(),
                -128.0,
                127.0,
                "",
            ),
            (
                "linearEquationParameters.threshold",
                self.cost_threshold.into(),
                1.0,
                127.0,
                "",
            ),
            ("divisionFactor", self.division_factor.into(), 1.0, 255.0, ""),
            ("penaltyShift", self.penalty_shift.into(), 0.0, 15.0, "bits"),
            (
                "edgeThreshold",
                self.edge_threshold.into(),
                0.0,
                255.0,
                "grey levels",
            ),
            (
                "smoothThreshold",
                self.smooth_threshold.into(),
                0.0,
                255.0,
                "grey levels",
            ),
        ];
        let penalties = [
            (
                "horizontalPenaltyCostP1",
                self.horizontal_p1 >> self.penalty_shift.min(31),
            ),
            (
                "horizontalPenaltyCostP2",
                self.horizontal_p2 >> self.penalty_shift.min(31),
            ),
            (
                "verticalPenaltyCostP1",
                self.vertical_p1 >> self.penalty_shift.min(31),
            ),
            (
                "verticalPenaltyCostP2",
                self.vertical_p2 >> self.penalty_shift.min(31),
            ),
            ("p1Config.defaultValue", self.p1.default),
            ("p1Config.edgeValue", self.p1.edge),
            ("p1Config.smoothValue", self.p1.smooth),
            ("p2Config.defaultValue", self.p2.default),
            ("p2Config.edgeValue", self.p2.edge),
            ("p2Config.smoothValue", self.p2.smooth),
        ];
        let penalties = penalties.map(|(name, value)| {
            (
                name,
                f64::from(value),
                0.0,
                MAX_PENALTY.into(),
                "after penaltyShift",
            )
        });
        for (name, value, low, high, unit) in ranges.into_iter().chain(penalties) {
            let what = if value.is_nan() {
                "it is no number".to_owned()
            } else if (low..=high).contains(&value) {
                continue;
            } else {
                format!("{value} is out of range")
            };
            let remedy = format!("give {low} to {high} {unit}");
            return Err(ParameterError::new(name, what, remedy.trim_end()));
        }
        if !matches!(self.block_size_px, 1 | 3 | 5 | 7) {
            let what = format!("there is no block of {}", self.block_size_px);
            return Err(ParameterError::new("blockSize", what, "give 1, 3, 5 or 7"));
        }
        if !matches!(self.paths, 3..=6 | 8) {
            let what = format!("there is no set of {}", self.paths);
            return Err(ParameterError::new("paths", what, "give 3, 4, 5, 6 or 8"));
        }
        self.confidence_metrics.check()?;
        self.hole_filling.check()
    }
}

/// Largest of penalties: sums of 8 paths then have 16 bits.
pub(super) const MAX_PENALTY: u32 = 7680;
