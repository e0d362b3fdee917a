use super::assumptions::{
    Collision, ConfidenceAt, ConfidenceComparison, Depth, Direction, Luma, LumaRounding, MaxDisparity,
    MaxDisparityUnit, OutlierNeighbourhood, Quantizer, RangeCut, SigmaUnit,
};
use super::{Assumptions, Parameters};

/// The parameters and assumptions for images of one size, in the single precision of the pixel loops.
#[derive(Clone, Debug)]
pub(super) struct SingleViewPlan {
    pub(super) assumptions: Assumptions,
    pub(super) width: usize,
    pub(super) height: usize,
    /// Disparity times depth, px·m, above 0.
    pub(super) disparity_times_depth: f32,
    /// 1 if samples move to the right, −1 if to the left.
    pub(super) side: f32,
    /// The range of depths that become samples, m: above 0, and finite.
    pub(super) looked_at: [f32; 2],
    /// The range of depths that are reported, m.
    pub(super) reported: [f32; 2],
    /// `minDistance` and `maxDistance`, m.
    pub(super) range: [f32; 2],
    pub(super) max_disparity_px: f32,
    pub(super) clamps: bool,
    /// The disparity step; 0 disables steps and jitter.
    pub(super) step_px: f32,
    pub(super) floors: bool,
    pub(super) sigma_px: f32,
    /// The side of a patch of pixels with the same jitter.
    pub(super) patch_px: f64,
    /// The patch of each column.
    pub(super) patch_of: Vec<u32>,
    pub(super) recomputes: bool,
    pub(super) last_wins: bool,
    pub(super) outlier_range: usize,
    pub(super) outlier_diamond: bool,
    /// The weights of red, green and blue for luma of 0 to 1.
    pub(super) luma: [f32; 3],
    /// The weights of red, green and blue for luma of 0 to 255.
    pub(super) levels: [f32; 3],
    /// Whether levels are rounded to whole ones.
    pub(super) rounds_levels: bool,
    /// The gain for luma of 0 to 255, so that whole levels have exact magnitudes.
    pub(super) sobel_gain: f32,
    /// The standard deviation of the grain, levels.
    pub(super) grain: f32,
    pub(super) threshold: f32,
    /// Whether a sample can have too little confidence.
    pub(super) can_lack: bool,
    pub(super) comparison: ConfidenceComparison,
    pub(super) confidence_at: ConfidenceAt,
}

#[expect(clippy::cast_possible_truncation, reason = "pixels are single precision")]
impl SingleViewPlan {
    pub(super) fn new(p: &Parameters, a: &Assumptions, width: u32, height: u32) -> Self {
        let signed = p.disparity_times_depth(width);
        let range = [p.min_distance_m as f32, (p.max_distance_m as f32).min(f32::MAX)];
        let whole = [0.0, f32::MAX];
        let (looked_at, reported) = match a.range_cut {
            RangeCut::Before => (range, whole),
            RangeCut::After => (whole, range),
        };
        let unit_px = match a.max_disparity_unit {
            MaxDisparityUnit::Rendered => 1.0,
            MaxDisparityUnit::Sensor => f64::from(width) / p.sensor_size_px,
        };
        let sigma_px = match a.sigma_unit {
            SigmaUnit::Px => p.noise_sigma_px,
            SigmaUnit::Steps => p.noise_sigma_px * p.noise_mean_px,
        };
        let luma: [f64; 3] = match a.luma {
            Luma::Rec709 => [0.2126, 0.7152, 0.0722],
            Luma::Rec601 => [0.299, 0.587, 0.114],
            Luma::Mean => [1.0 / 3.0; 3],
        };
        let threshold = p.confidence_threshold as f32;
        let can_lack = match a.confidence_comparison {
            ConfidenceComparison::Complement => threshold < 1.0,
            ConfidenceComparison::Strict => true,
            ConfidenceComparison::Literal => threshold > 0.0,
        };
        Self {
            assumptions: *a,
            width: width as usize,
            height: height as usize,
            disparity_times_depth: signed.abs() as f32,
            side: if (signed > 0.0) == (a.direction == Direction::Right) {
                1.0
            } else {
                -1.0
            },
            looked_at,
            reported,
            range,
            max_disparity_px: (p.max_disparity_px * unit_px) as f32,
            clamps: a.max_disparity == MaxDisparity::Clamp,
            step_px: p.noise_mean_px as f32,
            floors: a.quantizer == Quantizer::Floor,
            sigma_px: sigma_px as f32,
            patch_px: p.noise_downscale_factor_px,
            patch_of: (0..width)
                .map(|x| patch(x as usize, p.noise_downscale_factor_px))
                .collect(),
            recomputes: a.depth == Depth::Recomputed,
            last_wins: a.collision == Collision::Last,
            outlier_range: if width as usize * height as usize > 1 {
                p.outlier_removal_range_px as usize
            } else {
                0
            },
            outlier_diamond: a.outlier_neighbourhood == OutlierNeighbourhood::Four,
            luma: luma.map(|weight| (weight / 255.0) as f32),
            levels: luma.map(|weight| weight as f32),
            rounds_levels: a.luma_rounding == LumaRounding::EightBit,
            sobel_gain: (a.sobel_gain / 255.0) as f32,
            grain: a.grain_levels as f32,
            threshold,
            can_lack,
            comparison: a.confidence_comparison,
            confidence_at: a.confidence_at,
        }
    }

    /// Returns the jitter patch of a row.
    pub(super) fn patch(&self, y: usize) -> u32 {
        patch(y, self.patch_px)
    }
}

/// Returns the patch of a column or row.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "columns and rows"
)]
fn patch(place: usize, patch_px: f64) -> u32 {
    (place as f64 / patch_px) as u32
}
