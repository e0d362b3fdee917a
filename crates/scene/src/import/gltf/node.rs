//! Imports the tree of nodes, without recursion: the nesting depth is limited only by the file size.

use ::gltf::json;
use oaktwin_camera::math::{DAffine3, DMat4, DQuat, DVec3};

use super::document::Document;
use super::material::Materials;
use super::{camera, light, mesh};
use crate::import::builder::{Builder, step};
use crate::import::error::Fault;

/// Nodes below a path longer than this get the path of their parent.
const MAX_PATH_BYTES: usize = 2048;

/// The import state of a mesh.
#[derive(Clone, Copy)]
enum MeshState {
    Unread,
    Empty,
    Index(u32),
}

/// A node that is still to be visited.
struct Pending {
    node: usize,
    parent_path: String,
    file_from_parent: DAffine3,
}

pub(super) fn read(document: &Document, materials: &Materials, builder: &mut Builder) -> Result<(), Fault> {
    let roots = roots(document, builder);
    let mut walk = Walk {
        document,
        materials,
        meshes: vec![MeshState::Unread; document.root.meshes.len()],
        visited: vec![false; document.root.nodes.len()],
        repeated: 0,
        stack: Vec::new(),
    };
    walk.push(&roots, "", DAffine3::IDENTITY);
    while let Some(pending) = walk.stack.pop() {
        walk.visit(&pending, builder)?;
    }
    if walk.repeated > 0 {
        builder.warn(
            "gltf-tree",
            "nodes",
            format!(
                "{} references to nodes that are their own ancestors or have several parents; ignored",
                walk.repeated
            ),
        );
    }
    if !document.root.animations.is_empty() {
        let count = document.root.animations.len();
        builder.warn(
            "gltf-unsupported",
            "animations",
            format!("not supported: {count} skipped"),
        );
    }
    Ok(())
}

/// A depth-first traversal of the nodes.
struct Walk<'a> {
    document: &'a Document,
    materials: &'a Materials,
    meshes: Vec<MeshState>,
    visited: Vec<bool>,
    repeated: usize,
    stack: Vec<Pending>,
}

impl Walk<'_> {
    fn push(&mut self, children: &[usize], path: &str, file_from_parent: DAffine3) {
        // The last to be pushed is the first to be visited.
        self.stack.extend(children.iter().rev().map(|&node| Pending {
            node,
            parent_path: path.to_string(),
            file_from_parent,
        }));
    }

    fn visit(&mut self, pending: &Pending, builder: &mut Builder) -> Result<(), Fault> {
        let index = pending.node;
        let Some(node) = self.document.root.nodes.get(index) else {
            return Err(Fault::damaged(format!("nodes[{index}]"), "does not exist"));
        };
        if std::mem::replace(&mut self.visited[index], true) {
            self.repeated += 1;
            return Ok(());
        }
        let path = node_path(node, pending);
        let file_from_node = pending.file_from_parent * local(node);
        if let Some(mesh) = node.mesh {
            if node.skin.is_some() {
                builder.warn(
                    "gltf-unsupported",
                    &path,
                    "its skin is ignored: it is rendered in its rest pose",
                );
            }
            if let MeshState::Index(mesh) = self.mesh(index, mesh.value(), builder)? {
                builder.place(mesh, &path, file_from_node);
            }
        }
        if let Some(camera) = node.camera {
            camera::read(self.document, camera.value(), &path, file_from_node, builder);
        }
        let lights = node
            .extensions
            .as_ref()
            .and_then(|extensions| extensions.khr_lights_punctual.as_ref());
        if let Some(lights) = lights {
            light::read(
                self.document,
                lights.light.value(),
                &path,
                file_from_node,
                builder,
            );
        }
        let children: Vec<usize> = node.children.iter().flatten().map(json::Index::value).collect();
        self.push(&children, &path, file_from_node);
        Ok(())
    }

    /// Reads a mesh of the file on its first use.
    fn mesh(&mut self, node: usize, mesh: usize, builder: &mut Builder) -> Result<MeshState, Fault> {
        let Some(state) = self.meshes.get_mut(mesh) else {
            return Err(Fault::damaged(format!("nodes[{node}].mesh"), "does not exist"));
        };
        if let MeshState::Unread = state {
            let mesh = mesh::read(self.document, mesh, self.materials, builder)?;
            *state = builder.add_mesh(mesh).map_or(MeshState::Empty, MeshState::Index);
        }
        Ok(*state)
    }
}

fn node_path(node: &json::Node, pending: &Pending) -> String {
    let parent = &pending.parent_path;
    if parent.len() > MAX_PATH_BYTES {
        return parent.clone();
    }
    match step(node.name.as_deref().unwrap_or_default()) {
        name if name.is_empty() => format!("{parent}/node_{}", pending.node),
        name => format!("{parent}/{name}"),
    }
}

/// The root nodes of the displayed scene; without a scene, the nodes that are not children.
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

/// The transform from a node's frame to its parent's.
fn local(node: &json::Node) -> DAffine3 {
    if let Some(matrix) = node.matrix {
        return DAffine3::from_mat4(DMat4::from_cols_array(&matrix.map(f64::from)));
    }
    let vector = |value: Option<[f32; 3]>, default| value.map_or(default, |v| DVec3::from(v.map(f64::from)));
    let rotation = node.rotation.map_or(DQuat::IDENTITY, |rotation| {
        let quaternion = DQuat::from_array(rotation.0.map(f64::from));
        // In single precision the length is only approximately 1.
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
