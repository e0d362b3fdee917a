use oaktwin_camera::math::{DAffine3, DMat3, DVec3};
use oaktwin_scene::Mesh;
use oaktwin_simd::{LaneKernel, Lanes};

use super::rays::TileRays;
use super::state::{Leaf, TileState};
use super::transform::TileTransform;
use super::triangles::Triangles;
use crate::Clip;
use crate::ray::Prepared;
use crate::ray::bvh::Node;
use crate::ray::corners::corners;
use crate::ray::mesh_tree::MeshTree;
use crate::ray::stack::{Entries, Entry, push_children};

/// The origin of all rays.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Origin {
    /// The point in the world.
    pub(crate) point: DVec3,
    pub(crate) camera_from_world: DMat3,
    /// A power of two by which lengths in the tile frame are scaled to moderate magnitudes.
    pub(crate) scale: f64,
}

/// Traces the rays of a tile through the scene.
pub(crate) struct Trace<'a> {
    pub(crate) scene: &'a Prepared<'a>,
    pub(crate) origin: &'a Origin,
    pub(crate) rays: &'a TileRays,
    pub(crate) clip: Clip,
    pub(crate) state: &'a mut TileState,
    pub(crate) stack: &'a mut Entries,
}

impl LaneKernel for Trace<'_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self) {
        let Self {
            scene,
            origin,
            rays,
            clip,
            state,
            stack,
        } = self;
        state.reset::<L>(rays, clip, origin.scale);
        if rays.is_empty() {
            return;
        }
        let top = scene.instances;
        let tile_from_world = rays.tile_from_camera * origin.camera_from_world * origin.scale;
        let world = TileTransform::new(
            &tile_from_world,
            origin.point,
            &DAffine3::IDENTITY,
            &top.bounds,
            &rays.all,
        );
        let Some(world) = world else { return };
        stack.clear();
        let mut visit = VisitInstances {
            scene,
            origin,
            rays,
            tile_from_world,
        };
        walk::<L>(&top.nodes, &world, state, stack, &mut visit);
    }
}

/// The handling of leaves.
trait Visit {
    fn leaf<L: Lanes>(&mut self, first: u32, count: u32, state: &mut TileState, stack: &mut Entries);

    #[inline(always)]
    fn prefetch_early<L: Lanes>(&self, _first: u32) {}
    #[inline(always)]
    fn prefetch<L: Lanes>(&self, _first: u32, _count: u32) {}
}

struct VisitInstances<'a> {
    scene: &'a Prepared<'a>,
    origin: &'a Origin,
    rays: &'a TileRays,
    tile_from_world: DMat3,
}

impl Visit for VisitInstances<'_> {
    #[inline(always)]
    fn leaf<L: Lanes>(&mut self, first: u32, count: u32, state: &mut TileState, stack: &mut Entries) {
        for &instance in &self.scene.instances.order[first as usize..][..count as usize] {
            let Some((mesh, tree, mesh_from_world)) = self.scene.instance(instance) else {
                continue;
            };
            let frame = TileTransform::new(
                &self.tile_from_world,
                mesh_from_world.transform_point3(self.origin.point),
                &self.scene.scene.instances[instance as usize].world_from_mesh,
                &tree.bounds,
                &self.rays.all,
            );
            let Some(frame) = frame else { continue };
            let mut visit = VisitTriangles {
                mesh,
                tree,
                instance,
                frame: &frame,
                rays: self.rays,
                ready: Triangles::NONE,
            };
            walk::<L>(&tree.nodes, &frame, state, stack, &mut visit);
        }
    }
}

struct VisitTriangles<'a> {
    mesh: &'a Mesh,
    tree: &'a MeshTree,
    instance: u32,
    frame: &'a TileTransform,
    rays: &'a TileRays,
    ready: Triangles,
}

impl Visit for VisitTriangles<'_> {
    #[inline(always)]
    fn prefetch_early<L: Lanes>(&self, first: u32) {
        let triangles = &self.tree.triangles[first as usize..];
        L::prefetch(&triangles[0]);
        L::prefetch(&triangles[4.min(triangles.len() - 1)]);
    }
    #[inline(always)]
    fn prefetch<L: Lanes>(&self, first: u32, count: u32) {
        for triangle in &self.tree.triangles[first as usize..][..count as usize] {
            L::prefetch(&self.mesh.positions[triangle[0] as usize]);
        }
    }

    #[inline(always)]
    fn leaf<L: Lanes>(&mut self, first: u32, count: u32, state: &mut TileState, _: &mut Entries) {
        let triangles = &self.tree.triangles[first as usize..][..count as usize];
        let corners = corners::<L>(&self.mesh.positions, triangles);
        self.ready
            .set(corners, self.frame, self.rays, state.min_inverse_z);
        let needles = self.ready.needles.into_iter().fold(0, |all, edges| all | edges);
        let mut unsure = (self.ready.vast | needles) & ((1 << triangles.len()) - 1);
        while unsure != 0 {
            let lane = unsure.trailing_zeros() as usize & 7;
            unsure &= unsure - 1;
            let [a, b, c, _] = triangles[lane].map(|index| index as usize);
            let corners = [a, b, c].map(|vertex| self.mesh.positions[vertex]);
            self.ready.refine(lane, corners, self.frame);
            if needles >> lane & 1 == 1 {
                self.ready.refine_sides(lane, corners, self.frame);
            }
        }
        let leaf = Leaf {
            instance: self.instance,
            first,
            triangles,
            tree: self.tree,
        };
        state.test::<L>(self.rays, &self.ready, &leaf);
    }
}

/// Visits each leaf that the tile may see, from near to far.
#[inline(always)]
fn walk<L: Lanes>(
    nodes: &[Node],
    frame: &TileTransform,
    state: &mut TileState,
    stack: &mut Entries,
    visit: &mut impl Visit,
) {
    let base = stack.len();
    stack.push(Entry::ROOT);
    while stack.len() > base {
        let Some(entry) = stack.pop() else { break };
        if entry.start > state.farthest {
            continue;
        }
        if entry.count != 0 {
            if let Some(next) = stack[base..].last().filter(|next| next.count != 0) {
                visit.prefetch::<L>(next.first, next.count);
            }
            visit.leaf::<L>(entry.first, entry.count, state, stack);
            continue;
        }
        let node = &nodes[entry.first as usize];
        let (seen, starts) = frame.children::<L>(node, state.farthest);
        let from = stack.len();
        push_children(stack, node, seen, starts);
        for entry in &stack[from..] {
            if entry.count == 0 {
                let bounds = &nodes[entry.first as usize].bounds;
                L::prefetch(&bounds[0]);
                L::prefetch(&bounds[2]);
                L::prefetch(&bounds[4]);
            } else {
                visit.prefetch_early::<L>(entry.first);
            }
        }
    }
}
