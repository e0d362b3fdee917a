import pickle

import numpy as np
import pytest

import oaktwin
from conftest import ROOT

ROOM = ROOT / "crates/cli/tests/cli/fixtures/room.usda"
GRAVITY = 9.80665


def at_rest(count=2, seconds=1.0):
    return np.linspace(0, seconds, count), np.broadcast_to(np.eye(4), (count, 4, 4))


def circle(radius=1.0, turn=0.8, seconds=4.0, rate=50):
    """The body looks along the tangent of a circle around the world's z axis."""
    times = np.arange(0, seconds, 1 / rate)
    angles = turn * times
    poses = np.zeros((len(times), 4, 4))
    poses[:, 0, 0] = poses[:, 1, 1] = -np.sin(angles)
    poses[:, 1, 0], poses[:, 0, 1] = np.cos(angles), -np.cos(angles)
    poses[:, 2, 2] = poses[:, 3, 3] = 1
    poses[:, 0, 3], poses[:, 1, 3] = radius * np.cos(angles), radius * np.sin(angles)
    return times, poses


def in_body(device, samples):
    return samples @ device.extrinsics("imu", "body")[:3, :3].T


def test_rest(device):
    got = oaktwin.simulate_imu(device, *at_rest(seconds=20.0), rate=200)
    assert got["timestamp"].dtype == np.int64 and np.all(np.diff(got["timestamp"]) == 5_000_000)
    assert got["angular_velocity"].shape == got["linear_acceleration"].shape == (len(got["timestamp"]), 3)
    assert in_body(device, got["linear_acceleration"]).mean(0) == pytest.approx([0, 0, GRAVITY], abs=3e-3)
    assert got["angular_velocity"].mean(0) == pytest.approx(0, abs=1e-4)
    upright = oaktwin.simulate_imu(device, *at_rest(seconds=20.0), rate=200, up="y")
    assert in_body(device, upright["linear_acceleration"]).mean(0) == pytest.approx([0, GRAVITY, 0], abs=3e-3)


def test_a_circle(device):
    turn, radius = 0.8, 1.0
    got = oaktwin.simulate_imu(device, *circle(radius, turn), rate=100)
    assert in_body(device, got["angular_velocity"]).mean(0) == pytest.approx([0, 0, turn], abs=1e-3)
    # The sensor is on another circle: its place in the body's frame is (x, y), the centre is `radius` to the left.
    x, y, _ = device.extrinsics("imu", "body")[:3, 3]
    expected = [-(turn**2) * x, turn**2 * (radius - y), GRAVITY]
    assert in_body(device, got["linear_acceleration"]).mean(0) == pytest.approx(expected, abs=5e-3)


def test_seeds_and_parts(device):
    same = [oaktwin.simulate_imu(device, *at_rest(), seed=7)["linear_acceleration"] for _ in range(2)]
    assert np.array_equal(*same)
    assert not np.array_equal(same[0], oaktwin.simulate_imu(device, *at_rest(), seed=8)["linear_acceleration"])
    other = oaktwin.simulate_imu(device, *at_rest(), seed=7, part="BMI270")["linear_acceleration"]
    assert other.std() != same[0].std()


def test_matches_the_program(program, device, tmp_path):
    times, poses = circle(seconds=1.0)
    lines = []
    for t, pose in zip(times, poses, strict=True):
        # A turn about z.
        half = np.arctan2(pose[1, 0], pose[0, 0]) / 2
        x, y, z = pose[:3, 3]
        lines.append(f"{t!r} {x!r} {y!r} {z!r} 0 0 {np.sin(half)!r} {np.cos(half)!r}".replace("np.float64(", "").replace(")", ""))
    trajectory = tmp_path / "poses.tum"
    trajectory.write_text("\n".join(lines))
    csv = tmp_path / "imu.csv"
    program("render", ROOM, "--model", "OAK4-D", "--trajectory", trajectory, "--imu", csv, "--imu-rate", 100, "--seed", 3,
            "--annotators", "distance_to_image_plane", "--resolution", "16x10", "-o", tmp_path / "frames")
    expected = np.loadtxt(csv, delimiter=",")
    got = oaktwin.simulate_imu(device, times, poses, rate=100, seed=3)
    assert np.array_equal(got["timestamp"], expected[:, 0].astype(np.int64))
    # The poses went through quaternions only there, which may move a sample by one step.
    assert got["angular_velocity"] == pytest.approx(expected[:, 1:4], abs=3e-3)
    assert got["linear_acceleration"] == pytest.approx(expected[:, 4:7], abs=1e-2)


def test_invalid_input(device):
    times, poses = at_rest(3)
    for arguments, options in [
        ((times[:1], poses[:1]), {}),
        ((times[::-1], poses), {}),
        (([0.0, 0.5, 0.5], poses), {}),
        ((times[:2], poses), {}),
        ((times, np.full((3, 4, 4), np.nan)), {}),
        ((times, poses), {"rate": -1}),
        ((times, poses), {"rate": 1e12}),
        ((times, poses), {"part": "BMI271"}),
        ((times, poses), {"up": "x"}),
    ]:
        with pytest.raises(oaktwin.Error):
            oaktwin.simulate_imu(device, *arguments, **options)
    with pytest.raises(oaktwin.Error, match="OAK-1"):
        oaktwin.simulate_imu(oaktwin.Device("OAK-1"), times, poses)


def test_the_source_of_the_axes():
    """Sources disagree about the axes of the OAK-D's inertial unit."""
    driver, board = oaktwin.Device("OAK-D"), oaktwin.Device("OAK-D", imu_frame="board-file")
    left, up, forward = [0, 1, 0], [0, 0, 1], [1, 0, 0]
    assert np.array_equal(driver.extrinsics("imu", "body")[:3, :3].T, [np.negative(up), left, forward])
    assert np.array_equal(board.extrinsics("imu", "body")[:3, :3].T, [left, up, forward])
    copied = pickle.loads(pickle.dumps(board))
    assert np.array_equal(copied.extrinsics("imu", "body"), board.extrinsics("imu", "body"))
    with pytest.raises(oaktwin.Error, match="imu_frame: invalid value 'vendor'"):
        oaktwin.Device("OAK-D", imu_frame="vendor")
