use std::path::Path;

use oaktwin_render::BeamPattern;

use super::*;
use crate::camera::math::{DAffine3, DVec3};
use crate::camera::{Axes, Camera, ImageSize, LensModel, OpenCv, PixelPoint};
use crate::catalog::{Catalog, Projector, Role};
use crate::depth::imager::{Bits, Parameters};
use crate::depth::rectify::Method;
use crate::image::Image;
use crate::scene::{Instance, Light, LightKind, Material, MaterialSpan, Mesh, Scene};

fn twin(model: &str) -> Twin {
    let catalog = Catalog::builtin();
    catalog.nominal(catalog.device(model).unwrap())
}

fn unit(model: &str, file: &str) -> Twin {
    let catalog = Catalog::builtin();
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../calibration/fixtures")
        .join(file);
    crate::unit::open(catalog, catalog.device(model).unwrap(), &path, true)
        .unwrap()
        .0
}

/// A white rectangle `x` metres ahead of the body, across `y` and `z`.
fn plate(scene: &mut Scene, x: f32, [y0, y1]: [f32; 2], [z0, z1]: [f32; 2]) {
    let mesh = Mesh {
        positions: vec![[x, y0, z0], [x, y1, z0], [x, y1, z1], [x, y0, z1]],
        triangles: vec![[0, 1, 2], [0, 2, 3]],
        materials: vec![MaterialSpan {
            end: 2,
            material: Some(0),
        }],
        double_sided: true,
        ..Mesh::default()
    };
    scene.instances.push(Instance {
        mesh: u32::try_from(scene.meshes.len()).unwrap(),
        path: format!("/Plate{x}"),
        world_from_mesh: DAffine3::IDENTITY,
        labels: Vec::new(),
    });
    scene.meshes.push(mesh);
}

fn room() -> Scene {
    Scene {
        materials: vec![Material {
            base_color: Some([1.0; 3]),
            roughness: 1.0,
            ..Material::default()
        }],
        lights: vec![Light {
            path: "/Sky".to_owned(),
            kind: LightKind::Dome { texture: None },
            radiance: [1.0; 3],
            normalize: false,
            world_from_light: DAffine3::IDENTITY,
        }],
        ..Scene::default()
    }
}

fn wall(x: f32) -> Renderer {
    let mut scene = room();
    plate(&mut scene, x, [-60.0, 60.0], [-60.0, 60.0]);
    Renderer::new(scene)
}

/// Only dots, in 10 bits without noise.
fn dots_only(exposure: f64) -> PairOptions {
    PairOptions {
        projector: 1.0,
        ambient: 0.0,
        imager: Parameters {
            auto_exposure: false,
            exposure,
            noise: false,
            bits: Bits::Ten,
            ..Parameters::default()
        },
        ..PairOptions::default()
    }
}

fn numbers(image: &Recorded) -> Image<f64> {
    match image {
        Recorded::Eight(image) => image.map(|&number| f64::from(number)),
        Recorded::Ten(image) => image.map(|&number| f64::from(number)),
    }
}

/// Mean and standard deviation in the middle quarter.
fn middle(image: &Recorded) -> (f64, f64) {
    let (w, h) = (image.width(), image.height());
    let image = numbers(image);
    let values: Vec<f64> = (h / 4..3 * h / 4)
        .flat_map(|y| (w / 4..3 * w / 4).map(move |x| (x, y)))
        .map(|(x, y)| *image.get(x, y).unwrap())
        .collect();
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    let variance = values.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / values.len() as f64;
    (mean, variance.sqrt())
}

/// The centre of what is bright within 4 px, and how bright that is.
fn centroid(image: &Image<f64>, near: PixelPoint<OpenCv>) -> Option<(PixelPoint<OpenCv>, f64)> {
    let (cx, cy) = (near.x.round() as i64, near.y.round() as i64);
    let (mut x_sum, mut y_sum, mut sum) = (0.0, 0.0, 0.0);
    for y in cy - 4..=cy + 4 {
        for x in cx - 4..=cx + 4 {
            let value = image.get(u32::try_from(x).ok()?, u32::try_from(y).ok()?)?;
            x_sum += value * x as f64;
            y_sum += value * y as f64;
            sum += value;
        }
    }
    Some((PixelPoint::new(x_sum / sum, y_sum / sum), sum))
}

