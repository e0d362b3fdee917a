//! Both backends against the reference in double precision.

use oaktwin_camera::math::{DAffine3, DMat3, DQuat, DVec3};
use oaktwin_camera::{Camera, ImageSize, Intrinsics, LensModel, RigidTransform};
use oaktwin_render::{Backend, Clip, Renderer, View};
use oaktwin_scene::{Instance, Mesh, Scene};
use oaktwin_testkit::agreement;
use oaktwin_testkit::reference::Reference;

use crate::random::Random;

pub(crate) fn check(bytes: &[u8]) {
    let mut random = Random::new(bytes);
    let view = view(&mut random);
    let renderer = Renderer::new(scene(&mut random));
    let reference = Reference::new(renderer.scene(), &view);
    let truth = reference.image();
    for backend in [Backend::Raster, Backend::Ray] {
        if let Err(what) = agreement::compare(&renderer, &view, backend, &reference, &truth) {
            panic!("{backend:?}: {what}\n{view:?}\n{:?}", renderer.scene());
        }
    }
}

fn view(random: &mut Random<'_>) -> View {
    let size = ImageSize::new(1 + random.up_to(31), 1 + random.up_to(23));
    let hfov = (20.0 + f64::from(random.up_to(90))).to_radians();
    View {
        camera: Camera::new(Intrinsics::from_hfov(size, hfov), LensModel::Pinhole),
        world_from_camera: RigidTransform::new(rotation(random), point(random)),
        clip: Clip {
            near_m: random.pick(&[0.05, 0.001, 1.0]),
            far_m: random.pick(&[f64::INFINITY, 20.0]),
        },
    }
}

fn scene(random: &mut Random<'_>) -> Scene {
    let mut scene = Scene::default();
    for number in 0..=random.up_to(2) {
        scene.meshes.push(mesh(random));
        for _ in 0..=random.up_to(1) {
            let stretch = DVec3::new(stretch(random), stretch(random), stretch(random));
            let matrix = rotation(random) * DMat3::from_diagonal(stretch);
            scene.instances.push(Instance {
                mesh: number,
                path: format!("/Thing_{}", scene.instances.len()),
                world_from_mesh: DAffine3::from_mat3_translation(matrix, point(random)),
                labels: Vec::new(),
                material_offset: 0,
            });
        }
    }
    scene
}

#[expect(clippy::cast_possible_truncation, reason = "positions are float32")]
fn mesh(random: &mut Random<'_>) -> Mesh {
    let count = 3 + random.up_to(9);
    let scale = random.pick(&[1.0, 1.0, 0.01, 300.0]);
    let single = |point: DVec3| point.to_array().map(|x| x as f32);
    let mut positions: Vec<[f32; 3]> = Vec::new();
    for _ in 0..count {
        let near_line = positions.len() > 1 && random.up_to(3) == 3;
        let position = if near_line {
            // The third corner of a needle.
            let last = u32::try_from(positions.len() - 1).unwrap_or(0);
            let mut end = || positions[random.up_to(last) as usize];
            let [a, b] = [end(), end()].map(|end| DVec3::from(end.map(f64::from)));
            let away = random.pick(&[0.0, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2]) * (b - a).length();
            a.lerp(b, f64::from(random.byte()) / 128.0 - 0.5) + away * direction(random)
        } else {
            scale * point(random)
        };
        positions.push(single(position));
    }
    let mut corner = || random.up_to(count - 1);
    Mesh {
        positions,
        triangles: (0..=count).map(|_| [corner(), corner(), corner()]).collect(),
        ..Mesh::default()
    }
}

/// Returns a point within 8 m of the origin, on a grid of 1/16 m or finer.
fn point(random: &mut Random<'_>) -> DVec3 {
    let mut axis = || {
        let coarse = f64::from(random.byte()) / 16.0 - 8.0;
        if random.up_to(3) == 3 {
            coarse + f64::from(random.byte()) / 4096.0
        } else {
            coarse
        }
    };
    DVec3::new(axis(), axis(), axis())
}

fn stretch(random: &mut Random<'_>) -> f64 {
    random.pick(&[1.0, 1.0, -1.0, 0.25, 2.5, -0.05])
}

fn direction(random: &mut Random<'_>) -> DVec3 {
    point(random).try_normalize().unwrap_or(DVec3::Z)
}

fn rotation(random: &mut Random<'_>) -> DMat3 {
    let axis = direction(random);
    // Rays along an axis meet the grid of the points exactly.
    let angle = f64::from(random.byte().saturating_sub(64)) / 30.0;
    DMat3::from_quat(DQuat::from_axis_angle(axis, angle))
}

pub(crate) fn seeds() -> Vec<Vec<u8>> {
    (0..8u8)
        .map(|seed| {
            (0..200u8)
                .map(|at| at.wrapping_mul(seed * 2 + 1).rotate_left(u32::from(seed)))
                .collect()
        })
        .collect()
}
