//! The demo room through each engine, on one picture.

use std::error::Error;

use oaktwin::image::contact_sheet::{Picture, panels};
use oaktwin::image::{Image, png};
use oaktwin::pair::PairOptions;
use oaktwin::render::{Renderer, Rig, RigSpec};
use oaktwin::sensor::{EngineKind, SINGLE_VIEW, STEREO_MATCHING, STEREO_NOISE, SensorOptions};
use oaktwin_demo as demo_room;

use super::room::{self, RANGE_M, RoomImages};
use crate::context::{Context, Result};

/// The model with a dot projector, and the one with a time-of-flight camera.
const MODELS: [&str; 2] = ["oak_d_pro_poe", "oak_d_tof"];
/// The height of the pair at 400P, twice the height of the panels.
const HEIGHT: u32 = 400;
/// The share of the room's light that remains at night.
const NIGHT: f64 = 0.02;

/// Draws the room as measured by an OAK-D Pro's stereo by day and, with its dot projector, at night, by the other engines, and
/// by the model with time of flight.
pub(super) fn sheet(context: &Context, renderer: &Renderer) -> Result<Vec<u8>> {
    let twin = |id| Ok::<_, Box<dyn Error>>(context.catalog.nominal(context.device(id)?));
    let (pro, tof) = (twin(MODELS[0])?, twin(MODELS[1])?);
    let by = |kind: &'static EngineKind, light: &PairOptions| {
        let spec = RigSpec {
            sensor: SensorOptions {
                engine: Some(kind.into()),
                ..SensorOptions::default()
            },
            pair: *light,
            ..RigSpec::default()
        };
        room::rig(&pro, HEIGHT, &spec)
    };
    let day = PairOptions::default();
    let night = PairOptions {
        ambient: NIGHT,
        projector: 1.0,
        ..day
    };
    let measured = |mut rig: Rig| Ok::<_, Box<dyn Error>>(RoomImages::new(renderer, &mut rig)?.measured);
    let seen = RoomImages::new(renderer, &mut by(&SINGLE_VIEW, &day)?)?;
    let (rgb, exact, single_view) = (seen.rgb, seen.exact, seen.measured);
    let stereo_noise = by(&STEREO_NOISE, &day)?.measure(exact.clone(), Some(rgb.clone()), 0)?;
    let stereo_noise = stereo_noise.depth_sensor_distance.ok_or("nothing was measured")?;
    let by_day = measured(by(&STEREO_MATCHING, &day)?)?;
    let at_night = by(&STEREO_MATCHING, &night)?;
    let pair = at_night.pair().ok_or("no stereo pair")?;
    let pair = pair.capture(renderer, &demo_room::world_from_body(), 0);
    let dots: Image<u8> = pair.left.to_eight();
    let by_night = measured(at_night)?;
    let time_of_flight = measured(room::rig(&tof, HEIGHT, &RigSpec::default())?)?;
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
