//! Texture of the colour image: the saturated Sobel magnitude of its luma.

use super::assumptions::ConfidenceComparison;
use super::plan::SingleViewPlan;
use crate::random::RandomPlane;
use oaktwin_simd::saturating_trunc;

/// Computes the luma of a row of the colour image with the given weights.
#[inline(always)]
pub(super) fn luma([red, green, blue]: [f32; 3], rgb: &[[u8; 4]], out: &mut [f32]) {
    for (out, &pixel) in out.iter_mut().zip(rgb) {
        let word = u32::from_le_bytes(pixel);
        let channel = |shift: u32| ((word >> shift) & 0xFF).cast_signed() as f32;
        *out = red * channel(0) + green * channel(8) + blue * channel(16);
    }
}

/// Returns a confidence of 0 to 1 as a whole number of 0 to 255.
pub(super) fn level(confidence: f32) -> u16 {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 to 255")]
    let level = saturating_trunc(255.0 * confidence + 0.5) as u16;
    level
}

/// The luma in levels of 8 bits of three rows around the current one. Beyond the image, its border is repeated.
#[derive(Debug, Default)]
pub(super) struct Texture {
    /// Row y is at index y % 3, with one more column on either side.
    rows: [Vec<f32>; 3],
    /// The numbers of the rows in `luma`.
    held: Option<(usize, usize)>,
    grain: Vec<f32>,
    /// The saturated magnitude of the row of the last [`Texture::measure_row`].
    pub(super) confidence: Vec<f32>,
    /// 1 where the magnitude is below the threshold, else 0.
    pub(super) lacking: Vec<u32>,
}

impl Texture {
    pub(super) fn reset(&mut self, width: usize) {
        for row in &mut self.rows {
            row.resize(width + 2, 0.0);
        }
        self.held = None;
        self.grain.resize(width, 0.0);
        self.confidence.resize(width, 0.0);
        self.lacking.resize(width, 0);
    }

    /// Fills `confidence` and `lacking` for row `y` of the colour image.
    #[inline(always)]
    pub(super) fn measure_row(
        &mut self,
        plan: &SingleViewPlan,
        grain: &RandomPlane,
        rgb: &[[u8; 4]],
        y: usize,
    ) {
        let (first, last) = (y.saturating_sub(1), (y + 1).min(plan.height - 1));
        for row in first..=last {
            if self.held.is_none_or(|(from, to)| row < from || row > to) {
                self.read(plan, grain, rgb, row);
            }
        }
        self.held = Some((first, last));
        let [above, here, below] = [first, y, last].map(|row| self.rows[row % 3].as_slice());
        sobel(plan.sobel_gain, [above, here, below], &mut self.confidence);
        let threshold = plan.threshold;
        let tested = self.lacking.iter_mut().zip(&self.confidence);
        match plan.comparison {
            ConfidenceComparison::Complement => {
                tested.for_each(|(lacking, &s)| *lacking = u32::from(s < 1.0 - threshold));
            }
            ConfidenceComparison::Strict => {
                tested.for_each(|(lacking, &s)| *lacking = u32::from(s <= 1.0 - threshold));
            }
            ConfidenceComparison::Literal => {
                tested.for_each(|(lacking, &s)| *lacking = u32::from(threshold * s < threshold));
            }
        }
    }

    #[inline(always)]
    #[expect(clippy::cast_possible_truncation, reason = "rows of an image")]
    fn read(&mut self, plan: &SingleViewPlan, grain: &RandomPlane, rgb: &[[u8; 4]], y: usize) {
        let row = self.rows[y % 3].as_mut_slice();
        let width = plan.width;
        luma(plan.levels, &rgb[y * width..][..width], &mut row[1..=width]);
        if plan.rounds_levels {
            for luma in &mut row[1..=width] {
                *luma = saturating_trunc(*luma + 0.5) as f32;
            }
        }
        if plan.grain > 0.0 {
            grain.normals_here(y as u32, &mut self.grain);
            for (luma, grain) in row[1..=width].iter_mut().zip(&self.grain) {
                *luma += plan.grain * grain;
            }
        }
        row[0] = row[1];
        row[width + 1] = row[width];
    }
}

/// Computes min(1, gain · √(gx² + gy²)) with the kernels (1 2 1) and (−1 0 1); rows have one more column on either side.
#[inline(always)]
fn sobel(gain: f32, [above, here, below]: [&[f32]; 3], out: &mut [f32]) {
    let columns = above.windows(3).zip(here.windows(3)).zip(below.windows(3));
    for (out, ((a, b), c)) in out.iter_mut().zip(columns) {
        let gx = (a[2] - a[0]) + 2.0 * (b[2] - b[0]) + (c[2] - c[0]);
        let gy = (c[0] - a[0]) + 2.0 * (c[1] - a[1]) + (c[2] - a[2]);
        let s = gain * (gx * gx + gy * gy).sqrt();
        *out = if s < 1.0 { s } else { 1.0 };
    }
}
