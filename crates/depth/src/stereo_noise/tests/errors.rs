use super::*;
use crate::preset::Platform;
use crate::stereo_noise::DEVICE_BIAS_SIGMA_PX;

/// A plane, seen by a camera of any image width, all of it within sight.
fn plane(width: u32, height: u32, z: f64) -> Image<f32> {
    Image::filled(width, height, z as f32)
}

/// Disparities, matcher px, of the pixels that were measured in a frame.
fn measured(p: Parameters, depth: &Image<f32>, frame: u64) -> Vec<f64> {
    let image = sensor(p).disparity(&shot(depth, frame), &random());
    let step = p.subpixel.step_px();
    image
        .pixels()
        .iter()
        .map(|&fixed| f64::from(fixed) * step)
        .collect()
}

fn mean_and_sigma(values: impl Iterator<Item = f64> + Clone) -> (f64, f64) {
    let count = values.clone().count() as f64;
    let mean = values.clone().sum::<f64>() / count;
    let variance = values.map(|value| (value - mean).powi(2)).sum::<f64>() / count;
    (mean, variance.sqrt())
}

#[test]
fn pixel_locking_repeats_with_every_pixel() {
    let p = Parameters {
        pixel_locking_px: 0.13,
        bias_px: -0.22,
        occlusion: false,
        ..exact()
    };
    for tenth in 10..600 {
        let d = f64::from(tenth) * 0.137;
        let found = f64::from(disparity(p, &plane(1, 1, 60.0 / d)).pixels()[0]) / 32.0;
        let biased = d - 0.22;
        let expected = biased - 0.13 * (std::f64::consts::TAU * biased).sin();
        assert!(
            (found - expected).abs() < 0.5 / 32.0 + 2e-5,
            "{d}: {found} {expected}"
        );
    }
}

#[test]
fn jitter_has_its_sigma_and_is_shared_over_the_window() {
    for (width, window, sigma) in [
        (1280, 7, 0.4),
        (640, 7, 0.4),
        (320, 7, 0.4),
        (1280, 1, 0.3),
        (1280, 15, 0.5),
    ] {
        let p = Parameters {
            jitter_px: sigma,
            window_px: window,
            occlusion: false,
            ..exact()
        };
        // On a whole pixel of disparity; the steps add their own variance.
        let depth = plane(width, 200, 2.0);
        let frames: Vec<Vec<f64>> = (0..4).map(|frame| measured(p, &depth, frame)).collect();
        let all = frames.iter().flatten().copied();
        let (mean, found) = mean_and_sigma(all.clone());
        let side = (f64::from(window) * f64::from(width) / 1280.0).round().max(1.0);
        // What is independent: windows.
        let independent = all.count() as f64 / (side * side);
        let steps = (1.0 / 32f64).powi(2) / 12.0;
        let expected = (sigma * sigma + steps).sqrt();
        assert!(
            (mean - 30.0).abs() < 5.0 * sigma / independent.sqrt(),
            "{width} {window}: {mean}"
        );
        let tolerance = 5.0 / (2.0 * independent).sqrt();
        assert!(
            (found / expected - 1.0).abs() < tolerance,
            "{width} {window}: {found}"
        );

        // Over time too: the same pixels of two frames have nothing in common.
        let together = |a: &[f64], b: &[f64]| {
            let pairs = a.iter().zip(b);
            pairs.clone().map(|(a, b)| (a - mean) * (b - mean)).sum::<f64>() / pairs.count() as f64
        };
        let over_time = together(&frames[0], &frames[1]) / (sigma * sigma);
        assert!(over_time.abs() < 10.0 / independent.sqrt(), "{over_time}");

        // Neighbours share what windows share: a triangle of their distance.
        let image = &frames[2];
        for distance in 1..=20usize {
            let wide = width as usize;
            let along: f64 = image
                .chunks_exact(wide)
                .map(|row| together(&row[distance..], row))
                .sum::<f64>()
                / 200.0;
            let across = together(&image[distance * wide..], image);
            let expected = (1.0 - distance as f64 / side).max(0.0);
            for found in [along, across] {
                let found = found / (sigma * sigma);
                assert!(
                    (found - expected).abs() < 12.0 / independent.sqrt(),
                    "{window} {distance}: {found}"
                );
            }
        }
    }
}

