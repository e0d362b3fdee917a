//! The nodes of the scene and what they place.

use std::collections::{BTreeMap, HashMap};

use oaktwin_camera::math::{DAffine3, DMat3, DMat4, DQuat, DVec3};
use oaktwin_files::xml::{Element, XmlError};

use super::document::{Document, name};
use super::effect::Effects;
use super::geometry::{self, Bound, MAX_CORNERS};
use super::source::whole;
use crate::import::builder::{Builder, step};
use crate::import::error::{DAMAGED, Fault};

/// The maximum depth of nodes.
const MAX_DEPTH: usize = 256;

/// The maximum number of nodes, with all instances of nodes.
const MAX_NODES: usize = 1 << 20;

/// The maximum number of primitives whose materials are looked up, with all instances of geometries.
const MAX_PRIMITIVES: usize = 1 << 26;

/// Nodes below a path longer than this get the path of their parent.
const MAX_PATH_BYTES: usize = 2048;

/// A node that is still to be visited.
struct Pending<'a> {
    node: &'a Element,
    parent_path: String,
    file_from_parent: DAffine3,
    /// The place among the visited nodes of the one that contains or instances it.
    parent: Option<usize>,
    depth: usize,
}

/// What an instance binds to the names of materials.
type Bindings<'a> = BTreeMap<&'a str, Bound>;

/// A mesh of a geometry, in its frame.
type Placed = (u32, DAffine3);

struct Walk<'a, 'b> {
    document: &'b Document<'a>,
    effects: &'b mut Effects,
    builder: &'b mut Builder,
    left_out: &'b mut BTreeMap<&'static str, usize>,
    /// The meshes of geometries, as their instances look. Never iterated.
    meshes: HashMap<(&'a str, Bindings<'a>), Vec<Placed>>,
    corners_left: usize,
    primitives_left: usize,
    /// The visited nodes with the places of their parents.
    visited: Vec<(&'a Element, Option<usize>)>,
    stack: Vec<Pending<'a>>,
}

pub(super) fn read<'a>(
    document: &Document<'a>,
    effects: &mut Effects,
    left_out: &mut BTreeMap<&'static str, usize>,
    builder: &mut Builder,
) -> Result<(), Fault> {
    let Some(scene) = shown(document)? else {
        return Ok(());
    };
    let mut walk = Walk {
        document,
        effects,
        builder,
        left_out,
        meshes: HashMap::new(),
        corners_left: MAX_CORNERS,
        primitives_left: MAX_PRIMITIVES,
        visited: Vec::new(),
        stack: Vec::new(),
    };
    let root = |node| Pending {
        node,
        parent_path: String::new(),
        file_from_parent: DAffine3::IDENTITY,
        parent: None,
        depth: 0,
    };
    let roots: Vec<&Element> = scene.all("node").collect();
    walk.stack.extend(roots.into_iter().rev().map(root));
    while let Some(pending) = walk.stack.pop() {
        walk.visit(pending)?;
    }
    Ok(())
}

/// The scene that the file shows; without a statement, its first one.
fn shown<'a>(document: &Document<'a>) -> Result<Option<&'a Element>, XmlError> {
    let instance = document
        .root
        .child("scene")
        .and_then(|scene| scene.child("instance_visual_scene"));
    match instance {
        Some(instance) => document.follow(instance, "url", "visual_scene").map(Some),
        None => {
            let scenes = document.root.child("library_visual_scenes");
            Ok(scenes.and_then(|scenes| scenes.child("visual_scene")))
        }
    }
}

