use oaktwin_image::annotation::Frame;

use crate::CameraParams;

/// The arguments of `BasicWriter` that matter here, and what is written beside its own files.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Options {
    /// Digits of the frame's number.
    pub frame_padding: usize,
    /// Semantic segmentation as colours, or as ids in 16 bits.
    pub colorize_semantic_segmentation: bool,
    /// Instance id segmentation as colours, or as ids in 16 bits.
    pub colorize_instance_id_segmentation: bool,
    /// The seed that `metadata.txt` names; nothing here is random.
    pub seed: u64,
    /// What is written beside `BasicWriter`'s own files.
    pub extras: Extras,
}

impl Default for Options {
    /// `BasicWriter`'s defaults, and no extras.
    fn default() -> Self {
        Self {
            frame_padding: 4,
            colorize_semantic_segmentation: true,
            colorize_instance_id_segmentation: true,
            seed: 0,
            extras: Extras::default(),
        }
    }
}

/// Files beside `BasicWriter`'s own: see [`BasicWriter`](crate::BasicWriter) for their names.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[expect(clippy::struct_excessive_bools, reason = "each is a file")]
pub struct Extras {
    /// Depth as 16-bit PNG in millimetres.
    pub millimetres: bool,
    /// Depth as `OpenEXR`.
    pub exr: bool,
    /// Depth as a picture for people.
    pub preview: bool,
    /// The point cloud as PLY.
    pub ply: bool,
}

/// One camera's frame, to be written.
#[derive(Clone, Copy, Debug)]
pub struct Shot<'a> {
    /// The annotations; those that are there are written.
    pub frame: &'a Frame,
    /// The camera, where `camera_params` is asked for.
    pub camera_params: Option<&'a CameraParams>,
    /// The frame's number, from 0.
    pub number: u64,
    /// The render product's name where several cameras are written, each into a folder of its own; `None` for one
    /// camera, whose files lie flat. It is one folder's name: other characters than letters, digits, `_`, `-` and `.`
    /// become `_`.
    pub render_product: Option<&'a str>,
}
