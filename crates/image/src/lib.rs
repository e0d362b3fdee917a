//! Typed images: depth that says what it measures and what invalid means, the annotations of a ground-truth frame,
//! and the files that hold them.
//!
//! Rows run from top to bottom, pixels from left to right. Codecs go from bytes to images and back; they open no files.

pub mod annotation;
mod bytes;
mod depth;
mod error;
pub mod millimetres;
pub mod npy;
pub mod pfm;
mod plane;
pub mod png;

pub use depth::{RangeDepth, ZDepth};
pub use error::CodecError;
pub use plane::Image;
