//! The cameras of a scene's file.

use oaktwin::diagnostic;
use oaktwin::render::{CameraError, PlacedCamera, SceneCameraOptions, SceneFile, scene_cameras};

/// The cameras of a file, or why there are none.
pub(super) type Cameras = Result<Vec<PlacedCamera>, CameraError>;

/// The cameras of a file, with findings.
pub(super) fn cameras(file: &SceneFile) -> (Cameras, Vec<diagnostic::Finding>) {
    match scene_cameras(file, &SceneCameraOptions::default()) {
        Ok((cameras, findings)) => (Ok(cameras), findings),
        Err(CameraError::NoCamera { .. }) => (Ok(Vec::new()), Vec::new()),
        // Reported when the cameras are requested.
        Err(error) => (Err(error), Vec::new()),
    }
}
