"""The example that records a walk: both recordings match what was rendered."""

import os
import subprocess
import sys

import numpy as np
import pytest

import oaktwin
from conftest import ROOT

for peer in ["mcap_ros2.reader", "rerun.chunk", "matplotlib"]:
    pytest.importorskip(peer, reason=f"{peer} is not installed")

from test_recording import array, cloud, columns, messages, rerun, world_from  # noqa: E402

FRAMES, SIZE = 3, (64, 40)
EXAMPLE = ROOT / "examples/python/rerun_mcap.py"


@pytest.fixture(scope="module")
def walked(tmp_path_factory):
    folder = tmp_path_factory.mktemp("walk")
    command = [sys.executable, EXAMPLE, "-o", folder, "--frames", FRAMES, "--size", *SIZE]
    done = subprocess.run(
        [*map(str, command)], capture_output=True, text=True, encoding="utf-8", env={**os.environ, "MPLCONFIGDIR": str(folder)}
    )
    assert done.returncode == 0, done.stderr
    return folder, done.stdout


@pytest.fixture(scope="module")
def truth(walked):
    """The expected content, computed again: the camera, poses, and images of each frame."""
    folder, _ = walked
    device = oaktwin.Device("OAK4-D")
    camera = device.depth_camera().resized(*SIZE)
    angles = np.radians([190, 230, 270])
    eyes = np.stack([2.2 * np.cos(angles), 2.2 * np.sin(angles), np.full(3, 1.3)], axis=1)
    poses = np.stack([oaktwin.look_at(eye, (0.3, 0.2, 0.5)) for eye in eyes])
    seen = oaktwin.Scene.open(folder / "room.usda").render(camera, poses, annotators=["rgb", "distance_to_image_plane"])
    depth = seen["distance_to_image_plane"]
    sensor = oaktwin.DepthSensor(device, seed=7)
    return camera, poses, depth, np.stack([sensor(one, frame=at) for at, one in enumerate(depth)]), seen["rgb"]


def test_the_mcap(walked, truth):
    folder, printed = walked
    camera, poses, depth, measured, rgb = truth
    topics = messages(folder / "walk.mcap")
    for topic, found in topics.items():
        assert f"  {topic:22} {len(found):3} {type(found[0]).__name__}\n" in printed
    for frame, pose in enumerate(poses):
        stamp = (0, frame * 100_000_000)
        np.testing.assert_array_equal(array(topics["/oak/rgb"][frame]), rgb[frame, ..., :3])
        np.testing.assert_array_equal(array(topics["/oak/depth"][frame]), depth[frame])
        expected = np.where(measured[frame] > 0, measured[frame], np.nan)
        np.testing.assert_array_equal(array(topics["/oak/measured"][frame]), expected)
        np.testing.assert_array_equal(np.reshape(topics["/oak/camera_info"][frame].k, (3, 3)), camera.K)
        world_from_optical = world_from("oak_optical_frame", topics, stamp)
        np.testing.assert_allclose(world_from_optical, pose, atol=1e-12)
        # Measured points of the floor are at z = 0 in the world.
        points, _ = cloud(topics["/oak/measured_points"][frame])
        rays = np.stack([*np.meshgrid(np.arange(SIZE[0]), np.arange(SIZE[1])), np.ones(SIZE[::-1])], axis=2)
        z = np.where(np.isfinite(depth[frame]), depth[frame], 0)[..., None]
        exact = (rays @ np.linalg.inv(camera.K).T * z) @ pose[:3, :3].T + pose[:3, 3]
        floor = (np.abs(exact[..., 2]) < 1e-4) & ~np.isnan(points[..., 2])
        heights = (points[floor] @ world_from_optical[:3, :3].T + world_from_optical[:3, 3])[:, 2]
        assert floor.sum() > 300 and abs(np.median(heights)) < 0.01 and np.abs(heights).max() < 0.2
    error = np.abs(measured - depth)[np.isfinite(depth) & (measured > 0)]
    assert f"measured {np.mean(measured > 0):.1%} of the pixels, median error {1000 * np.median(error):.1f} mm" in printed


def test_the_rrd(walked, truth):
    folder, _ = walked
    camera, poses, depth, measured, rgb = truth
    rerun(folder / "home", "rrd", "verify", folder / "walk.rrd")
    found = columns(folder / "walk.rrd")
    images = {
        "rgb": ("Image:buffer", np.ascontiguousarray(rgb[..., :3])),
        "depth": ("DepthImage:buffer", depth),
        "measured": ("DepthImage:buffer", measured),
    }
    for name, (component, expected) in images.items():
        rows = found[f"/world/oak/image/{name}", component]
        assert [time for time, _ in rows] == [0, 100_000_000, 200_000_000]
        for (_, [pixels]), image in zip(rows, expected):
            np.testing.assert_array_equal(np.array(pixels, np.uint8), image.reshape(-1).view(np.uint8))
    for (_, [k]) in found["/world/oak/image", "Pinhole:image_from_camera"]:
        np.testing.assert_allclose(np.reshape(k, (3, 3)).T, camera.K, rtol=1e-6)
    turns = found["/world/oak", "Transform3D:mat3x3"]
    places = found["/world/oak", "Transform3D:translation"]
    for frame, pose in enumerate(poses):
        np.testing.assert_allclose(np.reshape(turns[frame][1][0], (3, 3)).T, pose[:3, :3], atol=1e-6)
        np.testing.assert_allclose(places[frame][1][0], pose[:3, 3], atol=1e-6)
        points = np.array(found["/world/oak/points", "Points3D:positions"][frame][1], np.float32)
        np.testing.assert_allclose(points[:, 2], measured[frame][measured[frame] > 0], rtol=1e-6)


def test_the_picture(walked):
    folder, _ = walked
    assert (folder / "walk.png").read_bytes().startswith(b"\x89PNG")
