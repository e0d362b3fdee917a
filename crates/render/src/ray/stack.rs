use oaktwin_simd::{I32Lanes, Lanes};

use super::bvh::Node;

/// A node or a leaf to visit.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Entry {
    /// Its start, in the unit of the traversal.
    pub(crate) start: f32,
    /// The node, or the first item.
    pub(crate) first: u32,
    /// The number of items; 0 for a node.
    pub(crate) count: u32,
}

impl Entry {
    /// The root of a tree.
    pub(crate) const ROOT: Self = Self {
        start: f32::NEG_INFINITY,
        first: 0,
        count: 0,
    };

    #[inline(always)]
    fn of_child(node: &Node, child: usize, starts: &[f32; 8]) -> Self {
        Self {
            start: starts[child],
            first: node.first[child],
            count: u32::from(node.count[child]),
        }
    }
}

/// A stack of entries, the next one last.
pub(super) type Entries = Vec<Entry>;

/// A leaf of the tree of an instance's mesh.
#[derive(Clone, Copy, Debug)]
pub(super) struct Leaf {
    pub(super) instance: u32,
    pub(super) first: u32,
    /// The number of triangles; 0 for none.
    pub(super) count: u32,
}

impl Leaf {
    pub(super) const NONE: Self = Self {
        instance: 0,
        first: 0,
        count: 0,
    };
}

/// The number of kinds of rays whose last blocker is remembered.
const KINDS: usize = 128;

/// The memory of a thread that casts rays.
#[derive(Debug)]
pub(crate) struct Stack {
    pub(super) entries: Entries,
    /// The leaf that stopped the last ray of each kind. The search would find it as well.
    blockers: [Leaf; KINDS],
}

impl Default for Stack {
    fn default() -> Self {
        Self {
            entries: Entries::new(),
            blockers: [Leaf::NONE; KINDS],
        }
    }
}

impl Stack {
    /// Forgets what stopped earlier rays, so that nothing depends on the work that a thread did before.
    pub(crate) fn forget(&mut self) {
        self.blockers = [Leaf::NONE; KINDS];
    }

    /// Returns the entries, and the leaf that stopped the last ray of a kind.
    pub(super) fn of_kind(&mut self, kind: usize) -> (&mut Entries, &mut Leaf) {
        (&mut self.entries, &mut self.blockers[kind % KINDS])
    }
}

/// Pushes the children in the mask `seen`, so that the one that starts first is popped first.
#[inline(always)]
pub(crate) fn push_children<L: Lanes>(stack: &mut Entries, node: &Node, seen: L::I32, starts: L) {
    let mut children = seen.signs();
    if children == 0 {
        return;
    }
    let starts_of = starts.to_array();
    let count = children.count_ones() as usize;
    if count == 1 {
        let child = children.trailing_zeros() as usize & 7;
        stack.push(Entry::of_child(node, child, &starts_of));
        return;
    }
    // Indices in the lowest bits make equal values distinct; they change the order by less than rounding does.
    let finite = starts.min(L::splat(f32::MAX)).max(L::splat(f32::MIN));
    let numbers = L::I32::load(&[0, 1, 2, 3, 4, 5, 6, 7]);
    let distinct = L::from_bits((finite.to_bits() & L::I32::splat(!7)) ^ numbers);
    let ranks = L::select(seen, distinct, L::splat(f32::INFINITY)).ranks();
    let base = stack.len();
    stack.resize(base + count, Entry::ROOT);
    let new = &mut stack[base..];
    while children != 0 {
        let child = children.trailing_zeros() as usize & 7;
        children &= children - 1;
        new[count - ranks[child] as usize] = Entry::of_child(node, child, &starts_of);
    }
}
