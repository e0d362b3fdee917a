//! Imports glTF 2.0, `.gltf` and `.glb`, from the raw JSON, without trusting its contents.
//!
//! Supported: nodes, animations, `EXT_mesh_gpu_instancing`, `KHR_node_visibility`, skins in the pose of their joints' nodes, morph targets, meshes of
//! triangles, strips and fans, sparse and quantized accessors, base colour with its texture and `KHR_texture_transform`,
//! vertex colours, cameras, `KHR_lights_punctual`, meshes compressed by Draco and meshopt, and textures compressed by Basis
//! Universal. Points, lines and other extensions that may move surfaces are reported as findings.

mod accessor;
mod animation;
mod camera;
mod channel;
mod compressed;
mod document;
mod extension;
mod glb;
mod instancing;
mod json;
mod light;
mod material;
mod mesh;
mod morph;
mod node;
mod placement;
mod skin;

use std::path::Path;

use self::document::Document;
use super::ImportOptions;
use super::builder::Builder;
use super::error::Fault;
use super::uri::Folder;

pub(super) fn read(
    bytes: Vec<u8>,
    path: &Path,
    options: &ImportOptions,
    builder: &mut Builder,
) -> Result<(), Fault> {
    let folder = Folder::of(path, options.allow_outside);
    let mut document = Document::open(bytes, path, folder)?;
    animate(&mut document, options.time_s, builder);
    extension::report(&document, builder);
    let materials = material::Materials::read(&document, builder);
    node::read(&document, &materials, builder)
}

/// Moves nodes and morph targets to where they are at a time, s; without one, they are as in the file.
fn animate(document: &mut Document, time_s: Option<f64>, builder: &mut Builder) {
    builder.animated_s = animation::range(document);
    let (Some(time_s), Some(_)) = (time_s, builder.animated_s) else {
        if let Some((first, last)) = builder.animated_s {
            let message = format!("from {first} to {last} s; nodes stand as in the file without a time");
            builder.note("time", "animations", message);
        }
        return;
    };
    let (changes, faults) = animation::at(document, time_s);
    for fault in faults {
        builder.warn("gltf-animation", "animations", format!("{fault}; ignored"));
    }
    for (node, change) in changes {
        if let Some(placement) = document.placements.get_mut(node) {
            placement.change(change);
        }
    }
}
