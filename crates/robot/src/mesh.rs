//! Meshes as OBJ files, which every simulator reads; Drake reads no STL.

use std::fmt::Write;

use oaktwin_usd::body::BodyPart;

/// Triangles with normals, in the body frame in metres.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct HousingMesh {
    /// The corners.
    pub points: Vec<[f32; 3]>,
    /// The unit normals of the triangles' corners.
    pub normals: Vec<[f32; 3]>,
    /// Indices into `points` and `normals` of the corners, counter-clockwise seen from outside.
    pub triangles: Vec<[[u32; 2]; 3]>,
}

impl HousingMesh {
    /// Adds a part of a body; faces with four corners become two triangles.
    #[expect(clippy::cast_sign_loss, reason = "indices and counts are positive")]
    pub(crate) fn add(&mut self, part: &BodyPart) {
        let offset = index(self.points.len());
        self.points.extend(&part.points);
        let mut first = 0;
        for count in &part.face_vertex_counts {
            let count = *count as usize;
            let corner = |i: usize| {
                part.face_vertex_indices
                    .get(first + i)
                    .map(|at| offset + *at as u32)
            };
            let normal = index(self.normals.len());
            self.normals
                .extend((0..count).filter_map(|i| part.normals.get(first + i)));
            for i in 2..count {
                if let (Some(a), Some(b), Some(c)) = (corner(0), corner(i - 1), corner(i)) {
                    let [nb, nc] = [i - 1, i].map(|i| normal + index(i));
                    self.triangles.push([[a, normal], [b, nb], [c, nc]]);
                }
            }
            first += count;
        }
    }

    /// Returns the mesh as a Wavefront OBJ file.
    pub(crate) fn to_obj(&self) -> Vec<u8> {
        let mut out = String::new();
        for [x, y, z] in &self.points {
            let _ = writeln!(out, "v {x} {y} {z}");
        }
        for [x, y, z] in &self.normals {
            let _ = writeln!(out, "vn {x} {y} {z}");
        }
        for triangle in &self.triangles {
            out.push('f');
            for [point, normal] in triangle {
                let _ = write!(out, " {}//{}", point + 1, normal + 1);
            }
            out.push('\n');
        }
        out.into_bytes()
    }
}

fn index(count: usize) -> u32 {
    u32::try_from(count).unwrap_or(u32::MAX)
}
