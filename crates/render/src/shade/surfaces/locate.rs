//! Where eight rays meet triangles.

use glam::Vec3;
use oaktwin_camera::math::DAffine3;
use oaktwin_simd::{F64Lanes, LaneKernel, Lanes};

use super::{Pixels, Placed, Surfaces};
use crate::ray::Vector;

/// Finds where rays meet triangles.
pub(super) struct Locate<'p, 'a> {
    pub(super) placed: &'p Placed<'a>,
    pub(super) world_from_camera: &'p [Vec3; 3],
    pub(super) pixels: &'p Pixels,
    pub(super) surfaces: &'p mut Surfaces,
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
        let ray = turned::<L>(world_from_camera, Vector::load(&pixels.rays));
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
            let between = Vector::<L>::load(na) * a + Vector::<L>::load(nb) * b + Vector::<L>::load(nc) * c;
            let smooth = turned::<L>(&placed.from_normal, between);
            let length = smooth.dot(smooth).sqrt();
            let is_sane = L::splat(TINY).lt(length) & length.lt(L::splat(f32::INFINITY));
            normal = select(is_sane, smooth * (side / length), flat);
        }
        normal.store(&mut surfaces.normal);
        let ray_height = ray.dot(triangle.normal);
        for (step, out) in pixels.steps.iter().zip(&mut surfaces.steps) {
            let step = turned::<L>(world_from_camera, Vector::load(step));
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
