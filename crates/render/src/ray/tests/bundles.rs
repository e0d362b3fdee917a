//! Bundles, remembered blockers and distances within a reach, compared with single rays that remember nothing.

use super::super::bundle::RAYS;
use super::*;

/// A deterministic sequence of numbers from −1 to 1.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }

    fn vector(&mut self) -> DVec3 {
        DVec3::new(self.next(), self.next(), self.next())
    }
}

/// Turned, stretched and mirrored copies of a cloud of triangles.
fn clouds(numbers: &mut Numbers) -> Scene {
    let corners: Vec<[f32; 3]> = (0..200)
        .flat_map(|_| {
            let centre = numbers.vector();
            [(); 3].map(|()| (centre + numbers.vector() * 0.12).to_array().map(|x| x as f32))
        })
        .collect();
    let instances = (0..12).map(|_| {
        let turned = DMat3::from_axis_angle(numbers.vector().normalize(), 3.0 * numbers.next());
        let stretched = DMat3::from_diagonal(DVec3::new(0.4, -0.7, 1.1));
        instance(
            0,
            DAffine3::from_mat3_translation(turned * stretched, numbers.vector() * 4.0),
        )
    });
    Scene {
        instances: instances.collect(),
        ..scene_of(soup(&corners))
    }
}

#[test]
fn bundles_and_kinds_of_rays_give_what_single_rays_give() {
    let mut numbers = Numbers(7);
    let scene = clouds(&mut numbers);
    let caster = RayCaster::new(&scene);
    let mut memory = Stack::default();
    let (mut stopped, mut all) = (0, 0);
    for round in 0..400 {
        let origin = numbers.vector() * 5.0;
        let target = numbers.vector() * 5.0;
        // Narrow and wide bundles, also around an axis, where components of the directions change sign.
        let width = [0.01, 0.3, 2.0][round % 3];
        let along = match round % 4 {
            0 => DVec3::Z * 5.0,
            _ => target - origin,
        };
        let directions: [DVec3; RAYS] = std::array::from_fn(|_| along + numbers.vector() * width);
        let rays = Rays {
            origin,
            directions,
            used: if round % 2 == 0 {
                u64::MAX
            } else {
                0x1111_0F00_0001_1111
            },
            far: if round % 5 == 0 { f64::INFINITY } else { 0.999 },
        };
        let found = caster.shadowed(&scene, &rays, round, &mut memory);
        assert_eq!(found & !rays.used, 0);
        for index in ray_bits(rays.used) {
            let ray = rays.ray(index);
            let expected = caster.is_occluded(&scene, ray, &mut Stack::default());
            assert_eq!((found >> index) & 1 == 1, expected, "{round} {index}");
            // The last ray of the kind was another one.
            assert_eq!(caster.is_shadowed(&scene, ray, 3, &mut memory), expected);
            let nearest = caster.cast(
                &scene,
                Ray {
                    far: f64::INFINITY,
                    ..ray
                },
                &mut Stack::default(),
            );
            let ahead = Ray {
                far: f64::INFINITY,
                ..ray
            };
            let within = caster.distance_within(&scene, ahead, 0.5, 90 + index % 8, &mut memory);
            assert_eq!(within, nearest.map(|(t, _)| t.min(0.5)), "{round} {index}");
            stopped += usize::from(expected);
            all += 1;
        }
    }
    assert!(stopped > all / 50 && stopped < all * 9 / 10, "{stopped} of {all}");
}
