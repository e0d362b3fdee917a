//! The demo room as every model sees it.

use std::path::Path;

use oaktwin::catalog::{Device, Twin, TwinDepthSensor};
use oaktwin::dataset::{Extras, FlatWriter, InputName, Options, Shot, Writer};
use oaktwin::files::{self, OutputFiles};
use oaktwin::image::annotation::{Annotator, Frame};
use oaktwin::image::contact_sheet::{Column, contact_sheet};
use oaktwin::image::{Image, ZDepth, png};
use oaktwin::render::{
    AnnotateOptions, Backend, OakOptions, OpenOptions, PlacedCamera, Renderer, SceneFile, oak_cameras,
};
use oaktwin::sensor::{self, SensorOptions};
use oaktwin_demo as demo_room;

use crate::context::Result;
use crate::destination;

/// Twice what the contact sheet shows.
const HEIGHT: u32 = 500;
/// What the room holds, metres: the same colours in every picture.
pub(super) const RANGE_M: (f32, f32) = (0.3, 8.0);
const ANNOTATORS: [Annotator; 2] = [Annotator::Rgb, Annotator::DistanceToImagePlane];

/// The folder of the room, and in it one for each model's images.
pub(super) const FOLDER: &str = "demo_room";

/// Writes the room into the demo's folder, and opens it.
pub(super) fn open(output: &Path) -> Result<Renderer> {
    let folder = output.join(FOLDER);
    for (name, bytes) in demo_room::files()? {
        files::write(&destination::in_folder(&folder, name)?, &bytes)?;
    }
    let scene = SceneFile::open(&folder.join(demo_room::STAGE), &OpenOptions::default())?;
    Ok(Renderer::new(scene.scene))
}

/// Writes what every model's depth camera sees and measures of the room; all of that on one picture.
pub(super) fn render(
    renderer: &Renderer,
    output: &Path,
    devices: &[&Device],
    twins: &[Twin],
) -> Result<Vec<u8>> {
    let folder = output.join(FOLDER);
    let options = Options {
        extras: Extras {
            preview: true,
            ..Extras::default()
        },
        ..Options::default()
    };
    let mut columns = Vec::new();
    for (device, twin) in devices.iter().zip(twins) {
        let sensor = sensor::depth_sensor(twin, None)?;
        let camera = depth_camera(twin, sensor, HEIGHT)?;
        let (rgb, depth) = seen(renderer, &camera)?;
        let measured = measured(twin, sensor, &camera, (&rgb, &depth))?;
        let frame = Frame {
            rgb: Some(rgb.clone()),
            distance_to_image_plane: Some(depth.clone()),
            depth_sensor_distance: Some(measured.clone()),
            ..Frame::default()
        };
        let mut output = OutputFiles::in_folder(&folder.join(&device.id))?;
        let input = InputName {
            suffix: "_0000".to_owned(),
            ..InputName::default()
        };
        let shot = Shot {
            input,
            ..Shot::new(frame, 0)
        };
        FlatWriter::new(options).write(&shot, &mut output)?;
        columns.push(Column {
            title: device.name.clone(),
            rgb,
            depth,
            measured,
        });
    }
    Ok(png::encode(&contact_sheet(&columns, RANGE_M))?)
}

/// What a model's own depth sensor reports of the room, in images so high.
pub(super) fn measured_by(renderer: &Renderer, twin: &Twin, height: u32) -> Result<ZDepth> {
    let sensor = sensor::depth_sensor(twin, None)?;
    let camera = depth_camera(twin, sensor, height)?;
    let (rgb, depth) = seen(renderer, &camera)?;
    measured(twin, sensor, &camera, (&rgb, &depth))
}

/// The picture that a camera takes, and its depth.
pub(super) fn seen(renderer: &Renderer, camera: &PlacedCamera) -> Result<(Image<[u8; 4]>, ZDepth)> {
    let view = camera.view(&camera.world_from_mount);
    let (frame, _) = renderer.annotate(&view, &ANNOTATORS, Backend::Auto, &AnnotateOptions::default());
    let both = frame.rgb.zip(frame.distance_to_image_plane);
    Ok(both.ok_or("nothing was rendered")?)
}

pub(super) fn depth_camera(twin: &Twin, sensor: &TwinDepthSensor, height: u32) -> Result<PlacedCamera> {
    let own = twin
        .camera(sensor.spec.camera)
        .map(|camera| camera.intrinsics.size);
    let options = OakOptions {
        cameras: std::slice::from_ref(&sensor.spec.prim),
        size: own.and_then(|size| size.scaled_to_height(height)),
        ..OakOptions::default()
    };
    let (cameras, _) = oak_cameras(twin, &demo_room::world_from_body(), &options)?;
    Ok(cameras.into_iter().next().ok_or("no camera")?)
}

/// What the sensor reports of a picture and its depth, by the model of its errors that is nearest to the device.
fn measured(
    twin: &Twin,
    depth_sensor: &TwinDepthSensor,
    camera: &PlacedCamera,
    (rgb, depth): (&Image<[u8; 4]>, &ZDepth),
) -> Result<ZDepth> {
    let options = SensorOptions {
        image: Some(camera.camera.intrinsics),
        ..SensorOptions::default()
    };
    let (mut sensor, _) = sensor::sensor(twin, depth_sensor, &options)?;
    let shot = sensor::Shot::new((&depth.0).into()).with_rgb(rgb.into())?;
    Ok(sensor.capture(shot, &[])?.distance)
}
