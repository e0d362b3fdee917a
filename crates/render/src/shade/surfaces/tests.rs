use oaktwin_camera::math::DQuat;

use super::*;
use crate::annotate::SurfaceFinder;
use crate::{Backend, Renderer, fixture};

/// Waves in front of the camera with interpolated normals: as they are, and mirrored and stretched; behind them a plain wall.
fn waves() -> Scene {
    let mut mesh = Mesh::default();
    let mut normals = Vec::new();
    for y in 0..12u8 {
        for x in 0..12u8 {
            let [x, y] = [x, y].map(|at| f32::from(at) * 0.1 - 0.55);
            mesh.positions
                .push([x, y, 0.1 * (9.0 * x).sin() * (7.0 * y).cos()]);
            normals.push([0.3 * x, 0.2 * y, -1.0]);
        }
    }
    for y in 0..11u32 {
        for x in 0..11u32 {
            let corner = y * 12 + x;
            mesh.triangles.push([corner, corner + 1, corner + 12]);
            mesh.triangles.push([corner + 1, corner + 13, corner + 12]);
        }
    }
    mesh.normals = Some(MeshAttribute::Vertex(normals));
    let mut scene = Scene::default();
    for scale in [DVec3::ONE, DVec3::new(-1.5, 0.5, 1.0)] {
        fixture::placed(&mut scene, "/Wave", mesh.clone());
        let turn = DQuat::from_rotation_x(0.4);
        let place = DVec3::new(scale.x * 0.4, 0.0, 1.5);
        scene.instances.last_mut().unwrap().world_from_mesh =
            DAffine3::from_scale_rotation_translation(scale, turn, place);
    }
    fixture::placed(
        &mut scene,
        "/Wall",
        fixture::rectangle([-9.0, 9.0], [-9.0, 9.0], 4.0),
    );
    scene
}

#[test]
fn packets_equal_single_surfaces_in_double_precision() {
    for (view, origin) in [
        (fixture::view(), DVec3::ZERO),
        (fixture::fisheye(), DVec3::new(3e5, -2e5, 1e4)),
    ] {
        let mut scene = waves();
        for instance in &mut scene.instances {
            instance.world_from_mesh.translation += origin;
        }
        let mut view = view;
        view.world_from_camera.translation += origin;
        let seen = Renderer::new(scene.clone()).visibility(&view, Backend::Auto);
        let rays = Rays::new(&view);
        for level in Level::available() {
            let mut packet = Packet::new(&scene, &view, &rays, level);
            let mut finder = SurfaceFinder::new(&scene, &view);
            let mut compared = 0;
            let mut check = |packet: &mut Packet<'_>| {
                let found = packet.find();
                for lane in 0..found.map_or(0, |found| found.count()) {
                    let found = found.as_ref().unwrap();
                    let [x, y] = found.place(lane);
                    let ray = rays.centre(x, y).unwrap();
                    let (hit, z) = (seen.hits.get(x, y).unwrap(), seen.z.0.get(x, y).unwrap());
                    assert_eq!(
                        (found.tag(lane), found.triangle(lane)),
                        ((200 * y + x) as usize, hit.triangle)
                    );
                    let expected = finder.find(*hit, ray, *z).unwrap();
                    let eye = view.world_from_camera.translation;
                    compare(found, lane, &expected, eye, rays.next(x, y, ray));
                    compared += 1;
                }
                packet.clear();
            };
            for (index, (hit, z)) in (0u32..).zip(seen.hits.pixels().iter().zip(seen.z.0.pixels())) {
                let place = [index % 200, index / 200];
                let Some(ray) = packet.ray(place).filter(|_| !hit.is_miss()) else {
                    continue;
                };
                if !packet.has_room_for(hit.instance) {
                    check(&mut packet);
                }
                packet.push(index as usize, place, ray, *hit, *z);
            }
            check(&mut packet);
            assert!(compared > 20_000);
        }
    }
}

fn compare(
    found: &PacketSurfaces<'_, '_>,
    lane: usize,
    expected: &Surface<'_>,
    eye: DVec3,
    next: [Option<DVec3>; 2],
) {
    let near = |a: Vec3, b: DVec3, tolerance: f32| (a - b.as_vec3()).length() < tolerance;
    let surfaces = found.surfaces;
    let point = expected.point - eye;
    assert!(near(
        lane_of(&surfaces.point, lane),
        point,
        2e-6 * surfaces.range[lane]
    ));
    assert!(near(
        lane_of(&surfaces.flat_normal, lane),
        expected.flat_normal,
        1e-5
    ));
    assert!(near(lane_of(&surfaces.normal, lane), expected.normal, 1e-4));
    let spot = found.spot(lane);
    let [_, b, c] = expected.weights;
    let differs = |a: f32, b: f64| (f64::from(a) - b).abs();
    assert!(differs(spot.at[0], b).max(differs(spot.at[1], c)) < 1e-4);
    for (step, next) in [spot.across, spot.down].into_iter().zip(next) {
        let Some(next) = next else { continue };
        let [_, next_b, next_c] = expected.weights_of(next);
        let [here_b, here_c] = [b, c];
        // Clamped weights differ from those in the plane at the triangle's border.
        assert!(
            differs(step[0], next_b - here_b).max(differs(step[1], next_c - here_c))
                < 2e-4 * (1.0 + next_b.abs() + next_c.abs())
        );
    }
}