impl<'a> Walk<'a, '_> {
    fn visit(&mut self, pending: Pending<'a>) -> Result<(), XmlError> {
        let node = pending.node;
        self.check(&pending)?;
        self.visited.push((node, pending.parent));
        let own = self.visited.len() - 1;
        let file_from_node = pending.file_from_parent * parent_from_node(node)?;
        let path = match step(name(node)) {
            _ if pending.parent_path.len() > MAX_PATH_BYTES => pending.parent_path,
            name if name.is_empty() => format!("{}/node_{own}", pending.parent_path),
            name => format!("{}/{name}", pending.parent_path),
        };
        let mut below = Vec::new();
        for child in &node.children {
            match child.tag.as_str() {
                "node" => below.push(child),
                "instance_node" => below.push(self.document.follow(child, "url", "node")?),
                "instance_geometry" => {
                    for (mesh, node_from_mesh) in self.instance(child)? {
                        self.builder.place(mesh, &path, file_from_node * node_from_mesh);
                    }
                }
                "instance_controller" => {
                    let message = "skins and morphs are not supported: it is missing";
                    self.builder.warn("dae-controller", child.place(), message);
                }
                "instance_light" => *self.left_out.entry("lights").or_default() += 1,
                "instance_camera" => *self.left_out.entry("cameras").or_default() += 1,
                _ => {}
            }
        }
        let (depth, parent) = (pending.depth + 1, Some(own));
        self.stack.extend(below.into_iter().rev().map(|node| Pending {
            node,
            parent_path: path.clone(),
            file_from_parent: file_from_node,
            parent,
            depth,
        }));
        Ok(())
    }

    /// Rejects nodes that contain themselves, and more nodes than a scene may have.
    fn check(&self, pending: &Pending<'_>) -> Result<(), XmlError> {
        let node = pending.node;
        let mut parent = pending.parent;
        while let Some(at) = parent {
            if std::ptr::eq(self.visited[at].0, node) {
                let remedy = "remove the <instance_node> of a node in itself";
                return Err(node.wrong("the node contains itself", remedy));
            }
            parent = self.visited[at].1;
        }
        if pending.depth > MAX_DEPTH {
            let message = format!("nodes nest more than {MAX_DEPTH} deep");
            return Err(node.wrong(message, "export the scene with fewer levels"));
        }
        if self.visited.len() >= MAX_NODES {
            let message = format!("there are more than {MAX_NODES} nodes with all their instances");
            return Err(node.wrong(message, "export a part of the scene"));
        }
        Ok(())
    }

    /// Returns the meshes that an `<instance_geometry>` places.
    fn instance(&mut self, instance: &'a Element) -> Result<Vec<Placed>, XmlError> {
        let geometry = self.document.follow(instance, "url", "geometry")?;
        let Some(mesh) = geometry.child("mesh") else {
            let message = "is neither polygons nor triangles: it is missing";
            self.builder.warn("dae-geometry", geometry.place(), message);
            return Ok(Vec::new());
        };
        let bindings = self.bindings(instance, mesh)?;
        let key = (geometry.get("id").unwrap_or_default(), bindings);
        if let Some(known) = self.meshes.get(&key) {
            return Ok(known.clone());
        }
        let bound = |symbol: &str| key.1.get(symbol).copied();
        let mut lines = 0;
        let read = geometry::read(mesh, &bound, &mut self.corners_left, &mut lines, self.builder)?;
        if lines > 0 {
            *self.left_out.entry("lines").or_default() += lines;
        }
        let mut placed = Vec::new();
        for (polygons, origin) in read {
            let (mesh, findings) = polygons.into_mesh(&geometry.place());
            self.builder.findings.extend(findings);
            let added = self.builder.add_mesh(mesh);
            placed.extend(added.map(|mesh| (mesh, DAffine3::from_translation(origin))));
        }
        self.meshes.insert(key, placed.clone());
        Ok(placed)
    }

    /// Returns the materials of an instance by the names that its geometry uses. Some exporters bind nothing, and name materials by their ids.
    fn bindings(&mut self, instance: &'a Element, mesh: &'a Element) -> Result<Bindings<'a>, XmlError> {
        self.primitives_left = self
            .primitives_left
            .checked_sub(mesh.children.len())
            .ok_or_else(|| {
                let message = format!("the instances have more than {MAX_PRIMITIVES} primitives");
                instance.wrong(message, "export a part of the scene")
            })?;
        let technique = instance
            .child("bind_material")
            .and_then(|bind| bind.child("technique_common"));
        let instances: HashMap<&str, &Element> = technique
            .iter()
            .flat_map(|technique| technique.all("instance_material"))
            .filter_map(|one| Some((one.get("symbol")?, one)))
            .collect();
        let mut bindings = Bindings::new();
        for primitive in &mesh.children {
            let symbol = primitive.get("material");
            let Some(symbol) = symbol.filter(|symbol| !bindings.contains_key(symbol)) else {
                continue;
            };
            let own = instances.get(symbol);
            let material = match own {
                Some(own) => Some(self.document.follow(own, "target", "material")?),
                None => self.document.find(symbol).filter(|found| found.tag == "material"),
            };
            let Some(material) = material else {
                continue;
            };
            let bound = self.effects.material(material, self.document, self.builder)?;
            let mut set = None;
            for input in own.iter().flat_map(|own| own.all("bind_vertex_input")) {
                if input.get("semantic") == bound.coordinates.as_deref() {
                    set = whole(input, "input_set")?;
                }
            }
            let (material, has_color) = (bound.material, bound.has_color);
            bindings.insert(
                symbol,
                Bound {
                    material,
                    set,
                    has_color,
                },
            );
        }
        Ok(bindings)
    }
}

