//! Rays from one point to places close to each other, traced together: boxes are tested once for all of them.

use oaktwin_camera::math::{DAffine3, DVec3};
use oaktwin_scene::{Mesh, Scene};
use oaktwin_simd::{I32Lanes, LaneKernel, Lanes};

use super::bvh::{Bounds, Node};
use super::corners::corners;
use super::exact::{Plane, Triangle};
use super::mesh_tree::MeshTree;
use super::single::{NEEDLE, loosened, power_of_two_near};
use super::stack::{Entries, Entry, Leaf, push_children};
use super::vector::Vector;
use super::{Prepared, Ray};
use crate::Hit;
use crate::cutout::{Cutouts, Transparent};

/// The number of rays in a bundle.
pub(crate) const RAYS: usize = 64;

/// Rays from a point in the world.
#[derive(Clone, Debug)]
pub(crate) struct Rays {
    /// The origin, metres.
    pub(crate) origin: DVec3,
    /// The directions, which need not be normalized.
    pub(crate) directions: [DVec3; RAYS],
    /// The bits of the rays that there are.
    pub(crate) used: u64,
    /// The end of all rays, in lengths of their directions.
    pub(crate) far: f64,
}

impl Rays {
    pub(super) fn ray(&self, index: usize) -> Ray {
        Ray {
            origin: self.origin,
            direction: self.directions.get(index).copied().unwrap_or_default(),
            near: 0.0,
            far: self.far,
        }
    }
}

/// Finds the rays that something stops, between the origin and `far`, both excluded.
pub(crate) struct Bundle<'a> {
    pub(crate) scene: &'a Prepared<'a>,
    pub(crate) cutouts: Option<&'a Cutouts>,
    pub(crate) rays: &'a Rays,
    pub(crate) stack: &'a mut Entries,
    /// The leaf to look at first; then the last one that stopped a ray.
    pub(crate) leaf: &'a mut Leaf,
}

/// The rays that are stopped, and those for which single precision does not decide.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Stopped {
    pub(crate) certain: u64,
    pub(crate) unclear: u64,
}

/// What is known about the rays so far.
struct TraversalState<'a> {
    scene: &'a Scene,
    cutouts: Option<&'a Cutouts>,
    rays: &'a Rays,
    /// The rays that nothing has stopped yet.
    open: u64,
    unclear: u64,
    /// The last leaf that stopped a ray.
    leaf: Leaf,
    /// The directions of the open rays in the frame that was made last, in double and in single precision.
    directions: [DVec3; RAYS],
    singles: [[f32; 3]; RAYS],
}

impl LaneKernel for Bundle<'_> {
    type Output = Stopped;

    #[inline(always)]
    fn run<L: Lanes>(mut self) -> Stopped {
        let mut state = TraversalState {
            scene: self.scene.scene,
            cutouts: self.cutouts,
            rays: self.rays,
            open: self.rays.used,
            unclear: 0,
            leaf: *self.leaf,
            directions: [DVec3::ZERO; RAYS],
            singles: [[0.0; 3]; RAYS],
        };
        let used = self.rays.used;
        self.trace::<L>(&mut state);
        *self.leaf = state.leaf;
        Stopped {
            certain: used & !state.open,
            unclear: state.unclear & state.open,
        }
    }
}

impl Bundle<'_> {
    #[inline(always)]
    fn trace<L: Lanes>(&mut self, state: &mut TraversalState<'_>) {
        let top = self.scene.instances;
        if self.leaf.count != 0
            && let Some((mesh, tree, mesh_from_world)) = self.scene.instance(self.leaf.instance)
            && let Some(frame) = BundleRays::new(mesh_from_world, state, &tree.bounds)
        {
            frame.leaf::<L>(mesh, tree, self.leaf, state);
        }
        let Some(frame) = BundleRays::new(DAffine3::IDENTITY, state, &top.bounds) else {
            return;
        };
        self.stack.clear();
        let visit = Instances { scene: self.scene };
        walk::<L>(&top.nodes, &frame, state, self.stack, &visit);
    }
}

