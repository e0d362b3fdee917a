//! From a scene file to ground truth.

mod annotators;
mod camera;
mod limits;
mod names;
mod oak;
mod pose;
pub mod trajectory;

pub use annotators::{DEFAULT_ANNOTATORS, UnknownAnnotator, annotator};
pub use camera::{CameraAttributes, CameraError, PlacedCamera};
pub use limits::{MAX_PIXELS, SizeError, available_bytes, check_size, frame_bytes, gib};
pub use names::folder_names;
pub use oak::{OakOptions, check_lens, oak_cameras};
pub use oaktwin_render::{Backend, Clip, Renderer, View};
pub use pose::{PoseError, look_at, pose};
