"""examples/python/replicator_folder.py."""

import json
import shutil
import subprocess
import sys

import numpy as np
import pytest

import oaktwin
from conftest import ROOT

SCRIPT = ROOT / "examples/python/replicator_folder.py"
SCENE = ROOT / "examples/depth_sensor/depth_sensor.usda"


def run(*command, code=0):
    done = subprocess.run([sys.executable, *map(str, command)], capture_output=True, text=True, encoding="utf-8")
    assert done.returncode == code, done.stderr
    return done.stderr if code else done.stdout


def body(eye, target):
    """A pose of a trajectory file."""
    world_from_body = oaktwin.look_at(eye, target, frame="body")
    m = world_from_body[:3, :3]
    w = np.sqrt(1 + np.trace(m)) / 2
    x, y, z = m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1]
    return {"position": list(eye), "orientation": [x / (4 * w), y / (4 * w), z / (4 * w), w]}


def render(folder, *options):
    run("-m", "oaktwin", "render", SCENE, "-o", folder, *options)
    return folder


@pytest.fixture(scope="module")
def frames(tmp_path_factory):
    """Three frames of one camera in a flat folder."""
    folder = tmp_path_factory.mktemp("rendered")
    poses = [body((3, -2 + 0.2 * step, 1.5), (0, 0, 0.5)) for step in range(3)]
    trajectory = folder / "poses.json"
    trajectory.write_text(json.dumps(poses))
    return render(folder / "flat", "--model", "OAK4-D", "--trajectory", trajectory, "--resolution", "320x200",
                  "--annotators", "distance_to_image_plane,rgb,camera_params")  # fmt: skip


@pytest.fixture(scope="module")
def several(tmp_path_factory):
    """Folders for the cameras of two depth sensors, each with a folder per annotator. The images are smaller than the cameras'
    own, so that principal points are slightly off the centre."""
    return render(tmp_path_factory.mktemp("rendered") / "several", "--model", "OAK-D ToF", "--look-at", 3, -2, 1.5, 0, 0, 0.5,
                  "--resolution", "320x200", "--annotators", "distance_to_image_plane,rgb,camera_params")  # fmt: skip


def results(folder):
    return {path.relative_to(folder): path.read_bytes() for path in folder.rglob("depth_sensor_distance_*.npy")}


@pytest.mark.parametrize(
    "options", [[], ["--seed", "5"], ["--preset", "robotics"]], ids=["plain", "seed", "filters that remember"]
)
def test_a_camera_is_sensed_as_the_program_does(frames, tmp_path, options):
    pytest.importorskip("PIL", reason="Pillow is not installed")
    ours, theirs = (shutil.copytree(frames, tmp_path / name) for name in ["ours", "theirs"])
    printed = run(SCRIPT, ours, *options)
    assert printed.endswith("3 frames, 1 camera\n") and printed.count("with its picture") == 3
    run("-m", "oaktwin", "sense", theirs, "--model", "OAK4-D", *options)
    got = results(ours)
    assert len(got) == 3 and got == results(theirs)
    # No other files are created or changed.
    before = {path.name: path.read_bytes() for path in frames.iterdir()}
    after = {path.name: path.read_bytes() for path in ours.iterdir()}
    assert after == {**before, **{path.name: content for path, content in got.items()}}
    measured = np.load(ours / "depth_sensor_distance_0001.npy")
    exact = np.load(ours / "distance_to_image_plane_0001.npy")
    assert measured.dtype == np.float32 and measured.shape == exact.shape == (200, 320)
    both = (measured > 0) & np.isfinite(exact)
    assert both.mean() > 0.2 and np.median(np.abs(measured - exact)[both]) < 0.05


def test_without_pictures(frames, tmp_path):
    ours, theirs = (shutil.copytree(frames, tmp_path / name) for name in ["ours", "theirs"])
    printed = run(SCRIPT, ours, "--no-rgb")
    assert "picture" not in printed
    for picture in theirs.glob("rgb_*.png"):
        picture.unlink()
    run("-m", "oaktwin", "sense", theirs, "--model", "OAK4-D")
    assert results(ours) == results(theirs)


def test_several_cameras(several, tmp_path):
    pytest.importorskip("PIL", reason="Pillow is not installed")
    ours, theirs = (shutil.copytree(several, tmp_path / name) for name in ["ours", "theirs"])
    printed = run(SCRIPT, ours, "--model", "OAK-D ToF")
    assert "2 frames, 2 cameras" in printed and "Camera_pseudo_depth_tof 0000: 320x200" in printed
    run("-m", "oaktwin", "sense", theirs, "--model", "OAK-D ToF")
    got = results(ours)
    assert len(got) == 2 and got == results(theirs)
    # Cameras that are not depth sensors of the model, and one that is, among others.
    for names in [{"Camera_pseudo_depth_stereo": "Front", "Camera_pseudo_depth_tof": "Back"},
                  {"Camera_pseudo_depth_stereo": "Front"}]:  # fmt: skip
        ours, theirs = (shutil.copytree(several, tmp_path / f"{name}{len(names)}") for name in ["ours", "theirs"])
        for folder in [ours, theirs]:
            for old, new in names.items():
                (folder / old).rename(folder / new)
        run(SCRIPT, ours, "--model", "OAK-D ToF")
        run("-m", "oaktwin", "sense", theirs, "--model", "OAK-D ToF")
        got = results(ours)
        assert len(got) == len(names) and got == results(theirs)


def test_nothing_to_do_is_an_error(tmp_path):
    assert "holds no distance_to_image_plane_0000.npy" in run(SCRIPT, tmp_path, code=1)
