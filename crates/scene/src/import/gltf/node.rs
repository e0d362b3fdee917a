//! Imports the tree of nodes, without recursion: the nesting depth is limited only by the file size.

use ::gltf::json;
use oaktwin_camera::math::DAffine3;

use super::document::Document;
use super::material::Materials;
use super::placement::INSTANCING as EXTENSION;
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
    parent: Parent,
}

/// What a node inherits.
#[derive(Clone, Copy)]
struct Parent {
    file_from_parent: DAffine3,
    is_visible: bool,
}

pub(super) fn read(document: &Document, materials: &Materials, builder: &mut Builder) -> Result<(), Fault> {
    let roots = roots(document, builder);
    let mut walk = Walk {
        document,
        materials,
        meshes: vec![MeshState::Unread; document.root.meshes.len()],
        file_from_nodes: None,
        visited: vec![false; document.root.nodes.len()],
        repeated: 0,
        stack: Vec::new(),
    };
    let file = Parent {
        file_from_parent: DAffine3::IDENTITY,
        is_visible: true,
    };
    walk.push(&roots, "", file);
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
    Ok(())
}

/// A depth-first traversal of the nodes.
struct Walk<'a> {
    document: &'a Document,
    materials: &'a Materials,
    meshes: Vec<MeshState>,
    /// The transforms of all nodes, once a skin needs them.
    file_from_nodes: Option<Vec<DAffine3>>,
    visited: Vec<bool>,
    repeated: usize,
    stack: Vec<Pending>,
}

impl Walk<'_> {
    fn push(&mut self, children: &[usize], path: &str, parent: Parent) {
        // The last to be pushed is the first to be visited.
        self.stack.extend(children.iter().rev().map(|&node| Pending {
            node,
            parent_path: path.to_string(),
            parent,
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
        let placement = &self.document.placements[index];
        let file_from_node = pending.parent.file_from_parent * placement.parent_from_node;
        let is_visible = pending.parent.is_visible && placement.is_visible;
        if is_visible && let Some(mesh) = node.mesh {
            let skin = node.skin.map(|skin| skin.value());
            self.place(index, mesh.value(), skin, &path, file_from_node, builder)?;
        }
        if let Some(camera) = node.camera {
            camera::read(self.document, camera.value(), &path, file_from_node, builder);
        }
        let lights = node
            .extensions
            .as_ref()
            .and_then(|extensions| extensions.khr_lights_punctual.as_ref());
        if is_visible && let Some(lights) = lights {
            light::read(
                self.document,
                lights.light.value(),
                &path,
                file_from_node,
                builder,
            );
        }
        let children: Vec<usize> = node.children.iter().flatten().map(json::Index::value).collect();
        let parent = Parent {
            file_from_parent: file_from_node,
            is_visible,
        };
        self.push(&children, &path, parent);
        Ok(())
    }

    /// Places the mesh of a node.
    fn place(
        &mut self,
        node: usize,
        mesh: usize,
        skin: Option<usize>,
        path: &str,
        file_from_node: DAffine3,
        builder: &mut Builder,
    ) -> Result<(), Fault> {
        let document = self.document;
        let weights = document.placements[node].weights.as_deref();
        if let Some(skin) = skin {
            let file_from_nodes = self
                .file_from_nodes
                .get_or_insert_with(|| file_from_nodes(document));
            let pose = match document.skins.get(skin) {
                Some(skin) => skin.pose(document, file_from_nodes, file_from_node),
                None => Err("it does not exist".into()),
            };
            match pose {
                Ok(pose) => {
                    if document.instancing.contains_key(&node) {
                        let message = format!("{EXTENSION} is ignored: its mesh has a skin");
                        builder.warn("gltf-unsupported", path, message);
                    }
                    let mesh = mesh::read(document, mesh, self.materials, weights, Some(&pose), builder)?;
                    if let Some(mesh) = builder.add_mesh(mesh) {
                        builder.place(mesh, path, pose.file_from_frame);
                    }
                    return Ok(());
                }
                Err(why) => builder.warn("gltf-skin", path, format!("its skin is ignored: {why}")),
            }
        }
        let found = match weights {
            Some(_) => {
                let mesh = mesh::read(document, mesh, self.materials, weights, None, builder)?;
                builder.add_mesh(mesh).map_or(MeshState::Empty, MeshState::Index)
            }
            None => self.mesh(node, mesh, builder)?,
        };
        let MeshState::Index(mesh) = found else {
            return Ok(());
        };
        let Some(instancing) = document.instancing.get(&node) else {
            builder.place(mesh, path, file_from_node);
            return Ok(());
        };
        if !instancing.others.is_empty() {
            let message = format!(
                "attributes of {EXTENSION} are ignored: {}",
                instancing.others.join(", ")
            );
            builder.warn("gltf-unsupported", path, message);
        }
        let node_from_mesh = instancing.node_from_mesh(document);
        let node_from_mesh = node_from_mesh.map_err(|message| Fault::damaged(path, message))?;
        for (i, node_from_mesh) in node_from_mesh.into_iter().enumerate() {
            builder.place(
                mesh,
                &format!("{path}/instance_{i}"),
                file_from_node * node_from_mesh,
            );
        }
        Ok(())
    }

    /// Reads a mesh of the file on its first use.
    fn mesh(&mut self, node: usize, mesh: usize, builder: &mut Builder) -> Result<MeshState, Fault> {
        let Some(state) = self.meshes.get_mut(mesh) else {
            return Err(Fault::damaged(format!("nodes[{node}].mesh"), "does not exist"));
        };
        if let MeshState::Unread = state {
            let mesh = mesh::read(self.document, mesh, self.materials, None, None, builder)?;
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

/// The transforms of all nodes to the file's frame. Of several parents the first counts.
fn file_from_nodes(document: &Document) -> Vec<DAffine3> {
    let nodes = &document.root.nodes;
    let children = |node: usize| nodes[node].children.iter().flatten().map(json::Index::value);
    let mut parents = vec![None; nodes.len()];
    for node in 0..nodes.len() {
        for child in children(node) {
            if let Some(parent @ None) = parents.get_mut(child) {
                *parent = Some(node);
            }
        }
    }
    let mut transforms: Vec<DAffine3> = document
        .placements
        .iter()
        .map(|placement| placement.parent_from_node)
        .collect();
    let mut stack: Vec<usize> = (0..nodes.len()).filter(|&node| parents[node].is_none()).collect();
    while let Some(node) = stack.pop() {
        if let Some(parent) = parents[node].take() {
            transforms[node] = transforms[parent] * transforms[node];
        }
        stack.extend(children(node).filter(|&child| parents.get(child) == Some(&Some(node))));
    }
    transforms
}
