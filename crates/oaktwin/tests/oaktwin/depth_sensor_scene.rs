//! Tests every effect of Isaac Sim's depth sensor on the example scene.

#![expect(
    clippy::unwrap_used,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a test"
)]

use std::ops::Range;
use std::path::Path;
use std::sync::LazyLock;

use oaktwin::image::annotation::{Annotator, Frame};
use oaktwin::image::{Image, ZDepth};
use oaktwin::render::{
    AnnotateOptions, Backend, DepthSensorOptions, OpenOptions, PlacedCamera, Renderer, SceneCameraOptions,
    SceneFile, depth_sensors, scene_cameras,
};
use oaktwin::sensor::{DepthShot, Illumination, SensorOptions};

/// The front of the red cube, 2.5 m away: its columns, and rows with nothing but ground and wall on its left.
const RED: Range<u32> = 960..1400;
const RED_ROWS: Range<u32> = 640..800;
/// The front of the blue cube, 3.5 m away, above the cone.
const BLUE: Range<u32> = 18..646;
const BLUE_ROWS: Range<u32> = 455..465;
/// Disparity times depth, px·m: b·f·W/S.
const BF: f32 = 0.075 * 805.0 * 1.5;

/// Rendered once for all tests.
static SCENE: LazyLock<(Vec<PlacedCamera>, Frame)> = LazyLock::new(|| {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/depth_sensor/depth_sensor.usda");
    let scene = SceneFile::open(&path, &OpenOptions::default()).unwrap();
    let (cameras, findings) = scene_cameras(&scene, &SceneCameraOptions::default()).unwrap();
    assert_eq!((cameras.len(), findings), (1, Vec::new()));
    let view = cameras[0].view(&cameras[0].world_from_mount);
    let (frame, _) = Renderer::new(scene.scene).annotate(
        &view,
        &[Annotator::Rgb, Annotator::DistanceToImagePlane],
        Backend::Auto,
        &AnnotateOptions::default(),
    );
    (cameras, frame)
});

fn truth() -> &'static ZDepth {
    SCENE.1.distance_to_image_plane.as_ref().unwrap()
}

/// The output of the scene's own sensor with these parameters.
fn sensed(parameters: &[(&str, &str)]) -> Image<f32> {
    let (cameras, frame) = &*SCENE;
    let owned = parameters.iter();
    let options = SensorOptions {
        parameters: owned
            .map(|(name, value)| ((*name).to_owned(), (*value).into()))
            .collect(),
        ..SensorOptions::default()
    };
    let options = DepthSensorOptions {
        twin: None,
        sensor: &options,
        light: Illumination::default(),
    };
    let (mut sensors, _) = depth_sensors(cameras, &options).unwrap();
    let shot = DepthShot::new((&truth().0).into());
    let shot = shot.with_rgb(frame.rgb.as_ref().unwrap().into()).unwrap();
    let sensor = sensors[0].as_mut().unwrap();
    sensor.capture(shot, &[]).unwrap().distance.0
}

/// No noise, and no pixels invalidated for lack of texture.
const QUIET: [(&str, &str); 2] = [("noiseMean", "0"), ("confidenceThreshold", "1")];

fn at(image: &Image<f32>, x: u32, y: u32) -> f32 {
    *image.get(x, y).unwrap()
}

/// The columns of a row with exactly this depth.
fn columns(image: &Image<f32>, y: u32, z: f32) -> Vec<u32> {
    (0..image.width())
        .filter(|&x| at(image, x, y).to_bits() == z.to_bits())
        .collect()
}

/// The number of valid pixels.
fn measured(image: &Image<f32>, rows: Range<u32>, columns: Range<u32>) -> usize {
    let places = rows.flat_map(|y| columns.clone().map(move |x| (x, y)));
    places.filter(|&(x, y)| at(image, x, y) > 0.0).count()
}

/// The two faces: rows, columns, and their constant depth.
fn faces() -> [(Range<u32>, Range<u32>, f32); 2] {
    let z = |x, y| at(&truth().0, x, y);
    [(BLUE_ROWS, BLUE, z(300, 460)), (RED_ROWS, RED, z(1200, 720))]
}

