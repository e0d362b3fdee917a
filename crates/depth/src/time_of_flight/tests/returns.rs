//! Two returns in a pixel.

use std::f64::consts::TAU;

use oaktwin_image::annotation::Returns;

use super::*;
use crate::DepthShot;
use crate::time_of_flight::TimeOfFlightOutput;
use crate::time_of_flight::unwrap::turn_m;

const SIZE: [u32; 2] = [40, 30];

/// The same two returns in all pixels, along the rays.
fn returns(p: Parameters, ranges: [f64; 2], strengths: [f32; 2]) -> Returns {
    Returns {
        depths: ranges.map(|range| terms::along_rays(p, SIZE[0], SIZE[1], range)),
        strengths: strengths.map(|strength| Image::filled(SIZE[0], SIZE[1], strength)),
    }
}

fn along_the_ray() -> Parameters {
    Parameters {
        enable_optical_correction: false,
        phase_unwrap_error_threshold: 400,
        signal_e: 1e4,
        full_well_e: 1e9,
        ..exact()
    }
}

/// The distance and the amplitude of the sum of two phasors, in double precision: of the pairs of periods, the one with the smallest
/// difference, and the mean of both frequencies by the squares of their frequencies.
fn expected(p: &Parameters, ranges: [f64; 2], strengths: [f32; 2]) -> (f64, f64) {
    let one = |turn: f64| {
        let parts = ranges.iter().zip(strengths).map(|(range, strength)| {
            let amplitude = p.contrast * p.signal_e * f64::from(strength) / (range * range);
            let phase = TAU * range / turn;
            (amplitude * phase.cos(), amplitude * phase.sin())
        });
        let (re, im) = parts.fold((0.0, 0.0), |sum, part| (sum.0 + part.0, sum.1 + part.1));
        (im.atan2(re).rem_euclid(TAU) / TAU * turn, re.hypot(im))
    };
    let turns = p.frequencies_mhz.map(turn_m);
    let [(slow, low), (fast, high)] = turns.map(one);
    let mut best = (f64::INFINITY, 0.0);
    for i in 0..4 {
        for j in 0..5 {
            let pair = [slow + f64::from(i) * turns[0], fast + f64::from(j) * turns[1]];
            let weights = p.frequencies_mhz.map(|frequency| frequency * frequency);
            let mean = (pair[0] * weights[0] + pair[1] * weights[1]) / (weights[0] + weights[1]);
            let difference = (pair[0] - pair[1]).abs();
            if difference < best.0 {
                best = (difference, mean);
            }
        }
    }
    (best.1, 0.5 * (low + high))
}

/// The mean amplitude of the pixels around the centre.
fn amplitude_of(output: &TimeOfFlightOutput) -> f64 {
    let places = (12..18).flat_map(|y| (17..23).map(move |x| (x, y)));
    let values = places.map(|(x, y)| f64::from(*output.amplitude.get(x, y).unwrap()));
    values.sum::<f64>() / 36.0
}

/// The depth lies between the surfaces, where the phasors of both frequencies say, and the amplitude is below the sum of both.
#[test]
fn phasors_add_up() {
    let p = along_the_ray();
    for (ranges, strengths) in [
        ([1.2, 1.5], [0.3, 0.3]),
        ([1.5, 2.0], [0.4, 0.2]),
        ([2.0, 1.4], [0.8, 0.1]),
        ([0.9, 1.2], [0.1, 0.2]),
    ] {
        let found = returns(p, ranges, strengths);
        let depth = found.depths[0].clone();
        let shot = DepthShot::new((&depth).into()).with_returns(&found).unwrap();
        let output = sensor(p).output(&shot, &random());
        let (distance, amplitude) = expected(&p, ranges, strengths);
        let (mean, _, fill) = statistics(&output.distance);
        assert!(
            (mean - distance).abs() < 0.001 && fill == 1.0,
            "{ranges:?}: {mean} {distance}"
        );
        let [near, far] = [ranges[0].min(ranges[1]), ranges[0].max(ranges[1])];
        assert!(near < mean && mean < far, "{mean}");
        let middle = amplitude_of(&output);
        assert!(
            (middle - amplitude).abs() < 1.0 + 0.01 * amplitude,
            "{middle} {amplitude}"
        );
        let alone: f64 = [0, 1]
            .map(|i: usize| p.contrast * p.signal_e * f64::from(strengths[i]) / ranges[i].powi(2))
            .iter()
            .sum();
        assert!(middle < 0.95 * alone, "{middle} {alone}");
    }
}

/// One return of a given strength is a surface of that albedo, and nothing is measured where nothing returns.
#[test]
fn one_return_is_a_surface_with_its_albedo() {
    let p = along_the_ray();
    let wall = wall(SIZE[0], SIZE[1], 2.0);
    let mut given = Returns {
        depths: [wall.clone(), Image::filled(SIZE[0], SIZE[1], f32::INFINITY)],
        strengths: [0.37, 0.0].map(|strength| Image::filled(SIZE[0], SIZE[1], strength)),
    };
    let output = |given: &Returns, albedo: f64| {
        let sensor = sensor(Parameters { albedo, ..p });
        let shot = DepthShot::new((&wall).into()).with_returns(given).unwrap();
        sensor.output(&shot, &random())
    };
    let alone = output(&given, 0.9);
    let middle = amplitude_of(&alone);
    // The rays of the pixels are up to 1 % longer than the depth.
    let expected = p.contrast * p.signal_e * 0.37 / 4.0;
    assert!((middle / expected - 1.0).abs() < 0.02, "{middle} {expected}");
    // Where no strength is given, the surface has the albedo of the engine.
    given.strengths[0] = Image::filled(SIZE[0], SIZE[1], f32::NAN);
    let own = output(&given, 0.37);
    assert_eq!(
        own.distance,
        sensor(Parameters { albedo: 0.37, ..p }).sense(&shot(&wall, 0), &random())
    );
    let nothing = Returns {
        depths: [f32::INFINITY; 2].map(|depth| Image::filled(SIZE[0], SIZE[1], depth)),
        strengths: [0.0; 2].map(|strength| Image::filled(SIZE[0], SIZE[1], strength)),
    };
    let dark = output(&nothing, 0.9);
    assert!(dark.distance.0.pixels().iter().all(|depth| *depth == 0.0));
    let wrong = Image::filled(3, 3, 1.0);
    let error = DepthShot::new((&wrong).into())
        .with_returns(&given)
        .unwrap_err()
        .to_string();
    assert!(error.contains("image of returns"), "{error}");
}
