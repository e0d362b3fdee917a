use std::ops::ControlFlow;
use std::path::PathBuf;

use super::*;
use oaktwin_catalog::Catalog;
use oaktwin_pipeline::sensor::{SINGLE_VIEW, STEREO_MATCHING, SensorOptions};

fn bench(model: &str, options: &AccuracyOptions) -> Bench {
    let catalog = Catalog::builtin();
    let twin = catalog.nominal(catalog.device(model).unwrap());
    Bench::new(&twin, options).unwrap().0
}

fn measured(model: &str, options: &AccuracyOptions) -> AccuracyReport {
    bench(model, options)
        .measure(None, &|_| ControlFlow::Continue(()))
        .unwrap()
        .report()
        .clone()
}

fn with_parameters(parameters: &[(&str, &str)]) -> SensorOptions {
    SensorOptions {
        parameters: parameters
            .iter()
            .map(|(a, b)| ((*a).to_owned(), (*b).into()))
            .collect(),
        ..SensorOptions::default()
    }
}

fn matching(parameters: &[(&str, &str)]) -> SensorOptions {
    SensorOptions {
        engine: Some((&STEREO_MATCHING).into()),
        ..with_parameters(parameters)
    }
}

/// Returns the R² between a twin that has a unit's optics and the measurements of that unit.
fn r_squared_of(file: &str, engine: SensorOptions, optics: MeasuredOptics, from_m: f64) -> f64 {
    let data = std::env::var_os("OAKTWIN_TEST_DATA").expect("OAKTWIN_TEST_DATA names the test data");
    let path = PathBuf::from(data).join("data/accuracy").join(file);
    let curve = measured::read(&path).unwrap();
    assert!(curve.is_absolute);
    let options = AccuracyOptions {
        engine,
        distances_m: Some(vec![3.0]),
        captures: 2,
        optics,
        from_m,
        ..AccuracyOptions::default()
    };
    let measurement = bench("oak-d-pro-poe", &options)
        .measure(Some((&path, &curve)), &|_| ControlFlow::Continue(()))
        .unwrap();
    let comparison = measurement.report().measured.clone().unwrap();
    assert_eq!(measurement.report().devices, Devices::AsGiven);
    println!(
        "{file}: {:?} over {}",
        comparison.r_squared, comparison.compared_points
    );
    comparison.r_squared.unwrap()
}

#[test]
#[ignore = "needs OAKTWIN_TEST_DATA"]
fn agrees_with_the_vendors_measured_curve_at_800p() {
    let optics = MeasuredOptics {
        focal_length_px: Some(794.0),
        width_px: None,
    };
    let curve = "depth_error_800p_75mm_measured.csv";
    let noise = with_parameters(&[("bias", "-0.22"), ("pixelLocking", "0.13")]);
    let r2 = r_squared_of(curve, noise, optics, 2.5);
    assert!(r2 >= 0.95, "{r2}");
    // The matcher has no pixel-locking parameter. Its board was chosen to fit this curve.
    let r2 = r_squared_of(curve, matching(&[("bias", "-0.22")]), optics, 2.5);
    assert!(r2 >= 0.9, "{r2}");
}

#[test]
#[ignore = "needs OAKTWIN_TEST_DATA"]
fn agrees_with_the_vendors_measured_curve_at_480p() {
    let optics = MeasuredOptics {
        focal_length_px: Some(454.0),
        width_px: Some(640),
    };
    let curve = "depth_error_480p_75mm_measured.csv";
    let r2 = r_squared_of(curve, with_parameters(&[("bias", "0")]), optics, 0.0);
    assert!(r2 >= 0.85, "{r2}");
    // The board was not chosen to fit this curve.
    let r2 = r_squared_of(curve, matching(&[("bias", "0")]), optics, 0.0);
    assert!(r2 >= 0.3, "{r2}");
}

