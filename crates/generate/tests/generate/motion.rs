//! Frames that take time.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::fs;

use crate::case::Case;
use oaktwin_camera::RigidTransform;
use oaktwin_camera::math::{DMat3, DQuat, DVec3};
use oaktwin_catalog::Catalog;
use oaktwin_generate::GenerateOptions;
use oaktwin_image::Image;
use oaktwin_image::annotation::{Annotator, Frame};
use oaktwin_pipeline::render::{OpenOptions, Passing, Renderer, Rig, RigSpec, SceneFile, Shutter, Twist};
use serde_json::Value;

const DRAWN: &str = "
frames = 3
scene = 'table.usda'
scene_options = { micro_texture = false }
[camera]
model = 'OAK-D Pro PoE'
cameras = 'rgb'
resolution = [160, 90]
rgb_imager = false
look_at = '/World/Table'
motion = { exposure_ms = { uniform = [4, 8] }, velocity_m_s = [{ uniform = [0.5, 1] }, 0.2, 0], \
           angular_velocity_deg_s = [0, 0, { normal = [0, 40] }] }
[output]
annotators = ['rgb', 'distance_to_image_plane']
";

const PATH: &str = "
frames = 4
frames_per_scene = 4
scene = 'table.usda'
[camera]
model = 'OAK-D Pro PoE'
cameras = 'rgb'
resolution = [64, 36]
trajectory = 'poses.tum'
motion = { exposure_ms = 10, readout_ms = 20, camera_offsets_ms = { rgb = 5 } }
[output]
annotators = ['rgb', 'distance_to_image_plane']
formats = ['tum']
";

/// A recipe, and a trajectory of three poses at 2 m/s.
fn case(recipe: &str) -> Case {
    let case = Case::new(recipe);
    let poses = "10 0 0 1.2 0 0 0 1\n10.1 0.2 0 1.2 0 0 0 1\n10.2 0.4 0 1.2 0 0 0 1\n";
    fs::write(case.folder.path().join("poses.tum"), poses).unwrap();
    case
}

fn three(value: &Value) -> DVec3 {
    DVec3::from([0, 1, 2].map(|axis| value[axis].as_f64().unwrap()))
}

/// A frame of a recipe is the frame that a rig takes with the drawn exposure, at the drawn pose and velocity.
#[test]
fn frames_are_those_of_the_rig() {
    let moving = case(DRAWN);
    let generator = moving.open().unwrap();
    let (before, after) = (
        DRAWN.split_once("motion = ").unwrap().0,
        DRAWN.split_once("[output]").unwrap().1,
    );
    let still = case(&format!("{before}[output]{after}")).open().unwrap();
    let scene = SceneFile::open(&moving.folder.path().join("table.usda"), &OpenOptions::default()).unwrap();
    let renderer = Renderer::new(scene.scene);
    let catalog = Catalog::builtin();
    let twin = catalog.nominal(catalog.device("OAK-D Pro PoE").unwrap());
    let mut exposures = Vec::new();
    let mut blurred_values = 0;
    for frame in 0..3 {
        let drawn = generator.explain(frame).unwrap();
        let (pose, motion) = (&drawn["camera"]["world_from_body"], &drawn["motion"]);
        let [x, y, z, w] = [0, 1, 2, 3].map(|index| pose["orientation"][index].as_f64().unwrap());
        let rotation = DMat3::from_quat(DQuat::from_xyzw(x, y, z, w));
        let exposure_ms = motion["exposure_ms"].as_f64().unwrap();
        exposures.push(exposure_ms);
        let spec = RigSpec {
            cameras: vec!["rgb".to_owned()],
            size: Some(oaktwin_camera::ImageSize::new(160, 90)),
            annotators: vec![Annotator::Rgb],
            shutter: Some(Shutter {
                exposure_ms,
                readout_ms: None,
            }),
            ..RigSpec::default()
        };
        let mut passing = Passing {
            renderer: &renderer,
            world_from_body: RigidTransform::new(rotation, three(&pose["position"])),
            twist: Twist {
                velocity: rotation * three(&motion["velocity_m_s"]),
                angular_velocity: three(&motion["angular_velocity_deg_s"]).map(f64::to_radians),
            },
        };
        let (mut rig, _) = Rig::new(&twin, &spec).unwrap();
        let (shots, _) = rig.expose(&mut passing, frame).unwrap();
        let expected = shots[0].frame.rgb.as_ref().unwrap();
        let [taken, moment] = [&generator, &still].map(|generator| {
            let (shots, _) = generator.sample(frame).unwrap();
            shots.into_iter().next().unwrap().frame
        });
        let colours = |frame: &Frame| frame.rgb.clone().unwrap();
        // The pose of the explanation is rounded to a quaternion.
        let differ = |a: &Image<[u8; 4]>, b: &Image<[u8; 4]>| {
            let both = a.pixels().as_flattened().iter().zip(b.pixels().as_flattened());
            both.filter(|(a, b)| a.abs_diff(**b) > 2).count()
        };
        let wrong = differ(&colours(&taken), expected);
        let blurred = differ(&colours(&taken), &colours(&moment));
        assert!(20 * wrong <= blurred, "{frame}: {wrong}, {blurred}");
        blurred_values += blurred;
        // Ground truth shows the moment.
        assert!(
            taken.distance_to_image_plane == moment.distance_to_image_plane,
            "{frame}"
        );
    }
    assert!(blurred_values > 1000, "{blurred_values}");
    assert!(exposures.iter().all(|ms| (4.0..=8.0).contains(ms)) && exposures[0] != exposures[1]);
}

