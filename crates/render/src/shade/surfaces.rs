//! The surfaces that pixels see, eight at a time, in single precision relative to the eye.

mod locate;
#[cfg(test)]
mod tests;

use glam::Vec3;
use oaktwin_camera::math::{DAffine3, DMat3, DVec3};
use oaktwin_scene::{Instance, Mesh, MeshAttribute, Scene};
use oaktwin_simd::{Level, run_lanes_at};

use self::locate::Locate;
use crate::annotate::Surface;
use crate::rays::Rays;
use crate::{Hit, View};

/// Three components of eight lanes.
pub(super) type Columns = [[f32; 8]; 3];

/// The pixels of a packet, which see the same instance.
#[derive(Debug, Default)]
struct Pixels {
    count: usize,
    /// What the caller identifies pixels by.
    tags: [usize; 8],
    places: [[u32; 2]; 8],
    triangles: [u32; 8],
    vertices: [[u32; 8]; 3],
    /// In the camera frame.
    rays: Columns,
    /// The differences to the rays of the pixels to the right and below; NaN where there is none.
    steps: [Columns; 2],
    /// The distance in lengths of the ray.
    distances: [f32; 8],
    /// The normals of the corners.
    normals: [Columns; 3],
}

/// The surfaces of a packet. Lanes from `count` on are arbitrary.
#[derive(Debug, Default)]
pub(super) struct Surfaces {
    /// The points relative to the eye, metres.
    pub(super) point: Columns,
    /// The distances from the eye, metres.
    pub(super) range: [f32; 8],
    /// The interpolated unit normals, flipped with `flat_normal`; equal to it where the mesh has no normals.
    pub(super) normal: Columns,
    /// The unit normals of the triangles, on the visible side.
    pub(super) flat_normal: Columns,
    /// The barycentric coordinates of the second and third corner.
    pub(super) weights: [[f32; 8]; 2],
    /// Their differences to the pixels to the right and below, 0 where the triangle's plane is not met.
    pub(super) steps: [[[f32; 8]; 2]; 2],
}

/// An instance as seen from the eye.
#[derive(Debug)]
struct Placed<'a> {
    instance: u32,
    placed: &'a Instance,
    mesh: &'a Mesh,
    /// From the mesh to world axes at the eye.
    from_mesh: DAffine3,
    /// The inverse transpose, for normals, also of mirrored instances, with elements near 1.
    from_normal: [Vec3; 3],
    /// The lengths in the world, metres, of the mesh's unit vectors.
    scale: Vec3,
    /// −1 where the instance is mirrored, which reverses the winding of its triangles.
    turn: f32,
    has_normals: bool,
}

/// A place on a triangle in barycentric coordinates of the second and third corner, and the differences to the places that
/// the pixels to the right and below see.
#[derive(Clone, Copy, Debug)]
pub(super) struct Spot {
    pub(super) at: [f32; 2],
    pub(super) across: [f32; 2],
    pub(super) down: [f32; 2],
}

impl Spot {
    /// Returns the place where a ray sees a surface; `next` are the rays of the pixels to the right and below.
    #[expect(clippy::cast_possible_truncation, reason = "shading is float32")]
    pub(super) fn seen_on(surface: &Surface<'_>, next: [Option<DVec3>; 2]) -> Self {
        let [_, b, c] = surface.weights;
        let [across, down] = next.map(|next| {
            let [_, next_b, next_c] = next.map_or(surface.weights, |next| surface.weights_of(next));
            let step = [next_b - b, next_c - c];
            if step.iter().all(|step| step.is_finite()) {
                step.map(|step| step as f32)
            } else {
                [0.0; 2]
            }
        });
        Self {
            at: [b as f32, c as f32],
            across,
            down,
        }
    }
}

/// Collects pixels and finds their surfaces.
#[derive(Debug)]
pub(super) struct Packet<'a> {
    scene: &'a Scene,
    rays: &'a Rays<'a>,
    eye: DVec3,
    world_from_camera: [Vec3; 3],
    level: Level,
    placed: Option<Placed<'a>>,
    pixels: Pixels,
    surfaces: Surfaces,
}

impl<'a> Packet<'a> {
    pub(super) fn new(scene: &'a Scene, view: &View, rays: &'a Rays<'a>, level: Level) -> Self {
        let rotation = view.world_from_camera.rotation;
        Self {
            scene,
            rays,
            eye: view.world_from_camera.translation,
            world_from_camera: [
                rotation.x_axis.as_vec3(),
                rotation.y_axis.as_vec3(),
                rotation.z_axis.as_vec3(),
            ],
            level,
            placed: None,
            pixels: Pixels::default(),
            surfaces: Surfaces::default(),
        }
    }

