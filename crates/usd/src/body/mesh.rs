use oaktwin_camera::math::DVec3;

use super::BodyPart;

/// The cosine of the crease angle, 35°: faces that meet at a larger angle form a crease.
const CREASE_COS: f64 = 0.819_152_044_288_991_8;

/// A mesh under construction in the body frame, mm.
#[derive(Clone, Debug, Default)]
pub(super) struct BodyMesh {
    pub(super) points: Vec<DVec3>,
    counts: Vec<usize>,
    indices: Vec<usize>,
}

impl BodyMesh {
    pub(super) fn triangle(&mut self, a: usize, b: usize, c: usize) {
        self.counts.push(3);
        self.indices.extend([a, b, c]);
    }

    pub(super) fn quad(&mut self, a: usize, b: usize, c: usize, d: usize) {
        self.counts.push(4);
        self.indices.extend([a, b, c, d]);
    }

    pub(super) fn append(&mut self, other: &Self) {
        let first = self.points.len();
        self.points.extend(&other.points);
        self.counts.extend(&other.counts);
        self.indices
            .extend(other.indices.iter().map(|index| first + index));
    }

    /// Converts to a part in metres whose normals are averaged, weighted by area, across all edges except creases.
    pub(super) fn into_part(self, name: &str, material: &'static str) -> BodyPart {
        let normals = self.normals();
        let integer = |value: &usize| i32::try_from(*value).unwrap_or(i32::MAX);
        BodyPart {
            name: name.to_owned(),
            points: self
                .points
                .iter()
                .map(|&point| rounded(point, 1e-3, 1e-6))
                .collect(),
            face_vertex_counts: self.counts.iter().map(integer).collect(),
            face_vertex_indices: self.indices.iter().map(integer).collect(),
            normals,
            material,
        }
    }

    /// Returns a unit normal for each corner: the area-weighted sum over the faces at its vertex that join its own smoothly.
    fn normals(&self) -> Vec<[f32; 3]> {
        let mut face_of_corner = Vec::with_capacity(self.indices.len());
        let mut areas = Vec::with_capacity(self.counts.len());
        let mut rest = self.indices.as_slice();
        for (face, &count) in self.counts.iter().enumerate() {
            let (corners, tail) = rest.split_at(count);
            rest = tail;
            areas.push(self.area_vector(corners));
            face_of_corner.extend(std::iter::repeat_n(face, count));
        }
        let units: Vec<DVec3> = areas
            .iter()
            .map(|area: &DVec3| area.normalize_or_zero())
            .collect();
        let vertices = Vertices::of(&self.indices, self.points.len());
        let mut normals = vec![[0.0; 3]; self.indices.len()];
        for vertex in 0..self.points.len() {
            let corners = vertices.corners(vertex);
            // A bit matrix of the faces that join smoothly. Vertices here have at most 64 faces; further ones are flat.
            let mut continues = [0_u64; 64];
            let count = corners.len().min(continues.len());
            let mut faces = [0; 64];
            for (i, &corner) in corners[..count].iter().enumerate() {
                faces[i] = face_of_corner[corner];
                continues[i] |= 1 << i;
                for j in 0..i {
                    let smooth = u64::from(units[faces[i]].dot(units[faces[j]]) > CREASE_COS);
                    continues[i] |= smooth << j;
                    continues[j] |= smooth << i;
                }
            }
            let mut known = (0, [0.0; 3]);
            for (i, &corner) in corners.iter().enumerate() {
                let own = face_of_corner[corner];
                let others = continues.get(i).copied().unwrap_or(0);
                // Most corners of a vertex join the same faces as the previous one.
                if others == 0 || others != known.0 {
                    let sum: DVec3 = (0..count)
                        .filter(|j| others >> j & 1 == 1)
                        .map(|j| areas[faces[j]])
                        .sum();
                    known = (others, rounded(sum.normalize_or(units[own]), 1.0, 1e-4));
                }
                normals[corner] = known.1;
            }
        }
        normals
    }

    /// Returns a vector along the normal whose length is twice the area.
    fn area_vector(&self, face: &[usize]) -> DVec3 {
        match *face {
            // The cross product of the diagonals.
            [a, b, c, d] => (self.points[c] - self.points[a]).cross(self.points[d] - self.points[b]),
            [a, b, c] => (self.points[b] - self.points[a]).cross(self.points[c] - self.points[a]),
            _ => DVec3::ZERO,
        }
    }
}

/// The face corners at each vertex, in one flat table.
struct Vertices {
    starts: Vec<usize>,
    corners: Vec<usize>,
}

impl Vertices {
    fn of(indices: &[usize], vertices: usize) -> Self {
        let mut starts = vec![0; vertices + 1];
        for &vertex in indices {
            starts[vertex + 1] += 1;
        }
        for vertex in 0..vertices {
            starts[vertex + 1] += starts[vertex];
        }
        let mut next = starts.clone();
        let mut corners = vec![0; indices.len()];
        for (corner, &vertex) in indices.iter().enumerate() {
            corners[next[vertex]] = corner;
            next[vertex] += 1;
        }
        Self { starts, corners }
    }

    fn corners(&self, vertex: usize) -> &[usize] {
        &self.corners[self.starts[vertex]..self.starts[vertex + 1]]
    }
}

/// Rounds `value × scale` to a multiple of `step`, which keeps the text short. The result is never `-0`.
fn rounded(value: DVec3, scale: f64, step: f64) -> [f32; 3] {
    // Adding 1.5 × 2^52 leaves no fraction bits, which rounds without a library call for all values in range.
    const WHOLE: DVec3 = DVec3::splat(6_755_399_441_055_744.0);
    ((value * (scale / step) + WHOLE - WHOLE) * step + DVec3::ZERO)
        .as_vec3()
        .to_array()
}
