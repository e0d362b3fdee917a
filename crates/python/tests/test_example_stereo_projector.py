"""The numbers of the projector example, with and without dots, and in bright light."""

import csv
import subprocess
import sys

import numpy as np
import pytest

import oaktwin
from conftest import ROOT

pytest.importorskip("matplotlib")

FOLDER = ROOT / "examples/python"


def run(folder, *arguments, code=0):
    command = [sys.executable, "stereo_projector.py", "-o", folder, *arguments]
    done = subprocess.run([*map(str, command)], capture_output=True, text=True, encoding="utf-8", cwd=FOLDER)
    assert done.returncode == code, done.stderr
    return done.stderr if code else done.stdout


def rows(folder):
    with open(folder / "projector.csv", newline="") as file:
        return [{name: float(value) for name, value in row.items()} for row in csv.DictReader(file)]


def test_holes_then_depth(tmp_path):
    printed = run(tmp_path)
    off, on = rows(tmp_path)
    assert (off["projector"], on["projector"]) == (0, 1)
    for row in (off, on):
        assert f"{row['density']:.1%}" in printed and f"{row['median_error_mm']:.1f} mm" in printed
    # Most of the image is a uniform wall.
    assert off["density"] < 0.3 and off["outliers"] > 0.4
    # The dots are on the wall and all objects; the left border is outside the right image.
    assert on["density"] > 0.65 and on["outliers"] < 0.1
    # A quarter of a pixel at 2.5 m.
    assert on["median_error_mm"] < 1000 * 0.25 * 2.5**2 / (400 * 0.075)
    assert (tmp_path / "projector.png").read_bytes().startswith(b"\x89PNG")


def test_the_numbers_are_those_of_the_arrays(tmp_path):
    run(tmp_path, "--size", 320, 200, "--seed", 3)
    device = oaktwin.Device("OAK-D Pro PoE")
    scene = oaktwin.Scene.open(tmp_path / "room.usda")
    ahead = oaktwin.look_at((0, 0, 0), (1, 0, -0.1), frame="body")
    for row in rows(tmp_path):
        taken = scene.render_pair(device, ahead, size=(320, 200), projector=row["projector"], ambient=0.3, seed=3, frame=0)
        depth = oaktwin.StereoMatcher(device)(taken["left"], taken["right"])["depth"]
        assert np.mean(depth > 0) == row["density"]
        error = np.abs(depth - taken["z"])[depth > 0]
        assert 1000 * np.median(error) == pytest.approx(row["median_error_mm"], rel=1e-6)


def test_light_drowns_the_dots(tmp_path):
    """More ambient light makes the dots less visible."""
    density = []
    for ambient in (0.05, 1, 20):
        run(tmp_path, "--ambient", ambient)
        density.append(rows(tmp_path)[1]["density"])
    assert density[0] > density[1] + 0.1 and density[1] > density[2] + 0.1


def test_a_model_without_a_projector(tmp_path):
    assert "OAK4-D: projector: the model has no dot projector" in run(tmp_path, "--model", "OAK4-D", code=1)
