//! Typed images: depth with its unit and invalid value, the annotations of a ground-truth frame, and file formats.
//!
//! Rows run from top to bottom, pixels from left to right. Codecs convert between bytes and images; they open no files.

pub mod annotation;
mod bytes;
pub mod colormap;
pub mod contact_sheet;
mod depth;
mod error;
pub mod exr;
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
pub mod tiff;
mod view;

pub use depth::{RangeDepth, ZDepth};
pub use error::CodecError;
pub use plane::Image;
pub use view::ImageView;
