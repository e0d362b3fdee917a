use std::f64::consts::TAU;
use std::fs;

use oaktwin_depth::random::{NoiseStage, Numbers, Stream};

use super::*;

/// The place of an edge that moves irregularly, and smoothly.
fn place(t: f64) -> f64 {
    0.3 * (TAU * 0.7 * t).sin() + 0.2 * (TAU * 1.13 * t + 0.4).sin() + 0.1 * (TAU * 0.31 * t).cos()
}

fn numbers(seed: u64) -> Numbers {
    Numbers::new(Stream::new(seed, "latency").plane(NoiseStage::Delivery, 0, 0))
}

/// An encoder at 1 kHz, from 0 to 10 s.
fn encoder() -> Track {
    let time_s: Vec<f64> = (0..10_000).map(|sample| f64::from(sample) * 1e-3).collect();
    Track {
        name: "encoder.csv".to_owned(),
        position: time_s.iter().map(|t| place(*t)).collect(),
        time_s,
    }
}

/// A camera at 30 fps with a latency and its jitter, and a noisy edge in pixels, on the other side of the axis.
fn camera(latency_s: f64, jitter_s: f64, noise_px: f64, seed: u64) -> Track {
    let mut numbers = numbers(seed);
    let exposed = (0..290).map(|frame| 0.0137 + f64::from(frame) / 30.0);
    let images = exposed.map(|t| {
        let arrival = t + latency_s + jitter_s * numbers.normal_within(4.0);
        (
            arrival,
            320.0 - 500.0 * place(t) + noise_px * numbers.normal_within(4.0),
        )
    });
    let images: Vec<(f64, f64)> = images.filter(|(t, _)| *t < 9.9).collect();
    Track {
        name: "camera.csv".to_owned(),
        time_s: images.iter().map(|image| image.0).collect(),
        position: images.iter().map(|image| image.1).collect(),
    }
}

#[test]
fn a_known_latency_is_found_within_a_millisecond() {
    for (seed, latency_s) in [(1, 0.0415), (2, 0.0083), (3, 0.2), (4, 0.9), (5, 0.1234)] {
        let (report, findings) = latency(&camera(latency_s, 0.0, 0.5, seed), &encoder(), 1.0).unwrap();
        assert!(
            (report.latency_s - latency_s).abs() < 1e-3,
            "{latency_s}: {report:?}"
        );
        assert!(
            report.correlation < -0.999 && findings.is_empty() && report.passed,
            "{findings:?}"
        );
        assert!(
            report.jitter_s < 1e-3 && (report.edge_noise - 0.5).abs() < 0.12,
            "{report:?}"
        );
    }
}

#[test]
fn without_noise_the_latency_is_exact() {
    let (report, _) = latency(&camera(0.0557, 0.0, 0.0, 1), &encoder(), 0.5).unwrap();
    assert!((report.latency_s - 0.0557).abs() < 2e-6, "{report:?}");
}

#[test]
fn intervals_contain_the_latency_as_often_as_they_say() {
    let encoder = encoder();
    let contains = |seed| {
        let (report, _) = latency(&camera(0.05, 0.0, 3.0, seed), &encoder, 0.2).unwrap();
        let (low, high) = report.interval_95_s;
        assert!(high - low < 4e-3, "{report:?}");
        (low..high).contains(&0.05)
    };
    let count = (0..50).filter(|seed| contains(*seed)).count();
    assert!((43..=50).contains(&count), "{count}");
}

#[test]
fn jitter_is_separated_from_the_noise_of_the_edge() {
    for (jitter_s, noise_px) in [(0.006, 0.5), (0.003, 1.0), (0.0, 2.0)] {
        let mut found = [0.0; 2];
        for seed in 0..10 {
            let (report, _) = latency(&camera(0.08, jitter_s, noise_px, seed), &encoder(), 0.3).unwrap();
            assert!((report.latency_s - 0.08).abs() < 2e-3, "{report:?}");
            found[0] += 0.1 * report.jitter_s;
            found[1] += 0.1 * report.edge_noise;
        }
        assert!((found[0] - jitter_s).abs() < 1e-3, "{jitter_s}: {found:?}");
        assert!((found[1] - noise_px).abs() < 0.35, "{noise_px}: {found:?}");
    }
}

