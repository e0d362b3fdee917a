pub use oaktwin_parameter::ParameterError;

/// Images that do not belong together.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the {what} is {width}x{height}, the depth {depth_width}x{depth_height}; give both in one size")]
pub struct ShotError {
    /// Which image.
    pub what: &'static str,
    /// Its columns.
    pub width: u32,
    /// Its rows.
    pub height: u32,
    /// Columns of the depth.
    pub depth_width: u32,
    /// Rows of the depth.
    pub depth_height: u32,
}

/// A batch whose shape is not that of its numbers.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "the {what} of a batch of shape {shape:?} has {length} numbers; give a C-contiguous array of that shape"
)]
pub struct BatchError {
    /// Which array.
    pub what: &'static str,
    /// Images, rows, columns.
    pub shape: [usize; 3],
    /// How many numbers there are.
    pub length: usize,
}
