//! Scenes of a chosen size, and the view of them.

use oaktwin_camera::ImageSize;
use oaktwin_camera::math::{DAffine3, DQuat, DVec3};
use oaktwin_render::View;
use oaktwin_scene::{Instance, Mesh, Scene};
use oaktwin_testkit::shapes::{heightfield, hills, icosphere};
use oaktwin_testkit::views::looking_at;

/// The size of images on all axes except the axis of pixels.
pub(crate) const SIZE: ImageSize = ImageSize::new(1280, 800);

/// The width of all scenes, metres.
const WIDTH_M: f64 = 14.0;

/// Returns a hilly plane of `2 squares²` triangles.
pub(crate) fn plane(squares: u32) -> Scene {
    let mesh = heightfield([squares; 2], [WIDTH_M; 2], |x, y| {
        0.3 * hills(x, y) + 0.01 * hills(17.0 * x, 17.0 * y)
    });
    scene(mesh, vec![DAffine3::IDENTITY])
}

/// Returns balls of 1280 triangles in a square grid that is as wide as the plane.
pub(crate) fn balls(count: u32) -> Scene {
    let side = f64::from(count).sqrt().ceil();
    let step = WIDTH_M / side;
    let places = (0..count).map(|index| {
        let (row, column) = ((f64::from(index) / side).floor(), f64::from(index) % side);
        let place = |at: f64| (at + 0.5) * step - WIDTH_M / 2.0;
        DAffine3::from_scale_rotation_translation(
            DVec3::splat(0.45 * step),
            DQuat::IDENTITY,
            DVec3::new(place(column), place(row), 0.0),
        )
    });
    scene(icosphere(3, |_| 1.0), places.collect())
}

/// Returns a view over the scenes; `turn`, radians, rotates it around their centre.
pub(crate) fn view(size: ImageSize, turn: f64) -> View {
    let eye = DVec3::new(4.0 * turn.sin(), -4.0 * turn.cos(), 3.0);
    let target = DVec3::new(1.5 * turn.sin(), -1.5 * turn.cos(), 0.0);
    looking_at(eye, target, DVec3::Z, size)
}

fn scene(mesh: Mesh, places: Vec<DAffine3>) -> Scene {
    let instances = (0u32..).zip(places).map(|(index, world_from_mesh)| Instance {
        mesh: 0,
        path: format!("/Instance{index}"),
        world_from_mesh,
        labels: Vec::new(),
        material_offset: 0,
    });
    Scene {
        instances: instances.collect(),
        meshes: vec![mesh],
        ..Scene::default()
    }
}
