//! Motions with known derivatives, and integration back to the trajectory.
#![expect(clippy::unwrap_used, reason = "helpers of tests")]

use oaktwin_camera::RigidTransform;
use oaktwin_camera::math::{DMat3, DQuat, DVec3};
use oaktwin_imu::{ImuReading, Motion, MotionError};

const G: f64 = 9.806_65;
const GRAVITY: DVec3 = DVec3::new(0.0, 0.0, -G);

/// A mounting with a lever arm and turned axes.
fn mounted() -> RigidTransform {
    let rotation = DMat3::from_cols_array_2d(&[[0.0, 1.0, 0.0], [0.0, 0.0, -1.0], [-1.0, 0.0, 0.0]]);
    RigidTransform::new(rotation, DVec3::new(-0.02, -0.4, 0.07))
}

fn motion(rate_hz: u32, seconds: u32, pose: impl Fn(f64) -> RigidTransform) -> Motion {
    let poses: Vec<_> = (0..=rate_hz * seconds)
        .map(|i| f64::from(i) / f64::from(rate_hz))
        .map(|t| (t, pose(t)))
        .collect();
    Motion::new(&poses).unwrap()
}

fn assert_near(found: ImuReading, rate: DVec3, force: DVec3, tolerance: f64) {
    let (a, b) = (found.angular_velocity - rate, found.specific_force - force);
    assert!(a.length() < tolerance && b.length() < tolerance, "{a} {b}");
}

#[test]
fn at_rest_only_gravity_is_felt() {
    let tilted = RigidTransform::new(DMat3::from_rotation_y(0.3), DVec3::new(4.0, 5.0, 6.0));
    let rest = motion(10, 1, |_| tilted);
    for t in [0.0, 0.05, 0.77, 1.0] {
        let level = motion(10, 1, |_| RigidTransform::IDENTITY).at(t);
        let found = level.reading(&RigidTransform::IDENTITY, GRAVITY);
        assert_near(found, DVec3::ZERO, DVec3::new(0.0, 0.0, G), 1e-12);
        let found = rest.at(t).reading(&mounted(), GRAVITY);
        let up = mounted().rotation.transpose() * tilted.rotation.transpose() * DVec3::Z;
        assert_near(found, DVec3::ZERO, up * G, 1e-9);
    }
}

#[test]
fn free_fall_is_weightless() {
    let fall = motion(30, 1, |t| {
        RigidTransform::new(DMat3::from_rotation_x(0.2), 0.5 * GRAVITY * t * t + DVec3::X * t)
    });
    for t in [0.0, 0.5, 1.0] {
        assert_near(
            fall.at(t).reading(&mounted(), GRAVITY),
            DVec3::ZERO,
            DVec3::ZERO,
            1e-7,
        );
    }
}

/// A constant turn about any axis: constant angular velocity and the centripetal acceleration of the lever arm.
#[test]
fn constant_turns_are_exact() {
    let axis = DVec3::new(1.0, -2.0, 0.5).normalize();
    let speed = 2.5;
    let turn = motion(20, 2, |t| {
        RigidTransform::new(DMat3::from_axis_angle(axis, speed * t), DVec3::ZERO)
    });
    let imu_from_body = mounted().rotation.transpose();
    for t in [0.0, 0.013, 0.7, 1.99, 2.0] {
        let state = turn.at(t);
        let rate = axis * speed;
        let centripetal = rate.cross(rate.cross(mounted().translation));
        let up = state.world_from_body.rotation.transpose() * DVec3::Z;
        let expected = imu_from_body * (centripetal + up * G);
        assert_near(
            state.reading(&mounted(), GRAVITY),
            imu_from_body * rate,
            expected,
            1e-8,
        );
    }
}

/// A circle that the body drives forwards, facing along its path, as a car does.
#[test]
fn circles_have_their_centripetal_acceleration() {
    let (radius, speed) = (2.0, 1.5f64);
    let rate = speed / radius;
    let pose = |t: f64| {
        let (sine, cosine) = (rate * t).sin_cos();
        let heading = DMat3::from_rotation_z(rate * t + std::f64::consts::FRAC_PI_2);
        RigidTransform::new(heading, DVec3::new(radius * cosine, radius * sine, 0.0))
    };
    let imu = mounted();
    let imu_from_body = imu.rotation.transpose();
    // The error of a cubic spline's acceleration falls with the square of the interval.
    for (rate_hz, tolerance) in [(10, 3e-3), (100, 3e-5)] {
        let circle = motion(rate_hz, 8, pose);
        for t in [0.51, 3.333, 7.4] {
            let state = circle.at(t);
            // In the body's frame, the centre is to the left.
            let of_body = DVec3::new(0.0, speed * speed / radius, G);
            let omega = DVec3::new(0.0, 0.0, rate);
            let expected = imu_from_body * (of_body + omega.cross(omega.cross(imu.translation)));
            assert_near(
                state.reading(&imu, GRAVITY),
                imu_from_body * omega,
                expected,
                tolerance,
            );
            assert!((state.velocity.length() - speed).abs() < tolerance);
        }
    }
}

