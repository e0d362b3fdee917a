//! Fits of simulated recordings with known parameters.

use std::fmt::Write;
use std::fs;
use std::path::Path;

use oaktwin_depth::random::Stream;
use oaktwin_depth::time_of_flight::{Parameters, TimeOfFlight};

use crate::fit::fixture::{self, codes, has};
use crate::fit::{FitOptions, FitReport};
use oaktwin_base::diagnostic::Finding;
use oaktwin_camera::ImageSize;
use oaktwin_pipeline::sensor::{SensorOptions, TIME_OF_FLIGHT, time_of_flight_parameters};

/// A few pixels at the centre of the device's view.
const CROP: [(&str, &str); 2] = [("width", "64"), ("principalPoint", "center")];
const WIDTH: u32 = 64;
const HEIGHT: u32 = 48;
const MODEL: &str = "oak-d-tof";

fn options() -> FitOptions {
    FitOptions {
        engine: SensorOptions {
            engine: Some((&TIME_OF_FLIGHT).into()),
            parameters: CROP.map(|(name, value)| (name.to_owned(), value.into())).to_vec(),
            ..SensorOptions::default()
        },
        region: 0.6,
        ..FitOptions::default()
    }
}

fn model() -> Parameters {
    let twin = fixture::twin(MODEL);
    let camera = twin.depth_sensors.last().unwrap().spec.camera;
    let mut p = time_of_flight_parameters(twin.camera(camera).unwrap().intrinsics);
    for (name, value) in CROP {
        p.set(name, value).unwrap();
    }
    p
}

struct Recorded<'a> {
    parameters: Parameters,
    seed: u64,
    distances_m: &'a [f64],
    frames: u64,
    turned_deg: f64,
}

impl Recorded<'_> {
    /// Writes a file of all frames for each distance, and the table, in which a distance may be wrong.
    fn write(&self, folder: &Path, said: impl Fn(f64) -> f64) {
        let engine = TimeOfFlight::new(self.parameters).unwrap();
        let random = Stream::new(self.seed, "test");
        let p = &self.parameters;
        let focal_px = p.focal_length_px * f64::from(WIDTH) / f64::from(p.width_px);
        let board = |z| fixture::board(ImageSize::new(WIDTH, HEIGHT), focal_px, z, self.turned_deg);
        let boards = self.distances_m.iter().map(|&z| (board(z), said(z)));
        fixture::record(folder, boards, self.frames, |shot| engine.sense(shot, &random));
    }

    fn fitted(&self, options: &FitOptions) -> (FitReport, Vec<Finding>) {
        let folder = tempfile::tempdir().unwrap();
        self.write(folder.path(), |z| z);
        fitted(folder.path(), options).unwrap()
    }
}

fn fitted(path: &Path, options: &FitOptions) -> Result<(FitReport, Vec<Finding>), String> {
    let (report, findings, read) = fixture::fitted(MODEL, &[path], options)?;
    assert_eq!(read.engine, &TIME_OF_FLIGHT);
    assert_eq!(read.parameters.len(), report.parameters.len());
    Ok((report, findings))
}

fn with(options: FitOptions, parameter: (&str, &str)) -> FitOptions {
    let mut options = options;
    let (name, value) = parameter;
    options.engine.parameters.push((name.to_owned(), value.into()));
    options
}

fn missing(report: &FitReport) -> Vec<&str> {
    report.not_found.iter().map(|one| one.name).collect()
}

fn distances(count: u32) -> Vec<f64> {
    (0..count).map(|i| 0.6 + 0.37 * f64::from(i)).collect()
}

