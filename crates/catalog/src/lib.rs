//! OAK sensors and devices as data: every number of Luxonis' parameter sheet, each with its source, and whatever
//! better evidence says beside it.
//!
//! ```
//! use oaktwin_catalog::{Catalog, Role};
//!
//! let catalog = Catalog::builtin();
//! let device = catalog.device("oak4d")?;
//! let twin = catalog.nominal(device);
//! let left = twin.camera(Role::Left).ok_or("no left camera")?;
//! assert_eq!(left.intrinsics.fx.round(), 805.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! A model of one's own is a TOML file of the form of `data/devices/*.toml`, loaded with [`Catalog::with_dir`] and
//! checked: its form against the types of this crate (as JSON schemas in `schema/`), its sense by rules that name file,
//! line and remedy.

mod builtin;
mod catalog;
mod check;
mod compare;
mod document;
mod error;
mod folder;
mod model;
mod nominal;
mod optics;
mod schema;
mod source;
mod twin;

pub use catalog::Catalog;
pub use compare::{Table, compare};
pub use error::{CatalogError, UnknownModel};
pub use model::{
    Accuracy, AccuracyBand, AccuracyHeadline, Body, Camera, DepthKind, DepthSensor, Device, Evidence, Imu,
    LegacyDistortion, Note, Projector, Role, Sensor,
};
pub use optics::LensChoice;
pub use schema::{device_schema, schema_files, sensor_schema};
pub use source::{Source, Sourced, Sources};
pub use twin::{Origin, Twin, TwinCamera, TwinDepthSensor};
