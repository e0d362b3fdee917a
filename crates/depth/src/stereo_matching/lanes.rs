//! Numbers of the widths that costs fit into: the narrower, the more of them at a time.

/// A cost, or a sum of costs. What is added is known to fit: [`Plan`](super::plan::Plan) chooses the width.
pub(super) trait Lane: Copy + Ord + Default + std::fmt::Debug + Send + Sync + 'static {
    /// The largest, which nothing is worse than.
    const MAX: Self;
    /// A cost and the candidate that has it, ordered by cost, then by candidate.
    type Key: Copy + Ord + std::fmt::Debug + Send + Sync + 'static;
    /// The worst key.
    const LAST: Self::Key;

    fn of(value: u16) -> Self;
    fn wide(self) -> u16;
    fn plus(self, other: Self) -> Self;
    /// Stops at the largest.
    fn plus_saturating(self, other: Self) -> Self;
    fn minus(self, other: Self) -> Self;
    /// The largest where a byte is 255, itself where it is 0.
    fn masked(self, mask: u8) -> Self;
    fn key(self, candidate: u8) -> Self::Key;
    /// The key's cost and its candidate.
    fn open(key: Self::Key) -> (Self, u8);
}

macro_rules! lane {
    ($lane:ty, $key:ty) => {
        impl Lane for $lane {
            const MAX: Self = <$lane>::MAX;
            type Key = $key;
            const LAST: $key = <$key>::MAX;

            #[inline(always)]
            #[expect(clippy::allow_attributes, reason = "one of the two is no cast")]
            #[allow(clippy::cast_possible_truncation, reason = "known to fit")]
            fn of(value: u16) -> Self {
                value as Self
            }

            #[inline(always)]
            fn wide(self) -> u16 {
                self.into()
            }

            #[inline(always)]
            fn plus(self, other: Self) -> Self {
                self.wrapping_add(other)
            }

            #[inline(always)]
            fn plus_saturating(self, other: Self) -> Self {
                self.saturating_add(other)
            }

            #[inline(always)]
            fn minus(self, other: Self) -> Self {
                self.wrapping_sub(other)
            }

            #[inline(always)]
            #[expect(clippy::cast_sign_loss, reason = "all bits or none")]
            fn masked(self, mask: u8) -> Self {
                self | mask.cast_signed() as Self
            }

            #[inline(always)]
            fn key(self, candidate: u8) -> $key {
                (<$key>::from(self) << 8) | <$key>::from(candidate)
            }

            #[inline(always)]
            #[expect(clippy::cast_possible_truncation, reason = "its halves")]
            fn open(key: $key) -> (Self, u8) {
                ((key >> 8) as Self, key as u8)
            }
        }
    };
}

lane!(u8, u16);
lane!(u16, u32);
