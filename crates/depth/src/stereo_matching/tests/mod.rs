#![expect(
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss,
    clippy::cast_sign_loss,
    reason = "small numbers of tests"
)]

mod effects;
mod findings;
mod names;
mod rvc4;
mod same_bytes;

use oaktwin_camera::StereoGeometry;
use oaktwin_image::{Image, ImageView};

use super::{Parameters, RectifiedPair};
use crate::preset::Platform;

const STEREO: StereoGeometry = StereoGeometry {
    focal_length_px: 800.0,
    baseline_m: 0.075,
};

fn parameters() -> Parameters {
    Parameters::new(Platform::Rvc2, STEREO, 1280)
}

/// The parameters with some of them changed.
fn changed(settings: &[(&str, &str)]) -> Parameters {
    let mut p = parameters();
    for (name, value) in settings {
        p.set(name, *value).unwrap();
    }
    p
}

/// The grey level of a texture between its pixels, seen by an imager with pixels as wide as the texture's.
fn texture(seed: u64, x: f64, y: u64) -> f64 {
    let level = |x: i64| {
        let mut bits = (x.cast_unsigned() ^ (y << 32) ^ (seed << 52)).wrapping_mul(0x9E37_79B9_7F4A_7C15);
        bits ^= bits >> 29;
        bits = bits.wrapping_mul(0xBF58_476D_1CE4_E5B9);
        ((bits >> 40) & 255) as f64
    };
    let (from, part) = (x.floor(), x - x.floor());
    let at = from as i64;
    0.5 * ((level(at - 1) + level(at)) * (1.0 - part) + (level(at) + level(at + 1)) * part)
}

/// An image for which `texture_at` returns a texture and the position in it.
fn image(width: u32, height: u32, texture_at: impl Fn(f64, f64) -> (u64, f64)) -> Image<u8> {
    let pixels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    let pixels = pixels.map(|(x, y)| {
        let (seed, at) = texture_at(f64::from(x), f64::from(y));
        texture(seed, at, u64::from(y)).round() as u8
    });
    Image::new(width, height, pixels.collect()).unwrap()
}

/// A wall of disparity `far`, and in front of it a box of disparity `near` that covers the columns `left..right`.
fn step(width: u32, height: u32, far: f64, near: f64, left: f64, right: f64) -> [Image<u8>; 2] {
    let inside = move |x: f64| x >= left && x < right;
    [
        image(width, height, |x, _| if inside(x) { (1, x) } else { (0, x) }),
        image(width, height, |x, _| {
            if inside(x + near) {
                (1, x + near)
            } else {
                (0, x + far)
            }
        }),
    ]
}

fn pair(images: &[Image<u8>; 2]) -> RectifiedPair<'_> {
    let [left, right] = images.each_ref().map(ImageView::from);
    RectifiedPair::new(left, right).unwrap()
}
