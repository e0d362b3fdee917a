use oaktwin_base::diagnostic::Level;
use oaktwin_camera::ImageSize;
use oaktwin_camera::math::{DAffine3, DVec3};
use oaktwin_catalog::{Catalog, Twin};
use oaktwin_image::Image;
use oaktwin_image::ZDepth;
use oaktwin_image::annotation::Annotator;
use oaktwin_render::Renderer;
use oaktwin_scene::{Instance, Scene, shape};

use super::*;
use crate::pair::PairOptions;
use crate::render::{Sweep, look_at};
use crate::sensor::{
    EngineKind, EngineRef, SINGLE_VIEW, STEREO_MATCHING, STEREO_NOISE, SensorOptions, TIME_OF_FLIGHT,
};

const SIZE: Option<ImageSize> = Some(ImageSize::new(320, 200));
const MEASURED: [Annotator; 2] = [Annotator::DistanceToImagePlane, Annotator::DepthSensorDistance];

fn twin(model: &str) -> Twin {
    let catalog = Catalog::builtin();
    catalog.nominal(catalog.device(model).unwrap())
}

/// A wall 2 m ahead.
fn wall() -> Renderer {
    let mut scene = Scene {
        meshes: vec![shape::plane(9.0, 9.0, shape::Axis::X)],
        ..Scene::default()
    };
    scene.instances.push(Instance {
        mesh: 0,
        path: "/Wall".to_owned(),
        world_from_mesh: DAffine3::from_translation(DVec3::new(2.0, 0.0, 0.0)),
        labels: Vec::new(),
        material_offset: 0,
    });
    Renderer::new(scene)
}

fn ahead() -> RigidTransform {
    look_at(DVec3::ZERO, DVec3::X, DVec3::Z).unwrap()
}

fn spec(engine: Option<&'static EngineKind>) -> RigSpec {
    RigSpec {
        size: SIZE,
        annotators: MEASURED.to_vec(),
        sensor: SensorOptions {
            engine: engine.map(EngineRef::from),
            // The wall has no texture.
            parameters: match engine {
                Some(kind) if *kind == TIME_OF_FLIGHT => Vec::new(),
                _ => vec![("confidenceThreshold".to_owned(), "0".into())],
            },
            ..SensorOptions::default()
        },
        ..RigSpec::default()
    }
}

#[test]
fn shoots_what_it_is_asked_for() {
    let (mut rig, findings) = Rig::new(&twin("OAK4-D"), &spec(None)).unwrap();
    assert!(findings.is_empty(), "{findings:?}");
    let (shots, findings) = rig.shoot(&wall(), Some(&ahead()), 3).unwrap();
    assert!(
        findings.iter().all(|one| one.level < Level::Error),
        "{findings:?}"
    );
    let [shot] = &shots[..] else {
        panic!("{} shots", shots.len())
    };
    let frame = &shot.frame;
    assert!(frame.rgb.is_none());
    assert_eq!(
        frame.distance_to_image_plane.as_ref().unwrap().0.get(160, 100),
        Some(&2.0)
    );
    let measured = frame.depth_sensor_distance.as_ref().unwrap().0.get(160, 100);
    assert!((measured.unwrap() - 2.0).abs() < 0.1);
    // The pose is the argument's, and a rig that was put there sees the same.
    let (again, _) = rig.at(&ahead()).shoot(&wall(), None, 3).unwrap();
    assert_eq!(again[0].frame, *frame);
}

#[test]
fn measures_foreign_images_like_its_own() {
    let of = RigSpec {
        annotators: vec![
            Annotator::Rgb,
            Annotator::DistanceToImagePlane,
            Annotator::DepthSensorDistance,
        ],
        ..spec(None)
    };
    let (mut rig, _) = Rig::new(&twin("OAK4-D"), &of).unwrap();
    let (shots, _) = rig.shoot(&wall(), Some(&ahead()), 7).unwrap();
    let frame = shots.into_iter().next().unwrap().frame;
    let depth = frame.distance_to_image_plane.unwrap();
    let measured = rig.measure(depth, frame.rgb, 7).unwrap();
    assert_eq!(measured.depth_sensor_distance, frame.depth_sensor_distance);
    let small = ZDepth(Image::filled(3, 2, 1.0));
    let error = rig.measure(small, None, 0).unwrap_err().to_string();
    assert!(error.contains("3x2") && error.contains("320x200"), "{error}");
}

#[test]
fn engines_are_of_the_technology() {
    let of = |model: &str| -> Vec<String> {
        let of = RigSpec {
            annotators: MEASURED.to_vec(),
            ..RigSpec::default()
        };
        let (rig, _) = Rig::new(&twin(model), &of).unwrap();
        let sensors = rig.sensors().iter().flatten();
        sensors.map(|sensor| sensor.engine().kind().to_string()).collect()
    };
    assert_eq!(of("OAK4-D"), ["stereo-noise"]);
    assert_eq!(of("OAK-D ToF"), ["stereo-noise", "time-of-flight"]);
}

