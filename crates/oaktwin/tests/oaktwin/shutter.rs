//! Closed forms of edges in motion.

#![expect(clippy::unwrap_used, reason = "a test")]

use oaktwin::camera::math::{DAffine3, DVec3};
use oaktwin::camera::{ImageSize, RigidTransform, Usd};
use oaktwin::catalog::{Catalog, Twin};
use oaktwin::image::annotation::{Annotator, Frame};
use oaktwin::render::{Passing, Renderer, Rig, RigSpec, Shutter, Twist, look_at};
use oaktwin::scene::{Instance, Scene, shape};

const SIZE: ImageSize = ImageSize::new(480, 270);
const DISTANCE_M: f64 = 2.0;

fn twin() -> Twin {
    let catalog = Catalog::builtin();
    catalog.nominal(catalog.device("OAK-D Pro PoE").unwrap())
}

fn rig(camera: &str, shutter: Option<Shutter>) -> Rig {
    let spec = RigSpec {
        cameras: vec![camera.to_owned()],
        size: Some(SIZE),
        annotators: vec![Annotator::Rgb, Annotator::DistanceToImagePlane],
        shutter,
        ..RigSpec::default()
    };
    Rig::new(&twin(), &spec).unwrap().0
}

/// A plate 2 m ahead, between two y coordinates, before nothing.
fn plate(right_m: f64, left_m: f64) -> Renderer {
    let mut scene = Scene {
        meshes: vec![shape::plane(20.0, left_m - right_m, shape::Axis::X)],
        ..Scene::default()
    };
    scene.instances.push(Instance {
        mesh: 0,
        path: "/Plate".to_owned(),
        world_from_mesh: DAffine3::from_translation(DVec3::new(
            DISTANCE_M,
            f64::midpoint(left_m, right_m),
            0.0,
        )),
        labels: Vec::new(),
        material_offset: 0,
    });
    Renderer::new(scene)
}

fn exposed(rig: &mut Rig, renderer: &Renderer, twist: Twist) -> Frame {
    let mut passing = Passing {
        renderer,
        world_from_body: look_at(DVec3::ZERO, DVec3::X, DVec3::Z).unwrap(),
        twist,
    };
    let (shots, _) = rig.expose(&mut passing, 0).unwrap();
    shots.into_iter().next().unwrap().frame
}

/// The coverage of the pixels of a row, 0 to 1.
fn coverage(frame: &Frame, row: u32) -> Vec<f64> {
    let rgb = frame.rgb.as_ref().unwrap();
    let pixels = (0..rgb.width()).map(|x| rgb.get(x, row).unwrap());
    pixels.map(|[_, _, _, alpha]| f64::from(*alpha) / 255.0).collect()
}

/// Where the image shows the plate's edge at y = 0, at an angle of yaw: the horizontal pixel coordinate.
fn edge_px(rig: &Rig, yaw: f64) -> f64 {
    let camera = &rig.cameras()[0];
    let at = camera.mount_from_camera.translation;
    let (ahead, left) = (DISTANCE_M * yaw.cos() - at.x, -DISTANCE_M * yaw.sin() - at.y);
    let intrinsics = camera.camera.intrinsics;
    intrinsics.principal_point::<Usd>().x - intrinsics.fx * left / ahead
}

