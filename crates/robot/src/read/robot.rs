//! What all formats of robots share.

use std::path::PathBuf;
use std::sync::Arc;

use oaktwin_base::diagnostic::Finding;
use oaktwin_camera::RigidTransform;
use oaktwin_camera::math::{DAffine3, DVec3};
use oaktwin_scene::Scene;

/// A robot: links that joints move. Lengths are in metres, angles in radians.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Robot {
    /// The name of the file's model.
    pub name: String,
    /// The links; a link comes after its parent. The first one is the base.
    pub links: Vec<Link>,
    /// The joints that move, in the order of the file.
    pub joints: Vec<Joint>,
    /// What the file contains that is not supported.
    pub findings: Vec<Finding>,
}

/// A rigid part of a robot.
#[derive(Clone, Debug, PartialEq)]
pub struct Link {
    /// The name.
    pub name: String,
    /// The index of the link that carries it; `None` of a base.
    pub parent: Option<usize>,
    /// The pose in the parent's frame, before the joints move it.
    pub parent_from_link: RigidTransform,
    /// The indices of the joints that move it relative to its parent, in the order in which they are applied.
    pub joints: Vec<usize>,
    /// What is visible of it.
    pub visuals: Vec<LinkVisual>,
    /// Whether it is the surroundings and not a part of the robot: the world body of an MJCF file.
    pub is_world: bool,
}

/// A joint that moves a link relative to its parent.
#[derive(Clone, Debug, PartialEq)]
pub struct Joint {
    /// The name.
    pub name: String,
    /// How it moves.
    pub kind: JointKind,
    /// The unit vector about which it turns, or along which it slides, in the link's frame.
    pub axis: DVec3,
    /// A point on the axis, in the link's frame.
    pub anchor: DVec3,
    /// The smallest and the largest position, radians or metres; `None` of a joint without limits.
    pub limits: Option<[f64; 2]>,
    /// The position at which the link is where the file says.
    pub reference: f64,
    /// The joint whose position determines this one's.
    pub mimic: Option<Mimic>,
}

/// The motion of a joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum JointKind {
    /// A rotation about the axis, radians.
    Revolute,
    /// A translation along the axis, metres.
    Prismatic,
}

/// A joint follows another one: `position = multiplier · other + offset`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mimic {
    /// The index of the other joint.
    pub joint: usize,
    /// The factor.
    pub multiplier: f64,
    /// The summand.
    pub offset: f64,
}

/// A visible shape of a link.
#[derive(Clone, Debug, PartialEq)]
pub struct LinkVisual {
    /// A name that is unique in its link.
    pub name: String,
    /// The pose of the shape in the link's frame.
    pub link_from_shape: RigidTransform,
    /// The shape.
    pub shape: Shape,
    /// Its colour, sRGB, where the mesh has no material of its own.
    pub color: Option<[f32; 3]>,
    /// The place of the shape in its file, for findings.
    pub place: String,
}

/// A shape about its own origin; those with an axis lie along z.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// A box with edges of these lengths.
    Box(DVec3),
    /// An ellipsoid with these half axes.
    Ellipsoid(DVec3),
    /// A cylinder.
    Cylinder {
        /// The radius.
        radius: f64,
        /// The length.
        length: f64,
    },
    /// A cylinder with a hemisphere beyond each end.
    Capsule {
        /// The radius.
        radius: f64,
        /// The length of the cylinder.
        length: f64,
    },
    /// A rectangle, perpendicular to z.
    Rectangle {
        /// The length along x.
        width: f64,
        /// The length along y.
        length: f64,
    },
    /// An instance of a stage.
    Instance {
        /// What the stage contains, in metres.
        scene: Arc<Scene>,
        /// The index of the instance.
        instance: usize,
        /// The transform of its mesh to the link.
        link_from_mesh: DAffine3,
    },
    /// A mesh file.
    Mesh {
        /// The file.
        file: PathBuf,
        /// The scale and the offset of its vertices.
        shape_from_file: DAffine3,
    },
}

impl Robot {
    /// Returns the index of a link.
    #[must_use]
    pub fn link(&self, name: &str) -> Option<usize> {
        self.links.iter().position(|link| link.name == name)
    }

    /// Returns the indices of the joints whose positions are free: they follow no other joint.
    pub fn free_joints(&self) -> impl Iterator<Item = usize> {
        (0..self.joints.len()).filter(|&index| self.joints[index].mimic.is_none())
    }

    /// Returns the position of each joint in which the robot is shown by default: the reference, or the middle of the limits if the reference is
    /// outside, as ROS's `joint_state_publisher` does.
    #[must_use]
    pub fn rest(&self) -> Vec<f64> {
        let free = self.joints.iter().map(|joint| match joint.limits {
            Some([low, high]) if !(low..=high).contains(&joint.reference) => 0.5 * (low + high),
            _ => joint.reference,
        });
        self.followed(free.collect())
    }

    /// Returns positions of all joints, with those that follow another one set.
    #[must_use]
    pub fn followed(&self, mut positions: Vec<f64>) -> Vec<f64> {
        // A joint may follow one that follows another one; circles are rejected when the file is read.
        for index in 0..self.joints.len() {
            positions[index] = self.position(index, &positions);
        }
        positions
    }

    fn position(&self, index: usize, positions: &[f64]) -> f64 {
        match self.joints[index].mimic {
            Some(mimic) => mimic.multiplier * self.position(mimic.joint, positions) + mimic.offset,
            None => positions[index],
        }
    }

    /// Returns the pose of each link in the frame of the base, for a position of each joint.
    #[must_use]
    pub fn base_from_links(&self, positions: &[f64]) -> Vec<RigidTransform> {
        let mut poses: Vec<RigidTransform> = Vec::with_capacity(self.links.len());
        for link in &self.links {
            let moved = link.joints.iter().fold(link.parent_from_link, |pose, &joint| {
                pose * self.joints[joint].motion(positions[joint])
            });
            poses.push(match link.parent {
                Some(parent) => poses[parent] * moved,
                None => moved,
            });
        }
        poses
    }
}

impl Joint {
    /// The unit of its positions.
    #[must_use]
    pub const fn unit(&self) -> &'static str {
        match self.kind {
            JointKind::Revolute => "rad",
            JointKind::Prismatic => "m",
        }
    }

    /// Returns the motion of the link from where the file says, in the link's frame.
    fn motion(&self, position: f64) -> RigidTransform {
        let by = position - self.reference;
        match self.kind {
            JointKind::Prismatic => RigidTransform::new(RigidTransform::IDENTITY.rotation, self.axis * by),
            JointKind::Revolute => {
                let rotation = super::turn::about(self.axis, by);
                RigidTransform::new(rotation, self.anchor - rotation * self.anchor)
            }
        }
    }
}
