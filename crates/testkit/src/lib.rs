//! For development only: what tests and benchmarks of rendering share.

#[cfg(target_os = "linux")]
pub mod embree;
pub mod process;
pub mod random;
pub mod reference;
pub mod shapes;