/// The product of a node's transforms, in their order.
fn parent_from_node(node: &Element) -> Result<DAffine3, XmlError> {
    let mut whole = DAffine3::IDENTITY;
    for element in &node.children {
        whole *= transform(element)?;
    }
    Ok(whole)
}

/// Reads a transform; the identity of any other element.
fn transform(element: &Element) -> Result<DAffine3, XmlError> {
    Ok(match element.tag.as_str() {
        "matrix" => matrix(element)?,
        "translate" => DAffine3::from_translation(DVec3::from(numbers::<3>(element)?)),
        "scale" => DAffine3::from_scale(DVec3::from(numbers::<3>(element)?)),
        "rotate" => {
            let [x, y, z, degrees] = numbers::<4>(element)?;
            let axis = DVec3::new(x, y, z).normalize_or_zero();
            if axis == DVec3::ZERO && degrees != 0.0 {
                let remedy = "give the axis of the rotation";
                return Err(element.wrong("the axis has no direction", remedy));
            }
            turn(axis, degrees.to_radians())
        }
        "lookat" => {
            let [ex, ey, ez, x, y, z, ux, uy, uz] = numbers::<9>(element)?;
            let (eye, point, up) = (
                DVec3::new(ex, ey, ez),
                DVec3::new(x, y, z),
                DVec3::new(ux, uy, uz),
            );
            look_at(eye, point, up)
                .ok_or_else(|| element.wrong("the directions of <lookat> coincide", "correct its points"))?
        }
        "skew" => {
            let remedy = "export the node with a <matrix>";
            return Err(element.wrong("<skew> is not supported", remedy));
        }
        _ => DAffine3::IDENTITY,
    })
}

fn numbers<const N: usize>(element: &Element) -> Result<[f64; N], XmlError> {
    let numbers = element.text_numbers()?;
    let count = numbers.len();
    numbers
        .try_into()
        .map_err(|_| element.wrong(format!("{count} numbers instead of {N}"), DAMAGED))
}

/// A matrix, row by row.
fn matrix(element: &Element) -> Result<DAffine3, XmlError> {
    let rows = numbers::<16>(element)?;
    if rows[12..] != [0.0, 0.0, 0.0, 1.0] {
        let message = "the last row of the matrix is not 0 0 0 1";
        return Err(element.wrong(message, "export the node without a projection"));
    }
    Ok(DAffine3::from_mat4(DMat4::from_cols_array(&rows).transpose()))
}

/// The rotation about a unit vector by an angle in radians, with sines that do not depend on the machine.
fn turn(axis: DVec3, angle: f64) -> DAffine3 {
    let (sine, cosine) = libm::sincos(0.5 * angle);
    let vector = axis * sine;
    DAffine3::from_quat(DQuat::from_xyzw(vector.x, vector.y, vector.z, cosine))
}

/// The frame at a point that looks along −z to another point, as a camera does.
fn look_at(eye: DVec3, point: DVec3, up: DVec3) -> Option<DAffine3> {
    let z = (eye - point).try_normalize()?;
    let x = up.cross(z).try_normalize()?;
    Some(DAffine3::from_mat3_translation(
        DMat3::from_cols(x, z.cross(x), z),
        eye,
    ))
}
