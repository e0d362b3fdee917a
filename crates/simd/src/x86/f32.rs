use std::arch::x86_64::*;
use std::marker::PhantomData;

use super::f64::Wide;
use super::i32::I32;
use crate::{Lanes, PackedVertex};

/// Eight `f32` in a register of AVX2, with `f64` as `W`.
#[derive(Clone, Copy)]
pub(crate) struct F32<W>(__m256, PhantomData<W>);

impl<W: Wide> F32<W> {
    #[inline(always)]
    fn new(values: __m256) -> Self {
        Self(values, PhantomData)
    }
}

operator!([W: Wide] F32<W>, Add::add, _mm256_add_ps);
operator!([W: Wide] F32<W>, Sub::sub, _mm256_sub_ps);
operator!([W: Wide] F32<W>, Mul::mul, _mm256_mul_ps);
operator!([W: Wide] F32<W>, Div::div, _mm256_div_ps);

impl<W: Wide> Lanes for F32<W> {
    type I32 = I32;
    type F64 = W;

    #[inline(always)]
    fn splat(value: f32) -> Self {
        Self::new(intrinsic!(_mm256_set1_ps(value)))
    }
    #[inline(always)]
    fn load(values: &[f32; 8]) -> Self {
        Self::new(intrinsic!(_mm256_loadu_ps(values.as_ptr())))
    }
    #[inline(always)]
    fn store(self, to: &mut [f32; 8]) {
        intrinsic!(_mm256_storeu_ps(to.as_mut_ptr(), self.0));
    }
    #[inline(always)]
    fn from_bits(bits: I32) -> Self {
        Self::new(intrinsic!(_mm256_castsi256_ps(bits.0)))
    }
    #[inline(always)]
    fn to_bits(self) -> I32 {
        I32(intrinsic!(_mm256_castps_si256(self.0)))
    }
    #[inline(always)]
    fn from_i32(values: I32) -> Self {
        Self::new(intrinsic!(_mm256_cvtepi32_ps(values.0)))
    }
    #[inline(always)]
    fn trunc(self) -> I32 {
        I32(intrinsic!(_mm256_cvttps_epi32(self.0)))
    }

    #[inline(always)]
    fn widen(self) -> W {
        W::from_f32(self.0)
    }
    #[inline(always)]
    fn widen_i32(values: I32) -> W {
        W::from_i32(values.0)
    }
    #[inline(always)]
    fn narrow(values: W) -> Self {
        Self::new(values.to_f32())
    }
    #[inline(always)]
    fn round(values: W) -> I32 {
        I32(values.round())
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        Self::new(intrinsic!(_mm256_sqrt_ps(self.0)))
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        Self::new(intrinsic!(_mm256_min_ps(self.0, other.0)))
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        Self::new(intrinsic!(_mm256_max_ps(self.0, other.0)))
    }
    #[inline(always)]
    fn le(self, other: Self) -> I32 {
        I32(intrinsic!(_mm256_castps_si256(_mm256_cmp_ps::<_CMP_LE_OQ>(
            self.0, other.0
        ))))
    }
    #[inline(always)]
    fn lt(self, other: Self) -> I32 {
        I32(intrinsic!(_mm256_castps_si256(_mm256_cmp_ps::<_CMP_LT_OQ>(
            self.0, other.0
        ))))
    }
    #[inline(always)]
    fn select(mask: I32, then: Self, otherwise: Self) -> Self {
        Self::new(intrinsic!(_mm256_blendv_ps(
            otherwise.0,
            then.0,
            _mm256_castsi256_ps(mask.0)
        )))
    }
    #[inline(always)]
    fn reduce_min(self) -> f32 {
        intrinsic!({
            let four = _mm_min_ps(_mm256_castps256_ps128(self.0), _mm256_extractf128_ps::<1>(self.0));
            let two = _mm_min_ps(four, _mm_movehl_ps(four, four));
            _mm_cvtss_f32(_mm_min_ss(two, _mm_movehdup_ps(two)))
        })
    }
    #[inline(always)]
    fn ranks(self) -> [u32; 8] {
        let mut ranks = [0; 8];
        intrinsic!({
            let mut sum = _mm256_setzero_si256();
            for lane in 0..8 {
                let other = _mm256_permutevar8x32_ps(self.0, _mm256_set1_epi32(lane));
                let is_not_greater = _mm256_cmp_ps::<_CMP_LE_OQ>(other, self.0);
                sum = _mm256_sub_epi32(sum, _mm256_castps_si256(is_not_greater));
            }
            _mm256_storeu_si256(ranks.as_mut_ptr().cast(), sum);
        });
        ranks
    }

