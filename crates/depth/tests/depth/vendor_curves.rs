//! The error curves that the vendor measured on one unit each, with the columns `distance_m` and `depth_error_percent`.

#![allow(
    clippy::print_stdout,
    clippy::expect_used,
    clippy::unwrap_used,
    reason = "a test"
)]

use oaktwin_depth::preset::Platform;
use std::fs;
use std::path::PathBuf;

use oaktwin_camera::StereoGeometry;
use oaktwin_depth::DepthShot;
use oaktwin_depth::random::Stream;
use oaktwin_depth::stereo_noise::{Parameters, StereoNoise};
use oaktwin_image::Image;

/// Returns the folder of the public test data.
fn test_data() -> PathBuf {
    std::env::var_os("OAKTWIN_TEST_DATA")
        .expect("OAKTWIN_TEST_DATA names the folder of the test data")
        .into()
}

/// Returns distances in metres with absolute errors in percent.
fn measured(file: &str) -> Vec<(f64, f64)> {
    let path = test_data().join("data/accuracy").join(file);
    let text = fs::read_to_string(&path).unwrap();
    let rows = text.lines().skip(1).map(|line| {
        let (distance, error) = line.split_once(',').unwrap();
        (distance.parse().unwrap(), error.parse().unwrap())
    });
    rows.collect()
}

/// As the vendor measures: a board at right angles, a region in the middle, its median, the mean of ten captures.
fn error_percent(sensor: &StereoNoise, distance_m: f64) -> f64 {
    #[expect(
        clippy::cast_possible_truncation,
        reason = "depth images are single precision"
    )]
    let board = Image::filled(sensor.parameters().width_px, 24, distance_m as f32);
    let width = board.width() as usize;
    let random = Stream::new(1, "left");
    let medians = (0..10).map(|frame| {
        let mut shot = DepthShot::new((&board).into());
        shot.frame = frame;
        let distance = sensor.sense(&shot, &random);
        let rows = distance.0.pixels().chunks_exact(width);
        let middle = rows.flat_map(|row| &row[width * 3 / 8..width * 5 / 8]);
        let mut valid: Vec<f32> = middle.copied().filter(|&z| z > 0.0).collect();
        valid.sort_by(f32::total_cmp);
        f64::from(valid[valid.len() / 2])
    });
    let found = medians.sum::<f64>() / 10.0;
    (found - distance_m).abs() / distance_m * 100.0
}

/// The coefficient of determination of a sensor's errors beyond a distance.
fn r_squared(sensor: &StereoNoise, measured: &[(f64, f64)], beyond_m: f64) -> f64 {
    let far = measured.iter().filter(|(distance, _)| *distance > beyond_m);
    let mean = far.clone().map(|(_, error)| error).sum::<f64>() / far.clone().count() as f64;
    let (mut unexplained, mut total) = (0.0, 0.0);
    for &(distance, error) in far {
        unexplained += (error - error_percent(sensor, distance)).powi(2);
        total += (error - mean).powi(2);
    }
    1.0 - unexplained / total
}

fn unit(focal_length_px: f64, width_px: u32, bias_px: f64, pixel_locking_px: f64) -> StereoNoise {
    let stereo = StereoGeometry {
        focal_length_px,
        baseline_m: 0.075,
    };
    let parameters = Parameters {
        bias_px,
        pixel_locking_px,
        ..Parameters::new(Platform::Rvc2, stereo, width_px)
    };
    StereoNoise::new(parameters).unwrap()
}

#[test]
#[ignore = "needs OAKTWIN_TEST_DATA"]
fn at_800p() {
    let measured = measured("depth_error_800p_75mm_measured.csv");
    let r2 = r_squared(&unit(794.0, 1280, -0.22, 0.13), &measured, 2.5);
    println!("800P beyond 2.5 m: R2 {r2:.4}");
    assert!(r2 >= 0.95, "{r2}");
}

#[test]
#[ignore = "needs OAKTWIN_TEST_DATA"]
fn at_480p() {
    let measured = measured("depth_error_480p_75mm_measured.csv");
    let r2 = r_squared(&unit(454.0, 640, 0.0, 0.2), &measured, 0.0);
    println!("480P: R2 {r2:.4}");
    assert!(r2 >= 0.85, "{r2}");
}
