/// What is left to visit: a node, or the items of a leaf.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Entry {
    /// Where it begins, in whatever measure the walk has.
    pub(crate) start: f32,
    /// The node, or the first item.
    pub(crate) first: u32,
    /// How many items; 0 for a node.
    pub(crate) count: u32,
}

/// Entries, the next one last. It grows as it must and keeps its memory.
pub(crate) type Stack = Vec<Entry>;

/// Appends the children that `mask` has, so that the one that starts first comes out first; equal ones in their
/// order in the node.
#[inline(always)]
pub(crate) fn push_children(stack: &mut Stack, node: &super::bvh::Node, mask: u32, starts: &[f32; 8]) {
    let base = stack.len();
    let mut left = mask & u32::from(node.present);
    while left != 0 {
        let child = 31 - left.leading_zeros() as usize;
        left ^= 1 << child;
        let entry = Entry {
            start: starts[child],
            first: node.first[child],
            count: u32::from(node.count[child]),
        };
        stack.push(entry);
        let mut at = stack.len() - 1;
        while at > base && stack[at - 1].start < entry.start {
            stack[at] = stack[at - 1];
            at -= 1;
        }
        stack[at] = entry;
    }
}
