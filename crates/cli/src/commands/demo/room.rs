//! The demo room as every model sees it.

use std::path::Path;

use oaktwin::catalog::{Device, Twin};
use oaktwin::dataset::{Extras, FlatWriter, InputName, Shot, Writer, WriterOptions};
use oaktwin::files::{self, OutputFiles};
use oaktwin::image::annotation::{Annotator, Frame};
use oaktwin::image::contact_sheet::{Column, contact_sheet};
use oaktwin::image::{Image, ZDepth, png};
use oaktwin::render::{OpenOptions, Renderer, Rig, RigSpec, SceneFile};
use oaktwin::sensor;
use oaktwin_demo as demo_room;

use crate::context::Result;
use crate::destination;

/// Twice what the contact sheet shows.
const HEIGHT: u32 = 500;
/// What the room holds, metres: the same colours in every picture.
pub(super) const RANGE_M: (f32, f32) = (0.3, 8.0);
const ANNOTATORS: [Annotator; 3] = [
    Annotator::Rgb,
    Annotator::DistanceToImagePlane,
    Annotator::DepthSensorDistance,
];

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
    let options = WriterOptions {
        extras: Extras {
            preview: true,
            ..Extras::default()
        },
        ..WriterOptions::default()
    };
    let mut columns = Vec::new();
    for (device, twin) in devices.iter().zip(twins) {
        let seen = RoomImages::new(renderer, &mut rig(twin, HEIGHT, &RigSpec::default())?)?;
        let frame = Frame {
            rgb: Some(seen.rgb.clone()),
            distance_to_image_plane: Some(seen.exact.clone()),
            depth_sensor_distance: Some(seen.measured.clone()),
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
            rgb: seen.rgb,
            depth: seen.exact,
            measured: seen.measured,
        });
    }
    Ok(png::encode(&contact_sheet(&columns, RANGE_M))?)
}

/// Makes the rig of a model's own depth sensor, with images so high.
pub(super) fn rig(twin: &Twin, height: u32, spec: &RigSpec) -> Result<Rig> {
    let sensor = sensor::depth_sensor(twin, None)?;
    let own = twin.camera(sensor.spec.camera);
    let spec = RigSpec {
        cameras: vec![sensor.spec.prim.clone()],
        size: own.and_then(|camera| camera.intrinsics.size.scaled_to_height(height)),
        annotators: ANNOTATORS.to_vec(),
        ..spec.clone()
    };
    Ok(Rig::new(twin, &spec)?.0)
}

/// What a rig sees and measures of the room.
pub(super) struct RoomImages {
    pub(super) rgb: Image<[u8; 4]>,
    pub(super) exact: ZDepth,
    pub(super) measured: ZDepth,
}

impl RoomImages {
    pub(super) fn new(renderer: &Renderer, rig: &mut Rig) -> Result<Self> {
        let (shots, _) = rig.shoot(renderer, Some(&demo_room::world_from_body()), 0)?;
        let frame = shots.into_iter().next().ok_or("no camera")?.frame;
        Ok(Self {
            rgb: frame.rgb.ok_or("nothing was rendered")?,
            exact: frame.distance_to_image_plane.ok_or("nothing was rendered")?,
            measured: frame.depth_sensor_distance.ok_or("nothing was measured")?,
        })
    }
}
