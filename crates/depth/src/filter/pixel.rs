use std::fmt::Debug;

/// A pixel of a disparity or depth image: `u8` without subpixels, `u16` otherwise. 0 is invalid.
pub trait Pixel: sealed::Pixel {}

impl Pixel for u8 {}
impl Pixel for u16 {}

pub(super) mod sealed {
    use super::Debug;

    /// The arithmetic of filters.
    pub trait Pixel:
        Copy + Ord + Default + Debug + Send + Sync + From<u8> + Into<u16> + Into<i32> + Into<f32> + 'static
    {
        /// The largest value.
        const MAX: Self;

        /// The absolute difference of two pixels.
        #[must_use]
        fn distance(self, other: Self) -> Self;

        /// The difference of two pixels in OpenCV's `filterSpeckles`, which receives 16-bit images as signed ones.
        #[must_use]
        fn speckle_distance(self, other: Self) -> Self;

        /// The next value, or the same at the end of the range.
        #[must_use]
        fn next(self) -> Self;

        /// The lower bits of a number.
        #[must_use]
        fn cut(value: i32) -> Self;
    }

    impl Pixel for u8 {
        const MAX: Self = Self::MAX;

        #[inline(always)]
        fn distance(self, other: Self) -> Self {
            self.abs_diff(other)
        }

        #[inline(always)]
        fn speckle_distance(self, other: Self) -> Self {
            self.abs_diff(other)
        }

        #[inline(always)]
        fn next(self) -> Self {
            self.saturating_add(1)
        }

        #[inline(always)]
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "only the lower bits are used"
        )]
        fn cut(value: i32) -> Self {
            value as Self
        }
    }

    impl Pixel for u16 {
        const MAX: Self = Self::MAX;

        #[inline(always)]
        fn distance(self, other: Self) -> Self {
            self.abs_diff(other)
        }

        #[inline(always)]
        fn speckle_distance(self, other: Self) -> Self {
            (self ^ 0x8000).abs_diff(other ^ 0x8000)
        }

        #[inline(always)]
        fn next(self) -> Self {
            self.saturating_add(1)
        }

        #[inline(always)]
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "only the lower bits are used"
        )]
        fn cut(value: i32) -> Self {
            value as Self
        }
    }
}