#[test]
fn jitter_is_normal() {
    for window in [1, 3, 7] {
        let p = Parameters {
            jitter_px: 1.0,
            window_px: window,
            occlusion: false,
            ..exact()
        };
        let depth = plane(1280, 400, 2.0);
        let values = measured(p, &depth, 3);
        for (beyond, expected) in [
            (0.5, 0.308_538),
            (1.0, 0.158_655),
            (2.0, 0.022_750),
            (3.0, 0.001_350),
        ] {
            let count = values.len() as f64 / f64::from(window * window);
            for side in [-1.0, 1.0] {
                // Halves of a step are counted as a half.
                let found = values
                    .iter()
                    .map(|value| {
                        let over = side * (value - 30.0) - beyond;
                        if over == 0.0 {
                            0.5
                        } else {
                            f64::from(u8::from(over > 0.0))
                        }
                    })
                    .sum::<f64>()
                    / values.len() as f64;
                let tolerance = 5.0 * (expected / count).sqrt() + 0.01 * expected;
                assert!((found - expected).abs() < tolerance, "{window} {beyond}: {found}");
            }
        }
    }
}

#[test]
fn an_image_of_any_width_has_the_same_error() {
    let p = Parameters {
        jitter_px: 0.2,
        bias_px: -0.22,
        pixel_locking_px: 0.13,
        occlusion: false,
        ..Parameters::new(Platform::Rvc2, STEREO, 1280)
    };
    let z = 3.3;
    let statistics = |width, height| {
        let frames = (0..20)
            .flat_map(|frame| measured(p, &plane(width, height, z), frame))
            .collect::<Vec<_>>();
        mean_and_sigma(frames.into_iter())
    };
    let (mean, sigma) = statistics(1280, 200);
    for (width, height) in [(106, 60), (320, 200), (640, 100), (1920, 100)] {
        let (other_mean, other_sigma) = statistics(width, height);
        assert!((other_mean - mean).abs() < 0.01, "{width}: {other_mean} {mean}");
        assert!(
            (other_sigma / sigma - 1.0).abs() < 0.03,
            "{width}: {other_sigma} {sigma}"
        );
    }
}

#[test]
fn a_device_has_one_bias_and_devices_spread() {
    let bias = |seed| {
        Parameters::new(Platform::Rvc2, STEREO, 1280)
            .of_device(seed)
            .bias_px
    };
    assert_eq!(bias(5), bias(5));
    let (mean, sigma) = mean_and_sigma((0..4000).map(bias));
    assert!(mean.abs() < 5.0 * DEVICE_BIAS_SIGMA_PX / 4000f64.sqrt(), "{mean}");
    assert!((sigma / DEVICE_BIAS_SIGMA_PX - 1.0).abs() < 0.06, "{sigma}");
}

#[test]
fn a_fraction_of_the_pixels_drops_out() {
    let depth = plane(1280, 100, 3.0);
    for dropout in [0.0, 0.01, 0.3, 1.0] {
        let p = Parameters {
            dropout,
            occlusion: false,
            ..exact()
        };
        let lost = |frame| {
            let image = sensor(p).sense(&shot(&depth, frame), &random());
            image.0.pixels().iter().map(|&z| z == 0.0).collect::<Vec<_>>()
        };
        let (first, second) = (lost(0), lost(1));
        let fraction = first.iter().filter(|&&lost| lost).count() as f64 / 128_000.0;
        let tolerance = 5.0 * (dropout * (1.0 - dropout) / 128_000.0).sqrt();
        assert!((fraction - dropout).abs() <= tolerance, "{fraction}");
        let both = first.iter().zip(&second).filter(|&(a, b)| *a && *b).count() as f64 / 128_000.0;
        assert!((both - dropout * dropout).abs() <= tolerance, "{both}");
    }
}
