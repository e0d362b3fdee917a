//! Shared code of tests and benchmarks; for development only.

pub mod agreement;
#[cfg(target_os = "linux")]
pub mod embree;
pub mod process;
pub mod random;
pub mod reference;
pub mod shapes;
pub mod stereo_pair;
pub mod views;
