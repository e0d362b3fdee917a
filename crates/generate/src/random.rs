//! Random numbers that depend on the seed, the name of a quantity and a number only.

use oaktwin_camera::math::{DMat3, DQuat, DVec3};
use oaktwin_depth::random::{Plane, Stage, Stream};

/// The random numbers of a recipe.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Random {
    seed: u64,
}

impl Random {
    pub(crate) const fn new(seed: u64) -> Self {
        Self { seed }
    }

    /// Returns the numbers of a quantity in a frame or scene of this number.
    pub(crate) fn numbers(self, name: &str, number: u64) -> Numbers {
        Numbers {
            plane: Stream::new(self.seed, name).plane(Stage::Recipe, number, 0),
            next: 0,
        }
    }
}

/// A sequence of random numbers. Functions are those of the crate `libm`, which gives the same bits on every machine.
#[derive(Clone, Debug)]
pub(crate) struct Numbers {
    plane: Plane,
    next: u32,
}

impl Numbers {
    /// Returns a number in [0, 1).
    pub(crate) fn uniform(&mut self) -> f64 {
        let [a, b, ..] = self.plane.words(self.next, 0);
        self.next += 1;
        let bits = (u64::from(a) << 32 | u64::from(b)) >> 11;
        #[expect(clippy::cast_precision_loss, reason = "53 bits")]
        let bits = bits as f64;
        bits * (1.0 / (1u64 << 53) as f64)
    }

    /// Returns a number of the standard normal distribution, cut at ±`limit`.
    pub(crate) fn normal_within(&mut self, limit: f64) -> f64 {
        loop {
            let radius = libm::sqrt(-2.0 * libm::log(1.0 - self.uniform()));
            let normal = radius * libm::cos(std::f64::consts::TAU * self.uniform());
            if normal.abs() <= limit {
                return normal;
            }
        }
    }

    /// Returns one of the items; `None` if there are none.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        clippy::cast_precision_loss,
        reason = "an index"
    )]
    pub(crate) fn pick<'a, T>(&mut self, items: &'a [T]) -> Option<&'a T> {
        let at = (self.uniform() * items.len() as f64) as usize;
        items.get(at.min(items.len().saturating_sub(1)))
    }

    /// Returns a rotation, each with the same probability (Shoemake 1992).
    pub(crate) fn rotation(&mut self) -> DMat3 {
        let [a, b, c] = [self.uniform(), self.uniform(), self.uniform()].map(|x| x * std::f64::consts::TAU);
        let (low, high) = (
            libm::sqrt(a / std::f64::consts::TAU),
            libm::sqrt(1.0 - a / std::f64::consts::TAU),
        );
        let quaternion = DQuat::from_xyzw(
            high * libm::sin(b),
            high * libm::cos(b),
            low * libm::sin(c),
            low * libm::cos(c),
        );
        DMat3::from_quat(quaternion.normalize())
    }
}

/// Returns the rotation by an angle in radians around a unit vector.
pub(crate) fn rotation_around(axis: DVec3, angle: f64) -> DMat3 {
    let (sine, cosine) = (libm::sin(angle), libm::cos(angle));
    let cross = DMat3::from_cols(
        DVec3::new(0.0, axis.z, -axis.y),
        DVec3::new(-axis.z, 0.0, axis.x),
        DVec3::new(axis.y, -axis.x, 0.0),
    );
    let outer = DMat3::from_cols(axis * axis.x, axis * axis.y, axis * axis.z);
    DMat3::from_diagonal(DVec3::splat(cosine)) + cross * sine + outer * (1.0 - cosine)
}

/// Returns a rotation that turns one unit vector into another.
pub(crate) fn rotation_between(from: DVec3, to: DVec3) -> DMat3 {
    let axis = from.cross(to);
    let (sine, cosine) = (axis.length(), from.dot(to));
    match axis.try_normalize() {
        Some(axis) => rotation_around(axis, libm::atan2(sine, cosine)),
        None if cosine > 0.0 => DMat3::IDENTITY,
        None => rotation_around(from.any_orthonormal_vector(), std::f64::consts::PI),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_depend_on_the_name_and_the_number_only() {
        let random = Random::new(3);
        let first = random.numbers("camera.distance", 7).uniform();
        assert_eq!(first, random.numbers("camera.distance", 7).uniform());
        assert_ne!(first, random.numbers("camera.distance", 8).uniform());
        assert_ne!(first, random.numbers("camera.roll", 7).uniform());
        assert_ne!(first, Random::new(4).numbers("camera.distance", 7).uniform());
    }

    #[test]
    fn rotations_are_uniform() {
        let mut sum = DVec3::ZERO;
        for frame in 0..20_000 {
            let rotation = Random::new(1).numbers("rotation", frame).rotation();
            assert!((rotation.determinant() - 1.0).abs() < 1e-9);
            sum += rotation * DVec3::new(0.6, 0.0, 0.8);
        }
        assert!(sum.length() / 20_000.0 < 0.02);
    }

    #[test]
    fn rotations_between_vectors() {
        for (from, to) in [
            (DVec3::X, DVec3::Y),
            (DVec3::Z, DVec3::Z),
            (DVec3::Z, DVec3::NEG_Z),
            (DVec3::X, DVec3::new(0.6, 0.0, -0.8)),
        ] {
            assert!((rotation_between(from, to) * from - to).length() < 1e-12);
        }
        let quarter = rotation_around(DVec3::Z, std::f64::consts::FRAC_PI_2);
        assert!((quarter * DVec3::X - DVec3::Y).length() < 1e-12);
    }
}
