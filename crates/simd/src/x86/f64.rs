use std::arch::x86_64::*;

use crate::F64Lanes;

/// Eight `f64` and their conversions from and to eight `f32` and `i32`.
pub(crate) trait Wide: F64Lanes {
    fn from_f32(values: __m256) -> Self;
    fn from_i32(values: __m256i) -> Self;
    fn to_f32(self) -> __m256;
    fn round(self) -> __m256i;
}

/// Two registers of AVX2.
#[derive(Clone, Copy)]
pub(crate) struct RegisterPair(__m256d, __m256d);

/// One register of AVX-512.
#[derive(Clone, Copy)]
pub(crate) struct Double(__m512d);

impl Double {
    #[inline(always)]
    fn new(values: __m512d) -> Self {
        Self(values)
    }
}

operator!([] Double, Add::add, _mm512_add_pd);
operator!([] Double, Sub::sub, _mm512_sub_pd);
operator!([] Double, Mul::mul, _mm512_mul_pd);
operator!([] Double, Div::div, _mm512_div_pd);

macro_rules! pair_operators {
    ($($operator:ident::$method:ident = $intrinsic:ident),*) => {$(
        impl std::ops::$operator for RegisterPair {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                intrinsic!(Self($intrinsic(self.0, other.0), $intrinsic(self.1, other.1)))
            }
        }
    )*};
}

pair_operators!(
    Add::add = _mm256_add_pd,
    Sub::sub = _mm256_sub_pd,
    Mul::mul = _mm256_mul_pd,
    Div::div = _mm256_div_pd
);

impl F64Lanes for RegisterPair {
    #[inline(always)]
    fn splat(value: f64) -> Self {
        intrinsic!(Self(_mm256_set1_pd(value), _mm256_set1_pd(value)))
    }
    #[inline(always)]
    fn load(values: &[f64; 8]) -> Self {
        let (low, high) = values.split_at(4);
        intrinsic!(Self(
            _mm256_loadu_pd(low.as_ptr()),
            _mm256_loadu_pd(high.as_ptr())
        ))
    }
    #[inline(always)]
    fn store(self, to: &mut [f64; 8]) {
        let (low, high) = to.split_at_mut(4);
        intrinsic!({
            _mm256_storeu_pd(low.as_mut_ptr(), self.0);
            _mm256_storeu_pd(high.as_mut_ptr(), self.1);
        });
    }
}

impl Wide for RegisterPair {
    #[inline(always)]
    fn from_f32(values: __m256) -> Self {
        intrinsic!(Self(
            _mm256_cvtps_pd(_mm256_castps256_ps128(values)),
            _mm256_cvtps_pd(_mm256_extractf128_ps::<1>(values)),
        ))
    }
    #[inline(always)]
    fn from_i32(values: __m256i) -> Self {
        intrinsic!(Self(
            _mm256_cvtepi32_pd(_mm256_castsi256_si128(values)),
            _mm256_cvtepi32_pd(_mm256_extracti128_si256::<1>(values)),
        ))
    }
    #[inline(always)]
    fn to_f32(self) -> __m256 {
        intrinsic!(_mm256_set_m128(_mm256_cvtpd_ps(self.1), _mm256_cvtpd_ps(self.0)))
    }
    #[inline(always)]
    fn round(self) -> __m256i {
        intrinsic!(_mm256_set_m128i(
            _mm256_cvtpd_epi32(self.1),
            _mm256_cvtpd_epi32(self.0)
        ))
    }
}

impl F64Lanes for Double {
    #[inline(always)]
    fn splat(value: f64) -> Self {
        Self(intrinsic!(_mm512_set1_pd(value)))
    }
    #[inline(always)]
    fn load(values: &[f64; 8]) -> Self {
        Self(intrinsic!(_mm512_loadu_pd(values.as_ptr())))
    }
    #[inline(always)]
    fn store(self, to: &mut [f64; 8]) {
        intrinsic!(_mm512_storeu_pd(to.as_mut_ptr(), self.0));
    }
}

impl Wide for Double {
    #[inline(always)]
    fn from_f32(values: __m256) -> Self {
        Self(intrinsic!(_mm512_cvtps_pd(values)))
    }
    #[inline(always)]
    fn from_i32(values: __m256i) -> Self {
        Self(intrinsic!(_mm512_cvtepi32_pd(values)))
    }
    #[inline(always)]
    fn to_f32(self) -> __m256 {
        intrinsic!(_mm512_cvtpd_ps(self.0))
    }
    #[inline(always)]
    fn round(self) -> __m256i {
        intrinsic!(_mm512_cvtpd_epi32(self.0))
    }
}
