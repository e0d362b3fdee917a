//! Scenes as USD files: meshes with poses, labels and preview materials, and lights.
//!
//! Meshes are written in the world frame's metres and axes. Geometry that several instances share is written for each.

mod light;
mod material;
mod mesh;
#[cfg(test)]
mod tests;
mod tree;

use oaktwin_camera::math::DAffine3;
use oaktwin_image::CodecError;
use oaktwin_scene::{Scene, Up};

use self::material::Materials;
use self::tree::Tree;
use crate::text::{Layer, PrimSpec, SpecValue, UpAxis};

/// A scene as a USD layer, and the images that it refers to.
#[derive(Clone, Debug, PartialEq)]
pub struct SceneLayer {
    /// The layer.
    pub layer: Layer,
    /// The images: their paths relative to the layer, and their bytes.
    pub images: Vec<(String, Vec<u8>)>,
}

/// How a layer refers to the images of a scene that are files.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ImageFiles {
    /// Where they are.
    Referenced,
    /// As copies beside the layer, so that it can be moved; formats other than PNG and JPEG where they are.
    Copied,
}

/// Converts a scene. Images that are not files, or that are copied, are to be written to `folder`, relative to the layer: the used ones, in
/// the order of their first use.
///
/// # Errors
/// Returns an error for a texture that cannot be decoded, or copied.
pub fn scene_file(scene: &Scene, folder: &str, files: ImageFiles) -> Result<SceneLayer, CodecError> {
    let materials = Materials::new(scene, folder, files)?;
    let mut tree = Tree::default();
    for instance in &scene.instances {
        if let Some(mesh) = scene.meshes.get(instance.mesh as usize) {
            let mesh = mesh::prim(mesh, instance, &materials);
            tree.insert(&instance.path, mesh, &instance.world_from_mesh);
        }
    }
    for light in &scene.lights {
        let prim = light::prim(light, &materials);
        tree.insert(&light.path, prim, &light.world_from_light);
    }
    let mut root = tree.into_root();
    materials.bind(&mut root);
    let layer = Layer {
        default_prim: Some(root.name.clone()),
        meters_per_unit: Some(1.0),
        up_axis: Some(match scene.up {
            Up::Y => UpAxis::Y,
            Up::Z => UpAxis::Z,
        }),
        prims: vec![root],
        ..Layer::default()
    };
    Ok(SceneLayer {
        layer,
        images: materials.into_images(),
    })
}

/// Sets the transform of a prim. `resets` ignores its parents' transforms.
fn place(prim: &mut PrimSpec, world_from_prim: &DAffine3, resets: bool) {
    let m = world_from_prim.matrix3;
    let axis = |v: oaktwin_camera::math::DVec3, w: f64| [v.x, v.y, v.z, w];
    let rows = [
        axis(m.x_axis, 0.0),
        axis(m.y_axis, 0.0),
        axis(m.z_axis, 0.0),
        axis(world_from_prim.translation, 1.0),
    ];
    prim.set("xformOp:transform", SpecValue::Matrix4d(rows));
    let reset = resets.then(|| "!resetXformStack!".to_owned());
    let order = reset
        .into_iter()
        .chain(["xformOp:transform".to_owned()])
        .collect();
    prim.set_uniform("xformOpOrder", SpecValue::TokenArray(order));
}
