//! OAK sensors and devices as data: every number of Luxonis' parameter sheet, each with its source, and whatever
//! better evidence says beside it.

mod model;
mod source;
mod twin;

pub use model::{
    Accuracy, AccuracyBand, Body, Camera, DepthKind, DepthSensor, Device, Evidence, Imu, LegacyDistortion,
    Note, Role, Sensor,
};
pub use source::{Source, Sources};
pub use twin::{Origin, Twin, TwinCamera, TwinDepthSensor};
