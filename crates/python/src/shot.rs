//! The `Shot` of Python.

use oaktwin::camera::RigidTransform;
use oaktwin::dataset;
use oaktwin::diagnostic::Finding;
use oaktwin::image::annotation::Annotator;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::camera::Camera;
use crate::error::wrong;
use crate::finding;
use crate::layers::layers;
use crate::pose::Of;

/// The outputs of a shot by default, in this order; an engine may lack the last ones.
pub(crate) const OUTPUTS: [Annotator; 5] = [
    Annotator::Rgb,
    Annotator::DistanceToImagePlane,
    Annotator::DepthSensorDistance,
    Annotator::DepthSensorReason,
    Annotator::DepthSensorConfidence,
];

/// Returns what a camera of a rig made of a scene, with the body of the device at a pose.
pub(crate) fn shot<'py>(
    py: Python<'py>,
    shot: dataset::Shot,
    world_from_body: &RigidTransform,
    seed: u64,
    findings: &[Finding],
) -> PyResult<Bound<'py, PyAny>> {
    let Some(image) = shot.view else {
        return Err(wrong(
            "shot",
            "has no images",
            "choose annotators that are images",
        ));
    };
    let layers = layers(py, shot.frame, image.camera.intrinsics.size)?;
    // A camera without a depth sensor shows what it sees.
    let measured = shot.sensor_view.as_ref().unwrap_or(&image);
    let about = PyDict::new(py);
    let body_from_world = world_from_body.inverse();
    for (name, view) in [("image_camera", &image), ("camera", measured)] {
        let body_from_camera = body_from_world * view.world_from_camera;
        about.set_item(name, Camera::rectified(view.camera, body_from_camera))?;
    }
    let world_from_camera = Of::Camera.array(py, &measured.world_from_camera)?;
    about.set_item("world_from_camera", world_from_camera)?;
    about.set_item("frame", shot.number)?;
    about.set_item("seed", seed)?;
    about.set_item("findings", finding::list(findings))?;
    let class = py.import("oaktwin._shots")?.getattr("Shot")?;
    class.call((layers,), Some(&about))
}
