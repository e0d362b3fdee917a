//! Each term against its closed form.

use std::f64::consts::TAU;

use proptest::prelude::*;

use super::*;
use crate::time_of_flight::unwrap::turn_m;

/// Millimetres and a half, m: rounding, and what single precision leaves.
const HALF_MM: f64 = 0.000_502;

/// A distance along each ray of a sensor that reports just that.
pub(super) fn along_rays(p: Parameters, width: u32, height: u32, range: f64) -> Image<f32> {
    let mut depth = wall(width, height, 0.0);
    let scale = f64::from(p.width_px) / f64::from(width) / p.focal_length_px;
    for (i, z) in depth.pixels_mut().iter_mut().enumerate() {
        let (x, y) = (i % width as usize, i / width as usize);
        let u = (x as f64 + 0.5 - f64::from(width) / 2.0) * scale;
        let v = (y as f64 + 0.5 - f64::from(height) / 2.0) * scale;
        *z = (range / (1.0 + u * u + v * v).sqrt()) as f32;
    }
    depth
}

/// The corners of a wall are farther away, and as deep.
#[test]
fn distance_becomes_depth() {
    for (width, height) in [(640, 480), (106, 80)] {
        let depth = wall(width, height, 3.217);
        let found = sense(exact(), &depth);
        assert!(
            found.0.pixels().iter().all(|z| (z - 3.217).abs() < 0.01),
            "{width}"
        );
        assert!((statistics(&found).0 - 3.217).abs() < 0.000_2);
        let radial = Parameters {
            enable_optical_correction: false,
            ..exact()
        };
        let found = sense(radial, &depth);
        let (u, v) = (
            (f64::from(width) / 2.0 - 0.5) * 640.0 / f64::from(width) / 457.0,
            (f64::from(height) / 2.0 - 0.5) * 640.0 / f64::from(width) / 457.0,
        );
        let corner = 3.217 * (1.0 + u * u + v * v).sqrt();
        assert!((f64::from(found.0.pixels()[0]) - corner).abs() < 0.01);
    }
}

#[test]
fn the_principal_point_is_where_it_is_said() {
    let p = Parameters {
        enable_optical_correction: false,
        principal_point_px: Some([0.5, 0.5]),
        ..exact()
    };
    let found = sense(p, &wall(640, 480, 2.0));
    assert_eq!(found.0.pixels()[0], 2.0);
    let last = f64::from(*found.0.pixels().last().unwrap());
    let (u, v) = (639.0 / 457.0, 479.0 / 457.0);
    assert!((last - 2.0 * f64::sqrt(1.0 + u * u + v * v)).abs() < 0.002);
}

/// Beyond the range of both frequencies, distances repeat; with one alone, after its own c / 2f.
#[test]
fn what_is_too_far_wraps() {
    for (level, period) in [(4, 4.0 * turn_m(80.0)), (0, turn_m(80.0))] {
        let p = Parameters {
            phase_unwrapping_level: level,
            enable_optical_correction: false,
            ..exact()
        };
        for near in [0.4, 0.9, 1.7] {
            let found = sense(p, &along_rays(p, 40, 30, near + period));
            let (mean, _, fill) = statistics(&found);
            assert!(
                (mean - near).abs() < 0.002 && fill == 1.0,
                "{level}: {near} {mean}"
            );
        }
    }
}

/// Between its range and the frequencies' own, a level finds nothing that fits: 0.375 m apart at least.
#[test]
fn what_is_out_of_a_levels_range_is_lost_or_wrong_by_periods() {
    let p = Parameters {
        phase_unwrapping_level: 1,
        enable_optical_correction: false,
        ..exact()
    };
    let depth = along_rays(p, 20, 10, 3.3);
    assert!(sense(p, &depth).0.pixels().iter().all(|&z| z == 0.0));
    let lenient = Parameters {
        phase_unwrap_error_threshold: 400,
        ..p
    };
    let found = sense(lenient, &depth);
    // One period of the higher frequency too few of each.
    let weight = 0.64 / 1.64;
    let wrong = 3.3 - weight * turn_m(80.0) - (1.0 - weight) * turn_m(100.0);
    assert!((statistics(&found).0 - wrong).abs() < 0.002);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    /// Within its range each level finds any distance, at any frequencies.
    #[test]
    fn distances_are_found(
        part in 0.01..0.98f64,
        level in 0u32..=5,
        low in 30.0..120.0f64,
        apart in prop_oneof![Just(1.15), Just(1.3), Just(1.7), Just(2.3)],
        standard: bool,
    ) {
        let frequencies_mhz = if standard { [80.0, 100.0] } else { [low, low * apart] };
        let p = Parameters {
            frequencies_mhz,
            phase_unwrapping_level: level,
            phase_unwrap_error_threshold: 1000,
            enable_optical_correction: false,
            ..exact()
        };
        let range = (part * sensor(p).range_m()).min(8.0);
        // Where a phase is 0 the least noise finds it at a whole turn.
        let turns = frequencies_mhz.map(|f| (range / turn_m(f)).fract());
        prop_assume!(turns.iter().all(|turn| (0.01..0.99).contains(turn)) && range > 0.05);
        let found = sense(p, &along_rays(p, 9, 7, range));
        let (mean, _, fill) = statistics(&found);
        // Of the lower frequency's noise.
        let sigma = turn_m(frequencies_mhz[0]) / TAU * 0.000_9 * range;
        prop_assert!((mean - range).abs() < sigma + HALF_MM && fill == 1.0, "{range} {mean} {fill}");
    }
}

