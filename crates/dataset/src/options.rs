use std::num::NonZeroU64;

/// The options of the writers of files. All but the extras and the shards exist in Replicator's `BasicWriter`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WriterOptions {
    /// The minimum number of digits of a frame number.
    pub frame_padding: usize,
    /// Whether semantic segmentation is written as colours, or as 16-bit ids.
    pub colorize_semantic_segmentation: bool,
    /// Whether instance id segmentation is written as colours, or as 16-bit ids.
    pub colorize_instance_id_segmentation: bool,
    /// The seed in `metadata.txt`; the writer itself is not random.
    pub seed: u64,
    /// The additional files.
    pub extras: Extras,
    /// The number of consecutive frames in a shard, for formats with shards.
    pub shard_frames: NonZeroU64,
}

// Evaluated by the compiler, so that it cannot panic.
/// The number of consecutive frames in a shard, unless it is chosen.
pub const SHARD_FRAMES: NonZeroU64 = NonZeroU64::new(100).unwrap();

impl Default for WriterOptions {
    /// `BasicWriter`'s defaults, and no extras.
    fn default() -> Self {
        Self {
            frame_padding: 4,
            colorize_semantic_segmentation: true,
            colorize_instance_id_segmentation: true,
            seed: 0,
            extras: Extras::default(),
            shard_frames: SHARD_FRAMES,
        }
    }
}

/// Files that are written beside the layout's own; [`BasicWriter`](crate::BasicWriter) lists their names.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[expect(clippy::struct_excessive_bools, reason = "each is a file")]
pub struct Extras {
    /// Whether depth is also written as 16-bit PNG in millimetres.
    pub millimetres: bool,
    /// Whether depth is also written as `OpenEXR`.
    pub exr: bool,
    /// Whether depth is also written as a colour-mapped PNG.
    pub preview: bool,
    /// Whether point clouds are also written as PLY.
    pub ply: bool,
}
