//! The confidence of each engine: what it is made of, and that the distance does not depend on whether it is requested.

#![expect(
    clippy::unwrap_used,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "tests"
)]

use oaktwin_depth::engines::{SINGLE_VIEW, STEREO_MATCHING, STEREO_NOISE, TIME_OF_FLIGHT};
use oaktwin_depth::random::Stream;
use oaktwin_depth::stereo_matching::{LuminanceImage, RectifiedPair};
use oaktwin_depth::time_of_flight::TimeOfFlight;
use oaktwin_depth::{Capture, DepthShot, EngineKind, Input, Sensor};
use oaktwin_image::Image;
use oaktwin_image::annotation::Annotator;

use crate::support::Optics;

const WIDTH: u32 = 200;
const HEIGHT: u32 = 90;
const CONFIDENCE: Annotator = Annotator::DepthSensorConfidence;

fn sensor(kind: &EngineKind, parameters: &[(&str, &str)], filters: &[&str]) -> Sensor {
    let optics = Optics {
        focal_length_px: 150.0,
        width: WIDTH,
    };
    optics.sensor(kind, parameters, filters)
}

/// Measures with and without confidence, and returns the distance and the confidence.
fn sure<'a>(mut sensor: Sensor, input: impl Into<Input<'a>>, more: &[Annotator]) -> (Capture, Image<u16>) {
    let input = input.into();
    let plain = sensor.clone().capture(input, &[]).unwrap();
    let request = [&[CONFIDENCE], more].concat();
    let capture = sensor.capture(input, &request).unwrap();
    assert_eq!(plain.distance, capture.distance);
    let levels: &Image<u16> = capture.extra(CONFIDENCE).unwrap();
    let levels = levels.clone();
    let distance = &capture.distance.0;
    assert_eq!(
        (levels.width(), levels.height()),
        (distance.width(), distance.height())
    );
    (capture, levels)
}

fn wall(metres: f32) -> Image<f32> {
    Image::filled(WIDTH, HEIGHT, metres)
}

/// Texture whose contrast grows to the right, with plain rows.
fn picture() -> Image<[u8; 4]> {
    let pixels = (0..HEIGHT).flat_map(|y| (0..WIDTH).map(move |x| (x, y)));
    let grey = |(x, y): (u32, u32)| {
        let random =
            (x.wrapping_mul(0x9E37_79B9) ^ y.wrapping_mul(0x85EB_CA6B)).wrapping_mul(0x2C1B_3C6D) >> 24;
        let value = if y < 30 { 90 } else { 90 + random * x / (4 * WIDTH) };
        [value as u8, value as u8, value as u8, 255]
    };
    Image::new(WIDTH, HEIGHT, pixels.map(grey).collect()).unwrap()
}

#[test]
fn stereo_noise_reports_the_texture_that_its_threshold_tests() {
    let (depth, picture) = (wall(2.0), picture());
    let shot = DepthShot::new((&depth).into())
        .with_rgb((&picture).into())
        .unwrap();
    let (_, levels) = sure(sensor(&STEREO_NOISE, &[("occlusion", "false")], &[]), shot, &[]);
    let luma = |x: usize, y: usize| i64::from(picture.pixels()[y * WIDTH as usize + x][0]);
    let (width, height) = (WIDTH as usize, HEIGHT as usize);
    // The window has 7 px; the first and last differences over 4 px of a row, and the border, are repeated.
    let difference = |x: i64, y: i64| {
        let (x, y) = (
            x.clamp(2, width as i64 - 3) as usize,
            y.clamp(0, height as i64 - 1) as usize,
        );
        let [apart, next] = [(x - 2, x + 2), (x, x + 1)].map(|(a, b)| (luma(a, y) - luma(b, y)).abs());
        apart.max(next)
    };
    for (place, level) in levels.pixels().iter().enumerate() {
        let (x, y) = ((place % width) as i64, (place / width) as i64);
        let sum: i64 = (-3..=3)
            .flat_map(|dy| (-3..=3).map(move |dx| (dx, dy)))
            .map(|(dx, dy)| difference(x + dx, y + dy))
            .sum();
        assert_eq!(i64::from(*level), (sum * 72 / 49).min(255), "{x} {y}");
    }
    assert!(levels.pixels().contains(&0) && levels.pixels().contains(&255));
    let thresholds = ["1", "55", "56", "200", "255"];
    for (threshold, contrast) in thresholds.iter().flat_map(|t| [(*t, "0"), (*t, "0.5")]) {
        let parameters = [
            ("confidenceThreshold", threshold),
            ("dotContrast", contrast),
            ("occlusion", "false"),
        ];
        let (capture, levels) = {
            let (capture, with_dots) = sure(sensor(&STEREO_NOISE, &parameters, &[]), shot, &[]);
            let more = with_dots.pixels().iter().zip(levels.pixels());
            assert!(contrast != "0" || with_dots == levels);
            assert!(more.clone().all(|(dots, plain)| dots >= plain));
            (capture, with_dots)
        };
        let threshold: u16 = threshold.parse().unwrap();
        for (metres, level) in capture.distance.0.pixels().iter().zip(levels.pixels()) {
            assert_eq!(*metres > 0.0, *level >= threshold, "{metres} {level}");
        }
    }
    let without = sensor(&STEREO_NOISE, &[], &[]).capture(DepthShot::new((&depth).into()), &[CONFIDENCE]);
    assert_eq!(without.unwrap().extra::<Image<u16>>(CONFIDENCE), None);
}

