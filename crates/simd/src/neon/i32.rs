use std::arch::aarch64::*;

use crate::I32Lanes;

/// Eight `i32` in two registers.
#[derive(Clone, Copy)]
pub(crate) struct I32(pub(super) [int32x4_t; 2]);

impl I32 {
    #[inline(always)]
    fn zip(self, other: Self, apply: impl Fn(int32x4_t, int32x4_t) -> int32x4_t) -> Self {
        let ([a, b], [c, d]) = (self.0, other.0);
        Self([apply(a, c), apply(b, d)])
    }

    /// Shifts left by a number of bits, or right if it is negative.
    #[inline(always)]
    fn shift(self, bits: i32) -> Self {
        let bits = Self::splat(bits);
        self.zip(bits, |a, b| intrinsic!(vshlq_s32(a, b)))
    }

    /// Returns all bits of the lanes whose sign bit is set.
    #[inline(always)]
    pub(super) fn mask(self) -> [uint32x4_t; 2] {
        self.0.map(|a| intrinsic!(vcltzq_s32(a)))
    }

    #[inline(always)]
    pub(super) fn from_mask(mask: [uint32x4_t; 2]) -> Self {
        Self(mask.map(|a| intrinsic!(vreinterpretq_s32_u32(a))))
    }
}

operators!(
    I32: Add::add = vaddq_s32,
    Sub::sub = vsubq_s32,
    Mul::mul = vmulq_s32,
    BitAnd::bitand = vandq_s32,
    BitOr::bitor = vorrq_s32,
    BitXor::bitxor = veorq_s32
);

impl I32Lanes for I32 {
    #[inline(always)]
    fn splat(value: i32) -> Self {
        Self([intrinsic!(vdupq_n_s32(value)); 2])
    }
    #[inline(always)]
    fn load(values: &[i32; 8]) -> Self {
        let (low, high) = values.split_at(4);
        intrinsic!(Self([vld1q_s32(low.as_ptr()), vld1q_s32(high.as_ptr())]))
    }
    #[inline(always)]
    fn store(self, to: &mut [i32; 8]) {
        let (low, high) = to.split_at_mut(4);
        intrinsic!({
            vst1q_s32(low.as_mut_ptr(), self.0[0]);
            vst1q_s32(high.as_mut_ptr(), self.0[1]);
        });
    }
    #[inline(always)]
    fn load_unsigned(values: &[u32; 8]) -> Self {
        Self::load(&values.map(u32::cast_signed))
    }
    #[inline(always)]
    fn store_unsigned(self, to: &mut [u32; 8]) {
        *to = self.to_array().map(i32::cast_unsigned);
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        self.zip(other, |a, b| intrinsic!(vminq_s32(a, b)))
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        self.zip(other, |a, b| intrinsic!(vmaxq_s32(a, b)))
    }
    #[inline(always)]
    fn shift_left(self, bits: u32) -> Self {
        self.shift(bits.cast_signed())
    }
    #[inline(always)]
    fn shift_right(self, bits: u32) -> Self {
        self.shift(-bits.cast_signed())
    }
    #[inline(always)]
    fn select(mask: Self, then: Self, otherwise: Self) -> Self {
        let ([m, n], [a, b], [c, d]) = (mask.mask(), then.0, otherwise.0);
        intrinsic!(Self([vbslq_s32(m, a, c), vbslq_s32(n, b, d)]))
    }
    #[inline(always)]
    fn signs(self) -> u32 {
        const BITS: [u32; 8] = [1, 2, 4, 8, 16, 32, 64, 128];
        let ([low, high], bits) = (self.mask(), Self::load_unsigned(&BITS).0);
        intrinsic!({
            let low = vandq_u32(low, vreinterpretq_u32_s32(bits[0]));
            let high = vandq_u32(high, vreinterpretq_u32_s32(bits[1]));
            vaddvq_u32(vorrq_u32(low, high))
        })
    }
}
