use std::arch::aarch64::*;

use super::f64::F64;
use super::i32::I32;
use crate::{I32Lanes, Lanes, PackedVertex};

/// Eight `f32` in two registers.
#[derive(Clone, Copy)]
pub(crate) struct F32([float32x4_t; 2]);

impl F32 {
    #[inline(always)]
    fn zip(self, other: Self, apply: impl Fn(float32x4_t, float32x4_t) -> float32x4_t) -> Self {
        let ([a, b], [c, d]) = (self.0, other.0);
        Self([apply(a, c), apply(b, d)])
    }
}

operators!(
    F32: Add::add = vaddq_f32,
    Sub::sub = vsubq_f32,
    Mul::mul = vmulq_f32,
    Div::div = vdivq_f32
);

impl Lanes for F32 {
    type I32 = I32;
    type F64 = F64;

    #[inline(always)]
    fn splat(value: f32) -> Self {
        Self([intrinsic!(vdupq_n_f32(value)); 2])
    }
    #[inline(always)]
    fn load(values: &[f32; 8]) -> Self {
        let (low, high) = values.split_at(4);
        intrinsic!(Self([vld1q_f32(low.as_ptr()), vld1q_f32(high.as_ptr())]))
    }
    #[inline(always)]
    fn store(self, to: &mut [f32; 8]) {
        let (low, high) = to.split_at_mut(4);
        intrinsic!({
            vst1q_f32(low.as_mut_ptr(), self.0[0]);
            vst1q_f32(high.as_mut_ptr(), self.0[1]);
        });
    }
    #[inline(always)]
    fn from_bits(bits: I32) -> Self {
        Self(bits.0.map(|a| intrinsic!(vreinterpretq_f32_s32(a))))
    }
    #[inline(always)]
    fn to_bits(self) -> I32 {
        I32(self.0.map(|a| intrinsic!(vreinterpretq_s32_f32(a))))
    }
    #[inline(always)]
    fn from_i32(values: I32) -> Self {
        Self(values.0.map(|a| intrinsic!(vcvtq_f32_s32(a))))
    }
    #[inline(always)]
    fn trunc(self) -> I32 {
        I32(self.0.map(|a| intrinsic!(vcvtq_s32_f32(a))))
    }

    #[inline(always)]
    fn widen(self) -> F64 {
        F64::from_f32(self.0)
    }
    #[inline(always)]
    fn widen_i32(values: I32) -> F64 {
        F64::from_i32(values.0)
    }
    #[inline(always)]
    fn narrow(values: F64) -> Self {
        Self(values.to_f32())
    }
    #[inline(always)]
    fn round(values: F64) -> I32 {
        I32(values.round())
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(self.0.map(|a| intrinsic!(vsqrtq_f32(a))))
    }
    // The instructions for the minimum and maximum return NaN if either value is.
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        Self::select(self.lt(other), self, other)
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        Self::select(other.lt(self), self, other)
    }
    #[inline(always)]
    fn le(self, other: Self) -> I32 {
        let ([a, b], [c, d]) = (self.0, other.0);
        I32::from_mask(intrinsic!([vcleq_f32(a, c), vcleq_f32(b, d)]))
    }
    #[inline(always)]
    fn lt(self, other: Self) -> I32 {
        let ([a, b], [c, d]) = (self.0, other.0);
        I32::from_mask(intrinsic!([vcltq_f32(a, c), vcltq_f32(b, d)]))
    }
    #[inline(always)]
    fn select(mask: I32, then: Self, otherwise: Self) -> Self {
        let ([m, n], [a, b], [c, d]) = (mask.mask(), then.0, otherwise.0);
        intrinsic!(Self([vbslq_f32(m, a, c), vbslq_f32(n, b, d)]))
    }
    #[inline(always)]
    fn reduce_min(self) -> f32 {
        intrinsic!(vminvq_f32(vminq_f32(self.0[0], self.0[1])))
    }
    #[inline(always)]
    fn ranks(self) -> [u32; 8] {
        let mut sum = I32::splat(0);
        for other in self.to_array() {
            // A mask is −1 where it is set.
            sum = sum - Self::splat(other).le(self);
        }
        let mut ranks = [0; 8];
        sum.store_unsigned(&mut ranks);
        ranks
    }

    #[inline(always)]
    fn gather(points: &[[f32; 3]], indices: [u32; 8]) -> [Self; 3] {
        let [x, y, z] = columns(indices.map(|index| point(points, index)));
        [x, y, z].map(|column| Self::from_bits(I32::from_mask(column)))
    }
    #[inline(always)]
    fn load_rows(rows: [&PackedVertex; 8]) -> (I32, I32, Self) {
        let rows = rows.map(|row| intrinsic!(vld1q_u32(row.0.as_ptr())));
        let [x, y, z] = columns(rows).map(I32::from_mask);
        (x, y, Self::from_bits(z))
    }
    #[inline(always)]
    fn store_rows(x: I32, y: I32, z: Self, rows: &mut [PackedVertex; 8]) {
        let zero = intrinsic!(vdupq_n_s32(0));
        let (z, (low, high)) = (z.to_bits(), rows.split_at_mut(4));
        for (half, rows) in [low, high].into_iter().enumerate() {
            let columns = int32x4x4_t(x.0[half], y.0[half], z.0[half], zero);
            // Interleaves the columns of four rows, which follow each other in memory.
            intrinsic!(vst4q_s32(rows.as_mut_ptr().cast(), columns));
        }
    }
}

/// Loads three coordinates and an arbitrary fourth value.
#[inline(always)]
fn point(points: &[[f32; 3]], index: u32) -> uint32x4_t {
    let index = index as usize;
    if index + 1 < points.len() {
        // Another point follows, so sixteen bytes lie within the slice.
        intrinsic!(vld1q_u32(points.as_ptr().add(index).cast()))
    } else {
        let [x, y, z] = points[index];
        let values = [x, y, z, 0.0];
        intrinsic!(vreinterpretq_u32_f32(vld1q_f32(values.as_ptr())))
    }
}

/// The first three columns of eight rows.
#[inline(always)]
fn columns([a, b, c, d, e, f, g, h]: [uint32x4_t; 8]) -> [[uint32x4_t; 2]; 3] {
    let ([x, y, z], [u, v, w]) = (columns_of_four([a, b, c, d]), columns_of_four([e, f, g, h]));
    [[x, u], [y, v], [z, w]]
}

#[inline(always)]
fn columns_of_four([a, b, c, d]: [uint32x4_t; 4]) -> [uint32x4_t; 3] {
    // Two zips with the row two places further interleave all four.
    intrinsic!({
        let (xy_even, z_even) = (vzip1q_u32(a, c), vzip2q_u32(a, c));
        let (xy_odd, z_odd) = (vzip1q_u32(b, d), vzip2q_u32(b, d));
        [
            vzip1q_u32(xy_even, xy_odd),
            vzip2q_u32(xy_even, xy_odd),
            vzip1q_u32(z_even, z_odd),
        ]
    })
}