    /// Returns the ray through the centre of a pixel in the camera frame, if the lens has one.
    #[inline]
    pub(super) fn ray(&self, [x, y]: [u32; 2]) -> Option<DVec3> {
        self.rays.centre(x, y)
    }

    /// Whether a pixel that sees an instance can be added.
    #[inline]
    pub(super) fn has_room_for(&self, instance: u32) -> bool {
        let pixels = &self.pixels;
        pixels.count == 0
            || (pixels.count < 8
                && self
                    .placed
                    .as_ref()
                    .is_some_and(|placed| placed.instance == instance))
    }

    /// Adds a pixel that hits a surface, for which there must be room. Ignores pixels without a ray or a triangle.
    #[inline]
    pub(super) fn push(&mut self, tag: usize, place: [u32; 2], ray: DVec3, hit: Hit, z: f32) {
        if self
            .placed
            .as_ref()
            .is_none_or(|placed| placed.instance != hit.instance)
        {
            self.placed = self.place(hit.instance);
        }
        let Some(placed) = &self.placed else { return };
        let triangle = hit.triangle as usize;
        let mesh = placed.mesh;
        let Some(vertices) = mesh.triangles.get(triangle).copied() else {
            return;
        };
        if vertices
            .iter()
            .any(|vertex| *vertex as usize >= mesh.positions.len())
        {
            return;
        }
        let pixels = &mut self.pixels;
        let lane = pixels.count & 7;
        pixels.count = lane + 1;
        pixels.tags[lane] = tag;
        pixels.places[lane] = place;
        pixels.triangles[lane] = hit.triangle;
        for (column, vertex) in pixels.vertices.iter_mut().zip(vertices) {
            column[lane] = vertex;
        }
        set_lane(&mut pixels.rays, lane, ray.as_vec3());
        #[expect(clippy::cast_possible_truncation, reason = "shading is float32")]
        {
            pixels.distances[lane] = (f64::from(z) / ray.z) as f32;
        }
        if placed.has_normals {
            let normals = mesh.normals.as_ref();
            let corners = normals.and_then(|normals| normals.corners(triangle, vertices));
            for (column, normal) in pixels.normals.iter_mut().zip(corners.unwrap_or_default()) {
                set_lane(column, lane, Vec3::from(normal));
            }
        }
        for (column, next) in pixels
            .steps
            .iter_mut()
            .zip(self.rays.next(place[0], place[1], ray))
        {
            set_lane(
                column,
                lane,
                next.map_or(Vec3::NAN, |next| (next - ray).as_vec3()),
            );
        }
    }

    fn place(&self, instance: u32) -> Option<Placed<'a>> {
        let found = self.scene.instances.get(instance as usize)?;
        let mesh = self.scene.meshes.get(found.mesh as usize)?;
        let mut from_mesh = found.world_from_mesh;
        from_mesh.translation -= self.eye;
        let from_normal = from_mesh.matrix3.inverse().transpose();
        Some(Placed {
            instance,
            placed: found,
            mesh,
            from_mesh,
            from_normal: near_one(from_normal),
            scale: lengths(&from_mesh.matrix3),
            turn: if from_mesh.matrix3.determinant() < 0.0 {
                -1.0
            } else {
                1.0
            },
            has_normals: mesh.normals.is_some(),
        })
    }

    /// Finds the surfaces of the pixels. Returns `None` if there are none.
    pub(super) fn find(&mut self) -> Option<PacketSurfaces<'_, 'a>> {
        let placed = self.placed.as_ref().filter(|_| self.pixels.count > 0)?;
        // Lanes without a pixel repeat a vertex of the first.
        for column in &mut self.pixels.vertices {
            for lane in self.pixels.count..8 {
                column[lane] = column[0];
            }
        }
        let kernel = Locate {
            placed,
            world_from_camera: &self.world_from_camera,
            pixels: &self.pixels,
            surfaces: &mut self.surfaces,
        };
        run_lanes_at(self.level, kernel);
        Some(PacketSurfaces {
            mesh: placed.mesh,
            instance: placed.placed,
            number: placed.instance,
            scale: placed.scale,
            pixels: &self.pixels,
            surfaces: &self.surfaces,
        })
    }

    /// Removes the pixels.
    pub(super) fn clear(&mut self) {
        self.pixels.count = 0;
    }
}

