//! A brute-force reference renderer: every ray against every triangle, in double precision.
//!
//! Shares no code with the renderer except the input types. In single precision, a pixel on the edge of a triangle may
//! belong to either side: [`Reference::explains`] tests whether a depth is one of the possible results.

use oaktwin_camera::math::{DVec2, DVec3};
use oaktwin_camera::{PixelPoint, Usd};
use oaktwin_render::{Hit, View};
use oaktwin_scene::Scene;
use rayon::prelude::*;

/// A scene's triangles in the camera frame of a view.
#[derive(Debug)]
pub struct Reference {
    view: View,
    /// In the order of the scene.
    triangles: Vec<(Hit, [DVec3; 3])>,
}

/// The first intersection of a ray with a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// The depth in metres along the optical axis.
    pub z: f64,
    /// The distance in metres to which the view's clipping range applies: along the axis, or along the ray for wide lenses.
    pub clipped_by: f64,
    /// The triangle.
    pub hit: Hit,
    /// The cosine of the angle between the ray and the triangle's normal, from 0 to 1.
    pub cos_incidence: f64,
}

/// A ray from the optical centre, scaled to the unit of the clipping range.
#[derive(Clone, Copy, Debug)]
struct Ray(DVec3);

impl Reference {
    /// Creates the reference for a scene and a view.
    ///
    /// # Panics
    /// Panics if an index is out of range.
    #[must_use]
    pub fn new(scene: &Scene, view: &View) -> Self {
        let camera_from_world = view.camera_from_world();
        let mut triangles = Vec::new();
        for (instance, placed) in (0..).zip(&scene.instances) {
            let mesh = &scene.meshes[placed.mesh as usize];
            for (triangle, corners) in (0..).zip(&mesh.triangles) {
                let hit = Hit { instance, triangle };
                let corners = corners.map(|i| {
                    let point_in_mesh = DVec3::from(mesh.positions[i as usize].map(f64::from));
                    let point_in_world = placed.world_from_mesh.transform_point3(point_in_mesh);
                    camera_from_world.transform_point3(point_in_world)
                });
                triangles.push((hit, corners));
            }
        }
        Self {
            view: *view,
            triangles,
        }
    }

    /// Returns the intersections of all pixels, row by row.
    #[must_use]
    pub fn image(&self) -> Vec<Option<Crossing>> {
        let size = self.view.camera.intrinsics.size;
        let rows = (0..size.height).into_par_iter();
        rows.flat_map_iter(|y| (0..size.width).map(move |x| self.pixel(x, y)))
            .collect()
    }

    /// Returns the intersection of a pixel's ray; `None` for a miss.
    #[must_use]
    pub fn pixel(&self, x: u32, y: u32) -> Option<Crossing> {
        self.first(self.ray(centre(x, y))?)
    }

    /// Returns whether `z` (infinite for a miss) is the depth of pixel (x, y) up to a relative error of 1e-5, or would be if
    /// edges were displaced by `slack_px`: then it is the depth of a triangle within twice the slack of the ray, and
    /// nothing that covers the whole neighbourhood is in front of it. A miss in the middle of a surface, at the
    /// seam of two triangles, is never explained.
    #[must_use]
    pub fn explains(&self, x: u32, y: u32, z: f64, slack_px: f64) -> bool {
        let Some(ray) = self.ray(centre(x, y)) else {
            return z.is_infinite();
        };
        // The maximum depth, from the intersections of nearby rays.
        let mut furthest = self.first(ray).map_or(f64::INFINITY, |crossing| crossing.z);
        for step in 0..8 {
            let offset = slack_px * DVec2::from_angle(f64::from(step) * std::f64::consts::FRAC_PI_4);
            let beside = self.ray(centre(x, y) + offset);
            let seen = beside.and_then(|beside| self.first(beside));
            // The depth of the same surface at the pixel itself.
            let depth = seen.map_or(f64::INFINITY, |seen| {
                let there = self.plane(ray, seen.hit).map_or(seen.z, |here| here.z);
                there.max(seen.z)
            });
            furthest = furthest.max(depth);
        }
        if z.is_infinite() {
            return furthest.is_infinite();
        }
        let intrinsics = &self.view.camera.intrinsics;
        let slack_rad = 2.0 * slack_px / intrinsics.fx.min(intrinsics.fy);
        let in_sight = z <= furthest * (1.0 + 1e-5);
        let is_at = |crossing: &Crossing| {
            // A surface seen edge-on has an arbitrary depth within single precision.
            let tolerance = 1e-5 + 4e-7 / crossing.cos_incidence.max(1e-6);
            (z - crossing.z).abs() <= tolerance * crossing.z.abs()
        };
        in_sight
            && self
                .triangles
                .iter()
                .filter(|(_, corners)| angle_to_triangle(ray.0, corners) <= slack_rad)
                .filter_map(|(hit, corners)| on_plane(ray, *hit, corners))
                .any(|crossing| is_at(&crossing))
    }

