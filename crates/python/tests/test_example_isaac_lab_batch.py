"""examples/python/isaac_lab_batch.py."""

import argparse
import importlib.util
import re
import subprocess
import sys

import numpy as np
import pytest

import oaktwin
from conftest import ROOT
from oaktwin import _oaktwin

SCRIPT = ROOT / "examples/python/isaac_lab_batch.py"
HAS_TORCH = importlib.util.find_spec("torch") is not None


def run(*options):
    done = subprocess.run(
        [sys.executable, SCRIPT, *map(str, options)], capture_output=True, text=True, encoding="utf-8"
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.fixture(scope="module")
def example():
    spec = importlib.util.spec_from_file_location("isaac_lab_batch", SCRIPT)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="module")
def ran(tmp_path_factory):
    folder = tmp_path_factory.mktemp("batch")
    printed = run("--envs", 48, "--steps", 3, "--numpy", "-o", folder)
    with np.load(folder / "batch.npz") as arrays:
        return printed, dict(arrays)


def test_output_equals_the_sensors(ran, device):
    printed, arrays = ran
    exact, measured = arrays["exact"], arrays["measured"]
    assert exact.shape == measured.shape == (16, 60, 106) and arrays["frame"] == 2
    hfov = device.depth_camera().hfov_deg
    # The first environments of 48 have the noise of the first of 16.
    sensor = oaktwin.DepthSensor(device, hfov_deg=hfov, seed=7)
    assert np.array_equal(sensor(exact, frame=2), measured)
    assert not np.array_equal(sensor(exact, frame=1), measured)
    assert "(48, 60, 106) of numpy" in printed
    shares = [float(share) for share in re.findall(r"step \d: [\d.]+ ms, ([\d.]+) % measured", printed)]
    assert len(shares) == 3 and all(70 < share < 95 for share in shares)
    assert abs(shares[2] - 100 * (measured > 0).mean()) < 2
    both = np.isfinite(exact) & (measured > 0)
    near = both & (exact < 2)
    assert np.abs(measured - exact)[near].max() < 0.02 < np.abs(measured - exact)[both].max()


def test_each_environment_and_step_has_its_own_noise(example, device):
    wall = np.full((3, 60, 106), 2.0, np.float32)
    sensor = oaktwin.DepthSensor(device, hfov_deg=77, seed=7)
    out, again = np.empty_like(wall), np.empty_like(wall)
    sensor(wall, frame=0, out=out)
    assert not np.array_equal(out[0], out[1]) and not np.array_equal(out[1], out[2])
    sensor(wall, frame=1, out=again)
    assert not np.array_equal(out[0], again[0])
    sensor(wall, frame=0, out=again)
    assert np.array_equal(out, again)


def test_the_cameras_field_of_view(ran, device):
    focal, aperture = map(float, re.search(r"focal_length=([\d.]+), horizontal_aperture=([\d.]+)", ran[0]).groups())
    assert np.degrees(2 * np.arctan(aperture / 2 / focal)) == pytest.approx(device.depth_camera().hfov_deg, abs=1e-3)


def test_the_synthetic_ground(example):
    """Ground pixels are 0.6 m below the camera, which is tilted down by 20 degrees."""
    depth = example.made_up_depth(5, 60, 106, 77.0)
    focal = 53 / np.tan(np.radians(38.5))
    y = (np.arange(60) - 29.5) / focal
    below = depth * (np.sin(np.radians(20)) + y * np.cos(np.radians(20)))[:, None]
    assert np.isinf(depth[:, 0]).any() and np.allclose(below[:, 50:], 0.6, atol=1e-5)
    assert (below[np.isfinite(depth)] < 0.6 + 1e-4).all()


@pytest.mark.skipif(not HAS_TORCH, reason="torch is not installed")
def test_torch(example, ran, tmp_path, device):
    import torch

    printed = run("--envs", 48, "--steps", 3, "-o", tmp_path)
    assert "(48, 60, 106) of torch" in printed and "as a modifier: the same" in printed
    with np.load(tmp_path / "batch.npz") as arrays:
        assert np.array_equal(arrays["measured"], ran[1]["measured"])
    # No copy: the sensor accesses the memory of the tensors.
    depth, out = torch.full((4, 60, 106), 2.0), torch.zeros(4, 60, 106)
    assert _oaktwin._read_from(depth) == depth.data_ptr()
    sensor = oaktwin.DepthSensor(device, hfov_deg=77.0, seed=1)
    at = out.data_ptr()
    assert sensor(depth, out=out) is out and out.data_ptr() == at and (out > 0).any()
    # As in an observation term.
    modifier = example.OakDepth(argparse.Namespace(params={"hfov_deg": 77.0, "seed": 1}), (4, 60, 106, 1), "cpu")
    observed = modifier(depth.unsqueeze(-1).clone())
    modifier.reset([0])
    assert observed.shape == (4, 60, 106, 1) and torch.equal(observed[..., 0], out)
    assert not torch.equal(modifier(depth.unsqueeze(-1).clone()), observed)