/// A motion with everything in it.
fn wild(t: f64) -> RigidTransform {
    let rotation = DQuat::from_euler(
        Default::default(),
        0.8 * (1.3 * t).sin(),
        0.5 * (0.9 * t).cos(),
        1.1 * t,
    );
    let position = DVec3::new(1.5 * (0.8 * t).cos(), (1.1 * t).sin(), 0.4 * (1.9 * t).sin());
    RigidTransform::new(DMat3::from_quat(rotation), position)
}

/// Integrates the readings of a sensor on a lever arm by the midpoint rule, and compares with its trajectory.
#[test]
fn readings_integrate_back_to_the_trajectory() {
    let motion = motion(30, 6, wild);
    let imu = mounted();
    let world_from_imu = |t: f64| motion.at(t).world_from_body * imu;
    let start = motion.at(0.0);
    let lever = start.world_from_body.rotation * start.angular_velocity.cross(imu.translation);
    let (mut position, mut velocity) = (world_from_imu(0.0).translation, start.velocity + lever);
    let mut orientation = DQuat::from_mat3(&world_from_imu(0.0).rotation);
    let rate_hz = 4000.0;
    let step = 1.0 / rate_hz;
    for k in 0..24_000 {
        let middle = motion.at((f64::from(k) + 0.5) * step).reading(&imu, GRAVITY);
        let halfway = orientation * DQuat::from_scaled_axis(middle.angular_velocity * (0.5 * step));
        let acceleration = halfway * middle.specific_force + GRAVITY;
        position += velocity * step + 0.5 * acceleration * step * step;
        velocity += acceleration * step;
        orientation = (orientation * DQuat::from_scaled_axis(middle.angular_velocity * step)).normalize();
    }
    let end = world_from_imu(6.0);
    assert!(
        (position - end.translation).length() < 1e-4,
        "{position} {}",
        end.translation
    );
    let off = orientation.angle_between(DQuat::from_mat3(&end.rotation));
    assert!(off < 1e-5, "{off}");
}

/// The interpolation approaches the motion that the poses were taken from.
#[test]
fn interpolation_converges() {
    let reference = motion(1000, 6, wild);
    let error = |rate_hz: u32| {
        let coarse = motion(rate_hz, 6, wild);
        let times = (1u32..60).map(|i| f64::from(i) * 0.1 + 0.003);
        let read = |motion: &Motion, t: f64| motion.at(t).reading(&mounted(), GRAVITY);
        times
            .map(|t| {
                let (a, b) = (read(&coarse, t), read(&reference, t));
                (a.angular_velocity - b.angular_velocity)
                    .length()
                    .max((a.specific_force - b.specific_force).length())
            })
            .fold(0.0, f64::max)
    };
    let errors = [error(10), error(20), error(40)];
    assert!(errors[0] < 0.05, "{errors:?}");
    assert!(
        errors[1] < errors[0] / 3.0 && errors[2] < errors[1] / 3.0,
        "{errors:?}"
    );
}

#[test]
fn two_poses_have_constant_velocities() {
    let end = RigidTransform::new(DMat3::from_rotation_x(1.2), DVec3::new(0.0, 3.0, 0.0));
    let motion = Motion::new(&[(1.0, RigidTransform::IDENTITY), (3.0, end)]).unwrap();
    assert_eq!((motion.start_s(), motion.duration_s()), (1.0, 2.0));
    for t in [0.0, 0.4, 2.0] {
        let state = motion.at(t);
        assert!((state.velocity - DVec3::new(0.0, 1.5, 0.0)).length() < 1e-12);
        assert!((state.angular_velocity - DVec3::new(0.6, 0.0, 0.0)).length() < 1e-12);
        assert!(state.acceleration.length() < 1e-12 && state.angular_acceleration.length() < 1e-12);
    }
    assert_eq!(motion.large_turn(), None);
    let far = RigidTransform::new(DMat3::from_rotation_x(1.8), DVec3::ZERO);
    let motion = Motion::new(&[(1.0, RigidTransform::IDENTITY), (3.0, far)]).unwrap();
    let (index, turn) = motion.large_turn().unwrap();
    assert!(index == 0 && (turn - 1.8).abs() < 1e-12);
}

#[test]
fn invalid_poses_are_rejected() {
    let at = |time: f64| (time, RigidTransform::IDENTITY);
    let error = |poses: &[(f64, RigidTransform)]| Motion::new(poses).unwrap_err();
    assert_eq!(error(&[]), MotionError::TooFew { poses: 0 });
    assert_eq!(error(&[at(0.0)]), MotionError::TooFew { poses: 1 });
    let nowhere = RigidTransform::new(DMat3::IDENTITY, DVec3::splat(f64::NAN));
    assert_eq!(
        error(&[at(0.0), (1.0, nowhere)]),
        MotionError::NotFinite { index: 1 }
    );
    assert_eq!(
        error(&[at(f64::INFINITY), at(1.0)]),
        MotionError::NotFinite { index: 0 }
    );
    for times in [[0.0, 1.0, 1.0], [0.0, 2.0, 1.0]] {
        let found = error(&times.map(at));
        let message = found.to_string();
        assert!(
            message.starts_with("pose 2: the time 1 s is not after"),
            "{message}"
        );
    }
}
