//! Camera mathematics: intrinsics, lens models, poses, stereo geometry, rectification and OpenUSD's apertures. Pure `f64`
//! functions; no files, no global state.
//!
//! # Conventions
//! * Angles are in radians, unless the name ends in `_deg`.
//! * The type of a pixel position defines the centre of the first pixel ([`OpenCv`]: 0, [`Usd`]: 0.5).
//! * Transforms are named `target_from_source`, and points carry their frame: `point_in_camera`.
//! * A camera's frame is OpenCV's optical frame (x right, y down, z forward) unless a name says otherwise.

mod aperture;
mod camera;
mod drift;
pub mod frame_names;
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
pub use drift::{DriftedMatches, MatchError, StereoDrift};
pub use intrinsics::Intrinsics;
pub use lens::{
    FTheta, LensError, LensFamily, LensModel, LensNames, OpenCvFisheye, OpenCvLens, OpenCvPinhole,
};
pub use map::undistort_rectify_map;
pub use pixel::{OpenCv, PixelConvention, PixelPoint, Usd};
pub use pose::{Axes, RigidTransform};
pub use rectify::{
    BaselineAxis, Rectification, RectifiedIntrinsics, RectifyError, stereo_rectify, stereo_rectify_to,
};
pub use size::ImageSize;
pub use stereo::StereoGeometry;

/// The vector and matrix types of this crate's interface, re-exported from `glam`.
pub mod math {
    pub use glam::{DAffine3, DMat2, DMat3, DMat4, DQuat, DVec2, DVec3, DVec4};
}
