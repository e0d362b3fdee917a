//! Face-varying values, stored once for each vertex that has the same at all its corners.

use super::attribute::Value;

/// Finds a vertex's earlier corners of the same value.
pub(super) struct Welder<T> {
    /// First one for each vertex, in order; then those of vertices that have several.
    pub(super) values: Vec<T>,
    /// For each value the next of the same vertex; `NONE` at the end.
    next: Vec<u32>,
    seen: Vec<bool>,
}

const NONE: u32 = u32::MAX;
/// A vertex with more values than this gets them unwelded, which keeps the time linear.
const LONGEST_CHAIN: usize = 16;

impl<T: Value> Welder<T> {
    pub(super) fn new(points: usize) -> Self {
        Self {
            values: vec![T::ZERO; points],
            next: vec![NONE; points],
            seen: vec![false; points],
        }
    }

    /// Where the value of a corner at `vertex` is.
    pub(super) fn index(&mut self, vertex: u32, value: T) -> u32 {
        let mut at = vertex;
        if !self.seen[at as usize] {
            self.seen[at as usize] = true;
            self.values[at as usize] = value;
            return at;
        }
        for _ in 0..LONGEST_CHAIN {
            if self.values[at as usize] == value {
                return at;
            }
            let next = self.next[at as usize];
            if next == NONE {
                break;
            }
            at = next;
        }
        // Fewer values than corners and vertices, and those have 31 bits each.
        let new = u32::try_from(self.values.len()).unwrap_or(NONE);
        self.next.push(self.next[at as usize]);
        self.next[at as usize] = new;
        self.values.push(value);
        new
    }
}
