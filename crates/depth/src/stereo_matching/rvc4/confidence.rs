//! RVC4's confidence: [`ConfidenceMetrics`].

use oaktwin_simd::{self as simd, Kernel, Level};
use rayon::prelude::*;

use super::super::parameters::ConfidenceMetrics;
use super::{BAND, DISPARITY, OCCLUDED, around, three};

/// Replaces the share, of 255, by which the smallest sum is below the smallest one that is not its neighbour with the
/// confidence.
pub(super) fn run(
    level: Level,
    metrics: &ConfidenceMetrics,
    bits: u32,
    width: usize,
    disparity: &[u16],
    confidence: &mut [u8],
) {
    let bands = confidence.par_chunks_mut(BAND * width).enumerate();
    bands.for_each(|(band, confidence)| {
        for (y, confidence) in (band * BAND..).zip(confidence.chunks_exact_mut(width)) {
            let Some(rows) = three(disparity, width, y) else {
                return;
            };
            simd::run_at(
                level,
                Confidence {
                    metrics,
                    bits,
                    rows,
                    confidence,
                },
            );
        }
    });
}

struct Confidence<'a> {
    metrics: &'a ConfidenceMetrics,
    bits: u32,
    rows: [&'a [u16]; 3],
    confidence: &'a mut [u8],
}

/// The limit to which differences of disparity are clamped, px.
const FARTHEST: i32 = 16;

impl Kernel for Confidence<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let m = self.metrics;
        let [occlusion, motion, flatness] =
            [m.occlusion_weight, m.motion_vector_weight, m.flatness_weight].map(i32::from);
        let threshold = i32::from(m.flatness_threshold);
        let is_override = m.flatness_override;
        let farthest = FARTHEST << self.bits;
        let raise = u32::from(m.motion_vector_threshold.min(3));
        let lower = 2 * self.bits + 1;
        around(self.rows, self.confidence, |near, confidence| {
            let own = near[4];
            let seen = if own & OCCLUDED == 0 { 255 } else { 0 };
            let middle = i32::from(own & DISPARITY);
            let (mut sum, mut squares) = (0, 0);
            for value in near {
                let apart = (i32::from(value & DISPARITY) - middle).clamp(-farthest, farthest);
                sum += apart;
                squares += apart * apart;
            }
            // This is 81 times the variance.
            let variance = 9 * squares - sum * sum;
            let still = 255 - ((variance << raise) >> lower).min(255);
            let steep = (8 * i32::from(*confidence) - 255 * threshold).clamp(0, 255);
            let mean = (occlusion * seen + motion * still + flatness * steep) >> 5;
            let sure = if is_override { steep } else { mean.min(255) };
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 to 255")]
            let sure = sure as u8;
            *confidence = sure;
        });
    }
}
