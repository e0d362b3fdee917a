//! The point on a triangle that a ray hits.

use oaktwin_camera::math::{DAffine3, DMat3, DVec3};
use oaktwin_scene::{Mesh, Scene};

use crate::barycentric::clamped;
use crate::{Hit, View};

/// Where a ray meets a triangle.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Surface<'a> {
    pub(crate) mesh: &'a Mesh,
    /// The point in the world, metres.
    pub(crate) point: DVec3,
    /// The distance from the camera, metres.
    pub(crate) range: f64,
    /// The barycentric coordinates, each from 0 to 1, with a sum of 1.
    pub(crate) weights: [f64; 3],
    /// The triangle's unit normal in the world, on the visible side.
    pub(crate) flat_normal: DVec3,
    /// The interpolated unit normal in the world, flipped with `flat_normal`; equal to it where the mesh has no normals.
    pub(crate) normal: DVec3,
    /// Whether the back of the triangle is seen, whose corners run clockwise.
    pub(crate) is_back: bool,
    /// The normals, in the camera frame, of the planes through the camera and each edge, in the order of the opposite
    /// corners.
    pub(crate) sides: [DVec3; 3],
}

impl Surface<'_> {
    /// Returns the barycentric coordinates where a ray of the camera meets the triangle's plane; NaN or infinite where it
    /// does not.
    #[inline]
    pub(crate) fn weights_of(&self, ray_in_camera: DVec3) -> [f64; 3] {
        let [a, b, c] = &self.sides;
        let (a, b, c) = (
            ray_in_camera.dot(*a),
            ray_in_camera.dot(*b),
            ray_in_camera.dot(*c),
        );
        let whole = a + b + c;
        [a / whole, b / whole, c / whole]
    }
}

/// Looks up surfaces, with a cache of the last instance and triangle.
pub(crate) struct SurfaceFinder<'a> {
    scene: &'a Scene,
    origin: DVec3,
    world_from_camera: DMat3,
    instance: u32,
    placed: Option<Placed<'a>>,
    hit: Hit,
    triangle: Option<Triangle>,
}

struct Placed<'a> {
    mesh: &'a Mesh,
    camera_from_mesh: DAffine3,
    /// The inverse transpose, also for mirrored instances.
    world_from_normal: DMat3,
    /// −1 where the instance is mirrored, which reverses the winding of its triangles.
    turn: f64,
}

/// A triangle in the camera frame.
#[derive(Clone, Copy)]
struct Triangle {
    corner: DVec3,
    sides: [DVec3; 3],
    /// Not normalized.
    normal: DVec3,
    /// In the world frame.
    flat_normal: DVec3,
    smooth_normals: Option<[[f32; 3]; 3]>,
}

impl<'a> SurfaceFinder<'a> {
    pub(crate) fn new(scene: &'a Scene, view: &View) -> Self {
        Self {
            world_from_camera: view.world_from_camera.rotation,
            ..Self::at(scene, view.world_from_camera.translation)
        }
    }

    /// Creates a finder for rays from a point, whose camera frame has the axes of the world.
    pub(crate) fn at(scene: &'a Scene, origin: DVec3) -> Self {
        Self {
            scene,
            origin,
            world_from_camera: DMat3::IDENTITY,
            instance: u32::MAX,
            placed: None,
            hit: Hit::MISS,
            triangle: None,
        }
    }

