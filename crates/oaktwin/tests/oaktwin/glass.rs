//! What both stereo engines make of a mirror, a window, a chrome ball and black cloth.

#![expect(clippy::unwrap_used, reason = "a test")]

use oaktwin::camera::ImageSize;
use oaktwin::camera::math::{DAffine3, DVec3};
use oaktwin::catalog::Catalog;
use oaktwin::image::ZDepth;
use oaktwin::image::annotation::Annotator;
use oaktwin::render::{Renderer, Rig, RigSpec, look_at};
use oaktwin::scene::{Instance, Material, MaterialSpan, Scene, Transmission, shape};
use oaktwin::sensor::{EngineKind, STEREO_MATCHING, STEREO_NOISE, SensorOptions, TIME_OF_FLIGHT};

use crate::plates::{plate, room};

const SIZE: ImageSize = ImageSize::new(640, 400);
const STEREO: &str = "OAK-D Pro PoE";
/// The distance of what is in front of the wall.
const NEAR: f32 = 1.5;

/// The place of the wall behind the camera: its image in the mirror has a disparity near a whole pixel, as the wall ahead has, where the
/// matcher has no error of its own.
const BEHIND: f32 = -0.77;

/// A random pattern 3 m ahead and another behind the camera; at 1.5 m a mirror on the left, black cloth, and a pane on the right; above
/// them a ball of chrome.
fn scene() -> Scene {
    let mut scene = room(256, None);
    plate(&mut scene, 3.0, [-9.0, 9.0], [-9.0, 9.0], 256.0 * 0.02);
    plate(&mut scene, BEHIND, [-9.0, 9.0], [-9.0, 9.0], 256.0 * 0.03);
    let mirror = Material {
        base_color: Some([0.9; 3]),
        metallic: 1.0,
        roughness: 0.0,
        ..Material::default()
    };
    let cloth = Material {
        base_color: Some([0.004; 3]),
        roughness: 1.0,
        ..Material::default()
    };
    let pane = Material {
        roughness: 0.0,
        transmission: Some(Transmission {
            share: 1.0,
            mask: None,
            tint: Some([0.9, 1.0, 0.9]),
            refracts: false,
        }),
        ..Material::default()
    };
    for (material, y) in [
        (mirror.clone(), [0.3, 1.0]),
        (cloth, [-0.25, 0.25]),
        (pane, [-1.0, -0.3]),
    ] {
        plate(&mut scene, NEAR, y, [-0.6, 0.2], 1.0);
        scene.meshes.last_mut().unwrap().materials[0].material = Some(added(&mut scene, material));
    }
    let mut ball = shape::sphere(0.25);
    ball.materials = vec![MaterialSpan {
        end: u32::try_from(ball.triangles.len()).unwrap(),
        material: Some(added(&mut scene, mirror)),
    }];
    scene.instances.push(Instance {
        mesh: u32::try_from(scene.meshes.len()).unwrap(),
        path: "/Ball".to_owned(),
        world_from_mesh: DAffine3::from_translation(DVec3::new(NEAR.into(), 0.0, 0.5)),
        labels: Vec::new(),
        material_offset: 0,
    });
    scene.meshes.push(ball);
    scene
}

fn added(scene: &mut Scene, material: Material) -> u32 {
    scene.materials.push(material);
    u32::try_from(scene.materials.len() - 1).unwrap()
}

fn measured(renderer: &Renderer, model: &str, engine: &'static EngineKind) -> (ZDepth, ZDepth, f64) {
    let catalog = Catalog::builtin();
    let twin = catalog.nominal(catalog.device(model).unwrap());
    let is_stereo = *engine != TIME_OF_FLIGHT;
    let spec = RigSpec {
        size: is_stereo.then_some(SIZE),
        cameras: match is_stereo {
            true => Vec::new(),
            false => vec!["Camera_pseudo_depth_tof".to_owned()],
        },
        annotators: vec![Annotator::DistanceToImagePlane, Annotator::DepthSensorDistance],
        sensor: SensorOptions {
            engine: Some(engine.into()),
            parameters: match is_stereo {
                true => vec![("subpixel".to_owned(), "true".into())],
                false => Vec::new(),
            },
            ..SensorOptions::default()
        },
        ..RigSpec::default()
    };
    let (mut rig, _) = Rig::new(&twin, &spec).unwrap();
    let pose = look_at(DVec3::ZERO, DVec3::X, DVec3::Z).unwrap();
    let (shots, _) = rig.shoot(renderer, Some(&pose), 0).unwrap();
    let frame = shots.into_iter().next().unwrap().frame;
    let focal_px = rig.cameras()[0].camera.intrinsics.fx;
    (
        frame.depth_sensor_distance.unwrap(),
        frame.distance_to_image_plane.unwrap(),
        focal_px,
    )
}

