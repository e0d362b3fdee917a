#![expect(clippy::cast_possible_truncation, reason = "small numbers of tests")]

mod dots;
mod errors;
mod geometry;
mod parameters;
mod same_bytes;

use crate::preset::Platform;
use oaktwin_camera::StereoGeometry;
use oaktwin_image::{Image, ZDepth};

use super::{Parameters, StereoNoise};
use crate::fixture::{self, random, shot};

const STEREO: StereoGeometry = StereoGeometry {
    focal_length_px: 800.0,
    baseline_m: 0.075,
};

/// No error but the steps of disparity.
fn exact() -> Parameters {
    Parameters {
        pixel_locking_px: 0.0,
        jitter_px: 0.0,
        ..Parameters::new(Platform::Rvc2, STEREO, 1280)
    }
}

fn sensor(parameters: Parameters) -> StereoNoise {
    StereoNoise::new(parameters).unwrap()
}

fn sense(parameters: Parameters, depth: &Image<f32>) -> ZDepth {
    sensor(parameters).sense(&shot(depth, 0), &random())
}

fn disparity(parameters: Parameters, depth: &Image<f32>) -> Image<u16> {
    sensor(parameters).disparity(&shot(depth, 0), &random())
}

/// A room with things in it, slopes and holes: what a depth image of any size may hold.
fn room(width: u32, height: u32) -> Image<f32> {
    fixture::room(width, height, 0.5, &[f32::NAN, f32::INFINITY, -1.0])
}
