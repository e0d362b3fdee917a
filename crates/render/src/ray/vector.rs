//! Vectors of lanes. Plain products and sums in a fixed order, so that what is equal stays equal.
//!
//! No closures here, nor in the kernels: a closure is compiled without the instructions of the function around it.

use super::simd::Lanes;

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

    /// One lane of each in all lanes.
    #[inline(always)]
    pub(crate) fn splat_lane([x, y, z]: &[[f32; 8]; 3], lane: usize) -> Self {
        Self::splat([x[lane], y[lane], z[lane]])
    }

    #[inline(always)]
    pub(crate) fn store(self, [x, y, z]: &mut [[f32; 8]; 3]) {
        self.x.store(x);
        self.y.store(y);
        self.z.store(z);
    }

    #[inline(always)]
    pub(crate) fn add(self, other: Self) -> Self {
        Self {
            x: self.x.add(other.x),
            y: self.y.add(other.y),
            z: self.z.add(other.z),
        }
    }

    #[inline(always)]
    pub(crate) fn sub(self, other: Self) -> Self {
        Self {
            x: self.x.sub(other.x),
            y: self.y.sub(other.y),
            z: self.z.sub(other.z),
        }
    }

    #[inline(always)]
    pub(crate) fn scale(self, by: L) -> Self {
        Self {
            x: self.x.mul(by),
            y: self.y.mul(by),
            z: self.z.mul(by),
        }
    }

    /// With the signs turned where `sign` is negative.
    #[inline(always)]
    pub(crate) fn turned(self, sign: L) -> Self {
        Self {
            x: self.x.xor(sign),
            y: self.y.xor(sign),
            z: self.z.xor(sign),
        }
    }

    #[inline(always)]
    pub(crate) fn dot(self, other: Self) -> L {
        self.x
            .mul(other.x)
            .add(self.y.mul(other.y))
            .add(self.z.mul(other.z))
    }

    #[inline(always)]
    pub(crate) fn cross(self, other: Self) -> Self {
        Self {
            x: self.y.mul(other.z).sub(self.z.mul(other.y)),
            y: self.z.mul(other.x).sub(self.x.mul(other.z)),
            z: self.x.mul(other.y).sub(self.y.mul(other.x)),
        }
    }

    /// The normal of the plane through the origin and two points. With the points in the other order it is the same
    /// with the other sign, to the last bit.
    #[inline(always)]
    pub(crate) fn side(self, other: Self) -> Self {
        self.add(other).cross(other.sub(self))
    }
}
