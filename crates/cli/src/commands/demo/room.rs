//! The demo room as every model sees it.

use std::path::Path;

use oaktwin::catalog::{Device, Twin, TwinDepthSensor};
use oaktwin::contact_sheet::{Column, contact_sheet};
use oaktwin::dataset::{BasicWriter, Extras, Options, Shot};
use oaktwin::image::annotation::{Annotator, Frame};
use oaktwin::image::{ZDepth, png};
use oaktwin::render::{
    AnnotateOptions, Backend, OakOptions, OpenOptions, PlacedCamera, Renderer, SceneFile, oak_cameras,
};
use oaktwin::sensor::single_view::Wanted;
use oaktwin::sensor::{self, SensorOptions};
use oaktwin::{demo_room, files};

use crate::context::Result;
use crate::destination;

/// Twice what the contact sheet shows.
const HEIGHT: u32 = 500;
/// What the room holds, metres: the same colours in every picture.
const RANGE_M: (f32, f32) = (0.3, 8.0);
const ANNOTATORS: [Annotator; 2] = [Annotator::Rgb, Annotator::DistanceToImagePlane];

/// The folder of the room, and in it one for each model's images.
pub(super) const FOLDER: &str = "demo_room";

/// Writes the room into the demo's folder, and what every model's depth camera sees and measures of it; all of that on
/// one picture.
pub(super) fn render(output: &Path, devices: &[Device], twins: &[Twin]) -> Result<Vec<u8>> {
    let folder = output.join(FOLDER);
    for (name, bytes) in demo_room::files()? {
        files::write(&destination::in_folder(&folder, name)?, &bytes)?;
    }
    let scene = SceneFile::open(&folder.join(demo_room::STAGE), &OpenOptions::default())?;
    let renderer = Renderer::new(scene.scene);
    let writer = BasicWriter::new(Options {
        extras: Extras {
            preview: true,
            ..Extras::default()
        },
        ..Options::default()
    });
    let mut columns = Vec::new();
    for (device, twin) in devices.iter().zip(twins) {
        let sensor = depth_sensor(twin)?;
        let camera = depth_camera(twin, sensor)?;
        let view = camera.view(&camera.world_from_mount);
        let (mut frame, _) =
            renderer.annotate(&view, &ANNOTATORS, Backend::Auto, &AnnotateOptions::default());
        frame.depth_sensor_distance = Some(measured(twin, sensor, &camera, &frame)?);
        let shot = Shot {
            frame: &frame,
            camera_params: None,
            number: 0,
            render_product: None,
        };
        for file in writer.files(&shot) {
            let path = destination::in_folder(&folder.join(&device.id), file.path())?;
            files::write(&path, &file.bytes()?)?;
        }
        if let (Some(rgb), Some(depth), Some(measured)) = (
            frame.rgb,
            frame.distance_to_image_plane,
            frame.depth_sensor_distance,
        ) {
            columns.push(Column {
                title: device.name.clone(),
                rgb,
                depth,
                measured,
            });
        }
    }
    Ok(png::encode(&contact_sheet(&columns, RANGE_M))?)
}

/// The model's own depth sensor: the last one, for where there are two, it is the time-of-flight camera.
fn depth_sensor(twin: &Twin) -> Result<&TwinDepthSensor> {
    let sensor = twin.depth_sensors.last();
    Ok(sensor.ok_or_else(|| format!("{} has no depth sensor", twin.device.name))?)
}

fn depth_camera(twin: &Twin, sensor: &TwinDepthSensor) -> Result<PlacedCamera> {
    let own = twin
        .camera(sensor.spec.camera)
        .map(|camera| camera.intrinsics.size);
    let options = OakOptions {
        cameras: std::slice::from_ref(&sensor.spec.prim),
        size: own.and_then(|size| size.scaled_to_height(HEIGHT)),
        ..OakOptions::default()
    };
    let (cameras, _) = oak_cameras(twin, &demo_room::world_from_body(), &options)?;
    Ok(cameras.into_iter().next().ok_or("no camera")?)
}

/// What the sensor reports, by the model of its errors that is nearest to the device.
fn measured(
    twin: &Twin,
    depth_sensor: &TwinDepthSensor,
    camera: &PlacedCamera,
    frame: &Frame,
) -> Result<ZDepth> {
    let options = SensorOptions {
        image: Some(camera.camera.intrinsics),
        ..SensorOptions::default()
    };
    let (mut sensor, _) = sensor::sensor(twin, depth_sensor, &options)?;
    let depth = frame.distance_to_image_plane.as_ref().ok_or("no depth")?;
    let mut shot = sensor::Shot::new((&depth.0).into());
    if let Some(rgb) = &frame.rgb {
        shot = shot.with_rgb(rgb.into())?;
    }
    Ok(sensor.capture(&shot, Wanted::default()).distance)
}
