//! Tests of the parameter sheet's OAK-D Pro on scenes with a closed-form result.

#![expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "small numbers of tests"
)]

mod effects;
mod outputs;
mod parameters;
mod same;

use oaktwin_image::Image;

use super::*;

fn oak_d_pro() -> Parameters {
    Parameters {
        baseline_mm: 75.0,
        focal_length_px: 805.0,
        max_disparity_px: 95.0,
        min_distance_m: 0.6,
        max_distance_m: 12.0,
        noise_mean_px: 0.25,
        noise_sigma_px: 0.2,
        noise_downscale_factor_px: 2.0,
        confidence_threshold: 0.8,
        outlier_removal_range_px: 3,
        ..Parameters::isaac_5_1()
    }
}

/// The OAK-D Pro without randomness.
fn quiet() -> Parameters {
    Parameters {
        noise_mean_px: 0.0,
        outlier_removal_range_px: 0,
        ..oak_d_pro()
    }
}

fn image<T>(width: u32, height: u32, value: impl Fn(u32, u32) -> T) -> Image<T> {
    let places = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    Image::new(width, height, places.map(|(x, y)| value(x, y)).collect()).unwrap()
}

fn sensor(parameters: Parameters) -> SingleView {
    SingleView::new(parameters, Assumptions::default()).unwrap()
}

fn distance(parameters: Parameters, depth: &Image<f32>, frame: u64) -> Image<f32> {
    let mut shot = DepthShot::new(depth.into());
    shot.frame = frame;
    sensor(parameters)
        .sense(&shot, &Stream::new(1, "left"), Wanted::default())
        .distance
        .0
}

/// A wall at 4 m with an object at `near` in front of it, in columns `from` to `to`.
fn step(width: u32, near: f32, from: u32, to: u32) -> Image<f32> {
    image(width, 40, |x, _| if (from..to).contains(&x) { near } else { 4.0 })
}
