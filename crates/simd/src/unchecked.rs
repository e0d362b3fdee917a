//! Conversions whose range is known, without the checks of `as`, which would keep loops from being vectorized.

#![expect(unsafe_code, reason = "the numbers are known to be in range")]

/// Truncates to an integer; numbers outside the range of `i32` become the nearest that single precision can represent, and
/// NaN the minimum.
#[inline(always)]
#[must_use]
pub fn saturating_trunc(value: f32) -> i32 {
    /// The largest `f32` below 2³¹.
    const MAX: f32 = 2_147_483_520.0;
    let value = if value > -MAX { value } else { -MAX };
    let value = if value < MAX { value } else { MAX };
    // SAFETY: the value is from −MAX to MAX.
    unsafe { value.to_int_unchecked() }
}

/// Two weights whose sum is 1, in single precision.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Weight {
    /// From 0 to 1.
    alpha: f32,
    /// From 0 to 1.
    rest: f32,
}

impl Weight {
    /// Creates the weights from the first one, clamped to 0 to 1; NaN becomes 0.
    #[must_use]
    pub fn new(alpha: f32) -> Self {
        let alpha = if alpha > 0.0 { alpha.min(1.0) } else { 0.0 };
        Self {
            alpha,
            rest: 1.0 - alpha,
        }
    }

    /// Mixes two numbers and rounds to the nearest integer, halves up.
    #[inline(always)]
    #[must_use]
    pub fn mix_rounded(&self, first: u16, second: u16) -> i32 {
        // SAFETY: as in `mix_truncated`, and at most 0.5 more.
        unsafe { (self.mix(first, second) + 0.5).to_int_unchecked() }
    }

    /// Mixes two numbers and truncates to an integer.
    #[inline(always)]
    #[must_use]
    pub fn mix_truncated(&self, first: u16, second: u16) -> i32 {
        // SAFETY: the numbers are from 0 to 65 535 and the weights from 0 to 1, so the sum is from 0 to 131 070.
        unsafe { self.mix(first, second).to_int_unchecked() }
    }

    #[inline(always)]
    fn mix(&self, first: u16, second: u16) -> f32 {
        f32::from(first) * self.alpha + f32::from(second) * self.rest
    }
}
