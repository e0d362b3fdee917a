//! Single rays, tested against eight boxes or eight triangles at once.

use oaktwin_camera::math::{DAffine3, DVec3};
use oaktwin_scene::{Mesh, Scene};
use oaktwin_simd::{I32Lanes, LaneKernel, Lanes};

use super::bvh::{Bounds, Node};
use super::corners::corners;
use super::exact::{Plane, Triangle};
use super::mesh_tree::MeshTree;
use super::stack::{Entries, Entry, Leaf, push_children};
use super::vector::Vector;
use super::{Prepared, Ray};
use crate::Hit;
use crate::cutout::{Cutouts, Transparent};

/// The state of a search along a ray.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Search<'a> {
    scene: &'a Scene,
    cutouts: Option<&'a Cutouts>,
    ray: &'a Ray,
    /// The nearest crossing so far, or the end of the ray.
    far: f64,
    hit: Hit,
    /// The leaf of `hit`.
    leaf: Leaf,
    until: Until,
    transparent: Transparent,
    sides: Sides,
}

/// The arithmetic that decides on which side of an edge the ray passes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Sides {
    /// Single precision for all triangles but those with an edge that points at the origin.
    Mixed,
    /// The same, and a triangle was not met that single precision takes for met. Its neighbours may have been missed.
    Rejected,
    /// Double precision for all triangles.
    Exact,
}

/// The square of the angle between an edge and the direction to it for which single precision is not trusted.
pub(super) const NEEDLE: f64 = 1.0 / 1024.0;

/// The condition that ends a search.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Until {
    /// The nearest crossing, both ends of the ray included.
    Nearest,
    /// The nearest crossing up to a distance, or any beyond it, which is reported at that distance.
    NearestWithin(f64),
    /// Any crossing between the ends, both excluded.
    Any,
}

impl Search<'_> {
    /// Considers a crossing and returns whether the search is over.
    fn offer(&mut self, t: f64, hit: Hit) -> bool {
        let near = self.ray.near;
        let is_wanted = match self.until {
            Until::Any => t > near && t < self.far,
            Until::Nearest | Until::NearestWithin(_) => {
                t >= near && (t < self.far || (t == self.far && hit < self.hit))
            }
        };
        if !is_wanted || !self.shows(hit) {
            return false;
        }
        self.hit = hit;
        match self.until {
            Until::Any => return true,
            Until::Nearest => self.far = t,
            Until::NearestWithin(reach) => self.far = t.min(reach),
        }
        false
    }

    #[inline]
    fn shows(&self, hit: Hit) -> bool {
        let Ray {
            origin, direction, ..
        } = *self.ray;
        self.cutouts
            .is_none_or(|cutouts| cutouts.shows(self.scene, hit, origin, direction, self.transparent))
    }
}

/// Casts a ray through the scene.
pub(crate) struct Cast<'a> {
    pub(crate) scene: &'a Prepared<'a>,
    pub(crate) cutouts: Option<&'a Cutouts>,
    pub(crate) ray: Ray,
    pub(crate) until: Until,
    /// Whether the ray meets clear surfaces.
    pub(crate) transparent: Transparent,
    pub(crate) stack: &'a mut Entries,
    /// The leaf to look at first; then the one where the search ended.
    pub(crate) leaf: &'a mut Leaf,
}

impl LaneKernel for Cast<'_> {
    type Output = Option<(f64, Hit)>;

    #[inline(always)]
    fn run<L: Lanes>(self) -> Self::Output {
        let Ray {
            origin,
            direction,
            far,
            ..
        } = self.ray;
        let top = self.scene.instances;
        let path = Path::new(DAffine3::IDENTITY, origin, direction, &top.bounds)?;
        let stack = self.stack;
        let mut sides = Sides::Mixed;
        loop {
            let mut search = Search {
                scene: self.scene.scene,
                cutouts: self.cutouts,
                ray: &self.ray,
                far,
                hit: Hit::MISS,
                leaf: Leaf::NONE,
                until: self.until,
                transparent: self.transparent,
                sides,
            };
            stack.clear();
            let mut visit = VisitInstances {
                scene: self.scene,
                ray: &self.ray,
            };
            let is_over = visit.triangles::<L>(*self.leaf, &mut search, stack)
                || walk::<L>(&top.nodes, &path, &mut search, stack, &mut visit);
            if search.sides != Sides::Rejected || is_over {
                if search.leaf.count != 0 {
                    *self.leaf = search.leaf;
                }
                return (!search.hit.is_miss()).then_some((search.far, search.hit));
            }
            sides = Sides::Exact;
        }
    }
}

