use super::Scheme;
use crate::polygon::PolygonMesh;
use crate::polygon::attribute::Value;
use crate::polygon::faces::Faces;

/// More faces than this are not made.
pub(super) const MOST_FACES: u64 = 1 << 25;
/// Beyond this the numbers of new points would not fit.
const MOST_POINTS: usize = 1 << 30;

/// The faces of a mesh that can be refined.
pub(super) struct Cage {
    /// Where each face's corners start, and where the last one's end.
    pub(super) starts: Vec<u32>,
    /// The point of each corner.
    pub(super) corners: Vec<u32>,
    /// The number of each face in the mesh.
    pub(super) faces: Vec<u32>,
    /// The number of each corner in the mesh.
    pub(super) mesh_corners: Vec<u32>,
}

impl Cage {
    /// Also says how many faces cannot be refined.
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

    /// For each corner the next one of its face.
    pub(super) fn next_corners(&self) -> impl Iterator<Item = usize> {
        self.starts.windows(2).flat_map(|face| {
            let (start, end) = (face[0] as usize, face[1] as usize);
            (start + 1..end).chain([start])
        })
    }

    pub(super) fn all_triangles(&self) -> bool {
        self.starts.windows(2).all(|face| face[1] - face[0] == 3)
    }

    /// How many levels, at most `levels`, give no more faces than are made.
    pub(super) fn affordable(&self, scheme: Scheme, levels: u32, points: usize) -> u32 {
        if points > MOST_POINTS {
            return 0;
        }
        let mut faces = match scheme {
            Scheme::Loop => 4 * self.faces.len() as u64,
            _ => self.corners.len() as u64,
        };
        let mut affordable = 0;
        while affordable < levels && 0 < faces && faces <= MOST_FACES {
            affordable += 1;
            faces *= 4;
        }
        affordable
    }

    /// The mesh's face that each face came from, after some levels.
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
