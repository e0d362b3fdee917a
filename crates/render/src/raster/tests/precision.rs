use super::*;

/// The largest errors of depth.
#[derive(Clone, Copy, Debug, Default)]
struct Worst {
    /// In units in the last place.
    ulp: f64,
    relative: f64,
    pixels: usize,
}

impl Worst {
    fn of(z: f32, truth: f64) -> Self {
        #[expect(clippy::cast_possible_truncation, reason = "rounds the true depth")]
        let nearest = truth as f32;
        let error = (f64::from(z) - truth).abs();
        Self {
            ulp: error / f64::from(nearest.next_up() - nearest),
            relative: error / truth,
            pixels: 1,
        }
    }

    fn or(self, other: Self) -> Self {
        Self {
            ulp: self.ulp.max(other.ulp),
            relative: self.relative.max(other.relative),
            pixels: self.pixels + other.pixels,
        }
    }
}

/// Measures errors at triangles of an angle of incidence and a range of extents in pixels.
fn errors(incidence_deg: f64, view: &View, extent: [f64; 2], seed: u64) -> Worst {
    let mut random = Random(seed);
    let mut worst = Worst::default();
    let k = view.camera.intrinsics;
    for _ in 0..12 {
        // A triangle around a ray, with its normal at the angle of incidence.
        let at = PixelPoint::<Usd>::new(
            random.within(0.1, 0.9) * f64::from(k.size.width),
            random.within(0.1, 0.9) * f64::from(k.size.height),
        );
        let ray = view.camera.unproject(at).unwrap();
        let distance = 10f64.powf(random.within(-0.5, 1.5));
        let sideways = ray.any_orthonormal_vector();
        let axis = DQuat::from_axis_angle(ray, random.within(0.0, 7.0)) * sideways;
        let normal = DQuat::from_axis_angle(axis, incidence_deg.to_radians()) * -ray;
        let (first, second) = normal.any_orthonormal_pair();
        let pixel = distance / k.fx;
        let corners = [0.0, 2.1, 4.2].map(|angle: f64| {
            let size = pixel * 10f64.powf(random.within(extent[0].log10(), extent[1].log10()));
            let angle = angle + random.within(-0.6, 0.6);
            ray * distance + (first * angle.cos() + second * angle.sin()) * size
        });
        let place = DAffine3::from_scale_rotation_translation(
            DVec3::splat(random.within(0.1, 3.0)),
            DQuat::from_scaled_axis(random.point(2.0)),
            random.point(10.0),
        );
        let from_world = place.inverse();
        let mut scene = scene(mesh(
            &corners.map(|p| from_world.transform_point3(p)),
            &[[0, 1, 2]],
        ));
        scene.instances[0].world_from_mesh = place;
        let [a, b, c] = scene.meshes[0]
            .corners(0)
            .unwrap()
            .map(|p| place.transform_point3(DVec3::from(p.map(f64::from))));
        let normal = (b - a).cross(c - a);
        let z = Rasterizer::new(&scene).depth(&scene, view).0;
        for (at, z) in (0..).zip(z.pixels()).filter(|(_, z)| z.is_finite()) {
            let centre = PixelPoint::<Usd>::new(
                f64::from(at % k.size.width) + 0.5,
                f64::from(at / k.size.width) + 0.5,
            );
            let ray = view.camera.unproject(centre).unwrap();
            // Rounding the corners to single precision rotates small triangles, and other rays have other incidence.
            let incidence = (normal.dot(ray).abs() / normal.length()).acos().to_degrees();
            if incidence > incidence_deg + 0.5 {
                continue;
            }
            let truth = a.dot(normal) / ray.dot(normal) * ray.z;
            worst = worst.or(Worst::of(*z, truth));
        }
    }
    worst
}

#[test]
fn depth_is_exact_to_single_precision() {
    let (mut below_75, mut below_85) = (Worst::default(), Worst::default());
    for view in [
        view(320, 200, 77.0),
        view(1280, 800, 77.0),
        view(40, 30, 100.0),
        view(5, 4, 77.0),
        view(640, 400, 20.0),
    ] {
        for (seed, extent) in (0..).zip([[0.5, 3.0], [2.0, 7.0], [3.0, 30.0], [30.0, 3000.0]]) {
            for incidence in [0.0, 30.0, 60.0, 75.0] {
                below_75 = below_75.or(errors(incidence, &view, extent, seed));
            }
            for incidence in [80.0, 85.0] {
                below_85 = below_85.or(errors(incidence, &view, extent, seed));
            }
        }
    }
    // Visible with --nocapture.
    println!("up to 75 deg: {below_75:?}; up to 85 deg: {below_85:?}");
    assert!(below_75.pixels > 10_000 && below_75.ulp <= 4.0);
    assert!(below_85.pixels > 10_000 && below_85.relative <= 1e-6);
}

#[test]
fn a_dense_mesh_is_exact_too() {
    const N: u32 = 150;
    let mut positions = Vec::new();
    for i in 0..(N + 1) * (N + 1) {
        let (x, y) = (f64::from(i % (N + 1)), f64::from(i / (N + 1)));
        let hill = (0.31 * x).sin() * (0.23 * y).cos();
        positions.push(DVec3::new(
            x * 0.04 - 3.0,
            y * 0.03 - 2.0,
            3.0 + 0.2 * hill + 0.02 * y,
        ));
    }
    let triangles: Vec<_> = (0..N * N)
        .flat_map(|i| {
            let a = i / N * (N + 1) + i % N;
            [[a, a + 1, a + N + 1], [a + 1, a + N + 2, a + N + 1]]
        })
        .collect();
    let mut scene = scene(mesh(&positions, &triangles));
    let place = DAffine3::from_rotation_y(0.1);
    scene.instances[0].world_from_mesh = place;
    let view = view(1280, 800, 77.0);
    let seen = render(&scene, &view);
    let mut worst = Worst::default();
    for ((at, z), hit) in (0u32..).zip(seen.z.0.pixels()).zip(seen.hits.pixels()) {
        if hit.is_miss() {
            continue;
        }
        let centre = PixelPoint::<Usd>::new(f64::from(at % 1280) + 0.5, f64::from(at / 1280) + 0.5);
        let ray = view.camera.unproject(centre).unwrap();
        let [a, b, c] = scene.meshes[0]
            .corners(hit.triangle as usize)
            .unwrap()
            .map(|p| place.transform_point3(DVec3::from(p.map(f64::from))));
        let normal = (b - a).cross(c - a);
        if normal.dot(ray).abs() >= 75f64.to_radians().cos() * normal.length() {
            worst = worst.or(Worst::of(*z, a.dot(normal) / ray.dot(normal) * ray.z));
        }
    }
    println!("{worst:?}");
    assert!(worst.pixels > 300_000 && worst.ulp <= 4.0);
}