#[test]
fn a_rolling_sensor_skews_an_edge_under_yaw() {
    let yaw_rate = 60f64.to_radians();
    let twist = Twist {
        angular_velocity: DVec3::new(0.0, 0.0, yaw_rate),
        ..Twist::default()
    };
    let scene = plate(0.0, 20.0);
    for (exposure_ms, readout_ms) in [(0.0, None), (4.0, None), (0.0, Some(12.0))] {
        let shutter = Shutter {
            exposure_ms,
            readout_ms,
        };
        let mut rig = rig("rgb", Some(shutter));
        let readout_s = readout_ms.unwrap_or(23.8) * 1e-3;
        let frame = exposed(&mut rig, &scene, twist);
        for row in 0..SIZE.height {
            let time_s = ((f64::from(row) + 0.5) / f64::from(SIZE.height) - 0.5) * readout_s;
            let expected = edge_px(&rig, yaw_rate * time_s);
            let seen: f64 = coverage(&frame, row).iter().sum();
            assert!(
                (seen - expected).abs() < 1.1,
                "row {row}: {seen} instead of {expected}"
            );
        }
        // From the first row to the last, the edge moves by more than ten pixels.
        let skew: f64 =
            coverage(&frame, SIZE.height - 1).iter().sum::<f64>() - coverage(&frame, 0).iter().sum::<f64>();
        let expected = edge_px(&rig, yaw_rate * readout_s / 2.0) - edge_px(&rig, -yaw_rate * readout_s / 2.0);
        assert!((skew - expected).abs() < 1.5, "{skew} instead of {expected}");
        if readout_ms.is_none() {
            assert!(skew > 5.0, "{skew}");
        }
    }
}

#[test]
fn exposure_blurs_a_rod_by_its_way() {
    // A rod of 60 mm that passes at 3 m/s.
    let (width_m, speed) = (0.06, 3.0);
    let scene = plate(-width_m / 2.0, width_m / 2.0);
    let twist = Twist {
        velocity: DVec3::new(0.0, speed, 0.0),
        ..Twist::default()
    };
    for exposure_ms in [5.0, 20.0] {
        let shutter = Shutter {
            exposure_ms,
            readout_ms: None,
        };
        let mut rig = rig("left", Some(shutter));
        let frame = exposed(&mut rig, &scene, twist);
        let fx = rig.cameras()[0].camera.intrinsics.fx;
        let way = fx * speed * exposure_ms * 1e-3 / DISTANCE_M;
        let width = fx * width_m / DISTANCE_M;
        let row = coverage(&frame, 100);
        // What is covered at all, what is always covered, and how much light the rod sends are the closed forms of a moving box.
        let touched = row.iter().filter(|share| **share > 0.0).count() as f64;
        let most = row.iter().fold(0.0, |most: f64, share| most.max(*share));
        let light: f64 = row.iter().sum();
        assert!((touched - (width + way)).abs() < 2.0, "{touched}: {width} {way}");
        assert!(
            (most - (width / way).min(1.0)).abs() < 0.06,
            "{most}: {width} {way}"
        );
        // The edges are ramps, also where the rod moves several pixels between samples.
        let rises = row.windows(2).map(|pair| (pair[1] - pair[0]).abs());
        let steepest = rises.fold(0.0, f64::max);
        assert!(steepest < 2.0 / way + 0.06, "{steepest}: {way}");
        assert!((light - width).abs() < 0.6, "{light}: {width}");
        // A global shutter: all rows are equal.
        assert_eq!(row, coverage(&frame, 0));
        assert_eq!(row, coverage(&frame, SIZE.height - 1));
    }
}

