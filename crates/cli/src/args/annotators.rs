//! Help on annotators.

use oaktwin::image::annotation::Annotator;

/// Returns the names of the annotators of scenes or depth sensors, each with its description.
pub(super) fn annotators(is_depth_sensor: bool) -> String {
    Annotator::all()
        .filter(|one| one.is_depth_sensor() == is_depth_sensor)
        .map(|one| format!("\n  {}: {}", one.name(), one.doc()))
        .collect()
}

/// Returns the names of a depth sensor's annotators other than its distance, comma-separated.
pub(super) fn sensor_outputs() -> String {
    let all = Annotator::all().filter(|one| one.is_depth_sensor() && *one != Annotator::DepthSensorDistance);
    all.map(Annotator::name).collect::<Vec<_>>().join(", ")
}
