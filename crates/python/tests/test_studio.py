"""The scripts that `oaktwin studio` exports give the images that its page shows."""

import io
import json
import os
import subprocess
import urllib.request

import numpy as np
import pytest

import oaktwin

PROGRAM = os.environ.get("OAKTWIN_BIN")

ROOM = """#usda 1.0
(
    metersPerUnit = 1
    upAxis = "Z"
)
def Cube "Crate"
{
    color3f[] primvars:displayColor = [(0.8, 0.5, 0.2)]
    double3 xformOp:translate = (2.5, 0.1, 0)
    float3 xformOp:rotateXYZ = (20, 30, 10)
    uniform token[] xformOpOrder = ["xformOp:translate", "xformOp:rotateXYZ"]
}
def Cube "Wall"
{
    double3 xformOp:translate = (6, 0, 0)
    double3 xformOp:scale = (0.1, 5, 4)
    uniform token[] xformOpOrder = ["xformOp:translate", "xformOp:scale"]
}
"""


@pytest.fixture(scope="module")
def studio(tmp_path_factory):
    if not PROGRAM:
        pytest.skip("OAKTWIN_BIN names no program")
    folder = tmp_path_factory.mktemp("studio")
    (folder / "room.usda").write_text(ROOM)
    process = subprocess.Popen(
        [PROGRAM, "studio", "room.usda", "--no-open"], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True
    )
    yield folder, process.stdout.readline().strip()
    process.kill()
    process.wait()


def export(link, **request):
    body = json.dumps({"scene": "first", "size": [320, 200], **request}).encode()
    with urllib.request.urlopen(urllib.request.Request(link + "api/export", body, method="POST")) as answer:
        return answer.read()


@pytest.mark.parametrize(
    "changes",
    [
        {"engine": "stereo-noise", "deviceSeed": 4, "filters": ["spatial:alpha=0.6"], "parameters": {"bias": "0.2"}},
        {"engine": "single-view", "parameters": {"noiseSigma": "0.5"}},
        {"model": "OAK-D Pro PoE", "engine": "stereo-matching", "preset": "ROBOTICS", "projector": 0.7, "ambient": 0.25, "seed": 3},
        {"populationSeed": 5, "drift": {"yaw": "0.3", "pitch": "-0.2"}},
        {"model": "OAK-D Pro PoE", "engine": "stereo-matching", "projector": 0.7, "populationSeed": 6, "drift": {"roll": "1"}},
        {"model": "OAK-D ToF", "sensor": "depth_tof", "engine": "time-of-flight"},
    ],
)
def test_the_script_reproduces_the_page(studio, monkeypatch, changes):
    folder, link = studio
    state = {
        "model": "OAK4-D",
        "calibration": None,
        "pose": {"position": [0, 0, 0.1], "quaternion": [0, 0.0871557427476582, 0, 0.9961946980917455]},
        "sensor": "depth_stereo",
        "lens": "pinhole",
        "engine": "stereo-noise",
        "preset": None,
        "filters": None,
        "parameters": {},
        "extendedDisparity": False,
        "seed": 0,
        "deviceSeed": None,
        "populationSeed": None,
        "drift": {},
        "projector": 0.0,
        "ambient": 1.0,
    }
    state.update(changes)
    shown = np.load(io.BytesIO(export(link, what="image", image="sensor", format="npy", state=state)))
    assert (shown > 0).any()
    script = export(link, what="python", state=state).decode()
    monkeypatch.chdir(folder)
    names = {}
    exec(script, names)
    assert np.array_equal(names["depth"], shown), script


def test_pixels_without_a_value_have_a_reason():
    device = oaktwin.Device("OAK4-D")
    depth = np.full((200, 320), 2.0, np.float32)
    depth[:, 100:140] = 0.8
    depth[:50] = np.inf
    sensor = oaktwin.DepthSensor(device, hfov_deg=77.0)
    outputs = sensor.annotate(depth, annotators=["depth_sensor_distance", "depth_sensor_reason"])
    codes = outputs["depth_sensor_reason"]
    assert codes.dtype == np.uint8 and codes.shape == depth.shape
    assert np.array_equal(codes == 0, outputs["depth_sensor_distance"] > 0)
    assert (codes[:50] == 1).all()
