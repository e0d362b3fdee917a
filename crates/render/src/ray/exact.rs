//! Rays and triangles in double precision.

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

/// The square of the sine of the angle between an edge and the direction to it below which not even double precision knows on which
/// side of it a ray passes.
const DEGENERATE: f64 = 1e-24;

/// Returns the normal of the plane through the origin and an edge, with [`super::vector::Vector::side`]'s length and sign; `None` if
/// the edge points at the origin.
pub(crate) fn side(p: DVec3, q: DVec3) -> Option<DVec3> {
    let side = (p + q).cross(q - p);
    (side.length_squared() > DEGENERATE * lengths(p, q)).then_some(side)
}

fn lengths(p: DVec3, q: DVec3) -> f64 {
    (p.length_squared() + q.length_squared()) * (q - p).length_squared()
}

/// A triangle relative to a ray's origin.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Triangle([DVec3; 3]);

impl Triangle {
    pub(crate) fn new(corners: [[f32; 3]; 3], origin: DVec3) -> Self {
        Self(corners.map(|p| DVec3::from(p.map(f64::from)) - origin))
    }

    /// Whether an edge points at the origin within the angle whose square is `limit`. Such triangles are seen edge-on.
    pub(crate) fn is_needle(&self, plane: &Plane, limit: f64) -> bool {
        let [a, b, c] = self.0;
        let farthest = (a.length_squared().max(b.length_squared())).max(c.length_squared());
        plane.distance * plane.distance <= limit * farthest * plane.normal.length_squared()
            && [(a, b), (b, c), (c, a)]
                .into_iter()
                .any(|(p, q)| (p + q).cross(q - p).length_squared() <= limit * lengths(p, q))
    }

    /// Whether the line through the origin meets the triangle, its edges included.
    pub(crate) fn is_met(&self, direction: DVec3) -> bool {
        let [a, b, c] = self.0;
        let (Some(ab), Some(bc), Some(ca)) = (side(a, b), side(b, c), side(c, a)) else {
            return false;
        };
        let sides = [ab, bc, ca].map(|side| side.dot(direction));
        sides.iter().all(|side| *side >= 0.0) || sides.iter().all(|side| *side <= 0.0)
    }
}
