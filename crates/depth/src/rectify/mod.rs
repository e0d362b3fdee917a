//! Raw images of a stereo pair to rectified ones, as the device does it.
//!
//! * RVC2: a homography where the field of view is 85° or less, which leaves the lens's distortion in the images; above,
//!   a mesh of a position every 16 pixels, with positions between them and with the first eight coefficients of the
//!   lens. Both images get the right camera's intrinsics.
//! * RVC4, and `DepthAI`'s `Rectification` node on a host: a position for each pixel, with the whole lens; both images
//!   get the left camera's intrinsics.
//!
//! Positions are rounded to 1/32 px and four pixels are mixed in whole numbers, as `cv2.remap` with `INTER_LINEAR` does.
//! What falls outside an image is black, or [`EdgeFill`]'s.
//!
//! What a mesh's target intrinsics are, and that a device mixes as OpenCV does, are estimates: hardware does both.

mod options;
mod pair;
mod positions;
mod remap;
mod rows;
#[cfg(test)]
mod tests;

pub use options::{EdgeFill, Method, RectifyOptions, Target};
pub use pair::StereoRectify;
pub use remap::Rectify;
pub use rows::Grey;
