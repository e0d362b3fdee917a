//! Why pixels have no disparity.

use oaktwin_image::Image;
use oaktwin_simd::Level;

use super::{Matched, Parameters, Passed, RectifiedPair, StereoMatching};
use crate::preset::Platform;
use crate::reason::{Reason, ReasonCodes};

impl StereoMatching {
    /// Returns the disparity and the confidence of a pair, and why pixels have no disparity.
    pub(crate) fn explained(&self, pair: &RectifiedPair<'_>) -> (Matched, ReasonCodes) {
        let Passed { matched, lost } = self.disparity_at(Level::detect(), pair, true);
        let (width, height) = (matched.disparity.width(), matched.disparity.height());
        let codes = Image::new(width, height, lost).unwrap_or_else(|| Image::filled(width, height, 0));
        let mut reasons = ReasonCodes(codes);
        let left = pair.left();
        let (levels, brightest) = (left.levels(), (1i16 << left.bits()) - 1);
        let code = |place: usize| {
            let is_bright = levels.get(place).is_some_and(|level| *level >= brightest);
            let confidence = matched.confidence.pixels().get(place).copied();
            unreliable(self.parameters(), confidence.unwrap_or_default(), is_bright).code()
        };
        reasons.after(matched.disparity.pixels(), |disparity| disparity > 0, code);
        (matched, reasons)
    }
}

/// Returns why a match at a valid position is not used.
fn unreliable(p: &Parameters, confidence: u8, is_bright: bool) -> Reason {
    let holes = &p.hole_filling;
    let fills = p.platform == Platform::Rvc4 && holes.enable && holes.invalidate_disparities;
    if confidence < p.confidence_threshold {
        if is_bright {
            Reason::Saturated
        } else {
            Reason::NoTexture
        }
    } else if fills && confidence < holes.fill_confidence_threshold {
        Reason::HoleFilling
    } else {
        // The disparity is rounded to 0.
        Reason::TooFar
    }
}
