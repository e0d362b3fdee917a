//! OAK sensors and devices as data: all numbers of Luxonis' parameter sheet with their sources, and better evidence where it
//! exists.
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
//! Users can add models as TOML files like `data/devices/*.toml`, which [`Catalog::with_dir`] loads and checks: their structure
//! against the types of this crate (with JSON schemas in `schema/`), and their content by rules. Errors state file, line and
//! remedy.

mod builtin;
mod catalog;
mod check;
mod choose;
mod compare;
mod document;
mod error;
mod folder;
mod imu_frame;
mod latency;
mod model;
mod nominal;
mod optics;
mod page;
#[cfg(feature = "schema")]
mod schema;
mod source;
mod twin;

pub use catalog::Catalog;
pub use choose::{DepthFilter, UnknownMaker};
pub use compare::{TextTable, compare};
pub use document::Document;
pub use error::{CatalogError, UnknownModel};
pub use imu_frame::{ImuFrame, nearest_directions};
pub use latency::{Connection, Latency, LatencyStage, MatchingMode};
pub use model::{
    Accelerometer, Accuracy, AccuracyBand, AccuracyHeadline, Body, BodyShape, Camera, DepthKind, DepthSensor,
    Device, Evidence, Gyroscope, Imu, InertialPart, LegacyDistortion, Magnetometer, Note, Projector, Role,
    Sensor, ShutterKind,
};
pub use optics::LensChoice;
pub use page::models_page;
#[cfg(feature = "schema")]
pub use schema::{device_schema, inertial_part_schema, schema_files, sensor_schema};
pub use source::{Source, Sourced, Sources};
pub use twin::{Origin, Twin, TwinCamera, TwinDepthSensor};
