"""examples/python/training.py."""

import importlib.util
import re
import subprocess
import sys

import numpy as np
import pytest

from conftest import ROOT

SCRIPT = ROOT / "examples/python/training.py"


def run(*options):
    done = subprocess.run(
        [sys.executable, SCRIPT, *map(str, options)], capture_output=True, text=True, encoding="utf-8"
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.fixture(scope="module")
def example():
    spec = importlib.util.spec_from_file_location("training", SCRIPT)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def numbers(printed):
    words = r"age (\d+) ms on average, (\d+) ms at most; (\d+) % of steps have a new frame"
    return [int(number) for number in re.search(words, printed).groups()]


def test_what_is_printed_and_written(tmp_path):
    printed = run("--envs", 64, "--steps", 60, "-o", tmp_path)
    assert "64 environments, observations (64, 1, 58, 87) of numpy" in printed
    mean, most, share = numbers(printed)
    # The mean delay is 60 ms and 5 ms of jitter, then half a period of the camera and half a step on average.
    assert 65 + 10 <= mean <= 65 + 40 and mean < most < 90 + 10 + 2 * 34 + 40
    assert 50 <= share <= 60  # 0.98 · 30 of 50 Hz
    with np.load(tmp_path / "training.npz") as arrays:
        exact, seen, age = arrays["exact"], arrays["seen"], arrays["age"]
    assert exact.shape == seen.shape == (16, 58, 87) and age.shape == (16,)
    assert seen.min() == -1 and seen.max() == pytest.approx(1)
    valid = (seen >= 0) & (exact >= 0)
    assert 0.6 < valid.mean() < 1
    # What is seen is behind, on average.
    assert 0.001 < (seen - exact)[valid & (exact < 0.9)].mean() < 0.05


def test_warp(tmp_path):
    pytest.importorskip("warp")
    printed = run("--envs", 16, "--steps", 10, "--warp", "-o", tmp_path)
    assert "16 environments, observations (16, 1, 58, 87) of numpy" in printed


def test_the_synthetic_ground(example):
    """Ground pixels are 0.6 m below the camera, which is tilted down by 20 degrees."""
    depth = example.made_up_depth(5, 60, 106, 77.0)
    focal = 53 / np.tan(np.radians(38.5))
    y = (np.arange(60) - 29.5) / focal
    below = depth * (np.sin(np.radians(20)) + y * np.cos(np.radians(20)))[:, None]
    assert np.isinf(depth[:, 0]).any() and np.allclose(below[:, 50:], 0.6, atol=1e-5)
    assert (below[np.isfinite(depth)] < 0.6 + 1e-4).all()
