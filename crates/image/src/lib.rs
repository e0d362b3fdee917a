//! Typed images: depth that says what it measures and what invalid means, the annotations of a ground-truth frame,
//! and the files that hold them.
//!
//! Rows run from top to bottom, pixels from left to right.

pub mod annotation;
mod depth;
mod plane;

pub use depth::{RangeDepth, ZDepth};
pub use plane::Image;
