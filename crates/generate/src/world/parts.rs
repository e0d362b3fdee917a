//! Convex parts of objects, with which their motion is computed.

use oaktwin_camera::math::DVec3;
use oaktwin_scene::Bounds;
use parry3d_f64::math::{Pose, Vector};
use parry3d_f64::shape::{ConvexPolyhedron, SharedShape};
use parry3d_f64::transformation::vhacd::{VHACD, VHACDParameters};
use parry3d_f64::transformation::voxelization::VoxelSet;

use super::hull::{Hull, from_parry, outermost, to_parry};
use super::triangles::Triangles;

/// The number of voxels along the longest edge of an object.
const RESOLUTION: u32 = 64;

/// The maximum volume between a part and its convex hull, relative to the hull of the object.
const CONCAVITY: f64 = 0.003;

/// The maximum number of parts.
const MAX_PARTS: u32 = 64;

/// The maximum number of corners of a part.
const MAX_CORNERS: usize = 128;

/// The corners of a cube.
const CORNERS: [[f64; 3]; 8] = [
    [-1.0, -1.0, -1.0],
    [1.0, -1.0, -1.0],
    [-1.0, 1.0, -1.0],
    [1.0, 1.0, -1.0],
    [-1.0, -1.0, 1.0],
    [1.0, -1.0, 1.0],
    [-1.0, 1.0, 1.0],
    [1.0, 1.0, 1.0],
];

/// The maximum depth of a vertex of a convex object below its hull, relative to the object's size.
const MAX_DEPTH: f64 = 0.01;

/// The minimum area of a convex object, relative to its hull.
const MIN_AREA: f64 = 0.95;

/// The maximum number of vertices whose depth is examined.
const MAX_EXAMINED: usize = 4096;

/// An object as a union of convex parts.
#[derive(Debug)]
pub(crate) struct Parts(Vec<ConvexPolyhedron>);

impl Parts {
    /// Divides an object into convex parts: its hull if it is nearly convex.
    pub(super) fn new(object: &Triangles, hull: &Hull) -> Self {
        if is_convex(object, hull) {
            return Self(vec![hull.shape.clone()]);
        }
        let size = hull.size();
        // Tiny and huge objects are divided like others.
        let points: Vec<Vector> = (object.points.iter())
            .map(|point| to_parry((*point - hull.center) / size))
            .collect();
        let parameters = VHACDParameters {
            resolution: RESOLUTION,
            concavity: CONCAVITY,
            max_convex_hulls: MAX_PARTS,
            ..VHACDParameters::default()
        };
        let decomposition = VHACD::decompose(&parameters, &points, &object.corners, true);
        let parts = decomposition.voxel_parts().iter();
        let parts = parts.filter_map(|voxels| part(voxels, &points, &object.corners, hull.center, size));
        let parts: Vec<ConvexPolyhedron> = parts.collect();
        match parts.is_empty() {
            true => Self(vec![hull.shape.clone()]),
            false => Self(parts),
        }
    }

    /// Returns the shape of the object at another scale; `None` if it would have no volume.
    pub(crate) fn shape(&self, scale: f64) -> Option<SharedShape> {
        let parts = self.0.iter().map(|part| {
            let part = part.clone().scaled(Vector::splat(scale))?;
            Some((Pose::identity(), SharedShape::new(part)))
        });
        let mut parts = parts.collect::<Option<Vec<_>>>()?;
        match parts.len() {
            1 => parts.pop().map(|(_, shape)| shape),
            _ => Some(SharedShape::compound(parts)),
        }
    }
}

/// Whether an object fills its hull: its vertices lie on the hull, and its surface is as large as the hull's.
fn is_convex(object: &Triangles, hull: &Hull) -> bool {
    let planes = hull.planes();
    let area: f64 = hull.area();
    let limit = MAX_DEPTH * hull.size();
    let step = object.corners.len().div_ceil(MAX_EXAMINED).max(1);
    let examined = object.corners.iter().step_by(step).flatten();
    let mut depths = examined.map(|index| {
        let point = object.points[*index as usize];
        let heights = planes.iter().map(|(normal, height)| height - normal.dot(point));
        heights.fold(f64::INFINITY, f64::min)
    });
    object.area() >= MIN_AREA * area && depths.all(|depth| depth <= limit)
}

