//! Rigid bodies that fall until they lie still.

use oaktwin_camera::RigidTransform;
use oaktwin_camera::math::DVec3;
use parry3d_f64::shape::SharedShape;
use rapier3d_f64::dynamics::{FrictionModel, IntegrationParameters, RigidBodyBuilder, RigidBodyHandle};
use rapier3d_f64::geometry::ColliderBuilder;
use rapier3d_f64::pipeline::PhysicsWorld;

use crate::world::{pose_from_parry, pose_to_parry, to_parry};

/// Gravity, m/s².
const GRAVITY: f64 = 9.81;

/// The coefficient of friction between all surfaces (an estimate for smooth plastic). What rests with little friction also rests with
/// more.
const FRICTION: f64 = 0.4;

/// The density of all bodies, kg/m³: only ratios matter, and they are 1.
const DENSITY: f64 = 1000.0;

/// The rate at which rotation decays, 1/s: a substitute for rolling friction, without which round objects roll for long.
const ANGULAR_DAMPING: f64 = 1.0;

/// The number of steps in the time in which the smallest body falls by half its size.
const STEPS_PER_FALL: f64 = 12.0;

/// The maximum number of steps: 6.3 s for bodies of 0.1 m.
const MAX_STEPS: u32 = 800;

/// The number of steps after which it is tested whether the bodies lie still.
const WINDOW: u32 = 40;

/// The maximum motion of a body at rest within a window, relative to the smallest body.
const STILL: f64 = 0.01;

/// The number of steps after which motion is damped more and more: by then the bodies have fallen, and some still roll or creep.
const CALM: u32 = 200;

/// The rate at which motion decays from then on, 1/s, and its growth from one window to the next.
const CALM_DAMPING: f64 = 0.5;
const CALM_GROWTH: f64 = 1.6;

/// The maximum speed, in sizes of the smallest body per time in which it falls by half its size: in a step no body moves by more than
/// 4 % of its size, so that none passes through the wall of a cup.
const MAX_SPEED: f64 = 0.5;

/// A sleeping body moves by less than this share of its size per second.
const SLEEPING_SPEED: f64 = 0.02;

/// The motion relative to each other, in sizes of the smallest body, after which the contacts of two bodies are found again. With the
/// engine's 0.05, bodies that roll sink into each other.
const CONTACT_DISTANCE: f64 = 0.002;

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
    pub(crate) is_at_rest: bool,
}

/// Bodies in motion.
pub(crate) struct Simulation {
    world: PhysicsWorld,
    bodies: Vec<RigidBodyHandle>,
    /// Where the bodies were at the end of the last window.
    settled: Vec<Settled>,
    /// The size of the smallest body that may move, metres.
    size: f64,
}

impl Simulation {
    /// Puts bodies above a fixed surface, which they do not intersect.
    pub(crate) fn new(ground: SharedShape, up: DVec3, bodies: Vec<Body>) -> Self {
        let moving = bodies.iter().filter(|body| !body.is_fixed);
        let sizes = moving.map(|body| body.shape.compute_local_aabb().extents().length());
        let size = sizes.reduce(f64::min).unwrap_or(1.0);
        let mut world = PhysicsWorld::new();
        world.gravity = to_parry(up * -GRAVITY);
        world.integration_parameters = parameters(size);
        let gap_m = bodies.iter().map(|body| body.gap_m).fold(0.0, f64::max);
        let collider = |shape: SharedShape, gap_m: f64| {
            let collider = ColliderBuilder::new(shape).density(DENSITY).friction(FRICTION);
            collider.contact_skin(gap_m / 2.0)
        };
        world.insert(RigidBodyBuilder::fixed(), collider(ground, gap_m));
        let (mut handles, mut settled) = (Vec::new(), Vec::new());
        for body in bodies {
            let kind = match body.is_fixed {
                true => RigidBodyBuilder::fixed(),
                false => RigidBodyBuilder::dynamic().angular_damping(ANGULAR_DAMPING),
            };
            let placed = kind.pose(pose_to_parry(&body.world_from_body));
            let (handle, _) = world.insert(placed, collider(body.shape, body.gap_m));
            if let Some(inserted) = world.bodies.get_mut(handle) {
                inserted.activation_mut().normalized_linear_threshold = SLEEPING_SPEED;
            }
            handles.push(handle);
            settled.push(Settled {
                world_from_body: body.world_from_body,
                is_at_rest: body.is_fixed,
            });
        }
        Self {
            world,
            bodies: handles,
            settled,
            size,
        }
    }

    /// Moves the bodies until all lie still, or for the maximum time; returns whether they do.
    pub(crate) fn settle(&mut self) -> bool {
        for step in 1..=MAX_STEPS {
            self.world.step();
            if step % WINDOW != 0 {
                continue;
            }
            self.observe();
            if self.settled.iter().all(|body| body.is_at_rest) {
                return true;
            }
            if step >= CALM {
                self.calm();
            }
        }
        false
    }

    /// Returns where the bodies are, in their order.
    pub(crate) fn settled(&self) -> &[Settled] {
        &self.settled
    }

    /// Compares the poses with those at the end of the last window.
    fn observe(&mut self) {
        for (handle, settled) in self.bodies.iter().zip(&mut self.settled) {
            let Some(body) = self.world.bodies.get(*handle).filter(|body| body.is_dynamic()) else {
                continue;
            };
            let (before, now) = (settled.world_from_body, pose_from_parry(body.position()));
            let turned = now.rotation - before.rotation;
            let turned = [turned.x_axis, turned.y_axis, turned.z_axis].map(DVec3::length);
            let motion = (now.translation - before.translation).length()
                + self.size / 2.0 * turned.into_iter().fold(0.0, f64::max);
            // A pose that is not finite is not one.
            if motion.is_finite() {
                settled.world_from_body = now;
            }
            settled.is_at_rest = motion <= STILL * self.size;
        }
    }

