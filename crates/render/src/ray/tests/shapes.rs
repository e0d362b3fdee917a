use super::*;

/// A closed ball of 8 · 4^levels triangles.
fn ball(levels: u32) -> Mesh {
    let mut triangles: Vec<[DVec3; 3]> = Vec::new();
    for sign in 0..8u32 {
        let s = |bit: u32| if sign >> bit & 1 == 0 { 1.0 } else { -1.0 };
        triangles.push([DVec3::X * s(0), DVec3::Y * s(1), DVec3::Z * s(2)]);
    }
    for _ in 0..levels {
        triangles = triangles
            .iter()
            .flat_map(|&[a, b, c]| {
                let (ab, bc, ca) = ((a + b).normalize(), (b + c).normalize(), (c + a).normalize());
                [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
            })
            .collect();
    }
    let corners: Vec<[f32; 3]> = triangles
        .iter()
        .flatten()
        .map(|p| p.as_vec3().to_array())
        .collect();
    soup(&corners)
}

#[test]
fn a_closed_surface_has_no_holes_from_inside() {
    let scene = Scene {
        meshes: vec![ball(4)],
        instances: vec![instance(0, random_transform(&mut Numbers(5)))],
        ..Scene::default()
    };
    let caster = RayCaster::new(&scene);
    let centre = scene.instances[0].world_from_mesh.translation;
    for mut view in every_lens(301, 203) {
        view.world_from_camera.translation = centre + DVec3::new(0.01, 0.02, -0.03);
        let seen = caster.visibility(&scene, &view);
        let places = (0..203u32).flat_map(|y| (0..301u32).map(move |x| (x, y)));
        for ((x, y), hit) in places.zip(seen.hits.pixels()) {
            let pixel = PixelPoint::<Usd>::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
            assert_eq!(
                hit.is_miss(),
                view.camera.unproject(pixel).is_none(),
                "{x} {y} {view:?}"
            );
        }
    }
}

#[test]
fn rays_through_the_vertices_of_a_grid_hit() {
    // Rays exactly through vertices and along edges.
    let size = 16u16;
    let at = |i: u16| f32::from(i) / f32::from(size) * 4.0 - 2.0;
    let mut corners = Vec::new();
    for y in 0..size {
        for x in 0..size {
            let p = |i: u16, j: u16| [at(x + i), at(y + j), 2.0];
            corners.extend([p(0, 0), p(1, 0), p(0, 1), p(1, 0), p(1, 1), p(0, 1)]);
        }
    }
    let scene = scene_of(soup(&corners));
    let camera = Camera::new(
        Intrinsics::new(
            ImageSize::new(17, 17),
            8.0,
            8.0,
            PixelPoint::<oaktwin_camera::OpenCv>::new(8.0, 8.0),
        ),
        LensModel::Pinhole,
    );
    let view = View {
        camera,
        ..view(LensModel::Pinhole, 1, 1, 60.0)
    };
    let seen = RayCaster::new(&scene).visibility(&scene, &view);
    assert!(seen.z.0.pixels().iter().all(|z| *z == 2.0));
    assert_like_brute_force(&scene, &view);
}

#[test]
fn tiny_and_huge_coordinates() {
    for exponent in [-30, -20, -10, 10, 20, 30] {
        let scale = 10f64.powi(exponent);
        let mut scene = random_scene(3);
        for mesh in &mut scene.meshes {
            for p in &mut mesh.positions {
                *p = (DVec3::from(p.map(f64::from)) * scale).as_vec3().to_array();
            }
        }
        // Scaled back by the transform.
        for placed in &mut scene.instances {
            placed.world_from_mesh *= DAffine3::from_scale(DVec3::splat(1.0 / scale));
        }
        assert_like_brute_force(&scene, &view(LensModel::Pinhole, 40, 30, 77.0));
        // Without scaling back.
        let mut scene = random_scene(3);
        for placed in &mut scene.instances {
            placed.world_from_mesh = DAffine3::from_scale(DVec3::splat(scale)) * placed.world_from_mesh;
        }
        let mut view = view(LensModel::Pinhole, 40, 30, 77.0);
        view.clip = Clip {
            near_m: 0.01 * scale,
            far_m: f64::INFINITY,
        };
        assert_like_brute_force(&scene, &view);
    }
}

#[test]
fn far_from_the_origin() {
    // A city in map coordinates: positions lie on a grid of 1/16 m.
    let mut scene = random_scene(4);
    let offset = DVec3::new(5e5, 5e6, 100.0);
    for mesh in &mut scene.meshes {
        for p in &mut mesh.positions {
            *p = (DVec3::from(p.map(f64::from)) * 100.0 + offset)
                .as_vec3()
                .to_array();
        }
    }
    scene.instances.truncate(1);
    scene.instances[0].world_from_mesh = DAffine3::IDENTITY;
    let mut view = view(LensModel::Pinhole, 40, 30, 77.0);
    view.world_from_camera.translation = offset + DVec3::new(0.123, 0.456, -150.0);
    assert_like_brute_force(&scene, &view);
}

/// The distance of two numbers in units in the last place.
fn ulps(a: f32, b: f32) -> u32 {
    a.to_bits().abs_diff(b.to_bits())
}

#[test]
fn depth_is_exact_at_any_angle_of_incidence() {
    for (degrees, largest) in [(0.0, 1), (30.0, 1), (60.0, 1), (75.0, 1), (85.0, 1), (89.9, 16)] {
        for seed in 0..4 {
            let mut numbers = Numbers(seed);
            // A plane of many triangles at some metres, at an angle to the camera.
            let mut corners = Vec::new();
            for _ in 0..200 {
                let centre = numbers.vector() * DVec3::new(4.0, 4.0, 0.0);
                for _ in 0..3 {
                    corners.push(
                        (centre + numbers.vector() * DVec3::new(2.0, 2.0, 0.0))
                            .as_vec3()
                            .to_array(),
                    );
                }
            }
            let turn = DMat3::from_rotation_y(f64::to_radians(degrees));
            let mut scene = scene_of(soup(&corners));
            scene.instances[0].world_from_mesh =
                DAffine3::from_mat3_translation(turn, DVec3::new(0.1, 0.2, 7.3));
            for view in [view(LensModel::Pinhole, 61, 43, 30.0), fisheye(61, 43, 40.0)] {
                let ours = RayCaster::new(&scene).visibility(&scene, &view);
                let truth = brute::visibility(&scene, &view);
                for ((ours, truth), (a, b)) in (ours.z.0.pixels().iter().zip(truth.z.0.pixels()))
                    .zip(ours.hits.pixels().iter().zip(truth.hits.pixels()))
                {
                    assert_eq!(a.is_miss(), b.is_miss());
                    assert!(ulps(*ours, *truth) <= largest, "{degrees}: {ours} {truth}");
                }
            }
        }
    }
}

#[test]
fn an_unbalanced_tree() {
    // Each triangle is larger and farther than the one before.
    let mut corners = Vec::new();
    let mut at = 1e-5f32;
    while at < 1e7 {
        corners.extend([[at, at, at], [2.0 * at, at, at], [at, 2.0 * at, at]]);
        at *= 1.02;
    }
    let scene = scene_of(soup(&corners));
    let view = View {
        clip: Clip {
            near_m: 1e-7,
            far_m: f64::INFINITY,
        },
        ..view(LensModel::Pinhole, 16, 16, 120.0)
    };
    assert_like_brute_force(&scene, &view);
}
