//! Brute force: every ray against every triangle, in double precision.

use oaktwin_camera::math::{DAffine3, DVec3};
use oaktwin_camera::{PixelPoint, Usd};
use oaktwin_image::{Image, ZDepth};
use oaktwin_scene::Scene;

use crate::{Hit, View, Visibility};

#[expect(clippy::cast_possible_truncation, reason = "depth is float32")]
pub(crate) fn visibility(scene: &Scene, view: &View) -> Visibility {
    let size = view.camera.intrinsics.size;
    let mut z = Image::filled(size.width, size.height, f32::INFINITY);
    let mut hits = Image::filled(size.width, size.height, Hit::MISS);
    let camera_from_world = view.camera_from_world();
    let along_axis = view.clips_along_axis();
    let places = (0..size.height).flat_map(|y| (0..size.width).map(move |x| (x, y)));
    for ((z, hit), (x, y)) in z.pixels_mut().iter_mut().zip(hits.pixels_mut()).zip(places) {
        let pixel = PixelPoint::<Usd>::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
        let Some(ray) = view.camera.unproject(pixel) else {
            continue;
        };
        let ray = if along_axis { ray / ray.z } else { ray };
        let (near, far) = (view.clip.near_m, view.clip.far_m);
        let mut nearest = far.next_up();
        each_crossing(scene, camera_from_world, DVec3::ZERO, ray, |t, found| {
            if t >= near && t < nearest {
                nearest = t;
                (*z, *hit) = ((t * ray.z) as f32, found);
            }
            false
        });
    }
    Visibility { z: ZDepth(z), hits }
}

#[cfg(test)]
pub(crate) fn is_occluded(scene: &Scene, origin: DVec3, direction: DVec3, near: f64, far: f64) -> bool {
    each_crossing(scene, DAffine3::IDENTITY, origin, direction, |t, _| {
        t > near && t < far
    })
}

/// Returns the nearest crossing, both ends included; of equally near ones the first.
#[cfg(test)]
pub(crate) fn nearest(
    scene: &Scene,
    origin: DVec3,
    direction: DVec3,
    near: f64,
    far: f64,
) -> Option<(f64, Hit)> {
    let mut nearest: Option<(f64, Hit)> = None;
    each_crossing(scene, DAffine3::IDENTITY, origin, direction, |t, hit| {
        if t >= near && t <= far && nearest.is_none_or(|(other, _)| t < other) {
            nearest = Some((t, hit));
        }
        false
    });
    nearest
}

/// Calls `visit` with each crossing's distance until it returns true.
#[expect(clippy::cast_possible_truncation, reason = "a mesh's indices are u32")]
fn each_crossing(
    scene: &Scene,
    target_from_world: DAffine3,
    origin: DVec3,
    direction: DVec3,
    mut visit: impl FnMut(f64, Hit) -> bool,
) -> bool {
    for (instance, placed) in scene.instances.iter().enumerate() {
        let Some(mesh) = scene.meshes.get(placed.mesh as usize) else {
            continue;
        };
        let target_from_mesh = target_from_world * placed.world_from_mesh;
        for triangle in 0..mesh.triangles.len() {
            let Some(corners) = mesh.corners(triangle) else {
                continue;
            };
            let [a, b, c] =
                corners.map(|p| target_from_mesh.transform_point3(DVec3::from(p.map(f64::from))) - origin);
            // The planes through the origin and each edge, which neighbouring triangles share exactly.
            let side = |p: DVec3, q: DVec3| direction.dot((p + q).cross(q - p));
            let sides = [side(a, b), side(b, c), side(c, a)];
            if !(sides.iter().all(|s| *s >= 0.0) || sides.iter().all(|s| *s <= 0.0)) {
                continue;
            }
            let normal = (b - a).cross(c - a);
            let t = a.dot(normal) / direction.dot(normal);
            let hit = Hit {
                instance: instance as u32,
                triangle: triangle as u32,
            };
            if t.is_finite() && visit(t, hit) {
                return true;
            }
        }
    }
    false
}
