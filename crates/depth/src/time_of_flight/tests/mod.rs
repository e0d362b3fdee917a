#![expect(clippy::cast_possible_truncation, reason = "small numbers of tests")]

mod errors;
mod multipath;
mod same_bytes;
mod terms;

use oaktwin_image::{Image, ZDepth};

use super::{Parameters, TimeOfFlight};
use crate::Shot;
use crate::random::Stream;

/// No error but whole millimetres.
fn exact() -> Parameters {
    Parameters {
        wiggling: 0.0,
        wiggling_residual: 0.0,
        ambient_e: 0.0,
        read_noise_e: 0.0,
        signal_e: 1e6,
        full_well_e: 1e9,
        pixel_mixing: 0.0,
        min_amplitude_e: 0.0,
        ..Parameters::new(457.0, 640)
    }
}

fn sensor(parameters: Parameters) -> TimeOfFlight {
    TimeOfFlight::new(parameters).unwrap()
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

/// A wall that faces the camera.
fn wall(width: u32, height: u32, z: f64) -> Image<f32> {
    Image::filled(width, height, z as f32)
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
                    z = z.min(0.15 + 0.3 * k);
                }
            }
            pixels.push(match (x + 3 * y) % 97 {
                0 => f32::NAN,
                1 => f32::INFINITY,
                2 => -1.0,
                3 => 1e-39,
                4 => 1e30,
                5 => 20.0,
                _ => z as f32,
            });
        }
    }
    Image::new(width, height, pixels).unwrap()
}

/// Mean and standard deviation of what was measured, and how much was.
fn statistics(image: &ZDepth) -> (f64, f64, f64) {
    let all = image.0.pixels();
    let values: Vec<f64> = all.iter().filter(|&&z| z > 0.0).map(|&z| f64::from(z)).collect();
    let count = values.len() as f64;
    let mean = values.iter().sum::<f64>() / count;
    let variance = values.iter().map(|z| (z - mean) * (z - mean)).sum::<f64>() / count;
    (mean, variance.sqrt(), count / all.len() as f64)
}
