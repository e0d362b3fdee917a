//! Which extensions are implemented, and which do not change where surfaces are.

use super::compressed;
use super::document::Document;
use crate::import::builder::Builder;

/// The extensions that are supported; [`compressed`] and [`placement`](super::placement) list further ones.
const IMPLEMENTED: [&str; 11] = [
    "EXT_texture_webp",
    "KHR_lights_punctual",
    "KHR_materials_emissive_strength",
    "KHR_materials_ior",
    "KHR_materials_transmission",
    "KHR_materials_unlit",
    "KHR_materials_variants",
    "KHR_materials_volume",
    "KHR_mesh_quantization",
    "KHR_texture_basisu",
    "KHR_texture_transform",
];

/// The beginnings of the names of extensions that change neither geometry nor visibility: looks, images, lights of the
/// surroundings, metadata, physics, sound. `MSFT_lod` adds coarser levels to a node that has the finest.
const HARMLESS: [&str; 30] = [
    "ADOBE_materials_",
    "AGI_stk_metadata",
    "CESIUM_primitive_outline",
    "EXT_feature_metadata",
    "EXT_instance_features",
    "EXT_lights_",
    "EXT_materials_",
    "EXT_mesh_features",
    "EXT_mesh_manifold",
    "EXT_structural_metadata",
    "EXT_texture_",
    "FB_geometry_metadata",
    "KHR_animation_",
    "KHR_audio",
    "KHR_implicit_shapes",
    "KHR_lights_",
    "KHR_materials_",
    "KHR_node_hoverability",
    "KHR_node_selectability",
    "KHR_physics_",
    "KHR_techniques_webgl",
    "KHR_texture_",
    "KHR_xmp",
    "MSFT_lod",
    "MSFT_packing_",
    "MSFT_texture_",
    "NV_materials_",
    "OMI_physics_",
    "VRM",
    "MOZ_lightmap",
];

/// Reports the extensions without which the result may be wrong.
pub(super) fn report(document: &Document, builder: &mut Builder) {
    let own = [super::placement::INSTANCING];
    let implemented = [
        &IMPLEMENTED[..],
        &compressed::EXTENSIONS,
        &super::placement::VISIBILITY,
        &own,
    ]
    .concat();
    for name in &document.extensions {
        if implemented.contains(&name.as_str()) {
            continue;
        }
        if document.root.extensions_required.contains(name) {
            builder.warn(
                "gltf-extension",
                name,
                "the file requires this extension, which is not supported; the result may be incomplete or wrong",
            );
        } else if !HARMLESS.iter().any(|start| name.starts_with(start)) {
            builder.warn(
                "gltf-extension",
                name,
                "not supported; if this extension changes geometry or visibility, the result is incomplete or wrong",
            );
        }
    }
}
