use std::collections::HashMap;

/// Merges the points of separate triangles that have equal coordinates.
#[derive(Default)]
pub(super) struct Welder {
    pub(super) points: Vec<[f32; 3]>,
    /// Never iterated, so its order has no effect.
    known: HashMap<[u32; 3], i32>,
}

impl Welder {
    pub(super) fn with_capacity(points: usize) -> Self {
        Self {
            points: Vec::with_capacity(points),
            known: HashMap::with_capacity(points),
        }
    }

    /// The index of the point with exactly these coordinates; 0 and −0 are equal.
    pub(super) fn index(&mut self, point: [f32; 3]) -> i32 {
        let bits = point.map(|x| (x + 0.0).to_bits());
        let points = &mut self.points;
        *self.known.entry(bits).or_insert_with(|| {
            points.push(point);
            i32::try_from(points.len() - 1).unwrap_or(-1)
        })
    }
}
