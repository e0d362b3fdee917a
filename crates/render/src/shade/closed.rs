//! Which meshes enclose a volume.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::OnceLock;

use oaktwin_scene::{Mesh, Scene};

/// Which meshes of a scene are closed, tested when it first matters.
#[derive(Debug)]
pub(super) struct Closed {
    known: Vec<OnceLock<bool>>,
}

impl Closed {
    pub(super) fn new(scene: &Scene) -> Self {
        Self {
            known: scene.meshes.iter().map(|_| OnceLock::new()).collect(),
        }
    }

    /// Whether a mesh of the scene encloses a volume.
    pub(super) fn is(&self, scene: &Scene, mesh: u32) -> bool {
        let known = self.known.get(mesh as usize).zip(scene.meshes.get(mesh as usize));
        known.is_some_and(|(known, mesh)| *known.get_or_init(|| is_closed(mesh)))
    }
}

/// Whether each edge of a mesh, whose vertices at one point count as one, has a neighbour that runs the other way.
fn is_closed(mesh: &Mesh) -> bool {
    let mut numbers = BTreeMap::new();
    let mut welded = Vec::with_capacity(mesh.positions.len());
    for position in &mesh.positions {
        // Both zeros are one.
        let key = position.map(|value| (value + 0.0).to_bits());
        let next = numbers.len();
        welded.push(*numbers.entry(key).or_insert(next));
    }
    let mut edges = BTreeSet::new();
    for triangle in &mesh.triangles {
        let corners = triangle.map(|corner| welded.get(corner as usize).copied().unwrap_or(usize::MAX));
        let [a, b, c] = corners;
        if a == b || b == c || c == a {
            continue;
        }
        for edge in [(a, b), (b, c), (c, a)] {
            if !edges.insert(edge) {
                return false;
            }
        }
    }
    !edges.is_empty() && edges.iter().all(|(a, b)| edges.contains(&(*b, *a)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixture::{cube, rectangle};

    #[test]
    fn boxes_are_closed_and_sheets_are_not() {
        assert!(is_closed(&cube()));
        assert!(!is_closed(&rectangle([0.0, 1.0], [0.0, 1.0], 1.0)));
        let mut open = cube();
        open.triangles.pop();
        assert!(!is_closed(&open));
        // Faces with vertices of their own are welded.
        let mut apart = Mesh::default();
        for triangle in &cube().triangles {
            let first = u32::try_from(apart.positions.len()).unwrap();
            apart.triangles.push([first, first + 1, first + 2]);
            apart
                .positions
                .extend(triangle.map(|corner| cube().positions[corner as usize]));
        }
        assert!(is_closed(&apart));
        assert!(!is_closed(&Mesh::default()));
    }
}