#[test]
fn sensors_that_the_engine_does_not_model_are_left_out() {
    let twin = twin("OAK-D ToF");
    let of = |engine, cameras: &[&str]| {
        let cameras = cameras.iter().map(|name| (*name).to_owned()).collect();
        Rig::new(
            &twin,
            &RigSpec {
                cameras,
                ..spec(Some(engine))
            },
        )
    };
    let (rig, findings) = of(&TIME_OF_FLIGHT, &[]).unwrap();
    assert_eq!(rig.cameras().len(), 1);
    assert_eq!(rig.cameras()[0].path, "OAK-D ToF/Camera_pseudo_depth_tof");
    let left_out = findings
        .iter()
        .find(|finding| finding.code == "sensor-left-out")
        .unwrap();
    assert_eq!(left_out.place, "OAK-D ToF/Camera_pseudo_depth_stereo");
    assert_eq!(left_out.level, Level::Note);
    let (rig, _) = of(&STEREO_NOISE, &[]).unwrap();
    assert_eq!(rig.cameras()[0].path, "OAK-D ToF/Camera_pseudo_depth_stereo");
    let error = of(&TIME_OF_FLIGHT, &["depth"]).unwrap_err().to_string();
    assert!(
        error.contains("does not model Camera_pseudo_depth_stereo"),
        "{error}"
    );
}

#[test]
fn pairs_are_made_where_they_are_used() {
    let has_pair = |engine, pair_use, sweep: Option<&str>| {
        let of = RigSpec {
            pair_use,
            sweep: sweep.map(|axis| Sweep::parse([axis]).unwrap()),
            ..spec(engine)
        };
        Rig::new(&twin("OAK4-D"), &of).unwrap().0.pair().is_some()
    };
    assert!(!has_pair(None, PairUse::Matched, None));
    assert!(has_pair(Some(&STEREO_MATCHING), PairUse::Matched, None));
    assert!(has_pair(
        None,
        PairUse::Matched,
        Some("engine=stereo-noise,stereo-matching")
    ));
    for pair_use in [PairUse::Written, PairUse::Described, PairUse::Beside] {
        assert!(has_pair(None, pair_use, None), "{pair_use:?}");
    }
    let beside = RigSpec {
        pair_use: PairUse::Beside,
        ..RigSpec::default()
    };
    assert!(Rig::new(&twin("OAK-1"), &beside).unwrap().0.pair().is_none());
}

#[test]
fn the_projector_lights_every_engine() {
    let measured = |engine, projector| {
        let of = RigSpec {
            pair: PairOptions {
                projector,
                ambient: 0.1,
                ..PairOptions::default()
            },
            sensor: SensorOptions {
                engine: Some(EngineRef::from(engine)),
                ..SensorOptions::default()
            },
            ..spec(None)
        };
        let (mut rig, _) = Rig::new(&twin("OAK-D Pro PoE"), &of).unwrap();
        let (shots, _) = rig.shoot(&wall(), Some(&ahead()), 0).unwrap();
        let distance = shots[0].frame.depth_sensor_distance.as_ref().unwrap().0.pixels();
        let count = distance.iter().filter(|metres| **metres > 0.0).count();
        count as f64 / distance.len() as f64
    };
    // A bare wall has no texture of its own.
    for engine in [&STEREO_NOISE, &STEREO_MATCHING] {
        let (dark, lit) = (measured(engine, 0.0), measured(engine, 1.0));
        assert!(dark < 0.1 && lit > 0.6, "{engine}: {dark} and {lit}");
    }
}

#[test]
fn what_is_missing_is_an_error_with_a_remedy() {
    let error = |model: &str, spec: &RigSpec| Rig::new(&twin(model), spec).unwrap_err().to_string();
    let left = RigSpec {
        cameras: vec!["left".to_owned()],
        ..spec(None)
    };
    let tof = RigSpec {
        cameras: vec!["Camera_pseudo_depth_tof".to_owned()],
        ..spec(Some(&STEREO_NOISE))
    };
    for (found, parts) in [
        (
            error("OAK-1", &spec(None)),
            ["no depth sensor", "choose a model with one: "],
        ),
        (
            error("OAK4-D", &left),
            ["no depth sensor", "choose 'camera=depth'"],
        ),
        (
            error("OAK-D ToF", &tof),
            ["Camera_pseudo_depth_tof", "stereo-noise"],
        ),
    ] {
        assert!(parts.iter().all(|part| found.contains(part)), "{found}");
    }
    let optional = RigSpec {
        is_sensor_optional: true,
        ..left
    };
    assert!(Rig::new(&twin("OAK4-D"), &optional).is_ok());
    let bias = RigSpec {
        sweep: Some(Sweep::parse(["bias=0,0.1"]).unwrap()),
        ..spec(Some(&STEREO_MATCHING))
    };
    assert!(error("OAK4-D", &bias).contains("renders the pair once"));
    let projector = RigSpec {
        pair: PairOptions {
            projector: 1.0,
            ..PairOptions::default()
        },
        ..spec(Some(&SINGLE_VIEW))
    };
    assert!(error("OAK4-D", &projector).contains("no dot projector"));
}

#[test]
fn each_camera_can_be_a_rig_of_its_own() {
    let of = RigSpec {
        cameras: ["depth", "left"].map(str::to_owned).to_vec(),
        annotators: MEASURED.to_vec(),
        ..RigSpec::default()
    };
    let (rig, findings) = Rig::new(&twin("OAK-D ToF"), &of).unwrap();
    assert_eq!(
        findings
            .iter()
            .filter(|one| one.code == "no-depth-sensor")
            .count(),
        1
    );
    let names: Vec<String> = rig.split().iter().map(|rig| rig.name().to_owned()).collect();
    assert_eq!(
        names,
        [
            "OAK-D ToF/Camera_pseudo_depth_stereo",
            "OAK-D ToF/Camera_pseudo_depth_tof"
        ]
    );
}
