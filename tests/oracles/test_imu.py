"""The samples of `oaktwin render --imu` beside SciPy's splines, integration, allantools and the messages as rosbags reads them."""

import subprocess
import tomllib
from pathlib import Path

import allantools
import numpy as np
import pytest
from rosbags.rosbag2 import Reader
from rosbags.typesys import Stores, get_typestore
from scipy.interpolate import CubicSpline
from scipy.spatial.transform import Rotation, RotationSpline

ROOT = Path(__file__).resolve().parents[2]
CATALOG = ROOT / "crates/catalog/data"
DEVICE = tomllib.loads((CATALOG / "devices/oak_d_pro_poe.toml").read_text())["imu"]
PART = tomllib.loads((CATALOG / "imus/bno086.toml").read_text())
GRAVITY = np.array([0, 0, -9.80665])
# From the catalog's units: micro-g and millidegrees.
UG, MDPS = 9.80665e-6, np.radians(1e-3)


def densities(sensor: str, key: str) -> np.ndarray:
    unit = {"accelerometer": ("ug", UG), "gyroscope": ("mdps", MDPS)}[sensor]
    return np.array(PART[sensor][f"{key}_{unit[0]}"]) * unit[1]


def simulate(program: Path, folder: Path, times: np.ndarray, positions: np.ndarray, rotations: Rotation, *more: str) -> np.ndarray:
    """Nanoseconds, angular velocity and specific force."""
    (folder / "floor.obj").write_text("v -9 -9 0\nv 9 -9 0\nv 0 9 0\nf 1 2 3\n")
    poses = np.column_stack([times, positions, rotations.as_quat()])
    np.savetxt(folder / "poses.tum", poses, fmt="%.9f")
    command = [program, "render", "floor.obj", "--up", "z", "--model", "OAK-D-Pro-PoE", "--trajectory", "poses.tum"]
    command += ["--resolution", "16x10", "--annotators", "distance_to_image_plane", "--imu", "imu.csv", *more]
    subprocess.run(command, check=True, cwd=folder, capture_output=True)
    return np.loadtxt(folder / "imu.csv", delimiter=",", skiprows=1)


@pytest.fixture(scope="module")
def walk(program: Path, tmp_path_factory: pytest.TempPathFactory) -> tuple[np.ndarray, ...]:
    """A walk of 10 s with all kinds of turns, recorded as well."""
    folder = tmp_path_factory.mktemp("walk")
    times = np.arange(0, 10.0001, 1 / 30)
    positions = np.stack([np.sin(times), 0.6 * np.cos(1.3 * times), 1.2 + 0.2 * np.sin(2.1 * times)], axis=1)
    angles = np.stack([1.1 * times, 0.4 * np.sin(1.7 * times), 0.3 * np.cos(0.9 * times)], axis=1)
    rotations = Rotation.from_euler("ZYX", angles)
    samples = simulate(program, folder, times, positions, rotations, "--imu-rate", "200", "--record", "walk.mcap")
    # As written, so that the spline goes through the same poses.
    poses = np.loadtxt(folder / "poses.tum")
    return folder, poses[:, 0], poses[:, 1:4], Rotation.from_quat(poses[:, 4:]), samples


def test_samples_are_those_of_scipys_splines(walk: tuple[np.ndarray, ...]) -> None:
    _, times, positions, rotations, samples = walk
    at = samples[:, 0] * 1e-9
    # SciPy's spline of rotations has other conditions at its ends, which fade within a second.
    inside = (at > 1) & (at < 9)
    at, samples = at[inside], samples[inside]
    place, turn = CubicSpline(times, positions, bc_type="not-a-knot"), RotationSpline(times, rotations)
    body_from_imu, lever = np.array(DEVICE["rotation"]), np.array(DEVICE["position_mm"]) * 1e-3
    rates, angular = turn(at, 1), turn(at, 2)
    world_from_body = turn(at)
    in_body = world_from_body.inv().apply(place(at, 2) - GRAVITY)
    in_body += np.cross(angular, lever) + np.cross(rates, np.cross(rates, lever))
    rate = 200.0
    for columns, expected, sensor in [(slice(1, 4), rates, "gyroscope"), (slice(4, 7), in_body, "accelerometer")]:
        difference = samples[:, columns] - expected @ body_from_imu
        step = PART[sensor]["step_ug"] * UG if sensor == "accelerometer" else PART[sensor]["step_mdps"] * MDPS
        deviation = np.sqrt(densities(sensor, "noise_density") ** 2 * rate + step**2 / 12)
        # The bias walks little in 10 s; twice its deviation at the end.
        walked = 2 * densities(sensor, "random_walk") * np.sqrt(10)
        assert (np.abs(difference) < 5.5 * deviation + 2 * walked).all(), sensor
        assert (np.abs(difference.mean(axis=0)) < 4 * deviation / np.sqrt(len(at)) + walked).all(), sensor
        assert difference.std(axis=0) == pytest.approx(deviation, rel=0.08)
        # The motion is far above the noise.
        assert (np.ptp(expected, axis=0) > 20 * deviation).all()


