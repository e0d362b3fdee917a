//! Robots of USD stages: the rigid bodies and joints of `UsdPhysics`.

use std::collections::{HashMap, HashSet, VecDeque};
use std::path::Path;
use std::sync::Arc;

use oaktwin_base::diagnostic::{Finding, Level};
use oaktwin_camera::RigidTransform;
use oaktwin_camera::math::{DAffine3, DMat3, DVec3};
use oaktwin_scene::{Scene, Up};
use oaktwin_usd::stage::{self, Physics, PhysicsJoint, SceneOptions};

use super::RobotFileError;
use super::document::XmlError;
use super::robot::{Joint, JointKind, Link, LinkVisual, Robot, Shape};
use super::turn;

/// Positions smaller than this, radians or metres, are 0: files store poses in single precision.
const NOISE: f64 = 1e-6;

/// How far the frames of a joint may be apart beyond its motion: metres, and entries of the rotation.
const APART: f64 = 1e-3;

pub(super) fn read(path: &Path) -> Result<Robot, RobotFileError> {
    let (stage, physics) = stage::open_physics(path, &SceneOptions::default())?;
    let moves = |joint: &PhysicsJoint| kind(joint).is_some();
    if !physics.joints.iter().any(moves) {
        return Err(RobotFileError::At(XmlError {
            file: path.to_owned(),
            place: "stage".to_owned(),
            message: "has no PhysicsRevoluteJoint or PhysicsPrismaticJoint that moves it".to_owned(),
            remedy: "give an animated stage as the scene, and mount the OAK on its prim: --mount /World/Robot/hand".to_owned(),
        }));
    }
    let stem = || {
        path.file_stem()
            .unwrap_or_default()
            .to_string_lossy()
            .into_owned()
    };
    let mut builder = Builder {
        robot: Robot {
            name: stage.metadata.default_prim.clone().unwrap_or_else(stem),
            findings: stage
                .findings
                .into_iter()
                .chain(physics.findings.clone())
                .collect(),
            ..Robot::default()
        },
        link_of_body: vec![None; physics.bodies.len()],
        names: HashSet::new(),
        physics: &physics,
    };
    builder.world(stage.scene.up);
    builder.tree();
    builder.shapes(&Arc::new(stage.scene));
    Ok(builder.robot)
}

/// How a joint moves; `None` of a fixed one and of types that are not supported.
fn kind(joint: &PhysicsJoint) -> Option<JointKind> {
    match joint.type_name.as_str() {
        "PhysicsRevoluteJoint" => Some(JointKind::Revolute),
        "PhysicsPrismaticJoint" => Some(JointKind::Prismatic),
        _ => None,
    }
}

struct Builder<'a> {
    robot: Robot,
    physics: &'a Physics,
    /// The link of each body, once it is placed.
    link_of_body: Vec<Option<usize>>,
    /// The names of links and joints.
    names: HashSet<String>,
}

