//! Imports glTF 2.0, `.gltf` and `.glb`, from the raw JSON, without trusting its contents.
//!
//! Supported: nodes, meshes of triangles, strips and fans, sparse and quantized accessors, base colour with its texture and
//! `KHR_texture_transform`, vertex colours, cameras, `KHR_lights_punctual`, meshes compressed by Draco and meshopt, and
//! textures compressed by Basis Universal. Skins, morph targets, points and lines are reported as findings.

mod accessor;
mod camera;
mod compressed;
mod document;
mod glb;
mod json;
mod light;
mod material;
mod mesh;
mod node;
mod uri;

use std::path::Path;

use self::document::Document;
use self::uri::Folder;
use super::builder::Builder;
use super::error::Fault;

/// The supported extensions that a file may require.
const KNOWN_EXTENSIONS: [&str; 9] = [
    "EXT_texture_webp",
    "KHR_lights_punctual",
    "KHR_materials_emissive_strength",
    "KHR_materials_ior",
    "KHR_materials_unlit",
    "KHR_materials_variants",
    "KHR_mesh_quantization",
    "KHR_texture_basisu",
    "KHR_texture_transform",
];

pub(super) fn read(
    bytes: Vec<u8>,
    path: &Path,
    allow_outside: bool,
    builder: &mut Builder,
) -> Result<(), Fault> {
    let folder = Folder::of(path, allow_outside);
    let document = Document::open(bytes, path, folder)?;
    for extension in &document.root.extensions_required {
        let extension = extension.as_str();
        if !KNOWN_EXTENSIONS.contains(&extension) && !compressed::EXTENSIONS.contains(&extension) {
            builder.warn(
                "gltf-extension",
                extension,
                "the file requires this extension, which is not supported; the result may be incomplete or wrong",
            );
        }
    }
    let materials = material::Materials::read(&document, builder);
    node::read(&document, &materials, builder)
}