fn body_from_projector(twin: &Twin) -> RigidTransform {
    let place = DVec3::from(twin.device.body.projector_mm.unwrap()) * 1e-3;
    RigidTransform::new(Axes::Ros.rotation_from(Axes::OpenCv), place)
}

fn belago() -> Projector {
    twin("oak-d-pro-poe").device.projector.unwrap()
}

/// Every dot's place on a wall `x` metres ahead, in the body.
fn dots_on_wall(twin: &Twin, x: f64) -> Vec<DVec3> {
    let dots = Dots::new(twin.device.projector.as_ref().unwrap());
    let body_from_projector = body_from_projector(twin);
    let at = |[u, v]: [f32; 2]| body_from_projector.apply(DVec3::new(f64::from(u), f64::from(v), 1.0) * x);
    dots.places().map(at).collect()
}

#[test]
fn dots_are_as_many_as_they_should_be_apart_and_within_the_field() {
    let spec = belago();
    let dots = Dots::new(&spec);
    let places: Vec<[f32; 2]> = dots.places().collect();
    assert_eq!((dots.len(), places.len()), (4700, 4700));
    let border = [spec.hfoi_deg, spec.vfoi_deg].map(|deg| (deg.to_radians() / 2.0).tan() as f32);
    assert!(
        places
            .iter()
            .all(|at| at[0].abs() < border[0] && at[1].abs() < border[1])
    );
    let mut nearest = f32::INFINITY;
    for (i, a) in places.iter().enumerate() {
        for b in &places[..i] {
            nearest = nearest.min((a[0] - b[0]).hypot(a[1] - b[1]));
        }
    }
    let own = (4.0 * border[0] * border[1] / 4700.0).sqrt();
    assert!(nearest > 0.65 * own, "{nearest} {own}");
    // All of the field has some.
    let full = |x: f32, y: f32| {
        places
            .iter()
            .any(|at| (at[0] - x).abs() < 0.07 && (at[1] - y).abs() < 0.07)
    };
    for i in -10..=10i8 {
        for j in -10..=10i8 {
            assert!(full(
                f32::from(i) / 10.0 * border[0],
                f32::from(j) / 10.0 * border[1]
            ));
        }
    }
    assert_eq!(dots, Dots::new(&spec));
}

#[test]
fn a_dot_is_half_as_bright_at_half_its_width_and_the_dark_is_known() {
    let spec = belago();
    let dots = Dots::new(&spec);
    let mut near_axis = 0;
    for [x, y] in dots.places() {
        let peak = dots.luminance([x, y]);
        assert!(!dots.is_dark_around([x, y], 0.0));
        if x.hypot(y) < 0.1 {
            near_axis += 1;
            assert!((peak / 3.0 - 1.0).abs() < 2e-3, "{peak}");
            let half = dots.luminance([x + 1.5e-3, y]);
            assert!((half / peak - 0.5).abs() < 0.02, "{half} {peak}");
        }
    }
    assert!(near_axis > 20);
    let (mut dark, mut total) = (0, 0);
    for i in -400..400i16 {
        for j in -300..300i16 {
            let at = [f32::from(i) * 2.2e-3, f32::from(j) * 2.2e-3];
            total += 1;
            if dots.is_dark_around(at, 1e-3) {
                dark += 1;
                assert!(dots.luminance(at) == 0.0 && dots.luminance([at[0] + 7e-4, at[1] - 7e-4]) == 0.0);
            }
        }
    }
    assert!(dark * 2 > total, "{dark} of {total}");
    assert!(dots.is_dark_around([f32::NAN, 0.0], 1.0) || dots.luminance([f32::NAN, 0.0]) == 0.0);
    assert_eq!(dots.luminance([9.0, -9.0]), 0.0);
}