impl Builder<'_> {
    /// Adds the stage itself, whose prims outside bodies stand still. The base of a robot has z up.
    fn world(&mut self, up: Up) {
        let base_from_stage = match up {
            Up::Z => DMat3::IDENTITY,
            Up::Y => DMat3::from_cols(DVec3::X, DVec3::Z, DVec3::NEG_Y),
        };
        self.names.insert("world".to_owned());
        self.robot.links.push(Link {
            name: "world".to_owned(),
            parent: None,
            parent_from_link: RigidTransform::new(base_from_stage, DVec3::ZERO),
            joints: Vec::new(),
            visuals: Vec::new(),
            is_world: true,
        });
    }

    /// Adds the bodies: those that joints hold to the world, then those that no joint moves, and what hangs on them.
    fn tree(&mut self) {
        let count = self.physics.bodies.len();
        let mut joints_of_body: Vec<Vec<usize>> = vec![Vec::new(); count];
        let mut of_world = Vec::new();
        let mut is_moved = vec![false; count];
        for (index, joint) in self.physics.joints.iter().enumerate() {
            let [first, second] = joint.ends.map(|end| end.body);
            if first == second {
                self.note(
                    joint,
                    Level::Warning,
                    "both of its ends are on the same body; it is ignored",
                );
                continue;
            }
            if joint.is_excluded {
                self.note(joint, Level::Note, "closes a loop, which is not kept closed");
                continue;
            }
            for end in [first, second] {
                match end {
                    Some(body) => joints_of_body[body].push(index),
                    None => of_world.push(index),
                }
            }
            if let (Some(_), Some(moved)) = (first, second) {
                is_moved[moved] = true;
            }
        }
        let mut used = vec![false; self.physics.joints.len()];
        let mut waiting: VecDeque<usize> = VecDeque::new();
        self.hang(None, &of_world, &mut used, &mut waiting);
        self.drain(&joints_of_body, &mut used, &mut waiting);
        for wanted in [false, true] {
            for (body, moved) in is_moved.iter().enumerate() {
                if self.link_of_body[body].is_none() && *moved == wanted {
                    let pose = self.physics.bodies[body].world_from_body;
                    self.place(body, 0, pose, None);
                    waiting.push_back(body);
                    self.drain(&joints_of_body, &mut used, &mut waiting);
                }
            }
        }
    }

    /// Hangs what joints hold on each waiting body, and so on.
    fn drain(&mut self, joints_of_body: &[Vec<usize>], used: &mut [bool], waiting: &mut VecDeque<usize>) {
        while let Some(body) = waiting.pop_front() {
            self.hang(Some(body), &joints_of_body[body], used, waiting);
        }
    }

    fn hang(
        &mut self,
        parent: Option<usize>,
        joints: &[usize],
        used: &mut [bool],
        waiting: &mut VecDeque<usize>,
    ) {
        for &index in joints {
            if std::mem::replace(&mut used[index], true) {
                continue;
            }
            let joint = &self.physics.joints[index];
            let is_reversed = joint.ends[0].body != parent;
            let [near, far] = match is_reversed {
                false => [joint.ends[0], joint.ends[1]],
                true => [joint.ends[1], joint.ends[0]],
            };
            let Some(body) = far.body else {
                continue;
            };
            if self.link_of_body[body].is_some() {
                self.note(joint, Level::Warning, "closes a loop, which is not kept closed");
                continue;
            }
            let parent_link = parent.and_then(|parent| self.link_of_body[parent]).unwrap_or(0);
            let world_from_parent = match parent {
                Some(parent) => self.physics.bodies[parent].world_from_body,
                None => RigidTransform::IDENTITY,
            };
            let parent_from_body = world_from_parent.inverse() * self.physics.bodies[body].world_from_body;
            // Where the stage has the far frame, seen from the near one.
            let near_from_far = near.body_from_joint.inverse() * parent_from_body * far.body_from_joint;
            let motion = kind(joint);
            let (position, rest) = match motion {
                Some(kind) => split(kind, joint.axis, &near_from_far),
                None => (0.0, near_from_far),
            };
            let is_fixed = joint.type_name == "PhysicsFixedJoint";
            if motion.is_none() && !is_fixed {
                let what = format!(
                    "{} is not supported; it stays as the stage has it",
                    joint.type_name
                );
                self.note(joint, Level::Warning, &what);
                self.place(body, parent_link, parent_from_body, None);
                waiting.push_back(body);
                continue;
            }
            let apart = rest.translation.length().max(entries(&rest.rotation));
            if apart > APART {
                let what = "its frames do not meet in the stage; its bodies are where the frames say";
                self.note(joint, Level::Note, what);
            }
            let moved = motion.map_or(RigidTransform::IDENTITY, |kind| moved(kind, joint.axis, position));
            let parent_from_link = near.body_from_joint * moved * far.body_from_joint.inverse();
            // A reversed joint moves the near body, seen from the far one.
            let sign = if is_reversed { -1.0 } else { 1.0 };
            let joint = motion.map(|kind| Joint {
                name: self.name(&joint.path),
                kind,
                axis: far.body_from_joint.rotation * joint.axis * sign,
                anchor: far.body_from_joint.translation,
                limits: self.limits(joint, kind),
                reference: position * sign,
                mimic: None,
            });
            self.place(body, parent_link, parent_from_link, joint);
            waiting.push_back(body);
        }
    }

    fn limits(&mut self, joint: &PhysicsJoint, kind: JointKind) -> Option<[f64; 2]> {
        if joint.has_mimic {
            self.note(
                joint,
                Level::Warning,
                "that it follows another joint is not supported; it moves on its own",
            );
        }
        let limits = match kind {
            JointKind::Revolute => joint.limits.map(f64::to_radians),
            JointKind::Prismatic => joint.limits,
        };
        match limits.map(f64::is_finite) {
            [true, true] if limits[0] <= limits[1] => Some(limits),
            [false, false] => None,
            [true, true] => {
                self.note(
                    joint,
                    Level::Warning,
                    "its lower limit is above its upper one; it may have any position",
                );
                None
            }
            _ => {
                self.note(
                    joint,
                    Level::Note,
                    "it has a limit on one side only, which is not kept",
                );
                None
            }
        }
    }

    fn place(&mut self, body: usize, parent: usize, parent_from_link: RigidTransform, joint: Option<Joint>) {
        let name = self.name(&self.physics.bodies[body].path);
        self.link_of_body[body] = Some(self.robot.links.len());
        let joints = joint.is_some().then_some(self.robot.joints.len());
        self.robot.joints.extend(joint);
        self.robot.links.push(Link {
            name,
            parent: Some(parent),
            parent_from_link,
            joints: joints.into_iter().collect(),
            visuals: Vec::new(),
            is_world: false,
        });
    }

    /// The name of a prim, or its path if another link or joint has that name.
    fn name(&mut self, path: &str) -> String {
        let short = path.rsplit('/').next().unwrap_or(path);
        let name = match self.names.contains(short) {
            true => path,
            false => short,
        };
        self.names.insert(name.to_owned());
        name.to_owned()
    }

    fn note(&mut self, joint: &PhysicsJoint, level: Level, what: &str) {
        let code = "usd-joint";
        self.robot
            .findings
            .push(Finding::new(code, level, &joint.path, what.to_owned(), ""));
    }

    /// Gives each instance of the stage to the nearest body around it.
    fn shapes(&mut self, scene: &Arc<Scene>) {
        let bodies: HashMap<&str, usize> = self
            .physics
            .bodies
            .iter()
            .enumerate()
            .map(|(index, body)| (body.path.as_str(), index))
            .collect();
        for (index, instance) in scene.instances.iter().enumerate() {
            let mut around = instance.path.as_str();
            let body = loop {
                if let Some(&body) = bodies.get(around) {
                    break Some(body);
                }
                match around.rsplit_once('/') {
                    Some((above, _)) => around = above,
                    None => break None,
                }
            };
            let below = instance.path.strip_prefix(around).unwrap_or(&instance.path);
            let world_from_link = body.map_or(RigidTransform::IDENTITY, |body| {
                self.physics.bodies[body].world_from_body
            });
            let link_from_world = world_from_link.inverse();
            let link_from_mesh =
                DAffine3::from_mat3_translation(link_from_world.rotation, link_from_world.translation)
                    * instance.world_from_mesh;
            let link = body.and_then(|body| self.link_of_body[body]).unwrap_or(0);
            let name = match below.trim_start_matches('/') {
                "" => "shape",
                below => below,
            };
            self.robot.links[link].visuals.push(LinkVisual {
                name: name.to_owned(),
                link_from_shape: RigidTransform::IDENTITY,
                shape: Shape::Instance {
                    scene: Arc::clone(scene),
                    instance: index,
                    link_from_mesh,
                },
                color: None,
                place: instance.path.clone(),
            });
        }
    }
}