def test_integration_leads_back_to_the_poses(walk: tuple[np.ndarray, ...]) -> None:
    """Dead reckoning from the first pose and velocity, by the midpoint rule."""
    _, times, positions, rotations, samples = walk
    body_from_imu = Rotation.from_matrix(DEVICE["rotation"])
    lever = np.array(DEVICE["position_mm"]) * 1e-3
    spline = CubicSpline(times, positions, bc_type="not-a-knot")
    attitude = rotations[0] * body_from_imu
    step = 1 / 200
    place = positions[0] + rotations[0].apply(lever)
    # The velocity of the sensor at the start, from a hundredth of a second later.
    first = RotationSpline(times, rotations)(0.01)
    velocity = (spline(0.01) + first.apply(lever) - place) / 0.01 - 0.005 * spline(0, 2)
    for before, after in zip(samples[:-1], samples[1:]):
        turned = attitude * Rotation.from_rotvec(0.5 * (before[1:4] + after[1:4]) * step)
        force = 0.5 * (attitude.apply(before[4:7]) + turned.apply(after[4:7])) + GRAVITY
        place = place + velocity * step + 0.5 * force * step**2
        velocity, attitude = velocity + force * step, turned
    expected = rotations[-1] * body_from_imu
    assert (expected.inv() * attitude).magnitude() < np.radians(0.2)
    # The noise of the gyroscope tilts gravity: g·σ·√(t⁵/20) for σ = 8 mdps/√Hz and t = 10 s are 10 cm along each horizontal axis, 14 cm
    # together. All else is small beside it: white noise of 1.2 mm/s²/√Hz causes 2 cm, the velocity at the start as much again.
    assert np.linalg.norm(place - positions[-1] - rotations[-1].apply(lever)) < 3 * 0.14


def deviation(values: np.ndarray, rate: float, taus: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    taus, found, _, _ = allantools.oadev(values, rate=rate, data_type="freq", taus=taus)
    return taus, found


def rest(program: Path, folder: Path, seconds: float, rate: float) -> np.ndarray:
    still = Rotation.from_quat(np.tile([0, 0, 0, 1.0], (2, 1)))
    return simulate(program, folder, np.array([0, seconds]), np.zeros((2, 3)), still, "--imu-rate", str(rate), "--seed", "5")


def test_allan_deviation_recovers_the_white_noise(program: Path, tmp_path: Path) -> None:
    samples = rest(program, tmp_path, 300, 400)
    for columns, sensor in [(range(1, 4), "gyroscope"), (range(4, 7), "accelerometer")]:
        step = PART[sensor]["step_ug"] * UG if sensor == "accelerometer" else PART[sensor]["step_mdps"] * MDPS
        for axis, column in enumerate(columns):
            taus, found = deviation(samples[:, column], 400, np.array([0.1, 0.2, 0.5, 1.0]))
            density = np.mean(found * np.sqrt(taus))
            # Rounding to steps is white noise, too.
            expected = np.sqrt(densities(sensor, "noise_density")[axis] ** 2 + step**2 / 12 / 400)
            assert density == pytest.approx(expected, rel=0.06), (sensor, axis)


def test_allan_deviation_recovers_the_random_walk(program: Path, tmp_path: Path) -> None:
    """Of the accelerometer, whose walk exceeds its white noise after less than a minute."""
    samples = rest(program, tmp_path, 7200, 50)
    taus = np.array([150.0, 200.0, 300.0, 400.0])
    ratios = []
    for axis, column in enumerate(range(4, 7)):
        taus, found = deviation(samples[:, column], 50, taus)
        white = densities("accelerometer", "noise_density")[axis] ** 2 / taus
        walk = np.sqrt(np.mean(3 * (found**2 - white) / taus))
        ratios.append(walk / densities("accelerometer", "random_walk")[axis])
    # A deviation over 300 s of 7200 s is known to about 20 %.
    assert np.mean(ratios) == pytest.approx(1, abs=0.3) and min(ratios) > 0.5 and max(ratios) < 1.7, ratios


def test_rosbags_reads_the_messages(walk: tuple[np.ndarray, ...]) -> None:
    folder, *_, samples = walk
    store = get_typestore(Stores.ROS2_HUMBLE)
    messages = []
    with Reader(folder / "walk.mcap") as reader:
        for connection, time, data in reader.messages():
            if connection.msgtype == "sensor_msgs/msg/Imu":
                message = store.deserialize_cdr(data, connection.msgtype)
                assert bytes(store.serialize_cdr(message, connection.msgtype)) == bytes(data)
                assert connection.topic.endswith("/imu/data_raw") and message.header.frame_id.endswith("imu_frame")
                assert time == message.header.stamp.sec * 10**9 + message.header.stamp.nanosec
                messages.append((time, message))
    assert [time for time, _ in messages] == [int(time) for time in samples[:, 0]]
    vector = lambda one: [one.x, one.y, one.z]
    assert np.array_equal([vector(message.angular_velocity) for _, message in messages], samples[:, 1:4])
    assert np.array_equal([vector(message.linear_acceleration) for _, message in messages], samples[:, 4:7])
    message = messages[0][1]
    # REP-145: no orientation.
    assert message.orientation_covariance[0] == -1
    for found, sensor in [(message.angular_velocity_covariance, "gyroscope"), (message.linear_acceleration_covariance, "accelerometer")]:
        expected = np.diag(densities(sensor, "noise_density") ** 2 * 200)
        assert np.allclose(np.reshape(found, (3, 3)), expected, rtol=1e-3)