/// Returns the hull of the surface within some voxels, and of the voxels inside the object.
fn part(
    voxels: &VoxelSet,
    points: &[Vector],
    corners: &[[u32; 3]],
    center: DVec3,
    size: f64,
) -> Option<ConvexPolyhedron> {
    let hull_of = |points: Vec<Vector>| {
        let points: Vec<DVec3> = points.into_iter().map(from_parry).collect();
        let bounds = points.iter().copied().map(Bounds::of).reduce(Bounds::union)?;
        let points = outermost(&points, bounds.center(), MAX_CORNERS);
        let points: Vec<Vector> = (points.into_iter())
            .map(|point| to_parry(center + point * size))
            .collect();
        ConvexPolyhedron::from_convex_hull(&points)
    };
    let mut solid = voxels.compute_primitive_intersections(points, corners);
    let inside = voxels.voxels().iter().filter(|voxel| !voxel.is_on_surface);
    for voxel in inside {
        let center = voxels.get_voxel_point(voxel);
        solid.extend(CORNERS.map(|sign| center + Vector::from_array(sign) * (voxels.scale / 2.0)));
    }
    let exact = hull_of(solid);
    // A piece of a surface may be flat, but voxels never are.
    exact.or_else(|| hull_of(voxels.compute_convex_hull(1).0))
}

#[cfg(test)]
mod tests {
    use parry3d_f64::query::PointQuery;
    use parry3d_f64::shape::Shape;

    use super::*;

    /// A surface of revolution around z with 24 sides, from radii and heights.
    #[expect(clippy::cast_possible_truncation, reason = "a few points")]
    fn turned(profile: &[[f64; 2]]) -> Triangles {
        const SIDES: u32 = 24;
        let mut object = Triangles::default();
        for [radius, height] in profile {
            object.points.extend((0..SIDES).map(|side| {
                let angle = std::f64::consts::TAU * f64::from(side) / f64::from(SIDES);
                DVec3::new(radius * libm::cos(angle), radius * libm::sin(angle), *height)
            }));
        }
        for row in 0..profile.len() as u32 - 1 {
            for side in 0..SIDES {
                let (a, b) = (row * SIDES + side, row * SIDES + (side + 1) % SIDES);
                object
                    .corners
                    .extend([[a, b, b + SIDES], [a, b + SIDES, a + SIDES]]);
            }
        }
        object
    }

    fn parts(object: &Triangles) -> Parts {
        Parts::new(object, &Hull::new(&object.points).unwrap())
    }

    #[test]
    fn a_can_is_one_part() {
        let can = turned(&[[0.0, 0.0], [0.03, 0.0], [0.03, 0.1], [0.0, 0.1]]);
        assert_eq!(parts(&can).0.len(), 1);
    }

    #[test]
    fn a_cup_is_hollow() {
        let cup = [
            [0.0, 0.0],
            [0.04, 0.0],
            [0.04, 0.1],
            [0.036, 0.1],
            [0.036, 0.008],
            [0.0, 0.008],
        ];
        let parts = parts(&turned(&cup));
        assert!((8..=64).contains(&parts.0.len()), "{}", parts.0.len());
        let distance = |point: [f64; 3]| {
            let point = Vector::from_array(point);
            let distances = parts
                .0
                .iter()
                .map(|part| part.distance_to_local_point(point, true));
            distances.fold(f64::INFINITY, f64::min)
        };
        for point in [
            [0.0, 0.0, 0.05],
            [0.033, 0.0, 0.05],
            [0.0, 0.03, 0.09],
            [0.02, -0.02, 0.012],
        ] {
            assert!(distance(point) > 1e-3, "{point:?}");
        }
        for point in [
            [0.038, 0.0, 0.05],
            [0.0, -0.038, 0.098],
            [0.02, 0.0, 0.004],
            [0.0, 0.0, 0.004],
        ] {
            assert!(distance(point) < 1e-4, "{point:?}");
        }
    }

    #[test]
    fn parts_cover_the_surface() {
        let cup = turned(&[
            [0.0, -0.035],
            [0.035, -0.035],
            [0.04, 0.035],
            [0.035, 0.035],
            [0.03, -0.028],
            [0.0, -0.028],
        ]);
        let parts = parts(&cup);
        let mut worst: f64 = 0.0;
        for corners in &cup.corners {
            let [a, b, c] = corners.map(|index| cup.points[index as usize]);
            for point in [a, (a + b) / 2.0, (a + b + c) / 3.0, (b + c) / 2.0, (a + c) / 2.0] {
                let distances = parts.0.iter();
                let distances = distances.map(|part| part.distance_to_local_point(to_parry(point), true));
                worst = worst.max(distances.fold(f64::INFINITY, f64::min));
            }
        }
        assert!(worst < 2e-4, "{worst}");
        // The cup has 9.9e-5 m³, and its hull three times as much. Parts overlap.
        let volume: f64 = parts
            .0
            .iter()
            .map(|part| Shape::mass_properties(part, 1.0).mass())
            .sum();
        assert!((9e-5..1.4e-4).contains(&volume), "{volume} {}", parts.0.len());
    }

    #[test]
    fn a_sheet_without_thickness_is_hollow() {
        let tube = turned(&[[0.04, 0.0], [0.04, 0.1]]);
        let parts = parts(&tube);
        let inside = |part: &ConvexPolyhedron| part.contains_local_point(Vector::new(0.0, 0.0, 0.05));
        assert!(
            parts.0.len() > 4 && !parts.0.iter().any(inside),
            "{}",
            parts.0.len()
        );
    }
}
