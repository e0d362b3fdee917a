/// The edges of a mesh, ordered by their end points.
pub(super) struct Edges {
    /// The two end points, the lower one first.
    pub(super) ends: Vec<[u32; 2]>,
    /// For each corner, the edge from it to the next corner of its face.
    pub(super) of_corner: Vec<u32>,
    /// The number of faces at each edge: 2 inside a surface, 1 at its border.
    pub(super) faces: Vec<u32>,
}

/// An edge as a number, ordered by the end points.
pub(super) fn key(a: u32, b: u32) -> u64 {
    (u64::from(a.min(b)) << 32) | u64::from(a.max(b))
}

impl Edges {
    /// `starts` contains the first corner of each face, and the end of the last face.
    pub(super) fn of(starts: &[u32], corners: &[u32]) -> Self {
        let mut halves = Vec::with_capacity(corners.len());
        for face in starts.windows(2) {
            for corner in face[0]..face[1] {
                let next = if corner + 1 < face[1] { corner + 1 } else { face[0] };
                halves.push((key(corners[corner as usize], corners[next as usize]), corner));
            }
        }
        halves.sort_unstable();
        let mut edges = Self {
            ends: Vec::with_capacity(halves.len() / 2),
            of_corner: vec![0; corners.len()],
            faces: Vec::with_capacity(halves.len() / 2),
        };
        for (index, same) in (0..).zip(halves.chunk_by(|a, b| a.0 == b.0)) {
            let key = same[0].0;
            #[allow(clippy::cast_possible_truncation, reason = "the two halves of the key")]
            edges.ends.push([(key >> 32) as u32, key as u32]);
            // At most the number of corners.
            edges.faces.push(u32::try_from(same.len()).unwrap_or(u32::MAX));
            for &(_, corner) in same {
                edges.of_corner[corner as usize] = index;
            }
        }
        edges
    }

    pub(super) fn len(&self) -> usize {
        self.ends.len()
    }

    /// The index of the edge with this [`key`].
    pub(super) fn find(&self, edge: u64) -> Option<usize> {
        self.ends.binary_search_by_key(&edge, |&[a, b]| key(a, b)).ok()
    }
}
