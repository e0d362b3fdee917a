//! OpenUSD assets of OAK cameras: author, package, check.

pub mod asset;
pub mod body;
pub mod check;
mod lens;
mod nvidia;
pub mod optics;
pub mod stage;
pub mod text;
pub mod usdz;
