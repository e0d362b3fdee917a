use super::{changed, image, pair, step};
use crate::stereo_matching::StereoMatching;

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// The occluded band is to the left of a near object and as wide as the difference of disparities, b·f·(1/z₁ − 1/z₂).
#[test]
fn invalidates_occluded_pixels() {
    let (far, near, left, right) = (12.0, 40.0, 180.0, 280.0);
    let images = step(400, 60, far, near, left, right);
    let engine = StereoMatching::new(changed(&[("leftRightCheckThreshold", "1")])).unwrap();
    let disparity = engine.disparity(&pair(&images)).disparity;
    let rows = || disparity.pixels().chunks(400).skip(8).take(44);
    let lost = |columns: std::ops::Range<usize>| {
        let all: Vec<u16> = rows().flat_map(|row| row[columns.clone()].to_vec()).collect();
        all.iter().filter(|&&d| d == 0).count() as f64 / all.len() as f64
    };
    let band = (near - far) as usize;
    let inside = lost(180 - band + 3..180 - 3);
    assert!(inside > 0.9, "{inside} of the band is lost");
    assert!(lost(60..180 - band - 4) < 0.02);
    assert!(lost(184..276) < 0.02);
    // There is no occlusion on the other side.
    assert!(lost(284..390) < 0.02);
    // The band at the left border is outside the right image.
    assert!(lost(0..10) > 0.9);
    let widths = rows().map(|row| row[100..184].iter().filter(|&&d| d == 0).count() as f64);
    let width = median(widths.collect());
    println!("the band is {width} px wide, {band} by geometry");
    assert!((width - band as f64).abs() <= 2.0, "{width}");
    let found = |columns: std::ops::Range<usize>| {
        let all = rows().flat_map(|row| row[columns.clone()].to_vec());
        median(all.map(|d| f64::from(d) / 32.0).collect())
    };
    assert!((found(60..140) - far).abs() < 0.1 && (found(190..270) - near).abs() < 0.1);
}

/// Pixel locking, the bias towards whole disparities, results from the matcher alone.
#[test]
fn reproduces_pixel_locking() {
    for interpolation in ["PARABOLA_5", "PARABOLA", "LINES"] {
        let settings = [("subpixelInterpolation", interpolation)];
        let engine = StereoMatching::new(changed(&settings)).unwrap();
        let steps = 16;
        let errors: Vec<f64> = (0..2 * steps)
            .map(|k| {
                let d = 9.0 + f64::from(k) / f64::from(steps);
                let images = [image(700, 40, |x, _| (0, x)), image(700, 40, |x, _| (0, x + d))];
                let disparity = engine.disparity(&pair(&images)).disparity;
                let rows = disparity.pixels().chunks(700).skip(8).take(24);
                let found = rows.flat_map(|row| &row[120..660]).filter(|&&d| d > 0);
                let found: Vec<f64> = found.map(|&d| f64::from(d) / 32.0).collect();
                assert!(found.len() > 12_000);
                found.iter().sum::<f64>() / found.len() as f64 - d
            })
            .collect();
        // The amplitude of the component with a period of one pixel.
        let wave = |quarter: f64| {
            let parts = errors.iter().enumerate().map(|(k, error)| {
                let turn = std::f64::consts::TAU * (k as f64 / f64::from(steps) + quarter);
                error * turn.sin()
            });
            2.0 * parts.sum::<f64>() / errors.len() as f64
        };
        let (sine, cosine) = (wave(0.0), wave(0.25));
        let mean = errors.iter().sum::<f64>() / errors.len() as f64;
        println!("{interpolation}: error {mean:+.3} px, {sine:+.3} sin 2πd {cosine:+.3} cos 2πd");
        // The error is the same in both periods.
        for (first, second) in errors.iter().zip(&errors[steps as usize..]) {
            assert!((first - second).abs() < 0.03, "{first} {second}");
        }
        assert!(mean.abs() < 0.04 && cosine.abs() < 0.03);
        if interpolation != "LINES" {
            assert!(sine < -0.03, "{sine}: toward whole disparities");
        }
    }
}

#[test]
fn invalidates_a_blank_wall() {
    let images = [image(300, 40, |_, _| (0, 5.0)), image(300, 40, |_, _| (0, 5.0))];
    let engine = StereoMatching::new(changed(&[])).unwrap();
    let matched = engine.disparity(&pair(&images));
    let kept = matched.disparity.pixels().iter().filter(|&&d| d > 0).count();
    assert_eq!(kept, 0);
}

#[test]
fn extended_disparity_doubles_the_search_range() {
    let images = step(600, 80, 20.0, 150.0, 300.0, 500.0);
    let found = |extended| {
        let p = changed(&[("extendedDisparity", extended), ("leftRightCheckThreshold", "2")]);
        let disparity = StereoMatching::new(p)
            .unwrap()
            .disparity(&pair(&images))
            .disparity;
        let rows = disparity.pixels().chunks(600).skip(10).take(60);
        let near: Vec<f64> = rows
            .flat_map(|row| row[320..480].to_vec())
            .map(|d| f64::from(d) / 32.0)
            .collect();
        near.iter().filter(|&&d| (d - 150.0).abs() < 1.0).count() as f64 / near.len() as f64
    };
    assert!(found("true") > 0.95);
    assert_eq!(found("false"), 0.0);
}

#[test]
fn depth_is_focal_length_times_baseline_over_disparity() {
    let images = [
        image(500, 40, |x, _| (0, x)),
        image(500, 40, |x, _| (0, x + 24.0)),
    ];
    let mut p = changed(&[("disparityShift", "10")]);
    p.width_px = 500;
    let engine = StereoMatching::new(p).unwrap();
    let depth = engine.sense(&pair(&images)).0;
    assert!((depth.pixels()[20 * 500 + 250] - 2.5).abs() < 0.01);
    // A pair at twice the width that the focal length is for.
    p.width_px = 250;
    p.stereo.focal_length_px = 400.0;
    let engine = StereoMatching::new(p).unwrap();
    assert_eq!(engine.sense(&pair(&images)).0, depth);
}