/// Many small recordings of different devices: the true value is inside the intervals about as often as they claim.
#[test]
fn intervals_contain_the_true_values() {
    const RUNS: u32 = 60;
    let mut inside = [0u32; 4];
    let mut widths = [0.0; 4];
    for run in 0..RUNS {
        let at = f64::from(run);
        let p = Parameters {
            bias_m: 0.004 * (at * 0.7).sin(),
            wiggling_residual: 0.004 + 0.012 * (at * 0.37).sin().abs(),
            signal_e: 3800.0 + 1200.0 * (at * 0.51).sin(),
            ambient_e: 40.0 + 400.0 * (at * 0.23).cos().abs(),
            enable_burst_mode: run % 3 == 0,
            ..model()
        };
        let distances: Vec<f64> = (0..12).map(|i| 0.6 + 0.33 * f64::from(i) + 0.007 * at).collect();
        let recorded = Recorded {
            parameters: p,
            seed: u64::from(run),
            distances_m: &distances,
            frames: 4,
            turned_deg: 0.0,
        };
        // Shared noise is detected.
        let (report, findings) = recorded.fitted(&options());
        assert_eq!(codes(&findings).contains(&"shared-noise"), p.enable_burst_mode);
        assert!(report.passed, "{run}: {findings:?}");
        let truths = [
            ("bias", p.bias_m),
            ("wigglingResidual", p.wiggling_residual),
            ("signal", p.signal_e),
            ("ambient", p.ambient_e),
        ];
        for ((count, width), (name, value)) in inside.iter_mut().zip(&mut widths).zip(truths) {
            *count += u32::from(has(&report, name, value));
            let [low, high] = report.parameter(name).unwrap().interval_95.unwrap();
            *width += (high - low) / f64::from(RUNS);
        }
    }
    println!("inside of {RUNS}: {inside:?}, mean widths {widths:?}");
    for count in inside {
        assert!(f64::from(count) >= 0.85 * f64::from(RUNS), "{inside:?}");
    }
    // Intervals must not be too wide either.
    assert!(
        widths[0] < 0.001 && widths[1] < 0.006 && widths[2] < 600.0 && widths[3] < 150.0,
        "{widths:?}"
    );
}

#[test]
fn wiggling_without_its_correction() {
    let p = Parameters {
        enable_wiggle_correction: false,
        wiggling: 0.05,
        bias_m: 0.002,
        ..model()
    };
    let recorded = Recorded {
        parameters: p,
        seed: 4,
        distances_m: &distances(12),
        frames: 4,
        turned_deg: 0.0,
    };
    let (report, findings) = recorded.fitted(&with(options(), ("enableWiggleCorrection", "false")));
    assert!(report.passed, "{findings:?}");
    let wiggling = report.parameter("wiggling").unwrap();
    assert!((wiggling.value - 0.05).abs() < 0.004, "{wiggling:?}");
}

#[test]
fn undeterminable_parameters_are_reported() {
    let of = |distances_m: &[f64], frames, signal_e| {
        let recorded = Recorded {
            parameters: Parameters {
                signal_e,
                full_well_e: 1e9,
                ..model()
            },
            seed: 5,
            distances_m,
            frames,
            turned_deg: 0.0,
        };
        recorded.fitted(&options())
    };
    let (one, findings) = of(&[2.0], 6, 3000.0);
    assert_eq!(
        missing(&one),
        ["ambient", "bias", "wigglingResidual"],
        "{findings:?}"
    );
    assert!(
        !one.passed
            && findings
                .iter()
                .any(|finding| finding.message.contains("one distance"))
    );
    let signal = one.parameter("signal").unwrap();
    assert!((signal.value / 3000.0 - 1.0).abs() < 0.08, "{signal:?}");
    let (still, findings) = of(&distances(12), 1, 3000.0);
    assert_eq!(missing(&still), ["signal", "ambient"], "{findings:?}");
    assert!(still.parameter("bias").unwrap().value.abs() < 0.002, "{still:?}");
    let (quiet, findings) = of(&[0.3, 0.4, 0.5, 0.6], 4, 4e5);
    assert!(missing(&quiet).contains(&"signal"), "{findings:?}");
}

