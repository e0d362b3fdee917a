import copy
import json
import pickle
import re

import numpy as np
import pytest

import oaktwin
from conftest import ROOT


def test_models(program):
    assert oaktwin.models() == [model["name"] for model in json.loads(program("models", "--json"))]
    for name in oaktwin.models():
        assert oaktwin.Device(name).name == name
    assert oaktwin.Device("oak d-pro_POE").name == "OAK-D Pro PoE"


def test_models_by_maker_and_depth():
    assert oaktwin.models(maker="stereolabs") == ["ZED 2i", "ZED Mini", "ZED X"]
    assert oaktwin.models(depth="none") == [
        "OAK4-CS",
        "OAK4-S",
        "OAK-1",
        "OAK-1 Lite",
        "OAK-1 MAX",
        "OAK-1 W",
        "OAK Thermal",
    ]
    assert oaktwin.models(maker="Luxonis", depth="tof") == ["OAK-D ToF"]
    with pytest.raises(oaktwin.Error, match="unknown maker 'Luxsonis'; did you mean 'Luxonis'?"):
        oaktwin.models(maker="Luxsonis")
    with pytest.raises(oaktwin.Error, match="depth: invalid value 'lidar'"):
        oaktwin.models(depth="lidar")


def test_a_device_with_three_stereo_pairs():
    device = oaktwin.Device("OAK-D LR")
    baselines = {name: spec["baseline_mm"] for name, spec in device.depth_sensors.items()}
    assert baselines == {"stereo": 150, "Camera_pseudo_depth_100mm": 100, "Camera_pseudo_depth_50mm": 50}
    near, far = device.depth_camera("Camera_pseudo_depth_50mm"), device.depth_camera()
    # The centre camera is 25 mm to the right of the body's origin, the left one 75 mm to the left.
    assert near.body_from_camera[1, 3] == -0.025 and far.body_from_camera[1, 3] == 0.075
    depth = np.full((80, 128), 2, np.float32)
    for name in baselines:
        assert (oaktwin.DepthSensor(device, sensor=name)(depth) > 0).any()


def test_a_device_without_depth():
    device = oaktwin.Device("OAK-1")
    assert device.depth_sensors == {} and list(device.cameras) == ["rgb"]
    with pytest.raises(oaktwin.Error, match="OAK-1 has no depth sensor; choose a model with one: OAK-D Pro PoE, "):
        oaktwin.DepthSensor(device)
    with pytest.raises(oaktwin.Error, match="imu"):
        device.extrinsics("imu", "rgb")


def test_a_device_is_what_the_program_shows(program, device):
    shown = json.loads(program("show", "OAK4-D", "--json"))
    assert device.report() == (shown[0] if isinstance(shown, list) else shown)
    assert repr(device) == "<oaktwin.Device OAK4-D (nominal): cameras rgb, left, right; depth stereo>"
    assert device.origin == "nominal" and device.findings == []


def test_cameras(device):
    assert sorted(device.cameras) == ["left", "rgb", "right"]
    left = device.cameras["left"]
    assert left.size == (1280, 800) == (left.width, left.height)
    fx = 640 / np.tan(np.radians(77 / 2))
    assert np.allclose(left.K, [[fx, 0, 639.5], [0, fx, 399.5], [0, 0, 1]], atol=1e-9)
    assert left.K.dtype == np.float64
    assert left.hfov_deg == pytest.approx(77) and left.lens == "pinhole" and left.distortion.shape == (0,)
    # The camera's x axis is the body's −y, its y axis −z, its z axis x.
    expected = [[0, 0, 1, 0], [-1, 0, 0, 0.0375], [0, -1, 0, 0], [0, 0, 0, 1]]
    assert np.array_equal(left.body_from_camera, expected)
    assert repr(left) == "<oaktwin.Camera left: 1280x800, fx 804.59 px, 77.00° x 52.87°, pinhole>"
    assert device.depth_camera("stereo").size == (1280, 800)
    assert set(oaktwin.Device("OAK-D ToF").depth_sensors) == {"stereo", "tof"}
    assert oaktwin.Device("OAK-D ToF").depth_camera().size != (1280, 800)