/// The distances cover every band and every phase of the periodic error.
#[test]
fn the_median_device_is_within_the_bands() {
    for model in ["oak-d-pro-poe", "oak-d-pro-w-poe", "oak4-d", "oak4-d-wide"] {
        let options = AccuracyOptions {
            distances_m: Some(vec![0.7, 1.53, 3.07, 3.41, 3.96, 4.7, 6.4, 6.9, 7.97, 8.2, 8.9]),
            captures: 1,
            ..AccuracyOptions::default()
        };
        let report = measured(model, &options);
        assert_eq!(report.devices, Devices::Population { count: 200 });
        for row in &report.distances {
            assert_eq!(row.verdict, Verdict::Inside, "{model}: {row:?}");
            let [low, high] = row.reading.error_quartiles_percent.unwrap();
            let middle = row.reading.error_percent.unwrap();
            assert!(low <= middle && middle <= high);
        }
        assert!(report.passed);
        assert_eq!(
            report.published.unwrap().source == oaktwin_catalog::Source::Estimate,
            model == "oak4-d-wide"
        );
    }
}

/// On its own, a bias of β px causes a relative error of z β / (f b), up to the disparity step of 1/32 px.
#[test]
fn bias_matches_the_closed_form() {
    let options = AccuracyOptions {
        engine: with_parameters(&[("bias", "-0.25"), ("pixelLocking", "0"), ("jitter", "0")]),
        distances_m: Some(vec![2.0, 5.0, 9.0]),
        captures: 2,
        ..AccuracyOptions::default()
    };
    let report = measured("oak4-d", &options);
    for row in &report.distances {
        let disparity = report.disparity_times_depth_px_m / row.distance_m;
        let expected = (disparity / (disparity - 0.25) - 1.0) * 100.0;
        let step = 100.0 / 64.0 / disparity + 0.05;
        let error = row.reading.error_percent.unwrap();
        assert!((error - expected).abs() < step, "{row:?} {expected}");
        assert_eq!(row.reading.temporal_noise_mm, Some(0.0));
        assert_eq!(row.reading.precision_mm, Some(0.0));
    }
    assert_eq!(report.protocol_deviations, ["2 captures instead of 10"]);
}

/// Jitter appears as temporal noise and as plane-fit RMS in pixels.
#[test]
fn recovers_the_jitter() {
    let options = AccuracyOptions {
        engine: with_parameters(&[("bias", "0"), ("pixelLocking", "0"), ("jitter", "0.2")]),
        distances_m: Some(vec![4.0]),
        captures: 40,
        region: 0.1,
        ..AccuracyOptions::default()
    };
    let report = measured("oak4-d", &options);
    let row = &report.distances[0];
    let rms = row.reading.subpixel_rms_px.unwrap();
    assert!((rms - 0.2).abs() < 0.02, "{row:?}");
    let millimetres = 0.2 * 16.0 / report.disparity_times_depth_px_m * 1e3;
    let temporal = row.reading.temporal_noise_mm.unwrap();
    assert!(
        (temporal / millimetres - 1.0).abs() < 0.1,
        "{temporal} {millimetres}"
    );
}

/// A time-of-flight camera described as stereo is exact if the depth is carried along and useless if it is recomputed from the
/// disparity.
#[test]
fn both_readings_of_the_time_of_flight_parameters() {
    let options = AccuracyOptions {
        distances_m: Some(vec![0.2, 5.0]),
        engine: SensorOptions {
            engine: Some((&SINGLE_VIEW).into()),
            ..SensorOptions::default()
        },
        ..AccuracyOptions::default()
    };
    let report = measured("oak-d-tof", &options);
    assert_eq!(report.carries_depth, Some(true));
    for row in &report.distances {
        assert!(row.reading.error_percent.unwrap().abs() < 1e-4);
        assert_eq!(
            (row.verdict, row.other_verdict()),
            (Verdict::Inside, Some(Verdict::Outside))
        );
        assert_eq!(row.bands.len(), 2);
    }
    let [near, far] = [&report.distances[0], &report.distances[1]];
    assert!((near.jitter_percent_of_disparity.unwrap() - 8.75).abs() < 0.01);
    assert!((far.jitter_percent_of_disparity.unwrap() - 218.8).abs() < 0.1);
    // The noise is so large that about half of the normal distribution lies more than half a step below 0 px.
    assert!(near.invalid_if_recomputed.unwrap() < 1e-9);
    assert!((far.invalid_if_recomputed.unwrap() - 0.5).abs() < 0.1, "{far:?}");

    let recomputed = AccuracyOptions {
        engine: SensorOptions {
            engine: Some((&SINGLE_VIEW).into()),
            ..with_parameters(&[("depth", "recomputed")])
        },
        ..options
    };
    let report = measured("oak-d-tof", &recomputed);
    assert_eq!(report.carries_depth, Some(false));
    assert_eq!(Some(&report.distances[1].reading), far.other_reading.as_ref());
    assert!(!report.passed);
}

