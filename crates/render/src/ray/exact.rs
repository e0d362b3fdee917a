//! The intersection of a ray with a triangle's plane in double precision.

use oaktwin_camera::math::DVec3;

/// The plane of a triangle relative to a ray's origin: the ray meets it after `distance / direction.dot(normal)` lengths of its
/// direction.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Plane {
    pub(crate) normal: DVec3,
    pub(crate) distance: f64,
}

impl Plane {
    pub(crate) fn new(corners: [[f32; 3]; 3], origin: DVec3) -> Self {
        // Differences and products of single-precision numbers are almost exact here.
        let [a, b, c] = corners.map(|p| DVec3::from(p.map(f64::from)));
        let normal = (b - a).cross(c - a);
        Self {
            normal,
            distance: (a - origin).dot(normal),
        }
    }

    pub(crate) fn meet(&self, direction: DVec3) -> f64 {
        self.distance / direction.dot(self.normal)
    }
}