/// The handling of leaves.
trait Visit {
    /// Tests the items of a leaf.
    fn leaf<L: Lanes>(&self, first: u32, count: u32, state: &mut TraversalState<'_>, stack: &mut Entries);
}

struct Instances<'a> {
    scene: &'a Prepared<'a>,
}

impl Visit for Instances<'_> {
    #[inline(always)]
    fn leaf<L: Lanes>(&self, first: u32, count: u32, state: &mut TraversalState<'_>, stack: &mut Entries) {
        for &instance in &self.scene.instances.order[first as usize..][..count as usize] {
            let Some((mesh, tree, mesh_from_world)) = self.scene.instance(instance) else {
                continue;
            };
            let Some(frame) = BundleRays::new(mesh_from_world, state, &tree.bounds) else {
                continue;
            };
            let visit = Triangles {
                mesh,
                tree,
                instance,
                frame: &frame,
            };
            walk::<L>(&tree.nodes, &frame, state, stack, &visit);
            if state.open == 0 {
                return;
            }
        }
    }
}

struct Triangles<'a> {
    mesh: &'a Mesh,
    tree: &'a MeshTree,
    instance: u32,
    frame: &'a BundleRays,
}

impl Visit for Triangles<'_> {
    #[inline(always)]
    fn leaf<L: Lanes>(&self, first: u32, count: u32, state: &mut TraversalState<'_>, _: &mut Entries) {
        let leaf = Leaf {
            instance: self.instance,
            first,
            count,
        };
        self.frame.leaf::<L>(self.mesh, self.tree, &leaf, state);
    }
}

/// A condition on the distances at which a ray of the bundle can be inside a box: beyond, or before, a plane of it.
#[derive(Clone, Copy, Debug, Default)]
struct Bound {
    plane: usize,
    /// The coordinate of the origin, moved away from the plane.
    origin: f32,
    /// The inverse of the direction of the ray that meets the plane first, or last.
    inverse: f32,
}

impl Bound {
    /// Returns the distances of the planes of a node's children.
    #[inline(always)]
    fn meet<L: Lanes>(&self, node: &Node) -> L {
        (L::load(&node.bounds[self.plane]) - L::splat(self.origin)) * L::splat(self.inverse)
    }
}

/// The rays in the frame of a hierarchy.
struct BundleRays {
    origin: DVec3,
    /// The end of the rays, in lengths of their directions in single precision.
    far: f32,
    /// The smallest and the largest coordinates of these.
    range: [[f32; 3]; 2],
    /// The origin in two parts.
    coarse: [f32; 3],
    fine: [f32; 3],
    /// A power of two that brings coordinates relative to the origin near 1.
    scale: f32,
    starts: [Bound; 6],
    start_count: usize,
    ends: [Bound; 3],
    end_count: usize,
}

