//! Renders, rectifies and matches image pairs of every model with each lens, and of every calibrated unit of the test data.

#![expect(clippy::unwrap_used, clippy::print_stdout, reason = "a test")]

use std::collections::BTreeSet;
use std::path::Path;

use oaktwin::camera::math::DVec3;
use oaktwin::camera::{ImageSize, RigidTransform, StereoGeometry};
use oaktwin::catalog::{Catalog, Role, Twin, TwinCamera};
use oaktwin::pair::{PairCameras, PairOptions};
use oaktwin::render::{Renderer, look_at};
use oaktwin::scene::Scene;
use oaktwin::sensor::SensorOptions;
use oaktwin::stereo::{Matcher, PairOf};
use oaktwin::unit;
use oaktwin::usd::asset::LensChoice;

const SIZE: ImageSize = ImageSize::new(640, 400);

/// A wall of random squares in front of a camera at the origin that faces along x.
fn wall(x: f32) -> Scene {
    let mut scene = crate::plates::room(512, None);
    crate::plates::plate(&mut scene, x, [-6.0, 6.0], [-6.0, 6.0], 0.012 * 512.0);
    scene
}

/// The median of (measured − true disparity) in the centre of the image, px, at several disparities a quarter of a pixel
/// apart, for a wall about 2 m away.
fn errors(twin: &Twin, lens: LensChoice, name: &str) -> Vec<f64> {
    let options = PairOptions {
        size: Some(SIZE),
        lens,
        ..PairOptions::default()
    };
    let cameras = PairCameras::new(twin, &options).unwrap();
    let of = PairOf::Twin {
        twin,
        cameras: (Role::Left, Role::Right),
        lens,
        is_raw: true,
        rectify: None,
        platform: None,
    };
    let mut matcher = Matcher::new(&of, SIZE, &SensorOptions::default()).unwrap();
    let stereo = cameras.rectify().geometry().stereo_geometry();
    // A unit converts disparity to depth with the baseline of its design.
    let device = StereoGeometry {
        baseline_m: twin.depth_baseline_m((Role::Left, Role::Right)).unwrap(),
        ..stereo
    };
    let nearest = stereo.disparity(2.0);
    let world_from_body: RigidTransform = look_at(DVec3::ZERO, DVec3::X, DVec3::Z).unwrap();
    let at = |quarter: f64| {
        let x = 2.0 * nearest / (nearest + quarter / 4.0);
        #[expect(clippy::cast_possible_truncation, reason = "metres")]
        let renderer = Renderer::new(wall(x as f32));
        let pair = cameras.capture(&renderer, &world_from_body, 0);
        let seen = matcher.match_pair(pair.left, pair.right).unwrap();
        assert!(seen.findings.is_empty(), "{name}: {:?}", seen.findings);
        let mut off = Vec::new();
        for y in 180..220 {
            for x in 290..350 {
                let (measured, truth) = (
                    *seen.capture.distance.0.get(x, y).unwrap(),
                    *pair.z.0.get(x, y).unwrap(),
                );
                if measured > 0.0 {
                    off.push(device.disparity(measured.into()) - stereo.disparity(truth.into()));
                }
            }
        }
        assert!(off.len() > 40 * 60 * 9 / 10, "{name}: {} measured", off.len());
        off.sort_by(f64::total_cmp);
        off[off.len() / 2]
    };
    [0.0, 1.0, 2.0, 3.0].map(at).to_vec()
}

/// Interpolation pulls each disparity towards an integer; the mean error is a fraction of a percent at 2 m.
fn check(twin: &Twin, lens: LensChoice, name: &str) {
    let errors = errors(twin, lens, name);
    let mean = errors.iter().sum::<f64>() / errors.len() as f64;
    println!("{name}: {errors:.2?} px, mean {mean:+.3}");
    assert!(
        mean.abs() < 0.13 && errors.iter().all(|error| error.abs() < 0.35),
        "{name}: {errors:?}"
    );
}

/// Models with the same pair and processor are measured once.
#[test]
fn exhaustive_models_and_lenses() {
    let catalog = Catalog::builtin();
    let (mut lenses, mut pairs) = (0, BTreeSet::new());
    for device in catalog.devices() {
        let twin = catalog.nominal(device);
        let Some(baseline) = &device.stereo_baseline_mm else {
            continue;
        };
        let optics = [Role::Left, Role::Right].map(|role| twin.camera(role).map(|camera| camera.intrinsics));
        if !pairs.insert(format!("{baseline:?} {optics:?} {:?}", twin.platform())) {
            continue;
        }
        check(&twin, LensChoice::Pinhole, &device.name);
        let is_wide = |camera: &TwinCamera| camera.nominal_fisheye().is_some();
        if twin.camera(Role::Left).is_some_and(is_wide) {
            check(&twin, LensChoice::Fisheye, &format!("{}, fisheye", device.name));
            lenses += 1;
        }
    }
    println!("{} different pairs", pairs.len());
    assert!(lenses > 0 && pairs.len() > 5);
}

/// Every real calibration gives a pair that measures correctly, or an error with the reason.
#[test]
#[ignore = "needs OAKTWIN_TEST_DATA"]
fn every_calibrated_unit() {
    let data = std::env::var_os("OAKTWIN_TEST_DATA").expect("OAKTWIN_TEST_DATA names the test data");
    let catalog = Catalog::builtin();
    let mut files: Vec<_> = std::fs::read_dir(Path::new(&data).join("data/calibration"))
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "json"))
        .collect();
    files.sort();
    let mut measured = 0;
    // Alternately as a unit of each processor.
    for (file, model) in files
        .iter()
        .zip(["OAK-D Pro PoE", "OAK4-D Wide"].into_iter().cycle())
    {
        let name = file.file_stem().unwrap().to_string_lossy();
        match unit::open(catalog, catalog.device(model).unwrap(), file, true) {
            Ok((twin, _)) => {
                check(&twin, LensChoice::Pinhole, &format!("{name} as {model}"));
                measured += 1;
            }
            Err(error) => {
                println!("{error}");
                assert!(
                    error.to_string().starts_with(&file.display().to_string()),
                    "{error}"
                );
            }
        }
    }
    assert!(measured >= files.len() - 1, "{measured} of {}", files.len());
}
