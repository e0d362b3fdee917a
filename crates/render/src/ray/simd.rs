//! Eight single-precision numbers at once, and the same eight one after another.
//!
//! Every operation is rounded by itself (nothing is fused), so both give the same bits.
#![allow(unsafe_code, reason = "AVX2 is asked for at run time")]

/// Eight `f64`.
pub(crate) trait Wide: Copy {
    fn load(values: &[f64; 8]) -> Self;
    fn store(self, to: &mut [f64; 8]);
    fn splat(value: f64) -> Self;
    fn add(self, other: Self) -> Self;
    fn sub(self, other: Self) -> Self;
    fn mul(self, other: Self) -> Self;
    fn div(self, other: Self) -> Self;
}

/// Eight `f32`. A comparison gives all ones or all zeros in each lane.
pub(crate) trait Lanes: Copy {
    type Wide: Wide;
    /// The same numbers.
    fn widen(self) -> Self::Wide;
    fn load(values: &[f32; 8]) -> Self;
    fn store(self, to: &mut [f32; 8]);
    fn load_bits(values: &[u32; 8]) -> Self;
    fn store_bits(self, to: &mut [u32; 8]);
    fn splat(value: f32) -> Self;
    fn add(self, other: Self) -> Self;
    fn sub(self, other: Self) -> Self;
    fn mul(self, other: Self) -> Self;
    fn div(self, other: Self) -> Self;
    fn sqrt(self) -> Self;
    /// The lesser; `other` where either is NaN.
    fn min(self, other: Self) -> Self;
    /// The greater; `other` where either is NaN.
    fn max(self, other: Self) -> Self;
    fn le(self, other: Self) -> Self;
    fn lt(self, other: Self) -> Self;
    fn and(self, other: Self) -> Self;
    fn xor(self, other: Self) -> Self;
    /// `then` where the lane is all ones, else `otherwise`.
    fn select(self, then: Self, otherwise: Self) -> Self;
    /// The sign bits, lane 0 lowest.
    fn signs(self) -> u32;
    /// The least of all lanes, none of which is NaN.
    fn least(self) -> f32;
    /// For each lane, how many lanes are not greater, itself included; 0 where it is NaN.
    fn ranks(self) -> [u32; 8];
    /// Says that a place will be read soon.
    #[inline(always)]
    fn prefetch<T>(_place: &T) {}
    /// The coordinates of eight points.
    fn gather(points: &[[f32; 3]], at: [u32; 8]) -> [Self; 3];

    #[inline(always)]
    fn values(self) -> [f32; 8] {
        let mut values = [0.0; 8];
        self.store(&mut values);
        values
    }
}

/// Work that is written for any [`Lanes`].
pub(crate) trait Kernel {
    type Output;
    /// Must be `#[inline(always)]`, and so must all that it calls with `L`: only then is it compiled for the
    /// instructions that `L` stands for.
    fn run<L: Lanes>(self) -> Self::Output;
}

/// The instructions to use.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Instructions {
    /// Those that every processor has.
    Baseline,
    #[cfg(target_arch = "x86_64")]
    Avx2(Avx2Token),
}

/// Exists only where the processor has AVX2.
#[cfg(target_arch = "x86_64")]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Avx2Token(());

impl Instructions {
    /// The best that this processor has.
    pub(crate) fn detect() -> Self {
        #[cfg(target_arch = "x86_64")]
        if std::arch::is_x86_feature_detected!("avx2") {
            return Self::Avx2(Avx2Token(()));
        }
        Self::Baseline
    }

    #[inline]
    pub(crate) fn run<K: Kernel>(self, kernel: K) -> K::Output {
        match self {
            Self::Baseline => kernel.run::<Scalar>(),
            #[cfg(target_arch = "x86_64")]
            Self::Avx2(_) => {
                // SAFETY: the token says that the processor has AVX2.
                unsafe { avx2::run(kernel) }
            }
        }
    }
}

#[derive(Clone, Copy)]
struct Scalar([f32; 8]);

