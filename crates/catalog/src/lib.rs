//! OAK sensors and devices as data: every number of Luxonis' parameter sheet, each with its source, and whatever
//! better evidence says beside it.

mod builtin;
mod catalog;
mod check;
mod document;
mod error;
mod folder;
mod model;
mod nominal;
mod source;
mod twin;

pub use catalog::Catalog;
pub use error::{CatalogError, UnknownModel};
pub use model::{
    Accuracy, AccuracyBand, AccuracyHeadline, Body, Camera, DepthKind, DepthSensor, Device, Evidence, Imu,
    LegacyDistortion, Note, Role, Sensor,
};
pub use source::{Source, Sources};
pub use twin::{Origin, Twin, TwinCamera, TwinDepthSensor};
