//! Alignment to another camera of the device.

use super::{AlignTo, SenseError};
use crate::limits::check_size;
use crate::sensor::{OutputCamera, Sensor};
use oaktwin_base::diagnostic::{message, opt};
use oaktwin_camera::Camera;
use oaktwin_catalog::{LensChoice, Twin, TwinDepthSensor};
use oaktwin_depth::align::Align;

/// Returns the alignment of a sensor's depth images to another camera.
///
/// # Errors
/// Returns an error if the device has no such camera or its image size is invalid.
pub fn align_to(
    twin: &Twin,
    sensor: &TwinDepthSensor,
    look: &Sensor,
    images: &Camera,
    to: &AlignTo,
    lens: LensChoice,
) -> Result<Align, SenseError> {
    aligner(twin, sensor, &look.output_camera(images), to, lens)
}

/// The alignment of reported depth to a camera with its lens.
pub(super) fn aligner(
    twin: &Twin,
    sensor: &TwinDepthSensor,
    reported: &OutputCamera,
    to: &AlignTo,
    lens: LensChoice,
) -> Result<Align, SenseError> {
    let target = twin.camera(to.camera).ok_or_else(|| {
        let has: Vec<&str> = twin
            .cameras
            .iter()
            .map(|camera| camera.spec.role.as_str())
            .collect();
        SenseError::option(message![
            opt("align").with(to.camera),
            format!(
                ": {} has no such camera; expected one of {}",
                twin.device.name,
                has.join(", ")
            )
        ])
    })?;
    let source = twin.depth_camera(sensor).ok_or_else(|| {
        SenseError::option(message![
            opt("align"),
            format!(": the position of {} is unknown; remove it", sensor.spec.prim)
        ])
    })?;
    let mut own = twin.optics(target, lens);
    if let Some(size) = to.size {
        check_size(size)
            .map_err(|error| SenseError::option(message![opt("align-size"), format!(": {error}")]))?;
        own.intrinsics = twin.resized(&own.intrinsics, size);
    }
    let target_from_reported =
        target.body_from_camera.inverse() * source.body_from_camera * reported.input_from_output();
    Ok(Align::new(reported.camera, own, target_from_reported, to.fill))
}
