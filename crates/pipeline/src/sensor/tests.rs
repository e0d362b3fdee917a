use super::*;
use oaktwin_camera::ImageSize;
use oaktwin_camera::Intrinsics;
use oaktwin_catalog::{Catalog, Role};
use oaktwin_depth::filter::Filter;
use oaktwin_depth::single_view::SingleView;
use oaktwin_depth::stereo_noise::StereoNoise;
use oaktwin_depth::time_of_flight::TimeOfFlight;
use oaktwin_depth::{stereo_noise, time_of_flight as tof};
use oaktwin_image::Image;

fn twin(model: &str) -> Twin {
    let catalog = Catalog::builtin();
    catalog.nominal(catalog.device(model).unwrap())
}

fn of(model: &str, index: usize, options: &SensorOptions) -> Result<(Sensor, Vec<Finding>), String> {
    let twin = twin(model);
    sensor(&twin, &twin.depth_sensors[index], options).map_err(|error| error.to_string())
}

fn stereo(sensor: &Sensor) -> stereo_noise::Parameters {
    *sensor
        .engine()
        .downcast_ref::<StereoNoise>()
        .unwrap()
        .parameters()
}

fn time_of_flight(sensor: &Sensor) -> tof::Parameters {
    *sensor
        .engine()
        .downcast_ref::<TimeOfFlight>()
        .unwrap()
        .parameters()
}

fn isaac(sensor: &Sensor) -> single_view::Parameters {
    *sensor.engine().downcast_ref::<SingleView>().unwrap().parameters()
}

#[test]
fn defaults_are_the_devices() {
    let options = SensorOptions::default();
    let (pro, findings) = of("OAK-D Pro PoE", 0, &options).unwrap();
    assert!(findings.is_empty() && pro.filters().is_empty());
    let p = stereo(&pro);
    assert_eq!(p.width_px, 1280);
    assert!((p.stereo.focal_length_px - 804.6).abs() < 0.1 && (p.stereo.baseline_m - 0.075).abs() < 1e-12);
    assert_eq!(p.bias_px, 0.0);
    let (tof, _) = of("OAK-D ToF", 1, &options).unwrap();
    let p = time_of_flight(&tof);
    assert_eq!((p.width_px, p.principal_point_px), (640, Some([320.0, 240.0])));
    assert!((p.focal_length_px - 457.0).abs() < 0.1, "{}", p.focal_length_px);
    let parity = SensorOptions {
        engine: Some((&SINGLE_VIEW).into()),
        ..options.clone()
    };
    let (tof, _) = of("OAK-D ToF", 1, &parity).unwrap();
    assert_eq!(isaac(&tof).baseline_mm, 0.5);
    let (near, _) = of("OAK-D ToF", 0, &options).unwrap();
    assert!((stereo(&near).stereo.baseline_m - 0.02).abs() < 1e-12);
    let wrong = |engine: &'static EngineKind, index| {
        let options = SensorOptions {
            engine: Some(engine.into()),
            ..options.clone()
        };
        of("OAK-D ToF", index, &options).unwrap_err()
    };
    assert_eq!(
        wrong(&STEREO_NOISE, 1),
        "engine: stereo-noise does not model Camera_pseudo_depth_tof, a tof sensor; use single-view, time-of-flight, or \
         choose another sensor"
    );
    assert_eq!(
        wrong(&TIME_OF_FLIGHT, 0),
        "engine: time-of-flight does not model Camera_pseudo_depth_stereo, a stereo sensor; use single-view, \
         stereo-noise, stereo-matching, or choose another sensor"
    );
}

