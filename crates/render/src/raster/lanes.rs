//! Eight numbers at a time: what instructions are needed, and what they mean.

/// Instructions on eight lanes. Every implementation gives the bits of [`Baseline`].
pub(super) trait Lanes: Copy {
    /// `f64`.
    type D: Copy;
    /// `f32`.
    type F: Copy;
    /// `i32`, or masks: all bits or none.
    type I: Copy;

    fn splat_d(self, value: f64) -> Self::D;
    fn widen(self, values: &[f32; 8]) -> Self::D;
    fn widen_i(self, values: Self::I) -> Self::D;
    fn add_d(self, a: Self::D, b: Self::D) -> Self::D;
    fn sub_d(self, a: Self::D, b: Self::D) -> Self::D;
    fn mul_d(self, a: Self::D, b: Self::D) -> Self::D;
    fn div_d(self, a: Self::D, b: Self::D) -> Self::D;
    /// To the nearest integer, of ties the even one; for what fits into 32 bits.
    fn round_d(self, a: Self::D) -> Self::I;
    fn narrow(self, a: Self::D) -> Self::F;

    fn splat_f(self, value: f32) -> Self::F;
    fn load_f(self, values: &[f32; 8]) -> Self::F;
    fn store_f(self, a: Self::F) -> [f32; 8];
    fn float_i(self, a: Self::I) -> Self::F;
    fn bits_f(self, a: Self::F) -> Self::I;
    fn add_f(self, a: Self::F, b: Self::F) -> Self::F;
    fn sub_f(self, a: Self::F, b: Self::F) -> Self::F;
    fn mul_f(self, a: Self::F, b: Self::F) -> Self::F;
    fn div_f(self, a: Self::F, b: Self::F) -> Self::F;
    /// `b` where they are equal or one is not a number.
    fn max_f(self, a: Self::F, b: Self::F) -> Self::F;
    /// Sign bits where `a` is the greater.
    fn greater_f(self, a: Self::F, b: Self::F) -> Self::I;
    /// Zero where the mask has a sign bit.
    fn zero_where_negative(self, mask: Self::I, a: Self::F) -> Self::F;

    fn splat_i(self, value: i32) -> Self::I;
    fn load_i(self, values: &[i32; 8]) -> Self::I;
    fn store_i(self, a: Self::I) -> [i32; 8];
    fn add_i(self, a: Self::I, b: Self::I) -> Self::I;
    fn sub_i(self, a: Self::I, b: Self::I) -> Self::I;
    fn mul_i(self, a: Self::I, b: Self::I) -> Self::I;
    fn and_i(self, a: Self::I, b: Self::I) -> Self::I;
    fn or_i(self, a: Self::I, b: Self::I) -> Self::I;
    fn xor_i(self, a: Self::I, b: Self::I) -> Self::I;
    /// `a` where the mask has a sign bit, else `b`.
    fn select_i(self, mask: Self::I, a: Self::I, b: Self::I) -> Self::I;
    fn min_i(self, a: Self::I, b: Self::I) -> Self::I;
    fn max_i(self, a: Self::I, b: Self::I) -> Self::I;
    fn shl_i(self, a: Self::I, bits: u32) -> Self::I;
    /// Keeps the sign.
    fn shr_i(self, a: Self::I, bits: u32) -> Self::I;
    /// The sign bits, the first lane's lowest.
    fn signs(self, a: Self::I) -> u32;

    /// Brings what is there into the fastest cache.
    fn prefetch<T>(self, values: &[T]);

    /// The first three columns of eight rows.
    fn columns(self, rows: [&Row; 8]) -> (Self::I, Self::I, Self::F);
    fn store_rows(self, x: Self::I, y: Self::I, z: Self::F, rows: &mut [Row; 8]);
}

/// Two integers, the bits of a float, and nothing.
#[derive(Clone, Copy, Debug)]
#[repr(align(16))]
pub(super) struct Row(pub(super) [u32; 4]);

/// Plain arrays.
#[derive(Clone, Copy, Debug)]
pub(super) struct Baseline;

#[inline(always)]
fn zip<A: Copy, B: Copy, C>(a: [A; 8], b: [B; 8], f: impl Fn(A, B) -> C) -> [C; 8] {
    std::array::from_fn(|l| f(a[l], b[l]))
}

impl Lanes for Baseline {
    type D = [f64; 8];
    type F = [f32; 8];
    type I = [i32; 8];

    #[inline(always)]
    fn splat_d(self, value: f64) -> [f64; 8] {
        [value; 8]
    }
    #[inline(always)]
    fn widen(self, values: &[f32; 8]) -> [f64; 8] {
        values.map(f64::from)
    }
    #[inline(always)]
    fn widen_i(self, values: [i32; 8]) -> [f64; 8] {
        values.map(f64::from)
    }
    #[inline(always)]
    fn add_d(self, a: [f64; 8], b: [f64; 8]) -> [f64; 8] {
        zip(a, b, |a, b| a + b)
    }
    #[inline(always)]
    fn sub_d(self, a: [f64; 8], b: [f64; 8]) -> [f64; 8] {
        zip(a, b, |a, b| a - b)
    }
    #[inline(always)]
    fn mul_d(self, a: [f64; 8], b: [f64; 8]) -> [f64; 8] {
        zip(a, b, |a, b| a * b)
    }
    #[inline(always)]
    fn div_d(self, a: [f64; 8], b: [f64; 8]) -> [f64; 8] {
        zip(a, b, |a, b| a / b)
    }
    #[inline(always)]
    fn round_d(self, a: [f64; 8]) -> [i32; 8] {
        a.map(super::frame::round)
    }
    #[inline(always)]
    #[expect(clippy::cast_possible_truncation, reason = "that is what it is for")]
    fn narrow(self, a: [f64; 8]) -> [f32; 8] {
        a.map(|a| a as f32)
    }

