//! Comparisons with brute-force ray casting in double precision.

mod precision;
mod random;
mod shapes;

use oaktwin_camera::math::{DAffine3, DMat3, DQuat, DVec3};
use oaktwin_camera::{Camera, ImageSize, Intrinsics, LensModel, PixelPoint, RigidTransform, Usd};
use oaktwin_scene::{Instance, Mesh, Scene};

use super::Rasterizer;
use crate::ray::brute;
use crate::{Clip, View, Visibility};

/// Reproducible random numbers.
#[derive(Debug)]
struct Random(u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let z = (self.0 ^ self.0 >> 30).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let z = (z ^ z >> 27).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ z >> 31
    }

    fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * ((self.bits() >> 11) as f64 / (1u64 << 53) as f64)
    }

    fn point(&mut self, extent: f64) -> DVec3 {
        DVec3::new(
            self.within(-extent, extent),
            self.within(-extent, extent),
            self.within(-extent, extent),
        )
    }
}

/// A view from the origin along +z.
fn view(width: u32, height: u32, hfov_deg: f64) -> View {
    let intrinsics = Intrinsics::from_hfov(ImageSize::new(width, height), hfov_deg.to_radians());
    View {
        camera: Camera::new(intrinsics, LensModel::Pinhole),
        world_from_camera: RigidTransform::IDENTITY,
        clip: Clip::default(),
    }
}

/// A view with unequal focal lengths, an off-centre principal point, a rotation and a translation.
fn odd_view(width: u32, height: u32) -> View {
    let focal = f64::from(width);
    let intrinsics = Intrinsics::new(
        ImageSize::new(width, height),
        focal * 0.7,
        focal * 0.9,
        PixelPoint::<Usd>::new(f64::from(width) * 0.37, f64::from(height) * 0.81),
    );
    View {
        camera: Camera::new(intrinsics, LensModel::Pinhole),
        world_from_camera: RigidTransform::new(
            DMat3::from_quat(DQuat::from_scaled_axis(DVec3::new(0.1, -0.4, 1.2))),
            DVec3::new(0.3, -0.2, -0.5),
        ),
        clip: Clip::default(),
    }
}

fn instance(mesh: u32, world_from_mesh: DAffine3) -> Instance {
    Instance {
        mesh,
        path: "/Thing".to_owned(),
        world_from_mesh,
        labels: Vec::new(),
        material_offset: 0,
    }
}

/// A scene of one mesh without a transform.
fn scene(mesh: Mesh) -> Scene {
    Scene {
        meshes: vec![mesh],
        instances: vec![instance(0, DAffine3::IDENTITY)],
        ..Scene::default()
    }
}

fn mesh(positions: &[DVec3], triangles: &[[u32; 3]]) -> Mesh {
    Mesh {
        positions: positions.iter().map(|p| p.as_vec3().to_array()).collect(),
        triangles: triangles.to_vec(),
        ..Mesh::default()
    }
}

fn render(scene: &Scene, view: &View) -> Visibility {
    let rasterizer = Rasterizer::new(scene);
    let seen = rasterizer.visibility(scene, view);
    assert_eq!(
        rasterizer.depth(scene, view),
        seen.z,
        "depth-only rendering gives the same depth"
    );
    seen
}

/// The number of pixels with different depth, with another triangle at the same depth, and with a hit.
#[derive(Debug, Default)]
struct Difference {
    depth: usize,
    triangle: usize,
    hits: usize,
}

fn difference(scene: &Scene, view: &View) -> Difference {
    let (ours, truth) = (render(scene, view), brute::visibility(scene, view));
    let mut found = Difference::default();
    let pixels = ours.z.0.pixels().iter().zip(truth.z.0.pixels());
    for ((z, true_z), (hit, true_hit)) in pixels.zip(ours.hits.pixels().iter().zip(truth.hits.pixels())) {
        found.hits += usize::from(true_z.is_finite());
        assert_eq!(z.is_finite(), !hit.is_miss());
        let same = z == true_z || (z - true_z).abs() <= 1e-6 * true_z;
        found.depth += usize::from(!same);
        found.triangle += usize::from(same && hit != true_hit);
    }
    found
}
