//! Digital twins of Luxonis OAK depth cameras: the facade of oaktwin's crates.
//!
//! A [`Twin`](catalog::Twin) is a device with every camera resolved: optics, lens, place. It comes from the
//! [`Catalog`](catalog::Catalog), nominal, or from a calibration, as one unit's ([`unit::open`]), and becomes a USD
//! asset ([`usd::asset`]), a report ([`report`]) or a calibration for other programs ([`calibration::export`]), or is put
//! into a scene, to see what it would see there ([`render`]).
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
//! assert_eq!(left.intrinsics.principal_point::<Usd>().x, 640.0);
//! // Places are metres in the body frame: x forward, y left, z up.
//! assert_eq!(left.body_from_camera.translation, DVec3::new(0.0, 0.0375, 0.0));
//!
//! let usd = asset(&twin, &AssetOptions::default())?;
//! assert!(usd.text().starts_with("#usda 1.0"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub use oaktwin_calibration as calibration;
pub use oaktwin_camera as camera;
pub use oaktwin_catalog as catalog;
pub use oaktwin_dataset as dataset;
pub use oaktwin_depth as depth;
pub use oaktwin_diagnostic as diagnostic;
pub use oaktwin_evaluate::{accuracy, figure, fit, measure};
pub use oaktwin_files as files;
pub use oaktwin_image as image;
pub use oaktwin_pipeline::{pair, progress, recording, render, report, sense, sensor, stereo, unit};
pub use oaktwin_scene as scene;
pub use oaktwin_usd as usd;