    #[inline(always)]
    fn splat_f(self, value: f32) -> [f32; 8] {
        [value; 8]
    }
    #[inline(always)]
    fn load_f(self, values: &[f32; 8]) -> [f32; 8] {
        *values
    }
    #[inline(always)]
    fn store_f(self, a: [f32; 8]) -> [f32; 8] {
        a
    }
    #[inline(always)]
    #[expect(
        clippy::cast_precision_loss,
        reason = "rounded to nearest, as by the instruction"
    )]
    fn float_i(self, a: [i32; 8]) -> [f32; 8] {
        a.map(|a| a as f32)
    }
    #[inline(always)]
    fn bits_f(self, a: [f32; 8]) -> [i32; 8] {
        a.map(|a| a.to_bits().cast_signed())
    }
    #[inline(always)]
    fn add_f(self, a: [f32; 8], b: [f32; 8]) -> [f32; 8] {
        zip(a, b, |a, b| a + b)
    }
    #[inline(always)]
    fn sub_f(self, a: [f32; 8], b: [f32; 8]) -> [f32; 8] {
        zip(a, b, |a, b| a - b)
    }
    #[inline(always)]
    fn mul_f(self, a: [f32; 8], b: [f32; 8]) -> [f32; 8] {
        zip(a, b, |a, b| a * b)
    }
    #[inline(always)]
    fn div_f(self, a: [f32; 8], b: [f32; 8]) -> [f32; 8] {
        zip(a, b, |a, b| a / b)
    }
    #[inline(always)]
    fn max_f(self, a: [f32; 8], b: [f32; 8]) -> [f32; 8] {
        zip(a, b, |a, b| if a > b { a } else { b })
    }
    #[inline(always)]
    fn greater_f(self, a: [f32; 8], b: [f32; 8]) -> [i32; 8] {
        zip(a, b, |a, b| -i32::from(a > b))
    }
    #[inline(always)]
    fn zero_where_negative(self, mask: [i32; 8], a: [f32; 8]) -> [f32; 8] {
        zip(mask, a, |mask, a| if mask < 0 { 0.0 } else { a })
    }

    #[inline(always)]
    fn splat_i(self, value: i32) -> [i32; 8] {
        [value; 8]
    }
    #[inline(always)]
    fn load_i(self, values: &[i32; 8]) -> [i32; 8] {
        *values
    }
    #[inline(always)]
    fn store_i(self, a: [i32; 8]) -> [i32; 8] {
        a
    }
    #[inline(always)]
    fn add_i(self, a: [i32; 8], b: [i32; 8]) -> [i32; 8] {
        zip(a, b, i32::wrapping_add)
    }
    #[inline(always)]
    fn sub_i(self, a: [i32; 8], b: [i32; 8]) -> [i32; 8] {
        zip(a, b, i32::wrapping_sub)
    }
    #[inline(always)]
    fn mul_i(self, a: [i32; 8], b: [i32; 8]) -> [i32; 8] {
        zip(a, b, i32::wrapping_mul)
    }
    #[inline(always)]
    fn and_i(self, a: [i32; 8], b: [i32; 8]) -> [i32; 8] {
        zip(a, b, |a, b| a & b)
    }
    #[inline(always)]
    fn or_i(self, a: [i32; 8], b: [i32; 8]) -> [i32; 8] {
        zip(a, b, |a, b| a | b)
    }
    #[inline(always)]
    fn xor_i(self, a: [i32; 8], b: [i32; 8]) -> [i32; 8] {
        zip(a, b, |a, b| a ^ b)
    }
    #[inline(always)]
    fn select_i(self, mask: [i32; 8], a: [i32; 8], b: [i32; 8]) -> [i32; 8] {
        std::array::from_fn(|l| if mask[l] < 0 { a[l] } else { b[l] })
    }
    #[inline(always)]
    fn min_i(self, a: [i32; 8], b: [i32; 8]) -> [i32; 8] {
        zip(a, b, i32::min)
    }
    #[inline(always)]
    fn max_i(self, a: [i32; 8], b: [i32; 8]) -> [i32; 8] {
        zip(a, b, i32::max)
    }
    #[inline(always)]
    fn shl_i(self, a: [i32; 8], bits: u32) -> [i32; 8] {
        a.map(|a| a << bits)
    }
    #[inline(always)]
    fn shr_i(self, a: [i32; 8], bits: u32) -> [i32; 8] {
        a.map(|a| a >> bits)
    }
    #[inline(always)]
    fn signs(self, a: [i32; 8]) -> u32 {
        (0..8).fold(0, |signs, l| signs | u32::from(a[l] < 0) << l)
    }

    #[inline(always)]
    fn prefetch<T>(self, _values: &[T]) {}

    #[inline(always)]
    fn columns(self, rows: [&Row; 8]) -> ([i32; 8], [i32; 8], [f32; 8]) {
        (
            rows.map(|row| row.0[0].cast_signed()),
            rows.map(|row| row.0[1].cast_signed()),
            rows.map(|row| f32::from_bits(row.0[2])),
        )
    }
    #[inline(always)]
    fn store_rows(self, x: [i32; 8], y: [i32; 8], z: [f32; 8], rows: &mut [Row; 8]) {
        for (l, row) in rows.iter_mut().enumerate() {
            row.0 = [x[l].cast_unsigned(), y[l].cast_unsigned(), z[l].to_bits(), 0];
        }
    }
}