    /// Returns the intersection of a pixel's ray with a triangle's plane; `None` if they do not meet.
    #[must_use]
    pub fn plane_at(&self, x: u32, y: u32, hit: Hit) -> Option<Crossing> {
        self.plane(self.ray(centre(x, y))?, hit)
    }

    fn plane(&self, ray: Ray, hit: Hit) -> Option<Crossing> {
        let key = |hit: Hit| (hit.instance, hit.triangle);
        let found = self
            .triangles
            .binary_search_by_key(&key(hit), |(hit, _)| key(*hit))
            .ok()?;
        on_plane(ray, hit, &self.triangles[found].1)
    }

    fn ray(&self, pixel: DVec2) -> Option<Ray> {
        let unit = self.view.camera.unproject(PixelPoint::<Usd>::from(pixel))?;
        Some(Ray(if self.view.clips_along_axis() {
            unit / unit.z
        } else {
            unit
        }))
    }

    fn first(&self, ray: Ray) -> Option<Crossing> {
        let clip = self.view.clip;
        let mut nearest: Option<Crossing> = None;
        for (hit, corners) in &self.triangles {
            if !covers(ray.0, corners) {
                continue;
            }
            let Some(found) = on_plane(ray, *hit, corners) else {
                continue;
            };
            let is_seen = found.clipped_by >= clip.near_m && found.clipped_by <= clip.far_m;
            if is_seen && nearest.is_none_or(|nearest| found.clipped_by < nearest.clipped_by) {
                nearest = Some(found);
            }
        }
        nearest
    }
}

/// The intersection of the ray with the plane of a triangle.
fn on_plane(Ray(ray): Ray, hit: Hit, &[a, b, c]: &[DVec3; 3]) -> Option<Crossing> {
    let normal = (b - a).cross(c - a);
    let along = ray.dot(normal);
    let t = a.dot(normal) / along;
    t.is_finite().then(|| Crossing {
        z: t * ray.z,
        clipped_by: t,
        hit,
        cos_incidence: along.abs() / (normal.length() * ray.length()),
    })
}

fn centre(x: u32, y: u32) -> DVec2 {
    DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5)
}

/// Whether the line through the origin meets the triangle, including its edges: whether it is on one side of the three
/// planes through the origin and an edge. Two triangles that share an edge compute the same number for it, negated, so
/// that there is no gap between them. Where an edge points at the origin, rounding would decide, and the triangle, which is seen
/// edge-on, is not met.
fn covers(ray: DVec3, &[a, b, c]: &[DVec3; 3]) -> bool {
    let points_at_origin = |p: DVec3, q: DVec3| {
        let lengths = (p.length_squared() + q.length_squared()) * (q - p).length_squared();
        4.0 * p.cross(q).length_squared() <= 1e-24 * lengths
    };
    if points_at_origin(a, b) || points_at_origin(b, c) || points_at_origin(c, a) {
        return false;
    }
    let sides = [a.cross(b).dot(ray), b.cross(c).dot(ray), c.cross(a).dot(ray)];
    sides.iter().all(|side| *side >= 0.0) || sides.iter().all(|side| *side <= 0.0)
}

/// The angle between the ray and the solid angle covered by the triangle, radians.
fn angle_to_triangle(ray: DVec3, corners: &[DVec3; 3]) -> f64 {
    let [a, b, c] = corners;
    let ahead = (*a + *b + *c).dot(ray) > 0.0 || corners.iter().any(|corner| corner.dot(ray) > 0.0);
    if ahead && covers(ray, corners) {
        return 0.0;
    }
    let edges = [(a, b), (b, c), (c, a)];
    edges
        .map(|(p, q)| angle_to_arc(ray, *p, *q))
        .into_iter()
        .fold(f64::INFINITY, f64::min)
}

/// The angle between the ray and the arc covered by the line from `p` to `q`, radians.
fn angle_to_arc(ray: DVec3, p: DVec3, q: DVec3) -> f64 {
    let across = p.cross(q);
    let between = |v: DVec3| p.cross(v).dot(across) >= 0.0 && v.cross(q).dot(across) >= 0.0;
    let foot = ray - across * (ray.dot(across) / across.length_squared());
    if foot.is_finite() && between(foot) {
        (ray.dot(across).abs() / (ray.length() * across.length())).asin()
    } else {
        angle(ray, p).min(angle(ray, q))
    }
}

