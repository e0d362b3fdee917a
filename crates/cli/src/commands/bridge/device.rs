//! The device that the bridge simulates: its coordinate frames, and the latency of its images.

use oaktwin::camera::RigidTransform;
use oaktwin::catalog::{Twin, TwinDepthSensor};
use oaktwin::robot::{Attachment, Description, RobotError};
use oaktwin::sensor::{latency, sensor};
use oaktwin_bridge::{Delivery, DeviceFrames};

use crate::args::BridgeArgs;
use crate::context::{Context, Result};

/// Returns the frames of the device, if they are to be published.
pub(super) fn frames(
    context: &Context,
    args: &BridgeArgs,
    twin: &Twin,
    depth: &str,
) -> Result<Option<DeviceFrames>> {
    let Some(name) = &args.tf else {
        return Ok(None);
    };
    let attachment = Attachment {
        name: name.clone(),
        ..Attachment::default()
    };
    let description = Description::new(&context.catalog, twin, &attachment).map_err(|error| match error {
        RobotError::Name { name, problem, .. } => RobotError::Name {
            option: "tf",
            name,
            problem,
        },
        other @ RobotError::NotFinite { .. } => other,
    })?;
    let sensor = twin.depth_sensors.iter().find(|sensor| sensor.spec.prim == depth);
    let camera = sensor.and_then(|sensor| twin.depth_camera(sensor));
    Ok(Some(DeviceFrames {
        device: name.clone(),
        frames: description.frames(),
        body_from_depth: camera.map_or(RigidTransform::IDENTITY, |camera| camera.body_from_camera),
    }))
}

/// Returns when frames are published.
pub(super) fn delivery(args: &BridgeArgs, twin: &Twin, depth: &TwinDepthSensor) -> Result<Delivery> {
    let options = args.engine.options()?;
    let timing = match args.latency.as_deref() {
        Some("catalog") => {
            let (made, _) = sensor(twin, depth, &options)?;
            let latency = latency(twin, depth, made.engine().as_ref(), None).ok_or_else(|| {
                format!(
                    "--latency: the catalog has no latency of {} {}; measure it with fit --latency, and give seconds",
                    twin.device.name, depth.spec.prim
                )
            })?;
            Delivery::of(&latency)
        }
        Some(text) => Delivery {
            latency_s: Delivery::parse_latency(text)?,
            ..Delivery::default()
        },
        None => Delivery::default(),
    };
    let delivery = Delivery {
        jitter_s: args.jitter.unwrap_or(timing.jitter_s),
        drop: args.drop,
        seed: options.seed,
        ..timing
    };
    delivery.check()?;
    Ok(delivery)
}
