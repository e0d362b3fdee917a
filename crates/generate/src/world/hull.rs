use oaktwin_camera::RigidTransform;
use oaktwin_camera::math::{DMat3, DQuat, DVec3};
use oaktwin_scene::Bounds;
use parry3d_f64::math::{Pose, Rotation, Vector};
use parry3d_f64::query::PointQuery;
use parry3d_f64::shape::ConvexPolyhedron;

/// The maximum number of corners of a hull.
const MAX_CORNERS: usize = 512;

/// The thickness of the hulls of flat objects, relative to their size.
const MIN_THICKNESS: f64 = 1e-3;

/// The convex hull of an object, with which collisions are found.
///
/// A hull of more than 512 corners is replaced by the hull of the 512 outermost points in as many directions, which is enlarged so
/// that it contains a sphere of the same size.
#[derive(Clone, Debug)]
pub(crate) struct Hull {
    pub(crate) shape: ConvexPolyhedron,
    /// The centre of its bounding box.
    pub(crate) center: DVec3,
    /// The downward directions in which it is stable on a plane, with the areas of the faces.
    pub(crate) rests: Vec<(DVec3, f64)>,
}

impl Hull {
    /// Creates the hull of points; `None` if they all coincide.
    pub(crate) fn new(points: &[DVec3]) -> Option<Self> {
        let bounds = points
            .iter()
            .map(|point| Bounds::of(*point))
            .reduce(Bounds::union)?;
        let size = bounds.size().length();
        if !(size > 0.0 && size.is_finite()) {
            return None;
        }
        let thinnest = bounds.size().min_element();
        let shape = (thinnest > MIN_THICKNESS * size)
            .then(|| ConvexPolyhedron::from_convex_hull(&corners(points, bounds)))
            .flatten();
        let shape = shape.or_else(|| ConvexPolyhedron::from_convex_hull(&boxed(bounds, size)))?;
        let rests = rests(&shape, bounds.center());
        Some(Self {
            shape,
            center: bounds.center(),
            rests,
        })
    }

    /// The corners.
    pub(crate) fn corners(&self) -> impl Iterator<Item = DVec3> {
        self.shape.points().iter().map(|point| from_parry(*point))
    }

    /// Returns the distance of a point from the hull, 0 inside.
    pub(crate) fn distance(&self, point: DVec3) -> f64 {
        self.shape.distance_to_local_point(to_parry(point), true)
    }

    /// Returns the length of the diagonal of its bounding box.
    pub(crate) fn size(&self) -> f64 {
        self.edges().length()
    }

    /// Returns the longest edge of its box, whose edges are parallel to the axes.
    pub(crate) fn longest_edge(&self) -> f64 {
        self.edges().max_element()
    }

    /// Returns the edges of its bounding box.
    fn edges(&self) -> DVec3 {
        let bounds = self.corners().map(Bounds::of).reduce(Bounds::union);
        bounds.map_or(DVec3::ZERO, Bounds::size)
    }

    /// Returns the area of its surface.
    pub(super) fn area(&self) -> f64 {
        Face::all(&self.shape).map(|face| face.area()).sum()
    }

    /// Returns the unit normals of its faces, outwards, and the heights of the faces along them.
    pub(super) fn planes(&self) -> Vec<(DVec3, f64)> {
        let faces = Face::all(&self.shape);
        let plane = |face: Face| Some((face.normal, face.normal.dot(*face.ring.first()?)));
        faces.filter_map(plane).collect()
    }

    /// Returns the hull of the object at another scale.
    pub(crate) fn scaled(&self, scale: f64) -> Option<Self> {
        if scale == 1.0 {
            return Some(self.clone());
        }
        Some(Self {
            shape: self.shape.clone().scaled(Vector::splat(scale))?,
            center: self.center * scale,
            rests: self.rests.clone(),
        })
    }
}

pub(crate) fn to_parry(vector: DVec3) -> Vector {
    Vector::from_array(vector.to_array())
}

pub(crate) fn from_parry(vector: Vector) -> DVec3 {
    DVec3::from_array(vector.to_array())
}

pub(crate) fn pose_to_parry(pose: &RigidTransform) -> Pose {
    let [x, y, z, w] = DQuat::from_mat3(&pose.rotation).normalize().to_array();
    Pose::from_parts(to_parry(pose.translation), Rotation::from_xyzw(x, y, z, w))
}

pub(crate) fn pose_from_parry(pose: &Pose) -> RigidTransform {
    let [x, y, z, w] = pose.rotation.to_array();
    let rotation = DMat3::from_quat(DQuat::from_xyzw(x, y, z, w).normalize());
    RigidTransform::new(rotation, from_parry(pose.translation))
}

/// The corners of the hull of some points, as many as a hull may have.
fn corners(points: &[DVec3], bounds: Bounds) -> Vec<Vector> {
    let kept = outermost(points, bounds.center(), MAX_CORNERS);
    // A sphere lies outside the hull of points on it by 1/cos of half the angle between neighbouring directions.
    let enlarged = 1.0031;
    let factor = if points.len() > MAX_CORNERS && kept.len() > MAX_CORNERS / 2 {
        enlarged
    } else {
        1.0
    };
    let moved = |point: DVec3| bounds.center() + (point - bounds.center()) * factor;
    kept.into_iter().map(|point| to_parry(moved(point))).collect()
}

