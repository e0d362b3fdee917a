//! The tree of nodes, without recursion: a file may nest as deep as it is long.

use ::gltf::json;
use oaktwin_camera::math::{DAffine3, DMat4, DQuat, DVec3};

use super::document::Document;
use super::material::Materials;
use super::{camera, light, mesh};
use crate::import::builder::{Builder, step};
use crate::import::error::Fault;

/// A path grows no longer than this on its way down.
const LONGEST_PATH: usize = 2048;

/// What became of a mesh.
#[derive(Clone, Copy)]
enum Known {
    NotYet,
    Empty,
    Number(u32),
}

pub(super) fn read(document: &Document, materials: &Materials, builder: &mut Builder) -> Result<(), Fault> {
    let nodes = &document.root.nodes;
    let mut meshes = vec![Known::NotYet; document.root.meshes.len()];
    let mut seen = vec![false; nodes.len()];
    let mut twice = 0_usize;
    let mut stack: Vec<(usize, String, DAffine3)> = Vec::new();
    let push = |stack: &mut Vec<_>, children: &[usize], path: &str, transform: DAffine3| {
        // The last to be pushed is the first to be visited.
        stack.extend(
            children
                .iter()
                .rev()
                .map(|&child| (child, path.to_string(), transform)),
        );
    };
    push(&mut stack, &roots(document, builder), "", DAffine3::IDENTITY);
    while let Some((index, parent, file_from_parent)) = stack.pop() {
        let Some(node) = nodes.get(index) else {
            return Err(Fault::damaged(format!("nodes[{index}]"), "is not there"));
        };
        if std::mem::replace(&mut seen[index], true) {
            twice += 1;
            continue;
        }
        let name = step(node.name.as_deref().unwrap_or_default());
        let name = if name.is_empty() {
            format!("node_{index}")
        } else {
            name
        };
        let path = if parent.len() > LONGEST_PATH {
            parent
        } else {
            format!("{parent}/{name}")
        };
        let file_from_node = file_from_parent * local(node);
        if let Some(said) = node.mesh {
            let said = said.value();
            if node.skin.is_some() {
                builder.warn(
                    "gltf-unsupported",
                    &path,
                    "its skin is left out: it is rendered as it was modelled",
                );
            }
            let known = match meshes.get(said).copied() {
                Some(Known::NotYet) => {
                    let mesh = mesh::read(document, said, materials, builder)?;
                    let known = builder.add_mesh(mesh).map_or(Known::Empty, Known::Number);
                    meshes[said] = known;
                    known
                }
                Some(known) => known,
                None => return Err(Fault::damaged(format!("nodes[{index}].mesh"), "is not there")),
            };
            if let Known::Number(mesh) = known {
                builder.place(mesh, &path, file_from_node);
            }
        }
        if let Some(said) = node.camera {
            camera::read(document, said.value(), &path, file_from_node, builder);
        }
        let lights = node
            .extensions
            .as_ref()
            .and_then(|extensions| extensions.khr_lights_punctual.as_ref());
        if let Some(said) = lights {
            light::read(document, said.light.value(), &path, file_from_node, builder);
        }
        let children: Vec<usize> = node.children.iter().flatten().map(json::Index::value).collect();
        push(&mut stack, &children, &path, file_from_node);
    }
    if twice > 0 {
        builder.warn(
            "gltf-tree",
            "nodes",
            format!("nodes that are their own ancestors or have several parents are taken once: {twice}"),
        );
    }
    if !document.root.animations.is_empty() {
        let count = document.root.animations.len();
        builder.warn("gltf-unsupported", "animations", format!("left out: {count}"));
    }
    Ok(())
}

/// The nodes of the scene that the file shows; without one, those that are nobody's child.
fn roots(document: &Document, builder: &mut Builder) -> Vec<usize> {
    let root = &document.root;
    let shown = root.scene.map_or(0, |scene| scene.value());
    if let Some(scene) = root.scenes.get(shown) {
        if root.scenes.len() > 1 {
            builder.warn(
                "gltf-unsupported",
                "scenes",
                format!("only scene {shown} of {} is rendered", root.scenes.len()),
            );
        }
        return scene.nodes.iter().map(json::Index::value).collect();
    }
    let mut is_child = vec![false; root.nodes.len()];
    for child in root.nodes.iter().flat_map(|node| node.children.iter().flatten()) {
        if let Some(is_child) = is_child.get_mut(child.value()) {
            *is_child = true;
        }
    }
    (0..root.nodes.len()).filter(|&node| !is_child[node]).collect()
}

/// From a node's frame to its parent's.
fn local(node: &json::Node) -> DAffine3 {
    if let Some(matrix) = node.matrix {
        return DAffine3::from_mat4(DMat4::from_cols_array(&matrix.map(f64::from)));
    }
    let vector =
        |said: Option<[f32; 3]>, otherwise| said.map_or(otherwise, |v| DVec3::from(v.map(f64::from)));
    let rotation = node.rotation.map_or(DQuat::IDENTITY, |rotation| {
        let quaternion = DQuat::from_array(rotation.0.map(f64::from));
        // Single precision is not quite of unit length.
        let length = quaternion.length();
        if length > 0.0 && length.is_finite() {
            quaternion / length
        } else {
            DQuat::IDENTITY
        }
    });
    DAffine3::from_scale_rotation_translation(
        vector(node.scale, DVec3::ONE),
        rotation,
        vector(node.translation, DVec3::ZERO),
    )
}