def test_resized_and_cropped(device):
    left = device.cameras["left"]
    small = left.resized(640, 400, rule="depthai")
    assert np.allclose(small.K[:2], left.K[:2] / 2) and small.size == (640, 400)
    assert left.resized(1280, 720).K[1, 2] == left.K[1, 2] - 40
    assert np.allclose(left.resized(640, 800, keep_aspect_ratio=False, rule="depthai").K[:2], left.K[:2] * [[0.5], [1]])
    part = left.cropped(100, 50, 640, 400)
    assert part.size == (640, 400) and np.allclose(left.K - part.K, [[0, 0, 100], [0, 0, 50], [0, 0, 0]])
    for bad in [(0, 4), (4, 0), (1 << 16, 1 << 16)]:
        with pytest.raises(oaktwin.Error, match="an image of"):
            left.resized(*bad)
    with pytest.raises(oaktwin.Error, match="are not within the image"):
        left.cropped(float("nan"), 0, 3, 3)
    with pytest.raises(oaktwin.Error, match="width: invalid value -1"):
        left.resized(-1, 3)


def test_extrinsics(device):
    right_from_left = device.extrinsics("left", "right")
    assert np.allclose(right_from_left, [[1, 0, 0, -0.075], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
    assert np.allclose(device.extrinsics("right", "left") @ right_from_left, np.eye(4))
    assert np.array_equal(device.extrinsics("left", "body"), device.cameras["left"].body_from_camera)
    assert device.extrinsics("imu", "rgb").shape == (4, 4)
    with pytest.raises(oaktwin.Error, match="OAK4-D: unknown camera or part 'lefft'; did you mean 'left'"):
        device.extrinsics("lefft", "right")


def test_a_calibrated_unit(program, calibration):
    unit = oaktwin.Device.from_calibration(calibration)
    assert unit.name == "OAK-D Pro PoE" and unit.origin == calibration.name
    assert unit.cameras["left"].lens == "opencv" and unit.cameras["left"].distortion.shape == (14,)
    assert np.array_equal(unit.extrinsics("left", "rgb"), oaktwin.Device.from_calibration(
        str(calibration), "OAK-D Pro PoE").extrinsics("left", "rgb"))
    shown = json.loads(program("show", "OAK-D Pro PoE", "--calibration", calibration, "--json"))
    shown = shown[0] if isinstance(shown, list) else shown
    assert unit.report() == shown
    assert [finding.code for finding in unit.findings] == [finding["code"] for finding in shown["findings"]]
    # The inverse of the rectification gives the raw extrinsics.
    pair = unit.rectification()
    assert np.allclose(pair.R1 @ pair.R1.T, np.eye(3)) and pair.baseline == pytest.approx(0.075, abs=0.002)
    with pytest.raises(oaktwin.Error):
        oaktwin.Device.from_calibration(calibration, "OAK-D ToF")


def test_invalid_calibrations(tmp_path, program):
    with pytest.raises(FileNotFoundError, match="there is no such file; check the path"):
        oaktwin.Device.from_calibration(tmp_path / "none.json")
    with pytest.raises(IsADirectoryError):
        oaktwin.Device.from_calibration(tmp_path)
    (tmp_path / "bad.json").write_text("{")
    with pytest.raises(oaktwin.Error) as raised:
        oaktwin.Device.from_calibration(tmp_path / "bad.json", "OAK4-D")
    said = program("show", "OAK4-D", "--calibration", tmp_path / "bad.json", code=2)
    assert said == f"error: {raised.value}\n"


def test_rectification(device):
    pair = device.rectification()
    left = device.cameras["left"]
    assert np.array_equal(pair.R1, np.eye(3)) and np.allclose(pair.P1[:, :3], left.K)
    assert np.allclose(pair.P2[0, 3], -left.K[0, 0] * 0.075)
    maps = pair.maps("left")
    assert maps.shape == (800, 1280, 2) and maps.dtype == np.float32
    y, x = np.mgrid[:800, :1280]
    assert np.allclose(maps, np.stack([x, y], -1), atol=1e-3)
    d = 12.5
    x, y, z, w = pair.Q @ [700.0, 300.0, d, 1.0]
    assert z / w == pytest.approx(left.K[0, 0] * 0.075 / d)
    assert device.rectification(intrinsics="left-camera").P2.shape == (3, 4)
    with pytest.raises(oaktwin.Error, match="camera: invalid value 'rgb'"):
        pair.maps("rgb")
    with pytest.raises(oaktwin.Error, match="did you mean"):
        device.rectification(intrinsics="left-camra")


@pytest.mark.filterwarnings("ignore::oaktwin.FindingWarning")
def test_exports_are_the_programs(program, tmp_path, calibration):
    unit = oaktwin.Device.from_calibration(calibration)
    for name in ["ros", "opencv", "kalibr", "depthai"]:
        folder = tmp_path / name
        folder.mkdir()
        program("calibration", "export", calibration, "--to", name, "-o", f"{folder}/")
        written = {file.name: file.read_text() for file in folder.iterdir()}
        assert getattr(unit, f"to_{name}")() == written
    assert list(oaktwin.Device("OAK4-D").to_ros()) == ["rgb.yaml", "left.yaml", "right.yaml"]


def test_usd(program, tmp_path, device):
    device.write_usd(tmp_path / "ours.usd", isaac="6", rigid_body=True)
    program("asset", "OAK4-D", "--isaac", "6", "--rigid-body", "-o", tmp_path / "theirs.usd")
    assert (tmp_path / "ours.usd").read_bytes() == (tmp_path / "theirs.usd").read_bytes()
    device.write_usd(str(tmp_path / "ours.usdz"), body=False)
    assert (tmp_path / "ours.usdz").read_bytes()[:2] == b"PK"
    with pytest.raises(oaktwin.Error, match=r"\.obj is not a USD format"):
        device.write_usd(tmp_path / "ours.obj")
    with pytest.raises(FileNotFoundError, match="make the folder first"):
        device.write_usd(tmp_path / "no/ours.usd")
    with pytest.raises(oaktwin.Error, match="isaac: invalid value '4.5'"):
        device.write_usd(tmp_path / "ours.usd", isaac="4.5")
    with pytest.raises(oaktwin.Error):
        oaktwin.Device("OAK-D ToF").write_usd(tmp_path / "ours.usd", extended_disparity=True)


@pytest.mark.filterwarnings("ignore::oaktwin.FindingWarning")
def test_overrides(program, tmp_path, calibration):
    (tmp_path / "vendor").mkdir()
    base = tmp_path / "vendor/oak.usda"
    nominal, device = oaktwin.Device("OAK-D Pro PoE"), oaktwin.Device.from_calibration(calibration)
    nominal.write_usd(base)
    device.write_usd(tmp_path / "ours.usda", over=base)
    program("asset", "OAK-D Pro PoE", "--calibration", calibration, "--over", base, "-o", tmp_path / "theirs.usda")
    with pytest.raises(oaktwin.Error, match="nothing to override"):
        nominal.write_usd(tmp_path / "none.usda", over=base)
    text = (tmp_path / "ours.usda").read_text()
    assert text == (tmp_path / "theirs.usda").read_text() and "./vendor/oak.usda" in text
    for error, said, over in [
        (FileNotFoundError, "none.usd", tmp_path / "none.usd"),
        (oaktwin.Error, "is the asset to override", tmp_path / "ours.usda"),
    ]:
        with pytest.raises(error, match=said):
            device.write_usd(tmp_path / "ours.usda", over=over)
    (tmp_path / "empty.usda").write_text("#usda 1.0\n")
    with pytest.raises(oaktwin.Error, match="empty.usda"):
        device.write_usd(tmp_path / "ours.usda", over=tmp_path / "empty.usda")
    with pytest.raises(oaktwin.Error, match="scene_limit: must be a finite number > 0"):
        device.write_usd(tmp_path / "ours.usda", over=base, scene_limit=0)
    with pytest.raises(oaktwin.Error, match="raise scene_limit from 0.000001"):
        device.write_usd(tmp_path / "ours.usda", over=base, scene_limit=1e-6)
    assert (tmp_path / "ours.usda").read_text() == text


def test_a_catalog_of_ones_own(program, tmp_path):
    built_in = ROOT / "crates/catalog/data/devices/oak4_d.toml"
    own = built_in.read_text().replace('id = "oak4_d"', 'id = "mine"').replace('name = "OAK4-D"', 'name = "Mine"')
    own = re.sub(r'^aliases = .*$', 'aliases = ["My own"]', own.replace('prim = "oak4_d"', 'prim = "mine"'), flags=re.M)
    (tmp_path / "mine.toml").write_text(own)
    assert oaktwin.models(catalog=tmp_path) == [*oaktwin.models(), "Mine"]
    device = oaktwin.Device("mine", catalog=tmp_path)
    shown = json.loads(program("--catalog", tmp_path, "show", "Mine", "--json"))
    assert device.report() == (shown[0] if isinstance(shown, list) else shown)
    assert copy.deepcopy(device).report() == device.report()
    with pytest.raises(oaktwin.Error):
        oaktwin.Device("Mine")
    for folder, exception in [(tmp_path / "none", FileNotFoundError), (tmp_path / "mine.toml", oaktwin.Error)]:
        with pytest.raises(exception):
            oaktwin.Device("Mine", catalog=folder)
    (tmp_path / "bad.toml").write_text("id =")
    with pytest.raises(oaktwin.Error, match="bad.toml"):
        oaktwin.models(catalog=tmp_path)


def test_findings_are_warnings(tmp_path):
    # ROS does not support all coefficients of a tilted lens.
    camera = json.loads(oaktwin.Device("OAK-D Pro PoE").to_depthai()["calibration.json"])
    for _, one in camera["cameraData"]:
        one["distortionCoeff"] = [0.01] * 5 + [0.0] * 7 + [0.02, 0.01]
    (tmp_path / "tilted.json").write_text(json.dumps(camera))
    unit = oaktwin.Device.from_calibration(tmp_path / "tilted.json", force=True)
    with pytest.warns(oaktwin.FindingWarning, match="distortion-fitted"):
        unit.to_ros()


def test_cameras_of_ones_own():
    wide = oaktwin.Camera((640, 480), hfov_deg=90, name="mine")
    assert wide.K[0, 0] == pytest.approx(320) and wide.name == "mine" and wide.clip == (0.01, 1e7)
    same = oaktwin.Camera((640, 480), K=wide.K, distortion=[0.1, -0.05])
    assert same.lens == "opencv" and list(same.distortion[:3]) == [0.1, -0.05, 0]
    assert oaktwin.Camera((640, 480), K=wide.K, lens="fisheye").distortion.shape == (4,)
    pose = oaktwin.look_at((0, 0, 0), (1, 0, 0), frame="camera")
    assert np.array_equal(oaktwin.Camera((4, 4), hfov_deg=9, body_from_camera=pose).body_from_camera, pose)
    bad = {
        "no pixel": dict(size=(0, 4), hfov_deg=3),
        "is out of range": dict(size=(4, 4), hfov_deg=180),
        "pass one of them": dict(size=(4, 4)),
        "3x3": dict(size=(4, 4), K=np.eye(4)),
        "not a camera matrix": dict(size=(4, 4), K=-np.eye(3)),
        "too short for its principal point": dict(size=(4, 4), K=np.diag([1e-300, 1e300, 1])),
        "is not an array of numbers": dict(size=(4, 4), K="K"),
        "coefficients": dict(size=(4, 4), hfov_deg=9, distortion=[0.0] * 15),
        "finite": dict(size=(4, 4), hfov_deg=9, distortion=[float("nan")]),
        "the model has at most 0": dict(size=(4, 4), hfov_deg=9, distortion=[0.1], lens="pinhole"),
        "not a valid range": dict(size=(4, 4), hfov_deg=9, near=2, far=1),
        "invalid value 'wide'": dict(size=(4, 4), hfov_deg=9, lens="wide"),
    }
    for text, arguments in bad.items():
        with pytest.raises(oaktwin.Error, match=text):
            oaktwin.Camera(**arguments)


def test_what_is_no_device():
    with pytest.raises(oaktwin.Error, match="did you mean OAK4-D"):
        oaktwin.Device("OAK4-E")
    with pytest.raises(oaktwin.Error, match="lens"):
        oaktwin.Device("OAK4-D", lens="telephoto")
    with pytest.raises(oaktwin.Error):
        oaktwin.Device("OAK4-D", lens="fisheye")
    assert oaktwin.Device("OAK4-D Wide", lens="fisheye").cameras["left"].lens == "fisheye"
    with pytest.raises(TypeError):
        oaktwin.Device(7)
    assert issubclass(oaktwin.Error, ValueError) and issubclass(oaktwin.FindingWarning, UserWarning)


def test_rectification_is_the_devices(calibration):
    """Its intrinsics are those of the images that the device's matcher sees."""
    for device in [oaktwin.Device("OAK4-D"), oaktwin.Device.from_calibration(calibration, "OAK-D Pro PoE")]:
        own = oaktwin.StereoMatcher(device).camera.K
        assert np.allclose(device.rectification().P1[:, :3], own, rtol=1e-9)
    # The unit's cameras differ, so that OpenCV's choice is another one.
    opencv = device.rectification(intrinsics="zero-disparity").P1[:, :3]
    assert not np.allclose(opencv, own, rtol=1e-4)
    # Another maker's has no processor that is known.
    other = oaktwin.Device("D435i")
    assert np.array_equal(other.rectification().P1, other.rectification(intrinsics="zero-disparity").P1)


def test_a_rig_is_of_no_model():
    content = json.loads((ROOT / "crates/calibration/fixtures/example-oak-d-pro-poe.json").read_text())
    content |= {"productName": "BENCH", "boardName": "FFC"}
    k = {socket: np.array(camera["intrinsicMatrix"]) for socket, camera in content["cameraData"]}
    rig = oaktwin.Device.from_calibration(content, pair=("CAM_B", "cam_c"), platform="rvc4")
    assert "no-model" in [finding.code for finding in rig.findings]
    assert np.allclose(rig.cameras["left"].K, k[1]) and np.allclose(rig.cameras["right"].K, k[2])
    matcher = oaktwin.StereoMatcher(rig)
    assert matcher.parameters["baseline"] == pytest.approx(0.0746, abs=5e-4)
    again = pickle.loads(pickle.dumps(rig))
    assert np.array_equal(again.cameras["left"].K, rig.cameras["left"].K)
    assert oaktwin.StereoMatcher(again).parameters == matcher.parameters
    with pytest.raises(oaktwin.Error, match="BENCH has no depth sensor"):
        oaktwin.DepthSensor(rig)
    for arguments, expected in [
        ({"pair": ("CAM_B", "CAM_X")}, "pair: 'CAM_X' is not a socket; pass names such as CAM_B"),
        ({"pair": ("CAM_B", "CAM_E")}, "CAM_E"),
        ({"pair": ("CAM_B", "CAM_C"), "model": "OAK-D"}, "pair: is for rigs"),
        ({"platform": "rvc4", "model": "OAK-D", "force": True}, "platform: is for rigs"),
        ({"platform": "rvc3"}, "platform: "),
    ]:
        with pytest.raises(oaktwin.Error, match=expected):
            oaktwin.Device.from_calibration(content, **arguments)