#[test]
fn a_moving_rod_is_blurred_alike_in_both_images_of_a_pair() {
    let (width_m, speed, exposure_ms) = (0.3, 3.0, 20.0);
    let spec = RigSpec {
        cameras: vec!["left".to_owned(), "right".to_owned()],
        size: Some(SIZE),
        annotators: vec![Annotator::Rgb],
        shutter: Some(Shutter {
            exposure_ms,
            readout_ms: None,
        }),
        ..RigSpec::default()
    };
    let mut rig = Rig::new(&twin(), &spec).unwrap().0;
    let renderer = plate(-width_m / 2.0, width_m / 2.0);
    let mut passing = Passing {
        renderer: &renderer,
        world_from_body: look_at(DVec3::ZERO, DVec3::X, DVec3::Z).unwrap(),
        twist: Twist {
            velocity: DVec3::new(0.0, speed, 0.0),
            ..Twist::default()
        },
    };
    let (shots, _) = rig.expose(&mut passing, 0).unwrap();
    // The coverage of a row, its mean place and its standard deviation, in pixels.
    let [left, right] = [0, 1].map(|index| {
        let row = coverage(&shots[index].frame, 100);
        let sum: f64 = row.iter().sum();
        let moment = |power: i32, centre: f64| {
            let parts = row.iter().zip(0u32..);
            let parts = parts.map(|(share, x)| share * (f64::from(x) + 0.5 - centre).powi(power));
            parts.sum::<f64>() / sum
        };
        let mean = moment(1, 0.0);
        (sum, mean, moment(2, mean).sqrt())
    });
    let cameras = rig.cameras();
    let fx = cameras[0].camera.intrinsics.fx;
    let [a, b] = [0, 1].map(|index: usize| cameras[index].mount_from_camera.translation);
    let disparity = fx * (a.y - b.y) / DISTANCE_M;
    let centres = [0, 1].map(|index: usize| cameras[index].camera.intrinsics.principal_point::<Usd>().x);
    let found = (left.1 - centres[0]) - (right.1 - centres[1]);
    assert!(
        disparity > 5.0 && (found - disparity).abs() < 0.1,
        "{found}: {disparity}"
    );
    // A box blurred by its way.
    let (width, way) = (
        fx * width_m / DISTANCE_M,
        fx * speed * exposure_ms * 1e-3 / DISTANCE_M,
    );
    let expected = ((width * width + way * way) / 12.0).sqrt();
    for (sum, _, spread) in [left, right] {
        assert!((sum - width).abs() < 0.6, "{sum}: {width}");
        assert!((spread - expected).abs() < 0.25, "{spread}: {expected}");
    }
    assert!((left.2 - right.2).abs() < 0.1, "{left:?} {right:?}");
}

#[test]
fn a_frame_without_motion_is_that_of_a_moment() {
    let scene = plate(0.0, 0.5);
    let shutter = Shutter {
        exposure_ms: 10.0,
        readout_ms: None,
    };
    for camera in ["rgb", "left"] {
        let still = exposed(&mut rig(camera, None), &scene, Twist::default());
        let taken = exposed(&mut rig(camera, Some(shutter)), &scene, Twist::default());
        assert_eq!(still, taken, "{camera}");
    }
}

#[test]
fn ground_truth_is_of_the_middle_of_the_exposure() {
    let scene = plate(0.0, 0.5);
    let shutter = Shutter {
        exposure_ms: 10.0,
        readout_ms: None,
    };
    let twist = Twist {
        velocity: DVec3::new(1.0, 2.0, 0.0),
        ..Twist::default()
    };
    let still = exposed(&mut rig("rgb", None), &scene, twist);
    let taken = exposed(&mut rig("rgb", Some(shutter)), &scene, twist);
    assert_eq!(still.distance_to_image_plane, taken.distance_to_image_plane);
    assert_ne!(still.rgb, taken.rgb);
    let again = exposed(&mut rig("rgb", Some(shutter)), &scene, twist);
    assert_eq!(taken.rgb, again.rgb);
}

