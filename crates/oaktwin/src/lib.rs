//! Digital twins of Luxonis OAK depth cameras: the facade crate of oaktwin.
//!
//! A [`Twin`](catalog::Twin) is a device with all cameras resolved: intrinsics, lens and pose. A nominal twin comes from the
//! [`Catalog`](catalog::Catalog), the twin of one unit from its calibration ([`unit::open`]). A twin can be written as a USD
//! asset ([`usd::asset`]), a report ([`report`]) or a calibration for other programs ([`calibration::export`]), and can be
//! placed in a scene to render what its cameras see ([`render`]).
//!
//! ```
//! use oaktwin::camera::{Usd, math::DVec3};
//! use oaktwin::catalog::{Catalog, Role};
//! use oaktwin::usd::asset::{AssetOptions, asset};
//!
//! let catalog = Catalog::builtin();
//! let twin = catalog.nominal(catalog.device("OAK-D Pro PoE")?);
//!
//! let left = twin.camera(Role::Left).ok_or("no left camera")?;
//! assert_eq!(left.intrinsics.fx.round(), 805.0);
//! // Places are metres in the body frame: x forward, y left, z up.
//! assert_eq!(left.body_from_camera.translation, DVec3::new(0.0, 0.0375, 0.0));
//!
//! let usd = asset(&twin, &AssetOptions::default())?;
//! assert!(usd.text().starts_with("#usda 1.0"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub use oaktwin_base::{diagnostic, parameter};
pub use oaktwin_calibration as calibration;
pub use oaktwin_calibration::population;
pub use oaktwin_camera as camera;
pub use oaktwin_catalog as catalog;
pub use oaktwin_dataset as dataset;
pub use oaktwin_depth as depth;
pub use oaktwin_evaluate::{accuracy, coverage, figure, fit, measure};
pub use oaktwin_files as files;
pub use oaktwin_files::memory;
#[cfg(feature = "generate")]
pub use oaktwin_generate as generate;
pub use oaktwin_image as image;
pub use oaktwin_pipeline::{imu, pair, progress, recording, render, report, sense, sensor, stereo, unit};
pub use oaktwin_robot as robot;
pub use oaktwin_scene as scene;
pub use oaktwin_usd as usd;