/// The angle between two directions, radians.
fn angle(p: DVec3, q: DVec3) -> f64 {
    p.cross(q).length().atan2(p.dot(q))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::{self, Kind, Lens, Random};
    use oaktwin_camera::math::DAffine3;
    use oaktwin_camera::{Camera, ImageSize, Intrinsics, LensModel, RigidTransform};
    use oaktwin_render::Clip;
    use oaktwin_scene::{Instance, Mesh};

    #[test]
    fn angles_to_an_arc() {
        let (p, q) = (DVec3::X * 3.0, DVec3::Y * 0.1);
        assert!(
            (angle_to_arc(DVec3::new(1.0, 1.0, 2f64.sqrt()), p, q) - std::f64::consts::FRAC_PI_4).abs()
                < 1e-12
        );
        assert!(angle_to_arc(DVec3::new(1.0, 2.0, 0.0), p, q).abs() < 1e-12);
        let beyond = DVec3::new(1.0, -1.0, 0.0);
        assert!((angle_to_arc(beyond, p, q) - std::f64::consts::FRAC_PI_4).abs() < 1e-12);
        // A degenerate edge acts as a point.
        assert!((angle_to_arc(DVec3::Z, p, p) - std::f64::consts::FRAC_PI_2).abs() < 1e-12);
    }

    #[test]
    fn angles_to_a_triangle() {
        let corners = [
            DVec3::new(0.0, 0.0, 1.0),
            DVec3::new(1.0, 0.0, 1.0),
            DVec3::new(0.0, 1.0, 1.0),
        ];
        assert_eq!(angle_to_triangle(DVec3::new(0.2, 0.2, 1.0), &corners), 0.0);
        let below = angle_to_triangle(DVec3::new(0.2, -0.1, 1.0), &corners);
        assert!(below > 0.05 && below < 0.1, "{below}");
        let behind = angle_to_triangle(DVec3::new(-0.2, -0.2, -1.0), &corners);
        assert!(behind > 1.0, "{behind}");
    }

    #[test]
    fn explains_differences_only_at_silhouettes() {
        let size = ImageSize::new(31, 23);
        let mut random = Random::new(5);
        let scene = random::scene(Kind::Room, &mut random);
        let view = random::view(Lens::Fisheye, size, DVec3::ZERO, &mut random);
        let reference = Reference::new(&scene, &view);
        for (i, truth) in (0..).zip(reference.image()) {
            let (x, y) = (i % size.width, i / size.width);
            if let Some(truth) = truth {
                assert!(reference.explains(x, y, truth.z, 0.01));
                assert!(!reference.explains(x, y, truth.z * 1.001, 0.01), "{truth:?}");
                assert!(
                    !reference.explains(x, y, f64::INFINITY, 0.01),
                    "a miss in a closed room"
                );
                assert!(!reference.explains(x, y, f64::NAN, 0.01));
            }
        }
    }

    #[test]
    fn both_sides_of_an_edge_are_explained() {
        // A square whose left edge passes exactly through the centres of a pixel column.
        let mesh = Mesh {
            positions: vec![
                [0.0, -9.0, 2.0],
                [9.0, -9.0, 2.0],
                [9.0, 9.0, 2.0],
                [0.0, 9.0, 2.0],
            ],
            triangles: vec![[0, 1, 2], [0, 2, 3]],
            ..Mesh::default()
        };
        let scene = Scene {
            meshes: vec![mesh],
            instances: vec![Instance {
                mesh: 0,
                path: String::new(),
                world_from_mesh: DAffine3::IDENTITY,
                labels: Vec::new(),
                material_offset: 0,
            }],
            ..Scene::default()
        };
        let intrinsics = Intrinsics::from_hfov(ImageSize::new(21, 21), 1.0);
        let view = View {
            camera: Camera::new(intrinsics, LensModel::Pinhole),
            world_from_camera: RigidTransform::IDENTITY,
            clip: Clip::default(),
        };
        let reference = Reference::new(&scene, &view);
        assert!(reference.explains(10, 7, 2.0, 0.01) && reference.explains(10, 7, f64::INFINITY, 0.01));
        assert!(!reference.explains(9, 7, 2.0, 0.01) && !reference.explains(11, 7, f64::INFINITY, 0.01));
        assert_eq!(
            reference.pixel(11, 7).map(|c| (c.z, c.cos_incidence < 1.0)),
            Some((2.0, true))
        );
    }
}