#[test]
fn time_of_flight_is_within_its_bands() {
    let options = AccuracyOptions {
        distances_m: Some(vec![0.25, 1.0, 2.5, 5.0]),
        devices: Some(5),
        ..AccuracyOptions::default()
    };
    let report = measured("oak-d-tof", &options);
    assert_eq!((&*report.engine, report.carries_depth), ("time-of-flight", None));
    for row in &report.distances {
        assert_eq!(row.verdict, Verdict::Inside, "{row:?}");
    }
    assert!(report.passed);
}

#[test]
fn selects_the_requested_devices() {
    let devices = |options: &AccuracyOptions| bench("oak4-d", options).report.devices;
    let seeded = SensorOptions {
        device_seed: Some(7),
        ..SensorOptions::default()
    };
    let with = |engine: SensorOptions, devices: Option<u32>| AccuracyOptions {
        engine,
        devices,
        ..AccuracyOptions::default()
    };
    assert_eq!(
        devices(&AccuracyOptions::default()),
        Devices::Population { count: 200 }
    );
    assert_eq!(
        devices(&with(SensorOptions::default(), Some(30))),
        Devices::Population { count: 30 }
    );
    assert_eq!(
        devices(&with(SensorOptions::default(), Some(1))),
        Devices::One { device_seed: 0 }
    );
    assert_eq!(devices(&with(seeded, None)), Devices::One { device_seed: 7 });
    assert_eq!(
        devices(&with(with_parameters(&[("bias", "0.1")]), None)),
        Devices::AsGiven
    );
}

#[test]
fn result_does_not_depend_on_the_thread_count() {
    let options = AccuracyOptions {
        distances_m: Some(vec![1.0, 4.0]),
        devices: Some(5),
        captures: 2,
        ..AccuracyOptions::default()
    };
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        pool.install(|| measured("oak-d-pro-w-poe", &options))
    };
    let one = on(1);
    assert_eq!(one, on(2));
    assert_eq!(one, on(7));
}

#[test]
fn nothing_is_measured_at_close_range() {
    let options = AccuracyOptions {
        distances_m: Some(vec![0.2, 0.5]),
        devices: Some(3),
        ..AccuracyOptions::default()
    };
    let report = measured("oak4-d", &options);
    assert!(
        report
            .distances
            .iter()
            .all(|row| row.verdict == Verdict::NothingMeasured)
    );
    assert!(report.distances.iter().all(|row| row.reading.fill_rate == 0.0));
    assert!(!report.passed);
}

#[test]
fn rejects_invalid_options() {
    let catalog = Catalog::builtin();
    let twin = catalog.nominal(catalog.device("oak-d-tof").unwrap());
    let error = |change: &dyn Fn(&mut AccuracyOptions)| {
        let mut options = AccuracyOptions::default();
        change(&mut options);
        Bench::new(&twin, &options).unwrap_err().to_string()
    };
    assert!(error(&|o| o.captures = 0).contains("captures"));
    assert!(error(&|o| o.devices = Some(0)).contains("devices"));
    assert!(error(&|o| o.region = f64::NAN).contains("region"));
    assert!(error(&|o| o.from_m = -1.0).contains("from"));
    assert!(error(&|o| o.distances_m = Some(vec![1.0, f64::NAN])).contains("NaN"));
    assert!(error(&|o| o.sensor = Some("steroe".to_owned())).contains("did you mean 'stereo'?"));
    let stereo = AccuracyOptions {
        sensor: Some("stereo".to_owned()),
        ..AccuracyOptions::default()
    };
    assert_eq!(Bench::new(&twin, &stereo).unwrap().0.report.published, None);
}

