use oaktwin_base::parameter::{
    FieldText, Hexadecimal, Kind, ParameterError, Platform, Value, choice, parameters,
};
use oaktwin_camera::StereoGeometry;

use crate::disparity::{DepthRounding, Fixed, FractionalBits, Subpixel, SubpixelSwitch};

choice! {
    /// The window of the census transform, rows × columns.
    CensusKernel {
        /// 5×5. The device's choice is not published.
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
    /// The number of disparities in the search range.
    DisparityWidth {
        /// 0 to 95.
        Disparity96 = "DISPARITY_96",
        /// 0 to 63.
        Disparity64 = "DISPARITY_64",
    }
}

choice! {
    /// The subpixel interpolation of the minimum of the summed costs. The device's is not published, except that it uses
    /// two neighbours on each side.
    Interpolation {
        /// The intersection of two lines of equal slope through three sums.
        Lines = "LINES",
        /// The vertex of the parabola fitted to five sums; to three beside the ends of the range.
        Parabola5 = "PARABOLA_5",
        /// The vertex of the parabola through three sums.
        Parabola = "PARABOLA",
    }
}

/// An RVC4 penalty for a change of disparity along a path.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct AdaptivePenalty {
    /// Whether it depends on the image.
    pub adaptive: bool,
    /// The penalty where it does not depend on the image.
    pub default: u32,
    /// The penalty where neighbours differ by more than `edgeThreshold`.
    pub edge: u32,
    /// The penalty where neighbours differ by less than `smoothThreshold`.
    pub smooth: u32,
}

