#![expect(clippy::cast_possible_truncation, reason = "small numbers of tests")]

mod behaviour;
mod errors;
mod multipath;
mod returns;
mod same_bytes;
mod terms;

use oaktwin_image::{Image, ZDepth};

use super::{Parameters, TimeOfFlight};
use crate::fixture::{self, random, shot};

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

fn sense(parameters: Parameters, depth: &Image<f32>) -> ZDepth {
    sensor(parameters).sense(&shot(depth, 0), &random())
}

/// A wall that faces the camera.
fn wall(width: u32, height: u32, z: f64) -> Image<f32> {
    Image::filled(width, height, z as f32)
}

/// A room with things in it, slopes and holes: what a depth image of any size may hold.
fn room(width: u32, height: u32) -> Image<f32> {
    fixture::room(
        width,
        height,
        0.15,
        &[f32::NAN, f32::INFINITY, -1.0, 1e-39, 1e30, 20.0],
    )
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
