//! Writers of data sets: the layout of Replicator's `BasicWriter`, files named after an input, and recordings.
//!
//! A [`Writer`] receives one [`Shot`] after the other and writes it into [`OutputFiles`](oaktwin_files::OutputFiles). A [`Format`]
//! writes frames in any order; to add one, implement the trait and add a row to [`FORMATS`].
//!
//! ```
//! use oaktwin_dataset::{BasicWriter, FormatWriter, WriterOptions, Shot, Writer};
//! use oaktwin_files::OutputFiles;
//! use oaktwin_image::{Image, ZDepth, annotation::Frame};
//!
//! # let folder = tempfile::tempdir()?;
//! # let folder = folder.path();
//! let frame = Frame {
//!     distance_to_image_plane: Some(ZDepth(Image::filled(4, 3, 1.5))),
//!     ..Frame::default()
//! };
//! let mut output = OutputFiles::in_folder(folder)?;
//! let mut writer = FormatWriter::new(Box::new(BasicWriter::new(WriterOptions::default())));
//! writer.write(&Shot::new(frame, 7), &mut output)?;
//! writer.finish(&mut output)?;
//! assert!(folder.join("distance_to_image_plane_0007.npy").exists());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod basic_writer;
mod boxes;
mod camera_params;
mod cloud;
pub mod euroc;
mod file;
mod flat;
mod formats;
mod imu;
mod json;
mod listing;
mod matrices;
mod normals;
mod object;
mod options;
pub mod recording;
mod segmentation;
mod shot;
mod writer;

pub use basic_writer::BasicWriter;
pub use camera_params::{CameraParams, FrameCamera};
pub use file::DatasetError;
pub use flat::FlatWriter;
pub use formats::{FORMATS, FormatKind, Needs};
pub use imu::ImuSample;
pub use object::{Extent, Model, Object, ObjectMask, Paint, StereoImages};
pub use options::{Extras, SHARD_FRAMES, WriterOptions};
pub use shot::{CloudAxes, InputName, LayerData, Shot, ShotLayer};
pub use writer::{Format, FormatWriter, Records, WriteError, Writer};