parameters! {
    /// The parameters of the stereo matcher. Lengths in pixels are in matcher pixels.
    pub struct Parameters("stereo-matching", platform) {
        /// The geometry of the rectified pair.
        stereo: StereoGeometry = StereoGeometry { focal_length_px: 800.0, baseline_m: 0.075 } => {
            /// The focal length of the rectified images, in matcher pixels.
            .focal_length_px: f64 => ("focalLength".unit("px").range(1.0..=1e5).typical(200.0..=2000.0).from_camera()),
            /// The distance between the optical centres.
            .baseline_m: f64 => ("baseline".unit("m").range(1e-4..=2.0).typical(0.02..=0.3).from_camera()),
        },
        /// The width of the images that the focal length is for; it is scaled for a pair of another width.
        width_px: u32 = 1280 => ("width".unit("px").range(1.0..=16384.0).typical(320.0..=1920.0).from_camera()),
        /// The step of disparity.
        subpixel: Subpixel = Subpixel::default() => {
            /// Whether disparity has fractional bits.
            : Subpixel => ("subpixel" as SubpixelSwitch.common(2)),
            /// The fractional bits of disparity: 3, 4 or 5, or 0 for whole pixels.
            : Subpixel => ("subpixelFractionalBits" as FractionalBits),
        },
        /// The subpixel interpolation. On the vendor's error curve of an 800P unit (f 794 px, bias −0.22 px, beyond 2.5 m,
        /// two captures) R² is 0.94 with `LINES`, 0.87 with `PARABOLA_5` and 0.79 with `PARABOLA`; the texture of the
        /// board was chosen by the same curve, with `LINES`.
        interpolation: Interpolation = Interpolation::default()
            => ("subpixelInterpolation".chosen("fit to the vendor's error curve")),
        /// Whether images of half the size are matched too, for near surfaces.
        extended_disparity: bool = false => ("extendedDisparity"),
        /// The first disparity of the search range.
        disparity_shift_px: u32 = 0 => ("disparityShift".common(5).unit("px").range(0.0..=1024.0).typical(0.0..=128.0)),
        /// Whether the left-right check is enabled.
        left_right_check: bool = true => ("leftRightCheck"),
        /// The largest difference between both directions of matching that the left-right check accepts.
        left_right_check_threshold_px: u32 = 10 => ("leftRightCheckThreshold".common(3).unit("px").range(0.0..=128.0).typical(0.0..=20.0)),
        /// The minimum confidence, as in `DepthAI` 3; 0 keeps all.
        confidence_threshold: u8 = 55 => ("confidenceThreshold".common(1).range(0.0..=255.0)),
        /// The number of columns at the left border that are lost.
        invalid_edge_px: u32 = 0 => ("numInvalidateEdgePixels".unit("px").range(0.0..=16384.0).typical(0.0..=64.0)),
        /// The window of the census transform.
        kernel_size: CensusKernel = CensusKernel::Auto => ("kernelSize".common(4)),
        /// The pixels of the window that are compared, row by row without the centre, the first in the highest bit. 0 is
        /// `DepthAI`'s choice: every second pixel in images at least 1280 px wide, all pixels in others.
        kernel_mask: u64 = 0 => ("kernelMask" as Hexadecimal),
        /// Whether pixels are compared with the mean of the window instead of its centre.
        mean_mode: bool = true => ("enableMeanMode"),
        /// The minimum excess of a brighter pixel, in 8-bit grey levels.
        census_threshold: u32 = 0 => ("censusTransform.threshold".unit("grey levels").range(0.0..=255.0).typical(0.0..=32.0)),
        /// An offset to that threshold, in 8-bit grey levels.
        noise_threshold_offset: i32 = i32::from(platform == Platform::Rvc4)
            => ("noiseThresholdOffset".unit("grey levels").range(0.0..=127.0)),
        /// An offset to that threshold for each 4096 grey levels; that unit is an estimate.
        noise_threshold_scale: i32 = i32::from(platform == Platform::Rvc4)
            => ("noiseThresholdScale".range(-128.0..=127.0)),
        /// The number of disparities in the search range.
        disparity_width: DisparityWidth = DisparityWidth::Disparity96 => ("disparityWidth"),
        /// Whether the last disparities are spread: of 96, 48 in steps of 1 px, 32 of 2 px and 16 of 4 px; of 64, 32, 16
        /// and 16.
        companding: bool = false => ("enableCompanding"),
        /// The weight of the difference of grey levels.
        alpha: u8 = 0 => ("alpha".range(0.0..=255.0)),
        /// The weight of the difference of census transforms.
        beta: u8 = 2 => ("beta".range(0.0..=255.0)),
        /// The largest cost.
        cost_threshold: u8 = 127 => ("linearEquationParameters.threshold".range(1.0..=127.0)),
        /// The side of the block over which costs are averaged. `DepthAI` calls its aggregation semi-global *block*
        /// matching and does not publish the block: 5, with `penaltyShift` 4, has no more wrong pixels than OpenCV on
        /// rendered pairs with noise; a block of 1 has half as many again.
        block_size_px: u32 = 5 => ("blockSize".unit("px").range(1.0..=7.0).step(2.0).chosen("rendered pairs")),
        /// The rows of that block, an odd number, or 0 for as many as columns. Pictures of five RVC2 units have holes that are wide
        /// and low, which one row reproduces (with 3 `paths` and `penaltyShift` 2); but then more pixels of rendered pairs are
        /// wrong than with OpenCV.
        block_rows_px: u32 = 0 => ("blockRows".unit("px").range(0.0..=7.0).chosen("rendered pairs")),
        /// The divisor of the summed costs.
        division_factor: u8 = 1 => ("divisionFactor".range(1.0..=255.0).typical(1.0..=8.0)),
        /// The platform whose penalties and steps are used; parameters of the other one have no effect.
        platform: Platform = platform => ("platform".from_camera()),
        /// The penalty along rows for a step of one disparity.
        horizontal_p1: u32 = 250 => ("horizontalPenaltyCostP1".on(Platform::Rvc2)),
        /// The penalty along rows for a larger step.
        horizontal_p2: u32 = 500 => ("horizontalPenaltyCostP2".on(Platform::Rvc2)),
        /// The penalty along all other paths for a step of one disparity.
        vertical_p1: u32 = 250 => ("verticalPenaltyCostP1".on(Platform::Rvc2)),
        /// The penalty along all other paths for a larger step.
        vertical_p2: u32 = 500 => ("verticalPenaltyCostP2".on(Platform::Rvc2)),
        /// The number of bits that the penalties are shifted right by: see `blockSize`.
        penalty_shift: u32 = 4
            => ("penaltyShift".unit("bits").range(0.0..=15.0).on(Platform::Rvc2).chosen("rendered pairs")),
        /// The penalty for a step of one disparity.
        p1: AdaptivePenalty = AdaptivePenalty { adaptive: true, default: 11, edge: 10, smooth: 22 } => {
            /// Whether P1 depends on the image.
            .adaptive: bool => ("p1Config.enableAdaptive".on(Platform::Rvc4)),
            /// P1 where it does not depend on the image.
            .default: u32 => ("p1Config.defaultValue".range(0.0..=7680.0).typical(0.0..=255.0).on(Platform::Rvc4)),
            /// P1 where neighbours differ by more than `edgeThreshold`.
            .edge: u32 => ("p1Config.edgeValue".range(0.0..=7680.0).typical(0.0..=255.0).on(Platform::Rvc4)),
            /// P1 where neighbours differ by less than `smoothThreshold`.
            .smooth: u32 => ("p1Config.smoothValue".range(0.0..=7680.0).typical(0.0..=255.0).on(Platform::Rvc4)),
        },
        /// The penalty for a larger step.
        p2: AdaptivePenalty = AdaptivePenalty { adaptive: true, default: 33, edge: 22, smooth: 63 } => {
            /// Whether P2 depends on the image.
            .adaptive: bool => ("p2Config.enableAdaptive".on(Platform::Rvc4)),
            /// P2 where it does not depend on the image.
            .default: u32 => ("p2Config.defaultValue".range(0.0..=7680.0).typical(0.0..=255.0).on(Platform::Rvc4)),
            /// P2 where neighbours differ by more than `edgeThreshold`.
            .edge: u32 => ("p2Config.edgeValue".range(0.0..=7680.0).typical(0.0..=255.0).on(Platform::Rvc4)),
            /// P2 where neighbours differ by less than `smoothThreshold`.
            .smooth: u32 => ("p2Config.smoothValue".range(0.0..=7680.0).typical(0.0..=255.0).on(Platform::Rvc4)),
        },
        /// The difference of neighbours above which they are an edge, in 8-bit grey levels.
        edge_threshold: u32 = 15
            => ("edgeThreshold".unit("grey levels").range(0.0..=255.0).on(Platform::Rvc4)),
        /// The difference of neighbours below which they are smooth, in 8-bit grey levels.
        smooth_threshold: u32 = 5
            => ("smoothThreshold".unit("grey levels").range(0.0..=255.0).on(Platform::Rvc4)),
        /// RVC4's confidence.
        confidence_metrics: ConfidenceMetrics = ConfidenceMetrics::default() => [
            /// RVC4's confidence: a weighted mean of an occlusion, a variance and a flatness measure.
            ///
            /// Names, ranges and defaults are published. In all of `DepthAI`'s settings the weights add up to 32; hence the
            /// mean used here, (Σ weight · measure) >> 5, at most 255. The three measures are not published; here each is
            /// 255 for a perfect pixel and 0 for the worst one.
            struct ConfidenceMetrics {
                /// The weight of the occlusion measure: 255 where the right image's disparity is the same to 1 px, else 0.
                occlusion_weight: u8 = 20
                    => ("occlusionConfidenceWeight".range(0.0..=32.0).on(Platform::Rvc4)),
                /// The weight of the variance measure: 255 less 40.5 for each px² of the variance of disparity in the 3×3
                /// neighbourhood. Differences are clamped to 16 px.
                motion_vector_weight: u8 = 4
                    => ("motionVectorConfidenceWeight".range(0.0..=32.0).on(Platform::Rvc4)),
                /// The binary logarithm of the scale of the variance; 0 is the most tolerant.
                motion_vector_threshold: u8 = 1
                    => ("motionVectorConfidenceThreshold".range(0.0..=3.0).on(Platform::Rvc4)),
                /// The weight of the flatness measure: the share by which the smallest summed cost is below the smallest
                /// one that is not its neighbour.
                flatness_weight: u8 = 8 => ("flatnessConfidenceWeight".range(0.0..=32.0).on(Platform::Rvc4)),
                /// The share in eighths up to which the flatness measure is 0; from one eighth more it is 255.
                flatness_threshold: u8 = 2
                    => ("flatnessConfidenceThreshold".range(1.0..=7.0).on(Platform::Rvc4)),
                /// Whether the flatness measure alone is the confidence.
                flatness_override: bool = false => ("flatnessOverride".on(Platform::Rvc4)),
            }
        ],
        /// RVC4's hole filling.
        hole_filling: HoleFilling = HoleFilling::default() => [
            /// RVC4's hole filling: pixels of low confidence take the mean of their superpixel.
            ///
            /// Superpixels are computed by SLIC, which Qualcomm's interface to the hardware names. Their size is not
            /// published: here there is one for each 8×8 pixels of the left image, after two rounds, and an 8-bit grey
            /// level weighs as much as a pixel. Filling does not change the confidence, which is an estimate too.
            struct HoleFilling {
                /// Whether holes are filled.
                enable: bool = true => ("holeFilling.enable".on(Platform::Rvc4)),
                /// The confidence above which a pixel contributes to the mean.
                high_confidence_threshold: u8 = 210
                    => ("holeFilling.highConfidenceThreshold".range(1.0..=255.0).on(Platform::Rvc4)),
                /// The confidence below which a pixel is filled.
                fill_confidence_threshold: u8 = 200
                    => ("holeFilling.fillConfidenceThreshold".range(1.0..=255.0).on(Platform::Rvc4)),
                /// The share of a superpixel that must have a high confidence: 1 a half, 2 a quarter, 3 an eighth.
                min_valid_disparity: u8 = 1
                    => ("holeFilling.minValidDisparity".range(1.0..=3.0).on(Platform::Rvc4)),
                /// Whether pixels of low confidence are lost in superpixels that are not filled.
                invalidate_disparities: bool = true
                    => ("holeFilling.invalidateDisparities".on(Platform::Rvc4)),
            }
        ],
        /// RVC4's adaptive median filter.
        adaptive_median: AdaptiveMedian = AdaptiveMedian::default() => [
            /// RVC4's adaptive median filter: pixels of low confidence take the median of their neighbourhood.
            ///
            /// The size of the neighbourhood is not published: here it is 3×3, with the border of the image repeated. A
            /// neighbour without a disparity is replaced by the pixel itself; a pixel without one stays invalid.
            struct AdaptiveMedian {
                /// Whether the adaptive median filter is enabled.
                enable: bool = true => ("adaptiveMedianFilter.enable".on(Platform::Rvc4)),
                /// The confidence below which a pixel is filtered.
                confidence_threshold: u8 = 200
                    => ("adaptiveMedianFilter.confidenceThreshold".range(0.0..=255.0).on(Platform::Rvc4)),
            }
        ],
        /// The number of aggregation paths: 3 along rows and from above; 4 from below too; 5 along rows, from above and
        /// from above diagonally; 6 from below too; 8 all. On the vendor's error curve R² is 0.92 with 3, 0.94 with 4 and
        /// 5, 0.95 with 8; with 8, slanted surfaces become stepped, and matching takes longer.
        paths: u32 = 4 => ("paths" as Paths.chosen("the vendor's error curve and slanted surfaces")),
        /// The rounding of depth to whole millimetres.
        depth_rounding: DepthRounding = DepthRounding::default() => ("depthRounding".estimate()),
    }
    also {
        /// The confidence threshold of `DepthAI` 2, 255 − `confidenceThreshold`; 255 keeps all.
        .confidence_threshold: u8 => ("confidenceThresholdV2" as CountingDown.range(0.0..=255.0)),
    }
    check relations
}