impl Scalar {
    #[inline(always)]
    fn zip(self, other: Self, f: impl Fn(f32, f32) -> f32) -> Self {
        Self(std::array::from_fn(|i| f(self.0[i], other.0[i])))
    }

    #[inline(always)]
    fn compare(self, other: Self, f: impl Fn(f32, f32) -> bool) -> Self {
        self.zip(other, |a, b| f32::from_bits(if f(a, b) { u32::MAX } else { 0 }))
    }
}

#[derive(Clone, Copy)]
struct WideScalar([f64; 8]);

impl Wide for WideScalar {
    #[inline(always)]
    fn load(values: &[f64; 8]) -> Self {
        Self(*values)
    }
    #[inline(always)]
    fn store(self, to: &mut [f64; 8]) {
        *to = self.0;
    }
    #[inline(always)]
    fn splat(value: f64) -> Self {
        Self([value; 8])
    }
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self(std::array::from_fn(|i| self.0[i] + other.0[i]))
    }
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self(std::array::from_fn(|i| self.0[i] - other.0[i]))
    }
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self(std::array::from_fn(|i| self.0[i] * other.0[i]))
    }
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        Self(std::array::from_fn(|i| self.0[i] / other.0[i]))
    }
}

impl Lanes for Scalar {
    type Wide = WideScalar;
    #[inline(always)]
    fn widen(self) -> WideScalar {
        WideScalar(self.0.map(f64::from))
    }
    #[inline(always)]
    fn load(values: &[f32; 8]) -> Self {
        Self(*values)
    }
    #[inline(always)]
    fn store(self, to: &mut [f32; 8]) {
        *to = self.0;
    }
    #[inline(always)]
    fn load_bits(values: &[u32; 8]) -> Self {
        Self(values.map(f32::from_bits))
    }
    #[inline(always)]
    fn store_bits(self, to: &mut [u32; 8]) {
        *to = self.0.map(f32::to_bits);
    }
    #[inline(always)]
    fn splat(value: f32) -> Self {
        Self([value; 8])
    }
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.zip(other, |a, b| a + b)
    }
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.zip(other, |a, b| a - b)
    }
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        self.zip(other, |a, b| a * b)
    }
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        self.zip(other, |a, b| a / b)
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(self.0.map(f32::sqrt))
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        self.zip(other, |a, b| if a < b { a } else { b })
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        self.zip(other, |a, b| if a > b { a } else { b })
    }
    #[inline(always)]
    fn le(self, other: Self) -> Self {
        self.compare(other, |a, b| a <= b)
    }
    #[inline(always)]
    fn lt(self, other: Self) -> Self {
        self.compare(other, |a, b| a < b)
    }
    #[inline(always)]
    fn and(self, other: Self) -> Self {
        self.zip(other, |a, b| f32::from_bits(a.to_bits() & b.to_bits()))
    }
    #[inline(always)]
    fn xor(self, other: Self) -> Self {
        self.zip(other, |a, b| f32::from_bits(a.to_bits() ^ b.to_bits()))
    }
    #[inline(always)]
    fn select(self, then: Self, otherwise: Self) -> Self {
        Self(std::array::from_fn(|i| {
            if self.0[i].is_sign_negative() {
                then.0[i]
            } else {
                otherwise.0[i]
            }
        }))
    }
    #[inline(always)]
    fn signs(self) -> u32 {
        (0..8).fold(0, |bits, i| bits | (self.0[i].to_bits() >> 31) << i)
    }
    #[inline(always)]
    fn least(self) -> f32 {
        self.0
            .into_iter()
            .fold(f32::INFINITY, |a, b| if b < a { b } else { a })
    }
    #[inline(always)]
    fn ranks(self) -> [u32; 8] {
        std::array::from_fn(|i| self.0.iter().map(|x| u32::from(*x <= self.0[i])).sum())
    }
    #[inline(always)]
    fn gather(points: &[[f32; 3]], at: [u32; 8]) -> [Self; 3] {
        let points = at.map(|index| points[index as usize]);
        std::array::from_fn(|axis| Self(std::array::from_fn(|lane| points[lane][axis])))
    }
}

