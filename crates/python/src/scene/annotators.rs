use std::collections::BTreeMap;

use oaktwin::image::annotation::Annotator;
use oaktwin::render::{annotation_bytes, annotator, frame_bytes};
use pyo3::prelude::*;

use crate::camera::Camera;
use crate::error::{error, wrong};
use crate::memory::check_free;

/// The annotators of scenes and depth sensors: a dictionary from name to description.
///
/// `Scene.render` takes all but "camera_params" and those whose names begin with "depth_sensor_", which
/// `DepthSensor.annotate` takes.
#[pyfunction]
pub(crate) fn annotators() -> BTreeMap<&'static str, &'static str> {
    Annotator::all().map(|one| (one.name(), one.doc())).collect()
}

/// Returns the annotator of a name, if it describes a scene and is an image or a list.
pub(super) fn scene_annotator(name: &str) -> PyResult<Annotator> {
    let found = annotator(name).map_err(error)?;
    if found == Annotator::CameraParams {
        return Err(wrong(
            name,
            "is not an image",
            "use the camera's attributes K, distortion and size",
        ));
    }
    if found.is_depth_sensor() {
        let remedy = "pass distance_to_image_plane (and rgb) to DepthSensor.annotate";
        return Err(wrong(name, "is an output of a depth sensor", remedy));
    }
    Ok(found)
}

pub(super) fn check_memory(camera: &Camera, annotators: &[Annotator], count: usize) -> PyResult<()> {
    let size = camera.camera.intrinsics.size;
    let results = annotation_bytes(size, annotators).saturating_mul(count as u64);
    let needed = results.saturating_add(frame_bytes(size, annotators));
    check_free(
        &camera.name,
        needed,
        "render fewer poses at once or smaller images",
    )
}
