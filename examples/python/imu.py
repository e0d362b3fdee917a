"""An OAK's inertial sensor along a walk: how fast dead reckoning drifts, and the noise that makes it drift.

    python examples/python/imu.py [-o imu/] [--model OAK-D-Pro-PoE] [--part BMI270] [--seconds 30]

A person carries the device around the corners of a room. Its accelerometer and gyroscope are simulated along the smooth motion
through the poses, and integrated from the true state of the start: position and heading drift away from the truth. Ten
minutes at rest show the noise as the Allan deviation, whose value at one second is the density of the white noise.
"""

import argparse
import csv
from pathlib import Path

import numpy as np

import oaktwin

RATE = 200
GRAVITY = np.array([0, 0, -9.80665])


def walk(times):
    """The body's poses (N, 4, 4) on an ellipse at walking speed, with the sway of steps; x forward, y left, z up."""
    angle = 0.35 * times
    step = 2 * np.pi * 1.8 * times
    place = np.stack([3 * np.cos(angle), 2 * np.sin(angle), 1.3 + 0.02 * np.sin(step)], axis=1)
    heading = np.arctan2(2 * np.cos(angle), -3 * np.sin(angle))
    roll = 0.03 * np.sin(step / 2)
    poses = np.tile(np.eye(4), (len(times), 1, 1))
    c, s, cr, sr, zero, one = np.cos(heading), np.sin(heading), np.cos(roll), np.sin(roll), 0 * roll, 0 * roll + 1
    yaw = np.array([[c, -s, zero], [s, c, zero], [zero, zero, one]])
    lean = np.array([[one, zero, zero], [zero, cr, -sr], [zero, sr, cr]])
    poses[:, :3, :3] = np.einsum("ijn,jkn->nik", yaw, lean)
    poses[:, :3, 3] = place
    return poses


def turn(vector):
    """The rotation by a rotation vector (Rodrigues' formula)."""
    angle = np.linalg.norm(vector)
    x, y, z = vector / max(angle, 1e-12)
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross


def dead_reckoning(samples, world_from_imu, velocity):
    """The poses of the sensor (M, 4, 4) from its samples, the first pose and the first velocity, by the midpoint rule."""
    rates, forces = samples["angular_velocity"], samples["linear_acceleration"]
    intervals = np.diff(samples["timestamp"]) * 1e-9
    poses = np.tile(world_from_imu, (len(rates), 1, 1))
    attitude, place = world_from_imu[:3, :3], world_from_imu[:3, 3]
    for index, dt in enumerate(intervals):
        turned = attitude @ turn((rates[index] + rates[index + 1]) / 2 * dt)
        acceleration = (attitude @ forces[index] + turned @ forces[index + 1]) / 2 + GRAVITY
        place = place + velocity * dt + acceleration * dt**2 / 2
        velocity, attitude = velocity + acceleration * dt, turned
        poses[index + 1, :3, :3], poses[index + 1, :3, 3] = attitude, place
    return poses


def drift(found, true):
    """The errors of position in metres and of orientation in degrees."""
    turned = np.einsum("nji,njk->nik", true[:, :3, :3], found[:, :3, :3])
    cosine = (np.trace(turned, axis1=1, axis2=2) - 1) / 2
    return np.linalg.norm((found - true)[:, :3, 3], axis=1), np.degrees(np.arccos(np.clip(cosine, -1, 1)))


def allan_deviation(values, rate, tau):
    """The Allan deviation (3,) of samples (M, 3) at an averaging time in seconds, from neighbouring intervals."""
    count = int(round(tau * rate))
    means = values[: len(values) // count * count].reshape(-1, count, 3).mean(axis=1)
    return np.sqrt((np.diff(means, axis=0) ** 2).mean(axis=0) / 2)


def write_euroc(path, samples):
    """Writes samples in the format of the EuRoC data sets."""
    with path.open("w", newline="", encoding="utf-8") as lines:
        writer = csv.writer(lines)
        names = [f"{name}_{axis} [{unit}]" for name, unit in [("w_RS_S", "rad s^-1"), ("a_RS_S", "m s^-2")] for axis in "xyz"]
        writer.writerow(["#timestamp [ns]", *names])
        vectors = np.hstack([samples["angular_velocity"], samples["linear_acceleration"]])
        writer.writerows([stamp, *map(repr, map(float, row))] for stamp, row in zip(samples["timestamp"], vectors))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("-o", "--output", type=Path, default=Path("imu"))
    parser.add_argument("--model", default="OAK-D-Pro-PoE")
    parser.add_argument("--part", help="the inertial part; by default the model's")
    parser.add_argument("--seconds", type=int, default=30, help="the length of the walk; default 30")
    args = parser.parse_args()
    args.output.mkdir(parents=True, exist_ok=True)
    device = oaktwin.Device(args.model)
    body_from_imu = device.extrinsics("imu", "body")

    # Poses at the times of the samples give the truth, too.
    times = np.arange(args.seconds * RATE + 1) / RATE
    poses = walk(times)
    samples = oaktwin.simulate_imu(device, times, poses, rate=RATE, part=args.part, seed=1)
    write_euroc(args.output / "data.csv", samples)
    true = poses @ body_from_imu
    velocity = (-3 * true[0, :3, 3] + 4 * true[1, :3, 3] - true[2, :3, 3]) * RATE / 2
    metres, degrees = drift(dead_reckoning(samples, true[0], velocity), true)
    print(f"{args.model}: a walk of {args.seconds} s at {RATE} Hz\n time   position  orientation")
    rows = [(second, metres[second * RATE], degrees[second * RATE]) for second in (1, 3, 10, 30) if second <= args.seconds]
    for second, off, turned in rows:
        print(f"{second:3} s  {off:7.3f} m    {turned:6.3f} deg")
    with (args.output / "drift.csv").open("w", newline="", encoding="utf-8") as lines:
        csv.writer(lines).writerows([("time_s", "position_m", "orientation_deg"), *rows])

    still = np.tile(np.eye(4), (2, 1, 1))
    rest = oaktwin.simulate_imu(device, [0, 600], still, rate=RATE, part=args.part, seed=2)
    for name, unit, scale in [("angular_velocity", "mdeg/s", np.degrees(1e3)), ("linear_acceleration", "mm/s^2", 1e3)]:
        at = {tau: allan_deviation(rest[name], RATE, tau) * scale for tau in (0.1, 1, 10)}
        print(f"Allan deviation of the {name.replace('_', ' ')}, {unit}: " + ", ".join(
            f"{tau} s {np.round(values, 3)}" for tau, values in at.items()
        ))


if __name__ == "__main__":
    main()
