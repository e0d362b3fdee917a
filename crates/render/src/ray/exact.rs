//! One ray and one triangle in double precision.

use oaktwin_camera::math::DVec3;

/// The plane of a triangle as a ray's origin sees it: a ray that starts there meets it after
/// `distance / direction.dot(normal)` lengths of its direction.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Plane {
    pub(crate) normal: DVec3,
    pub(crate) distance: f64,
}

impl Plane {
    pub(crate) fn new(corners: [[f32; 3]; 3], origin: DVec3) -> Self {
        // Differences and products of single-precision numbers are all but exact here.
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
