use oaktwin_depth::stereo_noise::Subpixel;

use super::test_rig::TestRig;
use super::{CAPTURES, Options};
use oaktwin_catalog::DepthKind;

/// What is not as the vendor measures.
pub(super) fn differences(
    rig: &TestRig,
    options: &Options,
    kind: DepthKind,
    own_width_px: Option<u32>,
) -> Vec<String> {
    let mut differences = Vec::new();
    let Some(unit) = rig.units.first() else {
        return differences;
    };
    if !unit.filters.is_empty() {
        differences.push("post filters are on".to_owned());
    }
    match unit.engine.subpixel() {
        Some(Subpixel::Bits5) => {}
        Some(subpixel) => differences.push(format!("{} subpixel bits instead of 5", subpixel.bits())),
        None if kind == DepthKind::Stereo => {
            differences.push(format!("{} has no subpixel bits", unit.engine.kind()));
        }
        None => {}
    }
    let width = rig.intrinsics.size.width;
    if let Some(own) = own_width_px.filter(|own| *own > width) {
        differences.push(format!("images of {width} px instead of {own}"));
    }
    if options.captures != CAPTURES {
        differences.push(format!("{} captures instead of {CAPTURES}", options.captures));
    }
    differences
}
