//! Alignment to another camera of the device.

use super::shot::reported;
use super::{AlignTo, SenseError};
use crate::limits::check_size;
use crate::sensor::Sensor;
use oaktwin_camera::math::{DMat3, DVec3};
use oaktwin_camera::{Camera, ImageSize, RigidTransform};
use oaktwin_catalog::{LensChoice, Twin, TwinDepthSensor};
use oaktwin_depth::align::Align;
use oaktwin_diagnostic::{message, opt};

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
    let size = images.intrinsics.size;
    let (width, height) = look.filters().size(size.width, size.height);
    let smaller = reported(images, ImageSize::new(width, height));
    aligner(
        twin,
        sensor,
        smaller,
        look.engine().lateral_shift_m(&images.intrinsics),
        to,
        lens,
    )
}

/// The alignment of reported depth to a camera with its lens.
pub(super) fn aligner(
    twin: &Twin,
    sensor: &TwinDepthSensor,
    reported: Camera,
    shift_m: f64,
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
                ": {} has no such camera; expected {}",
                twin.device.name,
                has.join(" or ")
            )
        ])
    })?;
    let source = twin.camera(sensor.spec.camera).ok_or_else(|| {
        SenseError::option(message![
            opt("align"),
            format!(": the position of {} is unknown; remove it", sensor.spec.prim)
        ])
    })?;
    let mut own = twin.optics(target, lens);
    if let Some(size) = to.size {
        check_size(size)
            .map_err(|error| SenseError::option(message![opt("align-size"), format!(": {error}")]))?;
        own.intrinsics = own.intrinsics.resized(size, true);
    }
    let source_from_reported = RigidTransform::new(DMat3::IDENTITY, DVec3::new(-shift_m, 0.0, 0.0));
    let target_from_reported =
        target.body_from_camera.inverse() * source.body_from_camera * source_from_reported;
    Ok(Align::new(reported, own, target_from_reported, to.fill))
}
