/// A node: up to eight boxes, each of another node or of a range of items.
#[derive(Clone, Debug)]
#[repr(align(64))]
pub(crate) struct Node {
    /// Minimum x, y, z, then maximum x, y, z, of each child; NaN for an absent child.
    pub(crate) bounds: [[f32; 8]; 6],
    /// The index of the child's node, or of its first item.
    pub(crate) first: [u32; 8],
    /// The number of items; 0 for a node.
    pub(crate) count: [u8; 8],
}

impl Node {
    pub(crate) const EMPTY: Self = Self {
        bounds: [[f32::NAN; 8]; 6],
        first: [0; 8],
        count: [0; 8],
    };
}
