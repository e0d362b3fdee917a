use oaktwin_camera::math::{DMat3, DQuat};

use super::RandomPlane;

/// A sequence of random numbers. Functions are from the crate `libm`, which gives the same bits on every machine.
#[derive(Clone, Debug)]
pub struct Numbers {
    plane: RandomPlane,
    next: u32,
}

impl Numbers {
    /// Creates the sequence of a plane.
    #[must_use]
    pub const fn new(plane: RandomPlane) -> Self {
        Self { plane, next: 0 }
    }

    /// Returns 64 random bits.
    pub fn bits(&mut self) -> u64 {
        let [a, b, ..] = self.plane.words(self.next, 0);
        self.next += 1;
        u64::from(a) << 32 | u64::from(b)
    }

    /// Returns a number in [0, 1).
    pub fn uniform(&mut self) -> f64 {
        #[expect(clippy::cast_precision_loss, reason = "53 bits")]
        let bits = (self.bits() >> 11) as f64;
        bits * (1.0 / (1u64 << 53) as f64)
    }

    /// Returns a number of the standard normal distribution, cut at ±`limit`.
    pub fn normal_within(&mut self, limit: f64) -> f64 {
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
    pub fn pick<'a, T>(&mut self, items: &'a [T]) -> Option<&'a T> {
        let at = (self.uniform() * items.len() as f64) as usize;
        items.get(at.min(items.len().saturating_sub(1)))
    }

    /// Returns a rotation, each with the same probability (Shoemake 1992).
    pub fn rotation(&mut self) -> DMat3 {
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::{NoiseStage, Stream};
    use oaktwin_camera::math::DVec3;

    #[test]
    fn rotations_are_uniform() {
        let mut sum = DVec3::ZERO;
        for frame in 0..20_000 {
            let rotation =
                Numbers::new(Stream::new(1, "rotation").plane(NoiseStage::Recipe, frame, 0)).rotation();
            assert!((rotation.determinant() - 1.0).abs() < 1e-9);
            sum += rotation * DVec3::new(0.6, 0.0, 0.8);
        }
        assert!(sum.length() / 20_000.0 < 0.02);
    }
}