/// The handling of leaves.
trait Visit {
    /// Tests the items of a leaf and returns whether the search is over.
    fn leaf<L: Lanes>(
        &mut self,
        first: u32,
        count: u32,
        search: &mut Search<'_>,
        stack: &mut Entries,
    ) -> bool;
}

struct VisitInstances<'a> {
    scene: &'a Prepared<'a>,
    ray: &'a Ray,
}

impl VisitInstances<'_> {
    /// Tests the triangles of a leaf and returns whether the search is over.
    #[inline(always)]
    fn triangles<L: Lanes>(&self, leaf: Leaf, search: &mut Search<'_>, stack: &mut Entries) -> bool {
        let Leaf {
            instance,
            first,
            count,
        } = leaf;
        if count == 0 {
            return false;
        }
        let Some((mesh, tree, mesh_from_world)) = self.scene.instance(instance) else {
            return false;
        };
        let path = Path::new(mesh_from_world, self.ray.origin, self.ray.direction, &tree.bounds);
        let Some(path) = path else { return false };
        let mut visit = VisitTriangles {
            mesh,
            tree,
            instance,
            path: &path,
        };
        visit.leaf::<L>(first, count, search, stack)
    }
}

impl Visit for VisitInstances<'_> {
    #[inline(always)]
    fn leaf<L: Lanes>(
        &mut self,
        first: u32,
        count: u32,
        search: &mut Search<'_>,
        stack: &mut Entries,
    ) -> bool {
        for &instance in &self.scene.instances.order[first as usize..][..count as usize] {
            let Some((mesh, tree, mesh_from_world)) = self.scene.instance(instance) else {
                continue;
            };
            let path = Path::new(mesh_from_world, self.ray.origin, self.ray.direction, &tree.bounds);
            let Some(path) = path else { continue };
            let mut visit = VisitTriangles {
                mesh,
                tree,
                instance,
                path: &path,
            };
            if walk::<L>(&tree.nodes, &path, search, stack, &mut visit) {
                return true;
            }
        }
        false
    }
}

struct VisitTriangles<'a> {
    mesh: &'a Mesh,
    tree: &'a MeshTree,
    instance: u32,
    path: &'a Path,
}

impl Visit for VisitTriangles<'_> {
    #[inline(always)]
    fn leaf<L: Lanes>(&mut self, first: u32, count: u32, search: &mut Search<'_>, _: &mut Entries) -> bool {
        let triangles = &self.tree.triangles[first as usize..][..count as usize];
        let mut candidates = match search.sides {
            Sides::Exact => (1 << triangles.len()) - 1,
            Sides::Mixed | Sides::Rejected => crossings::<L>(self.mesh, triangles, self.path, search),
        };
        while candidates != 0 {
            let lane = candidates.trailing_zeros() as usize;
            candidates &= candidates - 1;
            let last = search.hit;
            let is_over = self.is_over_at(triangles[lane], search);
            if search.hit != last {
                search.leaf = Leaf {
                    instance: self.instance,
                    first,
                    count,
                };
            }
            if is_over {
                return true;
            }
        }
        false
    }
}

impl VisitTriangles<'_> {
    fn is_over_at(&self, [a, b, c, triangle]: [u32; 4], search: &mut Search<'_>) -> bool {
        let corners = [a, b, c].map(|index| self.mesh.positions[index as usize]);
        let Path {
            origin, direction, ..
        } = *self.path;
        let plane = Plane::new(corners, origin);
        let exact = Triangle::new(corners, origin);
        if search.sides == Sides::Exact {
            if !exact.is_met(direction) {
                return false;
            }
        } else if exact.is_needle(&plane, NEEDLE) && !exact.is_met(direction) {
            search.sides = Sides::Rejected;
            return false;
        }
        let t = plane.meet(direction);
        let instance = self.instance;
        search.offer(t, Hit { instance, triangle })
    }
}

/// A ray in the frame of a hierarchy.
struct Path {
    origin: DVec3,
    direction: DVec3,
    /// The factor from `direction` to `single`.
    stretch: f64,
    single: [f32; 3],
    /// The origin in two parts.
    coarse: [f32; 3],
    fine: [f32; 3],
    /// A power of two that brings coordinates relative to the origin near 1.
    scale: f32,
    inverse: [f32; 3],
    /// The planes of a box that the ray meets first and last, and the origin moved away from them.
    first_planes: [usize; 3],
    last_planes: [usize; 3],
    origin_to_first: [f32; 3],
    origin_to_last: [f32; 3],
}

