//! OAK sensors and devices as data: every number of Luxonis' parameter sheet, each with its source, and whatever
//! better evidence says beside it.

mod builtin;
mod catalog;
mod check;
mod compare;
mod document;
mod error;
mod folder;
mod model;
mod nominal;
mod schema;
mod source;
mod twin;

pub use catalog::Catalog;
pub use compare::{Table, compare};
pub use error::{CatalogError, UnknownModel};
pub use model::{
    Accuracy, AccuracyBand, AccuracyHeadline, Body, Camera, DepthKind, DepthSensor, Device, Evidence, Imu,
    LegacyDistortion, Note, Role, Sensor,
};
pub use schema::{device_schema, schema_files, sensor_schema};
pub use source::{Source, Sources};
pub use twin::{Origin, Twin, TwinCamera, TwinDepthSensor};