/// The confidence threshold of `DepthAI` 2.
struct CountingDown;

impl FieldText<u8> for CountingDown {
    const KIND: Kind = Kind::Integer;

    fn set(field: &mut u8, text: &str) -> Option<()> {
        *field = 255 - u8::parse(text)?;
        Some(())
    }

    fn get(field: &u8) -> String {
        (255 - field).to_string()
    }
}

/// A number of aggregation paths.
struct Paths;

impl FieldText<u32> for Paths {
    const KIND: Kind = Kind::Text("3, 4, 5, 6 or 8");

    fn set(field: &mut u32, text: &str) -> Option<()> {
        *field = u32::parse(text).filter(|&paths| is_set_of_paths(paths))?;
        Some(())
    }

    fn get(field: &u32) -> String {
        field.text()
    }
}

const fn is_set_of_paths(paths: u32) -> bool {
    matches!(paths, 3..=6 | 8)
}

impl Parameters {
    /// Returns `DepthAI`'s defaults for a stereo pair on a platform, and choices of our own where it has none.
    #[must_use]
    pub fn new(platform: Platform, stereo: StereoGeometry, width_px: u32) -> Self {
        Self {
            stereo,
            width_px,
            ..Self::defaults(platform)
        }
    }

    /// The confidence threshold of `DepthAI` 2, whose confidence is inverted; 255 keeps all.
    #[must_use]
    pub const fn confidence_threshold_v2(&self) -> u8 {
        255 - self.confidence_threshold
    }

