//! The example of an engine that another crate declares: a rig, filters, accuracy and coverage with it.

#![expect(clippy::unwrap_used, reason = "a test")]

#[path = "../../../../examples/custom_engine/src/main.rs"]
#[allow(
    clippy::all,
    clippy::cast_possible_truncation,
    clippy::expect_used,
    clippy::print_stdout,
    dead_code,
    missing_docs,
    unreachable_pub,
    reason = "the code of an example, which has no lints of its own"
)]
mod example;

use std::ops::ControlFlow;
use std::path::Path;

use oaktwin::accuracy::{AccuracyOptions, Bench, MeasuredOptics};
use oaktwin::coverage::{self, Candidate, MeasuringRig, Region};
use oaktwin::parameter::ParameterError;
use oaktwin::prelude::*;

use example::BLOCK_MATCHING;

fn twin() -> Twin {
    Catalog::builtin().twin("OAK-D Pro PoE").unwrap()
}

fn sensor(parameters: &[(&str, &str)], filters: &[&str]) -> SensorOptions {
    let owned = |(name, value): &(&str, &str)| ((*name).to_owned(), (*value).into());
    SensorOptions {
        engine: Some((&BLOCK_MATCHING).into()),
        parameters: parameters.iter().map(owned).collect(),
        filters: filters.iter().map(|filter| (*filter).to_owned()).collect(),
        ..SensorOptions::default()
    }
}

fn spec(sensor: SensorOptions) -> RigSpec {
    RigSpec {
        size: Some(ImageSize::new(640, 400)),
        annotators: vec![Annotator::DistanceToImagePlane, Annotator::DepthSensorDistance],
        sensor,
        ..RigSpec::default()
    }
}

/// The room of the example `depth_sensor`, and the pose of its camera.
fn room() -> (Renderer, RigidTransform) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/depth_sensor/depth_sensor.usda");
    // The cubes of the room are plain.
    let options = OpenOptions {
        micro_texture: true,
        ..OpenOptions::default()
    };
    let scene = SceneFile::open(&path, &options).unwrap();
    let eye = DVec3::new(3.0, 0.0, 0.6);
    let pose = look_at(eye, eye - DVec3::X, DVec3::Z).unwrap();
    (Renderer::new(scene.scene), pose)
}

#[test]
fn another_crates_engine_measures_a_scene() {
    let (renderer, pose) = room();
    let median_error = |filters: &[&str]| {
        let spec = spec(sensor(&[("maxDisparity", "40")], filters));
        let (mut rig, findings) = Rig::new(&twin(), &spec).unwrap();
        assert!(
            findings.iter().all(|one| one.level < Level::Warning),
            "{findings:?}"
        );
        let (shots, _) = rig.shoot(&renderer, Some(&pose), 0).unwrap();
        let frame = &shots[0].frame;
        let truth = frame.distance_to_image_plane.as_ref().unwrap().0.pixels();
        let measured = frame.depth_sensor_distance.as_ref().unwrap().0.pixels();
        let both = truth.iter().zip(measured).filter(|(_, z)| **z > 0.0);
        let mut errors: Vec<f32> = both.map(|(truth, z)| (z / truth - 1.0).abs()).collect();
        assert!(errors.len() > measured.len() / 2, "{} pixels", errors.len());
        errors.sort_by(f32::total_cmp);
        errors[errors.len() / 2]
    };
    // Half a pixel of about four.
    for filters in [&[][..], &["median:kernel=KERNEL_5x5", "speckle"]] {
        let error = median_error(filters);
        assert!(error < 0.13, "{filters:?}: {error}");
    }
}

#[test]
fn accuracy_and_coverage_take_another_crates_engine() {
    let options = AccuracyOptions {
        engine: sensor(&[("maxDisparity", "30")], &[]),
        optics: MeasuredOptics {
            width_px: Some(320),
            ..MeasuredOptics::default()
        },
        distances_m: Some(vec![1.0]),
        captures: 1,
        devices: Some(1),
        ..AccuracyOptions::default()
    };
    let (bench, _) = Bench::new(&twin(), &options).unwrap();
    let go_on = |_| ControlFlow::Continue(());
    let measured = bench.measure(None, &go_on).unwrap();
    let report = measured.report();
    assert_eq!(report.engine, "block-matching");
    // Whole pixels of about 15.
    let error = report.distances[0].reading.error_percent.unwrap();
    assert!(error.abs() < 3.5, "{error} %");

    let (renderer, pose) = room();
    let spec = spec(sensor(&[("maxDisparity", "40")], &[]));
    let (rig, _) = MeasuringRig::new(&twin(), None, None, &spec).unwrap();
    let candidates = [Candidate::new(&rig, "here", pose)];
    let samples = coverage::CoverageOptions {
        samples: 500,
        ..coverage::CoverageOptions::default()
    };
    let found = coverage::measure(&renderer, &Region::default(), &candidates, &samples, &go_on).unwrap();
    let shares = &found.candidates[0].shares;
    assert!(
        shares.measured > 0.5 * shares.seen && shares.seen > 0.005,
        "{shares:?}"
    );
}

#[test]
fn mistakes_are_errors() {
    let error = |sensor: SensorOptions| Rig::new(&twin(), &spec(sensor)).unwrap_err().to_string();
    let unknown = error(sensor(&[("radiuss", "3")], &[]));
    assert!(
        unknown.contains("unknown parameter of block-matching") && unknown.contains("radius"),
        "{unknown}"
    );
    let foreign = error(sensor(&[("jitter", "0")], &[]));
    assert!(
        foreign.contains("a parameter of stereo-noise, not of block-matching"),
        "{foreign}"
    );
    let wide = error(sensor(&[("radius", "99")], &[]));
    assert!(wide.contains("99 is out of range"), "{wide}");

    let twice = EngineKind {
        name: "Stereo_Noise".into(),
        ..BLOCK_MATCHING.clone()
    };
    let twice = error(SensorOptions {
        engine: Some(twice.into()),
        ..SensorOptions::default()
    });
    assert!(twice.contains("already an engine named Stereo_Noise"), "{twice}");

    let mut rig = Rig::new(&twin(), &spec(sensor(&[], &[]))).unwrap().0;
    let depth = ZDepth(Image::filled(640, 400, 2.0));
    let error: ParameterError = match rig.measure(depth, None, 0) {
        Err(oaktwin::render::RigError::Parameter(error)) => error,
        other => panic!("{other:?}"),
    };
    assert!(error.what.contains("requires a stereo pair"), "{error}");
}
