use oaktwin_scene::Mesh;
use rayon::prelude::*;

use super::bvh::{self, Bounds, Item, Node};

/// A mesh's triangles in an order in which neighbours stand together, and the boxes over them.
#[derive(Debug)]
pub(crate) struct MeshTree {
    /// The first is the root.
    pub(crate) nodes: Vec<Node>,
    /// Three indices of positions, then the triangle's number in the mesh.
    pub(crate) triangles: Vec<[u32; 4]>,
    /// Of all triangles, in the mesh's frame.
    pub(crate) bounds: Bounds,
}

impl MeshTree {
    /// Triangles that refer to positions that are not there, or are no numbers, are left out.
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
