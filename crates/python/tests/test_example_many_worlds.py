"""examples/python/many_worlds.py."""

import subprocess
import sys

import numpy as np
import pytest

from conftest import ROOT

pytest.importorskip("mujoco", reason="MuJoCo is not installed")
pytest.importorskip("matplotlib", reason="Matplotlib is not installed")

SCRIPT = ROOT / "examples/python/many_worlds.py"


def test_worlds_differ_and_are_measured(tmp_path):
    command = [sys.executable, str(SCRIPT), "-o", str(tmp_path), "--count", "8"]
    done = subprocess.run(command, capture_output=True, text=True, encoding="utf-8")
    assert done.returncode == 0, done.stderr
    assert "8 worlds of 106x60" in done.stdout and (tmp_path / "worlds.png").stat().st_size > 10_000
    with np.load(tmp_path / "worlds.npz") as arrays:
        depth, measured = arrays["depth"], arrays["measured"]
    assert depth.shape == measured.shape == (8, 60, 106)
    assert all(not np.array_equal(depth[0], other) for other in depth[1:])
    valid = (measured > 0) & np.isfinite(depth)
    assert 0.8 < np.mean(valid[np.isfinite(depth)]) < 1.0
    assert 0 < np.median(np.abs(measured - depth)[valid]) < 0.01
