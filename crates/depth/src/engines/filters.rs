//! Where filters run.
//!
//! * On stereo, as on the device, on fixed-point disparity. The disparity range is spread over 0 to 8192 first, as
//!   `DepthAI`'s `getMaxDisparity` documents, unless no filter changes disparities or the last that does is a median:
//!   `delta` is in these units, `differenceThreshold` in pixels of disparity. Filters of depth ([`Filter::is_of_depth`])
//!   run after all others, on millimetres.
//! * On all other sensors in their order on depth, in whole millimetres.

use oaktwin_image::{Image, ImageView, ZDepth, millimetres};

use crate::disparity::Subpixel;
use crate::filter::{Chain, Filter};
use crate::reason::{Reason, ReasonCodes};

/// The range over which disparities are spread where filters change them: 13 bits, by `DepthAI`'s
/// `StereoDepthConfig::getMaxDisparity`.
const FILTERED_RANGE: f64 = 8192.0;

type Rgb<'a> = Option<ImageView<'a, [u8; 4]>>;

/// Whether no filter works on disparity.
pub(super) fn are_of_depth(filters: &Chain) -> bool {
    filters.filters().iter().all(Filter::is_of_depth)
}

/// Runs the filters that work on disparity. Returns the filtered disparity and the factor by which it is spread.
pub(super) fn run_on_disparity(
    filters: &mut Chain,
    mut disparity: Image<u16>,
    rgb: Rgb<'_>,
    max_px: u32,
    subpixel: Subpixel,
    reasons: Option<&mut ReasonCodes>,
) -> (Image<u16>, f64) {
    if are_of_depth(filters) {
        return (disparity, 1.0);
    }
    let scale = spread(filters.filters(), max_px, subpixel, &mut disparity);
    let integer_level = scale * f64::from(1 << subpixel.bits());
    let filtered = filters.run_some(
        disparity,
        rgb,
        integer_level,
        |filter| !filter.is_of_depth(),
        reasons,
    );
    (filtered, scale)
}

/// Runs the chosen filters on millimetres; returns `None` if there are none.
pub(super) fn run_on_metres(
    filters: &mut Chain,
    depth: &ZDepth,
    rgb: Rgb<'_>,
    chosen: impl Fn(&Filter) -> bool,
    mut reasons: Option<&mut ReasonCodes>,
) -> Option<ZDepth> {
    if !filters.filters().iter().any(&chosen) {
        return None;
    }
    let millimetres = millimetres::from_metres(&depth.0);
    if let Some(reasons) = &mut reasons {
        let beyond = |place: usize| match depth.0.pixels().get(place) {
            Some(metres) if *metres > 1.0 => Reason::TooFar.code(),
            _ => Reason::TooNear.code(),
        };
        reasons.after(millimetres.pixels(), |value| value > 0, beyond);
    }
    let filtered = filters.run_some(millimetres, rgb, 1.0, chosen, reasons);
    Some(ZDepth(millimetres::to_metres(&filtered)))
}

/// Spreads disparities for the filters and returns the factor. The device's rounding is not published; here it is to the
/// nearest.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "disparities of 16 bits; saturates"
)]
pub(crate) fn spread(filters: &[Filter], max_px: u32, subpixel: Subpixel, disparity: &mut Image<u16>) -> f64 {
    let changes = |filter: &&Filter| !filter.is_of_depth() && !filter.needs_rgb();
    match filters.iter().rfind(changes) {
        None | Some(Filter::Median(_)) => 1.0,
        Some(_) => {
            let scale = FILTERED_RANGE / f64::from(max_px << subpixel.bits());
            for fixed in disparity.pixels_mut() {
                let spread = (f64::from(*fixed) * scale + 0.5) as u16;
                *fixed = spread.max(u16::from(*fixed > 0));
            }
            scale
        }
    }
}