#[cfg(target_arch = "x86_64")]
mod avx2 {
    #[allow(clippy::wildcard_imports, reason = "intrinsics")]
    use std::arch::x86_64::*;

    use super::{Kernel, Lanes, Wide};

    /// Is made only within [`run`], so the processor has AVX2.
    #[derive(Clone, Copy)]
    pub(super) struct Avx2(__m256);

    /// As [`Avx2`].
    #[derive(Clone, Copy)]
    pub(super) struct WideAvx2(__m256d, __m256d);

    /// # Safety
    /// The processor has AVX2.
    #[target_feature(enable = "avx2")]
    pub(super) unsafe fn run<K: Kernel>(kernel: K) -> K::Output {
        kernel.run::<Avx2>()
    }

    // SAFETY of all below: the processor has AVX2 (see `Avx2`); loads and stores are of whole arrays, unaligned.
    /// Three coordinates and anything; inlined only where there is AVX2.
    #[inline(always)]
    fn point(points: &[[f32; 3]], index: u32) -> __m128 {
        let index = index as usize;
        if index + 1 < points.len() {
            // SAFETY: another point follows, so sixteen bytes are inside the slice.
            unsafe { _mm_loadu_ps(points.as_ptr().add(index).cast()) }
        } else {
            let [x, y, z] = points[index];
            // SAFETY: part of the instructions that every x86-64 has.
            unsafe { _mm_setr_ps(x, y, z, 0.0) }
        }
    }

    impl Wide for WideAvx2 {
        #[inline(always)]
        fn load(values: &[f64; 8]) -> Self {
            let (low, high) = values.split_at(4);
            Self(unsafe { _mm256_loadu_pd(low.as_ptr()) }, unsafe {
                _mm256_loadu_pd(high.as_ptr())
            })
        }
        #[inline(always)]
        fn store(self, to: &mut [f64; 8]) {
            let (low, high) = to.split_at_mut(4);
            unsafe {
                _mm256_storeu_pd(low.as_mut_ptr(), self.0);
                _mm256_storeu_pd(high.as_mut_ptr(), self.1);
            }
        }
        #[inline(always)]
        fn splat(value: f64) -> Self {
            let all = unsafe { _mm256_set1_pd(value) };
            Self(all, all)
        }
        #[inline(always)]
        fn add(self, other: Self) -> Self {
            unsafe { Self(_mm256_add_pd(self.0, other.0), _mm256_add_pd(self.1, other.1)) }
        }
        #[inline(always)]
        fn sub(self, other: Self) -> Self {
            unsafe { Self(_mm256_sub_pd(self.0, other.0), _mm256_sub_pd(self.1, other.1)) }
        }
        #[inline(always)]
        fn mul(self, other: Self) -> Self {
            unsafe { Self(_mm256_mul_pd(self.0, other.0), _mm256_mul_pd(self.1, other.1)) }
        }
        #[inline(always)]
        fn div(self, other: Self) -> Self {
            unsafe { Self(_mm256_div_pd(self.0, other.0), _mm256_div_pd(self.1, other.1)) }
        }
    }

