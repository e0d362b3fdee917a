//! The place on a triangle that a ray hits.

use oaktwin_camera::math::{DAffine3, DMat3, DVec3};
use oaktwin_scene::{Mesh, Scene};

use crate::{Hit, View};

/// Where a ray meets a triangle.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Surface<'a> {
    /// What it belongs to.
    pub(crate) mesh: &'a Mesh,
    /// In the world, metres.
    pub(crate) point: DVec3,
    /// From the camera to the point, metres.
    pub(crate) range: f64,
    /// The shares of the triangle's corners, each from 0 to 1, together 1.
    pub(crate) weights: [f64; 3],
    /// The triangle's own unit normal in the world, on the side that is seen.
    pub(crate) flat_normal: DVec3,
    /// The interpolated unit normal in the world, turned with `flat_normal`; the same where the mesh has none.
    pub(crate) normal: DVec3,
    /// The normals, in the camera's frame, of the sides of the camera's pyramid over the triangle, each opposite a
    /// corner.
    sides: [DVec3; 3],
}

impl Surface<'_> {
    /// The shares of the triangle's corners where another ray of the camera meets its plane; NaN or infinite where none
    /// does.
    #[inline]
    pub(crate) fn weights_of(&self, ray_in_camera: DVec3) -> [f64; 3] {
        let sides = self.sides.map(|side| ray_in_camera.dot(side));
        let whole = sides[0] + sides[1] + sides[2];
        sides.map(|side| side / whole)
    }
}

/// Looks up surfaces, remembering the instance that it saw last.
pub(crate) struct SurfaceFinder<'a> {
    scene: &'a Scene,
    origin: DVec3,
    world_from_camera: DMat3,
    last: Option<(u32, Placed<'a>)>,
}

#[derive(Clone, Copy)]
struct Placed<'a> {
    mesh: &'a Mesh,
    camera_from_mesh: DAffine3,
    /// Normals are turned by the inverse transpose, mirrored instances' too.
    world_from_normal: DMat3,
    /// −1 where the instance is mirrored: its triangles run the other way round.
    turn: f64,
}

impl<'a> SurfaceFinder<'a> {
    pub(crate) fn new(scene: &'a Scene, view: &View) -> Self {
        Self {
            scene,
            origin: view.world_from_camera.translation,
            world_from_camera: view.world_from_camera.rotation,
            last: None,
        }
    }

    /// What a ray in the camera's frame sees on the triangle that it hits, at the depth `z` along the optical axis.
    pub(crate) fn find(&mut self, hit: Hit, ray: DVec3, z: f32) -> Option<Surface<'a>> {
        let (origin, world_from_camera) = (self.origin, self.world_from_camera);
        let placed = self.placed(hit.instance)?;
        let triangle = hit.triangle as usize;
        let vertices = *placed.mesh.triangles.get(triangle)?;
        let [a, b, c] = (placed.mesh.corners(triangle)?).map(|p| {
            placed
                .camera_from_mesh
                .transform_point3(DVec3::from(p.map(f64::from)))
        });
        let normal = (b - a).cross(c - a);
        let from_plane = a.dot(normal) / ray.dot(normal);
        let from_depth = f64::from(z) / ray.z;
        // A triangle that is seen edge-on has no plane to speak of.
        let is_trusted = (from_plane - from_depth).abs() <= 1e-5 * from_depth.abs();
        let t = if is_trusted || !(from_depth.is_finite() && from_depth > 0.0) {
            from_plane
        } else {
            from_depth
        };
        let towards_camera = -ray.normalize_or_zero();
        let flat = (normal * placed.turn).normalize_or(towards_camera);
        let side = if flat.dot(ray) > 0.0 { -1.0 } else { 1.0 };
        let flat_normal = world_from_camera * flat * side;
        let mut surface = Surface {
            mesh: placed.mesh,
            point: origin + world_from_camera * ray * t,
            range: t * ray.length(),
            weights: [0.0; 3],
            flat_normal,
            normal: flat_normal,
            sides: [b.cross(c), c.cross(a), a.cross(b)],
        };
        surface.weights = clamped(surface.weights_of(ray));
        let smooth = placed.mesh.normals.as_ref().and_then(|normals| {
            let sum = surface.interpolated(normals.corners(triangle, vertices)?);
            (placed.world_from_normal * DVec3::from(sum)).try_normalize()
        });
        if let Some(smooth) = smooth {
            surface.normal = smooth * side;
        }
        Some(surface)
    }

    fn placed(&mut self, instance: u32) -> Option<Placed<'a>> {
        if let Some((last, placed)) = self.last
            && last == instance
        {
            return Some(placed);
        }
        let found = self.scene.instances.get(instance as usize)?;
        let world_from_mesh = found.world_from_mesh;
        let camera_from_world = self.world_from_camera.transpose();
        let placed = Placed {
            mesh: self.scene.meshes.get(found.mesh as usize)?,
            camera_from_mesh: DAffine3 {
                matrix3: camera_from_world * world_from_mesh.matrix3,
                translation: camera_from_world * (world_from_mesh.translation - self.origin),
            },
            world_from_normal: world_from_mesh.matrix3.inverse().transpose(),
            turn: world_from_mesh.matrix3.determinant().signum(),
        };
        self.last = Some((instance, placed));
        Some(placed)
    }
}

impl Surface<'_> {
    /// Between the corners' values.
    #[inline]
    pub(crate) fn interpolated<const N: usize>(&self, corners: [[f32; N]; 3]) -> [f64; N] {
        std::array::from_fn(|i| {
            let [a, b, c] = corners.map(|corner| f64::from(corner[i]));
            a * self.weights[0] + b * self.weights[1] + c * self.weights[2]
        })
    }
}

/// Shares from 0 to 1 that make up a whole, whatever rounding did to them.
fn clamped(shares: [f64; 3]) -> [f64; 3] {
    let positive = shares.map(|share| share.clamp(0.0, 1.0));
    let sum: f64 = positive.iter().sum();
    // Nor is a NaN a share.
    if sum > 0.0 {
        positive.map(|share| share / sum)
    } else {
        [1.0 / 3.0; 3]
    }
}
