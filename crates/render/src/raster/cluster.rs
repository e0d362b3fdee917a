//! Clusters of triangles, which are culled, transformed and drawn together.

use oaktwin_scene::Mesh;
use rayon::prelude::*;

use super::bounds::{Bounds, valid_corners};
use super::order;

/// The maximum number of triangles in a cluster.
pub(super) const MAX_TRIANGLES: usize = 256;
/// The maximum number of vertices in a cluster, for which the corners of triangles fit into bytes.
pub(super) const MAX_VERTICES: usize = 256;
/// The number of triangles or vertices that are read at once, past the end of a cluster.
pub(super) const LANES: usize = 8;

/// A copy of a mesh's geometry in spatial order, at 16 bytes per triangle.
#[derive(Debug, Default)]
pub(super) struct ClusteredMesh {
    pub(super) clusters: Vec<Cluster>,
    /// Vertices in the mesh frame, padded by [`LANES`].
    pub(super) x: Vec<f32>,
    pub(super) y: Vec<f32>,
    pub(super) z: Vec<f32>,
    /// The corners of triangles as vertices of the cluster, one byte each from the lowest; padded by [`LANES`].
    pub(super) corners: Vec<u32>,
    /// The index of each triangle in the mesh.
    pub(super) triangles: Vec<u32>,
}

/// Up to [`MAX_TRIANGLES`] neighbouring triangles.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cluster {
    pub(super) bounds: Bounds,
    pub(super) first_vertex: u32,
    pub(super) first_triangle: u32,
    pub(super) vertices: u16,
    pub(super) triangles: u16,
}

impl ClusteredMesh {
    pub(super) fn new(mesh: &Mesh) -> Self {
        let mut order = order::along_curve(mesh);
        let leaves = order::leaves(mesh, &mut order, MAX_TRIANGLES);
        let parts: Vec<Self> = leaves
            .par_chunks(256)
            .map(|leaves| {
                let mut part = Self::default();
                let mut slots = Slots::default();
                for leaf in leaves {
                    part.push(mesh, order.get(leaf.clone()).unwrap_or_default(), &mut slots);
                }
                part
            })
            .collect();
        let mut all = Self::default();
        let vertices: usize = parts.iter().map(|p| p.x.len()).sum();
        let triangles: usize = parts.iter().map(|p| p.corners.len()).sum();
        all.clusters
            .reserve_exact(parts.iter().map(|p| p.clusters.len()).sum());
        for axis in [&mut all.x, &mut all.y, &mut all.z] {
            axis.reserve_exact(vertices + LANES);
        }
        all.corners.reserve_exact(triangles + LANES);
        all.triangles.reserve_exact(triangles);
        for part in parts {
            all.append(&part);
        }
        for axis in [&mut all.x, &mut all.y, &mut all.z] {
            axis.extend([0.0; LANES]);
        }
        all.corners.extend([0; LANES]);
        all
    }

    #[expect(clippy::cast_possible_truncation, reason = "a mesh's indices are u32")]
    fn append(&mut self, part: &Self) {
        let (first_vertex, first_triangle) = (self.x.len() as u32, self.corners.len() as u32);
        self.clusters.extend(part.clusters.iter().map(|cluster| Cluster {
            first_vertex: cluster.first_vertex + first_vertex,
            first_triangle: cluster.first_triangle + first_triangle,
            ..*cluster
        }));
        self.x.extend_from_slice(&part.x);
        self.y.extend_from_slice(&part.y);
        self.z.extend_from_slice(&part.z);
        self.corners.extend_from_slice(&part.corners);
        self.triangles.extend_from_slice(&part.triangles);
    }

    /// Appends a cluster of these triangles, or several if they have too many vertices.
    #[expect(clippy::cast_possible_truncation, reason = "counts up to 256")]
    fn push(&mut self, mesh: &Mesh, ordered: &[u64], slots: &mut Slots) {
        slots.clear();
        let (first_vertex, first_triangle) = (self.x.len(), self.corners.len());
        let mut bounds = Bounds::EMPTY;
        for triangle in ordered.iter().map(|key| order::triangle(*key)) {
            let (Some(corners), Some(indices)) = (
                valid_corners(mesh, triangle as usize),
                mesh.triangles.get(triangle as usize),
            ) else {
                continue;
            };
            let mut packed = 0;
            for (shift, (index, [x, y, z])) in (0..).step_by(8).zip(indices.iter().zip(corners)) {
                let next = self.x.len() - first_vertex;
                let local = slots.local(*index, next as u16);
                if usize::from(local) == MAX_VERTICES {
                    self.x.truncate(first_vertex);
                    self.y.truncate(first_vertex);
                    self.z.truncate(first_vertex);
                    self.corners.truncate(first_triangle);
                    self.triangles.truncate(first_triangle);
                    let (left, right) = ordered.split_at(ordered.len() / 2);
                    self.push(mesh, left, slots);
                    self.push(mesh, right, slots);
                    return;
                }
                if usize::from(local) == next {
                    self.x.push(x);
                    self.y.push(y);
                    self.z.push(z);
                }
                bounds = bounds.include([x, y, z]);
                packed |= u32::from(local) << shift;
            }
            self.corners.push(packed);
            self.triangles.push(triangle);
        }
        if self.corners.len() > first_triangle {
            self.clusters.push(Cluster {
                bounds,
                first_vertex: first_vertex as u32,
                first_triangle: first_triangle as u32,
                vertices: (self.x.len() - first_vertex) as u16,
                triangles: (self.corners.len() - first_triangle) as u16,
            });
        }
    }

    /// Returns the positions of a triangle's corners; `triangle` is an index in this order.
    pub(super) fn positions(&self, cluster: &Cluster, triangle: usize) -> Option<[[f32; 3]; 3]> {
        let [a, b, c, _] = self.corners.get(triangle)?.to_le_bytes();
        let vertex = |local: u8| {
            let at = cluster.first_vertex as usize + usize::from(local);
            Some([*self.x.get(at)?, *self.y.get(at)?, *self.z.get(at)?])
        };
        Some([vertex(a)?, vertex(b)?, vertex(c)?])
    }
}

/// The vertices of a cluster by their index in the mesh: a hash table with open addressing.
#[derive(Debug)]
struct Slots {
    table: Box<[(u32, u16); Self::SIZE]>,
}

impl Default for Slots {
    fn default() -> Self {
        Self {
            table: Box::new([Self::FREE; Self::SIZE]),
        }
    }
}

impl Slots {
    const SIZE: usize = 1024;
    const FREE: (u32, u16) = (0, u16::MAX);

    fn clear(&mut self) {
        self.table.fill(Self::FREE);
    }

    /// Returns the index of a vertex in the cluster; `next` if it is new.
    fn local(&mut self, vertex: u32, next: u16) -> u16 {
        let mut at = vertex.wrapping_mul(0x9E37_79B1) as usize >> 22;
        loop {
            let slot = &mut self.table[at % Self::SIZE];
            if slot.1 == u16::MAX {
                *slot = (vertex, next);
                return next;
            }
            if slot.0 == vertex {
                return slot.1;
            }
            at += 1;
        }
    }
}