/// Returns the points that are the outermost ones in `count` directions from a center, or all if there are no more than that.
pub(super) fn outermost(points: &[DVec3], center: DVec3, count: usize) -> Vec<DVec3> {
    if points.len() <= count {
        return points.to_vec();
    }
    let mut outermost = vec![(f64::NEG_INFINITY, center); count];
    let directions: Vec<DVec3> = (0..count).map(|index| direction(index, count)).collect();
    for point in points {
        let from_center = *point - center;
        for ((most, kept), direction) in outermost.iter_mut().zip(&directions) {
            let reach = from_center.dot(*direction);
            if reach > *most {
                (*most, *kept) = (reach, *point);
            }
        }
    }
    let mut kept: Vec<DVec3> = outermost.into_iter().map(|(_, point)| point).collect();
    kept.sort_by(|a, b| {
        (a.x, a.y, a.z)
            .partial_cmp(&(b.x, b.y, b.z))
            .unwrap_or(std::cmp::Ordering::Equal)
    });
    kept.dedup();
    kept
}

/// One of `count` directions that are spread evenly over the sphere, in a Fibonacci spiral.
#[expect(clippy::cast_precision_loss, reason = "a small index")]
fn direction(index: usize, count: usize) -> DVec3 {
    let z = 1.0 - (2.0 * index as f64 + 1.0) / count as f64;
    let angle = index as f64 * 2.399_963_229_728_653;
    let radius = libm::sqrt(1.0 - z * z);
    DVec3::new(radius * libm::cos(angle), radius * libm::sin(angle), z)
}

/// The corners of a bounding box that is not flat.
fn boxed(bounds: Bounds, size: f64) -> Vec<Vector> {
    let half = (bounds.size() / 2.0).max(DVec3::splat(MIN_THICKNESS * size / 2.0));
    let sign = |corner: u32, axis: u32| if corner >> axis & 1 == 0 { -1.0 } else { 1.0 };
    (0..8)
        .map(|corner| DVec3::new(sign(corner, 0), sign(corner, 1), sign(corner, 2)))
        .map(|signs| to_parry(bounds.center() + signs * half))
        .collect()
}

/// A face of a hull.
struct Face {
    /// The unit normal, outwards.
    normal: DVec3,
    ring: Vec<DVec3>,
}

impl Face {
    fn all(shape: &ConvexPolyhedron) -> impl Iterator<Item = Self> {
        shape.faces().iter().map(|face| {
            let first = face.first_vertex_or_edge as usize;
            let ring = &shape.vertices_adj_to_face()[first..first + face.num_vertices_or_edges as usize];
            let points = ring
                .iter()
                .map(|vertex| from_parry(shape.points()[*vertex as usize]));
            Self {
                normal: from_parry(face.normal),
                ring: points.collect(),
            }
        })
    }

    fn edges(&self) -> impl Iterator<Item = (DVec3, DVec3)> {
        let next = self.ring.iter().cycle().skip(1);
        self.ring.iter().zip(next).map(|(a, b)| (*a, *b))
    }

    fn area(&self) -> f64 {
        let doubled = self.edges().map(|(a, b)| a.cross(b)).sum::<DVec3>();
        0.5 * doubled.dot(self.normal).abs()
    }
}

/// Finds the faces over which the centre of the box lies.
fn rests(shape: &ConvexPolyhedron, center: DVec3) -> Vec<(DVec3, f64)> {
    let mut rests: Vec<(DVec3, f64)> = Vec::new();
    for face in Face::all(shape) {
        let area = face.area();
        let sides = || {
            let edges = face.edges();
            edges.map(|(a, b)| (b - a).cross(center - a).dot(face.normal))
        };
        let is_above = sides().all(|side| side >= 0.0) || sides().all(|side| side <= 0.0);
        if is_above && area > 0.0 {
            rests.push((face.normal, area));
        }
    }
    rests
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cube() -> Vec<DVec3> {
        let bounds = Bounds {
            min: DVec3::ZERO,
            max: DVec3::new(1.0, 2.0, 3.0),
        };
        boxed(bounds, 1.0).into_iter().map(from_parry).collect()
    }

    #[test]
    fn a_box_rests_on_its_six_faces() {
        let hull = Hull::new(&cube()).unwrap();
        assert_eq!(hull.center, DVec3::new(0.5, 1.0, 1.5));
        let mut areas: Vec<f64> = hull.rests.iter().map(|(_, area)| *area).collect();
        areas.sort_by(f64::total_cmp);
        assert_eq!(areas, [2.0, 2.0, 3.0, 3.0, 6.0, 6.0]);
    }

    #[test]
    fn flat_and_dense_objects_have_a_hull() {
        let flat: Vec<DVec3> = cube()
            .into_iter()
            .map(|point| point * DVec3::new(1.0, 1.0, 0.0))
            .collect();
        assert!(Hull::new(&flat).is_some());
        assert!(Hull::new(&[DVec3::ONE; 5]).is_none());
        let sphere: Vec<DVec3> = (0..MAX_CORNERS * 4)
            .map(|i| direction(i % MAX_CORNERS, MAX_CORNERS))
            .collect();
        let dense = Hull::new(&sphere).unwrap();
        assert!(dense.corners().count() <= MAX_CORNERS);
        assert!(
            dense
                .corners()
                .all(|corner| (1.0..1.01).contains(&corner.length()))
        );
    }
}
