#![expect(clippy::cast_possible_truncation, reason = "small numbers of tests")]

mod errors;
mod geometry;
mod same_bytes;

use oaktwin_camera::StereoGeometry;
use oaktwin_image::{Image, ZDepth};

use super::{Parameters, StereoNoise};
use crate::Shot;
use crate::random::Stream;

const STEREO: StereoGeometry = StereoGeometry {
    focal_length_px: 800.0,
    baseline_m: 0.075,
};

/// No error but the steps of disparity.
fn exact() -> Parameters {
    Parameters {
        pixel_locking_px: 0.0,
        jitter_px: 0.0,
        ..Parameters::new(STEREO, 1280)
    }
}

fn sensor(parameters: Parameters) -> StereoNoise {
    StereoNoise::new(parameters).unwrap()
}

fn random() -> Stream {
    Stream::new(7, "camera")
}

/// A shot of `depth`, number `frame`.
fn shot(depth: &Image<f32>, frame: u64) -> Shot<'_> {
    let mut shot = Shot::new(depth.into());
    shot.frame = frame;
    shot
}

fn sense(parameters: Parameters, depth: &Image<f32>) -> ZDepth {
    sensor(parameters).sense(&shot(depth, 0), &random())
}

fn disparity(parameters: Parameters, depth: &Image<f32>) -> Image<u16> {
    sensor(parameters).disparity(&shot(depth, 0), &random())
}

/// A room with things in it, slopes and holes: what a depth image of any size may hold.
fn room(width: u32, height: u32) -> Image<f32> {
    let mut pixels = Vec::new();
    for y in 0..height {
        for x in 0..width {
            let (u, v) = (f64::from(x) / f64::from(width), f64::from(y) / f64::from(height));
            let mut z = 4.0 + u;
            if v > 0.6 {
                z = z.min(0.9 / (v - 0.5));
            }
            for k in 0..12 {
                let k = f64::from(k);
                let (at, up) = ((k * 0.37 + 0.1).fract(), (k * 0.61 + 0.2).fract());
                if (u - at).abs() < 0.03 + 0.01 * (k % 5.0) && (v - up).abs() < 0.08 {
                    z = z.min(0.5 + 0.3 * k);
                }
            }
            pixels.push(match (x + 3 * y) % 97 {
                0 => f32::NAN,
                1 => f32::INFINITY,
                2 => -1.0,
                _ => z as f32,
            });
        }
    }
    Image::new(width, height, pixels).unwrap()
}