#[test]
fn single_view_reports_the_confidence_of_the_sample_in_a_pixel() {
    let (depth, picture) = (wall(2.0), picture());
    let shot = DepthShot::new((&depth).into())
        .with_rgb((&picture).into())
        .unwrap();
    for at in ["source", "target"] {
        for range in ["0", "1", "2"] {
            let parameters = [
                ("confidenceThreshold", "0.9"),
                ("confidenceAt", at),
                ("outlierRemovalEnabled", range),
            ];
            let (capture, levels) = sure(sensor(&SINGLE_VIEW, &parameters, &[]), shot, &[]);
            let kept = capture.distance.0.pixels().iter().zip(levels.pixels());
            let kept: Vec<u16> = kept
                .filter(|(metres, _)| **metres > 0.0)
                .map(|(_, level)| *level)
                .collect();
            assert!(kept.len() > 1000);
            if range == "0" {
                // s ≥ 0.1, rounded: 25.5 or more.
                assert!(kept.iter().all(|level| *level >= 25), "{at}");
            }
        }
    }
    // A row of no texture; samples move by 150 · 0.075 / 2 = 5.6 px, and leave the border empty.
    let still = [
        ("noiseMean", "0"),
        ("noiseSigma", "0"),
        ("confidenceThreshold", "1"),
    ];
    let (capture, levels) = sure(sensor(&SINGLE_VIEW, &still, &[]), shot, &[]);
    let row = 10 * WIDTH as usize;
    assert!(
        levels.pixels()[row..row + WIDTH as usize]
            .iter()
            .all(|level| *level == 0)
    );
    assert!(capture.distance.0.pixels()[row + 100] > 0.0);
    let row = 60 * WIDTH as usize;
    let near_border = |place: usize| {
        (
            levels.pixels()[row + place],
            capture.distance.0.pixels()[row + place],
        )
    };
    assert!(near_border(2) == (0, 0.0) || near_border(WIDTH as usize - 3) == (0, 0.0));
    assert!(levels.pixels()[row..].contains(&255));
}

#[test]
fn time_of_flight_reports_the_amplitude_for_its_distance() {
    let mut depth = wall(1.0);
    for row in depth.pixels_mut().chunks_exact_mut(WIDTH as usize) {
        row[60..110].fill(3.0);
        row[150..170].fill(f32::INFINITY);
    }
    let shot = DepthShot::new((&depth).into());
    let engine = sensor(&TIME_OF_FLIGHT, &[], &[]);
    let (capture, levels) = sure(engine.clone(), shot, &[Annotator::DepthSensorReason]);
    let own: &TimeOfFlight = engine.engine().downcast_ref().unwrap();
    let output = own.output(&shot, &Stream::new(1, "camera"));
    assert_eq!(output.distance, capture.distance);
    let mut compared = 0;
    for (place, level) in levels.pixels().iter().enumerate() {
        let millimetres = output.distance.0.pixels()[place] * 1e3;
        if millimetres == 0.0 {
            assert_eq!(*level, 0);
            continue;
        }
        let amplitude = f32::from(output.amplitude.pixels()[place]);
        let expected = 100.0 * amplitude / (millimetres / 2.0).sqrt();
        assert!((f32::from(*level) - expected.min(65535.0)).abs() <= 1.0 + expected * 1e-6);
        compared += 1;
    }
    assert!(compared > 10_000);
    let at = |x: usize| levels.pixels()[45 * WIDTH as usize + x];
    assert!(
        at(30) > 2 * at(85) && at(85) > 0 && at(160) == 0,
        "{} {}",
        at(30),
        at(85)
    );
}

#[test]
fn matching_reports_the_confidence_of_its_costs() {
    let texture = |shift: u32| {
        let pixels = (0..HEIGHT).flat_map(|y| (0..WIDTH).map(move |x| (x + shift, y)));
        let random = |(x, y): (u32, u32)| {
            (x.wrapping_mul(0x9E37_79B9) ^ y.wrapping_mul(0x85EB_CA6B)).wrapping_mul(0x2C1B_3C6D) >> 24
        };
        Image::new(WIDTH, HEIGHT, pixels.map(|pixel| random(pixel) as u8).collect()).unwrap()
    };
    let [left, right] = [texture(0), texture(6)];
    let pair = RectifiedPair::new(
        LuminanceImage::Bits8((&left).into()),
        LuminanceImage::Bits8((&right).into()),
    )
    .unwrap();
    for filters in [&[][..], &["decimation:factor=2"]] {
        let (capture, levels) = sure(
            sensor(&STEREO_MATCHING, &[], filters),
            pair,
            &[Annotator::Confidence],
        );
        let bytes: &Image<u8> = capture.extra(Annotator::Confidence).unwrap();
        assert_eq!(levels, bytes.map(|byte| u16::from(*byte)));
        assert!(levels.pixels().iter().any(|level| *level > 150));
    }
}

#[test]
fn decimation_makes_it_as_small_as_the_distance() {
    let (depth, picture) = (wall(2.0), picture());
    let shot = DepthShot::new((&depth).into())
        .with_rgb((&picture).into())
        .unwrap();
    for kind in [&SINGLE_VIEW, &STEREO_NOISE, &TIME_OF_FLIGHT] {
        let (_, levels) = sure(sensor(kind, &[], &["decimation:factor=3"]), shot, &[]);
        assert!(levels.width() < WIDTH / 2, "{kind}");
    }
}
