//! Fits of simulated recordings with known parameters.

use oaktwin_depth::preset::Platform;
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

use oaktwin_depth::DepthShot;
use oaktwin_depth::random::Stream;
use oaktwin_depth::stereo_noise::{Parameters, StereoNoise};

use crate::accuracy::MeasuredOptics;
use crate::fit::fixture::{self, codes, has};
use crate::fit::{FitOptions, FitReport, TABLE};
use oaktwin_base::diagnostic::Finding;
use oaktwin_camera::{ImageSize, StereoGeometry};
use oaktwin_image::{Image, npy};

/// A matcher with few pixels and a long focal length: realistic disparities in small images.
const WIDTH: u32 = 320;
const HEIGHT: u32 = 120;
const FOCAL_PX: f64 = 800.0;
const BASELINE_M: f64 = 0.075;
const REGION: f64 = 0.3;
const MODEL: &str = "oak-d-pro-poe";

fn optics() -> MeasuredOptics {
    MeasuredOptics {
        focal_length_px: Some(FOCAL_PX),
        width_px: Some(WIDTH),
    }
}

fn options() -> FitOptions {
    FitOptions {
        optics: optics(),
        region: REGION,
        ..FitOptions::default()
    }
}

fn truth(bias: f64, locking: f64, jitter: f64, window: u32) -> Parameters {
    let stereo = StereoGeometry {
        focal_length_px: FOCAL_PX,
        baseline_m: BASELINE_M,
    };
    Parameters {
        bias_px: bias,
        pixel_locking_px: locking,
        jitter_px: jitter,
        window_px: window,
        ..Parameters::new(Platform::Rvc2, stereo, WIDTH)
    }
}

fn board(z: f64, turned_deg: f64) -> Image<f32> {
    fixture::board(ImageSize::new(WIDTH, HEIGHT), FOCAL_PX, z, turned_deg)
}

struct Recorded<'a> {
    parameters: Parameters,
    seed: u64,
    distances_m: &'a [f64],
    frames: u64,
    turned_deg: f64,
}

impl Recorded<'_> {
    /// Writes a file of all frames for each distance, and the table.
    fn write(&self, folder: &Path) {
        let engine = StereoNoise::new(self.parameters).unwrap();
        let random = Stream::new(self.seed, "test");
        let boards = self.distances_m.iter().map(|&z| (board(z, self.turned_deg), z));
        fixture::record(folder, boards, self.frames, |shot| engine.sense(shot, &random));
    }

    fn fitted(&self, options: &FitOptions) -> (FitReport, Vec<Finding>) {
        let folder = tempfile::tempdir().unwrap();
        self.write(folder.path());
        fitted(&[folder.path()], options).unwrap()
    }
}

fn fitted(paths: &[&Path], options: &FitOptions) -> Result<(FitReport, Vec<Finding>), String> {
    let (report, findings, _) = fixture::fitted(MODEL, paths, options)?;
    Ok((report, findings))
}