    /// Damps the motion more than before.
    fn calm(&mut self) {
        for (_, body) in self.world.bodies.iter_mut() {
            let linear = body.linear_damping().max(CALM_DAMPING);
            body.set_linear_damping(linear * CALM_GROWTH);
            body.set_angular_damping(body.angular_damping() * CALM_GROWTH);
        }
    }
}

/// Returns the parameters of the engine for bodies of this size and larger ones.
fn parameters(size: f64) -> IntegrationParameters {
    let fall = libm::sqrt(size / GRAVITY);
    IntegrationParameters {
        dt: fall / STEPS_PER_FALL,
        length_unit: size,
        normalized_max_linear_velocity: MAX_SPEED / fall,
        normalized_contact_recycle_distance: CONTACT_DISTANCE,
        // The simplified model does not let round objects rest.
        friction_model: FrictionModel::Coulomb,
        ..IntegrationParameters::default()
    }
}

#[cfg(test)]
mod tests {
    use oaktwin_camera::math::DMat3;

    use super::*;
    use crate::random::{Random, rotation_around};

    fn cuboid(size: [f64; 3], position: DVec3, rotation: DMat3) -> Body {
        let [x, y, z] = size.map(|edge| edge / 2.0);
        Body {
            shape: SharedShape::cuboid(x, y, z),
            world_from_body: RigidTransform::new(rotation, position),
            is_fixed: false,
            gap_m: 2e-4,
        }
    }

    /// A heap of boxes above a floor, in a column.
    fn heap(count: u32) -> Vec<Body> {
        let mut numbers = Random::new(1).numbers("heap", 0);
        let one = |index| {
            let aside = [numbers.uniform(), numbers.uniform()].map(|number| 0.1 * (number - 0.5));
            let position = DVec3::new(aside[0], aside[1], 0.08 + 0.08 * f64::from(index));
            cuboid([0.06, 0.04, 0.02], position, numbers.rotation())
        };
        (0..count).map(one).collect()
    }

    fn floor() -> SharedShape {
        SharedShape::cuboid(1.0, 1.0, 0.001)
    }

    #[test]
    fn a_box_falls_onto_its_side() {
        let lying = cuboid([0.1, 0.1, 0.02], DVec3::Z * 0.3, rotation_around(DVec3::X, 0.2));
        let mut simulation = Simulation::new(floor(), DVec3::Z, vec![lying]);
        assert!(simulation.settle());
        let settled = simulation.settled()[0];
        assert!(settled.is_at_rest);
        let height = settled.world_from_body.translation.z - 0.001;
        // The gap is 0.2 mm.
        assert!((0.01..0.0104).contains(&height), "{height}");
        assert!((settled.world_from_body.rotation.z_axis - DVec3::Z).length() < 1e-2);
    }

    #[test]
    fn a_settled_heap_stays_where_it_is() {
        let mut simulation = Simulation::new(floor(), DVec3::Z, heap(20));
        assert!(simulation.settle());
        let settled = simulation.settled().to_vec();
        let again = heap(20).into_iter().zip(&settled).map(|(body, settled)| Body {
            world_from_body: settled.world_from_body,
            ..body
        });
        let mut again = Simulation::new(floor(), DVec3::Z, again.collect());
        for _ in 0..4 * WINDOW {
            again.world.step();
        }
        again.observe();
        let moved = again.settled().iter().zip(&settled).map(|(after, before)| {
            let moved = after.world_from_body.translation - before.world_from_body.translation;
            moved.length()
        });
        let most = moved.fold(0.0, f64::max);
        assert!(most < 1e-3, "{most}");
    }

    #[test]
    fn fixed_bodies_do_not_move_and_the_void_has_no_rest() {
        let fixed = Body {
            is_fixed: true,
            ..cuboid([0.2, 0.2, 0.02], DVec3::Z * 0.2, DMat3::IDENTITY)
        };
        let above = cuboid([0.05; 3], DVec3::Z * 0.3, DMat3::IDENTITY);
        let beside = cuboid([0.05; 3], DVec3::new(5.0, 0.0, 0.3), DMat3::IDENTITY);
        let mut simulation = Simulation::new(floor(), DVec3::Z, vec![fixed.clone(), above, beside]);
        assert!(!simulation.settle());
        let [table, on_it, falling] = simulation.settled() else {
            panic!("three bodies");
        };
        assert_eq!(
            table.world_from_body.translation,
            fixed.world_from_body.translation
        );
        assert!((on_it.world_from_body.translation.z - 0.235).abs() < 5e-4 && on_it.is_at_rest);
        assert!(falling.world_from_body.translation.z < -1.0 && !falling.is_at_rest);
    }

    #[test]
    fn heaps_have_the_same_bits_on_every_thread() {
        let settle = || {
            let mut simulation = Simulation::new(floor(), DVec3::Z, heap(10));
            simulation.settle();
            let poses = simulation.settled().iter();
            let numbers = poses.flat_map(|body| {
                let pose = body.world_from_body;
                let rotation = pose.rotation.to_cols_array();
                rotation.into_iter().chain(pose.translation.to_array())
            });
            numbers.map(f64::to_bits).collect::<Vec<_>>()
        };
        let alone = settle();
        let threads: Vec<_> = (0..4).map(|_| std::thread::spawn(settle)).collect();
        for thread in threads {
            assert_eq!(thread.join().unwrap(), alone);
        }
    }
}