#[test]
fn the_scene_is_as_described() {
    let z = &truth().0;
    assert_eq!((z.width(), z.height()), (1920, 1080));
    let fx = SCENE.0[0].camera.intrinsics.fx;
    assert!((fx - 2199.0).abs() < 0.01, "{fx}");
    for (x, y, metres) in [(1200, 720, 2.5), (300, 460, 3.5), (960, 100, 9.0)] {
        let seen = at(z, x, y);
        assert!((seen - metres).abs() < 1e-5, "{x} {y}: {seen}");
    }
    for (rows, place, face) in faces() {
        for y in rows {
            assert_eq!(columns(z, y, face), place.clone().collect::<Vec<_>>(), "row {y}");
        }
    }
}

#[test]
fn a_face_has_one_depth_with_noise() {
    for parameters in [&[][..], &[("noiseSigma", "1.5"), ("noiseMean", "1")]] {
        let all = [parameters, &[("confidenceThreshold", "1")]].concat();
        let image = sensed(&all);
        for (rows, place, face) in faces() {
            // Farther right the background is visible through gaps that noise opens in the face.
            let inner = place.start + 60..place.end - 10;
            for y in rows.clone() {
                for x in inner.clone() {
                    let z = at(&image, x, y);
                    assert!(z == 0.0 || z.to_bits() == face.to_bits(), "{x} {y}: {z}");
                }
            }
            let share =
                measured(&image, rows.clone(), inner.clone()) as f32 / (rows.len() * inner.len()) as f32;
            assert!(share > 0.5, "{share}");
        }
    }
}

#[test]
fn objects_shift_right_by_their_disparity() {
    let image = sensed(&QUIET);
    for ((rows, place, face), shifts) in faces().into_iter().zip([25..=26, 33..=36]) {
        for y in rows {
            let now = columns(&image, y, face);
            assert_eq!(now.len(), place.len(), "row {y}");
            for (from, to) in place.clone().zip(&now) {
                assert!(shifts.contains(&(to - from)), "row {y}: {from} to {to}");
            }
        }
    }
}

#[test]
fn holes_open_on_the_left() {
    let image = sensed(&QUIET);
    for y in RED_ROWS {
        let first = columns(&image, y, 2.5)[0];
        let behind = at(&truth().0, RED.start - 1, y);
        let hole = (0..first).rev().take_while(|&x| at(&image, x, y) == 0.0).count();
        let expected = BF * (1.0 / 2.5 - 1.0 / behind);
        assert!(
            (hole as f32 - expected).abs() <= 1.0,
            "row {y}: {hole} px for {expected}"
        );
        // There are none on the right.
        assert_eq!(
            measured(&image, y..y + 1, RED.end + 20..RED.end + 60),
            40,
            "row {y}"
        );
    }
    // There is one at the left border, as wide as the shift of the background there.
    let hole = (0..).take_while(|&x| at(&image, x, 200) == 0.0).count();
    assert!((hole as f32 - BF / 9.0).abs() <= 0.5, "{hole}");
}

#[test]
fn a_negative_baseline_opens_holes_on_the_right() {
    let image = sensed(&[QUIET[0], QUIET[1], ("baselineMM", "-75")]);
    let now = columns(&image, 720, 2.5);
    assert_eq!((now[0], now.len()), (RED.start - 36, RED.len()));
    assert_eq!(measured(&image, 720..721, RED.end - 36..RED.end - 15), 0);
    assert_eq!(measured(&image, 720..721, RED.start - 60..RED.start - 36), 24);
}

