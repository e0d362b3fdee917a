use oaktwin_scene::Mesh;
use rayon::prelude::*;

use super::bvh::{self, Bounds, Item, Node};

/// The bounding volume hierarchy of a mesh.
#[derive(Debug)]
pub(crate) struct MeshTree {
    /// The nodes, the root first.
    pub(crate) nodes: Vec<Node>,
    /// Triangles in the order of the leaves: three indices of positions, then the triangle's index in the mesh.
    pub(crate) triangles: Vec<[u32; 4]>,
    /// The bounding box in the mesh frame.
    pub(crate) bounds: Bounds,
}

impl MeshTree {
    /// Builds the hierarchy without triangles whose positions are missing or not finite.
    pub(crate) fn new(mesh: &Mesh) -> Self {
        let count = u32::try_from(mesh.triangles.len()).unwrap_or(u32::MAX - 1);
        let mut items: Vec<Item> = (0..count)
            .into_par_iter()
            .with_min_len(4096)
            .filter_map(|index| {
                let bounds = Bounds::of_points(&mesh.corners(index as usize)?);
                bounds.is_finite().then(|| Item::new(bounds, index))
            })
            .collect();
        let nodes = bvh::build(&mut items, bvh::LEAF);
        let triangles = items
            .par_iter()
            .with_min_len(4096)
            .map(|item| {
                let [a, b, c] = mesh.triangles[item.index() as usize];
                [a, b, c, item.index()]
            })
            .collect();
        let bounds = Bounds::of_nodes(&nodes[0]);
        Self {
            nodes,
            triangles,
            bounds,
        }
    }
}