/// The noise of the distance is c / 4πf times the noise of the phase, which is a part of the phasor's noise over the amplitude.
#[test]
fn noise_is_that_of_the_amplitude() {
    let noisy = |signal_e, ambient_e, read_noise_e, z: f64| {
        let p = Parameters {
            signal_e,
            ambient_e,
            read_noise_e,
            phase_unwrapping_level: 0,
            enable_phase_shuffle_temporal_filter: false,
            enable_optical_correction: false,
            ..exact()
        };
        // Surfaces that face the camera: the middle of a long lens's image.
        let p = Parameters {
            focal_length_px: 1e5,
            ..p
        };
        let found = sense(p, &wall(160, 120, z));
        let (_, sigma, _) = statistics(&found);
        let light = signal_e * 0.5 / (z * z);
        let variance = (light + 0.5 * ambient_e + read_noise_e * read_noise_e) / 2.0;
        let phase = variance.sqrt() / (0.8 * light);
        let expected = turn_m(80.0) / TAU * phase;
        assert!((sigma / expected - 1.0).abs() < 0.03, "{z}: {sigma} {expected}");
        sigma
    };
    // Of the light itself it grows as the distance.
    let growth = noisy(3000.0, 0.0, 0.0, 1.6) / noisy(3000.0, 0.0, 0.0, 0.8);
    assert!((growth - 2.0).abs() < 0.1, "{growth}");
    // Of other light and of reading, as its square.
    let growth = noisy(2000.0, 40_000.0, 0.0, 1.2) / noisy(2000.0, 40_000.0, 0.0, 0.6);
    assert!((3.5..4.1).contains(&growth), "{growth}");
    let growth = noisy(2000.0, 0.0, 100.0, 1.2) / noisy(2000.0, 0.0, 100.0, 0.6);
    assert!((3.5..4.1).contains(&growth), "{growth}");
}

/// Twice measured has 1/√2 of the noise; half of it is the next frame's unless in burst mode.
#[test]
fn measurements_are_shared_by_frames() {
    let depth = wall(160, 120, 1.0);
    let errors = |shuffle, burst, frame| -> Vec<f64> {
        let p = Parameters {
            signal_e: 1000.0,
            enable_phase_shuffle_temporal_filter: shuffle,
            enable_burst_mode: burst,
            ..exact()
        };
        let found = sensor(p).sense(&shot(&depth, frame), &random());
        found.0.pixels().iter().map(|&z| f64::from(z) - 1.0).collect()
    };
    let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>() / a.len() as f64;
    let once = errors(false, false, 4);
    for burst in [false, true] {
        let (now, next, later) = (
            errors(true, burst, 4),
            errors(true, burst, 5),
            errors(true, burst, 6),
        );
        let variance = product(&now, &now);
        assert!((variance / product(&once, &once) - 0.5).abs() < 0.03);
        let shared = if burst { 0.0 } else { 0.5 };
        assert!((product(&now, &next) / variance - shared).abs() < 0.04);
        assert!((product(&now, &later) / variance).abs() < 0.04);
    }
}

/// −atan(w·sin 4φ), four times a period; corrected, the residual's.
#[test]
fn wiggling_has_four_periods() {
    let p = Parameters {
        wiggling: 0.071,
        wiggling_residual: 0.004,
        enable_wiggle_correction: false,
        phase_unwrapping_level: 0,
        enable_optical_correction: false,
        ..exact()
    };
    let corrected = Parameters {
        enable_wiggle_correction: true,
        ..p
    };
    for (p, w) in [(p, 0.071), (corrected, 0.004)] {
        let mut largest = 0f64;
        for i in 1..60 {
            let range = f64::from(i) / 60.0 * turn_m(80.0);
            let (mean, _, _) = statistics(&sense(p, &along_rays(p, 48, 32, range)));
            let phase = TAU * f64::from(i) / 60.0;
            let expected = -(w * (4.0 * phase).sin()).atan() * turn_m(80.0) / TAU;
            largest = largest.max(expected.abs());
            assert!(
                (mean - range - expected).abs() < 0.000_6,
                "{range}: {} {expected}",
                mean - range
            );
        }
        assert!((largest / (f64::atan(w) * turn_m(80.0) / TAU) - 1.0).abs() < 0.01);
    }
}

