"""Checks the example against DepthAI's API, and its guide and fit with a unit whose errors are known."""

import ast
import importlib.util
import re
import shutil
from unittest import mock

import numpy as np
import pytest

import oaktwin
from conftest import ROOT

EXAMPLE = ROOT / "examples/python/record_wall.py"
KNOWN = {"bias": -0.18, "pixelLocking": 0.09, "jitter": 0.06}


@pytest.fixture(scope="module")
def example():
    spec = importlib.util.spec_from_file_location("record_wall", EXAMPLE)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture
def unit(calibration):
    return oaktwin.Device.from_calibration(calibration)


class Wall:
    """A wall as a unit with known errors measures it; `at` is its distance, and `slope` its slope to the right."""

    def __init__(self, device, at=1.0, slope=0.0):
        self.sensor = oaktwin.DepthSensor(device, parameters=KNOWN)
        self.camera = device.depth_camera().resized(320, 200, rule="depthai")
        self.at, self.slope, self.frame = at, slope, 0

    def __call__(self):
        x = self.camera.rays()[..., 0] / self.camera.rays()[..., 2]
        # z = at + slope * X, with X = x * z.
        depth = (self.at / (1 - self.slope * x)).astype(np.float32)
        self.frame += 1
        return np.round(1000 * self.sensor(depth, frame=self.frame)).astype(np.uint16)


def test_every_name_exists_in_depthai():
    dai = pytest.importorskip("depthai")
    tree, names = ast.parse(EXAMPLE.read_text(encoding="utf-8")), set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Attribute) and re.match(r"dai\.\w", text := ast.unparse(node)) and "(" not in text:
            names.add(text)
    assert len(names) >= 8, names
    for name in names:
        found = dai
        for part in name.split(".")[1:]:
            found = getattr(found, part)


@pytest.mark.parametrize("platform", ["RVC2", "RVC4"])
def test_the_pipeline_uses_only_members_of_depthai(example, platform):
    dai = pytest.importorskip("depthai")
    made = []

    class Pipeline:
        def __init__(self, device):
            self.device = device

        def create(self, kind):
            node = mock.create_autospec(kind, instance=True)
            if kind is dai.node.Camera:
                node.build.return_value = node
                node.requestOutput.return_value = mock.create_autospec(dai.Node.Output, instance=True)
            else:
                # Attributes that pybind11 declares without a type.
                node.left, node.right = object(), object()
                node.depth = mock.create_autospec(dai.Node.Output, instance=True)
                node.initialConfig = dai.StereoDepthConfig()
            made.append(node)
            return node

    device = mock.create_autospec(dai.Device, instance=True)
    device.getPlatform.return_value = getattr(dai.Platform, platform)
    with mock.patch.object(dai, "Pipeline", Pipeline):
        pipeline, queue = example.pipeline_of(dai, device)
    stereo, left, right = made
    assert pipeline.device is device and queue is stereo.depth.createOutputQueue.return_value
    left.build.assert_called_once_with(dai.CameraBoardSocket.CAM_B)
    right.build.assert_called_once_with(dai.CameraBoardSocket.CAM_C)
    left.requestOutput.return_value.link.assert_called_once_with(stereo.left)
    config = stereo.initialConfig
    assert config.getMedianFilter() == dai.StereoDepthConfig.MedianFilter.MEDIAN_OFF
    processing = config.postProcessing
    assert not (processing.speckleFilter.enable or processing.spatialFilter.enable or processing.temporalFilter.enable)
    assert processing.decimationFilter.decimationFactor == 1
    assert stereo.setSubpixelFractionalBits.called == (platform == "RVC2")
    # The arguments that the example passes exist in the overloads.
    for method, words in [
        (dai.node.Camera.requestOutput, ["size", "type", "fps"]),
        (dai.Node.Output.createOutputQueue, ["maxSize", "blocking"]),
        (dai.Device.setIrLaserDotProjectorIntensity, ["intensity"]),
        (dai.CalibrationHandler.eepromToJsonFile, ["destPath"]),
    ]:
        assert all(word in method.__doc__ for word in words), method.__doc__


def test_the_guide_records_what_fit_reads(example, unit, calibration, tmp_path, capsys):
    shutil.copy(calibration, tmp_path / "calibration.json")
    wall, distances = Wall(unit), example.suggested(unit, farthest=3.0)
    assert len(distances) == 16 and distances == sorted(distances) and 0.35 < distances[0] and distances[-1] < 3.3
    answers = iter(["s", "0,78", *[""] * 14])

    def watch(device, next_image):
        planned = re.findall(r"Place the camera (\S+) m", capsys.readouterr().out)[-1]
        wall.at = float(planned)

    def ask(_):
        answer = next(answers)
        if answer not in ("s", ""):
            wall.at = float(answer.replace(",", "."))
        return answer

    example.guide(unit, wall, tmp_path, distances, 6, ask=ask, watch=watch)
    rows = example.recorded(tmp_path)
    assert len(rows) == 15 and rows[0][1] == 0.78 and rows[-1][1] == distances[-1]
    stored = np.load(tmp_path / rows[3][0])
    assert stored.shape == (6, 200, 320) and stored.dtype == np.float32 and abs(np.median(stored) / rows[3][1] - 1) < 0.03
    fitted = example.fit_and_show(unit, tmp_path, {})
    for name, value in KNOWN.items():
        assert abs(fitted.parameters[name] - value) < 0.03, fitted.parameters
    shown = capsys.readouterr().out
    assert "bias" in shown and shown.count(" m ") >= 15 and "unit.toml" in shown
    again = oaktwin.DepthSensor(unit, parameters=tmp_path / "unit.toml")
    assert again.parameters["bias"] == pytest.approx(fitted.parameters["bias"], rel=1e-3)


def test_what_the_camera_sees_becomes_advice(example, unit):
    distance, tilt, fill = example.view_of(unit, Wall(unit, at=1.5, slope=np.tan(np.radians(4.0)))())
    assert abs(distance - 1.5) < 0.03 and abs(tilt[0] - 4) < 0.6 and abs(tilt[1]) < 0.5 and fill > 0.9
    # The right side is farther: the camera looks too far to the right.
    assert re.fullmatch(r"turn the camera [34]\.\d deg to the left", example.advice(tilt, fill))
    assert example.advice((0.2, -0.3), 0.99) == ""
    assert "tilt it 2.0 deg down" in example.advice((0, -2.0), 1.0) and "add texture" in example.advice((0, 0), 0.4)
    nothing = example.view_of(unit, np.zeros((200, 320), np.uint16))
    assert nothing[0] is None and nothing[2] == 0