/// Returns the motion of a joint.
fn moved(kind: JointKind, axis: DVec3, position: f64) -> RigidTransform {
    match kind {
        JointKind::Prismatic => RigidTransform::new(DMat3::IDENTITY, axis * position),
        JointKind::Revolute => RigidTransform::new(turn::about(axis, position), DVec3::ZERO),
    }
}

/// Divides a motion into the position of a joint, radians or metres, and what is left of it.
fn split(kind: JointKind, axis: DVec3, motion: &RigidTransform) -> (f64, RigidTransform) {
    let position = match kind {
        JointKind::Prismatic => motion.translation.dot(axis),
        JointKind::Revolute => {
            // The sine and the cosine of a rotation about an axis, whose matrix may have other parts, too.
            let m = motion.rotation;
            let twice_sine = DVec3::new(
                m.y_axis.z - m.z_axis.y,
                m.z_axis.x - m.x_axis.z,
                m.x_axis.y - m.y_axis.x,
            );
            let trace = m.x_axis.x + m.y_axis.y + m.z_axis.z;
            libm::atan2(twice_sine.dot(axis), trace - 1.0)
        }
    };
    let position = if position.abs() < NOISE { 0.0 } else { position };
    (position, moved(kind, axis, position).inverse() * *motion)
}

/// The largest entry of a rotation that differs from the identity's.
fn entries(rotation: &DMat3) -> f64 {
    let difference = *rotation - DMat3::IDENTITY;
    let columns = [difference.x_axis, difference.y_axis, difference.z_axis];
    columns
        .map(|column| column.abs().max_element())
        .into_iter()
        .fold(0.0, f64::max)
}
