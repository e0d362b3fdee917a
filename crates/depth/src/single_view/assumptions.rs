/// What public sources leave open. The defaults are what fits NVIDIA's wording and the vendor's published pictures best.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Assumptions {
    /// Where the reported depth comes from.
    pub depth: Depth,
}

/// Where the reported depth comes from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Depth {
    /// A sample keeps the depth that was rendered; disparity only moves it.
    #[default]
    Carried,
    /// From the quantized and jittered disparity; a disparity of 0 or less is no measurement.
    Recomputed,
}
