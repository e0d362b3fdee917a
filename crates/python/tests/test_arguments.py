"""What arguments accept, and how errors name them."""

import json
import re
import sys

import numpy as np
import pytest

import oaktwin

PARAMETERS = 'engine = "stereo-noise"\n[parameters]\nbias = 0.25\n'


def test_parameters_are_a_mapping_a_file_or_a_fit(device, tmp_path):
    path = tmp_path / "unit.toml"
    path.write_text(PARAMETERS)
    fitted = oaktwin.Fit({"parameters": []}, PARAMETERS)
    for given in [{"bias": 0.25}, path, str(path), fitted]:
        sensor = oaktwin.DepthSensor(device, parameters=given)
        assert sensor.parameters["bias"] == 0.25 and sensor.engine == "stereo-noise"
    rows = oaktwin.accuracy(device, parameters=fitted, distances=[1], devices=1, captures=1).rows
    assert rows == oaktwin.accuracy(device, parameters={"bias": 0.25}, distances=[1], devices=1, captures=1).rows
    with pytest.raises(oaktwin.Error, match="^parameters: is a text of several lines, not a path; pass a mapping .*, or a Fit$"):
        oaktwin.DepthSensor(device, parameters=PARAMETERS)
    with pytest.raises(oaktwin.Error, match="^parameters: invalid value 3; pass a mapping"):
        oaktwin.DepthSensor(device, parameters=3)
    with pytest.raises(oaktwin.Error, match="^parameters: invalid value 1; pass names as keys"):
        oaktwin.DepthSensor(device, parameters={1: 2})
    with pytest.raises(oaktwin.Error, match="^parameters: engine: .*stereo-noise, but single-view is chosen"):
        oaktwin.DepthSensor(device, parameters=fitted, engine="single-view")
    with pytest.raises(oaktwin.Error, match="^parameters: are those of stereo-noise; pass those of stereo-matching"):
        oaktwin.StereoMatcher(device, parameters=fitted)
    with pytest.raises(TypeError, match="params"):
        oaktwin.DepthSensor(device, params=path)


def test_a_name_is_not_a_device(device):
    calls = [
        oaktwin.DepthSensor,
        oaktwin.Rig,
        oaktwin.StereoMatcher,
        oaktwin.accuracy,
        lambda given: oaktwin.simulate_imu(given, [0, 1], np.tile(np.eye(4), (2, 1, 1))),
        lambda given: oaktwin.Scene.from_triangles(np.eye(3), [[0, 1, 2]]).render_pair(given, np.eye(4)),
    ]
    for call in calls:
        with pytest.raises(oaktwin.Error, match=re.escape("device: invalid value 'OAK4-D'; pass oaktwin.Device(\"OAK4-D\")")):
            call("OAK4-D")
        with pytest.raises(oaktwin.Error, match="device: invalid value 5; pass oaktwin.Device"):
            call(5)


def test_drift_is_a_mapping_or_text(device):
    wall = np.full((60, 106), 2.0, np.float32)
    expected = oaktwin.DepthSensor(device, drift="yaw=0.3,baseline=50")(wall)
    assert np.array_equal(oaktwin.DepthSensor(device, drift={"yaw": 0.3, "baseline": 50})(wall), expected)
    with pytest.raises(oaktwin.Error, match="drift: invalid value 0.3; pass a mapping such as"):
        oaktwin.DepthSensor(device, drift=0.3)


class Handler:
    """DepthAI's CalibrationHandler."""

    def __init__(self, path):
        self.path = path

    def eepromToJson(self):
        return json.loads(self.path.read_text())


def test_calibrations_from_anything(calibration):
    text = calibration.read_text()
    expected = oaktwin.Device.from_calibration(calibration)
    assert expected.origin == calibration.name
    for given in [str(calibration), text, text.encode(), json.loads(text), Handler(calibration)]:
        unit = oaktwin.Device.from_calibration(given)
        assert unit.name == expected.name
        for role, camera in unit.cameras.items():
            assert np.array_equal(camera.K, expected.cameras[role].K)
    with pytest.raises(oaktwin.Error, match="^calibration: 1:2: "):
        oaktwin.Device.from_calibration("{")
    with pytest.raises(oaktwin.Error, match="^calibration: invalid value 3; pass the path"):
        oaktwin.Device.from_calibration(3)
    with pytest.raises(FileNotFoundError, match="none.json"):
        oaktwin.Device.from_calibration("none.json")


