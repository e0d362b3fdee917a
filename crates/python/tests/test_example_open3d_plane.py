"""Compares the numbers of the Open3D example with the ground truth and the theory."""

import csv
import subprocess
import sys

import numpy as np
import pytest

from conftest import ROOT, environment_with_libusb

FOLDER = ROOT / "examples/python"


@pytest.fixture(scope="module")
def run():
    """Runs Python with the libusb that Open3D requires."""
    environment = environment_with_libusb()

    def python(*arguments):
        command = [sys.executable, *map(str, arguments)]
        return subprocess.run(
            command, capture_output=True, text=True, encoding="utf-8", env=environment, cwd=FOLDER
        )

    for peer in ["open3d", "matplotlib"]:
        found = python("-c", f"import {peer}")
        if found.returncode != 0:
            pytest.skip(f"{peer} cannot be imported: {found.stderr.splitlines()[-1]}")
    return python


@pytest.mark.parametrize("tilt", [30, 0])
def test_the_plane_and_the_scatter(run, tmp_path, tilt):
    done = run("open3d_plane.py", "-o", tmp_path, "--tilt", tilt)
    assert done.returncode == 0, done.stderr
    with open(tmp_path / "plane.csv", newline="") as file:
        rows = [{name: float(value) for name, value in row.items()} for row in csv.DictReader(file)]
    assert [row["distance_m"] for row in rows] == [1, 2, 3, 4, 5, 6, 7, 8]
    assert (tmp_path / "plane.png").read_bytes().startswith(b"\x89PNG")
    for row in rows:
        # The rest are invalid pixels (the left border, occlusions) and the box.
        assert row["points"] > 0.9 * 640 * 400 and 0.8 < row["inliers"] / row["points"] < 0.95
        assert f"{row['rms_mm']:.1f} mm" in done.stdout
    if tilt:
        for row in rows:
            # RANSAC's variation between runs is smaller than this.
            assert row["angle_deg"] < (0.1 if row["distance_m"] <= 4 else 0.5)
            assert abs(row["offset_mm"]) < 3 * row["distance_m"]
            # An oblique wall covers many pixels of disparity, so pixel locking acts as random noise.
            assert row["rms_mm"] == pytest.approx(row["theory_mm"], rel=0.05)
        # Computed independently: a wall n . p = h through (0, 0, 4 m), the z of its columns, 0.05 px, 0.13 px and 1/32 px.
        x = (np.arange(640) - 319.5) / (640 / np.tan(np.radians(77 / 2)) / 2)
        z = 4 * np.cos(np.radians(tilt)) / (np.cos(np.radians(tilt)) + x * np.sin(np.radians(tilt)))
        sigma = np.sqrt(0.05**2 + 0.13**2 / 2 + 1 / 32**2 / 12) / (640 / np.tan(np.radians(77 / 2)) * 0.075)
        assert rows[3]["theory_mm"] == pytest.approx(1000 * sigma * np.sqrt(np.mean(z**4)), rel=0.05)
        assert rows[7]["rms_mm"] / rows[3]["rms_mm"] == pytest.approx(4, rel=0.05)
    else:
        # A wall parallel to the image has a constant disparity: pixel locking shifts it as a whole.
        for row in rows:
            assert row["rms_mm"] < 0.7 * row["theory_mm"]
        assert max(abs(row["offset_mm"]) for row in rows) > 20


def test_open3d_counts_pixels_as_we_do(run):
    """Points of ground-truth depth are on the wall; with a shift of half a pixel they are not."""
    code = """
import numpy as np, oaktwin, open3d_plane as example
camera = oaktwin.Device("OAK4-D").depth_camera().resized(320, 200)
scene, (normal, offset) = example.tilted_wall(3.0, 30.0)
depth = scene.render(camera, np.eye(4))["distance_to_image_plane"]
points = np.asarray(example.point_cloud(depth, camera).points)
assert len(points) == 320 * 200
for shift in [0, 0.5]:
    shifted = points + points[:, 2:] * [shift / camera.K[0, 0], 0, 0]
    print(np.median(np.abs(shifted @ normal - offset)))
"""
    done = run("-c", code)
    assert done.returncode == 0, done.stderr
    exact, shifted = map(float, done.stdout.split())
    assert exact < 1e-6 and shifted > 1e-3
