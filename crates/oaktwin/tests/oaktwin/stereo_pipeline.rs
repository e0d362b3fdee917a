//! Tests the pipeline from a scene through lights, cameras and matcher to depth for an OAK-D Pro.

#![expect(clippy::unwrap_used, reason = "a test")]

use std::ops::ControlFlow;

use oaktwin::accuracy;
use oaktwin::camera::math::DVec3;
use oaktwin::camera::{ImageSize, RigidTransform};
use oaktwin::catalog::{Catalog, Role, Twin};
use oaktwin::image::ZDepth;
use oaktwin::pair::{Pair, PairCameras, PairOptions};
use oaktwin::render::{Renderer, look_at};
use oaktwin::scene::Scene;
use oaktwin::sensor::{STEREO_MATCHING, SensorOptions};
use oaktwin::stereo::{Matcher, PairOf};
use oaktwin::usd::asset::LensChoice;

const SIZE: ImageSize = ImageSize::new(640, 400);

fn twin() -> Twin {
    let catalog = Catalog::builtin();
    catalog.nominal(catalog.device("OAK-D Pro PoE").unwrap())
}

/// A rectangle at x = `x` metres, between `y[0]` and `y[1]`; the squares of its pattern are `grain` metres wide.
fn plate(scene: &mut Scene, x: f32, y: [f32; 2], grain: f32) {
    crate::plates::plate(scene, x, y, [-4.0, 4.0], grain * 64.0);
}

/// A uniformly lit room: uniform grey or random squares.
fn room(is_blank: bool) -> Scene {
    crate::plates::room(64, is_blank.then_some(180))
}

fn captured(scene: Scene, options: PairOptions) -> Pair {
    let options = PairOptions {
        size: Some(SIZE),
        ..options
    };
    let cameras = PairCameras::new(&twin(), &options).unwrap();
    let world_from_body: RigidTransform = look_at(DVec3::ZERO, DVec3::X, DVec3::Z).unwrap();
    cameras.capture(&Renderer::new(scene), &world_from_body, 0)
}

fn depth(pair: Pair) -> ZDepth {
    let twin = twin();
    let of = PairOf::Twin {
        twin: &twin,
        cameras: (Role::Left, Role::Right),
        lens: LensChoice::default(),
        is_raw: false,
        rectify: None,
        platform: None,
    };
    let mut matcher = Matcher::new(&of, SIZE, &SensorOptions::default()).unwrap();
    let seen = matcher
        .match_pair(pair.rectified_left, pair.rectified_right)
        .unwrap();
    seen.capture.distance
}

/// The share of the central half of the image measured within a tenth of the truth.
fn right_share(depth: &ZDepth, truth: f32) -> f64 {
    let (width, height) = (SIZE.width as usize, SIZE.height as usize);
    let rows = depth
        .0
        .pixels()
        .chunks_exact(width)
        .skip(height / 4)
        .take(height / 2);
    let middle: Vec<f32> = rows
        .flat_map(|row| row[width / 4..3 * width / 4].to_vec())
        .collect();
    let right = middle.iter().filter(|z| (**z / truth - 1.0).abs() < 0.1).count();
    right as f64 / middle.len() as f64
}

#[test]
fn a_blank_wall_has_holes_without_the_projector_and_depth_with_it() {
    let wall = || {
        let mut scene = room(true);
        plate(&mut scene, 1.5, [-6.0, 6.0], 0.01);
        scene
    };
    let dark = PairOptions {
        ambient: 0.1,
        ..PairOptions::default()
    };
    let without = right_share(&depth(captured(wall(), dark)), 1.5);
    let with = PairOptions {
        projector: 1.0,
        ..dark
    };
    let with = right_share(&depth(captured(wall(), with)), 1.5);
    assert!(without < 0.3 && with > 0.9, "{without} {with}");
}

#[test]
fn occlusions_are_on_the_left_of_near_objects() {
    let (near, far) = (1.0f32, 3.0f32);
    let mut scene = room(false);
    plate(&mut scene, far, [-9.0, 9.0], 0.025);
    plate(&mut scene, near, [-0.2, 0.2], 0.0085);
    let pair = captured(scene, PairOptions::default());
    let geometry = pair.geometry.stereo_geometry();
    let expected = geometry.disparity(near.into()) - geometry.disparity(far.into());
    let truth = pair.z.clone();
    let depth = depth(pair);
    let width = SIZE.width as usize;
    let mut bands = [Vec::new(), Vec::new()];
    let rows = truth
        .0
        .pixels()
        .chunks_exact(width)
        .zip(depth.0.pixels().chunks_exact(width));
    for (truth, measured) in rows.skip(60).take(280) {
        let left = truth.iter().position(|z| *z < 2.0).unwrap();
        let right = truth.iter().rposition(|z| *z < 2.0).unwrap();
        // Pixels within 60 px of the plate that are not the wall: invalid or the plate's.
        let other = |pixels: &[f32]| pixels.iter().filter(|z| (**z - far).abs() > 0.5).count();
        bands[0].push(other(&measured[left - 60..left]));
        bands[1].push(other(&measured[right + 1..right + 61]));
    }
    let [left, right] = bands.map(|counts| counts.iter().sum::<usize>() as f64 / counts.len() as f64);
    // Within half a matching window on either side the result is random.
    assert!((left - expected).abs() < 4.0, "{left} px, {expected} expected");
    assert!(right < 4.0, "{right} px");
}

/// Subpixel interpolation pulls disparities towards integers: too far a quarter above one, too near a quarter below.
#[test]
fn the_error_oscillates_with_the_period_of_a_pixel() {
    let twin = twin();
    let own = twin.camera(Role::Left).unwrap().intrinsics.fx;
    let disparities = [10.0, 10.25, 10.75, 11.0];
    let options = accuracy::AccuracyOptions {
        engine: SensorOptions {
            engine: Some((&STEREO_MATCHING).into()),
            parameters: vec![("bias".to_owned(), "0".into())],
            ..SensorOptions::default()
        },
        distances_m: Some(disparities.map(|d| own * 0.075 / d).to_vec()),
        captures: 2,
        ..accuracy::AccuracyOptions::default()
    };
    let (bench, _) = accuracy::Bench::new(&twin, &options).unwrap();
    let measured = bench.measure(None, &|_| ControlFlow::Continue(())).unwrap();
    let rows = &measured.report().distances;
    let errors: Vec<f64> = rows
        .iter()
        .map(|row| row.reading.error_percent.unwrap())
        .collect();
    let [below, far, near, above] = errors[..] else {
        panic!("{errors:?}")
    };
    assert!(far > 0.3 && near < -0.3, "{errors:?}");
    assert!(below.abs() < 0.3 && above.abs() < 0.3, "{errors:?}");
}
