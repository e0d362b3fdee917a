//! Imports glTF 2.0, `.gltf` and `.glb`, from the raw JSON, without trusting its contents.
//!
//! Supported: nodes, `EXT_mesh_gpu_instancing`, `KHR_node_visibility`, skins in the pose of their joints' nodes, meshes of
//! triangles, strips and fans, sparse and quantized accessors, base colour with its texture and `KHR_texture_transform`,
//! vertex colours, cameras, `KHR_lights_punctual`, meshes compressed by Draco and meshopt, and textures compressed by Basis
//! Universal. Morph targets, animations, points, lines and other extensions that may move surfaces are reported as findings.

mod accessor;
mod camera;
mod compressed;
mod document;
mod extension;
mod glb;
mod instancing;
mod json;
mod light;
mod material;
mod mesh;
mod node;
mod placement;
mod skin;
mod uri;

use std::path::Path;

use self::document::Document;
use self::uri::Folder;
use super::builder::Builder;
use super::error::Fault;

pub(super) fn read(
    bytes: Vec<u8>,
    path: &Path,
    allow_outside: bool,
    builder: &mut Builder,
) -> Result<(), Fault> {
    let folder = Folder::of(path, allow_outside);
    let document = Document::open(bytes, path, folder)?;
    extension::report(&document, builder);
    let materials = material::Materials::read(&document, builder);
    node::read(&document, &materials, builder)
}
