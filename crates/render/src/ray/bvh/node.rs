/// Up to eight boxes and what is inside of each: another node, or items next to each other.
#[derive(Clone, Debug)]
#[repr(align(64))]
pub(crate) struct Node {
    /// Smallest x, y, z, then largest x, y, z, of each child. Those of an absent child are NaN.
    pub(crate) bounds: [[f32; 8]; 6],
    /// The child's node, or its first item.
    pub(crate) first: [u32; 8],
    /// How many items; 0 for a node.
    pub(crate) count: [u8; 8],
}

impl Node {
    /// Without children.
    pub(crate) const EMPTY: Self = Self {
        bounds: [[f32::NAN; 8]; 6],
        first: [0; 8],
        count: [0; 8],
    };
}
