use std::ops::{Add, BitAnd, BitOr, BitXor, Div, Mul, Sub};

/// Eight `f32`, with vectors of eight `i32` and eight `f64` of the same instruction set.
///
/// A comparison returns a mask: −1 in the lanes where it holds, else 0. Whatever takes a mask reads only sign bits.
pub trait Lanes:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    /// Eight `i32`, or a mask.
    type I32: I32Lanes;
    /// Eight `f64`.
    type F64: F64Lanes;

    /// Returns a vector with one value in all lanes.
    fn splat(value: f32) -> Self;
    /// Loads eight values.
    fn load(values: &[f32; 8]) -> Self;
    /// Stores the eight values.
    fn store(self, to: &mut [f32; 8]);
    /// Reinterprets bits.
    fn from_bits(bits: Self::I32) -> Self;
    /// Returns the bits.
    fn to_bits(self) -> Self::I32;
    /// Converts integers to the nearest numbers.
    fn from_i32(values: Self::I32) -> Self;
    /// Truncates numbers that fit into 32 bits to integers; the result for others depends on the processor.
    fn trunc(self) -> Self::I32;

    /// Converts to double precision.
    fn widen(self) -> Self::F64;
    /// Converts integers to double precision.
    fn widen_i32(values: Self::I32) -> Self::F64;
    /// Rounds to single precision.
    fn narrow(values: Self::F64) -> Self;
    /// Rounds numbers that fit into 32 bits to the nearest integers, ties to even ones.
    fn round(values: Self::F64) -> Self::I32;

    /// Returns the square roots.
    fn sqrt(self) -> Self;
    /// Returns the smaller of two values, and `other` where one is NaN or both are equal.
    fn min(self, other: Self) -> Self;
    /// Returns the larger of two values, and `other` where one is NaN or both are equal.
    fn max(self, other: Self) -> Self;
    /// Returns the mask of `self <= other`.
    fn le(self, other: Self) -> Self::I32;
    /// Returns the mask of `self < other`.
    fn lt(self, other: Self) -> Self::I32;
    /// Returns `then` where the mask is set, else `otherwise`.
    fn select(mask: Self::I32, then: Self, otherwise: Self) -> Self;
    /// Returns the minimum of all lanes, none of which may be NaN.
    fn reduce_min(self) -> f32;
    /// Returns for each lane how many lanes are not greater, including itself; 0 where it is NaN.
    fn ranks(self) -> [u32; 8];

    /// Loads the coordinates of eight points.
    fn gather(points: &[[f32; 3]], indices: [u32; 8]) -> [Self; 3];
    /// Loads the columns of eight rows.
    fn load_rows(rows: [&PackedVertex; 8]) -> (Self::I32, Self::I32, Self);
    /// Stores the columns of eight rows.
    fn store_rows(x: Self::I32, y: Self::I32, z: Self, rows: &mut [PackedVertex; 8]);
    /// Requests that a place be brought into the cache.
    #[inline(always)]
    fn prefetch<T: ?Sized>(_place: &T) {}

    /// Returns the eight values.
    #[inline(always)]
    fn to_array(self) -> [f32; 8] {
        let mut values = [0.0; 8];
        self.store(&mut values);
        values
    }
}

/// Eight `i32`; sums and products wrap around.
pub trait I32Lanes:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + BitAnd<Output = Self>
    + BitOr<Output = Self>
    + BitXor<Output = Self>
{
    /// Returns a vector with one value in all lanes.
    fn splat(value: i32) -> Self;
    /// Loads eight values.
    fn load(values: &[i32; 8]) -> Self;
    /// Stores the eight values.
    fn store(self, to: &mut [i32; 8]);
    /// Loads the bits of eight unsigned values.
    fn load_unsigned(values: &[u32; 8]) -> Self;
    /// Stores the bits as eight unsigned values.
    fn store_unsigned(self, to: &mut [u32; 8]);
    /// Returns the smaller of two values.
    fn min(self, other: Self) -> Self;
    /// Returns the larger of two values.
    fn max(self, other: Self) -> Self;
    /// Shifts left by less than 32 bits.
    fn shift_left(self, bits: u32) -> Self;
    /// Shifts right by less than 32 bits and keeps the sign.
    fn shift_right(self, bits: u32) -> Self;
    /// Returns `then` where the mask is set, else `otherwise`.
    fn select(mask: Self, then: Self, otherwise: Self) -> Self;
    /// Returns the sign bits, lane 0 lowest.
    fn signs(self) -> u32;

    /// Returns the eight values.
    #[inline(always)]
    fn to_array(self) -> [i32; 8] {
        let mut values = [0; 8];
        self.store(&mut values);
        values
    }
}

/// Eight `f64`.
pub trait F64Lanes:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    /// Returns a vector with one value in all lanes.
    fn splat(value: f64) -> Self;
    /// Loads eight values.
    fn load(values: &[f64; 8]) -> Self;
    /// Stores the eight values.
    fn store(self, to: &mut [f64; 8]);
}

/// Two integers, the bits of a float, and 32 unused bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(align(16))]
pub struct PackedVertex(pub [u32; 4]);
