//! The rigid bodies and joints of `UsdPhysics`.

use std::collections::{BTreeSet, HashMap};

use oaktwin_base::diagnostic::{Finding, Level};
use oaktwin_camera::RigidTransform;
use oaktwin_camera::math::{DAffine3, DMat3, DQuat, DVec3};

use super::plain::{api_schemas, plain_targets};
use super::reader::{Reader, Record};
use super::scene::{Context, rigid};
use super::value::{boolean, number, quaternion, text, vec3};

/// The bodies and joints of a stage, in traversal order.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Physics {
    /// The enabled rigid bodies.
    pub bodies: Vec<PhysicsBody>,
    /// The enabled joints of all types.
    pub joints: Vec<PhysicsJoint>,
    /// What is wrong with them.
    pub findings: Vec<Finding>,
}

/// A prim with `PhysicsRigidBodyAPI`.
#[derive(Clone, Debug, PartialEq)]
pub struct PhysicsBody {
    /// Its path.
    pub path: String,
    /// Its pose in the stage's axes, metres, without the scale of the prim.
    pub world_from_body: RigidTransform,
}

/// A joint.
#[derive(Clone, Debug, PartialEq)]
pub struct PhysicsJoint {
    /// Its path.
    pub path: String,
    /// Its type: `PhysicsRevoluteJoint`.
    pub type_name: String,
    /// Its frames in the two bodies.
    pub ends: [JointEnd; 2],
    /// The axis, a unit vector in the joint's frame.
    pub axis: DVec3,
    /// The limits: degrees, or metres of a prismatic joint; infinite where there is none.
    pub limits: [f64; 2],
    /// Whether the joint closes a loop of a robot: `physics:excludeFromArticulation`.
    pub is_excluded: bool,
    /// Whether it follows another joint, by a schema of a vendor.
    pub has_mimic: bool,
}

/// One end of a joint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JointEnd {
    /// The index of the body; `None` of the world.
    pub body: Option<usize>,
    /// The joint's frame in the body's frame, or in the world, metres.
    pub body_from_joint: RigidTransform,
}

/// Collects bodies and joints during the traversal of a stage.
pub(super) struct PhysicsReader {
    meters_per_unit: f64,
    physics: Physics,
    /// The transforms of prims to the stage, in stage units. Never iterated.
    stage_from_prims: HashMap<String, DAffine3>,
    joints: Vec<Authored>,
}

/// A joint as its prim says.
struct Authored {
    path: String,
    type_name: String,
    ends: [AuthoredEnd; 2],
    axis: DVec3,
    limits: [f64; 2],
    is_excluded: bool,
    has_mimic: bool,
}

struct AuthoredEnd {
    target: Option<String>,
    position: DVec3,
    rotation: DMat3,
}

impl PhysicsReader {
    pub(super) fn new(meters_per_unit: f64) -> Self {
        Self {
            meters_per_unit,
            physics: Physics::default(),
            stage_from_prims: HashMap::new(),
            joints: Vec::new(),
        }
    }

    /// Visits a prim, whose scene path is `path`.
    pub(super) fn visit(&mut self, reader: &Reader, prim: &Record, path: &str, context: &Context) {
        let type_name = prim.type_name.as_str();
        if type_name.starts_with("Physics") && type_name.ends_with("Joint") {
            self.joint(reader, prim, path);
            return;
        }
        if type_name.is_empty() && !prim.has("xformOpOrder") {
            return;
        }
        self.stage_from_prims
            .insert(path.to_owned(), context.stage_from_prim);
        let schemas = api_schemas(&reader.stage.prim(prim.path.clone()));
        let is_body = schemas.iter().any(|schema| schema == "PhysicsRigidBodyAPI");
        let enabled = reader.value(prim, "physics:rigidBodyEnabled");
        if !is_body || enabled.and_then(|value| boolean(&value)) == Some(false) {
            return;
        }
        let world_from_body = self.world(path, &context.stage_from_prim);
        self.physics.bodies.push(PhysicsBody {
            path: path.to_owned(),
            world_from_body,
        });
    }

    /// Returns the pose of a prim in metres.
    fn world(&mut self, path: &str, stage_from_prim: &DAffine3) -> RigidTransform {
        match rigid(stage_from_prim, self.meters_per_unit) {
            Some((pose, None | Some("a scale"))) => pose,
            Some((pose, Some(removed))) => {
                let what = format!("its transform contains {removed}, which is ignored");
                self.warn(
                    "body-transform",
                    path,
                    what,
                    "use only translations, rotations and scales",
                );
                pose
            }
            None => {
                let what = "its transform is singular; it is placed at the origin".to_owned();
                self.warn("body-transform", path, what, "give it a scale other than 0");
                RigidTransform::IDENTITY
            }
        }
    }

    fn warn(&mut self, code: &'static str, path: &str, what: String, remedy: &str) {
        let finding = Finding::new(code, Level::Warning, path, what, remedy);
        self.physics.findings.push(finding);
    }