#[test]
fn they_do_not_depend_on_the_order_of_frames() {
    for recipe in [DRAWN, PATH] {
        let case = case(recipe);
        case.generate("whole", &GenerateOptions::default()).unwrap();
        for frames in [2..4, 0..2] {
            let options = GenerateOptions {
                frames: Some(frames.start..frames.end.min(case.open().unwrap().frames())),
                resume: case.folder.path().join("parts").exists(),
                ..GenerateOptions::default()
            };
            case.generate("parts", &options).unwrap();
        }
        assert!(case.files("whole") == case.files("parts"));
    }
}

/// Stamps and poses belong to the middle of each camera's exposure, along a trajectory that begins again.
#[test]
fn cameras_have_their_own_times() {
    let case = case(PATH);
    case.generate("set", &GenerateOptions::default()).unwrap();
    let poses = fs::read_to_string(case.folder.path().join("set/000000/groundtruth.txt")).unwrap();
    let rows: Vec<Vec<f64>> = (poses.lines().filter(|line| !line.starts_with('#')))
        .map(|line| line.split(' ').map(|word| word.parse().unwrap()).collect())
        .collect();
    assert_eq!(rows.len(), 4);
    let start = rows[0][1];
    for (row, (time, x)) in rows
        .iter()
        .zip([(10.005, 0.0), (10.105, 0.2), (10.205, 0.4), (10.305, 0.0)])
    {
        assert!((row[0] - time).abs() < 1e-9, "{row:?}");
        assert!((row[1] - start - x).abs() < 1e-6, "{row:?}");
    }
    let at_its_time = start;
    case.write(&PATH.replace("{ rgb = 5 }", "{}"));
    case.generate("together", &GenerateOptions::default()).unwrap();
    let poses = fs::read_to_string(case.folder.path().join("together/000000/groundtruth.txt")).unwrap();
    let first = poses.lines().find(|line| !line.starts_with('#')).unwrap();
    let x: f64 = first.split(' ').nth(1).unwrap().parse().unwrap();
    assert!((at_its_time - x - 0.01).abs() < 1e-6, "2 m/s for 5 ms");
}

#[test]
fn impossible_motions_are_rejected() {
    for (recipe, from, to, expected) in [
        (
            DRAWN,
            "{ uniform = [4, 8] }",
            "-1",
            "exposure_ms: can be -1, which is out of range",
        ),
        (
            DRAWN,
            "exposure_ms = { uniform = [4, 8] }, ",
            "",
            "the key 'exposure_ms' is missing",
        ),
        (
            DRAWN,
            "0.2, 0]",
            "200, 0]",
            "velocity_m_s: can be 200, which is out of range",
        ),
        (DRAWN, "0.2, 0]", "0.2]", "expected an array of length 3"),
        (DRAWN, "velocity_m_s", "speed", "unknown key 'speed'"),
        (
            PATH,
            "exposure_ms = 10",
            "exposure_ms = 150",
            "exposes a frame for 150 ms, longer than the 100.0000 ms between frames",
        ),
        (
            PATH,
            "readout_ms = 20",
            "readout_ms = 101",
            "reads a frame for 101 ms, longer than",
        ),
        (
            PATH,
            "{ rgb = 5 }",
            "{ tof = 5 }",
            "camera.motion.camera_offsets_ms: no camera tof of the OAK-D Pro PoE is rendered; name one of rgb",
        ),
        (
            PATH,
            "{ rgb = 5 }",
            "{ rgb = -5 }",
            "rgb: can be -5, which is out of range",
        ),
        (
            PATH,
            "frames_per_scene = 4",
            "frames_per_scene = 1",
            "frames_per_scene is 1, and the trajectory has 3 poses",
        ),
        (
            PATH,
            "exposure_ms = 10",
            "exposure_ms = 10, velocity_m_s = [1, 0, 0]",
            "has a velocity, and the trajectory another one",
        ),
        (PATH, "trajectory = 'poses.tum'", "", "motion: has no velocity"),
    ] {
        assert!(recipe.contains(from), "{from}");
        let error = case(&recipe.replace(from, to)).open().map(|_| ()).unwrap_err();
        assert!(error.contains(expected), "{error}");
    }
}
