use std::arch::aarch64::*;

use crate::F64Lanes;
use crate::scalar::ROUND;

/// Eight `f64` in four registers.
#[derive(Clone, Copy)]
pub(crate) struct F64([float64x2_t; 4]);

impl F64 {
    #[inline(always)]
    fn zip(self, other: Self, apply: impl Fn(float64x2_t, float64x2_t) -> float64x2_t) -> Self {
        let ([a, b, c, d], [e, f, g, h]) = (self.0, other.0);
        Self([apply(a, e), apply(b, f), apply(c, g), apply(d, h)])
    }

    #[inline(always)]
    pub(super) fn from_f32([low, high]: [float32x4_t; 2]) -> Self {
        intrinsic!(Self([
            vcvt_f64_f32(vget_low_f32(low)),
            vcvt_high_f64_f32(low),
            vcvt_f64_f32(vget_low_f32(high)),
            vcvt_high_f64_f32(high),
        ]))
    }

    #[inline(always)]
    pub(super) fn from_i32([low, high]: [int32x4_t; 2]) -> Self {
        let widened = intrinsic!([
            vmovl_s32(vget_low_s32(low)),
            vmovl_high_s32(low),
            vmovl_s32(vget_low_s32(high)),
            vmovl_high_s32(high),
        ]);
        Self(widened.map(|a| intrinsic!(vcvtq_f64_s64(a))))
    }

    #[inline(always)]
    pub(super) fn to_f32(self) -> [float32x4_t; 2] {
        let [a, b, c, d] = self.0;
        intrinsic!([
            vcvt_high_f32_f64(vcvt_f32_f64(a), b),
            vcvt_high_f32_f64(vcvt_f32_f64(c), d)
        ])
    }

    #[inline(always)]
    pub(super) fn round(self) -> [int32x4_t; 2] {
        let [a, b, c, d] = (self + Self::splat(ROUND)).0;
        // The even elements are the lower halves of the sums.
        let lower = |a, b| intrinsic!(vuzp1q_s32(vreinterpretq_s32_f64(a), vreinterpretq_s32_f64(b)));
        [lower(a, b), lower(c, d)]
    }
}

operators!(
    F64: Add::add = vaddq_f64,
    Sub::sub = vsubq_f64,
    Mul::mul = vmulq_f64,
    Div::div = vdivq_f64
);

impl F64Lanes for F64 {
    #[inline(always)]
    fn splat(value: f64) -> Self {
        Self([intrinsic!(vdupq_n_f64(value)); 4])
    }
    #[inline(always)]
    fn load(values: &[f64; 8]) -> Self {
        let values = values.as_ptr();
        intrinsic!(Self([
            vld1q_f64(values),
            vld1q_f64(values.add(2)),
            vld1q_f64(values.add(4)),
            vld1q_f64(values.add(6)),
        ]))
    }
    #[inline(always)]
    fn store(self, to: &mut [f64; 8]) {
        for (two, values) in to.chunks_exact_mut(2).zip(self.0) {
            intrinsic!(vst1q_f64(two.as_mut_ptr(), values));
        }
    }
}
