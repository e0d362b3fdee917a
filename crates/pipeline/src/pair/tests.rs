mod drift;

use std::path::Path;

use super::cameras::dots;
use super::*;
use oaktwin_camera::math::{DAffine3, DVec3};
use oaktwin_camera::{Axes, Camera, ImageSize, LensModel, OpenCv, PixelPoint};
use oaktwin_catalog::{Catalog, Role};
use oaktwin_depth::imager::{Bits, Parameters};
use oaktwin_depth::rectify::{Method, RectifyOptions, StereoRectify};
use oaktwin_image::Image;
use oaktwin_scene::{Instance, Light, LightKind, Material, MaterialSpan, Mesh, Scene};

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
        material_offset: 0,
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

/// Every dot's place on a wall `x` metres ahead, in the body.
fn dots_on_wall(twin: &Twin, x: f64) -> Vec<DVec3> {
    let dots = dots(twin.device.projector.as_ref().unwrap());
    let body_from_projector = body_from_projector(twin);
    let at = |[u, v]: [f32; 2]| body_from_projector.apply(DVec3::new(f64::from(u), f64::from(v), 1.0) * x);
    dots.places().map(at).collect()
}

#[test]
fn a_blank_wall_has_texture_by_the_projector_alone() {
    let renderer = wall(1.5);
    let capture = |projector| {
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
    let (off, on) = (capture(0.0), capture(1.0));
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
        assert!(textured > 4.0 * noise, "{textured} {noise}");
    }
}