impl BundleRays {
    /// Creates the rays that are still open; `None` if they have no directions or the bounds are not finite.
    #[allow(
        clippy::cast_possible_truncation,
        reason = "the remainder is kept or within the slack"
    )]
    #[inline(always)]
    fn new(mesh_from_world: DAffine3, state: &mut TraversalState<'_>, bounds: &Bounds) -> Option<Self> {
        let origin = mesh_from_world.transform_point3(state.rays.origin);
        let [mut low, mut high] = [DVec3::INFINITY, DVec3::NEG_INFINITY];
        for ray in bits(state.open) {
            let direction = mesh_from_world.matrix3 * state.rays.directions[ray];
            state.directions[ray] = direction;
            low = low.min(direction);
            high = high.max(direction);
        }
        let longest = low.abs().max(high.abs()).max_element();
        if !(origin.is_finite() && longest.is_normal() && bounds.is_finite()) {
            return None;
        }
        let stretch = power_of_two_near(1.0 / longest);
        for ray in bits(state.open) {
            state.singles[ray] = (state.directions[ray] * stretch).to_array().map(|x| x as f32);
        }
        let [low, high] = [low, high].map(|d| (d * stretch).to_array().map(|x| x as f32));
        let coarse = origin.to_array().map(|x| x as f32);
        let fine = std::array::from_fn(|i| (origin[i] - f64::from(coarse[i])) as f32);
        let reach = |axis: usize| {
            let (min, max) = (bounds.min()[axis], bounds.max()[axis]);
            f64::from(min.abs().max(max.abs())) + origin[axis].abs()
        };
        let extent = (0..3).map(reach).fold(0.0, f64::max);
        // The rounding error of differences of coordinates and of their distance from the rays.
        let slack = (4e-7 * extent) as f32;
        let mut frame = Self {
            origin,
            far: (state.rays.far / stretch) as f32,
            range: [low, high],
            coarse,
            fine,
            scale: power_of_two_near(1.0 / extent.clamp(1e-37, 1e37)) as f32,
            starts: [Bound::default(); 6],
            start_count: 0,
            ends: [Bound::default(); 3],
            end_count: 0,
        };
        for axis in 0..3 {
            let inverse = |d: f32| 1.0 / if d.abs() < 1e-18 { 1e-18f32.copysign(d) } else { d };
            let to_min = |d: f32| Bound {
                plane: axis,
                origin: coarse[axis] + slack,
                inverse: inverse(d),
            };
            let to_max = |d: f32| Bound {
                plane: axis + 3,
                origin: coarse[axis] - slack,
                inverse: inverse(d),
            };
            let (low, high) = (low[axis], high[axis]);
            // A zero counts as positive.
            if low >= 0.0 {
                frame.start_at(to_min(high.abs()));
                frame.end_at(to_max(low.abs()));
            } else if high < 0.0 {
                frame.start_at(to_max(low));
                frame.end_at(to_min(high));
            } else {
                frame.start_at(to_max(low));
                frame.start_at(to_min(high.abs()));
            }
        }
        Some(frame)
    }

    #[inline(always)]
    fn start_at(&mut self, bound: Bound) {
        self.starts[self.start_count] = bound;
        self.start_count += 1;
    }

    #[inline(always)]
    fn end_at(&mut self, bound: Bound) {
        self.ends[self.end_count] = bound;
        self.end_count += 1;
    }

    /// Tests the open rays against the triangles of a leaf, as [`single`](super::single) does.
    #[inline(always)]
    fn leaf<L: Lanes>(&self, mesh: &Mesh, tree: &MeshTree, leaf: &Leaf, state: &mut TraversalState<'_>) {
        let triangles = &tree.triangles[leaf.first as usize..][..leaf.count as usize];
        let scale = L::splat(self.scale);
        let (coarse, fine) = (Vector::splat(self.coarse), Vector::splat(self.fine));
        let [a, b, c] = corners::<L>(&mesh.positions, triangles);
        let a = (a - coarse - fine) * scale;
        let b = (b - coarse - fine) * scale;
        let c = (c - coarse - fine) * scale;
        let sides = [a.side(b), b.side(c), c.side(a)];
        let normal = (b - a).cross(c - a);
        let distance = a.dot(normal);
        let zero = L::splat(0.0);
        // Rounding is monotonic, so these are bounds of what the rays get.
        let [ab, bc, ca] = [
            self.bounds(sides[0]),
            self.bounds(sides[1]),
            self.bounds(sides[2]),
        ];
        let may_be_inside =
            zero.le(ab[1].min(bc[1]).min(ca[1])).signs() | ab[0].max(bc[0]).max(ca[0]).le(zero).signs();
        if may_be_inside & ((1u32 << triangles.len()) - 1) == 0 {
            return;
        }
        let far = L::splat(loosened(self.far * self.scale, 1e-4));
        let mut open = state.open;
        while open != 0 {
            let ray = open.trailing_zeros() as usize;
            open &= open - 1;
            let direction = Vector::<L>::splat(state.singles[ray]);
            let [ab, bc, ca] = [
                sides[0].dot(direction),
                sides[1].dot(direction),
                sides[2].dot(direction),
            ];
            let t = distance / direction.dot(normal);
            let is_inside = zero.le(ab.min(bc).min(ca)).signs() | ab.max(bc).max(ca).le(zero).signs();
            let in_range = zero.le(t) & t.le(far);
            let candidates = is_inside & in_range.signs() & ((1u32 << triangles.len()) - 1);
            if candidates != 0 {
                self.decide(mesh, triangles, candidates, ray, leaf, state);
            }
        }
    }

    /// Returns the least and the greatest products of vectors with directions of the bundle.
    #[inline(always)]
    fn bounds<L: Lanes>(&self, vector: Vector<L>) -> [L; 2] {
        let [low, high] = [
            Vector::<L>::splat(self.range[0]),
            Vector::<L>::splat(self.range[1]),
        ];
        let [xs, ys, zs] = [
            [vector.x * low.x, vector.x * high.x],
            [vector.y * low.y, vector.y * high.y],
            [vector.z * low.z, vector.z * high.z],
        ];
        [
            xs[0].min(xs[1]) + ys[0].min(ys[1]) + zs[0].min(zs[1]),
            xs[0].max(xs[1]) + ys[0].max(ys[1]) + zs[0].max(zs[1]),
        ]
    }

    /// Decides in double precision whether triangles stop a ray.
    fn decide(
        &self,
        mesh: &Mesh,
        triangles: &[[u32; 4]],
        mut candidates: u32,
        ray: usize,
        leaf: &Leaf,
        state: &mut TraversalState<'_>,
    ) {
        let direction = state.directions[ray];
        while candidates != 0 {
            let [a, b, c, triangle] = triangles[candidates.trailing_zeros() as usize];
            candidates &= candidates - 1;
            let corners = [a, b, c].map(|index| mesh.positions[index as usize]);
            let plane = Plane::new(corners, self.origin);
            let exact = Triangle::new(corners, self.origin);
            if exact.is_needle(&plane, NEEDLE) && !exact.is_met(direction) {
                state.unclear |= 1 << ray;
                continue;
            }
            let t = plane.meet(direction);
            let instance = leaf.instance;
            let hit = Hit { instance, triangle };
            if t > 0.0 && t < state.rays.far && state.shows(hit, ray) {
                state.open &= !(1 << ray);
                state.leaf = *leaf;
                return;
            }
        }
    }
}