    #[inline(always)]
    fn gather(points: &[[f32; 3]], [a, b, c, d, e, f, g, h]: [u32; 8]) -> [Self; 3] {
        let (x, y, z) = columns(
            join(point(points, a), point(points, e)),
            join(point(points, b), point(points, f)),
            join(point(points, c), point(points, g)),
            join(point(points, d), point(points, h)),
        );
        intrinsic!([
            _mm256_castsi256_ps(x),
            _mm256_castsi256_ps(y),
            _mm256_castsi256_ps(z)
        ])
        .map(Self::new)
    }
    #[inline(always)]
    fn load_rows([a, b, c, d, e, f, g, h]: [&PackedVertex; 8]) -> (I32, I32, Self) {
        let (x, y, z) = columns(
            join(load(a), load(e)),
            join(load(b), load(f)),
            join(load(c), load(g)),
            join(load(d), load(h)),
        );
        (I32(x), I32(y), Self::from_bits(I32(z)))
    }
    #[inline(always)]
    fn store_rows(I32(x): I32, I32(y): I32, z: Self, rows: &mut [PackedVertex; 8]) {
        let I32(z) = z.to_bits();
        intrinsic!({
            let zero = _mm256_setzero_si256();
            let (xy_low, xy_high) = (_mm256_unpacklo_epi32(x, y), _mm256_unpackhi_epi32(x, y));
            let (z_low, z_high) = (_mm256_unpacklo_epi32(z, zero), _mm256_unpackhi_epi32(z, zero));
            let pairs = [
                _mm256_unpacklo_epi64(xy_low, z_low),
                _mm256_unpackhi_epi64(xy_low, z_low),
                _mm256_unpacklo_epi64(xy_high, z_high),
                _mm256_unpackhi_epi64(xy_high, z_high),
            ];
            for (lane, pair) in pairs.into_iter().enumerate() {
                _mm_storeu_si128(rows[lane].0.as_mut_ptr().cast(), _mm256_castsi256_si128(pair));
                _mm_storeu_si128(
                    rows[lane + 4].0.as_mut_ptr().cast(),
                    _mm256_extracti128_si256::<1>(pair),
                );
            }
        });
    }
    #[inline(always)]
    fn prefetch<T: ?Sized>(place: &T) {
        // A prefetch reads nothing.
        intrinsic!(_mm_prefetch::<_MM_HINT_T0>(std::ptr::from_ref(place).cast()));
    }
}

/// Loads three coordinates and an arbitrary fourth value.
#[inline(always)]
fn point(points: &[[f32; 3]], index: u32) -> __m128i {
    let index = index as usize;
    if index + 1 < points.len() {
        // Another point follows, so sixteen bytes lie within the slice.
        intrinsic!(_mm_loadu_si128(points.as_ptr().add(index).cast()))
    } else {
        let [x, y, z] = points[index];
        intrinsic!(_mm_castps_si128(_mm_setr_ps(x, y, z, 0.0)))
    }
}

#[inline(always)]
fn load(row: &PackedVertex) -> __m128i {
    intrinsic!(_mm_loadu_si128(row.0.as_ptr().cast()))
}

#[inline(always)]
fn join(low: __m128i, high: __m128i) -> __m256i {
    intrinsic!(_mm256_set_m128i(high, low))
}

/// The first three columns of rows 0 and 4, 1 and 5, 2 and 6, 3 and 7.
#[inline(always)]
fn columns(r0: __m256i, r1: __m256i, r2: __m256i, r3: __m256i) -> (__m256i, __m256i, __m256i) {
    intrinsic!({
        let (xy01, xy23) = (_mm256_unpacklo_epi32(r0, r1), _mm256_unpacklo_epi32(r2, r3));
        let (z01, z23) = (_mm256_unpackhi_epi32(r0, r1), _mm256_unpackhi_epi32(r2, r3));
        (
            _mm256_unpacklo_epi64(xy01, xy23),
            _mm256_unpackhi_epi64(xy01, xy23),
            _mm256_unpacklo_epi64(z01, z23),
        )
    })
}