#[test]
fn a_blank_wall_has_texture_by_the_projector_alone() {
    let renderer = wall(1.5);
    let look = |projector| {
        let options = PairOptions {
            projector,
            ..PairOptions::default()
        };
        pair(
            &renderer,
            &twin("oak-d-pro-poe"),
            &RigidTransform::IDENTITY,
            &options,
        )
        .unwrap()
    };
    let (off, on) = (look(0.0), look(1.0));
    assert!(off.z.0.pixels().iter().all(|z| (z - 1.5).abs() < 1e-5));
    for (image, other) in [(&off.left, &on.left), (&off.rectified_right, &on.rectified_right)] {
        let ((mean, noise), (_, textured)) = (middle(image), middle(other));
        // Nothing but noise: of a full well of 6300 electrons at 0.35, and of rounding.
        let level = mean / 255.0;
        let expected = ((level * 6300.0 + 6.25) / 6300.0f64.powi(2) * 255.0 * 255.0 + 1.0 / 12.0).sqrt();
        assert!(
            (level - 0.35).abs() < 0.01 && (noise / expected - 1.0).abs() < 0.05,
            "{noise} {expected}"
        );
        assert!(textured > 8.0 * noise, "{textured} {noise}");
    }
}

/// Projecting a dot's place on the wall says where it is in both images, and the rectified ones have f·b/z between them.
#[test]
fn dots_are_where_their_places_are_seen() {
    let twin = twin("oak-d-pro-poe");
    let (x, options) = (1.3f32, dots_only(0.5));
    let cameras = PairCameras::new(&twin, &options).unwrap();
    let seen = cameras.look(&wall(x), &RigidTransform::IDENTITY, 0);
    let rectified = [&seen.rectified_left, &seen.rectified_right].map(numbers);
    let disparity = seen.geometry.stereo_geometry().disparity(f64::from(x));
    let mut compared = 0;
    for point in dots_on_wall(&twin, f64::from(x)) {
        let places = [Role::Left, Role::Right].map(|role| {
            let camera = twin.camera(role).unwrap();
            let in_camera = camera.body_from_camera.inverse().apply(point);
            Camera::new(camera.intrinsics, LensModel::Pinhole)
                .project(in_camera)
                .unwrap()
        });
        let found = [0, 1].map(|i| centroid(&rectified[i], places[i]));
        if let [Some((left, a)), Some((right, b))] = found
            && a > 400.0
            && b > 400.0
        {
            compared += 1;
            for (found, place) in [(left, places[0]), (right, places[1])] {
                assert!((found.xy() - place.xy()).length() < 0.12, "{found:?} {place:?}");
            }
            assert!((left.x - right.x - disparity).abs() < 0.1 && (left.y - right.y).abs() < 0.1);
        }
    }
    assert!(compared > 3000, "{compared}");
}

#[test]
fn what_stands_in_the_light_takes_the_dots_of_the_wall_behind() {
    let twin = twin("oak-d-pro-poe");
    let mut scene = room();
    plate(&mut scene, 2.0, [-9.0, 9.0], [-9.0, 9.0]);
    let (near, [y0, y1], [z0, z1]) = (0.7, [-0.13, 0.03], [-0.08, 0.08]);
    plate(&mut scene, near, [y0, y1], [z0, z1]);
    let options = dots_only(2.0);
    let cameras = PairCameras::new(&twin, &options).unwrap();
    let seen = cameras.look(&Renderer::new(scene), &RigidTransform::IDENTITY, 0);
    let image = numbers(&seen.left);
    let left = twin.camera(Role::Left).unwrap();
    let camera_from_body = left.body_from_camera.inverse();
    let camera = Camera::new(left.intrinsics, LensModel::Pinhole);
    // How far inside the plate a line from a place to a dot on the wall passes it, metres.
    let inside = |from: DVec3, point: DVec3| {
        let at = from + (point - from) * ((f64::from(near) - from.x) / (point.x - from.x));
        let [y0, y1, z0, z1] = [y0, y1, z0, z1].map(f64::from);
        (at.y - y0).min(y1 - at.y).min(at.z - z0).min(z1 - at.z)
    };
    let (mut shadowed, mut lit, mut on_plate) = (0, 0, 0);
    let dots = dots_on_wall(&twin, 2.0)
        .into_iter()
        .zip(dots_on_wall(&twin, f64::from(near)));
    for (point, nearer) in dots {
        let by_projector = inside(body_from_projector(&twin).translation, point);
        let by_eye = inside(left.body_from_camera.translation, point);
        let sum = |point| {
            let place = camera.project(camera_from_body.apply(point)).unwrap();
            centroid(&image, place).map(|(_, sum)| sum)
        };
        if by_projector > 0.01 && by_eye < -0.01 {
            assert_eq!(sum(point), Some(0.0));
            shadowed += 1;
        }
        if (-0.1..-0.01).contains(&by_projector) && by_eye < -0.01 {
            assert!(sum(point).unwrap() > 300.0);
            lit += 1;
        }
        if by_projector > 0.01 {
            assert!(sum(nearer).unwrap() > 300.0);
            on_plate += 1;
        }
    }
    assert!(
        shadowed > 20 && lit > 50 && on_plate > 50,
        "{shadowed} {lit} {on_plate}"
    );
}