impl TraversalState<'_> {
    #[inline]
    fn shows(&self, hit: Hit, ray: usize) -> bool {
        let (origin, direction) = (self.rays.origin, self.rays.directions[ray]);
        self.cutouts
            .is_none_or(|cutouts| cutouts.shows(self.scene, hit, origin, direction, Transparent::Through))
    }
}

/// The numbers of the set bits.
#[inline(always)]
pub(crate) fn bits(mut set: u64) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let next = (set != 0).then(|| set.trailing_zeros() as usize);
        set &= set.wrapping_sub(1);
        next
    })
}

/// Visits each leaf that a ray may meet, from near to far, until no ray is open.
#[inline(always)]
fn walk<L: Lanes>(
    nodes: &[Node],
    frame: &BundleRays,
    state: &mut TraversalState<'_>,
    stack: &mut Entries,
    visit: &impl Visit,
) {
    let base = stack.len();
    stack.push(Entry::ROOT);
    let far = L::splat(loosened(frame.far, 1e-5));
    while stack.len() > base && state.open != 0 {
        let Some(entry) = stack.pop() else { break };
        if entry.count != 0 {
            visit.leaf::<L>(entry.first, entry.count, state, stack);
            continue;
        }
        let node = &nodes[entry.first as usize];
        // In this order NaN propagates and hides the child.
        let mut start = L::splat(0.0);
        for bound in &frame.starts[..frame.start_count] {
            start = start.max(bound.meet::<L>(node));
        }
        let mut end = far;
        for bound in &frame.ends[..frame.end_count] {
            end = end.min(bound.meet::<L>(node));
        }
        let end = (end * L::splat(1.0 + 1e-6)).max(end * L::splat(1.0 - 1e-6));
        push_children(stack, node, start.le(end), start);
    }
    stack.truncate(base);
}
