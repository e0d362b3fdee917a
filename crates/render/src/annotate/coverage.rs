//! Which pixels see a thing when nothing else is there.

use oaktwin_camera::math::{DAffine3, DVec3};
use oaktwin_camera::{PixelPoint, Usd};
use oaktwin_image::Image;
use oaktwin_scene::Scene;
use rayon::prelude::*;

use super::stencil::Stencil;
use super::surface::ray_in_camera;
use crate::View;

/// A piece of a triangle is as good as flat in the image of a lens when it is this small, radians.
const FLAT: f64 = 0.05;
/// How often a triangle is quartered at most to become that small.
const MOST_QUARTERINGS: u32 = 10;

/// The rays of a view, ready for many triangles.
pub(super) struct Coverage<'a> {
    view: &'a View,
    along_axis: bool,
    camera_from_world: DAffine3,
    /// Where there is a lens, the ray of each pixel: the same that the view is rendered with.
    rays: Option<Image<DVec3>>,
}

/// A triangle in the camera's frame.
struct Triangle {
    corners: [DVec3; 3],
    /// The normals of the sides of the origin's pyramid over it.
    sides: [DVec3; 3],
    normal: DVec3,
}

impl<'a> Coverage<'a> {
    pub(super) fn new(view: &'a View) -> Self {
        let size = view.camera.intrinsics.size;
        let along_axis = view.clips_along_axis();
        let rays = (!is_pinhole(view)).then(|| {
            let mut rays = Image::filled(size.width, size.height, DVec3::NAN);
            let row_length = (size.width as usize).max(1);
            let rows = rays.pixels_mut().par_chunks_mut(row_length);
            rows.zip(0..size.height).for_each(|(row, y)| {
                for (ray, x) in row.iter_mut().zip(0..) {
                    let unit = ray_in_camera(view, x, y).unwrap_or(DVec3::NAN);
                    *ray = if along_axis { unit / unit.z } else { unit };
                }
            });
            rays
        });
        Self {
            view,
            along_axis,
            camera_from_world: view.camera_from_world(),
            rays,
        }
    }

    /// Adds the pixels that see an instance.
    pub(super) fn add_instance(&self, scene: &Scene, instance: u32, stencil: &mut Stencil) {
        let Some(placed) = scene.instances.get(instance as usize) else {
            return;
        };
        let Some(mesh) = scene.meshes.get(placed.mesh as usize) else {
            return;
        };
        let camera_from_mesh = self.camera_from_world * placed.world_from_mesh;
        for triangle in 0..mesh.triangles.len() {
            if let Some(corners) = mesh.corners(triangle) {
                let corners =
                    corners.map(|p| camera_from_mesh.transform_point3(DVec3::from(p.map(f64::from))));
                self.add_triangle(corners, stencil);
            }
        }
    }

    fn add_triangle(&self, corners: [DVec3; 3], stencil: &mut Stencil) {
        let [a, b, c] = corners;
        let distance = |p: DVec3| if self.along_axis { p.z } else { p.length() };
        let (near, far) = (self.view.clip.near_m, self.view.clip.far_m);
        let distances = corners.map(distance);
        // A ball around the camera may be touched by a triangle whose corners are outside, but not the other way round.
        let hidden = if self.along_axis {
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
        };
        if self.rays.is_some() {
            self.add_piece(&triangle, corners, MOST_QUARTERINGS, stencil);
        } else {
            let clipped = in_front(corners, near);
            let points = clipped.iter().filter_map(|p| self.project(*p));
            self.add_box(&triangle, points, 1e-6, stencil);
        }
    }

    /// Quarters a triangle until its image hardly differs from that of its corners.
    fn add_piece(&self, triangle: &Triangle, piece: [DVec3; 3], quarterings: u32, stencil: &mut Stencil) {
        let [a, b, c] = piece;
        let is_small = [(a, b), (b, c), (c, a)]
            .iter()
            .all(|(p, q)| p.angle_between(*q) <= FLAT);
        let pixels = piece.map(|p| self.project(p));
        let seen = pixels.iter().flatten().count();
        if is_small && (seen == 0 || seen == 3) || quarterings == 0 {
            self.add_box(triangle, pixels.into_iter().flatten(), 1.0, stencil);
            return;
        }
        let [ab, bc, ca] = [a.midpoint(b), b.midpoint(c), c.midpoint(a)];
        for quarter in [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]] {
            self.add_piece(triangle, quarter, quarterings - 1, stencil);
        }
    }

    /// Tries each pixel of the box around some points of the image, `margin` pixels wider.
    fn add_box(
        &self,
        triangle: &Triangle,
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

    fn is_seen(&self, triangle: &Triangle, x: u32, y: u32) -> bool {
        let ray = match &self.rays {
            Some(rays) => rays.get(x, y).copied().unwrap_or(DVec3::NAN),
            None => {
                let centre = PixelPoint::<Usd>::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
                (self.view.camera.intrinsics.normalized_from_pixel(centre)).extend(1.0)
            }
        };
        let sides = triangle.sides.map(|side| ray.dot(side));
        if !(sides.iter().all(|s| *s >= 0.0) || sides.iter().all(|s| *s <= 0.0)) {
            return false;
        }
        let t = triangle.corners[0].dot(triangle.normal) / ray.dot(triangle.normal);
        (self.view.clip.near_m..=self.view.clip.far_m).contains(&t)
    }

    fn project(&self, point: DVec3) -> Option<[f64; 2]> {
        let pixel = self.view.camera.project(point)?.to::<Usd>();
        Some([pixel.x, pixel.y])
    }
}

fn is_pinhole(view: &View) -> bool {
    matches!(view.camera.lens, oaktwin_camera::LensModel::Pinhole)
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
    // Nothing between infinities that are the wrong way round.
    if first < end {
        first as u32..end as u32
    } else {
        0..0
    }
}

/// The corners of the part of a triangle that lies in front of a plane across the optical axis.
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
