//! The images of an OAK's stereo pair in a scene, raw and rectified.
//!
//! Each camera has its own intrinsics, lens and pose, nominal or calibrated. It sees the scene's light ([`PairOptions::ambient`])
//! and optionally the dots of a Pro model's projector; an [image sensor](oaktwin_depth::imager) records it, and a
//! [rectification](oaktwin_depth::rectify) aligns the rows of both images.
//!
//! ```
//! use oaktwin_camera::math::{DAffine3, DVec3};
//! use oaktwin_catalog::Catalog;
//! use oaktwin_pipeline::pair::{PairOptions, pair};
//! use oaktwin_pipeline::render::{Renderer, look_at};
//! use oaktwin_scene::{Instance, Mesh, Scene};
//!
//! let wall = Mesh {
//!     positions: vec![[2.0, -9.0, -9.0], [2.0, 9.0, -9.0], [2.0, 0.0, 18.0]],
//!     triangles: vec![[0, 1, 2]],
//!     ..Mesh::default()
//! };
//! let mut scene = Scene { meshes: vec![wall], ..Scene::default() };
//! scene.instances.push(Instance {
//!     mesh: 0,
//!     path: "/Wall".to_owned(),
//!     world_from_mesh: DAffine3::IDENTITY,
//!     labels: Vec::new(),
//!     material_offset: 0,
//! });
//!
//! let catalog = Catalog::builtin();
//! let twin = catalog.nominal(catalog.device("OAK-D Pro PoE")?);
//! let options = PairOptions { projector: 1.0, ..PairOptions::default() };
//! let world_from_body = look_at(DVec3::ZERO, DVec3::X, DVec3::Z)?;
//! let seen = pair(&Renderer::new(scene), &twin, &world_from_body, &options)?;
//! assert_eq!((seen.rectified_left.width(), seen.rectified_left.height()), (1280, 800));
//! assert_eq!(seen.z.0.get(640, 400), Some(&2.0));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod cameras;
mod error;
mod images;
mod options;
#[cfg(test)]
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "places within an image"
)]
mod tests;

pub(crate) use cameras::Light;
pub use cameras::{PairCameras, PairLight, default_projector, illumination, shifted};
pub use error::PairError;
pub use options::PairOptions;

use oaktwin_base::diagnostic::Finding;
use oaktwin_camera::{Rectification, RigidTransform};
use oaktwin_catalog::Twin;
use oaktwin_depth::imager::{Exposure, Recorded};
use oaktwin_image::ZDepth;
use oaktwin_render::Renderer;

/// A recorded stereo pair.
#[derive(Clone, Debug, PartialEq)]
pub struct Pair {
    /// The raw left image.
    pub left: Recorded,
    /// The raw right image.
    pub right: Recorded,
    /// The rectified left image.
    pub rectified_left: Recorded,
    /// The rectified right image.
    pub rectified_right: Recorded,
    /// The ground truth of the rectified left camera: z-depth in metres, `+inf` for a miss. It describes an ideal pinhole;
    /// after a homography the images still have lens distortion.
    pub z: ZDepth,
    /// The exposure of both cameras.
    pub exposure: Exposure,
    /// The geometry of the rectified cameras.
    pub geometry: Rectification,
    /// Findings about missing or unsupported appearance.
    pub findings: Vec<Finding>,
}

/// Renders one pair of a twin with its body (x forward, y left, z up) at `world_from_body`, metres. For several pairs create
/// [`PairCameras`] once.
///
/// # Errors
/// Returns the errors of [`PairCameras::new`].
pub fn pair(
    renderer: &Renderer,
    twin: &Twin,
    world_from_body: &RigidTransform,
    options: &PairOptions,
) -> Result<Pair, PairError> {
    Ok(PairCameras::new(twin, options)?.capture(renderer, world_from_body, 0))
}
