use super::*;

/// A closed bumpy ball of about `2 n²` triangles around the origin.
fn ball(n: u32, radius: f64) -> Mesh {
    let mut positions = vec![DVec3::Y * radius, -DVec3::Y * radius];
    for ring in 1..n {
        for step in 0..n {
            let (latitude, longitude) = (
                std::f64::consts::PI * f64::from(ring) / f64::from(n),
                std::f64::consts::TAU * f64::from(step) / f64::from(n),
            );
            let direction = DVec3::new(
                latitude.sin() * longitude.cos(),
                latitude.cos(),
                latitude.sin() * longitude.sin(),
            );
            let bump = 1.0 + 0.1 * (9.0 * latitude).sin() * (7.0 * longitude).sin();
            positions.push(direction * radius * bump);
        }
    }
    let at = |ring: u32, step: u32| match ring {
        0 => 0,
        ring if ring == n => 1,
        ring => 2 + (ring - 1) * n + step % n,
    };
    let mut triangles = Vec::new();
    for ring in 0..n {
        for step in 0..n {
            let [a, b] = [at(ring, step), at(ring, step + 1)];
            let [c, d] = [at(ring + 1, step), at(ring + 1, step + 1)];
            triangles.extend(
                [[a, b, c], [b, d, c]]
                    .into_iter()
                    .filter(|[a, b, c]| a != b && b != c && a != c),
            );
        }
    }
    mesh(&positions, &triangles)
}

fn count_misses(scene: &Scene, view: &View) -> usize {
    render(scene, view)
        .z
        .0
        .pixels()
        .iter()
        .filter(|z| !z.is_finite())
        .count()
}

#[test]
fn a_closed_mesh_has_no_holes() {
    for (n, radius) in [(6, 1.0), (12, 4.0), (200, 3.0), (500, 2.0), (60, 1e-3), (60, 1e6)] {
        let scene = scene(ball(n, radius));
        let mut inside = view(640, 400, 90.0);
        inside.clip.near_m = radius * 1e-4;
        assert_eq!(count_misses(&scene, &inside), 0, "n = {n}");
        // With the pole straight ahead all triangles of a ring meet at a pixel centre.
        for (pitch, aside) in [(90.0, 0.0), (90.0, 0.3), (-90.0, 0.1), (37.0, 0.35)] {
            inside.world_from_camera = RigidTransform::new(
                DMat3::from_rotation_x(f64::to_radians(pitch)),
                DVec3::new(aside, aside / 2.0, -aside) * radius,
            );
            inside.camera.intrinsics.size = ImageSize::new(641, 401);
            assert_eq!(count_misses(&scene, &inside), 0, "n = {n}, {pitch} deg");
        }
    }
}

#[test]
fn a_ball_from_outside_matches_brute_force() {
    let mut scene = scene(ball(24, 1.0));
    scene.instances = [(-1.5, 4.0), (0.0, 3.0), (1.0, 9.0)]
        .map(|(x, z)| instance(0, DAffine3::from_translation(DVec3::new(x, 0.2, z))))
        .to_vec();
    let found = difference(&scene, &view(320, 200, 77.0));
    assert!(
        found.hits > 10_000 && found.depth <= 5 && found.triangle <= 5,
        "{found:?}"
    );
}

/// A square of `n` by `n` quads, from `-extent` to `extent` in x and z.
fn floor(n: u32, extent: f64, y: f64) -> Mesh {
    let side = n + 1;
    let coordinate = |i: u32| extent * (2.0 * f64::from(i) / f64::from(n) - 1.0);
    let positions: Vec<_> = (0..side * side)
        .map(|i| DVec3::new(coordinate(i % side), y, coordinate(i / side)))
        .collect();
    let triangles: Vec<_> = (0..n * n)
        .flat_map(|i| {
            let a = i / n * side + i % n;
            [[a, a + 1, a + side], [a + 1, a + side + 1, a + side]]
        })
        .collect();
    mesh(&positions, &triangles)
}

#[test]
fn a_floor_that_crosses_the_near_plane() {
    for n in [1, 2, 7, 16] {
        for extent in [3.0, 50.0, 1e6] {
            let scene = scene(floor(n, extent, 1.3));
            let mut view = view(160, 100, 90.0);
            view.world_from_camera.rotation = DMat3::from_rotation_z(0.2);
            let found = difference(&scene, &view);
            assert!(found.hits > 1000 && found.depth <= 2, "{n}, {extent}: {found:?}");
            // Looking down, without the horizon.
            view.world_from_camera.rotation = DMat3::from_rotation_x(-0.9);
            assert!(difference(&scene, &view).depth <= 2, "{n}, {extent}");
        }
    }
}

