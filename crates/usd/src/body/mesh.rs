use oaktwin_camera::math::DVec3;

use super::BodyPart;

/// Faces that meet at more than this are a crease: cos 35°.
const CREASE_COS: f64 = 0.819_152_044_288_991_8;

/// A mesh being built, mm, in the body frame.
#[derive(Clone, Debug, Default)]
pub(super) struct Mesh {
    pub(super) points: Vec<DVec3>,
    counts: Vec<usize>,
    indices: Vec<usize>,
}

impl Mesh {
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

    /// The part in metres, with normals averaged by area across edges that are no creases.
    pub(super) fn into_part(self, name: &str, material: &'static str) -> BodyPart {
        let faces = self.faces();
        let areas: Vec<DVec3> = faces.iter().map(|face| self.area_vector(face)).collect();
        let units: Vec<DVec3> = areas.iter().map(|area| area.normalize_or_zero()).collect();
        let around = Incidence::of(&faces, self.points.len());
        let mut normals = Vec::with_capacity(self.indices.len());
        // Most vertices have one normal for all of their faces: the last one found there, with what it is the sum of.
        let mut known = vec![(DVec3::NAN, [0.0; 3]); self.points.len()];
        for (face, unit) in faces.iter().zip(&units) {
            for &vertex in *face {
                let mut sum = DVec3::ZERO;
                for &other in around.faces(vertex) {
                    let smooth = f64::from(u8::from(units[other].dot(*unit) > CREASE_COS));
                    sum += areas[other] * smooth;
                }
                let (known_sum, normal) = &mut known[vertex];
                if *known_sum != sum {
                    *known_sum = sum;
                    *normal = rounded(sum.normalize_or(*unit), 1.0, 1e-4);
                }
                normals.push(*normal);
            }
        }
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

    fn faces(&self) -> Vec<&[usize]> {
        let mut rest = self.indices.as_slice();
        self.counts
            .iter()
            .map(|&count| {
                let (face, tail) = rest.split_at(count);
                rest = tail;
                face
            })
            .collect()
    }

    /// Twice the area, along the normal.
    fn area_vector(&self, face: &[usize]) -> DVec3 {
        let origin = self.points[face[0]];
        face[1..]
            .windows(2)
            .map(|edge| (self.points[edge[0]] - origin).cross(self.points[edge[1]] - origin))
            .sum()
    }
}

/// The faces around each vertex, as one flat table.
struct Incidence {
    starts: Vec<usize>,
    faces: Vec<usize>,
}

impl Incidence {
    fn of(faces: &[&[usize]], vertices: usize) -> Self {
        let mut starts = vec![0; vertices + 1];
        for &vertex in faces.iter().copied().flatten() {
            starts[vertex + 1] += 1;
        }
        for vertex in 0..vertices {
            starts[vertex + 1] += starts[vertex];
        }
        let mut next = starts.clone();
        let mut table = vec![0; starts[vertices]];
        for (index, face) in faces.iter().enumerate() {
            for &vertex in *face {
                table[next[vertex]] = index;
                next[vertex] += 1;
            }
        }
        Self { starts, faces: table }
    }

    fn faces(&self, vertex: usize) -> &[usize] {
        &self.faces[self.starts[vertex]..self.starts[vertex + 1]]
    }
}

/// `value × scale` to a multiple of `step`: short in text, and never `-0`.
fn rounded(value: DVec3, scale: f64, step: f64) -> [f32; 3] {
    // Adding 1.5 × 2^52 leaves no fraction bits: rounding without a library call, for all that fits a body.
    const WHOLE: DVec3 = DVec3::splat(6_755_399_441_055_744.0);
    ((value * (scale / step) + WHOLE - WHOLE) * step + DVec3::ZERO)
        .as_vec3()
        .to_array()
}
