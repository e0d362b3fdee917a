//! Which part of a surface the depth sensors at candidate poses see and measure.
//!
//! Points are distributed evenly over the surface of a [`Region`] of a scene. For each [`Candidate`], an OAK at a pose, the depth
//! sensor's image is simulated, and a ray decides whether a point is visible. The shares of the points that are seen and measured,
//! the errors of the measurements and the [reasons](OutcomeRow) of the losses rank the candidates.
//!
//! ```
//! use oaktwin_camera::math::DVec3;
//! use oaktwin_catalog::Catalog;
//! use oaktwin_evaluate::coverage::{self, Candidate, MeasuringRig, CoverageOptions, Region};
//! use oaktwin_pipeline::render::{Renderer, RigSpec, look_at};
//! use oaktwin_scene::{Instance, Scene, shape};
//! use std::ops::ControlFlow;
//!
//! // A plate of 0.5 m × 0.5 m, 2 m ahead.
//! let mut scene = Scene { meshes: vec![shape::plane(0.5, 0.5, shape::Axis::X)], ..Scene::default() };
//! scene.instances.push(Instance {
//!     mesh: 0,
//!     path: "/World/Plate".to_owned(),
//!     world_from_mesh: oaktwin_camera::math::DAffine3::from_translation(DVec3::new(2.0, 0.0, 0.0)),
//!     labels: Vec::new(),
//!     material_offset: 0,
//! });
//!
//! let catalog = Catalog::builtin();
//! let twin = catalog.nominal(catalog.device("OAK4-D")?);
//! let (rig, _) = MeasuringRig::new(&twin, None, None, &RigSpec::default())?;
//! let ahead = Candidate::new(&rig, "ahead", look_at(DVec3::ZERO, DVec3::X, DVec3::Z)?);
//! let aside = Candidate::new(&rig, "aside", look_at(DVec3::ZERO, DVec3::Y, DVec3::Z)?);
//!
//! let region = Region { objects: vec!["/World/Plate".to_owned()], ..Region::default() };
//! let renderer = Renderer::new(scene);
//! let go_on = |_| ControlFlow::Continue(());
//! let coverage = coverage::measure(&renderer, &region, &[aside, ahead], &CoverageOptions::default(), &go_on)?;
//! assert_eq!(coverage.ranking, [1, 0]);
//! assert_eq!(coverage.candidates[1].shares.seen, 1.0);
//! assert_eq!(coverage.candidates[0].shares.lost["outside_view"], 1.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod assessment;
mod clip;
mod error;
mod lights;
mod measure;
mod motion;
mod motion_picture;
mod motion_table;
mod outcome;
mod patches;
mod picture;
mod placement;
mod region;
mod report;
mod rig;
mod sight;
mod surface;
mod table;
#[cfg(test)]
mod tests;
mod vantage;

pub use error::CoverageError;
pub use lights::{InLight, InLights, LIGHTS};
pub use measure::{CoverageOptions, MAX_CANDIDATES, MAX_SAMPLES, SAMPLES, measure};
pub use motion::{Carrier, MotionCoverage, MountCoverage, measure_motion};
pub use outcome::{Outcome, OutcomeRow, reasons};
pub use patches::{MAX_TRIANGLES, PATCHES, Patches};
pub use picture::picture;
pub use placement::{Base, Placement, PlacementSweep};
pub use region::Region;
pub use report::{
    CandidateCoverage, Coverage, Occluder, OwnRobot, PointOutcomes, SampledRegion, Selected, Shares,
};
pub use rig::{Candidate, MeasuringRig, candidates};
pub use surface::{Samples, SurfacePoint};