/// Projecting a dot's place on the wall says where it is in both images, and the rectified ones have f·b/z between them.
#[test]
fn dots_are_where_their_places_are_seen() {
    let twin = twin("oak-d-pro-poe");
    let (x, options) = (1.3f32, dots_only(0.5));
    let cameras = PairCameras::new(&twin, &options).unwrap();
    let seen = cameras.capture(&wall(x), &RigidTransform::IDENTITY, 0);
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
    let (near, [y0, y1], [z0, z1]) = (0.5, [-0.17, 0.03], [-0.2, 0.2]);
    plate(&mut scene, near, [y0, y1], [z0, z1]);
    let options = dots_only(2.0);
    let cameras = PairCameras::new(&twin, &options).unwrap();
    let seen = cameras.capture(&Renderer::new(scene), &RigidTransform::IDENTITY, 0);
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
        if let Some(sum) = sum(point).filter(|_| by_eye < -0.01) {
            if by_projector > 0.01 {
                assert_eq!(sum, 0.0);
                shadowed += 1;
            } else if (-0.1..-0.01).contains(&by_projector) {
                assert!(sum > 300.0, "{sum}");
                lit += 1;
            }
        }
        if let Some(sum) = sum(nearer).filter(|_| by_projector > 0.01) {
            assert!(sum > 300.0, "{sum}");
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
    let size = Some(ImageSize::new(640, 400));
    let capture = |z: f64, options: &PairOptions| {
        let options = PairOptions { size, ..*options };
        pair(&wall(z as f32), &twin, &RigidTransform::IDENTITY, &options).unwrap()
    };
    let office = capture(2.0, &PairOptions::default()).exposure;
    let at_one = middle(&capture(1.0, &dots_only(0.3)).left).0;
    for z in [1.0, 2.0, 4.0, 8.0, 16.0] {
        if z > 1.0 && z < 10.0 {
            let mut options = dots_only(0.3 * z * z);
            options.imager.max_exposure_time = 1e3;
            let mean = middle(&capture(z, &options).left).0;
            assert!((mean / at_one - 1.0).abs() < 0.03, "{z}: {mean} {at_one}");
        }
        let electrons = 6300.0 * office.time;
        let contrast = 3.0 / (z * z);
        let noise = (electrons + 6.25f64).sqrt();
        println!(
            "{z:4.1} m: a dot is {contrast:6.3} of a white wall's light, {:6.1} times its noise",
            contrast * electrons / noise
        );
    }
}

/// How far dots are from where the rectified cameras should see them: between the rows of the two images, in the left
/// image, and in the right one, px.
struct Off {
    rows: Vec<f64>,
    left: Vec<f64>,
    right: Vec<f64>,
}

/// Of a wall that is seen by a calibrated unit, rectified in several ways.
fn off<const N: usize>(twin: &Twin, exposure: f64, methods: [Method; N]) -> [Off; N] {
    let x = 1.1;
    let cameras = PairCameras::new(twin, &dots_only(exposure)).unwrap();
    let seen = cameras.capture(&wall(x as f32), &RigidTransform::IDENTITY, 0);
    let raw = [&seen.left, &seen.right].map(|image| match image {
        Recorded::Ten(image) => image,
        Recorded::Eight(_) => unreachable!(),
    });
    let [left, right] = [Role::Left, Role::Right].map(|role| twin.camera(role).unwrap());
    let right_from_left = right.body_from_camera.inverse() * left.body_from_camera;
    let points = dots_on_wall(twin, x);
    methods.map(|method| {
        let options = RectifyOptions {
            method,
            ..RectifyOptions::default()
        };
        let [left, right] = cameras.cameras();
        let rectify = StereoRectify::new(left, right, &right_from_left, &options).unwrap();
        let images = rectify.rectify(raw[0].into(), raw[1].into()).unwrap();
        let images = images.map(|image| image.map(|&number| f64::from(number)));
        let geometry = rectify.geometry();
        let rectified_from_body = cameras.body_from_rectified_left().inverse();
        let mut off = Off {
            rows: Vec::new(),
            left: Vec::new(),
            right: Vec::new(),
        };
        for &point in &points {
            let in_left = rectified_from_body.apply(point);
            let in_right = in_left + DVec3::X * geometry.offset;
            let places = [(in_left, geometry.left), (in_right, geometry.right)]
                .map(|(point, k)| k.pixel_from_normalized(point.truncate() / point.z));
            let centres = [0, 1].map(|i| centroid(&images[i], places[i]));
            if let [Some((left, a)), Some((right, b))] = centres
                && a > 400.0
                && b > 400.0
            {
                if method == Method::Full && cameras.rectify().geometry() == geometry {
                    let [x, y] = [places[0].x, places[0].y].map(|at| at.round() as u32);
                    let z = f64::from(*seen.z.0.get(x, y).unwrap());
                    assert!((z / in_left.z - 1.0).abs() < 2e-3, "{z} {in_left}");
                }
                off.rows.push((left.y - right.y).abs());
                off.left.push((left.xy() - places[0].xy()).length());
                off.right.push((right.xy() - places[1].xy()).length());
            }
        }
        off
    })
}

/// What a share of them stays within. Of a few dots, part lies beyond the border.
fn within(values: &[f64], share: f64) -> f64 {
    let mut values = values.to_vec();
    values.sort_by(f64::total_cmp);
    values[((values.len() - 1) as f64 * share) as usize]
}

#[test]
fn the_rectified_pair_of_a_wide_unit_has_its_points_in_the_same_rows() {
    let wide = unit("oak-d-pro-w-poe", "oak-d-pro-w-poe.json");
    let cameras = PairCameras::new(&wide, &PairOptions::default()).unwrap();
    assert_eq!(cameras.rectify().method(), Method::Mesh);
    let [full, mesh] = off(&wide, 0.8, [Method::Full, Method::Mesh]);
    for (name, off) in [("full", &full), ("mesh", &mesh)] {
        let [half, most] = [0.5, 0.95].map(|share| within(&off.rows, share));
        let [left, right] = [&off.left, &off.right].map(|off| within(off, 0.95));
        println!(
            "{name}: {} dots, rows {half:.3} {most:.3}, {left:.3} {right:.3} px",
            off.rows.len()
        );
    }
    assert!(full.rows.len() > 1500 && within(&full.rows, 0.95) < 0.1);
    assert!(within(&full.left, 0.95) < 0.15 && within(&full.right, 0.95) < 0.15);
    // The mesh leaves out all but eight coefficients.
    assert!(within(&mesh.rows, 0.95) < 0.5 && within(&mesh.rows, 0.95) > within(&full.rows, 0.95));
}

#[test]
fn after_a_homography_the_lens_remains() {
    let twin = unit("oak-d-pro-poe", "example-oak-d-pro-poe.json");
    let cameras = PairCameras::new(&twin, &PairOptions::default()).unwrap();
    assert_eq!(cameras.rectify().method(), Method::Homography);
    let [full, homography] = off(&twin, 0.5, [Method::Full, Method::Homography]);
    for (name, off) in [("full", &full), ("homography", &homography)] {
        let [half, most] = [0.5, 0.95].map(|share| within(&off.rows, share));
        let [left, right] = [&off.left, &off.right].map(|off| within(off, 0.95));
        println!(
            "{name}: {} dots, rows {half:.3} {most:.3}, {left:.3} {right:.3} px",
            off.rows.len()
        );
    }
    assert!(full.rows.len() > 2000 && within(&full.rows, 0.95) < 0.1);
    assert!(within(&full.left, 0.95) < 0.15 && within(&full.right, 0.95) < 0.15);
    assert!(within(&homography.left, 0.95) > 0.5);
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
        lens: oaktwin_usd::asset::LensChoice::Fisheye,
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
        "OAK4-D: projector: the model has no dot projector; turn it off, or choose a Pro model"
    );
    assert_eq!(
        error("oak-d-pro-poe", |o| o.projector = 1.5),
        "projector: 1.5 is out of range; give 0 to 1"
    );
    assert!(error("oak4-d", |o| o.ambient = f64::NAN).starts_with("ambient: NaN is out of range"));
    assert!(error("oak4-d", |o| o.size = Some(ImageSize::new(0, 3))).contains("has no pixel"));
    assert!(error("oak4-d", |o| o.imager.full_well_e = 0.0).starts_with("fullWell"));
}
