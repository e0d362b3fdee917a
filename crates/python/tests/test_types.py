"""The stubs match the module, and a strictly typed program passes mypy."""

import os
import subprocess
import sys

import pytest

pytest.importorskip("mypy")

STRICT = '''
import numpy as np
import numpy.typing as npt
from typing_extensions import assert_type

import oaktwin
from oaktwin.typing import SensorOptions

device = oaktwin.Device("OAK4-D")
options: SensorOptions = {"engine": "stereo-noise", "filters": ["median"]}
oaktwin.DepthSensor(device, **options)
camera = device.cameras["left"].resized(640, 400)
assert_type(camera.K, npt.NDArray[np.float64])
sensor = oaktwin.DepthSensor(device, engine="stereo-noise", filters=["median"], parameters={"window": 5}, seed=1)
metres = np.zeros((4, 5), np.float32)
assert_type(sensor(metres), npt.NDArray[np.float32])
assert_type(sensor(metres.astype(np.uint16), frame=3), npt.NDArray[np.uint16])
sensor(metres.data).shape
out = np.zeros((4, 5), np.float32)
sensor(metres, out=out).sum()
assert_type(oaktwin.filters.temporal(alpha=0.4)(metres), npt.NDArray[np.float32])
scene = oaktwin.Scene.from_triangles(np.eye(3), np.array([[0, 1, 2]]))
frames = scene.render(camera, np.stack([oaktwin.look_at((0, 0, 0), (1, 0, 0))] * 2), annotators=["rgb"])
assert_type(frames["rgb"], npt.NDArray[np.uint8])
samples = oaktwin.simulate_imu(device, [0, 1], np.stack([np.eye(4)] * 2))
assert_type(samples["timestamp"], npt.NDArray[np.int64])
pair = scene.render_pair(device, np.eye(4), size=(64, 40))
link = oaktwin.Mesh(np.eye(3), np.array([[0, 1, 2]]), color=(1, 0, 0))
parts = oaktwin.Scene.from_meshes({"link": link}, poses={"link": np.eye(4)}, labels={"link": "arm"})
parts.set_pose("link", np.eye(4))
assert_type(parts.poses["/World/link"], npt.NDArray[np.float64])
pixels, depths = camera.project([[0, 0, 1]], np.eye(4))
assert_type(camera.resized(5, 4).unproject(metres), npt.NDArray[np.float32])
oaktwin.DepthSensor(device, preset=oaktwin.presets("rvc4")[0])
matched = oaktwin.StereoMatcher(device, preset="default")(pair["left"], pair["right"])
assert_type(matched["depth"], npt.NDArray[np.float32])
assert_type(matched["findings"], list[oaktwin.Finding])
assert_type(oaktwin.accuracy(device, distances=[1.0]).passed, bool)
assert_type(oaktwin.coverage(scene, device, np.eye(4), region="/World", height=[1.0], seed=1).ranking, list[int])
'''

WRONG = '''
import oaktwin
import oaktwin.typing

oaktwin.DepthSensor(oaktwin.Device("OAK4-D"), engine="none")
oaktwin.DepthSensor(oaktwin.Device("OAK4-D"), None)
options: oaktwin.typing.SensorOptions = {"engin": "stereo-noise"}
oaktwin.Device("OAK4-D").nme
oaktwin.StereoMatcher(fx=300, baseline=0.075, platform="rvc3")
'''


def python(tmp_path, *arguments):
    environment = {**os.environ, "MYPY_CACHE_DIR": str(tmp_path / "cache")}
    command = [sys.executable, "-m", *arguments]
    return subprocess.run(command, capture_output=True, text=True, cwd=tmp_path, env=environment)


def test_the_stubs_are_the_modules(tmp_path):
    # Modules for other packages have no stubs, because their classes derive from classes of these packages.
    (tmp_path / "allowed").write_text(r"oaktwin\.(depthai|gymnasium|isaaclab|mjlab|warp)(\..*)?" + "\n")
    options = ["--ignore-disjoint-bases", "--allowlist", "allowed", "--ignore-unused-allowlist"]
    done = python(tmp_path, "mypy.stubtest", "oaktwin", *options)
    assert done.returncode == 0, done.stdout + done.stderr


def test_strict_users(tmp_path):
    (tmp_path / "strict.py").write_text(STRICT)
    done = python(tmp_path, "mypy", "--strict", "strict.py")
    assert done.returncode == 0, done.stdout + done.stderr
    (tmp_path / "wrong.py").write_text(WRONG)
    done = python(tmp_path, "mypy", "--strict", "wrong.py")
    assert done.stdout.count("error:") == 5, done.stdout


def test_the_package_is_strict_itself(tmp_path):
    done = python(tmp_path, "mypy", "--strict", "-p", "oaktwin")
    assert done.returncode == 0, done.stdout + done.stderr


def test_the_sample_runs(tmp_path):
    (tmp_path / "strict.py").write_text(STRICT)
    done = subprocess.run([sys.executable, "strict.py"], capture_output=True, text=True, cwd=tmp_path)
    assert done.returncode == 0, done.stderr


def test_virtual_devices_are_typed(tmp_path):
    pytest.importorskip("depthai")
    done = python(tmp_path, "mypy", "--strict", "-p", "oaktwin.depthai")
    assert done.returncode == 0, done.stdout + done.stderr