#[test]
fn rejects_times_that_no_camera_has() {
    let spec = |exposure_ms, readout_ms| RigSpec {
        shutter: Some(Shutter {
            exposure_ms,
            readout_ms,
        }),
        ..RigSpec::default()
    };
    for (exposure_ms, readout_ms, part) in [
        (-1.0, None, "'exposure': -1 ms is out of range"),
        (f64::NAN, None, "'exposure': NaN ms"),
        (f64::INFINITY, None, "'exposure': inf ms"),
        (1.0, Some(-2.0), "'readout': -2 ms"),
        (1.0, Some(f64::NAN), "'readout': NaN ms"),
    ] {
        let error = Rig::new(&twin(), &spec(exposure_ms, readout_ms))
            .unwrap_err()
            .to_string();
        assert!(error.contains(part) && error.contains("give 0 to"), "{error}");
    }
    let rig = rig("rgb", None);
    let camera = &rig.cameras()[0];
    let error = |exposure_ms, readout_ms| {
        let shutter = Shutter {
            exposure_ms,
            readout_ms,
        };
        shutter.check_period(camera, 1.0 / 30.0).unwrap_err().to_string()
    };
    assert!(error(40.0, None).contains("40 ms is longer than the frame period of 33.3333 ms"));
    assert!(error(5.0, Some(50.0)).contains("reads its rows in 50 ms"));
    assert!(Shutter::default().check_period(camera, 1.0 / 30.0).is_ok());
    assert_eq!(
        Twist::default().after(&RigidTransform::IDENTITY, 3.0),
        RigidTransform::IDENTITY
    );
}

/// The median of what time of flight measures, with the camera at a velocity before a wall 2 m ahead, in metres, and the rig.
fn measured(velocity: DVec3, renderer: &Renderer, shutter: Option<Shutter>) -> (Vec<f32>, Rig) {
    let catalog = Catalog::builtin();
    let twin = catalog.nominal(catalog.device("OAK-D ToF").unwrap());
    let spec = RigSpec {
        cameras: vec!["depth_tof".to_owned()],
        annotators: vec![Annotator::DepthSensorDistance],
        shutter,
        ..RigSpec::default()
    };
    let mut rig = Rig::new(&twin, &spec).unwrap().0;
    let twist = Twist {
        velocity,
        ..Twist::default()
    };
    let frame = exposed(&mut rig, renderer, twist);
    (frame.depth_sensor_distance.unwrap().0.pixels().to_vec(), rig)
}

#[test]
fn time_of_flight_sees_each_frequency_at_its_time() {
    let shutter = Some(Shutter {
        exposure_ms: 1.0,
        readout_ms: None,
    });
    let wall = plate(-20.0, 20.0);
    let median = |pixels: &[f32]| {
        let mut valid: Vec<f32> = pixels.iter().copied().filter(|metres| *metres > 0.0).collect();
        assert!(valid.len() > pixels.len() / 2);
        valid.sort_by(f32::total_cmp);
        f64::from(valid[valid.len() / 2])
    };
    let speed = 2.0;
    let (still, _) = measured(DVec3::ZERO, &wall, shutter);
    let (moved, rig) = measured(DVec3::new(speed, 0.0, 0.0), &wall, shutter);
    // The mean of both distances, weighted by the squares of 80 and 100 MHz.
    let [slow, fast] = rig.sensors()[0].as_ref().unwrap().engine().ages_s().unwrap();
    let expected = speed * (slow * 6400.0 + fast * 10_000.0) / 16_400.0;
    let farther = median(&moved) - median(&still);
    assert!(
        (farther - expected).abs() < 2e-3,
        "{farther} m instead of {expected} m"
    );

    // Beside the edge of a plate before a wall, the frequencies see different surfaces, and no distance agrees with both.
    let mut scene = plate(-20.0, 0.0).scene().clone();
    scene.instances.push(Instance {
        path: "/Wall".to_owned(),
        world_from_mesh: DAffine3::from_translation(DVec3::new(3.2, 0.0, 0.0)),
        ..scene.instances[0].clone()
    });
    let scene = Renderer::new(scene);
    let wrong = |velocity| {
        let (pixels, _) = measured(velocity, &scene, shutter);
        let near = |metres: f32| [2.0f32, 3.2].iter().any(|wall| (metres - wall).abs() < 0.05);
        pixels.iter().filter(|metres| !near(**metres)).count()
    };
    let (still, moved) = (wrong(DVec3::ZERO), wrong(DVec3::new(0.0, 3.0, 0.0)));
    assert!(moved > still + 300, "{moved} pixels instead of {still}");
}
