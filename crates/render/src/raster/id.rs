/// A triangle of a tile: the index of its entry and its index in the cluster.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Id(pub(super) i32);

impl Id {
    pub(super) const NONE: Self = Self(-1);

    /// There are fewer than 2^24 entries: more would not fit into memory.
    #[expect(clippy::cast_possible_truncation, reason = "see above")]
    pub(super) const fn new(entry: usize, triangle: u32) -> Self {
        Self(((entry as u32) << 8 | triangle).cast_signed())
    }

    pub(super) const fn parts(self) -> (usize, usize) {
        let bits = self.0.cast_unsigned() as usize;
        (bits >> 8, bits & 255)
    }
}
