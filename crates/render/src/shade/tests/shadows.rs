//! Light in shadows against closed forms, and in both images of a pair.

use super::*;
use crate::Luminance;

/// A floor at y = 1, lit by a lamp of radius 0.3 m, 2 m from it.
fn lit_floor() -> Scene {
    let mut scene = Scene {
        up: Up::Z,
        materials: vec![Material {
            base_color: Some([0.5; 3]),
            ..rough(None)
        }],
        ..Scene::default()
    };
    scene.lights = vec![Light {
        path: "/Lamp".to_owned(),
        kind: LightKind::Sphere { radius: LAMP.1 },
        radiance: [100.0; 3],
        normalize: false,
        world_from_light: DAffine3::from_translation(LAMP.0),
    }];
    plate(&mut scene, [-9.0, 9.0], [0.0, 18.0], 1.0);
    scene
}

/// The centre and the radius of the lamp.
const LAMP: (DVec3, f32) = (DVec3::new(0.0, -1.0, 3.0), 0.3);

/// Adds a horizontal rectangle.
fn plate(scene: &mut Scene, x: [f32; 2], z: [f32; 2], y: f32) {
    let mesh = Mesh {
        positions: vec![[x[0], y, z[0]], [x[0], y, z[1]], [x[1], y, z[1]], [x[1], y, z[0]]],
        triangles: vec![[0, 1, 2], [0, 2, 3]],
        materials: vec![MaterialSpan {
            end: 2,
            material: Some(0),
        }],
        ..Mesh::default()
    };
    placed(scene, "/Plate", mesh);
}

/// A view of the floor from above.
fn from_above() -> View {
    look_at(view(), DVec3::new(0.0, -0.6, 1.2), DVec3::new(0.0, 1.0, 3.0))
}

fn luminance(scene: &Scene, view: &View) -> Luminance {
    Renderer::new(scene.clone())
        .luminance(view, Backend::Auto, None)
        .0
}

/// The point that a pixel sees.
fn point(view: &View, light: &Luminance, [x, y]: [u32; 2]) -> DVec3 {
    let ray = crate::rays::Rays::new(view).centre(x, y).unwrap();
    let z = f64::from(*light.z.0.get(x, y).unwrap());
    view.world_from_camera.translation + view.world_from_camera.rotation * (ray * (z / ray.z))
}

#[test]
fn the_penumbra_of_a_round_lamp_has_its_closed_form() {
    let mut scene = lit_floor();
    // Its edge at x = 0 hides the left half of the lamp from below. It is too far away to occlude the surroundings of the floor.
    plate(&mut scene, [-9.0, 0.0], [2.0, 18.0], 0.2);
    let view = look_at(view(), DVec3::new(0.6, 0.3, 1.2), DVec3::new(0.0, 1.0, 3.0));
    let light = luminance(&scene, &view);
    let value = |at: [u32; 2]| f64::from(*light.scene.get(at[0], at[1]).unwrap());
    let (mut compared, mut worst) = (0, 0.0f64);
    for y in [70, 80, 91] {
        let row: Vec<(DVec3, f64)> = (0..200)
            .map(|x| (point(&view, &light, [x, y]), value([x, y])))
            .filter(|(point, _)| (point.y - 1.0).abs() < 1e-3 && point.x.abs() < 0.6)
            .collect();
        // What arrives without the lamp, and the lamp's light divided by the cosine over the square of the distance.
        let dark = row.first().unwrap().1;
        let unshadowed = |point: DVec3| (point.y - LAMP.0.y) / (LAMP.0 - point).length().powi(3);
        let (end, bright) = *row.last().unwrap();
        let scale = (bright - dark) / unshadowed(end);
        let mut last = 0.0;
        for (point, value) in row {
            let share = (value - dark) / (scale * unshadowed(point));
            // The plane through the point and the edge of the plate.
            let normal = (DVec3::new(0.0, 0.2, point.z) - point)
                .cross(DVec3::Z)
                .normalize();
            let way = LAMP.0 - point;
            let sine = way.dot(normal) / way.length();
            let distance = sine / (1.0 - sine * sine).sqrt() * way.length() / f64::from(LAMP.1);
            let expected = segment(distance);
            worst = worst.max((share - expected).abs());
            assert!(share > last - 0.003, "{point}: {share} {last}");
            last = share;
            compared += usize::from((0.02..0.98).contains(&expected));
        }
    }
    assert!(compared > 50, "{compared}");
    assert!(worst < 0.04, "{worst}");
}

