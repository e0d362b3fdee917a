use oaktwin_depth::stereo_noise::Subpixel;

use super::test_rig::TestRig;
use super::{AccuracyOptions, CAPTURES};
use oaktwin_catalog::DepthKind;

/// Lists the ways in which the measurement deviates from the vendor's protocol.
pub(super) fn protocol_deviations(
    rig: &TestRig,
    options: &AccuracyOptions,
    kind: DepthKind,
    own_width_px: Option<u32>,
) -> Vec<String> {
    let mut deviations = Vec::new();
    let Some(unit) = rig.units.first() else {
        return deviations;
    };
    if !unit.filters.is_empty() {
        deviations.push("post filters are enabled".to_owned());
    }
    match unit.engine.subpixel() {
        Some(Subpixel::Bits5) => {}
        Some(subpixel) => deviations.push(format!("{} subpixel bits instead of 5", subpixel.bits())),
        None if kind == DepthKind::Stereo => {
            deviations.push(format!("{} has no subpixel bits", unit.engine.kind()));
        }
        None => {}
    }
    let width = rig.intrinsics.size.width;
    if let Some(own) = own_width_px.filter(|own| *own > width) {
        deviations.push(format!("images of {width} px instead of {own}"));
    }
    if options.captures != CAPTURES {
        deviations.push(format!("{} captures instead of {CAPTURES}", options.captures));
    }
    deviations
}
