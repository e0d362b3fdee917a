//! The difference between a point and its best match in a row of the other image.

use oaktwin_simd::Kernel;

/// The number of columns and rows compared on each side of a point.
pub(super) const WINDOW: [usize; 2] = [6, 3];

/// The number of columns and rows of the compared window.
pub(super) const SIDES: [usize; 2] = [2 * WINDOW[0] + 1, 2 * WINDOW[1] + 1];

/// The number of pixels of the compared window.
pub(super) const AREA: f64 = (SIDES[0] * SIDES[1]) as f64;

/// The number of positions compared at once.
const AT_ONCE: usize = 32;

/// Returns the least sum of absolute differences between a window and a strip of the same height, over all positions of
/// the window along the strip.
pub(super) struct LeastDifference<'a> {
    pub(super) window: [&'a [u8; SIDES[0]]; SIDES[1]],
    /// Rows of equal length.
    pub(super) strip: [&'a [u8]; SIDES[1]],
}

impl Kernel for LeastDifference<'_> {
    type Output = u16;

    #[inline(always)]
    fn run(self) -> u16 {
        let length = self.strip[0].len();
        let positions = (length + 1).saturating_sub(SIDES[0]);
        let mut least = u16::MAX;
        if positions < AT_ONCE {
            for first in 0..positions {
                least = least.min(self.least::<1>(first));
            }
            return least;
        }
        let mut first = 0;
        while first < positions {
            // The last ones overlap those before them.
            first = first.min(positions - AT_ONCE);
            least = least.min(self.least::<AT_ONCE>(first));
            first += AT_ONCE;
        }
        least
    }
}

impl LeastDifference<'_> {
    /// Returns the least sum over `N` positions. A sum is at most 255 times 91.
    #[inline(always)]
    fn least<const N: usize>(&self, first: usize) -> u16 {
        let mut sums = [0u16; N];
        for (own, other) in self.window.iter().zip(&self.strip) {
            for (i, &level) in own.iter().enumerate() {
                let Some(others) = other.get(first + i..).and_then(|rest| rest.first_chunk::<N>()) else {
                    continue;
                };
                for k in 0..N {
                    sums[k] += u16::from(level.abs_diff(others[k]));
                }
            }
        }
        let mut least = u16::MAX;
        for sum in sums {
            least = least.min(sum);
        }
        least
    }
}
