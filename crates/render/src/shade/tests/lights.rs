use super::*;

/// A floor below the camera and a box on it, lit from the left by the sun.
pub(super) fn floor_and_box(lights: Vec<Light>) -> Scene {
    let mut scene = Scene {
        lights,
        up: Up::Y,
        ..Scene::default()
    };
    let floor = Mesh {
        positions: vec![
            [-9.0, 1.0, 0.0],
            [-9.0, 1.0, 18.0],
            [9.0, 1.0, 18.0],
            [9.0, 1.0, 0.0],
        ],
        triangles: vec![[0, 1, 2], [0, 2, 3]],
        ..Mesh::default()
    };
    placed(&mut scene, "/Floor", floor);
    let mut small = cube();
    for position in &mut small.positions {
        *position = [
            position[0] * 0.25,
            position[1] * 0.25 + 0.75,
            position[2] * 0.25 + 3.0,
        ];
    }
    placed(&mut scene, "/Box", small);
    scene
}

/// A sun at an elevation of 45° over −x; −y is up.
pub(super) fn sun() -> Light {
    let from = DVec3::new(-1.0, -1.0, 0.0).normalize();
    // The light's z axis points towards the sun.
    let world_from_light = DAffine3::from_mat3(oaktwin_camera::math::DMat3::from_cols(
        DVec3::Z
            .cross(from)
            .normalize()
            .cross(from)
            .cross(from)
            .normalize(),
        DVec3::Z,
        from,
    ));
    Light {
        path: "/Sun".to_owned(),
        kind: LightKind::Distant { angle: 0.005 },
        radiance: [3000.0; 3],
        normalize: false,
        world_from_light,
    }
}

#[test]
fn shadows_point_away_from_the_light() {
    let scene = floor_and_box(vec![sun(), dome(200.0)]);
    let seen = rgb(&scene, &view());
    let at = |point: DVec3| {
        let pixel = view().camera.project(point).unwrap().to::<oaktwin_camera::Usd>();
        i32::from(seen.get(pixel.x as u32, pixel.y as u32).unwrap()[1])
    };
    let (lit, shadow) = (at(DVec3::new(-0.6, 1.0, 3.0)), at(DVec3::new(0.45, 1.0, 3.0)));
    assert!(lit > shadow + 40, "{lit} {shadow}");
    // The box is half a metre high, so its shadow ends half a metre behind it.
    let beyond = at(DVec3::new(1.2, 1.0, 3.0));
    assert!((lit - beyond).abs() < 8, "{lit} {beyond}");
}

#[test]
fn lamps_light_the_surfaces_in_front_of_them() {
    // A lamp 1 m wide, 2 m above the floor, that shines down along +y.
    let down = DAffine3::from_translation(DVec3::new(0.0, -1.0, 3.0))
        * DAffine3::from_rotation_x(std::f64::consts::FRAC_PI_2);
    for kind in [
        LightKind::Rect {
            width: 1.0,
            height: 1.0,
        },
        LightKind::Disk { radius: 0.5 },
        LightKind::Sphere { radius: 0.2 },
    ] {
        let lamp = Light {
            path: "/Lamp".to_owned(),
            kind,
            radiance: [5000.0; 3],
            normalize: true,
            world_from_light: down,
        };
        let scene = floor_and_box(vec![lamp.clone()]);
        let seen = rgb(&scene, &view());
        let at = |point: DVec3| {
            let pixel = view().camera.project(point).unwrap().to::<oaktwin_camera::Usd>();
            i32::from(seen.get(pixel.x as u32, pixel.y as u32).unwrap()[1])
        };
        let (near, far) = (at(DVec3::new(-0.7, 1.0, 3.0)), at(DVec3::new(3.5, 1.0, 5.0)));
        assert!(near > far + 30, "{kind:?}: {near} {far}");
        // A lamp that points up does not light the floor.
        if !matches!(kind, LightKind::Sphere { .. }) {
            let flipped = Light {
                world_from_light: down * DAffine3::from_rotation_x(std::f64::consts::PI),
                ..lamp
            };
            let dark = rgb(&floor_and_box(vec![sun(), flipped]), &view());
            let without = rgb(&floor_and_box(vec![sun()]), &view());
            assert_eq!(dark, without);
        }
    }
}

#[test]
fn corners_are_darker_than_walls() {
    let mut scene = Scene::default();
    // Two walls that meet at 4 m, in the default light.
    let wall = Mesh {
        positions: vec![
            [0.0, -9.0, 4.0],
            [0.0, 9.0, 4.0],
            [-4.0, 9.0, 0.0],
            [-4.0, -9.0, 0.0],
        ],
        triangles: vec![[0, 1, 2], [0, 2, 3]],
        ..Mesh::default()
    };
    let mut other = wall.clone();
    for position in &mut other.positions {
        position[0] *= -1.0;
    }
    placed(&mut scene, "/Left", wall);
    placed(&mut scene, "/Right", other);
    let seen = rgb(&scene, &view());
    let value = |x| i32::from(seen.get(x, 80).unwrap()[1]);
    let values: Vec<i32> = (20..180).map(value).collect();
    assert!(
        value(40) > value(97) + 4 && value(160) > value(102) + 5,
        "{values:?}"
    );
    // The sampling pattern is invisible.
    for x in 10..90 {
        assert!((value(x) - value(x + 1)).abs() <= 2, "{x}");
    }
}

#[test]
fn a_scene_without_lights_gets_default_light() {
    for up in [Up::Y, Up::Z] {
        let mut scene = floor_and_box(Vec::new());
        scene.up = up;
        let seen = rgb(&scene, &view());
        assert!(seen.pixels().iter().all(|pixel| pixel[1] > 25));
        assert_eq!(seen.get(100, 0).unwrap()[3], 0);
        assert_eq!(seen.get(100, 159).unwrap()[3], 255);
        // Lights without radiance are ignored.
        scene.lights = vec![dome(0.0), dome(f32::NAN)];
        assert_eq!(rgb(&scene, &view()), seen);
    }
}

#[test]
fn a_dome_shows_its_image() {
    // Red around +x, which is left of the centre; blue above.
    let pixels = (0..16 * 32u32).map(|i| {
        let (x, y) = (i % 32, i / 32);
        let red = if (4..12).contains(&x) { 200 } else { 20 };
        [red, 20, if y < 4 { 200 } else { 20 }, 255]
    });
    let mut light = dome(1.0);
    light.kind = LightKind::Dome { texture: Some(0) };
    let mut scene = Scene {
        lights: vec![light],
        textures: vec![texture(Image::new(32, 16, pixels.collect()).unwrap())],
        up: Up::Y,
        ..Scene::default()
    };
    placed(&mut scene, "/Ball", cube());
    let centre = |target: DVec3| {
        let seen = rgb(&scene, &look_at(view(), target * 2.0, target * 3.0));
        *seen.get(100, 80).unwrap()
    };
    let [red, _, _, coverage] = centre(DVec3::X);
    assert!(red > 170 && coverage == 0, "{red}");
    assert!(centre(DVec3::NEG_X)[0] < 130 && centre(DVec3::Z)[0] < 130);
    assert!(centre(DVec3::new(0.05, 1.0, 0.0))[2] > 150);
    // Surfaces that face the red part are red.
    let facing = rgb(&scene, &look_at(view(), DVec3::X * 4.0, DVec3::ZERO));
    let away = rgb(&scene, &look_at(view(), DVec3::NEG_X * 4.0, DVec3::ZERO));
    assert!(facing.get(100, 80).unwrap()[0] > away.get(100, 80).unwrap()[0] + 40);
}