#[test]
fn what_repeats_is_reported() {
    let moving = |track: &Track, latency_s: f64| Track {
        position: track
            .time_s
            .iter()
            .map(|t| (TAU * 4.0 * (t - latency_s)).sin())
            .collect(),
        ..track.clone()
    };
    let reference = moving(&encoder(), 0.0);
    let camera = moving(&camera(0.05, 0.0, 0.0, 1), 0.05);
    let (report, findings) = latency(&camera, &reference, 0.6).unwrap();
    let [finding] = &findings[..] else {
        panic!("{findings:?}")
    };
    assert_eq!((finding.code, report.passed), ("latency-ambiguous", false));
    // Within a period there is one answer.
    let (report, findings) = latency(&camera, &reference, 0.12).unwrap();
    assert!(
        findings.is_empty() && (report.latency_s - 0.05).abs() < 1e-3,
        "{findings:?}"
    );
}

#[test]
fn what_determines_no_latency_is_an_error() {
    let error = |camera: &Track, longest_s| latency(camera, &encoder(), longest_s).unwrap_err().to_string();
    let good = camera(0.05, 0.0, 0.5, 1);
    let few = Track {
        time_s: good.time_s[..25].to_vec(),
        position: good.position[..25].to_vec(),
        ..good.clone()
    };
    let text = error(&few, 1.0);
    assert!(
        text.starts_with("camera.csv: has 0 images while the reference was recorded"),
        "{text}"
    );
    for longest_s in [0.0, -1.0, 61.0, f64::NAN] {
        assert!(error(&good, longest_s).contains("is out of range; give seconds above 0, up to 60"));
    }
    let mut numbers = numbers(9);
    let noise = Track {
        position: good.position.iter().map(|_| numbers.uniform()).collect(),
        ..good.clone()
    };
    let text = error(&noise, 1.0);
    assert!(text.contains("correlates with encoder.csv by 0."), "{text}");
    // A latency beyond the limit.
    let (_, findings) = latency(&camera(0.3, 0.0, 0.5, 1), &encoder(), 0.25).unwrap();
    assert_eq!(findings[0].code, "latency-at-limit");
}

#[test]
fn tracks_are_checked() {
    let folder = std::env::temp_dir().join(format!("oaktwin-latency-{}", std::process::id()));
    fs::create_dir_all(&folder).unwrap();
    let read = |text: &str| {
        let file = folder.join("track.csv");
        fs::write(&file, text).unwrap();
        Track::read(&file).map_err(|error| error.to_string())
    };
    let track = read("position,time_s\n1,0\n2.5,0.5\n").unwrap();
    assert_eq!(
        (&track.time_s[..], &track.position[..]),
        (&[0.0, 0.5][..], &[1.0, 2.5][..])
    );
    assert_eq!(track.at(0.25), (1.75, 3.0));
    assert_eq!((track.at(0.0).0, track.at(0.5).0), (1.0, 2.5));
    for (text, message) in [
        ("", "is empty"),
        ("time_s,position\n", "has no rows"),
        ("time_s,place\n0,1\n", "there is no column position"),
        (
            "time_s,position\n0,1\n0,2\n",
            "line 3: time_s: 0 is not after 0; sort by time",
        ),
        (
            "time_s,position\n0,1\n1,nan\n",
            "line 3: position: \"nan\" is not a finite number",
        ),
        (
            "time_s,position\n0,1\n1,1\n",
            "the position never changes; record an edge that moves",
        ),
    ] {
        let error = read(text).unwrap_err();
        assert!(error.contains(message), "{error}");
    }
    fs::remove_dir_all(&folder).unwrap();
    let track = |time_s: &[f64], position: &[f64]| {
        Track::new("camera", time_s.to_vec(), position.to_vec()).map_err(|error| error.to_string())
    };
    assert!(track(&[0.0, 1.0], &[2.0, 3.0]).is_ok());
    for (time_s, position, message) in [
        (
            &[0.0][..],
            &[][..],
            "camera: has 1 times and 0 positions; give a position for each time",
        ),
        (&[], &[], "camera: has 0 times"),
        (
            &[0.0, f64::NAN],
            &[1.0, 2.0],
            "camera: sample 1: (NaN, 2) is not finite",
        ),
        (
            &[1.0, 0.5],
            &[1.0, 2.0],
            "camera: sample 1: time_s: 0.5 is not after 1",
        ),
    ] {
        let error = track(time_s, position).unwrap_err();
        assert!(error.contains(message), "{error}");
    }
}
