//! Light from all directions as spherical harmonics.

use glam::Vec3;

/// Spherical harmonics up to the second order, in three channels, which suffice for diffuse surfaces (Ramamoorthi and Hanrahan,
/// "An Efficient Representation for Irradiance Environment Maps", 2001).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Harmonics([Vec3; 9]);

impl Harmonics {
    /// Creates uniform radiance.
    pub(super) fn uniform(radiance: Vec3) -> Self {
        let mut all = Self::default();
        all.0[0] = radiance / BASIS_0;
        all
    }

    /// Adds a gradient: `slope` times the cosine to `towards`.
    pub(super) fn with_slope(mut self, slope: Vec3, towards: Vec3) -> Self {
        for (coefficient, part) in self.0[1..4].iter_mut().zip([towards.y, towards.z, towards.x]) {
            *coefficient += slope * (part / BASIS_1);
        }
        self
    }

    /// Adds radiance from a small solid angle.
    pub(super) fn add(&mut self, direction: Vec3, radiance: Vec3, solid_angle: f32) {
        for (coefficient, basis) in self.0.iter_mut().zip(basis(direction)) {
            *coefficient += radiance * (basis * solid_angle);
        }
    }

    /// Returns the sum.
    pub(super) fn plus(mut self, other: &Self) -> Self {
        for (mine, others) in self.0.iter_mut().zip(other.0) {
            *mine += others;
        }
        self
    }

    /// Returns the irradiance of a surface divided by π: the cosine-weighted mean radiance.
    #[inline]
    pub(super) fn mean_by_cosine(&self, normal: Vec3) -> Vec3 {
        let mut sum = Vec3::ZERO;
        for ((coefficient, polynomial), band) in self.0.iter().zip(polynomials(normal)).zip(BANDS) {
            sum += *coefficient * (polynomial * band);
        }
        sum.max(Vec3::ZERO)
    }

    /// Returns the coefficients of that for 1, y, z, x, xy, yz, 3z² − 1, xz and x² − y² of the normal.
    #[inline]
    pub(super) fn by_cosine(&self) -> [Vec3; 9] {
        std::array::from_fn(|i| self.0[i] * BANDS[i])
    }

    /// Whether the radiance is uniform.
    #[inline]
    pub(super) fn is_uniform(&self) -> bool {
        self.0[1..].iter().all(|coefficient| *coefficient == Vec3::ZERO)
    }
}

/// The factors of the basis, times the coefficients of the cosine over π.
const BANDS: [f32; 9] = [
    BASIS_0,
    BASIS_1 * 2.0 / 3.0,
    BASIS_1 * 2.0 / 3.0,
    BASIS_1 * 2.0 / 3.0,
    1.092_548_4 / 4.0,
    1.092_548_4 / 4.0,
    0.315_391_57 / 4.0,
    1.092_548_4 / 4.0,
    0.546_274_2 / 4.0,
];

const BASIS_0: f32 = 0.282_094_8;
const BASIS_1: f32 = 0.488_602_5;

/// The real spherical harmonics of a unit vector.
#[inline]
fn basis(d: Vec3) -> [f32; 9] {
    [
        BASIS_0,
        BASIS_1 * d.y,
        BASIS_1 * d.z,
        BASIS_1 * d.x,
        1.092_548_4 * d.x * d.y,
        1.092_548_4 * d.y * d.z,
        0.315_391_57 * (3.0 * d.z * d.z - 1.0),
        1.092_548_4 * d.x * d.z,
        0.546_274_2 * (d.x * d.x - d.y * d.y),
    ]
}

/// The spherical harmonics without their factors.
#[inline]
fn polynomials(d: Vec3) -> [f32; 9] {
    [
        1.0,
        d.y,
        d.z,
        d.x,
        d.x * d.y,
        d.y * d.z,
        3.0 * d.z * d.z - 1.0,
        d.x * d.z,
        d.x * d.x - d.y * d.y,
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn uniform_light_does_not_depend_on_the_normal() {
        let uniform = Harmonics::uniform(Vec3::new(1.0, 2.0, 3.0));
        let got = uniform.mean_by_cosine(Vec3::new(0.6, 0.0, -0.8));
        assert!((got - Vec3::new(1.0, 2.0, 3.0)).length() < 1e-5);
    }

    #[test]
    fn integration_over_the_sphere_matches_the_formula() {
        // Radiance 1 + z from direction z.
        let mut summed = Harmonics::default();
        let (rings, sectors) = (64u16, 128u16);
        for i in 0..rings {
            let z = 2.0 * (f32::from(i) + 0.5) / f32::from(rings) - 1.0;
            for j in 0..sectors {
                let azimuth = std::f32::consts::TAU * f32::from(j) / f32::from(sectors);
                let across = (1.0 - z * z).sqrt();
                let direction = Vec3::new(across * azimuth.cos(), across * azimuth.sin(), z);
                let solid_angle = 4.0 * std::f32::consts::PI / (f32::from(rings) * f32::from(sectors));
                summed.add(direction, Vec3::splat(1.0 + z), solid_angle);
            }
        }
        let formula = Harmonics::uniform(Vec3::ONE).with_slope(Vec3::ONE, Vec3::Z);
        for normal in [Vec3::Z, Vec3::X, Vec3::NEG_Z] {
            // The cosine-weighted mean of z is 2/3 for a normal along z.
            let expected = 1.0 + normal.z * 2.0 / 3.0;
            for light in [&summed, &formula] {
                assert!((light.mean_by_cosine(normal).x - expected).abs() < 1e-3);
            }
        }
    }
}
