//! Limits, motion, fixed patterns, and accuracy as published.

use super::terms::along_rays;
use super::*;
use crate::time_of_flight::{INDOOR_E, OUTDOOR_E};

#[test]
fn what_is_too_near_or_too_dark_is_lost() {
    let p = Parameters {
        albedo: 1.0,
        ambient_e: 0.0,
        ..Parameters::new(457.0, 640)
    };
    let nearest = sensor(p).nearest_m();
    assert!((nearest - 0.2).abs() < 1e-9);
    let long = Parameters {
        focal_length_px: 1e5,
        wiggling: 0.0,
        ..p
    };
    let fill = |z| statistics(&sense(long, &wall(64, 48, z))).2;
    assert_eq!((fill(0.199), fill(0.201)), (0.0, 1.0));
    // Only noise: what is lost is most of it.
    assert!(fill(300.0) < 0.2);
}

/// The higher frequency's last measurement is now: both see what moves where it was before.
#[test]
fn what_moves_is_seen_where_it_was() {
    let p = Parameters {
        enable_optical_correction: false,
        ..exact()
    };
    let depth = along_rays(p, 40, 30, 2.0);
    for shuffle in [false, true] {
        let p = Parameters {
            enable_phase_shuffle_temporal_filter: shuffle,
            ..p
        };
        let ages = if shuffle { [2.0, 1.0] } else { [1.0, 0.0] };
        let weight = 0.64 / 1.64;
        let age = (weight * ages[0] + (1.0 - weight) * ages[1]) / 60.0;
        let velocity = Image::filled(40, 30, 1.5);
        let still = sensor(p).sense(&shot(&depth, 0), &random());
        let moved = shot(&depth, 0).with_radial_velocity((&velocity).into()).unwrap();
        let by_pixel = sensor(p).sense(&moved, &random());
        let everything = Parameters {
            radial_velocity_m_s: 1.5,
            ..p
        };
        assert!(by_pixel == sense(everything, &depth));
        let off = statistics(&by_pixel).0 - statistics(&still).0;
        assert!((off + 1.5 * age).abs() < 0.000_2, "{off}");
    }
}

/// Errors of pixels that stay, unless corrected.
#[test]
fn the_fixed_pattern_stays() {
    let p = Parameters {
        enable_fppn_correction: false,
        fixed_pattern_m: 0.02,
        bias_m: 0.1,
        ..exact()
    };
    let depth = wall(160, 120, 2.0);
    let first = sensor(p).sense(&shot(&depth, 0), &random());
    let (mean, sigma, _) = statistics(&first);
    let cosine = 0.84;
    assert!(
        (mean - 2.0 - 0.1 * cosine).abs() < 0.01 && (sigma / 0.02 - cosine).abs() < 0.15,
        "{mean} {sigma}"
    );
    let mut other = shot(&depth, 9);
    other.item = 4;
    let second = sensor(p).sense(&other, &random());
    let both = first.0.pixels().iter().zip(second.0.pixels());
    assert!(both.map(|(a, b)| (a - b).abs()).fold(0.0, f32::max) < 0.01);
}

/// The vendor's accuracy and precision: of the middle's median, in ten frames.
#[test]
fn it_is_as_accurate_as_published() {
    for (ambient_e, most) in [(INDOOR_E, 0.01), (OUTDOOR_E, 0.02)] {
        for z in [0.2, 0.35, 0.5, 0.8, 1.3, 2.0, 2.9, 3.7, 4.4, 5.0] {
            let p = Parameters {
                ambient_e,
                ..Parameters::new(457.0, 640)
            };
            let depth = wall(160, 120, z);
            let means: Vec<f64> = (0..10)
                .map(|frame| {
                    let found = sensor(p).sense(&shot(&depth, 2 * frame), &random());
                    let mut values: Vec<f32> =
                        found.0.pixels().iter().copied().filter(|&z| z > 0.0).collect();
                    assert!(values.len() > 8000, "{z}: {}", values.len());
                    values.sort_by(f32::total_cmp);
                    f64::from(values[values.len() / 2])
                })
                .collect();
            let mean = means.iter().sum::<f64>() / 10.0;
            let sigma = (means.iter().map(|m| (m - mean).powi(2)).sum::<f64>() / 10.0).sqrt();
            assert!((mean / z - 1.0).abs() < most, "{ambient_e} {z}: {mean}");
            assert!(sigma / z < 0.001, "{ambient_e} {z}: {sigma}");
        }
    }
}

/// The closed forms of the errors agree with the simulated measurements.
#[test]
fn closed_forms_agree_with_measurements() {
    let p = Parameters {
        focal_length_px: 1e5,
        wiggling: 0.05,
        wiggling_residual: 0.02,
        bias_m: 0.0,
        ..Parameters::new(457.0, 640)
    };
    for (z, level, shuffle) in [
        (0.83, 4, true),
        (2.41, 4, false),
        (4.2, 4, true),
        (1.3, 0, true),
        (1.52, 0, false),
    ] {
        let p = Parameters {
            phase_unwrapping_level: level,
            enable_phase_shuffle_temporal_filter: shuffle,
            ..p
        };
        let (mean, sigma, _) = statistics(&sense(p, &wall(320, 240, z)));
        let expected = p.wiggle_m(z, p.wiggling_left());
        assert!((mean - z - expected).abs() < 0.000_4, "{z}: {mean} {expected}");
        let variance = p.range_variance_m2(z, 1.0) + 1e-6 / 12.0;
        assert!(
            (sigma * sigma / variance - 1.0).abs() < 0.03,
            "{z}: {sigma} {variance}"
        );
    }
    assert_eq!(p.shared_noise(), 0.5);
    let burst = Parameters {
        enable_burst_mode: true,
        ..p
    };
    assert_eq!(burst.shared_noise(), 0.0);
    assert!((p.period_m() - 1.6456).abs() < 1e-3);
}
