//! Lanes as arrays: what every instruction set must agree with.

use std::array::from_fn;
use std::ops::{Add, BitAnd, BitOr, BitXor, Div, Mul, Sub};

use crate::{F64Lanes, I32Lanes, Lanes, PackedVertex, saturating_trunc};

#[derive(Clone, Copy)]
pub(crate) struct F32([f32; 8]);

#[derive(Clone, Copy)]
pub(crate) struct I32([i32; 8]);

#[derive(Clone, Copy)]
pub(crate) struct F64([f64; 8]);

#[inline(always)]
fn select<T: Copy>(mask: I32, then: [T; 8], otherwise: [T; 8]) -> [T; 8] {
    from_fn(|lane| {
        if mask.0[lane] < 0 {
            then[lane]
        } else {
            otherwise[lane]
        }
    })
}

macro_rules! operators {
    ($($vector:ident: $($operator:ident::$method:ident = $function:path),*;)*) => {$($(
        impl $operator for $vector {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self(from_fn(|lane| $function(self.0[lane], other.0[lane])))
            }
        }
    )*)*};
}

operators! {
    F32: Add::add = Add::add, Sub::sub = Sub::sub, Mul::mul = Mul::mul, Div::div = Div::div;
    F64: Add::add = Add::add, Sub::sub = Sub::sub, Mul::mul = Mul::mul, Div::div = Div::div;
    I32: Add::add = i32::wrapping_add, Sub::sub = i32::wrapping_sub, Mul::mul = i32::wrapping_mul,
        BitAnd::bitand = BitAnd::bitand, BitOr::bitor = BitOr::bitor, BitXor::bitxor = BitXor::bitxor;
}

/// 1.5 · 2^52: adding it to a number rounds the number to an integer, which is then the lowest bits of the sum.
pub(crate) const ROUND: f64 = 6_755_399_441_055_744.0;

/// Rounds a number that fits into 32 bits to the nearest integer, ties to the even one.
#[expect(clippy::cast_possible_truncation, reason = "takes the lowest bits")]
#[inline(always)]
#[must_use]
pub fn round_ties_even(value: f64) -> i32 {
    (value + ROUND).to_bits() as i32
}

impl Lanes for F32 {
    type I32 = I32;
    type F64 = F64;

    #[inline(always)]
    fn splat(value: f32) -> Self {
        Self([value; 8])
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
    fn from_bits(bits: I32) -> Self {
        Self(bits.0.map(|bits| f32::from_bits(bits.cast_unsigned())))
    }
    #[inline(always)]
    fn to_bits(self) -> I32 {
        I32(self.0.map(|value| value.to_bits().cast_signed()))
    }
    #[inline(always)]
    #[expect(clippy::cast_precision_loss, reason = "rounds to nearest")]
    fn from_i32(values: I32) -> Self {
        Self(values.0.map(|value| value as f32))
    }
    #[inline(always)]
    fn trunc(self) -> I32 {
        I32(self.0.map(saturating_trunc))
    }

    #[inline(always)]
    fn widen(self) -> F64 {
        F64(self.0.map(f64::from))
    }
    #[inline(always)]
    fn widen_i32(values: I32) -> F64 {
        F64(values.0.map(f64::from))
    }
    #[inline(always)]
    #[expect(clippy::cast_possible_truncation, reason = "rounds to single precision")]
    fn narrow(values: F64) -> Self {
        Self(values.0.map(|value| value as f32))
    }
    #[inline(always)]
    fn round(values: F64) -> I32 {
        I32(values.0.map(round_ties_even))
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(self.0.map(f32::sqrt))
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        Self(from_fn(|lane| {
            if self.0[lane] < other.0[lane] {
                self.0[lane]
            } else {
                other.0[lane]
            }
        }))
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        Self(from_fn(|lane| {
            if self.0[lane] > other.0[lane] {
                self.0[lane]
            } else {
                other.0[lane]
            }
        }))
    }
    #[inline(always)]
    fn le(self, other: Self) -> I32 {
        I32(from_fn(|lane| -i32::from(self.0[lane] <= other.0[lane])))
    }
    #[inline(always)]
    fn lt(self, other: Self) -> I32 {
        I32(from_fn(|lane| -i32::from(self.0[lane] < other.0[lane])))
    }
    #[inline(always)]
    fn select(mask: I32, then: Self, otherwise: Self) -> Self {
        Self(select(mask, then.0, otherwise.0))
    }
    #[inline(always)]
    fn reduce_min(self) -> f32 {
        self.0
            .into_iter()
            .fold(f32::INFINITY, |a, b| if b < a { b } else { a })
    }
    #[inline(always)]
    fn ranks(self) -> [u32; 8] {
        from_fn(|lane| self.0.iter().map(|value| u32::from(*value <= self.0[lane])).sum())
    }

    #[inline(always)]
    fn gather(points: &[[f32; 3]], indices: [u32; 8]) -> [Self; 3] {
        let points = indices.map(|index| points[index as usize]);
        from_fn(|axis| Self(from_fn(|lane| points[lane][axis])))
    }
    #[inline(always)]
    fn load_rows(rows: [&PackedVertex; 8]) -> (I32, I32, Self) {
        (
            I32(rows.map(|row| row.0[0].cast_signed())),
            I32(rows.map(|row| row.0[1].cast_signed())),
            Self(rows.map(|row| f32::from_bits(row.0[2]))),
        )
    }
    #[inline(always)]
    fn store_rows(x: I32, y: I32, z: Self, rows: &mut [PackedVertex; 8]) {
        for (lane, row) in rows.iter_mut().enumerate() {
            row.0 = [
                x.0[lane].cast_unsigned(),
                y.0[lane].cast_unsigned(),
                z.0[lane].to_bits(),
                0,
            ];
        }
    }
}

impl I32Lanes for I32 {
    #[inline(always)]
    fn splat(value: i32) -> Self {
        Self([value; 8])
    }
    #[inline(always)]
    fn load(values: &[i32; 8]) -> Self {
        Self(*values)
    }
    #[inline(always)]
    fn store(self, to: &mut [i32; 8]) {
        *to = self.0;
    }
    #[inline(always)]
    fn load_unsigned(values: &[u32; 8]) -> Self {
        Self(values.map(u32::cast_signed))
    }
    #[inline(always)]
    fn store_unsigned(self, to: &mut [u32; 8]) {
        *to = self.0.map(i32::cast_unsigned);
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        Self(from_fn(|lane| self.0[lane].min(other.0[lane])))
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        Self(from_fn(|lane| self.0[lane].max(other.0[lane])))
    }
    #[inline(always)]
    fn shift_left(self, bits: u32) -> Self {
        Self(self.0.map(|value| value << bits))
    }
    #[inline(always)]
    fn shift_right(self, bits: u32) -> Self {
        Self(self.0.map(|value| value >> bits))
    }
    #[inline(always)]
    fn select(mask: Self, then: Self, otherwise: Self) -> Self {
        Self(select(mask, then.0, otherwise.0))
    }
    #[inline(always)]
    fn signs(self) -> u32 {
        (0..8).fold(0, |signs, lane| signs | u32::from(self.0[lane] < 0) << lane)
    }
}

impl F64Lanes for F64 {
    #[inline(always)]
    fn splat(value: f64) -> Self {
        Self([value; 8])
    }
    #[inline(always)]
    fn load(values: &[f64; 8]) -> Self {
        Self(*values)
    }
    #[inline(always)]
    fn store(self, to: &mut [f64; 8]) {
        *to = self.0;
    }
}