/// The surfaces of a packet's pixels.
#[derive(Clone, Copy, Debug)]
pub(super) struct PacketSurfaces<'p, 'a> {
    pub(super) mesh: &'a Mesh,
    instance: &'a Instance,
    number: u32,
    scale: Vec3,
    pixels: &'p Pixels,
    pub(super) surfaces: &'p Surfaces,
}

impl PacketSurfaces<'_, '_> {
    pub(super) const fn count(&self) -> usize {
        self.pixels.count
    }

    pub(super) fn tag(&self, lane: usize) -> usize {
        self.pixels.tags[lane & 7]
    }

    /// Returns the coordinates of a pixel.
    pub(super) fn place(&self, lane: usize) -> [u32; 2] {
        self.pixels.places[lane & 7]
    }

    /// Returns the triangle that a pixel sees.
    pub(super) fn hit(&self, lane: usize) -> Hit {
        Hit {
            instance: self.number,
            triangle: self.triangle(lane),
        }
    }

    pub(super) fn triangle(&self, lane: usize) -> u32 {
        self.pixels.triangles[lane & 7]
    }

    /// Returns the material in a lane, as an index into the scene's.
    #[inline]
    pub(super) fn material(&self, lane: usize) -> Option<u32> {
        self.instance.material(self.mesh.material(self.triangle(lane)))
    }

    /// Returns the number of the instance.
    pub(super) const fn surface(&self) -> u32 {
        self.number
    }

    /// Returns the place in a lane in metres along the axes of the mesh, which moves with the instance, and the size of a pixel
    /// there.
    pub(super) fn grained(&self, lane: usize) -> Option<(Vec3, f32)> {
        self.spot(lane)
            .grained(self.mesh, self.triangle(lane), self.scale)
    }

    pub(super) fn spot(&self, lane: usize) -> Spot {
        let lane = lane & 7;
        let pair = |[b, c]: &[[f32; 8]; 2]| [b[lane], c[lane]];
        let [across, down] = &self.surfaces.steps;
        Spot {
            at: pair(&self.surfaces.weights),
            across: pair(across),
            down: pair(down),
        }
    }
}

impl Spot {
    /// Returns the place on a triangle in metres along the axes of the mesh, and the size of a pixel there; `scale` are the lengths
    /// of the mesh's unit vectors.
    pub(super) fn grained(&self, mesh: &Mesh, triangle: u32, scale: Vec3) -> Option<(Vec3, f32)> {
        let vertices = *mesh.triangles.get(triangle as usize)?;
        let corner = |vertex: u32| {
            let position = mesh.positions.get(vertex as usize)?;
            Some(Vec3::from(*position) * scale)
        };
        let (a, b, c) = (corner(vertices[0])?, corner(vertices[1])?, corner(vertices[2])?);
        let spot = self;
        let along = |[u, v]: [f32; 2]| (b - a) * u + (c - a) * v;
        let footprint = (along(spot.across).length() * along(spot.down).length()).sqrt();
        Some((a + along(spot.at), footprint))
    }
}

/// Returns the vector in a lane.
#[inline]
pub(super) fn lane_of([x, y, z]: &Columns, lane: usize) -> Vec3 {
    Vec3::new(x[lane & 7], y[lane & 7], z[lane & 7])
}

/// Sets the vector in a lane.
#[inline]
pub(super) fn set_lane([x, y, z]: &mut Columns, lane: usize, value: Vec3) {
    (x[lane & 7], y[lane & 7], z[lane & 7]) = value.into();
}

/// Returns the lengths of the columns of a matrix.
pub(super) fn lengths(axes: &DMat3) -> Vec3 {
    DVec3::new(axes.x_axis.length(), axes.y_axis.length(), axes.z_axis.length()).as_vec3()
}

/// Returns the columns of a matrix, scaled so that the largest element is 1.
fn near_one(matrix: DMat3) -> [Vec3; 3] {
    let columns = [matrix.x_axis, matrix.y_axis, matrix.z_axis];
    let largest = columns.map(|column| column.abs().max_element());
    let largest = largest.into_iter().fold(f64::MIN_POSITIVE, f64::max);
    columns.map(|column| (column / largest).as_vec3())
}

/// Interpolates the values of a triangle's corners; `None` if the attribute has too few.
#[inline]
pub(super) fn corner_values<T: Copy>(
    of: Option<&MeshAttribute<T>>,
    mesh: &Mesh,
    triangle: u32,
) -> Option<[T; 3]> {
    let triangle = triangle as usize;
    of?.corners(triangle, *mesh.triangles.get(triangle)?)
}
