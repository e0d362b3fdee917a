use std::fmt::Debug;

/// A pixel of a disparity or depth image: `u8` without subpixels, `u16` else. 0 is no value.
pub trait Pixel:
    sealed::Sealed + Copy + Ord + Default + Debug + Send + Sync + Into<u16> + Into<i32> + Into<f32>
{
    /// What a value becomes in a comparison of speckles: OpenCV looks at 16-bit images as at signed ones.
    #[doc(hidden)]
    fn for_speckles(self) -> i32;

    /// The lower bits of a number.
    #[doc(hidden)]
    fn cut(value: i32) -> Self;
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for u8 {}
    impl Sealed for u16 {}
}

impl Pixel for u8 {
    #[inline(always)]
    fn for_speckles(self) -> i32 {
        i32::from(self)
    }

    #[inline(always)]
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "the lower bits are wanted"
    )]
    fn cut(value: i32) -> Self {
        value as Self
    }
}

impl Pixel for u16 {
    #[inline(always)]
    fn for_speckles(self) -> i32 {
        i32::from(self.cast_signed())
    }

    #[inline(always)]
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "the lower bits are wanted"
    )]
    fn cut(value: i32) -> Self {
        value as Self
    }
}
