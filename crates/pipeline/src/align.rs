//! Alignment of depth to another camera of the device.

use crate::limits::check_size;
use crate::sensor::{OutputCamera, Sensor};
use oaktwin_base::diagnostic::{Message, message, opt};
use oaktwin_camera::{Camera, ImageSize, RigidTransform};
use oaktwin_catalog::{LensChoice, Role, Twin, TwinDepthSensor};
use oaktwin_dataset::{LayerData, ShotLayer};
use oaktwin_depth::align::{Align, AlignMode, AlignedZ, Fill};
use oaktwin_image::annotation::Annotator;
use oaktwin_image::{Image, ZDepth};

/// The camera that depth is aligned to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct AlignTo {
    /// The camera.
    pub camera: Role,
    /// The size of its image, resized by `DepthAI`'s rule; by default the camera's own.
    pub size: Option<ImageSize>,
    /// The splatting mode.
    pub fill: Fill,
    /// The depth of aligned samples; by default of a stereo pair [its platform's](AlignedZ::of_stereo), else `geometric`.
    pub z: Option<AlignedZ>,
}

/// The camera that measured.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Measuring<'a> {
    pub(crate) body_from_camera: RigidTransform,
    pub(crate) reported: &'a OutputCamera,
    pub(crate) is_stereo: bool,
}

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
) -> Result<Align, Message> {
    of_sensor(twin, sensor, &look.output_camera(images), to, lens)
}

/// The alignment of reported depth to a camera with its lens.
pub(crate) fn of_sensor(
    twin: &Twin,
    sensor: &TwinDepthSensor,
    reported: &OutputCamera,
    to: &AlignTo,
    lens: LensChoice,
) -> Result<Align, Message> {
    let source = twin.depth_camera(sensor).ok_or_else(|| {
        message![
            opt("align"),
            format!(": the position of {} is unknown; remove it", sensor.spec.prim)
        ]
    })?;
    let measuring = Measuring {
        body_from_camera: source.body_from_camera,
        reported,
        is_stereo: sensor.spec.pair().is_some(),
    };
    aligner(twin, &measuring, to, lens)
}

/// The alignment of depth that a camera of the device measured.
pub(crate) fn aligner(
    twin: &Twin,
    from: &Measuring<'_>,
    to: &AlignTo,
    lens: LensChoice,
) -> Result<Align, Message> {
    let target = twin.camera(to.camera).ok_or_else(|| {
        let has: Vec<&str> = twin
            .cameras
            .iter()
            .map(|camera| camera.spec.role.as_str())
            .collect();
        message![
            opt("align").with(to.camera),
            format!(
                ": {} has no such camera; expected one of {}",
                twin.device.name,
                has.join(", ")
            )
        ]
    })?;
    let mut own = twin.optics(target, lens);
    if let Some(size) = to.size {
        check_size(size).map_err(|error| message![opt("align-size"), format!(": {error}")])?;
        own.intrinsics = own.intrinsics.resized(size, true);
    }
    let target_from_reported =
        target.body_from_camera.inverse() * from.body_from_camera * from.reported.input_from_output();
    let own_z = || match from.is_stereo {
        true => AlignedZ::of_stereo(twin.platform()),
        false => AlignedZ::default(),
    };
    let mode = AlignMode {
        fill: to.fill,
        z: to.z.unwrap_or_else(own_z),
    };
    Ok(Align::new(from.reported.camera, own, target_from_reported, mode))
}

/// The aligned depth of a sensor's output, which has the size that the alignment was made for.
pub(crate) fn layer(align: &Align, to: &AlignTo, depth: &Image<f32>) -> Option<ShotLayer> {
    let ZDepth(aligned) = align.align(depth.into()).ok()?;
    let name = Annotator::DepthSensorDistance.name();
    Some(ShotLayer {
        folder: name,
        name: format!("{name}_aligned_{}", to.camera),
        data: LayerData::Depth(aligned),
    })
}