#[test]
fn wrong_periods_and_distances_out_of_range_are_excluded() {
    let good = distances(11);
    let recorded = Recorded {
        parameters: Parameters {
            bias_m: 0.003,
            ..model()
        },
        seed: 6,
        distances_m: &[&good[..], &[2.5]].concat(),
        frames: 4,
        turned_deg: 0.0,
    };
    let folder = tempfile::tempdir().unwrap();
    // The table places the board at 2.5 m a period farther away.
    let period = model().period_m();
    recorded.write(folder.path(), |z| if z == 2.5 { z + period } else { z });
    let (report, findings) = fitted(folder.path(), &options()).unwrap();
    assert_eq!(codes(&findings), ["wrong-period"], "{findings:?}");
    assert_eq!(report.points.iter().filter(|point| !point.is_used).count(), 1);
    assert!(has(&report, "bias", 0.003), "{report:?}");
    recorded.write(folder.path(), |z| if z == 2.5 { 8.2 } else { z });
    let (report, findings) = fitted(folder.path(), &options()).unwrap();
    assert_eq!(codes(&findings), ["beyond-range"], "{findings:?}");
    assert!(has(&report, "bias", 0.003), "{report:?}");
}

#[test]
fn a_small_rotation_is_corrected_and_a_large_one_rejected() {
    let recorded = |turned_deg| Recorded {
        parameters: Parameters {
            bias_m: -0.004,
            ..model()
        },
        seed: 11,
        distances_m: &[0.6, 0.9, 1.3, 1.7, 2.0, 2.4, 2.9, 3.1],
        frames: 4,
        turned_deg,
    };
    let (report, findings) = recorded(3.0).fitted(&options());
    assert!((report.tilt_deg.unwrap() - 3.0).abs() < 0.2, "{report:?}");
    assert_eq!(codes(&findings), ["turned"]);
    let bias = report.parameter("bias").unwrap().value;
    assert!((bias + 0.004).abs() < 0.001, "{bias}");
    let folder = tempfile::tempdir().unwrap();
    recorded(12.0).write(folder.path(), |z| z);
    let error = fitted(folder.path(), &options()).unwrap_err();
    assert!(error.contains("the target is tilted by 1"), "{error}");
}

/// Errors alone, signed and absolute.
#[test]
fn a_curve_of_errors() {
    let truth = Parameters {
        bias_m: 0.006,
        wiggling_residual: 0.01,
        ..model()
    };
    let folder = tempfile::tempdir().unwrap();
    for (bias_m, wiggling, is_absolute) in [(-0.006, 0.01, false), (0.001, 0.02, true)] {
        let mut text = "distance_m,depth_error_percent\n".to_owned();
        for i in 0..40 {
            let z = 0.4 + 0.11 * f64::from(i);
            let error_m = bias_m + truth.wiggle_m(z + bias_m, wiggling);
            let percent = 100.0 * error_m / z;
            let _ = writeln!(text, "{z},{}", if is_absolute { percent.abs() } else { percent });
        }
        let file = folder.path().join("curve.csv");
        fs::write(&file, text).unwrap();
        let narrow = FitOptions {
            region: 0.01,
            ..options()
        };
        let (report, findings) = fitted(&file, &narrow).unwrap();
        assert!(report.passed, "{findings:?}");
        let value = |name: &str| report.parameter(name).unwrap().value;
        assert!((value("bias") - bias_m).abs() < 1e-5, "{:?}", report.parameters);
        assert!((value("wigglingResidual") - wiggling).abs() < 1e-4);
        assert_eq!(missing(&report), ["signal", "ambient"]);
    }
}

#[test]
fn invalid_options_are_rejected() {
    let folder = tempfile::tempdir().unwrap();
    let focal = FitOptions {
        fits_focal_length: true,
        ..options()
    };
    for (options, expected) in [
        (focal, "do not depend on the focal length"),
        (
            with(options(), ("enableOpticalCorrection", "false")),
            "along the rays",
        ),
        (with(options(), ("albedo", "0")), "without light"),
    ] {
        let error = fitted(folder.path(), &options).unwrap_err();
        assert!(error.contains(expected), "{error}");
    }
}
