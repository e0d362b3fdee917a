//! Camera mathematics of an OAK twin: intrinsics, lens models, poses, stereo rigs, rectification and
//! OpenUSD's apertures. Pure `f64` functions; no files, no global state.
//!
//! # Conventions
//! * Angles are radians; a name that ends in `_deg` is in degrees.
//! * A pixel position says where the centre of the first pixel lies ([`OpenCv`]: 0, [`Usd`]: 0.5).
//! * Transforms are named `target_from_source`, and points carry their frame: `point_in_camera`.
//! * A camera's own frame is OpenCV's optical one (x right, y down, z forward) unless a name says otherwise.

mod aperture;
mod camera;
mod intrinsics;
mod lens;
mod map;
mod pixel;
mod pose;
mod rectify;
mod resize;
mod size;
mod stereo;

pub use aperture::{ApertureOffsets, UsdOptics, tenths_of_stage_unit};
pub use camera::Camera;
pub use intrinsics::Intrinsics;
pub use lens::{FTheta, LensError, LensModel, OpenCvFisheye, OpenCvPinhole};
pub use map::undistort_rectify_map;
pub use pixel::{OpenCv, PixelConvention, PixelPoint, Usd};
pub use pose::{Axes, RigidTransform};
pub use rectify::{
    BaselineAxis, Rectification, RectifiedIntrinsics, RectifyError, stereo_rectify, stereo_rectify_to,
};
pub use size::ImageSize;
pub use stereo::StereoGeometry;

/// The vector and matrix types of this crate's interface, from `glam`, so that one version serves all.
pub mod math {
    pub use glam::{DAffine3, DMat2, DMat3, DMat4, DQuat, DVec2, DVec3, DVec4};
}
