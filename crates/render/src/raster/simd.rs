//! Eight numbers at a time, and the choice of instructions to do it with.
//!
//! Nothing is contracted or reordered, so that all of it gives the same bits as the plain arrays of [`Baseline`].

#![allow(unsafe_code)]

use super::draw::{self, Job};
use super::lanes::{Baseline, Lanes};
use super::small::Scratch;
use super::tile::Tile;

/// Instructions to use.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Level {
    /// What every processor of the target has.
    Baseline,
    #[cfg(target_arch = "x86_64")]
    Avx2,
    #[cfg(target_arch = "x86_64")]
    Avx512,
}

impl Level {
    /// The best that this processor has.
    pub(super) fn detect() -> Self {
        Self::available().last().copied().unwrap_or(Self::Baseline)
    }

    /// All that this processor has.
    pub(super) fn available() -> Vec<Self> {
        let mut levels = vec![Self::Baseline];
        #[cfg(target_arch = "x86_64")]
        {
            if std::arch::is_x86_feature_detected!("avx2") {
                levels.push(Self::Avx2);
                if std::arch::is_x86_feature_detected!("avx512f")
                    && std::arch::is_x86_feature_detected!("avx512bw")
                    && std::arch::is_x86_feature_detected!("avx512dq")
                    && std::arch::is_x86_feature_detected!("avx512vl")
                {
                    levels.push(Self::Avx512);
                }
            }
        }
        levels
    }
}

/// [`draw::draw`] and [`draw::resolve`] with the given instructions.
pub(super) fn draw<const IDS: bool>(
    level: Level,
    job: &Job,
    tile: &mut Tile,
    scratch: &mut Scratch,
    rows: &mut [&mut [f32]],
) {
    match level {
        Level::Baseline => with::<_, IDS>(Baseline, job, tile, scratch, rows),
        // SAFETY: this level exists only where `available` found the processor to have its features.
        #[cfg(target_arch = "x86_64")]
        Level::Avx2 => unsafe { avx2::<IDS>(job, tile, scratch, rows) },
        // SAFETY: as above.
        #[cfg(target_arch = "x86_64")]
        Level::Avx512 => unsafe { avx512::<IDS>(job, tile, scratch, rows) },
    }
}

