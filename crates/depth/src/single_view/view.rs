//! Numbers become pixels of a picture.

use super::OutputMode;
use super::plan::Plan;

/// Where nothing was measured.
pub(super) const BLACK: [u8; 4] = [0, 0, 0, 255];

/// 0 to 1, and what lies outside at the nearer end, as a byte.
#[inline(always)]
fn byte(value: f32) -> u8 {
    // Not a number is 0.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 to 255")]
    let byte = (value.clamp(0.0, 1.0) * 255.0 + 0.5) as u8;
    byte
}

fn grey(value: f32) -> [u8; 4] {
    let byte = byte(value);
    [byte, byte, byte, 255]
}

/// From red at 0 over yellow, green and cyan to blue at 1.
fn rainbow(place: f32) -> [u8; 4] {
    let hue = 4.0 * place.clamp(0.0, 1.0);
    [byte(2.0 - hue), byte(hue.min(4.0 - hue)), byte(hue - 2.0), 255]
}

/// 0 at `minDistance`, 1 at `maxDistance`; 0 where these are one.
fn place(plan: &Plan, z: f32) -> f32 {
    let [near, far] = plan.range;
    if far > near {
        (z - near) / (far - near)
    } else {
        0.0
    }
}

/// The picture of a depth in a mode that shows depths.
pub(super) fn depth(plan: &Plan, mode: OutputMode, z: f32) -> [u8; 4] {
    if !(z > 0.0 && z < f32::INFINITY) {
        return BLACK;
    }
    match mode {
        OutputMode::Sawtooth => grey(z - z.floor()),
        OutputMode::Rainbow => rainbow(place(plan, z)),
        _ => grey(place(plan, z)),
    }
}

/// The picture of a disparity.
pub(super) fn disparity(plan: &Plan, d: f32) -> [u8; 4] {
    grey(d / plan.max_disparity_px)
}

/// The picture of a confidence, 0 to 1, and a disparity.
pub(super) fn confidence(plan: &Plan, confidence: f32, d: f32) -> [u8; 4] {
    [byte(confidence), byte(d / plan.max_disparity_px), 0, 255]
}
