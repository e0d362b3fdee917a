//! The surfaces that pixels see, eight at a time, in single precision relative to the eye.

use glam::Vec3;
use oaktwin_camera::math::{DAffine3, DMat3, DVec3};
use oaktwin_scene::{Attribute, Mesh, Scene};
use oaktwin_simd::{F64Lanes, LaneKernel, Lanes, Level, run_lanes_at};

use crate::ray::Vector;
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
    mesh: &'a Mesh,
    /// From the mesh to world axes at the eye.
    from_mesh: DAffine3,
    /// The inverse transpose, for normals, also of mirrored instances, with elements near 1.
    from_normal: [Vec3; 3],
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
        set(&mut pixels.rays, lane, ray.as_vec3());
        #[expect(clippy::cast_possible_truncation, reason = "shading is float32")]
        {
            pixels.distances[lane] = (f64::from(z) / ray.z) as f32;
        }
        if placed.has_normals {
            let normals = mesh.normals.as_ref();
            let corners = normals.and_then(|normals| normals.corners(triangle, vertices));
            for (column, normal) in pixels.normals.iter_mut().zip(corners.unwrap_or_default()) {
                set(column, lane, Vec3::from(normal));
            }
        }
        for (column, next) in pixels
            .steps
            .iter_mut()
            .zip(self.rays.next(place[0], place[1], ray))
        {
            set(
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
            mesh,
            from_mesh,
            from_normal: near_one(from_normal),
            turn: if from_mesh.matrix3.determinant() < 0.0 {
                -1.0
            } else {
                1.0
            },
            has_normals: mesh.normals.is_some(),
        })
    }

    /// Finds the surfaces of the pixels. Returns `None` if there are none.
    pub(super) fn find(&mut self) -> Option<Found<'_, 'a>> {
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
        Some(Found {
            mesh: placed.mesh,
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
pub(super) struct Found<'p, 'a> {
    pub(super) mesh: &'a Mesh,
    pixels: &'p Pixels,
    pub(super) surfaces: &'p Surfaces,
}

impl Found<'_, '_> {
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

    pub(super) fn triangle(&self, lane: usize) -> u32 {
        self.pixels.triangles[lane & 7]
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

/// Returns the vector in a lane.
#[inline]
pub(super) fn lane_of([x, y, z]: &Columns, lane: usize) -> Vec3 {
    Vec3::new(x[lane & 7], y[lane & 7], z[lane & 7])
}

#[inline]
fn set([x, y, z]: &mut Columns, lane: usize, value: Vec3) {
    (x[lane & 7], y[lane & 7], z[lane & 7]) = value.into();
}

/// Returns the columns of a matrix, scaled so that the largest element is 1.
fn near_one(matrix: DMat3) -> [Vec3; 3] {
    let columns = [matrix.x_axis, matrix.y_axis, matrix.z_axis];
    let largest = columns.map(|column| column.abs().max_element());
    let largest = largest.into_iter().fold(f64::MIN_POSITIVE, f64::max);
    columns.map(|column| (column / largest).as_vec3())
}

/// Finds where rays meet triangles.
struct Locate<'p, 'a> {
    placed: &'p Placed<'a>,
    world_from_camera: &'p [Vec3; 3],
    pixels: &'p Pixels,
    surfaces: &'p mut Surfaces,
}

impl LaneKernel for Locate<'_, '_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self) {
        let Self {
            placed,
            world_from_camera,
            pixels,
            surfaces,
        } = self;
        let (zero, one) = (L::splat(0.0), L::splat(1.0));
        let ray = turned::<L>(world_from_camera, load(&pixels.rays));
        let triangle = Triangle::<L>::new(placed, &pixels.vertices);
        let distance = L::load(&pixels.distances);
        let from_plane = triangle.corner.dot(triangle.normal) / ray.dot(triangle.normal);
        let is_known = zero.lt(distance) & distance.lt(L::splat(f32::INFINITY));
        let distance = L::select(is_known, distance, from_plane);
        let point = ray * distance;
        point.store(&mut surfaces.point);
        point.dot(point).sqrt().store(&mut surfaces.range);
        let from_corner = point - triangle.corner;
        let [a, b, c] = clamped(from_corner.dot(triangle.to_b), from_corner.dot(triangle.to_c));
        b.store(&mut surfaces.weights[0]);
        c.store(&mut surfaces.weights[1]);
        // The unit normal, on the visible side.
        let length = triangle.normal.dot(triangle.normal).sqrt();
        let unit = triangle.normal * (L::splat(placed.turn) / length.max(L::splat(TINY)));
        let minus_one = L::splat(-1.0);
        let side = L::select(zero.lt(unit.dot(ray)), minus_one, one);
        let towards_eye = ray * (minus_one / ray.dot(ray).sqrt());
        let flat = select(triangle.has_area, unit * side, towards_eye);
        flat.store(&mut surfaces.flat_normal);
        let mut normal = flat;
        if placed.has_normals {
            let [na, nb, nc] = &pixels.normals;
            let between = load::<L>(na) * a + load::<L>(nb) * b + load::<L>(nc) * c;
            let smooth = turned::<L>(&placed.from_normal, between);
            let length = smooth.dot(smooth).sqrt();
            let is_sane = L::splat(TINY).lt(length) & length.lt(L::splat(f32::INFINITY));
            normal = select(is_sane, smooth * (side / length), flat);
        }
        normal.store(&mut surfaces.normal);
        let ray_height = ray.dot(triangle.normal);
        for (step, out) in pixels.steps.iter().zip(&mut surfaces.steps) {
            let step = turned::<L>(world_from_camera, load(step));
            let height = step.dot(triangle.normal);
            let next_height = ray_height + height;
            // The next ray r + s meets the plane at d (r + s) (r·n) / (r·n + s·n).
            let way = (step * (ray_height / next_height) - ray * (height / next_height)) * distance;
            finite(way.dot(triangle.to_b)).store(&mut out[0]);
            finite(way.dot(triangle.to_c)).store(&mut out[1]);
        }
    }
}

/// The shortest vector that has a direction.
const TINY: f32 = 1e-15;

/// Triangles in world axes relative to the eye.
struct Triangle<L: Lanes> {
    corner: Vector<L>,
    /// Not normalized.
    normal: Vector<L>,
    has_area: L::I32,
    /// The gradients of the barycentric coordinates of the second and third corner.
    to_b: Vector<L>,
    to_c: Vector<L>,
}

impl<L: Lanes> Triangle<L> {
    #[inline(always)]
    fn new(placed: &Placed<'_>, [a, b, c]: &[[u32; 8]; 3]) -> Self {
        let positions = &placed.mesh.positions;
        let a = moved::<L>(&placed.from_mesh, L::gather(positions, *a));
        let b = moved::<L>(&placed.from_mesh, L::gather(positions, *b));
        let c = moved::<L>(&placed.from_mesh, L::gather(positions, *c));
        let corner = narrow::<L>(a);
        let ab = narrow::<L>([b[0] - a[0], b[1] - a[1], b[2] - a[2]]);
        let ac = narrow::<L>([c[0] - a[0], c[1] - a[1], c[2] - a[2]]);
        let longest = longest(ab).max(longest(ac)).max(L::splat(f32::MIN_POSITIVE));
        let scale = L::splat(1.0) / longest;
        let (ab, ac) = (ab * scale, ac * scale);
        let normal = ab.cross(ac);
        let square = normal.dot(normal);
        let has_area = L::splat(TINY * TINY).lt(square);
        let factor = scale / square.max(L::splat(TINY * TINY));
        Self {
            corner,
            normal,
            has_area,
            to_b: ac.cross(normal) * factor,
            to_c: normal.cross(ab) * factor,
        }
    }
}

/// Transforms points to double precision.
#[inline(always)]
fn moved<L: Lanes>(by: &DAffine3, [x, y, z]: [L; 3]) -> [L::F64; 3] {
    let (x, y, z) = (x.widen(), y.widen(), z.widen());
    let m = by.matrix3;
    let row = [
        [m.x_axis.x, m.y_axis.x, m.z_axis.x, by.translation.x],
        [m.x_axis.y, m.y_axis.y, m.z_axis.y, by.translation.y],
        [m.x_axis.z, m.y_axis.z, m.z_axis.z, by.translation.z],
    ];
    let mut sums = [x; 3];
    for (sum, [a, b, c, d]) in sums.iter_mut().zip(row) {
        *sum = L::F64::splat(a) * x + L::F64::splat(b) * y + L::F64::splat(c) * z + L::F64::splat(d);
    }
    sums
}

#[inline(always)]
fn narrow<L: Lanes>([x, y, z]: [L::F64; 3]) -> Vector<L> {
    Vector {
        x: L::narrow(x),
        y: L::narrow(y),
        z: L::narrow(z),
    }
}

#[inline(always)]
fn load<L: Lanes>([x, y, z]: &Columns) -> Vector<L> {
    Vector {
        x: L::load(x),
        y: L::load(y),
        z: L::load(z),
    }
}

#[inline(always)]
fn turned<L: Lanes>([x, y, z]: &[Vec3; 3], v: Vector<L>) -> Vector<L> {
    Vector::<L>::splat(x.to_array()) * v.x
        + Vector::<L>::splat(y.to_array()) * v.y
        + Vector::<L>::splat(z.to_array()) * v.z
}

#[inline(always)]
fn longest<L: Lanes>(v: Vector<L>) -> L {
    let zero = L::splat(0.0);
    let high = v.x.max(v.y).max(v.z);
    let low = v.x.min(v.y).min(v.z);
    high.max(zero - low)
}

#[inline(always)]
fn select<L: Lanes>(mask: L::I32, then: Vector<L>, otherwise: Vector<L>) -> Vector<L> {
    Vector {
        x: L::select(mask, then.x, otherwise.x),
        y: L::select(mask, then.y, otherwise.y),
        z: L::select(mask, then.z, otherwise.z),
    }
}

/// Clamps barycentric coordinates to 0 to 1 with a sum of 1, and returns all three.
#[inline(always)]
fn clamped<L: Lanes>(b: L, c: L) -> [L; 3] {
    let (zero, one) = (L::splat(0.0), L::splat(1.0));
    let a = (one - b - c).max(zero).min(one);
    // NaN becomes 0.
    let (b, c) = (b.max(zero).min(one), c.max(zero).min(one));
    let sum = a + b + c;
    let is_sane = zero.lt(sum);
    let third = L::splat(1.0 / 3.0);
    let scale = one / sum;
    [
        L::select(is_sane, a * scale, third),
        L::select(is_sane, b * scale, third),
        L::select(is_sane, c * scale, third),
    ]
}

/// Replaces NaN and infinity by 0.
#[inline(always)]
fn finite<L: Lanes>(x: L) -> L {
    let (zero, max) = (L::splat(0.0), L::splat(f32::MAX));
    let is_finite = x.le(max) & (zero - max).le(x);
    L::select(is_finite, x, zero)
}

/// Interpolates the values of a triangle's corners; `None` if the attribute has too few.
#[inline]
pub(super) fn corners_of<T: Copy>(of: Option<&Attribute<T>>, mesh: &Mesh, triangle: u32) -> Option<[T; 3]> {
    let triangle = triangle as usize;
    of?.corners(triangle, *mesh.triangles.get(triangle)?)
}

#[cfg(test)]
mod tests;
