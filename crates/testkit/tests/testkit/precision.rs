//! Tests the precision of depth against double precision: 4 ulp up to 75° between ray and normal, 1e-6 up to 85°, 1e-4 beyond.

#![allow(clippy::print_stdout, reason = "a test")]

use oaktwin_camera::math::{DAffine3, DMat3, DVec3};
use oaktwin_camera::{Camera, ImageSize, Intrinsics, LensModel, RigidTransform};
use oaktwin_image::ZDepth;
use oaktwin_render::{Backend, Clip, Renderer, View};
use oaktwin_scene::{Instance, Scene};
use oaktwin_testkit::random::Random;
use oaktwin_testkit::reference::{Crossing, Reference};

const SIZE: ImageSize = ImageSize::new(61, 43);

#[test]
fn depth_is_precise() {
    check_seeds(0..150);
}

#[test]
#[ignore = "slow: many more surfaces"]
fn slow_depth_is_precise_on_many_surfaces() {
    check_seeds(150..6000);
}

fn check_seeds(seeds: std::ops::Range<u64>) {
    let mut findings = Vec::new();
    let mut worst = [Backend::Raster, Backend::Ray].map(|backend| (backend, Worst::default()));
    for seed in seeds {
        let (scene, view) = surface(&mut Random::new(seed));
        let renderer = Renderer::new(scene);
        let truth = Reference::new(renderer.scene(), &view).image();
        for (backend, worst) in &mut worst {
            let was_too_large = worst.is_too_large();
            worst.compare(&renderer.depth(&view, *backend), &truth);
            if worst.is_too_large() && !was_too_large {
                findings.push(format!("{backend:?} seed {seed}: {worst:?}"));
            }
        }
    }
    for (backend, worst) in worst {
        println!("{backend:?}: {worst:?}");
        assert!(
            worst.pixels_up_to_75 > 10_000 && worst.pixels_up_to_85 > 1_000 && worst.pixels_beyond_85 > 1_000,
            "{worst:?}"
        );
    }
    assert!(findings.is_empty(), "{}", findings.join("\n"));
}

/// The maximum errors so far.
#[derive(Clone, Copy, Debug, Default)]
struct Worst {
    ulp_up_to_75: f64,
    relative_up_to_85: f64,
    ulp_beyond_85: f64,
    relative_beyond_85: f64,
    pixels_up_to_75: usize,
    pixels_up_to_85: usize,
    pixels_beyond_85: usize,
}

impl Worst {
    fn is_too_large(&self) -> bool {
        self.ulp_up_to_75 > 4.0 || self.relative_up_to_85 > 1e-6 || self.relative_beyond_85 > 1e-4
    }

    #[expect(clippy::cast_possible_truncation, reason = "the next float32")]
    fn compare(&mut self, ZDepth(depth): &ZDepth, truth: &[Option<Crossing>]) {
        for (single, truth) in depth.pixels().iter().zip(truth) {
            let (Some(truth), true) = (truth, single.is_finite()) else {
                continue;
            };
            let error = (f64::from(*single) - truth.z).abs();
            if error > 1e-3 * truth.z {
                // Another surface, at a silhouette: covered by `backends.rs`.
                continue;
            }
            let nearest = truth.z as f32;
            let ulp = f64::from(nearest.next_up()) - f64::from(nearest);
            let degrees = truth.cos_incidence.acos().to_degrees();
            if degrees <= 75.0 {
                self.pixels_up_to_75 += 1;
                self.ulp_up_to_75 = self.ulp_up_to_75.max(error / ulp);
            } else if degrees <= 85.0 {
                self.pixels_up_to_85 += 1;
                self.relative_up_to_85 = self.relative_up_to_85.max(error / truth.z);
            } else {
                self.pixels_beyond_85 += 1;
                self.ulp_beyond_85 = self.ulp_beyond_85.max(error / ulp);
                self.relative_beyond_85 = self.relative_beyond_85.max(error / truth.z);
            }
        }
    }
}

/// A curved or flat sheet of triangles in front of a camera, from a millimetre to ten kilometres away, coarse or
/// fine, with any tilt and position, placed by its instance or by its vertices.
#[expect(clippy::cast_possible_truncation, reason = "positions are float32")]
fn surface(random: &mut Random) -> (Scene, View) {
    let scale = random.magnitude(1e-3, 1e4);
    let split = [1, 3, 14][random.below(3) as usize];
    // A floor below a camera extends much farther than its distance.
    let extent = [4.0, 4.0, 100.0, 10_000.0][random.below(4) as usize];
    let bulge = [0.0, 0.0, 0.1][random.below(3) as usize];
    let mut mesh = oaktwin_testkit::shapes::heightfield([split, split], [extent, extent], |x, y| {
        bulge * (3.0 * x).sin() * y.cos()
    });
    // The axis meets the sheet at one unit, tilted by up to 84°.
    let tilt =
        DMat3::from_rotation_z(random.range(-3.2, 3.2)) * DMat3::from_rotation_x(random.range(0.0, 1.466));
    let camera_from_mesh = DAffine3::from_scale(DVec3::splat(scale))
        * DAffine3::from_mat3_translation(tilt, DVec3::new(0.0, 0.0, 1.0));
    let rotation = random.rotation();
    let away = [0.0, 1.0, 1e3][random.below(3) as usize] * scale;
    let world_from_camera = RigidTransform::new(rotation, away * random.direction());
    let world_from_mesh =
        DAffine3::from_mat3_translation(rotation, world_from_camera.translation) * camera_from_mesh;
    let baked = random.below(2) == 0 && away <= scale;
    if baked {
        for p in &mut mesh.positions {
            let place = world_from_mesh.transform_point3(DVec3::from(p.map(f64::from)));
            *p = place.to_array().map(|x| x as f32);
        }
    }
    let placed = Instance {
        mesh: 0,
        path: "/Sheet".to_owned(),
        world_from_mesh: if baked {
            DAffine3::IDENTITY
        } else {
            world_from_mesh
        },
        labels: Vec::new(),
        material_offset: 0,
    };
    let scene = Scene {
        meshes: vec![mesh],
        instances: vec![placed],
        ..Scene::default()
    };
    let hfov = random.range(30.0, 100.0).to_radians();
    let view = View {
        camera: Camera::new(Intrinsics::from_hfov(SIZE, hfov), LensModel::Pinhole),
        world_from_camera,
        clip: Clip {
            near_m: 0.05 * scale,
            far_m: f64::INFINITY,
        },
    };
    (scene, view)
}
