//! One ray at a time, eight boxes or eight triangles at once.

use oaktwin_camera::math::{DAffine3, DVec3};
use oaktwin_scene::Mesh;

use super::bvh::{Bounds, Node};
use super::corners::corners;
use super::exact::Plane;
use super::mesh_tree::MeshTree;
use super::simd::{Kernel, Lanes};
use super::stack::{Entry, Stack, push_children};
use super::vector::{add, cross, dot, sub};
use super::{Prepared, Ray};
use crate::Hit;

/// What a search along a ray knows so far.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Search {
    near: f64,
    /// The nearest crossing so far, or the ray's end.
    far: f64,
    hit: Hit,
    until: Until,
}

/// When a search has seen enough.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Until {
    /// When nothing nearer is left. Both ends of the ray belong to it.
    Nearest,
    /// At any crossing between the ends.
    Any,
}

impl Search {
    /// Whether it is over.
    fn offer(&mut self, t: f64, hit: Hit) -> bool {
        match self.until {
            Until::Any => {
                let found = t > self.near && t < self.far;
                if found {
                    self.hit = hit;
                }
                found
            }
            Until::Nearest => {
                let is_first = (hit.instance, hit.triangle) < (self.hit.instance, self.hit.triangle);
                if t >= self.near && (t < self.far || (t == self.far && is_first)) {
                    (self.far, self.hit) = (t, hit);
                }
                false
            }
        }
    }
}

/// A ray through the whole scene.
pub(crate) struct Cast<'a> {
    pub(crate) scene: &'a Prepared<'a>,
    pub(crate) ray: Ray,
    pub(crate) until: Until,
    pub(crate) stack: &'a mut Stack,
}

impl Kernel for Cast<'_> {
    type Output = Option<(f64, Hit)>;

    #[inline(always)]
    fn run<L: Lanes>(self) -> Self::Output {
        let Ray {
            origin,
            direction,
            near,
            far,
        } = self.ray;
        let mut search = Search {
            near,
            far,
            hit: Hit::MISS,
            until: self.until,
        };
        let top = self.scene.instances;
        let path = Path::new(DAffine3::IDENTITY, origin, direction, &top.bounds)?;
        let stack = self.stack;
        stack.clear();
        walk::<L>(
            &top.nodes,
            &path,
            &mut search,
            stack,
            &mut |first, count, search, stack| {
                for &instance in &top.order[first as usize..][..count as usize] {
                    let Some((mesh, tree, mesh_from_world)) = self.scene.instance(instance) else {
                        continue;
                    };
                    if through_mesh::<L>((mesh, tree), instance, mesh_from_world, &self.ray, search, stack) {
                        return true;
                    }
                }
                false
            },
        );
        (!search.hit.is_miss()).then_some((search.far, search.hit))
    }
}

#[inline(always)]
fn through_mesh<L: Lanes>(
    (mesh, tree): (&Mesh, &MeshTree),
    instance: u32,
    mesh_from_world: DAffine3,
    ray: &Ray,
    search: &mut Search,
    stack: &mut Stack,
) -> bool {
    let Some(path) = Path::new(mesh_from_world, ray.origin, ray.direction, &tree.bounds) else {
        return false;
    };
    walk::<L>(
        &tree.nodes,
        &path,
        search,
        stack,
        &mut |first, count, search, _| {
            let triangles = &tree.triangles[first as usize..][..count as usize];
            let mut candidates = crossings::<L>(mesh, triangles, &path, search);
            while candidates != 0 {
                let lane = candidates.trailing_zeros() as usize;
                candidates &= candidates - 1;
                let triangle = triangles[lane][3];
                let Some(corners) = mesh.corners(triangle as usize) else {
                    continue;
                };
                let t = Plane::new(corners, path.origin).meet(path.direction);
                if search.offer(t, Hit { instance, triangle }) {
                    return true;
                }
            }
            false
        },
    )
}

/// A ray as boxes and triangles of one frame see it.
struct Path {
    origin: DVec3,
    direction: DVec3,
    /// `direction` times this is what single precision has; its own lengths are this much shorter.
    stretch: f64,
    single: [f32; 3],
    /// The origin in two parts.
    coarse: [f32; 3],
    fine: [f32; 3],
    /// A power of two that brings coordinates relative to the origin near 1.
    scale: f32,
    inverse: [f32; 3],
    /// The planes of a node that the ray meets first, and by how much the origin is moved away from each.
    first_planes: [usize; 3],
    origin_to_first: [f32; 3],
    origin_to_last: [f32; 3],
}