#[test]
fn the_images_own_focal_length_is_said() {
    let image = |width: u32, fx: f64| SensorOptions {
        image: Some(Intrinsics::new(
            ImageSize::new(width, width * 5 / 8),
            fx,
            fx,
            oaktwin_camera::PixelPoint::<oaktwin_camera::Usd>::new(f64::from(width) / 2.0, 1.0),
        )),
        ..SensorOptions::default()
    };
    let own = twin("OAK-D Pro PoE").cameras[1].intrinsics.fx;
    let (same, findings) = of("OAK-D Pro PoE", 0, &image(640, own / 2.0)).unwrap();
    // Only what the size means is said.
    let codes: Vec<&str> = findings.iter().map(|finding| finding.code).collect();
    assert_eq!(codes, ["mode"]);
    assert_eq!(stereo(&same).stereo.focal_length_px, own);
    let (other, findings) = of("OAK-D Pro PoE", 0, &image(640, 300.0)).unwrap();
    assert_eq!(findings[0].code, "own-focal-length");
    assert_eq!(stereo(&other).stereo.focal_length_px, 600.0);
    let single = SensorOptions {
        engine: Some((&SINGLE_VIEW).into()),
        ..image(640, 300.0)
    };
    assert_eq!(
        isaac(&of("OAK-D Pro PoE", 0, &single).unwrap().0).focal_length_px,
        600.0
    );
    for wrong in [0.0, f64::NAN, -3.0] {
        for engine in [&SINGLE_VIEW, &STEREO_NOISE] {
            let options = SensorOptions {
                engine: Some(engine.into()),
                ..image(640, wrong)
            };
            assert!(
                of("OAK-D Pro PoE", 0, &options)
                    .unwrap_err()
                    .contains("ocalLength")
            );
        }
    }
}

#[test]
fn presets_are_the_platforms() {
    let preset = |name: &str| SensorOptions {
        preset: Some(name.to_owned()),
        ..SensorOptions::default()
    };
    let (pro, findings) = of("OAK-D Pro PoE", 0, &preset("robotics")).unwrap();
    assert_eq!(stereo(&pro).subpixel.bits(), 3);
    let names = |sensor: &Sensor| {
        sensor
            .filters()
            .filters()
            .iter()
            .map(Filter::name)
            .collect::<Vec<_>>()
    };
    assert!(names(&pro).contains(&"median"));
    assert!(
        findings[0]
            .message
            .starts_with("preset ROBOTICS: 3 subpixel bits"),
        "{findings:?}"
    );
    let (oak4, _) = of("OAK4-D", 0, &preset("default")).unwrap();
    assert!(stereo(&oak4).extended_disparity);
    assert!(
        of("OAK4-D", 0, &preset("high_density"))
            .unwrap_err()
            .contains("RVC2")
    );
    assert!(
        of("OAK-D Pro PoE", 0, &preset("robotcs"))
            .unwrap_err()
            .contains("ROBOTICS")
    );
    let (tof, _) = of("OAK-D ToF", 1, &preset("tof_mid_range")).unwrap();
    assert_eq!(names(&tof), ["temporal", "speckle", "spatial"]);
    let p = time_of_flight(&tof);
    assert_eq!(
        (p.phase_unwrap_error_threshold, p.confidence_threshold),
        (75, 0.2)
    );
    assert!(of("OAK-D ToF", 1, &preset("robotics")).is_err());
    let own = SensorOptions {
        filters: vec!["median:size=5".to_owned(), "speckle".to_owned()],
        ..preset("robotics")
    };
    assert_eq!(
        names(&of("OAK-D Pro PoE", 0, &own).unwrap().0),
        ["median", "speckle"]
    );
    let extended = SensorOptions {
        engine: Some((&SINGLE_VIEW).into()),
        ..preset("face")
    };
    assert_eq!(
        isaac(&of("OAK-D Pro PoE", 0, &extended).unwrap().0).max_disparity_px,
        191.0
    );
}

#[test]
fn parameters_by_name_belong_to_their_engine() {
    let with = |engine: &'static EngineKind, name: &str, value: &str| {
        let options = SensorOptions {
            engine: Some(engine.into()),
            parameters: vec![(name.to_owned(), value.into())],
            ..SensorOptions::default()
        };
        of("OAK-D Pro PoE", 0, &options).map(|(sensor, _)| sensor)
    };
    let (single, noise): (&'static EngineKind, &'static EngineKind) = (&SINGLE_VIEW, &STEREO_NOISE);
    assert_eq!(
        isaac(&with(single, "noise-mean", "0.5").unwrap()).noise_mean_px,
        0.5
    );
    assert_eq!(stereo(&with(noise, "JITTER", "0.1").unwrap()).jitter_px, 0.1);
    with(single, "depth", "recomputed").unwrap();
    assert_eq!(
        with(noise, "noiseMean", "0.5").unwrap_err(),
        "noiseMean: a parameter of single-view, not of stereo-noise; remove it, or choose the engine single-view"
    );
    assert!(
        with(single, "jitter", "0.5")
            .unwrap_err()
            .contains("of stereo-noise")
    );
    assert!(
        with(single, "noiseMeen", "0.5")
            .unwrap_err()
            .contains("did you mean 'noiseMean'")
    );
    for (engine, name, value) in [
        (single, "baselineMM", "0"),
        (single, "confidenceThreshold", "1.5"),
        (noise, "baseline", "0"),
        (noise, "focalLength", "nan"),
        (noise, "jitter", "much"),
    ] {
        assert!(with(engine, name, value).is_err(), "{name}={value}");
    }
}