#[test]
fn smooth_surfaces_have_holes_along_lines_of_equal_disparity() {
    // Steps of 2 px without jitter. On the cone's left half disparity grows along a row: a gap opens at each step, and the
    // gaps form lines of equal disparity.
    let step = 2.0;
    let image = sensed(&[
        ("noiseMean", "2"),
        ("noiseSigma", "0"),
        ("confidenceThreshold", "1"),
        ("outlierRemovalEnabled", "0"),
    ]);
    let (mut tears, mut holes) = (0, 0);
    for y in 760..950 {
        let z = |x: u32| at(&truth().0, x, y);
        let disparity = |x: u32| (BF / z(x) / step).round() * step;
        for x in 500..740 {
            let (here, next) = (disparity(x), disparity(x + 1));
            let is_cone = z(x) < 3.3 && (z(x) - z(x + 1)).abs() < 0.05;
            // At the edge of a step, single and double precision may differ.
            let is_sure = [x, x + 1]
                .iter()
                .all(|&x| ((BF / z(x) / step).fract() - 0.5).abs() > 1e-4);
            if is_cone && is_sure && next > here {
                tears += 1;
                let first = x + here as u32 + 1;
                holes += usize::from(measured(&image, y..y + 1, first..first + 2) == 0);
            }
        }
    }
    assert!(tears > 100 && holes == tears, "{holes} of {tears}");
}

#[test]
fn right_edges_are_clean_and_left_edges_ragged() {
    let image = sensed(&[("confidenceThreshold", "1")]);
    let mut left = Vec::new();
    for y in RED_ROWS {
        // From the end of the hole.
        left.push(columns(&image, y, 2.5)[0]);
    }
    let spread = left.iter().max().unwrap() - left.iter().min().unwrap();
    assert!((1..=4).contains(&spread), "{spread}");
    // Nothing is measured on the left of the cube; on its right the wall is measured up to the edge.
    let beside = |place: Range<u32>| {
        measured(&image, RED_ROWS, place.clone()) as f32 / (RED_ROWS.len() * place.len()) as f32
    };
    let (left, right) = (
        beside(RED.start + 22..RED.start + 33),
        beside(RED.end + 38..RED.end + 49),
    );
    assert!(left < 0.1 && right > 0.9, "{left} {right}");
}

#[test]
fn a_maximum_distance_removes_farther_pixels() {
    // Outlier removal would also depend on the removed neighbours.
    let outliers = ("outlierRemovalEnabled", "0");
    let (near, all) = (sensed(&[("maxDistance", "3"), outliers]), sensed(&[outliers]));
    let whole = |image: &Image<f32>| measured(image, 0..1080, 0..1920);
    assert!(near.pixels().iter().all(|&z| z <= 3.0));
    assert!(whole(&near) * 2 < whole(&all) && whole(&near) > 10_000);
    // The remaining pixels are unchanged.
    for y in RED_ROWS {
        assert!(columns(&near, y, 2.5) == columns(&all, y, 2.5), "row {y}");
    }
}

#[test]
fn confidence_thins_untextured_surfaces() {
    // The wall with its grid, and the front of the red cube.
    let shares = |threshold: &str, more: &[(&str, &str)]| {
        let parameters = [&[("noiseMean", "0"), ("confidenceThreshold", threshold)], more].concat();
        let one = sensed(&parameters);
        let wall = measured(&one, 20..420, 100..1900) as f32 / (400.0 * 1800.0);
        let face = measured(&one, RED_ROWS, RED.start + 60..RED.end - 10) as f32;
        (wall, face / (RED_ROWS.len() * (RED.len() - 70)) as f32)
    };
    let all = shares("1", &[]);
    assert_eq!(all, (1.0, 1.0));
    // The lines of the grid remain, and of the evenly lit face the lines where its shade changes.
    let (wall, face) = shares("0.8", &[]);
    assert!(wall > 0.02 && wall < 0.3, "{wall}");
    assert!(face > 0.005 && face < 0.15, "{face}");
    let thinner = shares("0.2", &[]);
    assert!(thinner.0 <= wall && thinner.1 < face, "{thinner:?}");
    // Grain fills both.
    let grain = [("grain", "1")];
    let mut before = all;
    for threshold in ["0.8", "0.5", "0.2"] {
        let now = shares(threshold, &grain);
        assert!(now.0 < before.0 && now.1 < before.1, "{threshold}: {now:?}");
        assert!(now.0 > now.1, "{threshold}: {now:?}");
        before = now;
    }
}

#[test]
fn output_is_independent_of_the_number_of_threads() {
    let on = |threads| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        pool.install(|| sensed(&[]))
    };
    let one = on(1);
    for threads in [2, 8] {
        assert_eq!(on(threads).pixels(), one.pixels());
    }
}