/// The area of the unit disk on one side of a line at a distance from its centre, as a share.
fn segment(distance: f64) -> f64 {
    let distance = distance.clamp(-1.0, 1.0);
    (distance.acos() - distance * (1.0 - distance * distance).sqrt()) / std::f64::consts::PI
}

#[test]
fn both_images_of_a_stereo_pair_have_the_same_shadows() {
    let cases = [
        vec![lit_floor().lights[0].clone()],
        vec![sun(), dome(400.0)],
        vec![dome(1000.0)],
        Vec::new(),
    ];
    for lights in cases {
        let scene = Scene {
            lights,
            ..floor_and_box(Vec::new())
        };
        let left = from_above();
        let baseline = left.world_from_camera.rotation.x_axis * 0.075;
        let right = View {
            world_from_camera: RigidTransform::new(
                left.world_from_camera.rotation,
                left.world_from_camera.translation + baseline,
            ),
            ..left
        };
        let depth = luminance(&scene, &left).z;
        let (a, b) = (rgb(&scene, &left), rgb(&scene, &right));
        let level = |image: &Image<[u8; 4]>, x: u32, y: u32| f32::from(image.get(x, y).unwrap()[1]);
        let (mut differ, mut count) = (0, 0);
        for y in 2..158 {
            for x in 30..198 {
                // Only the floor, away from outlines.
                let is_floor = |x: u32, y: u32| {
                    let z = f64::from(*depth.0.get(x, y).unwrap());
                    let ray = crate::rays::Rays::new(&left).centre(x, y).unwrap();
                    let point = left.world_from_camera.rotation * (ray * (z / ray.z));
                    (left.world_from_camera.translation.y + point.y - 1.0).abs() < 1e-3
                };
                if ![[x - 2, y], [x + 2, y], [x, y - 2], [x, y + 2]]
                    .iter()
                    .all(|[x, y]| is_floor(*x, *y))
                {
                    continue;
                }
                let place = x as f32 - 7.5 / depth.0.get(x, y).unwrap();
                let (near, part) = (place.floor(), place - place.floor());
                let other = level(&b, near as u32, y) * (1.0 - part) + level(&b, near as u32 + 1, y) * part;
                count += 1;
                differ += usize::from((other - level(&a, x, y)).abs() > 1.5);
            }
        }
        assert!(count > 5000, "{count}");
        assert!(differ * 100 < count, "{differ} of {count}: {:?}", scene.lights);
    }
}

#[test]
fn shadows_of_the_sun_are_sharp_to_a_pixel() {
    let mut scene = lit_floor();
    scene.lights = vec![sun()];
    plate(&mut scene, [-9.0, -0.3], [0.0, 18.0], 0.6);
    let view = look_at(view(), DVec3::new(0.6, 0.3, 1.2), DVec3::new(0.0, 1.0, 3.0));
    let light = luminance(&scene, &view);
    let mut rows = 0;
    for y in 60..100 {
        let row: Vec<f32> = (0..200)
            .filter(|x| {
                let at = point(&view, &light, [*x, y]);
                (at.y - 1.0).abs() < 1e-3 && at.x.abs() < 0.8
            })
            .map(|x| *light.scene.get(x, y).unwrap())
            .collect();
        let (low, high) = (row[0], row[row.len() - 1]);
        if high < 3.0 * low {
            continue;
        }
        rows += 1;
        let between = row
            .iter()
            .filter(|value| (low * 1.2..high * 0.9).contains(*value))
            .count();
        assert!(between <= 2, "{y}: {row:?}");
    }
    assert!(rows > 20, "{rows}");
}
