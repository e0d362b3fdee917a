//! Small scenes for tests.

use oaktwin_camera::math::{DAffine3, DMat3, DVec3};
use oaktwin_camera::{
    Camera, ImageSize, Intrinsics, LensModel, OpenCvFisheye, PixelPoint, RigidTransform, Usd,
};
use oaktwin_scene::{Instance, Label, Mesh, Scene};

use crate::{Clip, View};

/// A pinhole at the world's origin, with the world's axes as its own: 200 × 160 pixels, 100 px focal length, centred.
pub(crate) fn view() -> View {
    View {
        camera: Camera::new(intrinsics(), LensModel::Pinhole),
        world_from_camera: RigidTransform::IDENTITY,
        clip: Clip::default(),
    }
}

/// The same view with an equidistant fisheye: half the width of the image is 1 rad.
pub(crate) fn fisheye() -> View {
    View {
        camera: Camera::new(
            intrinsics(),
            LensModel::OpenCvFisheye(OpenCvFisheye { k: [0.0; 4] }),
        ),
        ..view()
    }
}

fn intrinsics() -> Intrinsics {
    let size = ImageSize::new(200, 160);
    Intrinsics::new(size, 100.0, 100.0, PixelPoint::<Usd>::new(100.0, 80.0))
}

/// A view from `eye` to `target`; the world's −y is up in the image.
pub(crate) fn look_at(view: View, eye: DVec3, target: DVec3) -> View {
    let forward = (target - eye).normalize();
    let right = DVec3::Y.cross(forward).normalize();
    let rotation = DMat3::from_cols(right, forward.cross(right), forward);
    View {
        world_from_camera: RigidTransform::new(rotation, eye),
        ..view
    }
}

/// A rectangle across the optical axis, facing the camera.
#[expect(clippy::cast_possible_truncation, reason = "a mesh is float32")]
pub(crate) fn rectangle(x: [f64; 2], y: [f64; 2], z: f64) -> Mesh {
    let corner = |x: f64, y: f64| [x as f32, y as f32, z as f32];
    Mesh {
        positions: vec![
            corner(x[0], y[0]),
            corner(x[0], y[1]),
            corner(x[1], y[1]),
            corner(x[1], y[0]),
        ],
        triangles: vec![[0, 1, 2], [0, 2, 3]],
        ..Mesh::default()
    }
}

/// A box from −1 to 1 without normals.
pub(crate) fn cube() -> Mesh {
    let positions = (0..8u8)
        .map(|i| [0, 1, 2].map(|axis| if i >> axis & 1 == 1 { 1.0 } else { -1.0 }))
        .collect();
    let quads = [
        [0, 4, 6, 2],
        [1, 3, 7, 5],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 2, 3, 1],
        [4, 5, 7, 6],
    ];
    let triangles = quads.iter().flat_map(|[a, b, c, d]| [[*a, *b, *c], [*a, *c, *d]]);
    Mesh {
        positions,
        triangles: triangles.collect(),
        ..Mesh::default()
    }
}

/// Adds a mesh without a transform.
pub(crate) fn placed(scene: &mut Scene, path: &str, mesh: Mesh) {
    placed_at(scene, path, mesh, DAffine3::IDENTITY, &[]);
}

/// Adds a mesh with a transform and labels; each label is a prim, a taxonomy and a name.
pub(crate) fn placed_at(
    scene: &mut Scene,
    path: &str,
    mesh: Mesh,
    world_from_mesh: DAffine3,
    labels: &[[&str; 3]],
) {
    let labels = labels.iter().map(|[prim, taxonomy, name]| Label {
        prim: (*prim).to_owned(),
        taxonomy: (*taxonomy).to_owned(),
        name: (*name).to_owned(),
    });
    scene.instances.push(Instance {
        mesh: u32::try_from(scene.meshes.len()).unwrap(),
        path: path.to_owned(),
        world_from_mesh,
        labels: labels.collect(),
        material_offset: 0,
    });
    scene.meshes.push(mesh);
}
