"""examples/python/mujoco_table.py."""

import os
import subprocess
import sys

import numpy as np
import pytest

import oaktwin
from conftest import ROOT

pytest.importorskip("mujoco", reason="MuJoCo is not installed")

SCRIPT = ROOT / "examples/python/mujoco_table.py"


def run(folder, *options, **environment):
    command = [sys.executable, SCRIPT, "-o", folder, "--frames", "2", *options]
    done = subprocess.run(
        list(map(str, command)), capture_output=True, text=True, encoding="utf-8", env={**os.environ, **environment}
    )
    assert done.returncode == 0, done.stderr
    with np.load(folder / "frames.npz") as arrays:
        return done.stdout, dict(arrays)


@pytest.fixture(scope="module")
def rays(tmp_path_factory):
    return run(tmp_path_factory.mktemp("rays"), "--renderer", "rays")


@pytest.fixture(scope="module", params=["rays", "auto"])
def frames(request, rays, tmp_path_factory):
    return rays[1] if request.param == "rays" else run(tmp_path_factory.mktemp("auto"))[1]


def pixel_rays(frames):
    """The ray of each pixel, scaled to 1 along the axis, in the camera frame and the world."""
    k, pose = frames["K"], frames["world_from_camera"]
    height, width = frames["exact"].shape[1:]
    x, y = np.meshgrid(np.arange(width), np.arange(height))
    in_camera = np.stack([(x - k[0, 2]) / k[0, 0], (y - k[1, 2]) / k[1, 1], np.ones((height, width))], -1)
    return in_camera, in_camera @ pose[:3, :3].T


def test_the_camera_is_the_oaks(frames, device):
    own, k = device.depth_camera(), frames["K"]
    assert np.allclose(k[:2, :2], own.K[:2, :2] / 2, rtol=1e-12) and k[:2, 2].tolist() == [319.5, 199.5]
    # The measured and the expected position of the magenta ball.
    point = np.linalg.inv(frames["world_from_camera"]) @ [0.4, 0.3, 0.02, 1]
    u, v, _ = k @ (point[:3] / point[2])
    r, g, b = np.moveaxis(frames["rgb"][0].astype(int), -1, 0)
    rows, columns = np.nonzero((r > 2 * g) & (b > 2 * g))
    assert len(rows) > 100
    assert np.median(columns) == pytest.approx(u, abs=0.6) and np.median(rows) == pytest.approx(v, abs=0.6)
    nearest = point[2] * (1 - 0.02 / np.linalg.norm(point[:3]))
    assert frames["exact"][0][round(v), round(u)] == pytest.approx(nearest, abs=1e-3)


def test_exact_depth_is_the_tables(frames):
    eye = frames["world_from_camera"][:3, 3]
    _, direction = pixel_rays(frames)
    depth = -eye[2] / direction[..., 2]
    at = eye + direction * depth[..., None]
    # An empty part of the table.
    is_table = (at[..., 0] > 0.45) & (at[..., 0] < 0.59) & (np.abs(at[..., 1]) < 0.2)
    assert is_table.sum() > 3000
    assert np.abs(frames["exact"][0] - depth)[is_table].max() < 2e-6
    # Misses are not at the far plane.
    assert np.isinf(frames["exact"]).any() and frames["exact"][np.isfinite(frames["exact"])].max() < 15


def test_measured_depth_is_the_sensors(frames, device):
    sensor = oaktwin.DepthSensor(device, seed=7, fx=frames["K"][0, 0])
    for frame, (exact, measured) in enumerate(zip(frames["exact"], frames["measured"])):
        assert np.array_equal(sensor(exact, frame=frame), measured)
    own = sensor.parameters
    near, far = np.percentile(frames["exact"][np.isfinite(frames["exact"])], [1, 99])
    assert 0.5 < near < far < 8
    both = np.isfinite(frames["exact"]) & (frames["measured"] > 0)
    assert 0.6 < both.mean() < 0.8
    # Disparity in matcher pixels.
    focal_baseline = float(own["focalLength"]) * float(own["baseline"])
    error = focal_baseline / frames["measured"][both].astype(float) - focal_baseline / frames["exact"][both]
    locking, jitter, step = float(own["pixelLocking"]), float(own["jitter"]), 2.0 ** -int(own["subpixelFractionalBits"])
    # A sine, noise, and rounding to disparity steps, then to millimetres.
    millimetre = 0.0005 * focal_baseline / frames["measured"][both].min() ** 2
    assert np.abs(error).max() < locking + 5.5 * jitter + step / 2 + millimetre
    # Nearly all surfaces are nearer than 6 m, where RVC4 has smaller errors.
    factor = float(own["closeRangeFactor"])
    expected = np.sqrt(factor**2 * (locking**2 / 2 + jitter**2) + step**2 / 12)
    assert np.std(error) == pytest.approx(expected, rel=0.05)
    assert abs(np.mean(error)) < 0.02 and float(own["bias"]) == 0


def test_renderers_agree(rays, frames):
    """Compares OpenGL, if available, with ray casting."""
    ray, other = rays[1]["exact"], frames["exact"]
    assert (np.isfinite(ray) != np.isfinite(other)).mean() < 1e-4
    both = np.isfinite(ray) & np.isfinite(other)
    difference = np.abs(np.subtract(ray, other, where=both, out=np.zeros_like(ray)))
    assert np.percentile(difference, 95) < 2e-6 and np.mean(difference > 5e-3) < 2e-3


def test_without_opengl(rays, tmp_path):
    printed, frames = run(tmp_path, MUJOCO_GL="off")
    assert "MuJoCo's ray casting serves" in printed and "rendered by ray casting" in printed
    assert np.array_equal(frames["measured"], rays[1]["measured"])
    assert "ray casting serves" not in rays[0]