    impl Lanes for Avx2 {
        type Wide = WideAvx2;
        #[inline(always)]
        fn widen(self) -> WideAvx2 {
            unsafe {
                WideAvx2(
                    _mm256_cvtps_pd(_mm256_castps256_ps128(self.0)),
                    _mm256_cvtps_pd(_mm256_extractf128_ps::<1>(self.0)),
                )
            }
        }
        #[inline(always)]
        fn load(values: &[f32; 8]) -> Self {
            Self(unsafe { _mm256_loadu_ps(values.as_ptr()) })
        }
        #[inline(always)]
        fn store(self, to: &mut [f32; 8]) {
            unsafe { _mm256_storeu_ps(to.as_mut_ptr(), self.0) }
        }
        #[inline(always)]
        fn load_bits(values: &[u32; 8]) -> Self {
            Self(unsafe { _mm256_loadu_ps(values.as_ptr().cast()) })
        }
        #[inline(always)]
        fn store_bits(self, to: &mut [u32; 8]) {
            unsafe { _mm256_storeu_ps(to.as_mut_ptr().cast(), self.0) }
        }
        #[inline(always)]
        fn splat(value: f32) -> Self {
            Self(unsafe { _mm256_set1_ps(value) })
        }
        #[inline(always)]
        fn add(self, other: Self) -> Self {
            Self(unsafe { _mm256_add_ps(self.0, other.0) })
        }
        #[inline(always)]
        fn sub(self, other: Self) -> Self {
            Self(unsafe { _mm256_sub_ps(self.0, other.0) })
        }
        #[inline(always)]
        fn mul(self, other: Self) -> Self {
            Self(unsafe { _mm256_mul_ps(self.0, other.0) })
        }
        #[inline(always)]
        fn div(self, other: Self) -> Self {
            Self(unsafe { _mm256_div_ps(self.0, other.0) })
        }
        #[inline(always)]
        fn sqrt(self) -> Self {
            Self(unsafe { _mm256_sqrt_ps(self.0) })
        }
        #[inline(always)]
        fn min(self, other: Self) -> Self {
            Self(unsafe { _mm256_min_ps(self.0, other.0) })
        }
        #[inline(always)]
        fn max(self, other: Self) -> Self {
            Self(unsafe { _mm256_max_ps(self.0, other.0) })
        }
        #[inline(always)]
        fn le(self, other: Self) -> Self {
            Self(unsafe { _mm256_cmp_ps::<_CMP_LE_OQ>(self.0, other.0) })
        }
        #[inline(always)]
        fn lt(self, other: Self) -> Self {
            Self(unsafe { _mm256_cmp_ps::<_CMP_LT_OQ>(self.0, other.0) })
        }
        #[inline(always)]
        fn and(self, other: Self) -> Self {
            Self(unsafe { _mm256_and_ps(self.0, other.0) })
        }
        #[inline(always)]
        fn xor(self, other: Self) -> Self {
            Self(unsafe { _mm256_xor_ps(self.0, other.0) })
        }
        #[inline(always)]
        fn select(self, then: Self, otherwise: Self) -> Self {
            Self(unsafe { _mm256_blendv_ps(otherwise.0, then.0, self.0) })
        }
        #[inline(always)]
        fn signs(self) -> u32 {
            unsafe { _mm256_movemask_ps(self.0) }.cast_unsigned()
        }
        #[inline(always)]
        fn least(self) -> f32 {
            unsafe {
                let four = _mm_min_ps(_mm256_castps256_ps128(self.0), _mm256_extractf128_ps::<1>(self.0));
                let two = _mm_min_ps(four, _mm_movehl_ps(four, four));
                _mm_cvtss_f32(_mm_min_ss(two, _mm_movehdup_ps(two)))
            }
        }
        #[inline(always)]
        fn prefetch<T>(place: &T) {
            // A hint: nothing is read.
            unsafe { _mm_prefetch::<_MM_HINT_T0>(std::ptr::from_ref(place).cast()) }
        }
        #[inline(always)]
        fn ranks(self) -> [u32; 8] {
            let mut ranks = [0; 8];
            unsafe {
                let mut sum = _mm256_setzero_si256();
                for lane in 0..8 {
                    let other = _mm256_permutevar8x32_ps(self.0, _mm256_set1_epi32(lane));
                    let is_not_greater = _mm256_cmp_ps::<_CMP_LE_OQ>(other, self.0);
                    sum = _mm256_sub_epi32(sum, _mm256_castps_si256(is_not_greater));
                }
                _mm256_storeu_si256(ranks.as_mut_ptr().cast(), sum);
            }
            ranks
        }
        #[inline(always)]
        fn gather(points: &[[f32; 3]], at: [u32; 8]) -> [Self; 3] {
            let [a, b, c, d, e, f, g, h] = at;
            let (a, b) = (point(points, a), point(points, b));
            let (c, d) = (point(points, c), point(points, d));
            let (e, f) = (point(points, e), point(points, f));
            let (g, h) = (point(points, g), point(points, h));
            unsafe {
                let (ae, bf) = (_mm256_set_m128(e, a), _mm256_set_m128(f, b));
                let (cg, dh) = (_mm256_set_m128(g, c), _mm256_set_m128(h, d));
                let (xy_ab, z_ab) = (_mm256_unpacklo_ps(ae, bf), _mm256_unpackhi_ps(ae, bf));
                let (xy_cd, z_cd) = (_mm256_unpacklo_ps(cg, dh), _mm256_unpackhi_ps(cg, dh));
                [
                    Self(_mm256_shuffle_ps::<0b01_00_01_00>(xy_ab, xy_cd)),
                    Self(_mm256_shuffle_ps::<0b11_10_11_10>(xy_ab, xy_cd)),
                    Self(_mm256_shuffle_ps::<0b01_00_01_00>(z_ab, z_cd)),
                ]
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// Every operation on one pair of vectors, as bits.
    struct Everything([f32; 8], [f32; 8]);

    impl Kernel for Everything {
        type Output = Vec<u32>;

        #[inline(always)]
        #[allow(clippy::cast_possible_truncation, reason = "halves")]
        fn run<L: Lanes>(self) -> Vec<u32> {
            let (a, b) = (L::load(&self.0), L::load(&self.1));
            let all = [
                a.add(b),
                a.sub(b),
                a.mul(b),
                a.div(b),
                a.sqrt(),
                a.min(b),
                a.max(b),
                a.le(b),
                a.lt(b),
                a.and(b),
                a.xor(b),
                a.le(b).select(a, b),
                L::splat(self.0[3]),
            ];
            let mut bits: Vec<u32> = all
                .iter()
                .flat_map(|v| v.values())
                // Which NaN comes out is nobody's business.
                .map(|x| if x.is_nan() { f32::NAN } else { x }.to_bits())
                .collect();
            bits.push(a.signs());
            let (c, d) = (a.widen(), b.widen());
            for wide in [c.add(d), c.sub(d), c.mul(d), c.div(d), L::Wide::splat(0.1).mul(c)] {
                let mut values = [0.0; 8];
                wide.store(&mut values);
                L::Wide::load(&values).mul(d).store(&mut values);
                for value in values.map(|x| if x.is_nan() { f64::NAN } else { x }.to_bits()) {
                    bits.extend([(value >> 32) as u32, value as u32]);
                }
            }
            let mut raw = [0; 8];
            L::load_bits(&self.0.map(f32::to_bits)).store_bits(&mut raw);
            bits.extend(raw);
            // No NaN, and only one zero.
            let ordered = a.le(b).select(L::splat(-1.0), L::splat(2.0));
            bits.push(ordered.least().to_bits());
            bits.extend(a.ranks());
            let points = [[self.0[0], self.1[0], 0.5], [self.0[1], self.1[1], 1.5], [2.5; 3]];
            for axis in L::gather(&points, [0, 1, 2, 0, 2, 1, 1, 2]) {
                axis.store_bits(&mut raw);
                bits.extend(raw);
            }
            bits.push(
                L::load(&self.0.map(|x| if x.is_nan() { 1.0 } else { x + 0.0 }))
                    .least()
                    .to_bits(),
            );
            bits
        }
    }

    fn number() -> impl Strategy<Value = f32> {
        prop_oneof![
            any::<f32>(),
            -1e3f32..1e3,
            Just(0.0),
            Just(-0.0),
            Just(f32::INFINITY),
            Just(f32::NAN)
        ]
    }

    proptest! {
        #[test]
        fn every_instruction_set_gives_the_same_bits(
            a in prop::array::uniform8(number()), b in prop::array::uniform8(number())
        ) {
            let best = Instructions::detect().run(Everything(a, b));
            prop_assert_eq!(best, Instructions::Baseline.run(Everything(a, b)));
        }
    }
}
