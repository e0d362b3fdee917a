"""Compares the files of Ray's workers, one of which is killed, with the files of a single process."""

import hashlib
import json
import subprocess
import sys

import numpy as np
import pytest

import oaktwin
from conftest import ROOT

EXAMPLE = ROOT / "examples/python/ray_frames.py"
FRAMES = 6
SIZE = (160, 100)


def run(folder, *arguments):
    options = ["-o", folder, "--frames", FRAMES, "--size", *SIZE, *arguments]
    command = [sys.executable, EXAMPLE, *map(str, options)]
    return subprocess.run(command, capture_output=True, text=True, encoding="utf-8")


def hashes(folder):
    return {path.name: hashlib.sha256(path.read_bytes()).hexdigest() for path in folder.iterdir()}


@pytest.fixture(scope="module")
def local(tmp_path_factory):
    folder = tmp_path_factory.mktemp("local") / "frames"
    done = run(folder, "--local")
    assert done.returncode == 0, done.stderr
    return folder


def test_a_frame_is_a_function_of_its_number(local):
    found = hashes(local)
    assert len(found) == 4 * FRAMES + 1
    assert json.loads((local / "frames.json").read_text()) == {
        name: found[name] for name in found if name != "frames.json"
    }
    for name in ["distance_to_image_plane", "depth_sensor_distance", "rgb", "world_from_camera"]:
        assert len({found[f"{name}_{number:04}.npy"] for number in range(FRAMES)}) == FRAMES

    device = oaktwin.Device("OAK-D Pro PoE")
    sensor = oaktwin.DepthSensor(device, seed=7)
    depth, pose, measured = (
        np.load(local / f"{name}_0003.npy")
        for name in ["distance_to_image_plane", "world_from_camera", "depth_sensor_distance"]
    )
    assert np.array_equal(sensor(depth, frame=3), measured) and (measured > 0).mean() > 0.7
    assert not np.array_equal(sensor(depth, frame=2), measured)
    scene = oaktwin.Scene.open(ROOT / "examples/depth_sensor/depth_sensor.usda")
    camera = device.depth_camera().resized(*SIZE)
    assert np.array_equal(scene.render(camera, pose)["distance_to_image_plane"], depth)


@pytest.mark.parametrize(
    "arguments",
    [
        # Two workers, one killed while it writes a file of frame 2.
        ["--workers", 2, "--kill-at", 2],
        # Another number of workers and blocks; and a single worker that is restarted.
        ["--workers", 1, "--blocks", 2, "--kill-at", FRAMES - 1],
    ],
)
def test_output_is_independent_of_workers(local, tmp_path, arguments):
    pytest.importorskip("ray.data", reason="ray[data] is not installed", exc_type=ImportError)
    # The remains of an interrupted run.
    folder = tmp_path / "frames"
    folder.mkdir()
    (folder / "rgb_0000.npy.1.part").write_bytes(b"part")
    done = run(folder, *arguments)
    assert done.returncode == 0, done.stderr
    assert f"{FRAMES} frames, {4 * FRAMES} files, a worker was killed" in done.stdout
    assert hashes(folder) == hashes(local)


def test_temporal_filters_are_rejected(tmp_path):
    done = run(tmp_path / "frames", "--local", "--preset", "default")
    assert done.returncode == 1 and "temporal filter makes a frame depend" in done.stderr
    assert "Traceback" not in done.stderr and not any((tmp_path / "frames").iterdir())