impl Path {
    /// Creates the ray; `None` if it has no direction or the bounds are not finite.
    #[allow(
        clippy::cast_possible_truncation,
        reason = "the remainder is kept or within the slack"
    )]
    #[inline(always)]
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
        // A direction parallel to the planes of boxes still crosses them, very far away.
        let inverse = single.map(|d| 1.0 / if d.abs() < 1e-18 { 1e-18f32.copysign(d) } else { d });
        let is_forward = inverse.map(|x| x > 0.0);
        // The rounding error of differences of coordinates and of their distance from the ray.
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
            last_planes: std::array::from_fn(|axis| if is_forward[axis] { axis + 3 } else { axis }),
            origin_to_first: std::array::from_fn(|axis| moved(axis, is_forward[axis])),
            origin_to_last: std::array::from_fn(|axis| moved(axis, !is_forward[axis])),
        })
    }

    /// Converts a distance in lengths of the ray's direction.
    #[allow(clippy::cast_possible_truncation, reason = "callers add a slack for rounding")]
    fn lengths(&self, t: f64) -> f32 {
        (t / self.stretch) as f32
    }
}

/// The power of two at or below a positive number.
pub(super) fn power_of_two_near(x: f64) -> f64 {
    f64::from_bits(x.to_bits() & 0x7ff0_0000_0000_0000)
}

/// Visits each leaf that the ray meets, from near to far, until the search is over, and returns whether it is.
#[inline(always)]
fn walk<L: Lanes>(
    nodes: &[Node],
    path: &Path,
    search: &mut Search<'_>,
    stack: &mut Entries,
    visit: &mut impl Visit,
) -> bool {
    let base = stack.len();
    stack.push(Entry::ROOT);
    let near = L::splat(loosened(path.lengths(search.ray.near), -1e-5));
    let inverse = Vector::<L>::splat(path.inverse);
    let to_first = Vector::<L>::splat(path.origin_to_first);
    let to_last = Vector::<L>::splat(path.origin_to_last);
    let [x, y, z] = path.first_planes;
    let [x1, y1, z1] = path.last_planes;
    while stack.len() > base {
        let Some(entry) = stack.pop() else { break };
        let far = loosened(path.lengths(search.far), 1e-5);
        if entry.start > far {
            continue;
        }
        if entry.count != 0 {
            if visit.leaf::<L>(entry.first, entry.count, search, stack) {
                stack.truncate(base);
                return true;
            }
            continue;
        }
        let node = &nodes[entry.first as usize];
        let planes = &node.bounds;
        // In this order NaN propagates and hides the child.
        let start = near
            .max((L::load(&planes[x]) - to_first.x) * inverse.x)
            .max((L::load(&planes[y]) - to_first.y) * inverse.y)
            .max((L::load(&planes[z]) - to_first.z) * inverse.z);
        let end = L::splat(far)
            .min((L::load(&planes[x1]) - to_last.x) * inverse.x)
            .min((L::load(&planes[y1]) - to_last.y) * inverse.y)
            .min((L::load(&planes[z1]) - to_last.z) * inverse.z);
        let end = (end * L::splat(1.0 + 1e-6)).max(end * L::splat(1.0 - 1e-6));
        push_children(stack, node, start.le(end), start);
    }
    false
}

/// Moves `t` by a fraction of itself as a margin for rounding.
pub(super) fn loosened(t: f32, part: f32) -> f32 {
    t + t.abs() * part
}

/// Returns the triangles that the ray may cross, in single precision with a margin, as bits.
#[inline(always)]
fn crossings<L: Lanes>(mesh: &Mesh, triangles: &[[u32; 4]], path: &Path, search: &Search<'_>) -> u32 {
    let scale = L::splat(path.scale);
    let coarse = Vector::splat(path.coarse);
    let fine = Vector::splat(path.fine);
    let direction = Vector::<L>::splat(path.single);
    let [a, b, c] = corners::<L>(&mesh.positions, triangles);
    let a = (a - coarse - fine) * scale;
    let b = (b - coarse - fine) * scale;
    let c = (c - coarse - fine) * scale;
    let ab = a.side(b).dot(direction);
    let bc = b.side(c).dot(direction);
    let ca = c.side(a).dot(direction);
    let normal = (b - a).cross(c - a);
    let t = a.dot(normal) / direction.dot(normal);
    let zero = L::splat(0.0);
    let is_inside = zero.le(ab.min(bc).min(ca)).signs() | ab.max(bc).max(ca).le(zero).signs();
    let near = loosened(path.lengths(search.ray.near) * path.scale, -1e-4);
    let far = loosened(path.lengths(search.far) * path.scale, 1e-4);
    let in_range = L::splat(near).le(t) & t.le(L::splat(far));
    is_inside & in_range.signs() & ((1u32 << triangles.len()) - 1)
}