    fn joint(&mut self, reader: &Reader, prim: &Record, path: &str) {
        let flag = |name: &str| reader.value(prim, name).and_then(|value| boolean(&value));
        if flag("physics:jointEnabled") == Some(false) {
            return;
        }
        let limit = |name: &str, fallback: f64| {
            let value = reader.value(prim, name).and_then(|value| number(&value));
            value.filter(|value| !value.is_nan()).unwrap_or(fallback)
        };
        let axis = reader.value(prim, "physics:axis").and_then(text);
        let axis = match axis.as_deref() {
            None | Some("X") => DVec3::X,
            Some("Y") => DVec3::Y,
            Some("Z") => DVec3::Z,
            Some(other) => {
                let what = format!("its axis is '{other}'; X is used");
                self.warn("joint-axis", path, what, "write X, Y or Z");
                DVec3::X
            }
        };
        let mut bad = Vec::new();
        let ends = ["0", "1"].map(|end| {
            let rotation = reader.value(prim, &format!("physics:localRot{end}"));
            let rotation = rotation.and_then(|value| quaternion(&value));
            let rotation = rotation.unwrap_or(DQuat::IDENTITY);
            let is_sound = rotation.is_finite() && rotation.length() > 1e-6;
            let position = reader.value(prim, &format!("physics:localPos{end}"));
            let position = position.and_then(|value| vec3(&value)).unwrap_or(DVec3::ZERO);
            if !(is_sound && position.is_finite()) {
                bad.push(end);
            }
            let rotation = if is_sound {
                rotation.normalize()
            } else {
                DQuat::IDENTITY
            };
            let mut targets = plain_targets(reader, prim, path, &format!("physics:body{end}"));
            AuthoredEnd {
                target: (!targets.is_empty()).then(|| targets.swap_remove(0).path),
                position: if position.is_finite() {
                    position
                } else {
                    DVec3::ZERO
                },
                rotation: DMat3::from_quat(rotation),
            }
        });
        for end in bad {
            let what = format!(
                "localPos{end} and localRot{end} are no pose; the part that is not is replaced by none"
            );
            self.warn(
                "joint-frame",
                path,
                what,
                "write finite numbers, and a quaternion other than 0",
            );
        }
        self.joints.push(Authored {
            path: path.to_owned(),
            type_name: prim.type_name.as_str().to_owned(),
            ends,
            axis,
            limits: [
                limit("physics:lowerLimit", f64::NEG_INFINITY),
                limit("physics:upperLimit", f64::INFINITY),
            ],
            is_excluded: flag("physics:excludeFromArticulation") == Some(true),
            has_mimic: prim
                .properties
                .iter()
                .any(|name| name.as_str().to_ascii_lowercase().contains("mimic")),
        });
    }

    /// Returns what was read.
    pub(super) fn finish(mut self) -> Physics {
        let bodies: HashMap<String, usize> = self
            .physics
            .bodies
            .iter()
            .enumerate()
            .map(|(index, body)| (body.path.clone(), index))
            .collect();
        let mut missing = BTreeSet::new();
        for joint in std::mem::take(&mut self.joints) {
            let is_prismatic = joint.type_name == "PhysicsPrismaticJoint";
            let ends = joint.ends.map(|end| self.end(&end, &bodies, &mut missing));
            self.physics.joints.push(PhysicsJoint {
                path: joint.path,
                type_name: joint.type_name,
                ends,
                axis: joint.axis,
                limits: joint.limits.map(|limit| {
                    if is_prismatic {
                        limit * self.meters_per_unit
                    } else {
                        limit
                    }
                }),
                is_excluded: joint.is_excluded,
                has_mimic: joint.has_mimic,
            });
        }
        for path in missing {
            let what =
                "a joint names it as a body, but there is no such prim with a transform; the world is used";
            self.warn(
                "joint-body",
                &path,
                what.to_owned(),
                "name a prim with PhysicsRigidBodyAPI",
            );
        }
        self.physics
    }

    /// Returns the frame of a joint in the nearest body around its target. The scale of the target applies to the position, as OpenUSD's own reader of
    /// physics has it (`pxr/usd/usdPhysics/parseUtils.cpp`).
    fn end(
        &mut self,
        end: &AuthoredEnd,
        bodies: &HashMap<String, usize>,
        missing: &mut BTreeSet<String>,
    ) -> JointEnd {
        let scaled = |position: DVec3| position * self.meters_per_unit;
        let in_world = |position: DVec3| JointEnd {
            body: None,
            body_from_joint: RigidTransform::new(end.rotation, position),
        };
        let Some(target) = &end.target else {
            return in_world(scaled(end.position));
        };
        let Some(stage_from_target) = self.stage_from_prims.get(target).copied() else {
            missing.insert(target.clone());
            return in_world(scaled(end.position));
        };
        let position = scaled(stage_from_target.transform_point3(end.position));
        let world_from_target = self.world(target, &stage_from_target);
        let world_from_joint = RigidTransform::new(world_from_target.rotation * end.rotation, position);
        let mut around = Some(target.as_str());
        while let Some(path) = around {
            if let Some(&body) = bodies.get(path) {
                let body_from_world = self.physics.bodies[body].world_from_body.inverse();
                return JointEnd {
                    body: Some(body),
                    body_from_joint: body_from_world * world_from_joint,
                };
            }
            around = path.rsplit_once('/').map(|(above, _)| above);
        }
        JointEnd {
            body: None,
            body_from_joint: world_from_joint,
        }
    }
}
