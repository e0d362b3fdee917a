use std::f64::consts::TAU;

use oaktwin_image::Image;

use super::StereoNoise;
use crate::Shot;
use crate::random::{Stage, Stream, standard_normal};

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "fixed-point disparities"
)]
pub(super) fn disparity(sensor: &StereoNoise, shot: &Shot<'_>, random: &Stream) -> Image<u16> {
    let (p, depth) = (sensor.parameters(), shot.depth());
    let (width, height) = (depth.width(), depth.height());
    let jitter = random.plane(Stage::Jitter, shot.frame, shot.item);
    let image_px = f64::from(width) / f64::from(p.width_px);
    let step = p.subpixel.step_px();
    let shift = f64::from(p.disparity_shift_px);
    let mut out = Image::filled(width, height, 0u16);
    for (y, row) in depth.rows().enumerate() {
        // Where the nearest of all to the right lies in the right image.
        let mut taken = f64::INFINITY;
        for (x, &z) in row.iter().enumerate().rev() {
            let z = f64::from(z);
            if !(z > 0.0 && z.is_finite()) {
                continue;
            }
            let d = p.stereo.disparity(z);
            let right = x as f64 - d * image_px;
            let is_hidden = right >= taken;
            taken = taken.min(right);
            if is_hidden || right < 0.0 {
                continue;
            }
            let biased = d + p.bias_px;
            let [a, b, ..] = jitter.words(x as u32, y as u32);
            let noisy =
                biased - p.pixel_locking_px * (TAU * biased).sin() + p.jitter_px * standard_normal(a, b)[0];
            let fixed = ((noisy - shift) / step).round();
            if fixed >= 1.0 && noisy <= f64::from(p.max_disparity_px()) {
                out.pixels_mut()[y * width as usize + x] = fixed as u16;
            }
        }
    }
    out
}
