//! The pixels that an instance covers, regardless of occlusion.

use oaktwin_camera::math::{DAffine3, DVec3};
use oaktwin_camera::{LensModel, Usd};
use oaktwin_scene::Scene;

use super::stencil::Stencil;
use crate::cutout::{Cutouts, Transparent};
use crate::rays::Rays;
use crate::{Hit, View};

/// The angle in radians below which an edge counts as straight in the image of a lens.
const FLAT: f64 = 0.05;
/// How many times a triangle is subdivided at most.
const MAX_SUBDIVISIONS: u32 = 10;

/// The coverage test of a view.
pub(super) struct Coverage<'a> {
    view: &'a View,
    rays: &'a Rays<'a>,
    cutouts: Option<&'a Cutouts>,
    camera_from_world: DAffine3,
}

/// A triangle in the camera frame.
struct Triangle<'a> {
    corners: [DVec3; 3],
    /// The normals of the planes through the origin and each edge.
    sides: [DVec3; 3],
    normal: DVec3,
    /// Decides which parts are invisible, if any may be.
    hole: Option<Hole<'a>>,
}

/// A triangle of a scene with a mask.
struct Hole<'a> {
    cutouts: &'a Cutouts,
    scene: &'a Scene,
    hit: Hit,
}

impl<'a> Coverage<'a> {
    pub(super) fn new(view: &'a View, rays: &'a Rays<'a>, cutouts: Option<&'a Cutouts>) -> Self {
        Self {
            view,
            rays,
            cutouts,
            camera_from_world: view.camera_from_world(),
        }
    }

    /// Adds the pixels that an instance covers.
    pub(super) fn add_instance(&self, scene: &Scene, instance: u32, stencil: &mut Stencil) {
        let Some(placed) = scene.instances.get(instance as usize) else {
            return;
        };
        let Some(mesh) = scene.meshes.get(placed.mesh as usize) else {
            return;
        };
        let camera_from_mesh = self.camera_from_world * placed.world_from_mesh;
        let cutouts = (self.cutouts).filter(|cutouts| cutouts.cut_instance(scene, instance));
        for (index, triangle) in (0..mesh.triangles.len()).zip(0_u32..) {
            if let Some(corners) = mesh.corners(index) {
                let corners =
                    corners.map(|p| camera_from_mesh.transform_point3(DVec3::from(p.map(f64::from))));
                let hole = cutouts.map(|cutouts| Hole {
                    cutouts,
                    scene,
                    hit: Hit { instance, triangle },
                });
                self.add_triangle(corners, hole, stencil);
            }
        }
    }

    fn add_triangle(&self, corners: [DVec3; 3], hole: Option<Hole<'_>>, stencil: &mut Stencil) {
        let [a, b, c] = corners;
        let along_axis = self.rays.are_along_axis();
        let distance = |p: DVec3| if along_axis { p.z } else { p.length() };
        let (near, far) = (self.view.clip.near_m, self.view.clip.far_m);
        let distances = corners.map(distance);
        // A triangle with all corners beyond the far distance may still reach into the sphere of that radius.
        let hidden = if along_axis {
            distances.iter().all(|d| *d < near) || distances.iter().all(|d| *d > far)
        } else {
            distances.iter().all(|d| *d < near)
        };
        if hidden || !corners.iter().all(|p| p.is_finite()) {
            return;
        }
        let triangle = Triangle {
            corners,
            sides: [(a, b), (b, c), (c, a)].map(|(p, q)| (p + q).cross(q - p)),
            normal: (b - a).cross(c - a),
            hole,
        };
        if self.view.camera.lens == LensModel::Pinhole {
            let clipped = in_front(corners, near);
            let points = clipped.iter().filter_map(|p| self.project(*p));
            self.add_box(&triangle, points, 1e-6, stencil);
        } else {
            self.add_piece(&triangle, corners, MAX_SUBDIVISIONS, stencil);
        }
    }