    /// Sets the confidence threshold to `DepthAI` 2's.
    pub const fn set_confidence_threshold_v2(&mut self, threshold: u8) {
        self.confidence_threshold = 255 - threshold;
    }

    /// The number of disparities in the search range.
    #[must_use]
    pub const fn candidates(&self) -> u32 {
        match self.disparity_width {
            DisparityWidth::Disparity96 => 96,
            DisparityWidth::Disparity64 => 64,
        }
    }

    /// The largest disparity in the search range, px; in extended mode twice the range of one pass.
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

    /// The largest value of a disparity image: the search range in steps.
    #[must_use]
    pub const fn max_fixed_disparity(&self) -> u32 {
        (self.max_disparity_px() - self.disparity_shift_px) << self.subpixel.bits()
    }

    pub(crate) fn fixed(&self) -> Fixed {
        Fixed {
            stereo: self.stereo,
            subpixel: self.subpixel,
            shift_px: self.disparity_shift_px,
            rounding: self.depth_rounding,
        }
    }

    fn relations(&self) -> Result<(), ParameterError> {
        let rvc2 = [
            ("horizontalPenaltyCostP1", self.horizontal_p1),
            ("horizontalPenaltyCostP2", self.horizontal_p2),
            ("verticalPenaltyCostP1", self.vertical_p1),
            ("verticalPenaltyCostP2", self.vertical_p2),
        ];
        for (name, penalty) in rvc2 {
            let shifted = penalty >> self.penalty_shift.min(31);
            if shifted > MAX_PENALTY {
                let what = format!("{shifted} is out of range after penaltyShift");
                return Err(ParameterError::new(
                    name,
                    what,
                    format!("expected 0 to {MAX_PENALTY}"),
                ));
            }
        }
        if self.block_rows_px != 0 && self.block_rows_px.is_multiple_of(2) {
            let what = format!("invalid value '{}'", self.block_rows_px);
            return Err(ParameterError::new(
                "blockRows",
                what,
                "expected 0 or an odd number",
            ));
        }
        if !is_set_of_paths(self.paths) {
            let what = format!("invalid value '{}'", self.paths);
            return Err(ParameterError::new("paths", what, "expected 3, 4, 5, 6 or 8"));
        }
        Ok(())
    }
}

/// The largest penalty, for which the sums of 8 paths fit into 16 bits.
pub(super) const MAX_PENALTY: u32 = 7680;

/// The platform without which a parameter has no effect; `None` if it has an effect on both, or does not exist.
#[must_use]
pub fn platform_of(name: &str) -> Option<Platform> {
    <Parameters as oaktwin_base::parameter::Table>::row(name)
        .ok()?
        .about
        .platform
}
