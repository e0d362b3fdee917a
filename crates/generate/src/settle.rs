//! Rigid bodies that fall until they lie still.

use oaktwin_camera::RigidTransform;
use oaktwin_camera::math::DVec3;
use parry3d_f64::shape::SharedShape;
use rapier3d_f64::dynamics::{RigidBodyBuilder, RigidBodyHandle};
use rapier3d_f64::geometry::ColliderBuilder;
use rapier3d_f64::pipeline::PhysicsWorld;

use crate::world::{pose_from_parry, pose_to_parry, to_parry};

/// Gravity, m/s².
const GRAVITY: f64 = 9.81;

/// The coefficient of friction between all surfaces: that of smooth plastic and of oiled steel (an estimate). What rests with little
/// friction also rests with more.
const FRICTION: f64 = 0.4;

/// The density of all bodies, kg/m³. Only ratios matter, which are 1.
const DENSITY: f64 = 1000.0;

/// The rate at which rotation decays, 1/s: a substitute for rolling friction, without which round objects roll for long.
const ANGULAR_DAMPING: f64 = 1.0;

/// The number of steps in the time that a body needs to fall by half its size.
const STEPS_PER_FALL: f64 = 12.0;

/// The maximum number of steps: 7.6 s for bodies of 0.1 m.
const MAX_STEPS: u32 = 900;

/// The maximum speed, in sizes of a body per time that it needs to fall by half its size.
const MAX_SPEED: f64 = 2.0;

/// A body at rest moves by less than this share of its size per second.
const REST_SPEED: f64 = 0.02;

/// A rigid body.
#[derive(Clone, Debug)]
pub(crate) struct Body {
    pub(crate) shape: SharedShape,
    pub(crate) world_from_body: RigidTransform,
    pub(crate) is_fixed: bool,
    /// The gap that it keeps from others, metres.
    pub(crate) gap_m: f64,
}

/// Where a body comes to lie.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Settled {
    pub(crate) world_from_body: RigidTransform,
    /// Whether it lies still.
    pub(crate) is_at_rest: bool,
}

/// Bodies in motion.
pub(crate) struct Simulation {
    world: PhysicsWorld,
    bodies: Vec<(RigidBodyHandle, Body)>,
}

impl Simulation {
    /// Puts bodies above a fixed surface, which they do not intersect.
    pub(crate) fn new(ground: SharedShape, up: DVec3, bodies: Vec<Body>) -> Self {
        let mut world = PhysicsWorld::new();
        world.gravity = to_parry(up * -GRAVITY);
        let moving = bodies.iter().filter(|body| !body.is_fixed);
        let sizes = moving.map(|body| body.shape.compute_local_aabb().extents().length());
        let size = sizes.reduce(f64::min).unwrap_or(1.0);
        let fall = libm::sqrt(size / GRAVITY);
        let parameters = &mut world.integration_parameters;
        parameters.dt = fall / STEPS_PER_FALL;
        parameters.length_unit = size;
        parameters.normalized_max_linear_velocity = MAX_SPEED / fall;
        let gap_m = bodies.iter().map(|body| body.gap_m).fold(0.0, f64::max);
        let ground = ColliderBuilder::new(ground).contact_skin(gap_m / 2.0);
        world.insert(RigidBodyBuilder::fixed(), ground.friction(FRICTION));
        let put = |body: Body| {
            let kind = match body.is_fixed {
                true => RigidBodyBuilder::fixed(),
                false => RigidBodyBuilder::dynamic().angular_damping(ANGULAR_DAMPING),
            };
            let collider = ColliderBuilder::new(body.shape.clone())
                .contact_skin(body.gap_m / 2.0)
                .density(DENSITY)
                .friction(FRICTION);
            let pose = pose_to_parry(&body.world_from_body);
            let (handle, _) = world.insert(kind.pose(pose), collider);
            if let Some(inserted) = world.bodies.get_mut(handle) {
                inserted.activation_mut().normalized_linear_threshold = REST_SPEED;
            }
            (handle, body)
        };
        let bodies = bodies.into_iter().map(put).collect();
        Self { world, bodies }
    }

    /// Moves the bodies until all lie still, or for the maximum time; returns the number of steps.
    pub(crate) fn settle(&mut self) -> u32 {
        for step in 0..MAX_STEPS {
            self.world.step();
            if self.world.active_bodies().next().is_none() {
                return step + 1;
            }
        }
        MAX_STEPS
    }

    /// Returns where the bodies are, in their order.
    pub(crate) fn poses(&self) -> Vec<Settled> {
        let bodies = self.bodies.iter();
        bodies
            .map(|(handle, start)| {
                let body = self.world.bodies.get(*handle).filter(|_| !start.is_fixed);
                let pose = body.map(|body| pose_from_parry(body.position()));
                let pose = pose.filter(|pose| pose.translation.is_finite());
                Settled {
                    world_from_body: pose.unwrap_or(start.world_from_body),
                    is_at_rest: start.is_fixed || (pose.is_some() && body.is_some_and(|body| body.is_sleeping())),
                }
            })
            .collect()
    }
}
