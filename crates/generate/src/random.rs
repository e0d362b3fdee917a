//! Random numbers that depend on the seed, the name of a quantity and a number only.

use oaktwin_camera::math::{DMat3, DVec3};
pub(crate) use oaktwin_depth::random::Numbers;
use oaktwin_depth::random::{NoiseStage, Stream};

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
        Numbers::new(Stream::new(self.seed, name).plane(NoiseStage::Recipe, number, 0))
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