#[test]
fn a_camera_in_the_plane_of_a_mesh() {
    let scene = scene(floor(5, 10.0, 0.0));
    let found = difference(&scene, &view(101, 75, 70.0));
    assert!(
        found.depth <= 101,
        "at most the row that sees it edge-on: {found:?}"
    );
    let z = render(&scene, &view(100, 75, 70.0)).z.0;
    assert!(z.pixels().iter().all(|z| *z >= 0.01));
}

#[test]
fn huge_and_tiny_triangles_and_triangles_behind_the_camera() {
    let triangle = |scale: f64, z: f64| {
        mesh(
            &[
                DVec3::new(-scale, -scale * 0.9, z),
                DVec3::new(scale * 1.1, -scale, z * 1.5),
                DVec3::new(0.1 * scale, scale, z),
            ],
            &[[0, 1, 2]],
        )
    };
    for (scale, z, expected) in [
        (1e6, 3.0, 1..64_001),
        (1e12, 1e3, 1..64_001),
        (1e6, 1e6, 1..64_001),
        (1e-6, 2e-6, 0..1),
        (1e-6, 2.0, 0..2),
        (1.0, -3.0, 0..1),
        (1e6, -3.0, 0..1),
        (1e-30, 1.0, 0..2),
        (1e30, 1e30, 0..1),
    ] {
        let scene = scene(triangle(scale, z));
        let found = difference(&scene, &view(320, 200, 77.0));
        assert!(expected.contains(&found.hits), "{scale}, {z}: {found:?}");
        assert!(found.depth <= 2, "{scale}, {z}: {found:?}");
    }
    // A triangle of a micrometre, with a near plane that does not clip it.
    let mut near = view(320, 200, 77.0);
    near.clip.near_m = 1e-7;
    let found = difference(&scene(triangle(1e-6, 2e-6)), &near);
    assert!(found.hits > 1000 && found.depth <= 2, "{found:?}");
}

#[test]
fn needle_triangles() {
    let mut random = Random(5);
    let mut positions = Vec::new();
    let mut triangles = Vec::new();
    for at in 0..500u32 {
        let centre = random.point(2.0) + DVec3::Z * 5.0;
        let along = random.point(2.0);
        positions.extend([
            centre - along,
            centre + along,
            centre + along * 0.2 + random.point(0.01),
        ]);
        triangles.push([3 * at, 3 * at + 1, 3 * at + 2]);
    }
    let found = difference(&scene(mesh(&positions, &triangles)), &view(320, 200, 77.0));
    assert!(found.hits > 1000 && found.depth * 500 <= found.hits, "{found:?}");
}

#[test]
fn the_first_of_equally_near_triangles_is_visible() {
    let mut twice = scene(floor(20, 3.0, 0.0));
    twice.instances = vec![twice.instances[0].clone(); 3];
    let both = twice.meshes[0].triangles.clone();
    twice.meshes[0].triangles.extend(both.iter().rev());
    let mut view = view(200, 150, 70.0);
    view.world_from_camera = RigidTransform::new(DMat3::from_rotation_x(-0.9), DVec3::new(0.01, -2.0, -1.0));
    let seen = render(&twice, &view);
    let hits: Vec<_> = seen.hits.pixels().iter().filter(|hit| !hit.is_miss()).collect();
    assert!(hits.len() > 5000);
    assert!(hits.iter().all(|hit| hit.instance == 0 && hit.triangle < 800));
}

#[test]
fn invalid_triangles_are_skipped() {
    let mut bad = floor(2, 1.0, 0.5);
    bad.positions[0] = [f32::NAN, 0.0, 0.0];
    bad.positions[1] = [f32::INFINITY, 0.0, 0.0];
    bad.triangles.push([0, 1, 99]);
    let mut scene = scene(bad);
    scene.instances.push(instance(7, DAffine3::IDENTITY));
    scene.instances.push(instance(
        0,
        DAffine3::from_scale(DVec3::new(f64::NAN, f64::INFINITY, 1e300)),
    ));
    render(&scene, &view(64, 48, 77.0));
    render(&Scene::default(), &view(64, 48, 77.0));
}