    /// Returns the surface where a ray in the camera frame hits a triangle at z-depth `z`.
    #[inline]
    pub(crate) fn find(&mut self, hit: Hit, ray: DVec3, z: f32) -> Option<Surface<'a>> {
        self.find_at(hit, ray, f64::from(z) / ray.z)
    }

    /// Returns the surface where a ray in the camera frame hits a triangle at a distance in lengths of the ray.
    #[inline]
    pub(crate) fn find_at(&mut self, hit: Hit, ray: DVec3, from_depth: f64) -> Option<Surface<'a>> {
        if hit != self.hit {
            self.turn_to(hit);
        }
        let (Some(placed), Some(triangle)) = (&self.placed, &self.triangle) else {
            return None;
        };
        let from_plane = triangle.corner.dot(triangle.normal) / ray.dot(triangle.normal);
        // The plane of a triangle seen edge-on is ill-conditioned.
        let is_trusted = (from_plane - from_depth).abs() <= 1e-5 * from_depth.abs();
        let t = if is_trusted || !(from_depth.is_finite() && from_depth > 0.0) {
            from_plane
        } else {
            from_depth
        };
        let ray_in_world = self.world_from_camera * ray;
        let side = if triangle.flat_normal.dot(ray_in_world) > 0.0 {
            -1.0
        } else {
            1.0
        };
        let flat_normal = if triangle.flat_normal == DVec3::ZERO {
            -ray_in_world.normalize_or_zero()
        } else {
            triangle.flat_normal * side
        };
        let mut surface = Surface {
            mesh: placed.mesh,
            point: self.origin + ray_in_world * t,
            range: t * ray.length(),
            weights: [0.0; 3],
            flat_normal,
            normal: flat_normal,
            is_back: side < 0.0,
            sides: triangle.sides,
        };
        surface.weights = clamped(surface.weights_of(ray));
        if let Some(normals) = triangle.smooth_normals {
            let normal = placed.world_from_normal * DVec3::from(surface.interpolated(normals));
            surface.normal = normal.try_normalize().map_or(flat_normal, |normal| normal * side);
        }
        Some(surface)
    }

    fn turn_to(&mut self, hit: Hit) {
        self.hit = hit;
        if hit.instance != self.instance {
            self.instance = hit.instance;
            self.placed = self.place(hit.instance);
        }
        self.triangle = self.triangle(hit.triangle);
    }

    fn triangle(&self, triangle: u32) -> Option<Triangle> {
        let placed = self.placed.as_ref()?;
        let index = triangle as usize;
        let [a, b, c] = placed.mesh.corners(index)?;
        let in_camera = |p: [f32; 3]| {
            placed
                .camera_from_mesh
                .transform_point3(DVec3::from(p.map(f64::from)))
        };
        let (a, b, c) = (in_camera(a), in_camera(b), in_camera(c));
        let normal = (b - a).cross(c - a);
        let flat = (normal * placed.turn).normalize_or_zero();
        let normals = placed.mesh.normals.as_ref();
        Some(Triangle {
            corner: a,
            sides: [b.cross(c), c.cross(a), a.cross(b)],
            normal,
            flat_normal: self.world_from_camera * flat,
            smooth_normals: match normals {
                Some(normals) => normals.corners(index, *placed.mesh.triangles.get(index)?),
                None => None,
            },
        })
    }

    fn place(&self, instance: u32) -> Option<Placed<'a>> {
        let found = self.scene.instances.get(instance as usize)?;
        let world_from_mesh = found.world_from_mesh;
        let camera_from_world = self.world_from_camera.transpose();
        Some(Placed {
            mesh: self.scene.meshes.get(found.mesh as usize)?,
            camera_from_mesh: DAffine3 {
                matrix3: camera_from_world * world_from_mesh.matrix3,
                translation: camera_from_world * (world_from_mesh.translation - self.origin),
            },
            world_from_normal: world_from_mesh.matrix3.inverse().transpose(),
            turn: world_from_mesh.matrix3.determinant().signum(),
        })
    }
}

impl Surface<'_> {
    /// Interpolates the values of the corners.
    #[inline]
    pub(crate) fn interpolated<const N: usize>(&self, corners: [[f32; N]; 3]) -> [f64; N] {
        let [a, b, c] = &corners;
        let mut between = [0.0; N];
        for (i, value) in between.iter_mut().enumerate() {
            *value = f64::from(a[i]) * self.weights[0]
                + f64::from(b[i]) * self.weights[1]
                + f64::from(c[i]) * self.weights[2];
        }
        between
    }
}
