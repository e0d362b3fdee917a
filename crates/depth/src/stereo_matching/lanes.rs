//! The integer types of costs: narrower ones process more values at a time.

/// A cost or a sum of costs. Sums do not overflow: [`PassPlan`](super::plan::PassPlan) chooses the width.
pub(super) trait Lane: Copy + Ord + Default + std::fmt::Debug + Send + Sync + 'static {
    /// The largest value.
    const MAX: Self;
    /// A cost with its candidate, ordered by cost, then by candidate.
    type Key: Copy + Ord + std::fmt::Debug + Send + Sync + 'static;
    /// The largest key.
    const LAST: Self::Key;

    fn of(value: u16) -> Self;
    fn wide(self) -> u16;
    fn plus(self, other: Self) -> Self;
    /// Adds, saturating at the largest value.
    fn plus_saturating(self, other: Self) -> Self;
    fn minus(self, other: Self) -> Self;
    /// Returns the largest value if the mask is 255, the value itself if it is 0.
    fn masked(self, mask: u8) -> Self;
    fn key(self, candidate: u8) -> Self::Key;
    /// Returns the key's cost and candidate.
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

/// A sum of at most 9 bits, so that with a candidate of 7 bits its key has 16.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
#[repr(transparent)]
pub(super) struct Short(u16);

impl Lane for Short {
    const MAX: Self = Self(u16::MAX);
    type Key = u16;
    const LAST: u16 = u16::MAX;

    #[inline(always)]
    fn of(value: u16) -> Self {
        Self(value)
    }

    #[inline(always)]
    fn wide(self) -> u16 {
        self.0
    }

    #[inline(always)]
    fn plus(self, other: Self) -> Self {
        Self(self.0.wrapping_add(other.0))
    }

    #[inline(always)]
    fn plus_saturating(self, other: Self) -> Self {
        Self(self.0.saturating_add(other.0))
    }

    #[inline(always)]
    fn minus(self, other: Self) -> Self {
        Self(self.0.wrapping_sub(other.0))
    }

    #[inline(always)]
    fn masked(self, mask: u8) -> Self {
        Self(self.0.masked(mask))
    }

    #[inline(always)]
    fn key(self, candidate: u8) -> u16 {
        (self.0 << 7) | u16::from(candidate)
    }

    #[inline(always)]
    fn open(key: u16) -> (Self, u8) {
        (Self(key >> 7), (key & 127) as u8)
    }
}
