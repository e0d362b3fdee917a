//! The work of a tile, and what it consists of.

use super::cluster::{Cluster, ClusteredMesh};
use super::frame::FrameConstants;
use super::id::Id;
use super::visible::Visible;
use crate::Hit;

/// The work of a tile.
#[derive(Clone, Copy, Debug)]
pub(super) struct Job<'a> {
    pub(super) frame: &'a FrameConstants<'a>,
    pub(super) meshes: &'a [ClusteredMesh],
    pub(super) visible: &'a [Visible],
    /// The entries to draw, in order; their lower halves are indices in `visible`.
    pub(super) entries: &'a [u64],
}

/// An entry with its mesh and cluster.
pub(super) struct Entry<'a> {
    pub(super) item: &'a Visible,
    pub(super) mesh: &'a ClusteredMesh,
    pub(super) cluster: &'a Cluster,
}

impl Job<'_> {
    #[inline(always)]
    pub(super) fn entry(&self, at: usize) -> Option<Entry<'_>> {
        #[expect(clippy::cast_possible_truncation, reason = "takes the lower half")]
        let item = self.visible.get(*self.entries.get(at)? as u32 as usize)?;
        let instance = self.frame.scene.instances.get(item.instance as usize)?;
        let mesh = self.meshes.get(instance.mesh as usize)?;
        let cluster = mesh.clusters.get(item.cluster as usize)?;
        Some(Entry { item, mesh, cluster })
    }

    /// Returns the triangle in the scene.
    pub(super) fn hit(&self, id: Id) -> Hit {
        if id == Id::NONE {
            return Hit::MISS;
        }
        let (at, triangle) = id.parts();
        self.entry(at).map_or(Hit::MISS, |entry| entry.hit(triangle))
    }
}

impl Entry<'_> {
    pub(super) fn hit(&self, triangle: usize) -> Hit {
        let at = self.cluster.first_triangle as usize + triangle;
        Hit {
            instance: self.item.instance,
            triangle: self.mesh.triangles.get(at).copied().unwrap_or(u32::MAX),
        }
    }
}