    /// Subdivides a triangle until its edges are nearly straight in the image.
    fn add_piece(
        &self,
        triangle: &Triangle<'_>,
        piece: [DVec3; 3],
        subdivisions: u32,
        stencil: &mut Stencil,
    ) {
        let [a, b, c] = piece;
        let is_small = [(a, b), (b, c), (c, a)]
            .iter()
            .all(|(p, q)| p.angle_between(*q) <= FLAT);
        let pixels = piece.map(|p| self.project(p));
        let seen = pixels.iter().flatten().count();
        if is_small && (seen == 0 || seen == 3) || subdivisions == 0 {
            self.add_box(triangle, pixels.into_iter().flatten(), 1.0, stencil);
            return;
        }
        let [ab, bc, ca] = [a.midpoint(b), b.midpoint(c), c.midpoint(a)];
        for quarter in [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]] {
            self.add_piece(triangle, quarter, subdivisions - 1, stencil);
        }
    }

    /// Tests each pixel in the bounding box of image points, enlarged by `margin` pixels.
    fn add_box(
        &self,
        triangle: &Triangle<'_>,
        points: impl Iterator<Item = [f64; 2]>,
        margin: f64,
        stencil: &mut Stencil,
    ) {
        let mut low = [f64::INFINITY; 2];
        let mut high = [f64::NEG_INFINITY; 2];
        for point in points {
            for axis in 0..2 {
                low[axis] = low[axis].min(point[axis]);
                high[axis] = high[axis].max(point[axis]);
            }
        }
        let size = self.view.camera.intrinsics.size;
        let x = centres(low[0] - margin, high[0] + margin, size.width);
        let y = centres(low[1] - margin, high[1] + margin, size.height);
        for y in y {
            for x in x.clone() {
                if !stencil.has(x, y) && self.is_seen(triangle, x, y) {
                    stencil.insert(x, y);
                }
            }
        }
    }

    fn is_seen(&self, triangle: &Triangle<'_>, x: u32, y: u32) -> bool {
        let Some(ray) = self.rays.centre(x, y) else {
            return false;
        };
        let sides = triangle.sides.map(|side| ray.dot(side));
        if !(sides.iter().all(|s| *s >= 0.0) || sides.iter().all(|s| *s <= 0.0)) {
            return false;
        }
        let t = triangle.corners[0].dot(triangle.normal) / ray.dot(triangle.normal);
        (self.view.clip.near_m..=self.view.clip.far_m).contains(&t)
            && triangle.hole.as_ref().is_none_or(|hole| {
                let pose = &self.view.world_from_camera;
                let Hole { cutouts, scene, hit } = *hole;
                cutouts.shows(
                    scene,
                    hit,
                    pose.translation,
                    pose.rotation * ray,
                    Transparent::Surface,
                )
            })
    }

    fn project(&self, point: DVec3) -> Option<[f64; 2]> {
        let pixel = self.view.camera.project(point)?.to::<Usd>();
        Some([pixel.x, pixel.y])
    }
}

/// The pixels whose centres lie between two coordinates.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "clamped to the image first"
)]
fn centres(low: f64, high: f64, count: u32) -> std::ops::Range<u32> {
    let first = (low - 0.5).ceil().clamp(0.0, f64::from(count));
    let end = ((high - 0.5).floor() + 1.0).clamp(0.0, f64::from(count));
    // Without points the box is inverted.
    if first < end {
        first as u32..end as u32
    } else {
        0..0
    }
}

/// Clips a triangle at the near plane.
fn in_front(corners: [DVec3; 3], near: f64) -> Vec<DVec3> {
    if corners.iter().all(|p| p.z >= near) {
        return corners.to_vec();
    }
    let mut kept = Vec::with_capacity(4);
    for (p, q) in [(0, 1), (1, 2), (2, 0)].map(|(i, j)| (corners[i], corners[j])) {
        if p.z >= near {
            kept.push(p);
        }
        if (p.z >= near) != (q.z >= near) {
            kept.push(p.lerp(q, (near - p.z) / (q.z - p.z)));
        }
    }
    kept
}
