//! What the two cameras of an OAK record of a scene, and the same rectified: what its stereo matches.
//!
//! Each camera has its own intrinsics, lens and place, nominal or calibrated. It sees the scene's light ([`PairOptions::ambient`])
//! and, if asked for, the dots of a Pro model's projector; an [image sensor](oaktwin_depth::imager) records it, and a
//! [rectification](oaktwin_depth::rectify) turns both images so that rows meet.
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
mod options;
#[cfg(test)]
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "places within an image"
)]
mod tests;

pub use cameras::PairCameras;
pub use cameras::shifted;
pub use error::PairError;
pub use options::PairOptions;

use oaktwin_camera::{Rectification, RigidTransform};
use oaktwin_catalog::Twin;
use oaktwin_depth::imager::{Exposure, Recorded};
use oaktwin_diagnostic::Finding;
use oaktwin_image::ZDepth;
use oaktwin_render::Renderer;

/// What a stereo pair sees at one moment.
#[derive(Clone, Debug, PartialEq)]
pub struct Pair {
    /// As the left camera records it.
    pub left: Recorded,
    /// As the right camera records it.
    pub right: Recorded,
    /// The left image, rectified.
    pub rectified_left: Recorded,
    /// The right image, rectified.
    pub rectified_right: Recorded,
    /// The truth in the rectified left frame: metres along its optical axis, `+inf` for a miss. It is an ideal pinhole's:
    /// after a homography the images still have their lens's distortion.
    pub z: ZDepth,
    /// How long both collected light.
    pub exposure: Exposure,
    /// The rectified cameras.
    pub geometry: Rectification,
    /// What the pictures had to do without.
    pub findings: Vec<Finding>,
}

/// One pair of a twin whose body (x forward, y left, z up) stands at `world_from_body`, metres. For more than one make
/// [`PairCameras`] once.
///
/// # Errors
/// Those of [`PairCameras::new`].
pub fn pair(
    renderer: &Renderer,
    twin: &Twin,
    world_from_body: &RigidTransform,
    options: &PairOptions,
) -> Result<Pair, PairError> {
    Ok(PairCameras::new(twin, options)?.look(renderer, world_from_body, 0))
}
