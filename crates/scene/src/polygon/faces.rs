use std::ops::Range;

use super::PolygonMesh;

/// The range of each face's corners.
#[derive(Debug)]
pub(super) enum Faces {
    /// All faces have the same number of corners.
    Regular { corners: u32, count: u32 },
    /// Face `i` has the corners `starts[i]..starts[i + 1]`.
    Varied { starts: Vec<u32> },
}

/// Errors in the face vertex counts.
#[derive(Debug, Default, PartialEq, Eq)]
pub(super) struct CountFaults {
    /// The number of faces with too few corners left.
    pub(super) faces_without_corners: usize,
    /// The number of corners without a face.
    pub(super) corners_without_face: usize,
    /// The number of negative counts, which are taken as zero.
    pub(super) negative: usize,
}

impl CountFaults {
    pub(super) fn any(&self) -> bool {
        *self != Self::default()
    }
}

impl Faces {
    /// The leading faces for which counts and corners are consistent.
    pub(super) fn of(mesh: &PolygonMesh) -> (Self, CountFaults) {
        let counts = &mesh.face_vertex_counts;
        // Corner indices have 32 bits; corners beyond are ignored.
        let corners = u32::try_from(mesh.face_vertex_indices.len()).unwrap_or(u32::MAX);
        if let Some(regular) = Self::regular(counts, corners) {
            return (regular, CountFaults::default());
        }
        let mut faults = CountFaults::default();
        let mut starts = Vec::with_capacity(counts.len() + 1);
        let mut end = 0_u32;
        starts.push(end);
        for (face, &count) in counts.iter().enumerate() {
            let count = u32::try_from(count).unwrap_or_else(|_| {
                faults.negative += 1;
                0
            });
            match end.checked_add(count) {
                Some(next) if next <= corners => end = next,
                _ => {
                    faults.faces_without_corners = counts.len() - face;
                    break;
                }
            }
            starts.push(end);
        }
        faults.corners_without_face = mesh.face_vertex_indices.len() - end as usize;
        (Self::Varied { starts }, faults)
    }

    fn regular(counts: &[i32], corners: u32) -> Option<Self> {
        let &first = counts.first()?;
        let count = u32::try_from(counts.len()).ok()?;
        let each = u32::try_from(first).ok()?;
        if counts.iter().any(|&count| count != first) || each.checked_mul(count)? != corners {
            return None;
        }
        Some(Self::Regular { corners: each, count })
    }

    pub(super) fn len(&self) -> u32 {
        match self {
            Self::Regular { count, .. } => *count,
            // Built from fewer than 2³² corners; empty faces beyond that need not be counted.
            Self::Varied { starts } => u32::try_from(starts.len() - 1).unwrap_or(u32::MAX),
        }
    }

    /// The corners of a face.
    pub(super) fn corners(&self, face: u32) -> Range<u32> {
        match self {
            Self::Regular { corners, .. } => face * corners..(face + 1) * corners,
            Self::Varied { starts } => starts[face as usize]..starts[face as usize + 1],
        }
    }

    pub(super) fn all_triangles(&self) -> bool {
        matches!(self, Self::Regular { corners: 3, .. })
    }
}