/// How bright the dots of a wall are: as 1/z². Prints from where on they are lost in the noise of an office's light.
#[test]
fn dots_fade_with_the_square_of_the_distance() {
    let twin = twin("oak-d-pro-poe");
    let at_one = middle(
        &pair(&wall(1.0), &twin, &RigidTransform::IDENTITY, &dots_only(0.3))
            .unwrap()
            .left,
    )
    .0;
    let mut last = f64::INFINITY;
    for z in [1.0, 2.0, 4.0, 8.0] {
        let exposure = 0.3 * z * z;
        let mut options = dots_only(exposure);
        options.imager.max_exposure_time = 1e3;
        let renderer = wall(z as f32);
        let seen = pair(&renderer, &twin, &RigidTransform::IDENTITY, &options).unwrap();
        let mean = middle(&seen.left).0;
        assert!((mean / at_one - 1.0).abs() < 0.03, "{z}: {mean} {at_one}");

        let lit = PairOptions {
            projector: 1.0,
            ..PairOptions::default()
        };
        let on = pair(&renderer, &twin, &RigidTransform::IDENTITY, &lit).unwrap();
        let level = 6300.0 * on.exposure.time;
        let noise = (level + 6.25f64).sqrt();
        let signal = 3.0 / (z * z) * level;
        let ratio = signal / noise;
        println!(
            "{z:4.1} m: a dot is {:5.2} of the wall's light, {ratio:6.1} times its noise",
            3.0 / (z * z)
        );
        assert!(ratio < last);
        last = ratio;
    }
}

/// The rectified images of a calibrated unit: how far dots are from where the rectified cameras should see them.
fn off(twin: &Twin, options: PairOptions) -> (Vec<DVec3>, Method) {
    let x = 1.1;
    let cameras = PairCameras::new(twin, &options).unwrap();
    let seen = cameras.look(&wall(x as f32), &RigidTransform::IDENTITY, 0);
    let images = [&seen.rectified_left, &seen.rectified_right].map(numbers);
    let rectified_from_body = cameras.body_from_rectified_left().inverse();
    let geometry = seen.geometry;
    let mut found = Vec::new();
    for point in dots_on_wall(twin, x) {
        let in_left = rectified_from_body.apply(point);
        let in_right = in_left + DVec3::X * geometry.offset;
        let places = [(in_left, geometry.left), (in_right, geometry.right)]
            .map(|(point, intrinsics)| intrinsics.pixel_from_normalized(point.truncate() / point.z));
        let centres = [0, 1].map(|i| centroid(&images[i], places[i]));
        if let [Some((left, a)), Some((right, b))] = centres
            && a > 400.0
            && b > 400.0
        {
            let z = seen
                .z
                .0
                .get(places[0].x.round() as u32, places[0].y.round() as u32)
                .unwrap();
            assert!((f64::from(*z) / in_left.z - 1.0).abs() < 2e-3, "{z} {in_left}");
            found.push(DVec3::new(
                left.y - right.y,
                (left.xy() - places[0].xy()).length(),
                (right.xy() - places[1].xy()).length(),
            ));
        }
    }
    (found, cameras.rectify().method())
}

