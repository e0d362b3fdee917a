//! The directions in which rough mirrors reflect a ray, and rough glass passes it on.

use oaktwin_camera::math::DVec3;

/// The number of rays of a blurred reflection or passage.
const SAMPLES: u8 = 16;
/// The squared roughness, the width of the distribution of normals, below which a reflection is sharp.
const SHARP: f64 = 0.0025;
/// The cosine and sine of the golden angle, by which successive samples turn.
const TURN: [f64; 2] = [-0.737_368_878_078_319_7, 0.675_490_294_261_523_8];

/// The normals of the facets that reflect a ray or pass it on, with the distribution of Trowbridge and Reitz ("GGX"): the same for all pixels, so that
/// both images of a pair have the same blur and no noise.
pub(super) struct Lobe {
    normal: DVec3,
    width: f64,
    /// The angle by which a ray turns, by the angle of the facet.
    turn: f64,
    samples: u8,
}

/// Returns the normals of a surface with a roughness. Only what happens first to a ray blurs it. `turn` is the angle by which a ray turns, by the
/// angle of the facet: 2 for reflections.
pub(super) fn normals(normal: DVec3, roughness: f32, turn: f64, is_first: bool) -> Lobe {
    let width = f64::from(roughness * roughness);
    let is_sharp = width < SHARP || !is_first;
    Lobe {
        normal,
        width: if is_sharp { 0.0 } else { width },
        turn,
        samples: if is_sharp { 1 } else { SAMPLES },
    }
}

impl Lobe {
    /// Whether the reflection is not blurred.
    pub(super) fn is_sharp(&self) -> bool {
        self.samples == 1
    }

    /// Returns the share of one ray.
    pub(super) fn share(&self) -> f32 {
        1.0 / f32::from(self.samples)
    }

    /// Returns the normals.
    pub(super) fn iter(&self) -> impl Iterator<Item = DVec3> + '_ {
        let (u, v) = self.normal.any_orthonormal_pair();
        let mut turned = [1.0, 0.0];
        (0..self.samples).map(move |index| {
            if self.width == 0.0 {
                return self.normal;
            }
            let part = (f64::from(index) + 0.5) / f64::from(self.samples);
            let slope = self.width * (part / (1.0 - part)).sqrt();
            let [x, y] = turned;
            turned = [x * TURN[0] - y * TURN[1], x * TURN[1] + y * TURN[0]];
            (self.normal + (u * x + v * y) * slope).normalize()
        })
    }

    /// Returns the angle between the rays of the lobe, radians, from the typical slope.
    fn spacing(&self) -> f64 {
        self.turn * self.width / f64::from(self.samples).sqrt()
    }

    /// Returns the factor by which the lobe is wider than the angle between a ray and the rays of the next pixels; 1 if it is not.
    pub(super) fn widening(&self, ray: DVec3, next: [Option<DVec3>; 2]) -> f64 {
        let steps = next.iter().flatten().map(|next| (*next - ray).length());
        let pixel = steps.fold(0.0, f64::max);
        if pixel > 0.0 {
            (self.spacing() / pixel).max(1.0)
        } else {
            1.0
        }
    }

    /// Moves the ray of the next pixel away from a ray, so that the footprints of a lobe's rays are adjacent.
    pub(super) fn widened(&self, ray: DVec3, next: DVec3) -> DVec3 {
        let step = next - ray;
        let length = step.length();
        if length > 0.0 && self.spacing() > length {
            ray + step * (self.spacing() / length)
        } else {
            next
        }
    }
}
