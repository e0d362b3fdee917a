use oaktwin_camera::math::{DAffine3, DMat3, DVec3};
use oaktwin_camera::{Camera, ImageSize, Intrinsics, LensModel, PixelPoint, RigidTransform, Usd};
use oaktwin_render::{Backend, Clip, Renderer, View};
use oaktwin_scene::{Instance, Mesh, Scene};

use crate::engine::Engine;
use crate::protocol::ViewJson;

/// One of this project's backends.
pub(crate) struct Ours {
    renderer: Renderer,
    view: View,
    backend: Backend,
}

impl Ours {
    /// Builds the scene, including the preparation that a backend does for the first pixel.
    pub(crate) fn build(backend: Backend, mesh: Mesh, view: &ViewJson) -> Self {
        let placed = Instance {
            mesh: 0,
            path: "/Triangles".to_owned(),
            world_from_mesh: DAffine3::IDENTITY,
            labels: Vec::new(),
            material_offset: 0,
        };
        let scene = Scene {
            meshes: vec![mesh],
            instances: vec![placed],
            ..Scene::default()
        };
        let renderer = Renderer::new(scene);
        let view = view_of(view);
        let mut pixel = view;
        pixel.camera.intrinsics = Intrinsics::from_hfov(ImageSize::new(1, 1), 1e-3);
        let _ = renderer.depth(&pixel, backend);
        Self {
            renderer,
            view,
            backend,
        }
    }
}

impl Engine for Ours {
    fn modes(&self) -> Vec<String> {
        vec![String::new()]
    }

    fn frame(&self, _mode: &str) -> Vec<f32> {
        self.renderer.depth(&self.view, self.backend).0.into_pixels()
    }
}

fn view_of(view: &ViewJson) -> View {
    let centre = PixelPoint::<Usd>::new(f64::from(view.width) / 2.0, f64::from(view.height) / 2.0);
    let size = ImageSize::new(view.width, view.height);
    let intrinsics = Intrinsics::new(size, view.focal, view.focal, centre);
    View {
        camera: Camera::new(intrinsics, LensModel::Pinhole),
        world_from_camera: RigidTransform::new(
            DMat3::from_cols_array_2d(&view.rotation).transpose(),
            DVec3::from(view.translation),
        ),
        clip: Clip {
            near_m: view.near,
            ..Clip::default()
        },
    }
}
