//! Which prims of a stage move, so that another time needs their transforms only.

use std::collections::HashMap;

use oaktwin_base::diagnostic::{Finding, Level};
use oaktwin_camera::RigidTransform;
use oaktwin_camera::math::{DAffine3, DVec3};
use oaktwin_scene::Scene;

use super::prim_opinions::PrimOpinions;
use super::reader::{Reader, Record};
use super::scene::{Context, is_invertible, pose, rigid};
use super::transform::{LocalTransform, is_transformed, local_transform};
use super::walk::VisitedPrim;

/// The namespaces and types of attributes that do not change what is rendered.
const UNSEEN_NAMESPACES: [&str; 8] = [
    "userProperties:",
    "physics:",
    "physx",
    "drive:",
    "state:",
    "omni:",
    "ui:",
    "isaac:",
];
const UNSEEN_TYPES: [&str; 5] = [
    "RenderProduct",
    "RenderSettings",
    "RenderVar",
    "PhysicsScene",
    "OmniGraph",
];

/// A prim that moves, or one below it.
struct Node {
    /// The nearest moving prim above, which comes earlier in the list; `None` if nothing above moves.
    parent: Option<usize>,
    /// The transform of the prim above if it does not move, in stage units.
    stage_from_parent: DAffine3,
    local: Local,
    path: String,
    camera: Option<usize>,
}

/// The transform authored on a prim.
enum Local {
    Constant(Option<LocalTransform>),
    Animated(Box<Record>),
}

impl Node {
    /// The transform authored on the prim at the reader's time.
    fn local(&self, reader: &Reader) -> Option<LocalTransform> {
        match &self.local {
            Local::Constant(local) => *local,
            Local::Animated(record) => local_transform(reader, record),
        }
    }
}

/// What changes with time, found while a stage is read.
#[derive(Default)]
pub(super) struct Motion {
    nodes: Vec<Node>,
    /// The first attribute that changes more than the transforms of prims.
    deforms: Option<String>,
    /// The prototypes of point instancers, whose copies have no nodes.
    prototypes: Vec<String>,
    /// The prim that carries a device.
    mount: Option<String>,
    mount_node: Option<usize>,
    /// The prims that can carry one, for errors.
    transformed: Vec<String>,
}

impl Motion {
    /// Begins with the path of the prim that carries a device, if there is one.
    pub(super) fn new(mount: Option<&str>) -> Self {
        Self {
            mount: mount.map(str::to_owned),
            ..Self::default()
        }
    }

    /// Visits a prim below a context; `inner` is its own. Returns the number of its node if it can move.
    pub(super) fn visit(
        &mut self,
        reader: &Reader,
        prim: &VisitedPrim,
        path: &str,
        context: &Context,
        inner: &Context,
        opinions: &PrimOpinions,
    ) -> Option<usize> {
        let kind = prim.type_name.as_str();
        let is_mount = self.mount.as_deref() == Some(path);
        if self.mount.is_some() && is_transformed(kind) {
            self.transformed.push(path.to_owned());
        }
        let is_moved = self.classify(reader, prim, path);
        if kind == "PointInstancer" {
            let targets = reader.targets(prim, "prototypes");
            self.prototypes
                .extend(targets.iter().map(|path| path.as_str().to_owned()));
        }
        if !is_moved && context.node.is_none() && !is_mount {
            return None;
        }
        let carries = kind == "PointInstancer" || kind.contains("Light") || inner.is_skinned();
        if carries && (is_moved || context.node.is_some()) {
            self.deform(path);
        }
        let local = match is_moved {
            true => Local::Animated(Box::new(Record::clone(prim))),
            false => Local::Constant(opinions.transform),
        };
        let node = self.nodes.len();
        self.nodes.push(Node {
            parent: context.node,
            stage_from_parent: context.stage_from_prim,
            local,
            path: path.to_owned(),
            camera: None,
        });
        if is_mount {
            self.mount_node = Some(node);
        }
        Some(node)
    }

    /// Notes the camera of a node.
    pub(super) fn camera(&mut self, node: usize, camera: usize) {
        self.nodes[node].camera = Some(camera);
    }

    /// Whether a prim's own transform is animated. Notes other animated attributes.
    fn classify(&mut self, reader: &Reader, prim: &Record, path: &str) -> bool {
        let kind = prim.type_name.as_str();
        let mut is_moved = false;
        let names = prim.properties.iter().map(openusd::tf::Token::as_str);
        for name in names.filter(|_| !UNSEEN_TYPES.contains(&kind)) {
            let is_transform = name == "xformOpOrder" || name.starts_with("xformOp:");
            let is_seen = is_transform && !is_moved && is_transformed(kind)
                || !is_transform
                    && self.deforms.is_none()
                    && !UNSEEN_NAMESPACES.iter().any(|space| name.starts_with(space));
            if is_seen && reader.is_sampled(&prim.path, name) {
                match is_transform {
                    true => is_moved = true,
                    false => self.deform(&format!("{path}.{name}")),
                }
            }
        }
        is_moved
    }

