//! Comparisons with brute force in double precision.
#![allow(
    clippy::cast_precision_loss,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "test numbers"
)]

mod bundles;
mod needles;
mod shapes;

use oaktwin_camera::math::{DAffine3, DMat3, DVec3};
use oaktwin_camera::{
    Camera, FTheta, ImageSize, Intrinsics, LensModel, OpenCvFisheye, OpenCvPinhole, PixelPoint,
    RigidTransform, Usd,
};
use oaktwin_scene::{Instance, Mesh, Scene};
use proptest::prelude::*;

use super::*;
use crate::Clip;

fn instance(mesh: u32, world_from_mesh: DAffine3) -> Instance {
    Instance {
        mesh,
        path: String::new(),
        world_from_mesh,
        labels: Vec::new(),
        material_offset: 0,
    }
}

fn soup(corners: &[[f32; 3]]) -> Mesh {
    let count = u32::try_from(corners.len() / 3).unwrap();
    Mesh {
        positions: corners.to_vec(),
        triangles: (0..count).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect(),
        ..Mesh::default()
    }
}

fn scene_of(mesh: Mesh) -> Scene {
    Scene {
        meshes: vec![mesh],
        instances: vec![instance(0, DAffine3::IDENTITY)],
        ..Scene::default()
    }
}

fn view(lens: LensModel, width: u32, height: u32, hfov_deg: f64) -> View {
    let intrinsics = Intrinsics::from_hfov(ImageSize::new(width, height), hfov_deg.to_radians());
    View {
        camera: Camera::new(intrinsics, lens),
        world_from_camera: RigidTransform::IDENTITY,
        clip: Clip::default(),
    }
}

fn fisheye(width: u32, height: u32, hfov_deg: f64) -> View {
    let size = ImageSize::new(width, height);
    let focal = f64::from(width) / hfov_deg.to_radians();
    let centre = PixelPoint::<Usd>::new(f64::from(width) / 2.0, f64::from(height) / 2.0);
    let lens = LensModel::OpenCvFisheye(OpenCvFisheye {
        k: [-0.02, 0.001, 0.0, 0.0],
    });
    View {
        camera: Camera::new(Intrinsics::new(size, focal, focal, centre), lens),
        ..view(LensModel::Pinhole, width, height, 77.0)
    }
}

fn ftheta(width: u32, height: u32) -> View {
    let size = ImageSize::new(width, height);
    let per_pixel = 150f64.to_radians() / f64::from(width);
    let centre = PixelPoint::<Usd>::new(f64::from(width) / 2.0, f64::from(height) / 2.0);
    let k = [0.0, per_pixel, 1e-4 * per_pixel];
    let lens = FTheta::new(&k, size, centre, 200f64.to_radians()).unwrap();
    View {
        camera: Camera::from_ftheta(lens, size),
        ..view(LensModel::Pinhole, width, height, 77.0)
    }
}

fn rational(width: u32, height: u32) -> View {
    let k = [12.9, -46.3, 1e-3, -5e-4, 41.2, 12.7, -45.9, 40.9];
    view(
        LensModel::OpenCvPinhole(OpenCvPinhole::from_slice(&k).unwrap()),
        width,
        height,
        70.0,
    )
}

fn every_lens(width: u32, height: u32) -> [View; 5] {
    [
        view(LensModel::Pinhole, width, height, 77.0),
        rational(width, height),
        fisheye(width, height, 127.0),
        fisheye(width, height, 220.0),
        ftheta(width, height),
    ]
}

/// Reproducible random numbers.
struct Numbers(u64);

