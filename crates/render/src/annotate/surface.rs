//! The place on a triangle that a ray hits.

use oaktwin_camera::math::{DAffine3, DMat3, DVec3};
use oaktwin_camera::{PixelPoint, Usd};
use oaktwin_scene::{Mesh, Scene};

use crate::{Hit, View};

/// Where a ray meets a triangle.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Surface {
    /// In the world, metres.
    pub(crate) point: DVec3,
    /// From the camera to the point, metres along the unit ray.
    pub(crate) range: f64,
    /// The unit normal in the world on the side that is seen: interpolated, or the triangle's own where the mesh has
    /// none.
    pub(crate) normal: DVec3,
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
    mesh_from_world: DAffine3,
    origin_in_mesh: DVec3,
    /// Normals are turned by the inverse transpose, mirrored instances' too.
    world_from_normal: DMat3,
}

/// The unit ray of a pixel in the camera's frame.
pub(crate) fn ray_in_camera(view: &View, x: u32, y: u32) -> Option<DVec3> {
    let centre = PixelPoint::<Usd>::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
    view.camera.unproject(centre)
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

    /// What the unit ray `ray_in_camera` sees on the triangle that it hits, `z` away along the optical axis.
    pub(crate) fn find(&mut self, hit: Hit, ray_in_camera: DVec3, z: f32) -> Option<Surface> {
        let (origin, ray) = (self.origin, self.world_from_camera * ray_in_camera);
        let placed = self.placed(hit.instance)?;
        let triangle = hit.triangle as usize;
        let vertices = *placed.mesh.triangles.get(triangle)?;
        let [a, b, c] = placed
            .mesh
            .corners(triangle)?
            .map(|p| DVec3::from(p.map(f64::from)) - placed.origin_in_mesh);
        let direction = placed.mesh_from_world.transform_vector3(ray);
        // The shares are those of the origin's pyramid over the triangle.
        let sides = [b.cross(c), c.cross(a), a.cross(b)].map(|n| direction.dot(n));
        let whole = sides[0] + sides[1] + sides[2];
        let weights = clamped(sides.map(|side| side / whole));
        let normal = (b - a).cross(c - a);
        let from_plane = a.dot(normal) / direction.dot(normal);
        let from_depth = f64::from(z) / ray_in_camera.z;
        // A triangle that is seen edge-on has no plane to speak of.
        let range = match (from_plane - from_depth).abs() <= 1e-5 * from_depth.abs() {
            true => from_plane,
            false if from_depth.is_finite() && from_depth > 0.0 => from_depth,
            false => from_plane,
        };
        let flat = (placed.world_from_normal * normal).normalize_or(-ray);
        let side = if flat.dot(ray) > 0.0 { -1.0 } else { 1.0 };
        let flat_normal = flat * side;
        let smooth = placed.mesh.normals.as_ref().and_then(|normals| {
            let corners = normals.corners(triangle, vertices)?;
            let sum = corners
                .iter()
                .zip(weights)
                .map(|(normal, weight)| DVec3::from(normal.map(f64::from)) * weight)
                .fold(DVec3::ZERO, |sum, part| sum + part);
            (placed.world_from_normal * sum).try_normalize()
        });
        Some(Surface {
            point: origin + ray * range,
            range,
            normal: smooth.map_or(flat_normal, |smooth| smooth * side),
        })
    }

    fn placed(&mut self, instance: u32) -> Option<Placed<'a>> {
        if let Some((last, placed)) = self.last
            && last == instance
        {
            return Some(placed);
        }
        let found = self.scene.instances.get(instance as usize)?;
        let mesh_from_world = found.world_from_mesh.inverse();
        let placed = Placed {
            mesh: self.scene.meshes.get(found.mesh as usize)?,
            mesh_from_world,
            origin_in_mesh: mesh_from_world.transform_point3(self.origin),
            world_from_normal: mesh_from_world.matrix3.transpose(),
        };
        self.last = Some((instance, placed));
        Some(placed)
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
