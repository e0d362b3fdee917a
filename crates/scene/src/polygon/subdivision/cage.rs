use oaktwin_files::memory::{self as memory, Shortage};

use super::Scheme;
use crate::polygon::PolygonMesh;
use crate::polygon::faces::Faces;
use crate::polygon::value::Value;

/// The maximum number of faces of a refined mesh.
pub(super) const MAX_FACES: u64 = 1 << 25;
/// The memory for a refined face and its rendering, in bytes.
const FACE_BYTES: u64 = 256;
/// The maximum number of points, so that indices fit.
const MAX_POINTS: usize = 1 << 30;

/// The faces of a mesh that can be refined.
pub(super) struct Cage {
    /// The first corner of each face, and the end of the last face.
    pub(super) starts: Vec<u32>,
    /// The point of each corner.
    pub(super) corners: Vec<u32>,
    /// The index in the mesh of each face.
    pub(super) faces: Vec<u32>,
    /// The index in the mesh of each corner.
    pub(super) mesh_corners: Vec<u32>,
}

impl Cage {
    /// Also returns the number of faces that cannot be refined.
    pub(super) fn of(mesh: &PolygonMesh) -> (Self, u64) {
        let (faces, _) = Faces::of(mesh);
        let mut cage = Self {
            starts: vec![0],
            corners: Vec::with_capacity(mesh.face_vertex_indices.len()),
            faces: Vec::with_capacity(faces.len() as usize),
            mesh_corners: Vec::with_capacity(mesh.face_vertex_indices.len()),
        };
        let mut lost = 0;
        let mut end = 0;
        for face in 0..faces.len() {
            let range = faces.corners(face);
            let usable = |corner: u32| {
                let point = u32::try_from(mesh.face_vertex_indices[corner as usize]).ok()?;
                mesh.points.get(point as usize)?.is_finite().then_some(point)
            };
            if range.len() < 3 || !range.clone().all(|corner| usable(corner).is_some()) {
                lost += 1;
                continue;
            }
            end += range.end - range.start;
            cage.corners.extend(range.clone().filter_map(usable));
            cage.mesh_corners.extend(range);
            cage.starts.push(end);
            cage.faces.push(face);
        }
        (cage, lost)
    }

    /// For each corner, the next corner of its face.
    pub(super) fn next_corners(&self) -> impl Iterator<Item = usize> {
        self.starts.windows(2).flat_map(|face| {
            let (start, end) = (face[0] as usize, face[1] as usize);
            (start + 1..end).chain([start])
        })
    }

    pub(super) fn all_triangles(&self) -> bool {
        self.starts.windows(2).all(|face| face[1] - face[0] == 3)
    }

    /// The number of levels, at most `levels`, whose result stays within the limits.
    pub(super) fn affordable(&self, scheme: Scheme, levels: u32, points: usize) -> u32 {
        if points > MAX_POINTS {
            return 0;
        }
        let mut faces = self.first_faces(scheme);
        let mut affordable = 0;
        while affordable < levels && 0 < faces && faces <= MAX_FACES {
            affordable += 1;
            faces *= 4;
        }
        affordable
    }

    /// The number of levels, at most `levels`, for whose faces there is memory, and what is missing for one more.
    pub(super) fn fitting(&self, scheme: Scheme, levels: u32) -> (u32, Option<Shortage>) {
        let mut faces = self.first_faces(scheme);
        for level in 0..levels {
            if let Err(shortage) = memory::check(faces.saturating_mul(FACE_BYTES)) {
                return (level, Some(shortage));
            }
            faces = faces.saturating_mul(4);
        }
        (levels, None)
    }

    /// The number of faces after one level.
    fn first_faces(&self, scheme: Scheme) -> u64 {
        match scheme {
            Scheme::Loop => 4 * self.faces.len() as u64,
            _ => self.corners.len() as u64,
        }
    }

    /// The mesh's face from which each face originates after `levels` levels.
    pub(super) fn origins(&self, scheme: Scheme, levels: u32) -> Vec<u32> {
        let quarters = 4_usize.pow(levels - 1);
        let children = |face: &[u32]| match scheme {
            Scheme::Loop => 4 * quarters,
            _ => (face[1] - face[0]) as usize * quarters,
        };
        self.starts
            .windows(2)
            .zip(&self.faces)
            .flat_map(|(face, &number)| std::iter::repeat_n(number, children(face)))
            .collect()
    }
}
