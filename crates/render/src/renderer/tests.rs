use rayon::prelude::*;

use super::*;
use crate::{AnnotateOptions, fixture};

#[test]
fn moved_instances_look_as_if_they_had_always_been_there() {
    use oaktwin_camera::math::{DQuat, DVec3};
    use oaktwin_image::annotation::Annotator;

    let mut scene = Scene::default();
    for z in [2.0, 3.0, 4.0] {
        fixture::placed(
            &mut scene,
            "/Part",
            fixture::rectangle([-0.3 * z, 0.1], [-0.5, 0.5], z),
        );
    }
    let view = fixture::view();
    let all = [
        Annotator::DistanceToImagePlane,
        Annotator::Rgb,
        Annotator::Normals,
        Annotator::InstanceIdSegmentation,
    ];
    let render = |renderer: &Renderer, backend| {
        format!(
            "{:?}",
            renderer.annotate(&view, &all, backend, &AnnotateOptions::default())
        )
    };
    let mut moving = Renderer::new(scene.clone());
    let before = render(&moving, Backend::Ray);
    for step in 1..4_u32 {
        let turn = DQuat::from_rotation_z(0.3 * f64::from(step));
        let pose = DAffine3::from_rotation_translation(turn, DVec3::new(0.2, 0.1, -0.4 * f64::from(step)));
        moving.set_poses([(1, pose), (7, pose)]);
        scene.instances[1].world_from_mesh = pose;
        for backend in [Backend::Ray, Backend::Raster] {
            let after = render(&moving, backend);
            assert!(
                after == render(&Renderer::new(scene.clone()), backend),
                "{backend:?}"
            );
            assert_ne!(after, before);
        }
    }
}

#[test]
fn replaced_instances_look_as_if_they_had_always_been_there() {
    use oaktwin_image::annotation::Annotator;
    use oaktwin_scene::MaterialSpan;

    let red = |value: f32| Material {
        base_color: Some([value, 0.1, 0.1]),
        ..Material::default()
    };
    let mut scene = Scene::default();
    for z in [2.0, 3.0, 4.0] {
        let mut mesh = fixture::rectangle([-0.3 * z, 0.1], [-0.5, 0.5], z);
        mesh.materials = vec![MaterialSpan {
            end: 2,
            material: Some(0),
        }];
        fixture::placed(&mut scene, "/Part", mesh);
    }
    scene.materials = vec![red(0.9)];
    let view = fixture::view();
    let all = [
        Annotator::Rgb,
        Annotator::DistanceToImagePlane,
        Annotator::InstanceIdSegmentation,
    ];
    let render = |renderer: &Renderer, backend| {
        format!(
            "{:?}",
            renderer.annotate(&view, &all, backend, &AnnotateOptions::default())
        )
    };
    let mut first = scene.clone();
    first.meshes.truncate(2);
    first.instances.truncate(2);
    let mut moving = Renderer::new(first);
    for backend in [Backend::Ray, Backend::Raster] {
        let _ = render(&moving, backend);
    }
    moving.add(scene.meshes.split_off(2), []);
    let mut other = scene.instances[2].clone();
    other.material_offset = 1;
    let placed = vec![
        scene.instances[1].clone(),
        other.clone(),
        Instance {
            world_from_mesh: DAffine3::from_translation([0.3, 0.1, 0.0].into()),
            ..other
        },
    ];
    let materials = vec![red(0.5), red(0.2)];
    scene.meshes = moving.scene().meshes.clone();
    scene.instances.clone_from(&placed);
    scene.materials.clone_from(&materials);
    moving.place(placed, materials, Vec::new());
    let mut plain = scene.clone();
    plain
        .instances
        .iter_mut()
        .for_each(|instance| instance.material_offset = 0);
    for backend in [Backend::Ray, Backend::Raster] {
        let after = render(&moving, backend);
        assert!(
            after == render(&Renderer::new(scene.clone()), backend),
            "{backend:?}"
        );
        assert_ne!(after, render(&Renderer::new(plain.clone()), backend));
    }
}

#[test]
fn some_blocks_are_rendered_like_the_whole_image() {
    let mut scene = Scene::default();
    for step in 0..300u16 {
        let z = 3.0 - 0.005 * f64::from(step);
        let side = 0.01 * f64::from(step % 17) - 0.1;
        fixture::placed(
            &mut scene,
            "/Rectangle",
            fixture::rectangle([side * z, (side + 0.02) * z], [-1.0, 1.0], z),
        );
    }
    let view = fixture::view();
    let renderer = Renderer::new(scene);
    for backend in [Backend::Ray, Backend::Raster] {
        let whole = renderer.visibility(&view, backend);
        let (width, height) = (whole.hits.width(), whole.hits.height());
        for (across, down) in [(1, 0), (3, 2), (20, 7)] {
            let mut blocks = Blocks::none(width, height);
            for (x, y) in [(0, 0), (width - 1, height - 1), (8 * across, 8 * down + 7)] {
                blocks.add(x, y);
            }
            let part = renderer.visibility_in(&blocks, &view, backend);
            let places = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
            let mut compared = 0;
            for (x, y) in places.filter(|(x, y)| blocks.contains(x / 8, y / 8)) {
                compared += 1;
                assert_eq!(part.z.0.get(x, y), whole.z.0.get(x, y));
                assert_eq!(part.hits.get(x, y), whole.hits.get(x, y));
            }
            assert_eq!(compared, 3 * 64);
            assert_ne!(part.hits, whole.hits);
        }
    }
}

#[test]
fn many_views_at_once_wait_for_one_preparation() {
    let mut scene = Scene::default();
    for step in 0..300u16 {
        let z = 3.0 + 0.01 * f64::from(step);
        fixture::placed(
            &mut scene,
            "/Rectangle",
            fixture::rectangle([-z, 0.01 * z], [-1.0, 1.0], z),
        );
    }
    let view = fixture::view();
    let renderer = Renderer::new(scene);
    let alone = Renderer::new(renderer.scene().clone()).depth(&view, Backend::Ray);
    let backends = [Backend::Raster, Backend::Ray, Backend::Ray, Backend::Raster];
    let all: Vec<_> = backends
        .repeat(8)
        .into_par_iter()
        .map(|backend| renderer.depth(&view, backend))
        .collect();
    assert_eq!(all[1], alone);
    assert!(all.chunks(4).all(|chunk| *chunk == all[..4]));
}