#[test]
fn devices_differ_by_their_seed_alone() {
    let bias = |device_seed| {
        let options = SensorOptions {
            device_seed,
            ..SensorOptions::default()
        };
        stereo(&of("OAK4-D", 0, &options).unwrap().0).bias_px
    };
    assert_eq!(bias(None), 0.0);
    assert_eq!(bias(Some(3)), bias(Some(3)));
    assert_ne!(bias(Some(3)), bias(Some(4)));
}

#[test]
fn reports_parameters_of_another_processor() {
    let set = |name: &str| SensorOptions {
        engine: Some((&STEREO_MATCHING).into()),
        parameters: vec![(name.to_owned(), "20".into())],
        ..SensorOptions::default()
    };
    let of_rvc4 = set("flatnessConfidenceWeight");
    assert!(of("OAK4-D", 0, &of_rvc4).unwrap().1.is_empty());
    let (_, findings) = of("OAK-D Pro PoE", 0, &of_rvc4).unwrap();
    assert_eq!(findings.len(), 1);
    assert_eq!(findings[0].code, "other-platform");
    assert_eq!(
        findings[0].message,
        "flatnessConfidenceWeight has no effect on RVC2"
    );
    let (_, findings) = of("OAK4-D", 0, &set("horizontalPenaltyCostP1")).unwrap();
    assert_eq!(findings[0].code, "other-platform");
}

#[test]
fn rvc2_has_no_median_with_many_subpixel_bits() {
    let with = |model: &str, bits: &str| {
        let options = SensorOptions {
            filters: vec!["median:size=5".to_owned(), "speckle".to_owned()],
            parameters: vec![("subpixelFractionalBits".to_owned(), bits.into())],
            ..SensorOptions::default()
        };
        let (sensor, findings) = of(model, 0, &options).unwrap();
        let codes: Vec<&str> = findings.iter().map(|finding| finding.code).collect();
        (sensor.filters().filters().len(), codes.contains(&"median-off"))
    };
    for bits in ["4", "5"] {
        assert_eq!(with("OAK-D Pro PoE", bits), (1, true));
        assert_eq!(with("OAK4-D", bits), (2, false));
        assert_eq!(with("RealSense D455", bits), (2, false));
    }
    assert_eq!(with("OAK-D Pro PoE", "3"), (2, false));
    assert_eq!(with("OAK-D Pro PoE", "0"), (2, false));
}

#[test]
fn rvc4_is_more_accurate_at_close_range() {
    let factor = |model| {
        let sensor = of(model, 0, &SensorOptions::default()).unwrap().0;
        stereo(&sensor).close_range_factor
    };
    assert_eq!(factor("OAK4-D"), 0.75);
    assert_eq!(factor("OAK-D Pro PoE"), 1.0);
}

/// A unit whose processor uses the baseline of the design has that scale error.
#[test]
fn the_baseline_of_the_design_scales_depth() {
    let mut twin = twin("OAK-D Pro PoE");
    let pair = (Role::Left, Role::Right);
    let sense = |twin: &Twin| {
        let options = SensorOptions {
            parameters: vec![
                ("jitter".to_owned(), "0".into()),
                ("pixelLocking".to_owned(), "0".into()),
            ],
            ..SensorOptions::default()
        };
        let sensor = &twin.depth_sensors[0];
        let (mut sensor, _) = super::sensor(twin, sensor, &options).unwrap();
        let depth = Image::filled(1280, 8, 2.0);
        let capture = sensor.capture(DepthShot::new((&depth).into()), &[]).unwrap();
        f64::from(capture.distance.0.pixels()[1280 * 4 + 640])
    };
    assert!((sense(&twin) - 2.0).abs() < 0.004);
    let design = twin.baseline_m(pair).unwrap() * 1.016;
    twin.design_baselines_m.insert(pair, design);
    assert!((sense(&twin) - 2.032).abs() < 0.004);
}
