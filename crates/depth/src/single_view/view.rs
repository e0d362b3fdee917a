//! Visualizations of depth, disparity and confidence.

use super::OutputMode;
use super::plan::SingleViewPlan;

/// The colour of pixels without measurement.
pub(super) const BLACK: [u8; 4] = [0, 0, 0, 255];

/// Converts a value of 0 to 1 to a byte; values outside are clamped.
#[inline(always)]
fn byte(value: f32) -> u8 {
    // NaN becomes 0.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 to 255")]
    let byte = (value.clamp(0.0, 1.0) * 255.0 + 0.5) as u8;
    byte
}

fn grey(value: f32) -> [u8; 4] {
    let byte = byte(value);
    [byte, byte, byte, 255]
}

/// Returns a colour from red at 0 through yellow, green and cyan to blue at 1.
fn rainbow(place: f32) -> [u8; 4] {
    let hue = 4.0 * place.clamp(0.0, 1.0);
    [byte(2.0 - hue), byte(hue.min(4.0 - hue)), byte(hue - 2.0), 255]
}

/// Maps `minDistance` to 0 and `maxDistance` to 1; returns 0 if they are equal.
fn place(plan: &SingleViewPlan, z: f32) -> f32 {
    let [near, far] = plan.range;
    if far > near {
        (z - near) / (far - near)
    } else {
        0.0
    }
}

/// Returns the colour of a depth in a mode that shows depth.
pub(super) fn depth(plan: &SingleViewPlan, mode: OutputMode, z: f32) -> [u8; 4] {
    if !(z > 0.0 && z < f32::INFINITY) {
        return BLACK;
    }
    match mode {
        OutputMode::Sawtooth => grey(z - z.floor()),
        OutputMode::Rainbow => rainbow(place(plan, z)),
        _ => grey(place(plan, z)),
    }
}

/// Returns the colour of a disparity.
pub(super) fn disparity(plan: &SingleViewPlan, d: f32) -> [u8; 4] {
    grey(d / plan.max_disparity_px)
}

/// Returns the colour of a confidence of 0 to 1 and a disparity.
pub(super) fn confidence(plan: &SingleViewPlan, confidence: f32, d: f32) -> [u8; 4] {
    [byte(confidence), byte(d / plan.max_disparity_px), 0, 255]
}
