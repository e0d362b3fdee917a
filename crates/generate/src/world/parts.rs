//! Convex parts of objects, with which their motion is computed.

use oaktwin_camera::math::DVec3;
use parry3d_f64::math::{Pose, Vector};
use parry3d_f64::shape::{ConvexPolyhedron, SharedShape};
use parry3d_f64::transformation::vhacd::{VHACD, VHACDParameters};
use parry3d_f64::transformation::voxelization::VoxelSet;

use super::hull::{Hull, from_parry, outermost, to_parry};
use super::triangles::Triangles;

/// The number of voxels along the longest edge of an object.
const RESOLUTION: u32 = 64;

/// The maximum volume between a part and its convex hull, relative to the hull of the object.
const CONCAVITY: f64 = 0.005;

/// The maximum number of parts.
const MAX_PARTS: u32 = 64;

/// The maximum number of corners of a part.
const MAX_CORNERS: usize = 64;

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
        // Voxels are found in single steps of their size, so that the numbers have to be of a common magnitude.
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

    /// The number of parts.
    #[cfg(test)]
    pub(crate) fn count(&self) -> usize {
        self.0.len()
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

/// Returns the hull of the surface within some voxels.
fn part(
    voxels: &VoxelSet,
    points: &[Vector],
    corners: &[[u32; 3]],
    center: DVec3,
    size: f64,
) -> Option<ConvexPolyhedron> {
    let hull_of = |points: Vec<Vector>| {
        let points: Vec<DVec3> = points.into_iter().map(from_parry).collect();
        let middle = points.iter().sum::<DVec3>() / f64::max(points.len() as f64, 1.0);
        let points = outermost(&points, middle, MAX_CORNERS);
        let points: Vec<Vector> = (points.into_iter())
            .map(|point| to_parry(center + point * size))
            .collect();
        ConvexPolyhedron::from_convex_hull(&points)
    };
    let exact = hull_of(voxels.compute_primitive_intersections(points, corners));
    // A piece of a surface may be flat, but voxels never are.
    exact.or_else(|| hull_of(voxels.compute_convex_hull(1).0))
}
