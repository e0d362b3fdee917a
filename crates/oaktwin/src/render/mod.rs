//! From a scene file to ground truth.

mod annotators;
mod around;
mod camera;
mod frames;
mod limits;
mod names;
mod oak;
mod output_folder;
mod pose;
mod scene_camera;
mod scene_file;
pub mod trajectory;

pub use annotators::{DEFAULT_ANNOTATORS, UnknownAnnotator, annotator};
pub use camera::{CameraAttributes, CameraError, PlacedCamera};
pub use frames::{Done, FrameOptions, FramesError, Written, WrittenFile, write_frames};
pub use limits::{MAX_PIXELS, SizeError, available_bytes, check_size, frame_bytes, gib};
pub use names::folder_names;
pub use oak::{OakOptions, check_lens, oak_cameras};
pub use oaktwin_render::{Backend, Clip, Renderer, View};
pub use output_folder::OutputFolder;
pub use pose::{PoseError, look_at, pose};
pub use scene_camera::{SceneCameraOptions, scene_cameras};
pub use scene_file::{OpenOptions, SceneFile, SceneFileError};

/// Renders with this many threads from now on. Without effect once something was rendered.
pub fn use_threads(threads: usize) {
    // An error says that the threads are there already.
    let _ = rayon::ThreadPoolBuilder::new()
        .num_threads(threads)
        .build_global();
}