impl Numbers {
    /// Returns a number from 0 to 1, 1 excluded.
    fn next(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(0x5851_f42d_4c95_7f2d)
            .wrapping_add(0x1405_7b7e_f767_814f);
        let mixed = (self.0 ^ (self.0 >> 29)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        (mixed >> 11) as f64 / (1u64 << 53) as f64
    }

    fn vector(&mut self) -> DVec3 {
        DVec3::new(self.next(), self.next(), self.next()) * 2.0 - 1.0
    }
}

fn random_soup(numbers: &mut Numbers, triangles: u32, extent: f64, size: f64) -> Mesh {
    let mut corners = Vec::new();
    for _ in 0..triangles {
        let centre = numbers.vector() * extent;
        for _ in 0..3 {
            corners.push((centre + numbers.vector() * size).as_vec3().to_array());
        }
    }
    soup(&corners)
}

fn random_transform(numbers: &mut Numbers) -> DAffine3 {
    let axis = numbers.vector().normalize_or(DVec3::X);
    let turn = DMat3::from_axis_angle(axis, 6.0 * numbers.next());
    let mut scale = DVec3::splat(0.3) + (numbers.vector() + DVec3::ONE) * 0.7;
    if numbers.next() < 0.5 {
        scale.x = -scale.x;
    }
    let shear = DMat3::from_cols(DVec3::X, DVec3::new(0.4, 1.0, 0.0), DVec3::Z);
    DAffine3::from_mat3_translation(
        turn * DMat3::from_diagonal(scale) * shear,
        numbers.vector() * 3.0 + DVec3::Z * 4.0,
    )
}

fn random_scene(seed: u64) -> Scene {
    let mut numbers = Numbers(seed);
    let meshes = vec![
        random_soup(&mut numbers, 60, 1.0, 0.4),
        random_soup(&mut numbers, 3, 0.5, 1.0),
        Mesh::default(),
    ];
    let mut instances: Vec<Instance> = (0..6u32)
        .map(|i| instance(i % 3, random_transform(&mut numbers)))
        .collect();
    // An instance around the camera.
    instances.push(instance(0, DAffine3::from_scale(DVec3::splat(2.0))));
    Scene {
        meshes,
        instances,
        ..Scene::default()
    }
}

fn random_pose(seed: u64) -> RigidTransform {
    let mut numbers = Numbers(seed ^ 0xabcd);
    let axis = numbers.vector().normalize_or(DVec3::X);
    RigidTransform::new(DMat3::from_axis_angle(axis, numbers.next()), numbers.vector())
}

/// Counts the pixels with different results; another triangle at the same depth is not a difference.
fn differences(a: &Visibility, b: &Visibility) -> usize {
    let pairs = a.z.0.pixels().iter().zip(b.z.0.pixels());
    pairs
        .zip(a.hits.pixels().iter().zip(b.hits.pixels()))
        .filter(|((za, zb), (ha, hb))| {
            let is_far_off = (**za - **zb).abs() > 1e-6 * zb.abs();
            ha.is_miss() != hb.is_miss() || (!ha.is_miss() && (is_far_off || za.is_nan()))
        })
        .count()
}

fn assert_like_brute_force(scene: &Scene, view: &View) {
    let caster = RayCaster::new(scene);
    let ours = caster.visibility(scene, view);
    let truth = brute::visibility(scene, view);
    assert_eq!(differences(&ours, &truth), 0, "{view:?}");
    assert_eq!(caster.depth(scene, view), ours.z);
}

#[test]
fn random_scenes_through_every_lens() {
    for seed in 0..6 {
        let scene = random_scene(seed);
        for mut view in every_lens(45, 27) {
            view.world_from_camera = random_pose(seed);
            assert_like_brute_force(&scene, &view);
        }
    }
}

#[test]
fn clips_along_the_axis_or_along_the_ray() {
    for seed in 0..3 {
        let scene = random_scene(seed);
        for mut view in every_lens(45, 27) {
            view.clip = Clip {
                near_m: 1.5,
                far_m: 4.0,
            };
            assert_like_brute_force(&scene, &view);
        }
    }
    // Surfaces exactly at a clipping distance are visible.
    let wall = scene_of(soup(&[[-9.0, -9.0, 2.0], [9.0, -9.0, 2.0], [0.0, 9.0, 2.0]]));
    for (near_m, far_m) in [(2.0, 9.0), (0.1, 2.0), (2.0, 2.0)] {
        let mut view = view(LensModel::Pinhole, 16, 8, 60.0);
        view.clip = Clip { near_m, far_m };
        let z = RayCaster::new(&wall).depth(&wall, &view);
        assert!(z.0.pixels().iter().all(|z| *z == 2.0), "{near_m} {far_m}");
    }
}

#[test]
fn rays_of_any_origin_and_length() {
    for seed in 0..8 {
        let scene = random_scene(seed);
        let caster = RayCaster::new(&scene);
        let mut numbers = Numbers(seed + 100);
        let rays: Vec<Ray> = (0..500)
            .map(|i| {
                let mut direction = numbers.vector() * 10f64.powf(8.0 * numbers.next() - 4.0);
                if i % 5 == 0 {
                    direction[i % 3] = 0.0;
                }
                let length = direction.length();
                Ray {
                    origin: numbers.vector() * 4.0,
                    direction,
                    near: 0.3 * numbers.next() / length,
                    far: if i % 2 == 0 {
                        f64::INFINITY
                    } else {
                        6.0 * numbers.next() / length
                    },
                }
            })
            .collect();
        let nearest = caster.cast_all(&scene, &rays);
        let occluded = caster.are_occluded(&scene, &rays);
        for ((ray, nearest), occluded) in rays.iter().zip(nearest).zip(occluded) {
            let blocked = brute::is_occluded(&scene, ray.origin, ray.direction, ray.near, ray.far);
            assert_eq!(occluded, blocked, "{ray:?}");
            let truth = brute::nearest(&scene, ray.origin, ray.direction, ray.near, ray.far);
            assert_eq!(nearest.map(|n| n.1), truth.map(|n| n.1), "{ray:?}");
            if let (Some((ours, _)), Some((t, _))) = (nearest, truth) {
                assert!((ours - t).abs() <= 1e-9 * t, "{ours} {t}");
            }
        }
    }
}

#[test]
fn rays_without_finite_direction_or_origin_miss() {
    let scene = random_scene(1);
    let caster = RayCaster::new(&scene);
    for bad in [0.0, f64::NAN, f64::INFINITY] {
        for (origin, direction) in [(DVec3::ZERO, DVec3::splat(bad)), (DVec3::splat(bad), DVec3::ZERO)] {
            let ray = Ray {
                origin,
                direction,
                near: 0.0,
                far: f64::INFINITY,
            };
            assert_eq!(caster.cast_all(&scene, &[ray]), [None]);
            assert_eq!(caster.are_occluded(&scene, &[ray]), [false]);
        }
    }
}

#[test]
fn the_first_of_equally_near_triangles_is_visible() {
    let triangle = [[-9.0, -9.0, 2.0], [9.0, -9.0, 2.0], [0.0, 9.0, 2.0]];
    let scene = Scene {
        meshes: vec![soup(&triangle.repeat(1000))],
        instances: (0..3).map(|_| instance(0, DAffine3::IDENTITY)).collect(),
        ..Scene::default()
    };
    let seen = RayCaster::new(&scene).visibility(&scene, &view(LensModel::Pinhole, 20, 10, 60.0));
    let first = Hit {
        instance: 0,
        triangle: 0,
    };
    assert!(seen.hits.pixels().iter().all(|hit| *hit == first));
}

#[test]
fn empty_and_invalid_scenes() {
    let pinhole = view(LensModel::Pinhole, 9, 5, 77.0);
    let empty = Scene::default();
    let seen = RayCaster::new(&empty).visibility(&empty, &pinhole);
    assert!(seen.hits.pixels().iter().all(|hit| hit.is_miss()));
    assert!(seen.z.0.pixels().iter().all(|z| *z == f32::INFINITY));
    let nothing = view(LensModel::Pinhole, 0, 5, 77.0);
    assert!(
        RayCaster::new(&empty)
            .depth(&empty, &nothing)
            .0
            .pixels()
            .is_empty()
    );

    let one = scene_of(soup(&[[-1.0, -1.0, 2.0], [1.0, -1.0, 2.0], [0.0, 1.0, 2.0]]));
    assert_like_brute_force(&one, &pinhole);

    // Points, lines, a missing vertex, a missing mesh, a NaN position.
    let mut broken = scene_of(soup(&[
        [0.0, 0.0, 2.0],
        [0.0, 0.0, 2.0],
        [0.0, 0.0, 2.0],
        [-1.0, 0.0, 2.0],
        [0.0, 0.0, 2.0],
        [1.0, 0.0, 2.0],
        [f32::NAN, 0.0, 2.0],
        [1.0, 0.0, 2.0],
        [0.0, 1.0, 2.0],
    ]));
    broken.meshes[0].triangles.push([0, 1, 99]);
    broken.instances.push(instance(7, DAffine3::IDENTITY));
    broken
        .instances
        .push(instance(0, DAffine3::from_scale(DVec3::ZERO)));
    let seen = RayCaster::new(&broken).visibility(&broken, &pinhole);
    assert!(seen.hits.pixels().iter().all(|hit| hit.is_miss()));
}

#[test]
fn a_hundred_thousand_instances() {
    let mut scene = random_scene(2);
    let mut numbers = Numbers(9);
    for i in 0..100_000u32 {
        let mut place = random_transform(&mut numbers);
        place.matrix3 *= 0.02;
        place.translation *= 5.0;
        scene.instances.push(instance(i % 3, place));
    }
    let caster = RayCaster::new(&scene);
    let view = view(LensModel::Pinhole, 160, 100, 77.0);
    let seen = caster.visibility(&scene, &view);
    // Brute force for a few rays only.
    let mut numbers = Numbers(3);
    for _ in 0..3 {
        let (x, y) = ((numbers.next() * 160.0) as u32, (numbers.next() * 100.0) as u32);
        let pixel = PixelPoint::<Usd>::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
        let ray = view.camera.unproject(pixel).unwrap();
        let truth = brute::nearest(
            &scene,
            DVec3::ZERO,
            ray / ray.z,
            view.clip.near_m,
            view.clip.far_m,
        );
        assert_eq!(*seen.hits.get(x, y).unwrap(), truth.map_or(Hit::MISS, |t| t.1));
    }
}

#[test]
fn any_number_of_threads_and_any_level_give_the_same_bytes() {
    let scene = random_scene(11);
    let caster = RayCaster::new(&scene);
    let at_levels = Level::available().into_iter().map(|level| RayCaster {
        level,
        ..RayCaster::new(&scene)
    });
    let at_levels: Vec<_> = at_levels.collect();
    for view in every_lens(131, 77) {
        let one = caster.visibility(&scene, &view);
        for caster in &at_levels {
            assert_eq!(caster.visibility(&scene, &view), one, "{:?}", caster.level);
        }
        for threads in [1, 3] {
            let pool = rayon::ThreadPoolBuilder::new()
                .num_threads(threads)
                .build()
                .unwrap();
            let many = pool.install(|| RayCaster::new(&scene).visibility(&scene, &view));
            assert_eq!(many, one);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]
    #[test]
    fn random_scenes_match_brute_force(seed in any::<u64>(), lens in 0usize..5) {
        let mut view = every_lens(33, 21)[lens];
        view.world_from_camera = random_pose(seed);
        assert_like_brute_force(&random_scene(seed), &view);
    }
}
