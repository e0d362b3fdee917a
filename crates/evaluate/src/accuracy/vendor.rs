use oaktwin_depth::stereo_noise::Subpixel;

use super::stand::Stand;
use super::{CAPTURES, Options};
use oaktwin_catalog::DepthKind;
use oaktwin_pipeline::sensor::Engine;

/// What is not as the vendor measures.
pub(super) fn differences(
    stand: &Stand,
    options: &Options,
    kind: DepthKind,
    own_width_px: Option<u32>,
) -> Vec<String> {
    let mut differences = Vec::new();
    let Some(unit) = stand.units.first() else {
        return differences;
    };
    if !unit.filters.is_empty() {
        differences.push("post filters are on".to_owned());
    }
    let subpixel = match &unit.engine {
        Engine::StereoNoise(engine) => Some(engine.parameters().subpixel),
        Engine::StereoMatching(engine) => Some(engine.parameters().subpixel),
        Engine::SingleView(_) | Engine::TimeOfFlight(_) => None,
    };
    if let Some(subpixel) = subpixel.filter(|bits| *bits != Subpixel::Bits5) {
        differences.push(format!("{} subpixel bits instead of 5", subpixel.bits()));
    }
    if matches!(unit.engine, Engine::SingleView(_)) && kind == DepthKind::Stereo {
        differences.push("Isaac Sim's sensor has no subpixel bits".to_owned());
    }
    let width = stand.intrinsics.size.width;
    if let Some(own) = own_width_px.filter(|own| *own > width) {
        differences.push(format!("images of {width} px instead of {own}"));
    }
    if options.captures != CAPTURES {
        differences.push(format!("{} captures instead of {CAPTURES}", options.captures));
    }
    differences
}
