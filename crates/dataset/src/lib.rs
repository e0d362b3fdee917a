//! Writers of data sets: the layout of Replicator's `BasicWriter`, recordings, and pictures and figures for people.
//!
//! A writer says which files a frame consists of; each [`DatasetFile`] is encoded when it is asked for its bytes, on any
//! thread. Nothing is written here: whoever opens files does so whole or not at all.
//!
//! ```
//! use oaktwin_dataset::{BasicWriter, Options, Shot};
//! use oaktwin_image::{Image, ZDepth, annotation::Frame};
//!
//! let frame = Frame {
//!     distance_to_image_plane: Some(ZDepth(Image::filled(4, 3, 1.5))),
//!     ..Frame::default()
//! };
//! let writer = BasicWriter::new(Options::default());
//! let files = writer.files(&Shot { frame: &frame, number: 7, camera_params: None, render_product: None });
//! assert_eq!(files[0].path(), "distance_to_image_plane_0007.npy");
//! assert!(files[0].bytes()?.starts_with(b"\x93NUMPY"));
//! # Ok::<(), oaktwin_dataset::DatasetError>(())
//! ```

mod basic_writer;
mod boxes;
mod camera_params;
mod cloud;
mod file;
mod json;
mod listing;
mod matrices;
mod normals;
mod options;
pub mod recording;
mod segmentation;

pub use basic_writer::BasicWriter;
pub use camera_params::{CameraParams, View};
pub use file::{DatasetError, DatasetFile};
pub use options::{Extras, Options, Shot};