impl Path {
    /// `None` where the ray has no direction, or there is nothing to meet.
    #[allow(clippy::cast_possible_truncation, reason = "the rest is kept or allowed for")]
    fn new(frame_from_world: DAffine3, origin: DVec3, direction: DVec3, bounds: &Bounds) -> Option<Self> {
        let origin = frame_from_world.transform_point3(origin);
        let direction = frame_from_world.transform_vector3(direction);
        let longest = direction.abs().max_element();
        if !(origin.is_finite() && longest.is_normal() && bounds.is_finite()) {
            return None;
        }
        let stretch = power_of_two_near(1.0 / longest);
        let single = (direction * stretch).to_array().map(|x| x as f32);
        let coarse = origin.to_array().map(|x| x as f32);
        let fine: [f32; 3] = std::array::from_fn(|i| (origin[i] - f64::from(coarse[i])) as f32);
        let reach = |axis: usize| {
            let (min, max) = (bounds.min()[axis], bounds.max()[axis]);
            f64::from(min.abs().max(max.abs())) + origin[axis].abs()
        };
        let extent = (0..3).map(reach).fold(0.0, f64::max);
        // A direction along a plane of boxes still crosses them, very far away.
        let inverse = single.map(|d| 1.0 / if d.abs() < 1e-18 { 1e-18f32.copysign(d) } else { d });
        let is_forward = inverse.map(|x| x > 0.0);
        // What rounding may do to a difference of coordinates, and to their distance from the ray.
        let slack = (4e-7 * extent) as f32;
        let moved = |axis: usize, forward: bool| {
            if forward {
                coarse[axis] + slack
            } else {
                coarse[axis] - slack
            }
        };
        Some(Self {
            origin,
            direction,
            stretch,
            single,
            coarse,
            fine,
            scale: power_of_two_near(1.0 / extent.clamp(1e-37, 1e37)) as f32,
            inverse,
            first_planes: std::array::from_fn(|axis| if is_forward[axis] { axis } else { axis + 3 }),
            origin_to_first: std::array::from_fn(|axis| moved(axis, is_forward[axis])),
            origin_to_last: std::array::from_fn(|axis| moved(axis, !is_forward[axis])),
        })
    }

    /// A number of the ray's own lengths in this path's.
    #[allow(
        clippy::cast_possible_truncation,
        reason = "all that uses it allows for rounding"
    )]
    fn lengths(&self, t: f64) -> f32 {
        (t / self.stretch) as f32
    }
}

/// The power of two at or below a positive number.
pub(super) fn power_of_two_near(x: f64) -> f64 {
    f64::from_bits(x.to_bits() & 0x7ff0_0000_0000_0000)
}

/// Calls `leaf` with the items of each leaf that the ray meets, near ones first, until it says that it is over.
#[inline(always)]
fn walk<L: Lanes>(
    nodes: &[Node],
    path: &Path,
    search: &mut Search,
    stack: &mut Stack,
    leaf: &mut impl FnMut(u32, u32, &mut Search, &mut Stack) -> bool,
) -> bool {
    let base = stack.len();
    stack.push(Entry {
        start: f32::NEG_INFINITY,
        first: 0,
        count: 0,
    });
    let near = L::splat(loosened(path.lengths(search.near), -1.0));
    let inverse = path.inverse.map(L::splat);
    let to_first = path.origin_to_first.map(L::splat);
    let to_last = path.origin_to_last.map(L::splat);
    while stack.len() > base {
        let Some(entry) = stack.pop() else { break };
        let far = loosened(path.lengths(search.far), 1.0);
        if entry.start > far {
            continue;
        }
        if entry.count != 0 {
            if leaf(entry.first, entry.count, search, stack) {
                stack.truncate(base);
                return true;
            }
            continue;
        }
        let node = &nodes[entry.first as usize];
        let mut start = near;
        let mut end = L::splat(far);
        for axis in 0..3 {
            let first = L::load(&node.bounds[path.first_planes[axis]]);
            let last = L::load(&node.bounds[(path.first_planes[axis] + 3) % 6]);
            start = first.sub(to_first[axis]).mul(inverse[axis]).max(start);
            end = last.sub(to_last[axis]).mul(inverse[axis]).min(end);
        }
        let end = end.mul(L::splat(1.0 + 1e-6)).max(end.mul(L::splat(1.0 - 1e-6)));
        let mask = start.le(end).signs();
        push_children(stack, node, mask, &start.values());
    }
    false
}

/// `t` moved a little, so that rounding loses nothing: up or down.
fn loosened(t: f32, sign: f32) -> f32 {
    t + sign * t.abs() * 1e-5
}

/// Which triangles the ray passes through, as far as single precision can tell.
#[inline(always)]
fn crossings<L: Lanes>(mesh: &Mesh, triangles: &[[u32; 4]], path: &Path, search: &Search) -> u32 {
    let scale = L::splat(path.scale);
    let coarse = path.coarse.map(L::splat);
    let fine = path.fine.map(L::splat);
    let d = path.single.map(L::splat);
    let [a, b, c] = corners::<L>(&mesh.positions, triangles).map(|corner| {
        let axis = |i: usize| corner[i].sub(coarse[i]).sub(fine[i]).mul(scale);
        [axis(0), axis(1), axis(2)]
    });
    let side = |p: [L; 3], q: [L; 3]| dot(d, cross(add(p, q), sub(q, p)));
    let sides = [side(a, b), side(b, c), side(c, a)];
    let normal = cross(sub(b, a), sub(c, a));
    let t = dot(a, normal).div(dot(d, normal));
    let zero = L::splat(0.0);
    let least = sides[0].min(sides[1]).min(sides[2]);
    let greatest = sides[0].max(sides[1]).max(sides[2]);
    let limit = |t: f64, sign: f32| {
        let t = path.lengths(t) * path.scale;
        L::splat(t + sign * t.abs() * 1e-4)
    };
    let in_range = limit(search.near, -1.0).le(t).and(t.le(limit(search.far, 1.0)));
    let is_inside = zero.le(least).signs() | greatest.le(zero).signs();
    is_inside & in_range.signs() & ((1u32 << triangles.len()) - 1)
}
