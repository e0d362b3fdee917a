//! Stores face-varying values once per vertex if all its corners have the same value.

use super::value::Value;

/// Finds earlier corners of a vertex with the same value.
pub(super) struct Welder<T> {
    /// The first value of each vertex in order, followed by additional values.
    pub(super) values: Vec<T>,
    /// For each value the next one of the same vertex; `NONE` at the end.
    next: Vec<u32>,
    seen: Vec<bool>,
}

const NONE: u32 = u32::MAX;
/// Vertices with more values than this get further values unwelded, which keeps the time linear.
const MAX_CHAIN: usize = 16;

impl<T: Value> Welder<T> {
    pub(super) fn new(points: usize) -> Self {
        Self {
            values: vec![T::ZERO; points],
            next: vec![NONE; points],
            seen: vec![false; points],
        }
    }

    /// The index of `value` at a corner of `vertex`.
    pub(super) fn index(&mut self, vertex: u32, value: T) -> u32 {
        let mut at = vertex;
        if !self.seen[at as usize] {
            self.seen[at as usize] = true;
            self.values[at as usize] = value;
            return at;
        }
        for _ in 0..MAX_CHAIN {
            if self.values[at as usize] == value {
                return at;
            }
            let next = self.next[at as usize];
            if next == NONE {
                break;
            }
            at = next;
        }
        // There are fewer values than corners and vertices, each of which has 31 bits.
        let new = u32::try_from(self.values.len()).unwrap_or(NONE);
        self.next.push(self.next[at as usize]);
        self.next[at as usize] = new;
        self.values.push(value);
        new
    }
}