#[inline(always)]
fn with<L: Lanes, const IDS: bool>(
    l: L,
    job: &Job,
    tile: &mut Tile,
    scratch: &mut Scratch,
    rows: &mut [&mut [f32]],
) {
    draw::draw::<L, IDS>(l, job, tile, scratch);
    draw::resolve(tile, rows);
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn avx2<const IDS: bool>(job: &Job, tile: &mut Tile, scratch: &mut Scratch, rows: &mut [&mut [f32]]) {
    with::<_, IDS>(Avx2, job, tile, scratch, rows);
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,avx512f,avx512bw,avx512dq,avx512vl")]
fn avx512<const IDS: bool>(job: &Job, tile: &mut Tile, scratch: &mut Scratch, rows: &mut [&mut [f32]]) {
    with::<_, IDS>(Avx512, job, tile, scratch, rows);
}

/// AVX2, with eight `f64` in two registers.
///
/// Only [`avx2`] makes one, so that whoever has it runs where AVX2 is.
#[cfg(target_arch = "x86_64")]
#[derive(Clone, Copy)]
struct Avx2;

/// AVX-512 for `f64`, AVX2 for the rest. Only [`avx512`] makes one.
#[cfg(target_arch = "x86_64")]
#[derive(Clone, Copy)]
struct Avx512;

#[cfg(target_arch = "x86_64")]
mod x86 {
    use std::arch::x86_64::*;

    use super::super::lanes::{Lanes, Row};
    use super::{Avx2, Avx512};

    type F = __m256;
    type I = __m256i;

    macro_rules! narrow_lanes {
        () => {
            type F = F;
            type I = I;

            #[inline(always)]
            fn splat_f(self, value: f32) -> F {
                // SAFETY: whoever made `self` has the features; pointers come from references.
                unsafe { _mm256_set1_ps(value) }
            }
            #[inline(always)]
            fn load_f(self, values: &[f32; 8]) -> F {
                // SAFETY: whoever made `self` has the features; pointers come from references.
                unsafe { _mm256_loadu_ps(values.as_ptr()) }
            }
            #[inline(always)]
            fn store_f(self, a: F) -> [f32; 8] {
                // SAFETY: whoever made `self` has the features; pointers come from references.
                unsafe {
                    {
                        let mut out = [0.0; 8];
                        _mm256_storeu_ps(out.as_mut_ptr(), a);
                        out
                    }
                }
            }
            #[inline(always)]
            fn float_i(self, a: I) -> F {
                // SAFETY: whoever made `self` has the features; pointers come from references.
                unsafe { _mm256_cvtepi32_ps(a) }
            }
            #[inline(always)]
            fn bits_f(self, a: F) -> I {
                // SAFETY: whoever made `self` has the features; pointers come from references.
                unsafe { _mm256_castps_si256(a) }
            }
            #[inline(always)]
            fn add_f(self, a: F, b: F) -> F {
                // SAFETY: whoever made `self` has the features; pointers come from references.
                unsafe { _mm256_add_ps(a, b) }
            }
            #[inline(always)]
            fn sub_f(self, a: F, b: F) -> F {
                // SAFETY: whoever made `self` has the features; pointers come from references.
                unsafe { _mm256_sub_ps(a, b) }
            }
            #[inline(always)]
            fn mul_f(self, a: F, b: F) -> F {
                // SAFETY: whoever made `self` has the features; pointers come from references.
                unsafe { _mm256_mul_ps(a, b) }
            }
            #[inline(always)]
            fn div_f(self, a: F, b: F) -> F {
                // SAFETY: whoever made `self` has the features; pointers come from references.
                unsafe { _mm256_div_ps(a, b) }
            }
            #[inline(always)]
            fn max_f(self, a: F, b: F) -> F {
                // SAFETY: whoever made `self` has the features; pointers come from references.
                unsafe { _mm256_max_ps(a, b) }
            }
            #[inline(always)]
            fn greater_f(self, a: F, b: F) -> I {
                // SAFETY: whoever made `self` has the features.
                unsafe { _mm256_castps_si256(_mm256_cmp_ps::<_CMP_GT_OQ>(a, b)) }
            }
            #[inline(always)]
            fn zero_where_negative(self, mask: I, a: F) -> F {
                // SAFETY: whoever made `self` has the features; pointers come from references.
                unsafe { _mm256_blendv_ps(a, _mm256_setzero_ps(), _mm256_castsi256_ps(mask)) }
            }
            #[inline(always)]
            fn splat_i(self, value: i32) -> I {
                // SAFETY: whoever made `self` has the features; pointers come from references.
                unsafe { _mm256_set1_epi32(value) }
            }
            #[inline(always)]
            fn load_i(self, values: &[i32; 8]) -> I {
                // SAFETY: whoever made `self` has the features; pointers come from references.
                unsafe { _mm256_loadu_si256(values.as_ptr().cast()) }
            }
            #[inline(always)]
            fn store_i(self, a: I) -> [i32; 8] {
                // SAFETY: whoever made `self` has the features; pointers come from references.
                unsafe {
                    {
                        let mut out = [0; 8];
                        _mm256_storeu_si256(out.as_mut_ptr().cast(), a);
                        out
                    }
                }
            }
            #[inline(always)]
            fn add_i(self, a: I, b: I) -> I {
                // SAFETY: whoever made `self` has the features; pointers come from references.
                unsafe { _mm256_add_epi32(a, b) }
            }
            #[inline(always)]
            fn sub_i(self, a: I, b: I) -> I {
                // SAFETY: whoever made `self` has the features; pointers come from references.
                unsafe { _mm256_sub_epi32(a, b) }
            }
            #[inline(always)]
            fn mul_i(self, a: I, b: I) -> I {
                // SAFETY: whoever made `self` has the features; pointers come from references.
                unsafe { _mm256_mullo_epi32(a, b) }
            }
            #[inline(always)]
            fn and_i(self, a: I, b: I) -> I {
                // SAFETY: whoever made `self` has the features; pointers come from references.
                unsafe { _mm256_and_si256(a, b) }
            }
            #[inline(always)]
            fn or_i(self, a: I, b: I) -> I {
                // SAFETY: whoever made `self` has the features; pointers come from references.
                unsafe { _mm256_or_si256(a, b) }
            }
            #[inline(always)]
            fn xor_i(self, a: I, b: I) -> I {
                // SAFETY: whoever made `self` has the features; pointers come from references.
                unsafe { _mm256_xor_si256(a, b) }
            }
            #[inline(always)]
            fn select_i(self, mask: I, a: I, b: I) -> I {
                // SAFETY: whoever made `self` has the features.
                unsafe {
                    let (mask, a, b) = (
                        _mm256_castsi256_ps(mask),
                        _mm256_castsi256_ps(a),
                        _mm256_castsi256_ps(b),
                    );
                    _mm256_castps_si256(_mm256_blendv_ps(b, a, mask))
                }
            }
            #[inline(always)]
            fn min_i(self, a: I, b: I) -> I {
                // SAFETY: whoever made `self` has the features; pointers come from references.
                unsafe { _mm256_min_epi32(a, b) }
            }
            #[inline(always)]
            fn max_i(self, a: I, b: I) -> I {
                // SAFETY: whoever made `self` has the features; pointers come from references.
                unsafe { _mm256_max_epi32(a, b) }
            }
            #[inline(always)]
            fn shl_i(self, a: I, bits: u32) -> I {
                // SAFETY: whoever made `self` has the features; pointers come from references.
                unsafe { _mm256_sll_epi32(a, _mm_cvtsi32_si128(bits.cast_signed())) }
            }
            #[inline(always)]
            fn shr_i(self, a: I, bits: u32) -> I {
                // SAFETY: whoever made `self` has the features; pointers come from references.
                unsafe { _mm256_sra_epi32(a, _mm_cvtsi32_si128(bits.cast_signed())) }
            }
            #[inline(always)]
            fn signs(self, a: I) -> u32 {
                // SAFETY: whoever made `self` has the features; pointers come from references.
                unsafe { _mm256_movemask_ps(_mm256_castsi256_ps(a)).cast_unsigned() }
            }
            #[inline(always)]
            fn prefetch<T>(self, values: &[T]) {
                // SAFETY: whoever made `self` has the features; a prefetch has no effect on any address.
                unsafe { _mm_prefetch::<_MM_HINT_T0>(values.as_ptr().cast()) }
            }

            #[inline(always)]
            fn columns(self, rows: [&Row; 8]) -> (I, I, F) {
                // SAFETY: whoever made `self` has the features; pointers come from references.
                unsafe {
                    {
                        macro_rules! pair {
                            ($l:literal) => {{
                                let low = _mm256_castsi128_si256(_mm_load_si128(rows[$l].0.as_ptr().cast()));
                                _mm256_inserti128_si256::<1>(
                                    low,
                                    _mm_load_si128(rows[$l + 4].0.as_ptr().cast()),
                                )
                            }};
                        }
                        let (r0, r1, r2, r3) = (pair!(0), pair!(1), pair!(2), pair!(3));
                        let (xy01, xy23) = (_mm256_unpacklo_epi32(r0, r1), _mm256_unpacklo_epi32(r2, r3));
                        let (z01, z23) = (_mm256_unpackhi_epi32(r0, r1), _mm256_unpackhi_epi32(r2, r3));
                        (
                            _mm256_unpacklo_epi64(xy01, xy23),
                            _mm256_unpackhi_epi64(xy01, xy23),
                            _mm256_castsi256_ps(_mm256_unpacklo_epi64(z01, z23)),
                        )
                    }
                }
            }
            #[inline(always)]
            fn store_rows(self, x: I, y: I, z: F, rows: &mut [Row; 8]) {
                // SAFETY: whoever made `self` has the features; pointers come from references.
                unsafe {
                    {
                        let (z, zero) = (_mm256_castps_si256(z), _mm256_setzero_si256());
                        let (xy_low, xy_high) = (_mm256_unpacklo_epi32(x, y), _mm256_unpackhi_epi32(x, y));
                        let (z_low, z_high) = (
                            _mm256_unpacklo_epi32(z, zero),
                            _mm256_unpackhi_epi32(z, zero),
                        );
                        let pairs = [
                            _mm256_unpacklo_epi64(xy_low, z_low),
                            _mm256_unpackhi_epi64(xy_low, z_low),
                            _mm256_unpacklo_epi64(xy_high, z_high),
                            _mm256_unpackhi_epi64(xy_high, z_high),
                        ];
                        for (l, pair) in pairs.into_iter().enumerate() {
                            _mm_store_si128(rows[l].0.as_mut_ptr().cast(), _mm256_castsi256_si128(pair));
                            _mm_store_si128(
                                rows[l + 4].0.as_mut_ptr().cast(),
                                _mm256_extracti128_si256::<1>(pair),
                            );
                        }
                    }
                }
            }
        };
    }

    impl Lanes for Avx2 {
        type D = (__m256d, __m256d);
        narrow_lanes!();

        #[inline(always)]
        fn splat_d(self, value: f64) -> Self::D {
            // SAFETY: whoever made `self` has the features; pointers come from references.
            unsafe { (_mm256_set1_pd(value), _mm256_set1_pd(value)) }
        }
        #[inline(always)]
        fn widen(self, values: &[f32; 8]) -> Self::D {
            // SAFETY: whoever made `self` has the features; pointers come from references.
            unsafe {
                {
                    let all = _mm256_loadu_ps(values.as_ptr());
                    (
                        _mm256_cvtps_pd(_mm256_castps256_ps128(all)),
                        _mm256_cvtps_pd(_mm256_extractf128_ps::<1>(all)),
                    )
                }
            }
        }
        #[inline(always)]
        fn widen_i(self, values: I) -> Self::D {
            // SAFETY: whoever made `self` has the features; pointers come from references.
            unsafe {
                (
                    _mm256_cvtepi32_pd(_mm256_castsi256_si128(values)),
                    _mm256_cvtepi32_pd(_mm256_extracti128_si256::<1>(values)),
                )
            }
        }
        #[inline(always)]
        fn add_d(self, a: Self::D, b: Self::D) -> Self::D {
            // SAFETY: whoever made `self` has the features; pointers come from references.
            unsafe { (_mm256_add_pd(a.0, b.0), _mm256_add_pd(a.1, b.1)) }
        }
        #[inline(always)]
        fn sub_d(self, a: Self::D, b: Self::D) -> Self::D {
            // SAFETY: whoever made `self` has the features; pointers come from references.
            unsafe { (_mm256_sub_pd(a.0, b.0), _mm256_sub_pd(a.1, b.1)) }
        }
        #[inline(always)]
        fn mul_d(self, a: Self::D, b: Self::D) -> Self::D {
            // SAFETY: whoever made `self` has the features; pointers come from references.
            unsafe { (_mm256_mul_pd(a.0, b.0), _mm256_mul_pd(a.1, b.1)) }
        }
        #[inline(always)]
        fn div_d(self, a: Self::D, b: Self::D) -> Self::D {
            // SAFETY: whoever made `self` has the features; pointers come from references.
            unsafe { (_mm256_div_pd(a.0, b.0), _mm256_div_pd(a.1, b.1)) }
        }
        #[inline(always)]
        fn round_d(self, a: Self::D) -> I {
            // SAFETY: whoever made `self` has the features; pointers come from references.
            unsafe { _mm256_set_m128i(_mm256_cvtpd_epi32(a.1), _mm256_cvtpd_epi32(a.0)) }
        }
        #[inline(always)]
        fn narrow(self, a: Self::D) -> F {
            // SAFETY: whoever made `self` has the features; pointers come from references.
            unsafe { _mm256_set_m128(_mm256_cvtpd_ps(a.1), _mm256_cvtpd_ps(a.0)) }
        }
    }

    impl Lanes for Avx512 {
        type D = __m512d;
        narrow_lanes!();

        #[inline(always)]
        fn splat_d(self, value: f64) -> Self::D {
            // SAFETY: whoever made `self` has the features; pointers come from references.
            unsafe { _mm512_set1_pd(value) }
        }
        #[inline(always)]
        fn widen(self, values: &[f32; 8]) -> Self::D {
            // SAFETY: whoever made `self` has the features; pointers come from references.
            unsafe { _mm512_cvtps_pd(_mm256_loadu_ps(values.as_ptr())) }
        }
        #[inline(always)]
        fn widen_i(self, values: I) -> Self::D {
            // SAFETY: whoever made `self` has the features; pointers come from references.
            unsafe { _mm512_cvtepi32_pd(values) }
        }
        #[inline(always)]
        fn add_d(self, a: Self::D, b: Self::D) -> Self::D {
            // SAFETY: whoever made `self` has the features; pointers come from references.
            unsafe { _mm512_add_pd(a, b) }
        }
        #[inline(always)]
        fn sub_d(self, a: Self::D, b: Self::D) -> Self::D {
            // SAFETY: whoever made `self` has the features; pointers come from references.
            unsafe { _mm512_sub_pd(a, b) }
        }
        #[inline(always)]
        fn mul_d(self, a: Self::D, b: Self::D) -> Self::D {
            // SAFETY: whoever made `self` has the features; pointers come from references.
            unsafe { _mm512_mul_pd(a, b) }
        }
        #[inline(always)]
        fn div_d(self, a: Self::D, b: Self::D) -> Self::D {
            // SAFETY: whoever made `self` has the features; pointers come from references.
            unsafe { _mm512_div_pd(a, b) }
        }
        #[inline(always)]
        fn round_d(self, a: Self::D) -> I {
            // SAFETY: whoever made `self` has the features; pointers come from references.
            unsafe { _mm512_cvtpd_epi32(a) }
        }
        #[inline(always)]
        fn narrow(self, a: Self::D) -> F {
            // SAFETY: whoever made `self` has the features; pointers come from references.
            unsafe { _mm512_cvtpd_ps(a) }
        }
    }
}