/// What an edge's pixels see: the sum of two phasors.
#[test]
fn flying_pixels_are_between() {
    let (near, far, weight) = (0.6, 0.9, 0.2);
    let p = Parameters {
        pixel_mixing: weight,
        phase_unwrapping_level: 0,
        focal_length_px: 1e5,
        ..exact()
    };
    let mut depth = wall(64, 48, far);
    for row in depth.pixels_mut().chunks_exact_mut(64) {
        row[32..].fill(near as f32);
    }
    let found = sense(p, &depth);
    // Amplitude and phase of both.
    let phasor = |z: f64, weight: f64| {
        let (amplitude, phase) = (weight / (z * z), TAU * z / turn_m(80.0));
        [amplitude * phase.cos(), amplitude * phase.sin()]
    };
    let between = |a: [f64; 2], b: [f64; 2]| (a[1] + b[1]).atan2(a[0] + b[0]) * turn_m(80.0) / TAU;
    let of_far = between(phasor(far, 1.0 - weight), phasor(near, weight));
    let of_near = between(phasor(far, weight), phasor(near, 1.0 - weight));
    assert!(near < of_near && of_near < of_far && of_far < far);
    let column = |x: usize| {
        found
            .0
            .pixels()
            .chunks_exact(64)
            .map(|row| f64::from(row[x]))
            .sum::<f64>()
            / 48.0
    };
    for (x, expected) in [(30, far), (31, of_far), (32, of_near), (33, near)] {
        assert!(
            (column(x) - expected).abs() < 0.000_6,
            "{x}: {} {expected}",
            column(x)
        );
    }
}

/// Of noise that finds the next pair of periods, 0.375 m apart, the mean is so many periods off.
#[test]
fn noise_finds_wrong_periods() {
    let p = Parameters {
        signal_e: 120.0,
        read_noise_e: 3.0,
        focal_length_px: 1e5,
        ..exact()
    };
    let found = sense(p, &wall(320, 240, 3.0));
    let values = found.0.pixels();
    // One turn of each; the weighted mean of c / 2f.
    let weight = 0.64 / 1.64;
    let jump = weight * turn_m(80.0) + (1.0 - weight) * turn_m(100.0);
    let near = |z: f64| {
        values
            .iter()
            .filter(|&&v| (f64::from(v) - z).abs() < 0.15)
            .count()
    };
    let wrong = near(3.0 - jump) + near(3.0 + jump);
    assert!(
        near(3.0) > 30_000 && wrong > 500 && wrong < near(3.0) / 5,
        "{wrong}"
    );
    assert!(near(3.0 - jump / 2.0) < wrong / 20);
    let strict = Parameters {
        phase_unwrap_error_threshold: 30,
        ..p
    };
    let kept = |image: &ZDepth| image.0.pixels().iter().filter(|&&z| z > 0.0).count();
    assert!(kept(&sense(strict, &wall(320, 240, 3.0))) < kept(&found) / 2);
}

/// Albedo·cos θ/r² of a slanted plane, from its depth alone; the mean of both frequencies.
#[test]
fn amplitude_is_lamberts() {
    let p = Parameters {
        signal_e: 20_000.0,
        read_noise_e: 0.0,
        full_well_e: 1e9,
        ..exact()
    };
    let (width, height) = (160u32, 120u32);
    let normal = [0.5f64, -0.2, 0.8];
    let scale = 640.0 / f64::from(width) / 457.0;
    let ray = |i: usize| {
        let (x, y) = (i % width as usize, i / width as usize);
        let u = (x as f64 + 0.5 - f64::from(width) / 2.0) * scale;
        let v = (y as f64 + 0.5 - f64::from(height) / 2.0) * scale;
        [u, v, 1.0]
    };
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let mut depth = wall(width, height, 0.0);
    for (i, z) in depth.pixels_mut().iter_mut().enumerate() {
        *z = (1.6 / dot(normal, ray(i))) as f32;
    }
    let output = sensor(p).output(&shot(&depth, 0), &random());
    for (i, &amplitude) in output.amplitude.pixels().iter().enumerate() {
        let ray = ray(i);
        let z = 1.6 / dot(normal, ray);
        let (length, size) = (dot(ray, ray).sqrt(), dot(normal, normal).sqrt());
        let cosine = dot(normal, ray) / length / size;
        let expected = 0.8 * 20_000.0 * 0.5 * cosine / (z * length).powi(2);
        // Five standard deviations of noise.
        let allowed = 5.0 * (expected / 0.8 / 2.0).sqrt() + 1.0;
        assert!(
            (f64::from(amplitude) - expected).abs() < allowed,
            "{i}: {amplitude} {expected}"
        );
    }
}

#[test]
fn a_picture_is_its_albedo() {
    let depth = wall(64, 48, 1.0);
    let grey = Image::filled(64, 48, [188u8, 188, 188, 255]);
    let black = Image::filled(64, 48, [0u8, 0, 0, 255]);
    let mean = |picture: &Image<[u8; 4]>| {
        let shot = shot(&depth, 0).with_rgb(picture.into()).unwrap();
        let amplitude = sensor(Parameters::new(457.0, 640))
            .output(&shot, &random())
            .amplitude;
        amplitude.pixels().iter().map(|&a| f64::from(a)).sum::<f64>() / 3072.0
    };
    // Black is 0.02.
    assert!((mean(&grey) / mean(&black) - 188.0 / 255.0 / 0.02).abs() < 1.0);
}
