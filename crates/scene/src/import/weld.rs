use std::collections::HashMap;
use std::hash::Hash;

/// A coordinate of a point, in single or double precision.
pub(super) trait Coordinate: Copy {
    type Bits: Eq + Hash;
    /// The bits of the number; 0 and −0 have the same.
    fn bits(self) -> Self::Bits;
}

impl Coordinate for f32 {
    type Bits = u32;
    fn bits(self) -> u32 {
        (self + 0.0).to_bits()
    }
}

impl Coordinate for f64 {
    type Bits = u64;
    fn bits(self) -> u64 {
        (self + 0.0).to_bits()
    }
}

/// Merges the points of separate triangles that have equal coordinates.
pub(super) struct Welder<C: Coordinate> {
    pub(super) points: Vec<[C; 3]>,
    /// Never iterated, so its order has no effect.
    known: HashMap<[C::Bits; 3], i32>,
}

impl<C: Coordinate> Welder<C> {
    pub(super) fn with_capacity(points: usize) -> Self {
        Self {
            points: Vec::with_capacity(points),
            known: HashMap::with_capacity(points),
        }
    }

    /// The index of the point with exactly these coordinates.
    pub(super) fn index(&mut self, point: [C; 3]) -> i32 {
        let points = &mut self.points;
        *self.known.entry(point.map(C::bits)).or_insert_with(|| {
            points.push(point);
            i32::try_from(points.len() - 1).unwrap_or(-1)
        })
    }
}
