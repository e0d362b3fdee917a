//! Vectors of lanes, with products and sums in a fixed order.
//!
//! Kernels contain no closures, because a closure is compiled without the instructions of the enclosing function.

use std::ops::{Add, Mul, Sub};

use oaktwin_simd::Lanes;

#[derive(Clone, Copy)]
pub(crate) struct Vector<L> {
    pub(crate) x: L,
    pub(crate) y: L,
    pub(crate) z: L,
}

impl<L: Lanes> Vector<L> {
    #[inline(always)]
    pub(crate) fn splat([x, y, z]: [f32; 3]) -> Self {
        Self {
            x: L::splat(x),
            y: L::splat(y),
            z: L::splat(z),
        }
    }

    /// Broadcasts one lane of each component.
    #[inline(always)]
    pub(crate) fn splat_lane([x, y, z]: &[[f32; 8]; 3], lane: usize) -> Self {
        Self::splat([x[lane], y[lane], z[lane]])
    }

    #[inline(always)]
    pub(crate) fn load([x, y, z]: &[[f32; 8]; 3]) -> Self {
        Self {
            x: L::load(x),
            y: L::load(y),
            z: L::load(z),
        }
    }

    #[inline(always)]
    pub(crate) fn store(self, [x, y, z]: &mut [[f32; 8]; 3]) {
        self.x.store(x);
        self.y.store(y);
        self.z.store(z);
    }

    /// Flips the signs where `sign` is the bits of −0.
    #[inline(always)]
    pub(crate) fn flip(self, sign: L::I32) -> Self {
        Self {
            x: L::from_bits(self.x.to_bits() ^ sign),
            y: L::from_bits(self.y.to_bits() ^ sign),
            z: L::from_bits(self.z.to_bits() ^ sign),
        }
    }

    #[inline(always)]
    pub(crate) fn dot(self, other: Self) -> L {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    #[inline(always)]
    pub(crate) fn cross(self, other: Self) -> Self {
        Self {
            x: self.y * other.z - self.z * other.y,
            y: self.z * other.x - self.x * other.z,
            z: self.x * other.y - self.y * other.x,
        }
    }

    /// Returns the normal of the plane through the origin and two points. Swapping the points flips its sign exactly.
    #[inline(always)]
    pub(crate) fn side(self, other: Self) -> Self {
        (self + other).cross(other - self)
    }
}

impl<L: Lanes> Add for Vector<L> {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self {
            x: self.x + other.x,
            y: self.y + other.y,
            z: self.z + other.z,
        }
    }
}

impl<L: Lanes> Sub for Vector<L> {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self {
            x: self.x - other.x,
            y: self.y - other.y,
            z: self.z - other.z,
        }
    }
}

impl<L: Lanes> Mul<L> for Vector<L> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, factor: L) -> Self {
        Self {
            x: self.x * factor,
            y: self.y * factor,
            z: self.z * factor,
        }
    }
}