/// Many small recordings of different devices: the true value is inside the intervals about as often as they claim.
#[test]
fn intervals_contain_the_true_values() {
    const RUNS: u32 = 60;
    let mut inside = [0u32; 4];
    let mut widths = [0.0; 3];
    for run in 0..RUNS {
        let at = f64::from(run);
        let bias = 0.3 * (at * 0.7).sin();
        let locking = 0.04 + 0.18 * (at * 0.37).sin().abs();
        let jitter = 0.03 + 0.05 * (at * 0.51).cos().abs();
        let window = [3, 5, 7, 9][run as usize % 4];
        let distances: Vec<f64> = (0..9).map(|i| 1.6 + 0.83 * f64::from(i) + 0.01 * at).collect();
        let recorded = Recorded {
            parameters: truth(bias, locking, jitter, window),
            seed: u64::from(run),
            distances_m: &distances,
            frames: 4,
            turned_deg: 0.0,
        };
        let (report, findings) = recorded.fitted(&options());
        assert!(report.passed, "{run}: {findings:?}");
        let truths = [
            ("bias", bias),
            ("pixelLocking", locking),
            ("jitter", jitter),
            ("window", f64::from(window)),
        ];
        for (count, (name, value)) in inside.iter_mut().zip(truths) {
            *count += u32::from(has(&report, name, value));
        }
        for (width, (name, _)) in widths.iter_mut().zip(truths) {
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
        widths[0] < 0.02 && widths[1] < 0.03 && widths[2] < 0.01,
        "{widths:?}"
    );
}

#[test]
fn a_focal_length_is_found_and_a_wrong_one_is_reported() {
    let distances: Vec<f64> = (0..24).map(|i| 1.2 + 0.31 * f64::from(i)).collect();
    let mut parameters = truth(-0.2, 0.13, 0.05, 7);
    parameters.stereo.focal_length_px = 788.0;
    let recorded = Recorded {
        parameters,
        seed: 3,
        distances_m: &distances,
        frames: 4,
        turned_deg: 0.0,
    };
    let free = FitOptions {
        fits_focal_length: true,
        ..options()
    };
    let (report, findings) = recorded.fitted(&free);
    assert!(report.passed, "{findings:?}");
    for (name, value) in [("focalLength", 788.0), ("bias", -0.2), ("pixelLocking", 0.13)] {
        let parameter = report.parameter(name).unwrap();
        assert!(has(&report, name, value), "{parameter:?}");
    }
    let focal = report.parameter("focalLength").unwrap().interval_95.unwrap();
    assert!(focal[1] - focal[0] < 2.0, "{focal:?}");
    let (report, findings) = recorded.fitted(&options());
    assert!(codes(&findings).contains(&"other-focal-length"), "{findings:?}");
    assert!(!report.passed);
}

#[test]
fn a_small_rotation_is_corrected_and_a_large_one_rejected() {
    let distances: Vec<f64> = (0..10).map(|i| 1.6 + 0.7 * f64::from(i)).collect();
    let recorded = |turned_deg| Recorded {
        parameters: truth(-0.2, 0.13, 0.05, 7),
        seed: 11,
        distances_m: &distances,
        frames: 4,
        turned_deg,
    };
    let (report, findings) = recorded(2.0).fitted(&options());
    assert!(
        (report.tilt_deg.unwrap() - 2.0).abs() < 0.4,
        "{:?}",
        report.tilt_deg
    );
    assert_eq!(codes(&findings), ["turned"]);
    let bias = report.parameter("bias").unwrap().value;
    let locking = report.parameter("pixelLocking").unwrap().value;
    assert!(
        (bias + 0.2).abs() < 0.01 && (locking - 0.13).abs() < 0.015,
        "{bias} {locking}"
    );
    let folder = tempfile::tempdir().unwrap();
    recorded(12.0).write(folder.path());
    let error = fitted(&[folder.path()], &options()).unwrap_err();
    assert!(
        error.contains("the target is tilted by 1") && error.contains("perpendicular"),
        "{error}"
    );
}

#[test]
fn undeterminable_parameters_are_reported() {
    let of = |distances_m: &[f64], frames, jitter| {
        let recorded = Recorded {
            parameters: truth(-0.2, 0.13, jitter, 7),
            seed: 5,
            distances_m,
            frames,
            turned_deg: 0.0,
        };
        recorded.fitted(&options())
    };
    let missing = |report: &FitReport| report.not_found.iter().map(|one| one.name).collect::<Vec<_>>();
    let (one, findings) = of(&[2.0], 4, 0.05);
    assert_eq!(missing(&one), ["bias", "pixelLocking"]);
    assert!(
        !one.passed && findings[0].message.contains("one distance"),
        "{findings:?}"
    );
    assert!(has(&one, "jitter", 0.05));
    // 60 px·m: whole disparities.
    let (phase, findings) = of(&[2.0, 3.0, 4.0, 5.0, 6.0, 10.0], 4, 0.05);
    assert_eq!(
        missing(&phase),
        ["bias", "pixelLocking"],
        "{:?}",
        phase.parameters
    );
    assert!(findings[0].message.contains("same phase"), "{findings:?}");
    let distances: Vec<f64> = (0..12).map(|i| 1.6 + 0.41 * f64::from(i)).collect();
    let (still, findings) = of(&distances, 1, 0.05);
    assert_eq!(missing(&still), ["jitter", "window"], "{findings:?}");
    let bias = still.parameter("bias").unwrap();
    assert!((bias.value + 0.2).abs() < 0.02, "{bias:?}");
    let (quiet, findings) = of(&distances, 4, 0.0);
    assert!(codes(&findings).contains(&"jitter-below-steps"), "{findings:?}");
    assert_eq!(missing(&quiet), ["window"]);
    assert!(
        has(&quiet, "bias", -0.2) && has(&quiet, "pixelLocking", 0.13),
        "{quiet:?}"
    );
}

#[test]
fn an_implausible_bias_is_reported() {
    let distances: Vec<f64> = (0..12).map(|i| 1.6 + 0.41 * f64::from(i)).collect();
    let recorded = Recorded {
        parameters: truth(-1.4, 0.1, 0.05, 7),
        seed: 5,
        distances_m: &distances,
        frames: 2,
        turned_deg: 0.0,
    };
    let (report, findings) = recorded.fitted(&options());
    assert!(
        (report.parameter("bias").unwrap().value + 1.4).abs() < 0.02,
        "{report:?}"
    );
    assert_eq!(codes(&findings), ["implausible-bias"], "{findings:?}");
}

/// Distances that are wrong by 3 %, which no bias explains.
#[test]
fn a_wrong_scale_is_reported() {
    let distances: Vec<f64> = (0..12).map(|i| 1.6 + 0.41 * f64::from(i)).collect();
    let recorded = Recorded {
        parameters: truth(0.0, 0.1, 0.05, 7),
        seed: 5,
        distances_m: &distances,
        frames: 2,
        turned_deg: 0.0,
    };
    let folder = tempfile::tempdir().unwrap();
    recorded.write(folder.path());
    let mut table = "file,distance_m\n".to_owned();
    for (number, z) in distances.iter().enumerate() {
        let _ = writeln!(table, "{number}.npy,{}", z / 1.03);
    }
    fs::write(folder.path().join(TABLE), table).unwrap();
    let (_, findings) = fitted(&[folder.path()], &options()).unwrap();
    let finding = findings
        .iter()
        .find(|finding| finding.code == "wrong-scale")
        .unwrap();
    let percent: f64 = finding
        .message
        .split_whitespace()
        .nth(5)
        .unwrap()
        .parse()
        .unwrap();
    assert!((percent - 3.0).abs() < 0.3, "{finding}");
}

/// Ground truth beside the sensor's images of a board so oblique that it spans many pixels of disparity.
#[test]
fn ground_truth_beside_the_sensors_images() {
    let engine = StereoNoise::new(truth(-0.15, 0.1, 0.05, 7)).unwrap();
    let random = Stream::new(9, "test");
    let folder = tempfile::tempdir().unwrap();
    let put = |name: &str, frame: u64, image: &Image<f32>| {
        let shape = [HEIGHT as usize, WIDTH as usize];
        let path = folder.path().join(format!("{name}_{frame:04}.npy"));
        fs::write(path, npy::encode(&shape, image.pixels()).unwrap()).unwrap();
    };
    let depth = board(3.0, 60.0);
    for frame in 0..5 {
        let mut shot = DepthShot::new((&depth).into());
        shot.frame = frame;
        put("distance_to_image_plane", frame, &depth);
        put("depth_sensor_distance", frame, &engine.sense(&shot, &random).0);
    }
    let (report, findings) = fitted(&[folder.path()], &options()).unwrap();
    assert!(report.passed, "{findings:?}");
    // Each column has its own true distance.
    assert_eq!(report.points.len(), 96);
    for (name, value) in [("bias", -0.15), ("pixelLocking", 0.1), ("jitter", 0.05)] {
        let found = report.parameter(name).unwrap().value;
        assert!((found - value).abs() < 0.005, "{name}: {found}");
    }
    assert_eq!(report.parameter("window").unwrap().value, 7.0);
    fs::remove_file(folder.path().join("distance_to_image_plane_0002.npy")).unwrap();
    for frame in 0..5 {
        let _ = fs::remove_file(
            folder
                .path()
                .join(format!("depth_sensor_distance_{frame:04}.npy")),
        );
    }
    let error = fitted(&[folder.path()], &options()).unwrap_err();
    assert!(error.contains("no output of a depth sensor"), "{error}");
}

/// The vendor's two curves, each of one device.
#[test]
#[ignore = "needs OAKTWIN_TEST_DATA"]
fn the_vendors_measured_curves() {
    let data = std::env::var_os("OAKTWIN_TEST_DATA").expect("OAKTWIN_TEST_DATA names the test data");
    let file = |name: &str| PathBuf::from(&data).join("data/accuracy").join(name);
    let of = |name: &str, width_px, focal_length_px, from_m| {
        let options = FitOptions {
            optics: MeasuredOptics {
                focal_length_px,
                width_px,
            },
            from_m,
            fits_focal_length: true,
            ..FitOptions::default()
        };
        let (report, findings) = fitted(&[&file(name)], &options).unwrap();
        println!("{name}: {:?} {:?} {findings:?}", report.parameters, report.curve);
        let value = |name: &str| report.parameter(name).unwrap().value;
        let found = [value("bias"), value("pixelLocking"), value("focalLength")];
        (found, report.curve.unwrap().r_squared.unwrap())
    };
    let ([bias, locking, focal], r2) = of("depth_error_800p_75mm_measured.csv", None, None, 2.5);
    assert!(
        (bias + 0.22).abs() < 0.02 && (locking - 0.13).abs() < 0.02,
        "{bias} {locking}"
    );
    assert!((focal - 794.0).abs() < 3.0 && r2 > 0.96, "{focal} {r2}");
    let ([bias, locking, focal], r2) = of("depth_error_480p_75mm_measured.csv", Some(640), Some(450.0), 0.0);
    assert!(
        bias.abs() < 0.02 && (locking - 0.2).abs() < 0.03,
        "{bias} {locking}"
    );
    assert!((focal - 454.0).abs() < 3.0 && r2 > 0.85, "{focal} {r2}");
}

#[test]
fn millimetres_on_few_steps_are_not_averaged_out() {
    assert!((super::rounding(0.0, 0.25, 0.0) - 0.0625 / 12.0).abs() < 1e-12);
    let coarse = super::rounding(0.05, 1.0 / 32.0, 0.06);
    assert!(coarse > 0.0 && coarse < 0.06f64.powi(2) / 12.0);
}
