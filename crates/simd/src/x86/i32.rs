use std::arch::x86_64::*;

use crate::I32Lanes;

#[derive(Clone, Copy)]
pub(crate) struct I32(pub(super) __m256i);

impl I32 {
    #[inline(always)]
    fn new(values: __m256i) -> Self {
        Self(values)
    }
}

operator!([] I32, Add::add, _mm256_add_epi32);
operator!([] I32, Sub::sub, _mm256_sub_epi32);
operator!([] I32, Mul::mul, _mm256_mullo_epi32);
operator!([] I32, BitAnd::bitand, _mm256_and_si256);
operator!([] I32, BitOr::bitor, _mm256_or_si256);
operator!([] I32, BitXor::bitxor, _mm256_xor_si256);

impl I32Lanes for I32 {
    #[inline(always)]
    fn splat(value: i32) -> Self {
        Self(intrinsic!(_mm256_set1_epi32(value)))
    }
    #[inline(always)]
    fn load(values: &[i32; 8]) -> Self {
        Self(intrinsic!(_mm256_loadu_si256(values.as_ptr().cast())))
    }
    #[inline(always)]
    fn store(self, to: &mut [i32; 8]) {
        intrinsic!(_mm256_storeu_si256(to.as_mut_ptr().cast(), self.0));
    }
    #[inline(always)]
    fn load_unsigned(values: &[u32; 8]) -> Self {
        Self(intrinsic!(_mm256_loadu_si256(values.as_ptr().cast())))
    }
    #[inline(always)]
    fn store_unsigned(self, to: &mut [u32; 8]) {
        intrinsic!(_mm256_storeu_si256(to.as_mut_ptr().cast(), self.0));
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        Self(intrinsic!(_mm256_min_epi32(self.0, other.0)))
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        Self(intrinsic!(_mm256_max_epi32(self.0, other.0)))
    }
    #[inline(always)]
    fn shift_left(self, bits: u32) -> Self {
        Self(intrinsic!(_mm256_sll_epi32(
            self.0,
            _mm_cvtsi32_si128(bits.cast_signed())
        )))
    }
    #[inline(always)]
    fn shift_right(self, bits: u32) -> Self {
        Self(intrinsic!(_mm256_sra_epi32(
            self.0,
            _mm_cvtsi32_si128(bits.cast_signed())
        )))
    }
    #[inline(always)]
    fn select(mask: Self, then: Self, otherwise: Self) -> Self {
        Self(intrinsic!(_mm256_castps_si256(_mm256_blendv_ps(
            _mm256_castsi256_ps(otherwise.0),
            _mm256_castsi256_ps(then.0),
            _mm256_castsi256_ps(mask.0),
        ))))
    }
    #[inline(always)]
    fn signs(self) -> u32 {
        intrinsic!(_mm256_movemask_ps(_mm256_castsi256_ps(self.0))).cast_unsigned()
    }
}
