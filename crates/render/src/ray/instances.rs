use oaktwin_camera::math::{DAffine3, DVec3};
use oaktwin_scene::Scene;

use super::bvh::{self, Bounds, Item, Node};
use super::mesh_tree::MeshTree;

/// The most instances of a leaf: to look into one costs more than to look at its box.
const LEAF: usize = 1;

/// The boxes over a scene's instances.
#[derive(Debug)]
pub(crate) struct Instances {
    /// The first is the root.
    pub(crate) nodes: Vec<Node>,
    /// The instances that leaves refer to.
    pub(crate) order: Vec<u32>,
    /// Of each of the scene's instances.
    pub(crate) mesh_from_world: Vec<DAffine3>,
    /// In the world.
    pub(crate) bounds: Bounds,
}

impl Instances {
    /// Instances without triangles, or that cannot be inverted, are left out.
    pub(crate) fn new(scene: &Scene, trees: &[MeshTree]) -> Self {
        let mut items = Vec::new();
        let mut mesh_from_world = Vec::with_capacity(scene.instances.len());
        for (index, instance) in (0u32..).zip(&scene.instances) {
            let inverse = instance.world_from_mesh.inverse();
            mesh_from_world.push(inverse);
            let Some(tree) = trees.get(instance.mesh as usize) else {
                continue;
            };
            if tree.triangles.is_empty() || !inverse.is_finite() {
                continue;
            }
            let bounds = in_world(&tree.bounds, &instance.world_from_mesh);
            if bounds.is_finite() {
                items.push(Item::new(bounds, index));
            }
        }
        let nodes = bvh::build(&mut items, LEAF);
        let bounds = Bounds::of_nodes(&nodes[0]);
        let order = items.iter().map(Item::index).collect();
        Self {
            nodes,
            order,
            mesh_from_world,
            bounds,
        }
    }
}

/// The box around a box that has been moved.
#[allow(clippy::cast_possible_truncation, reason = "rounded outwards")]
fn in_world(bounds: &Bounds, world_from_mesh: &DAffine3) -> Bounds {
    let (min, max) = (bounds.min(), bounds.max());
    let mut low = DVec3::INFINITY;
    let mut high = DVec3::NEG_INFINITY;
    for corner in 0..8u8 {
        let pick = |axis: usize| {
            f64::from(if corner >> axis & 1 == 0 {
                min[axis]
            } else {
                max[axis]
            })
        };
        let point = world_from_mesh.transform_point3(DVec3::new(pick(0), pick(1), pick(2)));
        low = low.min(point);
        high = high.max(point);
    }
    Bounds::new(
        low.to_array().map(|x| (x as f32).next_down()),
        high.to_array().map(|x| (x as f32).next_up()),
    )
}
