"""The stereo error model, compared with a NumPy implementation of the documented steps."""

from dataclasses import asdict, replace
from functools import partial
from pathlib import Path

import numpy as np
import pytest

import stereo_noise_model as model

SETTINGS = [
    {},
    {"bias": -0.22, "subpixelFractionalBits": 3},
    {"subpixelFractionalBits": 0, "jitter": 0.3},
    {"subpixelFractionalBits": 4, "extendedDisparity": True, "disparityShift": 3},
    {"disparityShift": 20, "bias": 0.4, "pixelLocking": 0.2},
    {"window": 1, "jitter": 0.2},
    {"window": 3, "jitter": 0.5, "depthRounding": "truncate"},
    {"window": 5},
    {"window": 21, "jitter": 1.0},
    {"edgeDilation": 3},
    {"edgeDilation": 2.5, "leftRightCheck": False},
    {"edgeDilation": 4, "leftRightCheckThreshold": 0},
    {"edgeDilation": 3, "leftRightCheckThreshold": 40, "extendedDisparity": True},
    {"edgeDilation": 5, "occlusion": False},
    {"occlusion": False, "dropout": 0.3},
    {"dropout": 0.02, "numInvalidateEdgePixels": 30},
    {"confidenceThreshold": 120},
    {"confidenceThreshold": 120, "dotContrast": 3},
    {"confidenceThreshold": 200, "dotContrast": 1e4, "edgeDilation": 3},
    {"confidenceThreshold": 0, "jitter": 0, "pixelLocking": 0},
    {"closeRangeFactor": 0.75, "bias": -0.4, "pixelLocking": 0.2, "jitter": 0.3},
    {"closeRangeFactor": 2, "bias": 0.4, "window": 5},
]

SIZES = [(96, 1280), (60, 106), (70, 333), (40, 640), (9, 1), (1, 65), (30, 1920)]


@pytest.fixture
def ask(depth_eval):
    return partial(depth_eval, "stereo_noise")


def scene(random, height, width):
    """A wall, a floor, boxes and poles at any depth, and invalid depth."""
    x = np.linspace(0, 1, width)[None, :]
    y = np.linspace(0, 1, height)[:, None]
    z = random.uniform(2, 9) + random.uniform(-1.5, 1.5) * x + random.uniform(-0.5, 0.5) * y
    with np.errstate(divide="ignore"):
        z = np.minimum(z, np.where(y > 0.6, random.uniform(0.2, 0.9) / (y - 0.5), np.inf))
    for _ in range(random.integers(2, 20)):
        left, top = random.uniform(-0.1, 1, 2)
        wide, high = random.choice([0.004, 0.03, 0.2]), random.uniform(0.05, 0.7)
        inside = (x >= left) & (x < left + wide) & (y >= top) & (y < top + high)
        z = np.where(inside, random.uniform(0.3, 6) + random.uniform(-1, 1) * (x - left), z)
    z = np.where(random.random(z.shape) < 0.01, random.choice([np.nan, np.inf, -np.inf, 0, -1, 1e-30], z.shape), z)
    return z.astype(np.float32)


def picture(random, height, width):
    """Noise whose strength grows from left to right."""
    strength = np.linspace(0, 25, width)[None, :, None]
    levels = 100 + strength * random.standard_normal((height, width, 4))
    return np.clip(levels, 0, 255).astype(np.uint8)


def wire(p):
    fields = asdict(p)
    named = {"focal_length_px": "focalLength", "baseline_m": "baseline", "width_px": "width"}
    request = {ours: fields.pop(theirs) for ours, theirs in named.items()}
    return {**request, "parameters": fields}


def compare(found, depth, p, **arguments):
    """All pixels are equal except those that float32 rounds differently; returns their number."""
    steps, expected = model.disparity(depth, p, **arguments)
    differing = np.nonzero(found != expected)
    # Of float32, and of normal numbers in steps of 1/1024 in small windows.
    tolerance = 2e-3 + (p.window * depth.shape[1] / p.width < 3.5) * p.jitter * 2**p.subpixelFractionalBits / 512
    ties = np.abs(steps[differing] - np.floor(steps[differing]) - 0.5) < tolerance
    # A tie at the end of the range may go either way.
    near = np.abs(found[differing].astype(int) - expected[differing].astype(int)) <= 1
    at_the_end = (expected[differing] >= p.max_fixed) | (found[differing] >= p.max_fixed)
    at_the_end |= (expected[differing] <= 1) & (found[differing] <= 1)
    wrong = ~(ties & (near | at_the_end))
    where = tuple(axis[wrong][:5] for axis in differing)
    assert not wrong.any(), (p, where, found[where], expected[where], steps[where])
    return len(ties)


@pytest.mark.parametrize("size", SIZES, ids=str)
def test_disparities(ask, tmp_path: Path, size):
    random = np.random.default_rng([5, *size])
    pixels = differing = 0
    for number, settings in enumerate(SETTINGS):
        depth = scene(random, *size)
        width = int(random.choice([1280, 640]))
        p = model.Parameters(random.uniform(400, 900), random.choice([0.02, 0.075, 0.15]), width)
        p = replace(p, pixelLocking=0.13 if width > 640 else 0.2)
        p = replace(p, **settings)
        rgb = picture(random, *size) if number % 2 == 0 or "confidenceThreshold" in settings else None
        np.save(tmp_path / "depth.npy", depth)
        arguments = {"seed": 2**63 + number, "camera": "left", "frame": 2**32 + 3 * number, "item": number}
        request = {"depth": "depth.npy", "disparity": "disparity.npy", "distance": "distance.npy"}
        if rgb is not None:
            np.save(tmp_path / "rgb.npy", rgb)
            request["rgb"] = "rgb.npy"
        ask(**{key: str(tmp_path / name) for key, name in request.items()}, **wire(p), **arguments)
        found = np.load(tmp_path / "disparity.npy")
        differing += compare(found, depth, p, rgb=rgb, **arguments)
        pixels += found.size
        np.testing.assert_array_equal(np.load(tmp_path / "distance.npy"), model.metres(found, p))
    print(f"{size}: {differing} of {pixels} pixels differ by rounding")
    assert differing <= max(2, 1e-3 * pixels)


def test_a_batch(ask, tmp_path: Path):
    random = np.random.default_rng(7)
    p = model.Parameters(800.0, 0.075, 1280, bias=-0.1)
    depth = np.stack([scene(random, 60, 106) for _ in range(12)])
    np.save(tmp_path / "depth.npy", depth)
    paths = {"depth": str(tmp_path / "depth.npy"), "distance": str(tmp_path / "distance.npy")}
    ask(**paths, **wire(p), seed=3, camera="batch", frame=9)
    found = np.load(tmp_path / "distance.npy")
    assert found.shape == depth.shape
    differing = 0
    for item, (image, sensed) in enumerate(zip(depth, found, strict=True)):
        expected = model.stereo_noise(image, p, 3, "batch", 9, item)
        np.testing.assert_array_equal(sensed > 0, expected > 0)
        differing += np.count_nonzero(sensed != expected)
    assert differing <= 1e-3 * depth.size