def test_depthais_handler(calibration):
    dai = pytest.importorskip("depthai")
    unit = oaktwin.Device.from_calibration(dai.CalibrationHandler(str(calibration)))
    expected = oaktwin.Device.from_calibration(calibration)
    for role, camera in unit.cameras.items():
        assert np.allclose(camera.K, expected.cameras[role].K, rtol=1e-6)


def test_a_file_is_not_a_model(calibration):
    for name in ["cal.json", str(calibration)]:
        with pytest.raises(oaktwin.Error, match=f"{name}: is a file, not a model; use Device.from_calibration"):
            oaktwin.Device(name)


def test_a_model_that_stands_for_another():
    with pytest.warns(oaktwin.FindingWarning, match="D435.*has no inertial sensor"):
        device = oaktwin.Device("D435")
    assert device.name == "RealSense D435i" and [finding.code for finding in device.findings] == ["stand-in"]
    assert not oaktwin.Device("D435i").findings


def test_sizes_are_pairs_or_numbers():
    camera = oaktwin.Camera((64, 48), hfov_deg=60)
    assert oaktwin.Camera(64, 48, hfov_deg=60) == camera == oaktwin.Camera(np.array([64, 48]), hfov_deg=60)
    assert camera.resized((32, 24)) == camera.resized(32, 24)
    assert camera.cropped(1, 2, (30, 20)) == camera.cropped(1, 2, 30, 20)
    for wrong in [lambda: oaktwin.Camera(64, hfov_deg=60), lambda: camera.resized(32)]:
        with pytest.raises(oaktwin.Error, match="size: .*pass .width, height."):
            wrong()


def test_parts_of_an_image_are_within_it():
    camera = oaktwin.Camera((64, 48), hfov_deg=60)
    assert camera.cropped(0.5, 0, 63, 48).size == (63, 48)
    for part in [(-1, 0, 10, 10), (0, 0, 65, 48), (60, 0, 5, 5), (0, 40.5, 5, 8), (np.nan, 0, 5, 5)]:
        with pytest.raises(oaktwin.Error, match="are not within the image, 64x48; pass a part of the image"):
            camera.cropped(*part)


def test_type_errors_name_the_argument(device):
    scene = oaktwin.Scene.from_triangles(np.eye(3), [[0, 1, 2]])
    camera, mesh = device.cameras["left"], oaktwin.Mesh(np.eye(3), [[0, 1, 2]])
    for name, call in {
        "device": lambda: oaktwin.DepthSensor("OAK4-D"),
        "hfov_deg": lambda: oaktwin.DepthSensor(device, hfov_deg="wide"),
        "camera": lambda: scene.render(device, np.eye(4)),
        "rgb": lambda: oaktwin.DepthSensor(device)(np.ones((4, 4)), "x"),
        "frame": lambda: oaktwin.DepthSensor(device)(np.ones((4, 4)), frame=0.5),
        "seed": lambda: oaktwin.DepthSensor(device, seed="a"),
        "imager": lambda: scene.render_pair(device, np.eye(4), imager={1: 2}),
        "device_seed": lambda: scene.render_pair(device, np.eye(4), device_seed="a"),
        "devices": lambda: oaktwin.coverage(scene, ["OAK4-D"], np.eye(4)),
        "height": lambda: oaktwin.coverage(scene, device, np.eye(4), height=1.0),
        "region_box": lambda: oaktwin.coverage(scene, device, np.eye(4), region_box=1.0),
        "labels": lambda: oaktwin.Scene.from_meshes({"a": mesh}, labels={"a": 1}),
        "poses": lambda: oaktwin.Scene.from_meshes({"a": mesh}, poses={"a": "b"}),
        "xyz": lambda: device.export("out", "urdf", xyz=1),
        "filters": lambda: oaktwin.Filter(3),
        "source": lambda: device.extrinsics(1, "left"),
        "count": lambda: device.population("a"),
        "points": lambda: camera.project("x"),
        "model": lambda: oaktwin.Device(3),
        "path": lambda: oaktwin.Recording(3),
        "recordings": lambda: oaktwin.fit(device, [3]),
        "distances": lambda: oaktwin.accuracy(device, distances=3),
    }.items():
        with pytest.raises((TypeError, oaktwin.Error)) as raised:
            call()
        # Notes exist since Python 3.11.
        if sys.version_info >= (3, 11) or isinstance(raised.value, oaktwin.Error):
            said = [str(raised.value), *getattr(raised.value, "__notes__", [])]
            assert any(re.search(rf"\b{name}\b", text) for text in said), said
