//! Triangles that share their vertices.

use std::collections::HashMap;

use meshopt_rs::simplify::{simplify, simplify_sloppy};
use meshopt_rs::vertex::Position;
use oaktwin::camera::math::DVec3;

use crate::protocol::MeshHeader;

/// The relative error up to which details are removed before whole shapes are.
const TARGET_ERROR: f32 = 0.02;

/// A vertex: triangles share it if their position, colour and object are equal.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
struct Vertex {
    /// The bits of the coordinates, metres.
    position: [u32; 3],
    color: [u8; 3],
    object: u32,
}

impl Position for Vertex {
    fn pos(&self) -> [f32; 3] {
        self.position.map(f32::from_bits)
    }
}

/// A mesh with shared vertices.
#[derive(Debug, Default)]
pub(super) struct Welded {
    vertices: Vec<Vertex>,
    indices: Vec<u32>,
    known: HashMap<Vertex, u32>,
}

impl Welded {
    pub(super) fn add(&mut self, position: DVec3, color: [u8; 3], object: u32) {
        let bits = |x: f64| {
            #[expect(clippy::cast_possible_truncation, reason = "the page draws single precision")]
            let narrow = x as f32;
            // Zeros of both signs are one place.
            (narrow + 0.0).to_bits()
        };
        let vertex = Vertex {
            position: position.to_array().map(bits),
            color,
            object,
        };
        let next = u32::try_from(self.vertices.len()).unwrap_or(u32::MAX);
        let index = *self.known.entry(vertex).or_insert_with(|| {
            self.vertices.push(vertex);
            next
        });
        self.indices.push(index);
    }

    pub(super) fn add_triangle(&mut self, corners: [DVec3; 3], color: [u8; 3], object: u32) {
        corners
            .into_iter()
            .for_each(|corner| self.add(corner, color, object));
    }

    /// The number of triangles.
    pub(super) fn len(&self) -> usize {
        self.indices.len() / 3
    }

    /// The triangles with their colours.
    pub(super) fn facets(&self) -> impl Iterator<Item = ([[f32; 3]; 3], [u8; 3])> {
        self.indices.chunks_exact(3).filter_map(|corners| {
            let at = |index: u32| self.vertices.get(index as usize);
            let [a, b, c] = [at(corners[0])?, at(corners[1])?, at(corners[2])?];
            Some(([a.pos(), b.pos(), c.pos()], a.color))
        })
    }

    /// Removes triangles until about `triangles` remain: details first, then whole shapes.
    pub(super) fn simplify(&mut self, triangles: usize) {
        let target = triangles * 3;
        // Only needed to add vertices.
        self.known = HashMap::new();
        if self.indices.len() <= target {
            return;
        }
        let mut simple = vec![0; self.indices.len()];
        let count = simplify(&mut simple, &self.indices, &self.vertices, target, TARGET_ERROR);
        simple.truncate(count);
        if count > target {
            let mut sloppy = vec![0; simple.len()];
            let count = simplify_sloppy(&mut sloppy, &simple, &self.vertices, target);
            sloppy.truncate(count);
            // Nothing is left of shapes that are small: then some of the triangles stay.
            simple = match count {
                0 => some(&simple, triangles),
                _ => sloppy,
            };
        }
        self.indices = simple;
        self.remove_unused();
    }

    fn remove_unused(&mut self) {
        let mut places = vec![u32::MAX; self.vertices.len()];
        let mut vertices = Vec::new();
        for index in &mut self.indices {
            let place = &mut places[*index as usize];
            if *place == u32::MAX {
                *place = u32::try_from(vertices.len()).unwrap_or(u32::MAX);
                vertices.push(self.vertices[*index as usize]);
            }
            *index = *place;
        }
        self.vertices = vertices;
    }

    pub(super) fn encode(&self, of_triangles: usize) -> Vec<u8> {
        let header = MeshHeader {
            vertices: self.vertices.len(),
            triangles: self.indices.len() / 3,
            of_triangles,
        };
        let mut out = crate::wire::begin(&header);
        out.resize(out.len().next_multiple_of(4), 0);
        for vertex in &self.vertices {
            vertex
                .position
                .iter()
                .for_each(|bits| out.extend(bits.to_le_bytes()));
        }
        for vertex in &self.vertices {
            out.extend(vertex.color);
            out.push(255);
        }
        for index in &self.indices {
            out.extend(index.to_le_bytes());
        }
        for triangle in self.indices.chunks_exact(3) {
            let object = self.vertices[triangle[0] as usize].object;
            out.extend(object.to_le_bytes());
        }
        out
    }
}

/// Returns the indices of some triangles, evenly distributed.
fn some(indices: &[u32], triangles: usize) -> Vec<u32> {
    let all = indices.len() / 3;
    let kept = (0..triangles.min(all)).map(|index| index * all / triangles.min(all));
    kept.flat_map(|at| &indices[3 * at..3 * at + 3])
        .copied()
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A flat square of `cells` × `cells` squares.
    fn grid(cells: u16) -> Welded {
        let mut welded = Welded::default();
        for row in 0..cells {
            for column in 0..cells {
                let corner = |dx, dy| DVec3::new(f64::from(column + dx), f64::from(row + dy), 0.0);
                for (dx, dy) in [(0, 0), (1, 0), (1, 1), (0, 0), (1, 1), (0, 1)] {
                    welded.add(corner(dx, dy), [9; 3], 0);
                }
            }
        }
        welded
    }

    #[test]
    fn vertices_are_shared() {
        let welded = grid(10);
        assert_eq!((welded.vertices.len(), welded.indices.len()), (121, 600));
    }

    #[test]
    fn flat_surfaces_lose_their_details() {
        let mut welded = grid(50);
        welded.simplify(1000);
        let triangles = welded.indices.len() / 3;
        assert!((2..=1000).contains(&triangles), "{triangles}");
        let area: f64 = (welded.indices.chunks_exact(3))
            .map(|corners| {
                let at = |index: u32| DVec3::from(welded.vertices[index as usize].pos().map(f64::from));
                (at(corners[1]) - at(corners[0]))
                    .cross(at(corners[2]) - at(corners[0]))
                    .length()
                    / 2.0
            })
            .sum();
        // Collapses in a plane may leave slivers on top of each other.
        assert!((area - 2500.0).abs() < 50.0, "{area}");
        assert!(welded.vertices.len() <= 3 * triangles);
    }

    #[test]
    fn encoded_meshes_have_the_announced_length() {
        let bytes = grid(3).encode(18);
        let length = u32::from_le_bytes(bytes[..4].try_into().unwrap()) as usize;
        let header: serde_json::Value = serde_json::from_slice(&bytes[4..4 + length]).unwrap();
        assert_eq!(header["vertices"], 16);
        let start = (4 + length).next_multiple_of(4);
        assert_eq!(bytes.len() - start, 16 * 16 + 18 * 16);
    }
}
