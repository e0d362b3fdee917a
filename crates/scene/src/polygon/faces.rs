use std::ops::Range;

use super::PolygonMesh;

/// Where each face's corners are among all corners.
#[derive(Debug)]
pub(super) enum Faces {
    /// All faces have as many corners.
    Regular { corners: u32, count: u32 },
    /// Face `i` has the corners `starts[i]..starts[i + 1]`.
    Varied { starts: Vec<u32> },
}

/// What was wrong with the counts.
#[derive(Debug, Default, PartialEq, Eq)]
pub(super) struct CountFaults {
    /// Faces for which there were no corners left.
    pub(super) faces_without_corners: usize,
    /// Corners that belong to no face.
    pub(super) corners_without_face: usize,
    /// Counts below zero, taken as zero.
    pub(super) negative: usize,
}

impl CountFaults {
    pub(super) fn any(&self) -> bool {
        *self != Self::default()
    }
}

impl Faces {
    /// The faces that the counts and the number of corners agree on: the first ones.
    pub(super) fn of(mesh: &PolygonMesh) -> (Self, CountFaults) {
        let counts = &mesh.face_vertex_counts;
        // An index of a corner has 32 bits: what is beyond has no corners.
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
            // Built from fewer than 2³² corners; empty faces beyond that are not worth counting.
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