fn drifted(engine: &SensorOptions, drift: &str) -> SensorOptions {
    SensorOptions {
        drift: Some(oaktwin_camera::StereoDrift::parse(drift).unwrap()),
        ..engine.clone()
    }
}

/// A yaw adds f·yaw to disparity, and a longer baseline or focal length scales it, whichever engine measures.
#[test]
fn drift_has_the_errors_of_its_closed_forms() {
    let depth = with_parameters(&[("pixelLocking", "0"), ("jitter", "0"), ("bias", "0")]);
    for (engine, within) in [(depth, 0.1), (matching(&[("bias", "0")]), 0.6)] {
        for (drift, disparity) in [
            ("yaw=0.5", (1.0, 0.5e-3)),
            ("yaw=-0.5", (1.0, -0.5e-3)),
            ("baseline=750", (1.01, 0.0)),
            ("focalLength=10000", (1.01, 0.0)),
        ] {
            let options = AccuracyOptions {
                engine: drifted(&engine, drift),
                distances_m: Some(vec![2.0]),
                devices: Some(1),
                captures: 2,
                ..AccuracyOptions::default()
            };
            let report = measured("oak-d-pro-poe", &options);
            // In units of the focal length, the disparity at 2 m is b/z.
            let true_disparity = 0.075 / 2.0;
            let expected = true_disparity / (true_disparity * disparity.0 + disparity.1) - 1.0;
            let found = report.distances[0].reading.error_percent.unwrap();
            assert!(
                (found - expected * 100.0).abs() < within,
                "{} {drift}: {found} is not {}",
                report.engine,
                expected * 100.0
            );
        }
    }
}

#[test]
fn pitch_costs_density() {
    let fill = |engine: &SensorOptions, drift: &str| {
        let options = AccuracyOptions {
            engine: drifted(engine, drift),
            distances_m: Some(vec![2.0]),
            devices: Some(1),
            captures: 1,
            ..AccuracyOptions::default()
        };
        measured("oak-d-pro-poe", &options).distances[0].reading.fill_rate
    };
    let engine = SensorOptions::default();
    assert!(fill(&engine, "pitch=0.1") > 0.99);
    let lost = 1.0 - fill(&engine, "pitch=4");
    assert!((0.35..0.6).contains(&lost), "{lost}");
    // The board has more detail than a room, so that the matcher loses less of it.
    let matcher = matching(&[]);
    assert!(fill(&matcher, "pitch=8") < fill(&matcher, "") - 0.05);
}

#[test]
fn a_population_has_a_range_that_grows_with_drift() {
    let range = |drift: &str| {
        let options = AccuracyOptions {
            engine: drifted(&SensorOptions::default(), drift),
            population: true,
            devices: Some(60),
            distances_m: Some(vec![1.0, 4.0]),
            captures: 1,
            ..AccuracyOptions::default()
        };
        let report = measured("oak-d-pro-poe", &options);
        assert_eq!(report.devices, Devices::Factory { count: 60 });
        [0, 1].map(|row| report.distances[row].reading.error_5_to_95_percent.unwrap())
    };
    let [near, far] = range("");
    let [drifted_near, drifted_far] = range("yaw=0.5");
    assert!(near[0] < near[1] && far[1] > near[1]);
    assert!(
        drifted_near[1] > 1.3 * near[1] && drifted_far[1] > 1.3 * far[1],
        "{drifted_far:?} {far:?}"
    );
    // Of 60 normal yaws of 0.5 mrad, 95 % are below 1 mrad: 0.8 px of 15.1 px at 4 m.
    assert!((3.0..8.5).contains(&drifted_far[1]), "{drifted_far:?}");
}
