use oaktwin_base::diagnostic::{Finding, Level, message, opt};
use oaktwin_depth::Engine;
use oaktwin_depth::filter::Filter;

/// The most fractional bits of disparity with which RVC2 has a median filter (`DepthAI`'s documentation of `StereoDepth`).
const MOST_BITS: u32 = 3;

/// Removes the median filters that RVC2 switches off, with a finding.
pub(super) fn switch_off(filters: &mut Vec<Filter>, engine: &dyn Engine, place: &str) -> Option<Finding> {
    let bits = engine.subpixel()?.bits();
    let count = filters.len();
    if bits > MOST_BITS {
        filters.retain(|filter| !matches!(filter, Filter::Median(_)));
    }
    (filters.len() < count).then(|| {
        Finding::new(
            "median-off",
            Level::Warning,
            place,
            format!("RVC2 has no median filter with {bits} fractional bits of disparity; it has no effect"),
            message![
                "give ",
                opt("param").with("subpixelFractionalBits=3"),
                ", or leave the filter out"
            ],
        )
    })
}