    fn deform(&mut self, place: &str) {
        self.deforms.get_or_insert_with(|| place.to_owned());
    }

    /// The prim that was to carry a device and was not found, with the prims that could.
    pub(super) fn missing_mount(&self) -> Option<(&str, &[String])> {
        let mount = self.mount.as_deref().filter(|_| self.mount_node.is_none())?;
        Some((mount, &self.transformed))
    }

    /// Finishes the first pass, which made a scene.
    pub(super) fn finish(mut self, scene: &Scene) -> Moving {
        let meters_per_unit = scene.meters_per_unit.0;
        let is_copied = |node: &&Node| {
            let inside = |prototype: &String| {
                node.path
                    .strip_prefix(prototype.as_str())
                    .is_some_and(|rest| rest.is_empty() || rest.starts_with('/'))
            };
            matches!(node.local, Local::Animated(_)) && self.prototypes.iter().any(inside)
        };
        if let Some(node) = self.nodes.iter().find(is_copied) {
            let path = node.path.clone();
            self.deform(&path);
        }
        let mut by_path: HashMap<&str, Vec<usize>> = HashMap::new();
        for (index, instance) in scene.instances.iter().enumerate() {
            by_path.entry(&instance.path).or_default().push(index);
        }
        let instances: Vec<Vec<usize>> = self
            .nodes
            .iter()
            .map(|node| by_path.remove(node.path.as_str()).unwrap_or_default())
            .collect();
        Moving {
            nodes: self.nodes,
            instances,
            mount: self.mount_node,
            deforms: self.deforms,
            meters_per_unit,
        }
    }
}

/// The transforms of prims that move.
pub(super) struct Moving {
    nodes: Vec<Node>,
    /// The instances of each node.
    instances: Vec<Vec<usize>>,
    mount: Option<usize>,
    pub(super) deforms: Option<String>,
    meters_per_unit: f64,
}

/// What has moved at a time.
pub(super) struct Moved {
    pub(super) instances: Vec<(usize, DAffine3)>,
    pub(super) cameras: Vec<(usize, RigidTransform)>,
}

impl Moving {
    /// Whether nothing changes with time.
    pub(super) fn is_still(&self) -> bool {
        self.deforms.is_none()
            && !self
                .nodes
                .iter()
                .any(|node| matches!(node.local, Local::Animated(_)))
    }

    /// Returns the pose of the prim that carries a device, at the reader's time, and a finding about what its transform cannot pass on.
    /// There is no pose without such a prim, and if its transform is singular.
    pub(super) fn mount(&self, reader: &Reader) -> (Option<RigidTransform>, Option<Finding>) {
        let Some(mount) = self.mount.map(|index| &self.nodes[index]) else {
            return (None, None);
        };
        let placed = self.placed(mount, reader);
        let message = match placed {
            Some((_, None)) => None,
            Some((_, Some(removed))) => Some(format!(
                "its transform contains {removed}, which the mounted device ignores"
            )),
            None => Some("its transform is singular; the mounted device stays where it was".to_owned()),
        };
        let finding =
            message.map(|message| Finding::new("mount-transform", Level::Warning, &mount.path, message, ""));
        (placed.map(|(pose, _)| pose), finding)
    }

    fn placed<'a>(
        &'a self,
        mut node: &'a Node,
        reader: &Reader,
    ) -> Option<(RigidTransform, Option<&'static str>)> {
        let mut locals = Vec::new();
        loop {
            locals.push(node.local(reader));
            match node.parent {
                Some(parent) => node = &self.nodes[parent],
                None => break,
            }
        }
        let place = |parent, local: Option<LocalTransform>| local.map_or(parent, |local| local.below(parent));
        let stage_from_prim = locals.into_iter().rev().fold(node.stage_from_parent, place);
        rigid(&stage_from_prim, self.meters_per_unit)
    }

    /// Returns the transforms at the reader's time; `None` if a transform has no inverse, so that meshes have to be made for it.
    pub(super) fn at(&self, reader: &Reader) -> Option<Moved> {
        let mut stage_from_prim: Vec<DAffine3> = Vec::with_capacity(self.nodes.len());
        let mut moved = Moved {
            instances: Vec::new(),
            cameras: Vec::new(),
        };
        let world_from_stage = DAffine3::from_scale(DVec3::splat(self.meters_per_unit));
        for (index, node) in self.nodes.iter().enumerate() {
            let parent = node
                .parent
                .map_or(node.stage_from_parent, |parent| stage_from_prim[parent]);
            let opinions = node.local(reader).map_or(parent, |local| local.below(parent));
            stage_from_prim.push(opinions);
            for &instance in &self.instances[index] {
                let world_from_mesh = world_from_stage * opinions;
                if !is_invertible(&world_from_mesh) {
                    return None;
                }
                moved.instances.push((instance, world_from_mesh));
            }
            if let Some(camera) = node.camera {
                moved
                    .cameras
                    .push((camera, pose(&opinions, self.meters_per_unit)?.0));
            }
        }
        Some(moved)
    }
}
