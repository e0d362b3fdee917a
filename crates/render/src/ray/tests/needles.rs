//! Triangles so thin, and so nearly pointing at the camera, that single precision does not know their sides.

use super::*;

/// A needle beside a ray of the camera: three corners along it, off by up to `width` metres.
fn needle(numbers: &mut Numbers, along: DVec3, width: f64) -> [DVec3; 3] {
    let mut corner = |near: f64, far: f64| {
        let distance = near + (far - near) * numbers.next();
        along * distance + width * numbers.vector()
    };
    [corner(0.3, 1.0), corner(1.0, 5.0), corner(-2.0, 9.0)]
}

/// The angle between a ray and the arc that an edge covers, radians.
fn angle_to_edge(ray: DVec3, p: DVec3, q: DVec3) -> f64 {
    let across = p.cross(q);
    let foot = ray - across * (ray.dot(across) / across.length_squared());
    let is_between = p.cross(foot).dot(across) >= 0.0 && foot.cross(q).dot(across) >= 0.0;
    if foot.is_finite() && is_between {
        (ray.dot(across).abs() / (ray.length() * across.length())).asin()
    } else {
        ray.angle_between(p).min(ray.angle_between(q))
    }
}

/// The angle between a ray and a triangle in double precision, radians.
fn angle_to(ray: DVec3, [a, b, c]: [DVec3; 3]) -> f64 {
    // A needle with a corner behind the camera can be seen from so near that it is wide.
    let sides = [a.cross(b).dot(ray), b.cross(c).dot(ray), c.cross(a).dot(ray)];
    if sides.iter().all(|side| *side > 0.0) || sides.iter().all(|side| *side < 0.0) {
        return 0.0;
    }
    let edges = [(a, b), (b, c), (c, a)].map(|(p, q)| angle_to_edge(ray, p, q));
    edges.into_iter().fold(f64::INFINITY, f64::min)
}

/// Places a needle in the world, and returns its corners in single precision, relative to the camera.
fn stored(corners: [DVec3; 3], world_from_camera: &RigidTransform) -> ([[f32; 3]; 3], [DVec3; 3]) {
    let world = corners.map(|p| {
        let p = world_from_camera.rotation * p + world_from_camera.translation;
        p.as_vec3().to_array()
    });
    let back = world.map(|p| {
        let p = DVec3::from(p.map(f64::from)) - world_from_camera.translation;
        world_from_camera.rotation.transpose() * p
    });
    (world, back)
}

fn poses(numbers: &mut Numbers) -> RigidTransform {
    let axis = numbers.vector().normalize_or(DVec3::X);
    let turn = DMat3::from_axis_angle(axis, 6.0 * numbers.next());
    RigidTransform::new(turn, numbers.vector() * 8.0)
}

const WIDTHS: [f64; 6] = [0.0, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4];

#[test]
fn needles_are_seen_where_they_are() {
    let mut numbers = Numbers(41);
    let mut hits = 0;
    for round in 0..1200usize {
        let width = WIDTHS[round % WIDTHS.len()];
        let world_from_camera = poses(&mut numbers);
        let view = View {
            world_from_camera,
            ..view(LensModel::Pinhole, 40, 30, 77.0)
        };
        // Half of them point exactly at the centre of a pixel.
        let pixel = PixelPoint::<Usd>::new(
            (40.0 * numbers.next()).floor() + if round % 4 < 2 { 0.5 } else { numbers.next() },
            (30.0 * numbers.next()).floor() + if round % 4 < 2 { 0.5 } else { numbers.next() },
        );
        let along = view.camera.unproject(pixel).unwrap();
        let (world, corners) = stored(needle(&mut numbers, along, width), &world_from_camera);
        let scene = scene_of(soup(&world));
        let seen = RayCaster::new(&scene).visibility(&scene, &view);
        for (x, y) in (0..30).flat_map(|y| (0..40).map(move |x| (x, y))) {
            if seen.hits.get(x, y).unwrap().is_miss() {
                continue;
            }
            hits += 1;
            let ray = PixelPoint::<Usd>::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
            let off = angle_to(view.camera.unproject(ray).unwrap(), corners);
            // 0.02 px.
            assert!(
                off < 8e-4,
                "round {round}, ({x}, {y}): {off} rad beside {corners:?}"
            );
        }
    }
    assert!(hits > 20, "{hits}");
}

#[test]
fn single_rays_meet_needles_where_they_are() {
    let mut numbers = Numbers(43);
    let mut hits = 0;
    for round in 0..3000usize {
        let width = WIDTHS[round % WIDTHS.len()];
        let world_from_camera = poses(&mut numbers);
        let along = (numbers.vector() + DVec3::Z * 1.5).normalize();
        let (world, corners) = stored(needle(&mut numbers, along, width), &world_from_camera);
        let scene = scene_of(soup(&world));
        let caster = RayCaster::new(&scene);
        let mut stack = Stack::default();
        for step in 0..12 {
            let away = if step == 0 { 0.0 } else { 1e-6 * 4f64.powi(step) };
            let in_camera = along + away * numbers.vector();
            let ray = Ray {
                origin: world_from_camera.translation,
                direction: world_from_camera.rotation * in_camera,
                near: 1e-3,
                far: f64::INFINITY,
            };
            let found = caster.cast(&scene, ray, &mut stack);
            assert_eq!(found.is_some(), caster.is_occluded(&scene, ray, &mut stack));
            if found.is_some() {
                hits += 1;
                let off = angle_to(in_camera, corners);
                assert!(off < 8e-4, "round {round}: {off} rad beside {corners:?}");
            }
        }
    }
    assert!(hits > 20, "{hits}");
}
