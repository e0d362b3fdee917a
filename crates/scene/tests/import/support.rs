use std::fs;
use std::path::PathBuf;

use oaktwin_camera::math::DVec3;
use oaktwin_scene::Scene;
use oaktwin_scene::import::{self, ImportError, ImportOptions, ImportedScene};
use tempfile::TempDir;

/// A temporary folder with files.
pub(crate) struct Files(TempDir);

impl Files {
    pub(crate) fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    pub(crate) fn with(self, name: &str, content: impl AsRef<[u8]>) -> Self {
        let path = self.path(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, content).unwrap();
        self
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    pub(crate) fn try_open(&self, name: &str) -> Result<ImportedScene, ImportError> {
        import::open(&self.path(name), &ImportOptions::default())
    }

    pub(crate) fn open(&self, name: &str) -> ImportedScene {
        let imported = self.try_open(name).unwrap();
        check(&imported.scene);
        imported
    }

    /// The error message without the folder's name.
    pub(crate) fn error(&self, name: &str) -> String {
        let folder = format!("{}/", self.0.path().display());
        self.try_open(name).unwrap_err().to_string().replace(&folder, "")
    }
}

pub(crate) fn open(name: &str, content: impl AsRef<[u8]>) -> ImportedScene {
    Files::new().with(name, content).open(name)
}

pub(crate) fn error(name: &str, content: impl AsRef<[u8]>) -> String {
    Files::new().with(name, content).error(name)
}

/// Checks the invariants of a scene.
pub(crate) fn check(scene: &Scene) {
    assert!(!scene.instances.is_empty());
    for instance in &scene.instances {
        let mesh = &scene.meshes[instance.mesh as usize];
        assert!(!mesh.triangles.is_empty());
        assert!(instance.path.starts_with('/'));
        assert!(instance.world_from_mesh.inverse().is_finite());
    }
    for mesh in &scene.meshes {
        assert!(mesh.positions.iter().flatten().all(|x| x.is_finite()));
        for (i, triangle) in mesh.triangles.iter().enumerate() {
            assert!(mesh.corners(i).is_some());
            if let Some(normals) = &mesh.normals {
                for normal in normals.corners(i, *triangle).unwrap() {
                    let length = normal.iter().map(|x| x * x).sum::<f32>();
                    assert!(length == 0.0 || (length - 1.0).abs() < 1e-5);
                }
            }
            for uv in mesh.uvs.iter().flat_map(|uvs| uvs.corners(i, *triangle).unwrap()) {
                assert!(uv.iter().all(|x| x.is_finite()));
            }
            if let Some(material) = mesh.material(i as u32) {
                assert!((material as usize) < scene.materials.len());
            }
        }
        if let Some(last) = mesh.materials.last() {
            assert_eq!(last.end as usize, mesh.triangles.len());
        }
    }
    for texture in scene
        .materials
        .iter()
        .filter_map(|material| material.base_color_texture)
    {
        assert!((texture.texture as usize) < scene.textures.len());
    }
}

/// The corners of all triangles in the world frame.
pub(crate) fn triangles(scene: &Scene) -> Vec<[DVec3; 3]> {
    let mut all = Vec::new();
    for instance in &scene.instances {
        let mesh = &scene.meshes[instance.mesh as usize];
        for i in 0..mesh.triangles.len() {
            let corners = mesh.corners(i).unwrap();
            all.push(corners.map(|p| {
                instance
                    .world_from_mesh
                    .transform_point3(DVec3::from(p.map(f64::from)))
            }));
        }
    }
    all
}

pub(crate) fn messages(imported: &ImportedScene) -> Vec<String> {
    let text =
        |finding: &oaktwin_base::diagnostic::Finding| format!("{}: {}", finding.place, finding.message);
    imported.findings.iter().map(text).collect()
}

pub(crate) fn floats(numbers: &[f32]) -> Vec<u8> {
    numbers.iter().flat_map(|x| x.to_le_bytes()).collect()
}