/// The values of the pixels that see a rectangle at the distance of what is in front of the wall.
fn seen(depth: &ZDepth, focal_px: f64, y: [f64; 2], z: [f64; 2]) -> Vec<f32> {
    let (width, height) = (f64::from(depth.0.width()), f64::from(depth.0.height()));
    let is_within = |at: f64, range: [f64; 2]| at >= range[0] && at <= range[1];
    let mut values = Vec::new();
    for (row, line) in depth
        .0
        .pixels()
        .chunks_exact(depth.0.width() as usize)
        .enumerate()
    {
        for (column, value) in line.iter().enumerate() {
            let scale = f64::from(NEAR) / focal_px;
            let left = (width / 2.0 - column as f64) * scale;
            let up = (height / 2.0 - row as f64) * scale;
            if is_within(left, y) && is_within(up, z) {
                values.push(*value);
            }
        }
    }
    values
}

fn median(values: &[f32]) -> f32 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f32::total_cmp);
    sorted[sorted.len() / 2]
}

#[test]
fn both_engines_see_the_mirrored_room_and_what_lies_behind_glass() {
    let renderer = Renderer::new(scene());
    let (noise, truth, focal_px) = measured(&renderer, STEREO, &STEREO_NOISE);
    let (matched, _, _) = measured(&renderer, STEREO, &STEREO_MATCHING);
    // In the mirror, the wall behind the camera is as far away as the path is long. Edges, whose width is a window of the matcher, are left
    // out.
    let parts = [
        ("mirror", [0.4, 0.9], [-0.5, 0.1], 2.0 * NEAR - BEHIND),
        ("cloth", [-0.1, 0.1], [-0.5, 0.1], 0.0),
        ("pane", [-0.9, -0.4], [-0.5, 0.1], 3.0),
        ("wall", [0.5, 1.0], [0.3, 0.6], 3.0),
    ];
    let mut counts = [0, 0];
    for (name, y, z, expected) in parts {
        let [noise, matched] = [&noise, &matched].map(|depth| seen(depth, focal_px, y, z));
        for (engine, depth) in [("noise", &noise), ("matching", &matched)] {
            let found = median(depth);
            assert!(
                (found - expected).abs() <= 0.03 * expected,
                "{name} {engine}: {found} {expected}"
            );
        }
        // On cloth without a texture, the matcher finds some noise.
        let least = if name == "cloth" { 0.75 } else { 0.98 };
        let agrees = |(a, b): &(&f32, &f32)| (**a - **b).abs() <= 0.1 * a.max(**b);
        let same = noise.iter().zip(&matched).filter(agrees).count();
        let share = same as f64 / noise.len() as f64;
        assert!(share >= least, "{name}: the engines agree in {share}");
        counts = [counts[0] + same, counts[1] + noise.len()];
    }
    assert!(counts[0] as f64 >= 0.9 * counts[1] as f64, "{counts:?}");
    // The truth is the surface, and the image in the ball is nearer than half its radius behind its surface.
    let surface = seen(&truth, focal_px, [0.4, 0.9], [-0.5, 0.1]);
    assert!((median(&surface) - NEAR).abs() < 1e-4);
    let ball = seen(&noise, focal_px, [-0.05, 0.05], [0.45, 0.55]);
    let way = NEAR - 0.25 - BEHIND;
    let image = NEAR - 0.25 + 0.125 * way / (way + 0.125);
    assert!((median(&ball) - image).abs() < 0.05, "{} {image}", median(&ball));
    let ball = seen(&matched, focal_px, [-0.05, 0.05], [0.45, 0.55]);
    assert!((median(&ball) - image).abs() < 0.08, "{} {image}", median(&ball));
}

#[test]
fn mirrors_lengthen_the_path_of_light_in_flight() {
    let renderer = Renderer::new(scene());
    let (depth, _, focal_px) = measured(&renderer, "OAK-D ToF", &TIME_OF_FLIGHT);
    for (y, expected) in [([0.4, 0.6], 2.0 * NEAR - BEHIND), ([-0.6, -0.4], 3.0)] {
        let found = median(&seen(&depth, focal_px, y, [-0.3, 0.0]));
        assert!((found - expected).abs() <= 0.03 * expected, "{found} {expected}");
    }
}
