//! Typed images: depth that says what it measures and what invalid means, the annotations of a ground-truth frame,
//! and the files that hold them.
//!
//! Rows run from top to bottom, pixels from left to right. Codecs go from bytes to images and back; they open no files.

pub mod annotation;
mod bytes;
pub mod colormap;
pub mod contact_sheet;
mod depth;
pub mod draw;
mod error;
pub mod exr;
mod half;
mod limits;
pub mod millimetres;
pub mod noise;
pub mod npy;
pub mod pfm;
mod plane;
pub mod ply;
pub mod png;
pub mod preview;
pub mod srgb;
pub mod text;
pub mod texture;
mod view;

pub use depth::{RangeDepth, ZDepth};
pub use error::CodecError;
pub use plane::Image;
pub use view::ImageView;
