//! Rectification of a stereo pair, as on the device.
//!
//! * RVC2: a homography where the field of view is 85° or less, which leaves the lens distortion in the images; above,
//!   a mesh with a node every 16 pixels, interpolated, with the first eight coefficients of the lens. Both images get the
//!   right camera's intrinsics.
//! * RVC4, and `DepthAI`'s `Rectification` node on a host: a map with a position for each pixel and the complete lens model; both
//!   images get the left camera's intrinsics.
//!
//! Positions are rounded to 1/32 px and pixels are interpolated in integers, as in `cv2.remap` with `INTER_LINEAR`. Pixels
//! outside the raw image are black, or [`EdgeFill`].
//!
//! The target intrinsics of a mesh and the interpolation, which hardware does, are estimates.

mod options;
mod pair;
mod positions;
mod remap;
mod rows;
#[cfg(test)]
mod tests;

pub use options::{EdgeFill, Method, RectifyOptions};
pub use pair::{RemainingDistortion, StereoRectify};
pub use remap::Rectify;
pub use rows::Grey;
