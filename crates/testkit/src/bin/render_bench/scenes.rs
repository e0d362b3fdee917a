//! The benchmark's scenes and views.

use std::path::Path;

use oaktwin_camera::ImageSize;
use oaktwin_camera::math::DVec3;
use oaktwin_scene::Mesh;
use oaktwin_testkit::shapes::{heightfield, hills, icosphere};
use oaktwin_testkit::views::looking_at;

use crate::protocol::ViewJson;
use crate::triangles::Files;

/// A scene of the benchmark.
pub(crate) struct Scene {
    pub(crate) name: &'static str,
    /// The title in the table.
    pub(crate) title: &'static str,
    eye: [f64; 3],
    target: [f64; 3],
    up: DVec3,
    /// `None` if the triangles are written by another program.
    make: Option<fn() -> Mesh>,
}

/// The scenes, from small to large.
pub(crate) const SCENES: [Scene; 4] = [
    Scene {
        name: "sphere",
        title: "displaced sphere",
        eye: [0.0, -1.9, 0.3],
        target: [0.0, 0.0, 0.0],
        up: DVec3::Z,
        make: Some(|| icosphere(7, |[x, y, z]| 1.0 + 0.04 * hills(6.0 * x + z, 6.0 * y - 2.0 * z))),
    },
    Scene {
        name: "plane",
        title: "displaced plane",
        eye: [0.0, -4.0, 3.0],
        target: [0.0, -1.5, 0.0],
        up: DVec3::Z,
        make: Some(|| {
            heightfield([708, 708], [14.0, 14.0], |x, y| {
                0.3 * hills(x, y) + 0.01 * hills(17.0 * x, 17.0 * y)
            })
        }),
    },
    Scene {
        name: "chess",
        title: "Open Chess Set",
        eye: [0.45, 0.3, 0.3],
        target: [0.0, 0.03, 0.0],
        up: DVec3::Y,
        make: None,
    },
    Scene {
        name: "heightfield",
        title: "heightfield",
        eye: [0.0, -18.0, 8.0],
        target: [0.0, 0.0, -2.0],
        up: DVec3::Z,
        make: Some(|| {
            heightfield([2000, 2000], [40.0, 40.0], |x, y| {
                2.0 * hills(0.3 * x, 0.3 * y) + 0.02 * hills(9.0 * x, 9.0 * y)
            })
        }),
    },
];

/// Returns the scene with this name.
pub(crate) fn find(name: &str) -> Result<&'static Scene, String> {
    let names = || {
        SCENES
            .iter()
            .map(|scene| scene.name)
            .collect::<Vec<_>>()
            .join(", ")
    };
    let found = SCENES.iter().find(|scene| scene.name == name);
    found.ok_or_else(|| format!("unknown scene {name}; expected one of {}", names()))
}

impl Scene {
    /// The scene's triangle files, created on first use.
    pub(crate) fn files(&self, folder: &Path) -> Result<Files, String> {
        let files = Files::of(folder, self.name);
        match self.make {
            None if files.exist() => Ok(files),
            None => Err(
                "the triangles are extracted by `cargo xtask bench render` with OAKTWIN_TEST_DATA set"
                    .to_owned(),
            ),
            Some(make) => {
                let written = files.write(&make());
                written.map_err(|error| format!("{}: {error}", folder.display()))?;
                Ok(files)
            }
        }
    }

    /// A view with a horizontal field of view of 77°, like an OAK-D's stereo cameras'.
    pub(crate) fn view(&self, width: u32, height: u32) -> ViewJson {
        let size = ImageSize::new(width, height);
        let view = looking_at(self.eye.into(), self.target.into(), self.up, size);
        let pose = view.world_from_camera;
        ViewJson {
            width,
            height,
            focal: view.camera.intrinsics.fx,
            rotation: pose.rotation.transpose().to_cols_array_2d(),
            translation: pose.translation.to_array(),
            near: 0.01,
        }
    }
}
