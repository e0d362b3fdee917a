//! The demo room through each engine, on one picture.

use std::error::Error;

use oaktwin::camera::ImageSize;
use oaktwin::catalog::Twin;
use oaktwin::depth::stereo_matching;
use oaktwin::image::contact_sheet::{Picture, panels};
use oaktwin::image::{Image, ZDepth, png};
use oaktwin::pair::{Pair, PairCameras, PairOptions};
use oaktwin::render::Renderer;
use oaktwin::sensor::{
    self, EngineKind, Input, SINGLE_VIEW, STEREO_MATCHING, STEREO_NOISE, SensorOptions, Shot,
};
use oaktwin_demo as demo_room;

use super::room::{self, RANGE_M};
use crate::context::{Context, Result};

/// The model with a dot projector, and the one with a time-of-flight camera.
const MODELS: [&str; 2] = ["oak_d_pro_poe", "oak_d_tof"];
/// The size of the pair at 400P, twice the size of the panels.
const SIZE: ImageSize = ImageSize::new(640, 400);
/// The share of the room's light that remains at night.
const NIGHT: f64 = 0.02;

/// Draws the room as measured by an OAK-D Pro's stereo by day and, with its dot projector, at night, by the other engines, and
/// by the model with time of flight.
pub(super) fn sheet(context: &Context, renderer: &Renderer) -> Result<Vec<u8>> {
    let twin = |id| Ok::<_, Box<dyn Error>>(context.catalog.nominal(context.device(id)?));
    let (pro, tof) = (twin(MODELS[0])?, twin(MODELS[1])?);
    let day = look(renderer, &pro, &PairOptions::default())?;
    let night = look(
        renderer,
        &pro,
        &PairOptions {
            ambient: NIGHT,
            projector: 1.0,
            ..PairOptions::default()
        },
    )?;
    let sensor = sensor::depth_sensor(&pro, None)?;
    let camera = room::depth_camera(&pro, sensor, SIZE.height)?;
    let (rgb, exact) = room::seen(renderer, &camera)?;
    let by = |kind: &'static EngineKind, pair: Option<&Pair>| -> Result<ZDepth> {
        let options = SensorOptions {
            engine: Some(kind),
            image: Some(camera.camera.intrinsics),
            ..SensorOptions::default()
        };
        let (mut sensor, _) = sensor::sensor(&pro, sensor, &options)?;
        let input = match pair {
            None => Input::Depth(Shot::new((&exact.0).into()).with_rgb((&rgb).into())?),
            Some(pair) => Input::Pair(stereo_matching::Pair::new(
                &pair.rectified_left,
                &pair.rectified_right,
            )?),
        };
        Ok(sensor.capture(input, &[])?.distance)
    };
    let single_view = by(&SINGLE_VIEW, None)?;
    let stereo_noise = by(&STEREO_NOISE, None)?;
    let by_day = by(&STEREO_MATCHING, Some(&day))?;
    let by_night = by(&STEREO_MATCHING, Some(&night))?;
    let dots: Image<u8> = night.left.to_eight();
    let time_of_flight = room::measured_by(renderer, &tof, SIZE.height)?;
    let all = [
        ("colour", Picture::Rgb(&rgb)),
        ("exact depth", Picture::Depth(&exact)),
        ("single-view: Isaac Sim's", Picture::Depth(&single_view)),
        ("stereo-noise", Picture::Depth(&stereo_noise)),
        ("at night, with dots", Picture::Grey(&dots)),
        ("stereo-matching by day", Picture::Depth(&by_day)),
        ("stereo-matching at night", Picture::Depth(&by_night)),
        ("time-of-flight (OAK-D ToF)", Picture::Depth(&time_of_flight)),
    ];
    Ok(png::encode(&panels(&all, 4, RANGE_M))?)
}

/// Renders a pair.
fn look(renderer: &Renderer, twin: &Twin, options: &PairOptions) -> Result<Pair> {
    let options = PairOptions {
        size: Some(SIZE),
        ..*options
    };
    Ok(PairCameras::new(twin, &options)?.look(renderer, &demo_room::world_from_body(), 0))
}