fn root_mean_square(values: impl Iterator<Item = f64> + Clone) -> f64 {
    let count = values.clone().count() as f64;
    (values.map(|value| value * value).sum::<f64>() / count).sqrt()
}

#[test]
fn the_rectified_pair_of_a_unit_has_its_points_in_the_same_rows() {
    let wide = unit("oak-d-pro-w-poe", "oak-d-pro-w-poe.json");
    let (found, method) = off(&wide, dots_only(0.8));
    assert_eq!(method, Method::Mesh);
    let rows = root_mean_square(found.iter().map(|off| off.x));
    println!("{} dots, rows {rows:.3} px", found.len());
    assert!(found.len() > 1500 && rows < 0.1);
}

#[test]
fn after_a_homography_the_lens_remains() {
    let twin = unit("oak-d-pro-poe", "example-oak-d-pro-poe.json");
    let straight = dots_only(0.5);
    let full = PairOptions {
        rectify: Some(crate::depth::rectify::RectifyOptions {
            method: Method::Full,
            ..Default::default()
        }),
        ..straight
    };
    let (left, method) = off(&twin, straight);
    assert_eq!(method, Method::Homography);
    let (corrected, _) = off(&twin, full);
    let worst = |found: &[DVec3]| found.iter().map(|off| off.y.max(off.z)).fold(0.0, f64::max);
    let rows = root_mean_square(corrected.iter().map(|off| off.x));
    println!("{} and {}, rows {rows:.3} px", worst(&left), worst(&corrected));
    assert!(corrected.len() > 2000 && worst(&left) > 0.5 && worst(&corrected) < 0.2 && rows < 0.1);
}

#[test]
fn borders_are_black_where_a_camera_does_not_see() {
    let twin = unit("oak-d-pro-poe", "example-oak-d-pro-poe.json");
    let options = PairOptions::default();
    let seen = pair(&wall(2.0), &twin, &RigidTransform::IDENTITY, &options).unwrap();
    let black = |image: &Recorded| {
        numbers(image)
            .pixels()
            .iter()
            .filter(|&&number| number == 0.0)
            .count()
    };
    assert_eq!(black(&seen.left) + black(&seen.right), 0);
    let borders = black(&seen.rectified_left) + black(&seen.rectified_right);
    assert!((1000..200_000).contains(&borders), "{borders}");
}

#[test]
fn the_same_on_any_number_of_threads() {
    let twin = twin("oak-d-pro-w-poe");
    let options = PairOptions {
        projector: 0.7,
        size: Some(ImageSize::new(640, 400)),
        lens: crate::usd::asset::LensChoice::Fisheye,
        seed: 3,
        ..PairOptions::default()
    };
    let with = |threads| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        pool.install(|| pair(&wall(1.0), &twin, &RigidTransform::IDENTITY, &options).unwrap())
    };
    let (one, three) = (with(1), with(3));
    assert!(one == three);
    assert_eq!((one.left.width(), one.rectified_left.height()), (640, 400));
    assert_ne!(one.left, one.right);
}

#[test]
fn what_makes_no_pair() {
    let error = |model: &str, change: fn(&mut PairOptions)| {
        let mut options = PairOptions::default();
        change(&mut options);
        PairCameras::new(&twin(model), &options).unwrap_err().to_string()
    };
    assert_eq!(
        error("oak4-d", |o| o.projector = 1.0),
        "OAK4-D: projector: it has no dot projector; leave it off, or choose a Pro model"
    );
    assert_eq!(
        error("oak-d-pro-poe", |o| o.projector = 1.5),
        "projector: 1.5 is out of range; give 0 to 1"
    );
    assert!(error("oak4-d", |o| o.ambient = f64::NAN).starts_with("ambient: NaN is out of range"));
    assert!(error("oak4-d", |o| o.size = Some(ImageSize::new(0, 3))).contains("has no pixel"));
    assert!(error("oak4-d", |o| o.imager.full_well_e = 0.0).starts_with("fullWell"));
}
