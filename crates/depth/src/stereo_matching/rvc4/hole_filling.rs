//! Hole filling with the mean of the superpixel: [`HoleFilling`].

use super::super::parameters::HoleFilling;
use super::superpixels::{Superpixels, Total};
use super::{DISPARITY, each_row};

/// The sums of a superpixel.
#[derive(Clone, Copy, Debug, Default)]
struct Sure {
    count: u32,
    /// The number of pixels with a high confidence.
    sure: u32,
    disparity: u32,
}

impl Total for Sure {
    #[inline(always)]
    fn add(&mut self, other: &Self) {
        self.count += other.count;
        self.sure += other.sure;
        self.disparity += other.disparity;
    }
}

impl Sure {
    /// Returns the mean disparity of the pixels with a high confidence, or `None` if there are too few.
    fn mean(&self, holes: &HoleFilling) -> Option<u16> {
        let is_enough = self.sure << holes.min_valid_disparity.min(3) >= self.count;
        let mean = (self.disparity + self.sure / 2).checked_div(self.sure)?;
        u16::try_from(mean).ok().filter(|_| is_enough)
    }
}

pub(super) fn run(
    holes: &HoleFilling,
    superpixels: &Superpixels,
    width: usize,
    disparity: &mut [u16],
    confidence: &[u8],
) {
    let mut totals = Vec::new();
    let seen = &*disparity;
    superpixels.total(width, &mut totals, |y, x, sums: &mut Sure| {
        let at = y * width + x;
        let (Some(&disparity), Some(&confidence)) = (seen.get(at), confidence.get(at)) else {
            return;
        };
        let is_sure = confidence > holes.high_confidence_threshold;
        sums.count += 1;
        sums.sure += u32::from(is_sure);
        sums.disparity += if is_sure {
            u32::from(disparity & DISPARITY)
        } else {
            0
        };
    });
    let none = if holes.invalidate_disparities {
        Some(0)
    } else {
        None
    };
    let means: Vec<Option<u16>> = totals.iter().map(|sums| sums.mean(holes).or(none)).collect();
    each_row(
        width,
        disparity,
        confidence,
        || (),
        |(), y, disparity, confidence| {
            let pixels = disparity
                .iter_mut()
                .zip(confidence)
                .zip(superpixels.numbers(width, y));
            for ((own, &confidence), number) in pixels {
                if confidence >= holes.fill_confidence_threshold {
                    continue;
                }
                if let Some(&Some(mean)) = means.get(number) {
                    *own = (*own & !DISPARITY) | mean;
                }
            }
        },
    );
}
