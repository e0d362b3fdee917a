//! OpenUSD assets of OAK cameras: author, package, check, read.

pub mod asset;
pub mod body;
pub mod check;
pub mod depth_sensor;
mod lens;
pub mod materialx;
mod nvidia;
pub mod optics;
pub mod scene_file;
pub mod stage;
pub mod text;
pub mod usdz;
