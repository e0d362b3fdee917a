pub use oaktwin_base::parameter::ParameterError;

/// An image whose size differs from the depth image's.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the {what} is {width}x{height}, the depth {depth_width}x{depth_height}; give both in one size")]
pub struct ShotError {
    /// The image.
    pub what: &'static str,
    /// Its width, px.
    pub width: u32,
    /// Its height, px.
    pub height: u32,
    /// The width of the depth image, px.
    pub depth_width: u32,
    /// The height of the depth image, px.
    pub depth_height: u32,
}

/// An array whose length does not match the shape of its batch.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "the {what} of a batch of shape {shape:?} has {length} numbers; give a C-contiguous array of that shape"
)]
pub struct BatchError {
    /// The array.
    pub what: &'static str,
    /// Images, rows, columns.
    pub shape: [usize; 3],
    /// The length of the array.
    pub length: usize,
}
