use oaktwin_camera::math::{DAffine3, DVec3};
use oaktwin_scene::Scene;

use super::bvh::{self, Bounds, Item, Node};
use super::mesh_tree::MeshTree;

/// The maximum number of instances of a leaf: entering an instance costs more than testing its box.
const LEAF: usize = 1;

/// The bounding volume hierarchy over a scene's instances.
#[derive(Debug)]
pub(crate) struct Instances {
    /// The nodes, the root first.
    pub(crate) nodes: Vec<Node>,
    /// The instances that leaves refer to.
    pub(crate) order: Vec<u32>,
    /// The inverse transform of each instance of the scene.
    pub(crate) mesh_from_world: Vec<DAffine3>,
    /// The bounding box in the world.
    pub(crate) bounds: Bounds,
}

impl Instances {
    /// Builds the hierarchy without instances that have no triangles or a singular transform.
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

/// Returns the bounding box of a transformed box.
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
