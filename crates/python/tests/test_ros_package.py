"""The ROS 2 package in ros/: its conversion of messages, with the message types of rosbags."""

import ast
import sys

import numpy as np
import pytest

import oaktwin
from conftest import ROOT

rosbags_typesys = pytest.importorskip("rosbags.typesys", reason="rosbags is not installed")
sys.path.append(str(ROOT / "ros/oaktwin_ros"))

from oaktwin_ros import conversion, settings  # noqa: E402

STORE = rosbags_typesys.get_typestore(rosbags_typesys.Stores.ROS2_JAZZY)
Time, Header = (STORE.types[name] for name in ("builtin_interfaces/msg/Time", "std_msgs/msg/Header"))
Image, CameraInfo, PointCloud2, PointField, Region = (
    STORE.types[f"sensor_msgs/msg/{name}"]
    for name in ("Image", "CameraInfo", "PointCloud2", "PointField", "RegionOfInterest")
)
HEADER = Header(Time(3, 5), "optical")


def image(encoding, array, step=None, *, big=False):
    """A message of an array (H, W, …) whose rows are `step` bytes apart."""
    array = np.ascontiguousarray(array)
    if big:
        array = array.astype(array.dtype.newbyteorder(">"))
    height, width = array.shape[:2]
    rows = array.view(np.uint8).reshape(height, -1)
    step = step or rows.shape[1]
    data = np.zeros((height, step), np.uint8)
    data[:, : rows.shape[1]] = rows
    return Image(HEADER, height, width, encoding, int(big), step, data.ravel())


def info(**changes):
    fields = {
        "header": HEADER,
        "height": 480,
        "width": 640,
        "distortion_model": "plumb_bob",
        "d": np.zeros(5),
        "k": np.array([400.0, 0, 319.5, 0, 401.0, 239.5, 0, 0, 1]),
        "r": np.eye(3).ravel(),
        "p": np.zeros(12),
        "binning_x": 0,
        "binning_y": 0,
        "roi": Region(0, 0, 0, 0, False),
    }
    return CameraInfo(**fields | changes)


@pytest.mark.parametrize("big", [False, True])
@pytest.mark.parametrize("padding", [0, 6])
def test_depth_is_read(big, padding):
    metres = np.array([[1.5, np.inf, 0.25], [np.nan, 0, 2]], np.float32)
    found = conversion.depth(image("32FC1", metres, 12 + padding, big=big))
    assert found.dtype == np.float32 and np.array_equal(found, metres, equal_nan=True)
    millimetres = np.array([[1500, 0, 65535], [1, 2, 3]], np.uint16)
    for encoding in ("16UC1", "mono16"):
        found = conversion.depth(image(encoding, millimetres, 6 + padding, big=big))
        assert found.dtype == np.uint16 and np.array_equal(found, millimetres)
    # The sensor takes what is read.
    sensor = oaktwin.DepthSensor(oaktwin.Device("OAK4-D"), hfov_deg=70)
    assert sensor(conversion.depth(image("32FC1", metres, big=big))).shape == (2, 3)


def test_a_last_row_may_end_with_its_pixels():
    message = image("16UC1", np.array([[1, 2], [3, 4]], np.uint16), 6)
    message.data = message.data[:10]
    assert np.array_equal(conversion.depth(message), [[1, 2], [3, 4]])


@pytest.mark.parametrize(
    ("changes", "expected"),
    [
        ({"encoding": "rgb8"}, "encoding: 'rgb8' is not an encoding of depth"),
        ({"step": 3}, "step: 3 bytes for rows of 4"),
        ({"width": 0}, "width, height: an image of 0x2"),
        ({"height": 3}, "data: 8 bytes instead of 12"),
        ({"height": 2**32 - 1, "width": 2**30, "step": 2**32 - 1}, "data: 8 bytes instead of"),
    ],
)
def test_wrong_images_are_rejected(changes, expected):
    message = image("16UC1", np.zeros((2, 2), np.uint16))
    for name, value in changes.items():
        setattr(message, name, value)
    with pytest.raises(ValueError) as raised:
        conversion.depth(message)
    assert str(raised.value).startswith(expected)


def test_colours_are_read():
    rgb = np.arange(24, dtype=np.uint8).reshape(2, 4, 3)
    assert np.array_equal(conversion.color(image("rgb8", rgb)), rgb)
    assert np.array_equal(conversion.color(image("bgr8", rgb[..., ::-1])), rgb)
    rgba = np.dstack([rgb, np.zeros((2, 4), np.uint8)])
    assert np.array_equal(conversion.color(image("rgba8", rgba)), rgb)
    assert np.array_equal(conversion.color(image("mono8", rgb[..., 0])), rgb[..., [0, 0, 0]])
    with pytest.raises(ValueError, match="not an encoding of 8-bit colours"):
        conversion.color(image("bayer_rggb8", rgb[..., 0]))


def test_cameras_are_read():
    camera = oaktwin.Camera(**conversion.camera(info()))
    assert camera.size == (640, 480) and camera.K[0, 2] == 319.5 and camera.lens == "pinhole"
    bent = oaktwin.Camera(**conversion.camera(info(d=np.array([0.1, 0, 0, 0, 0]))))
    assert bent.lens == "opencv" and bent.distortion[0] == 0.1
    fisheye = info(d=np.full(4, 0.1), distortion_model="equidistant")
    assert oaktwin.Camera(**conversion.camera(fisheye)).lens == "fisheye"


@pytest.mark.parametrize(
    ("changes", "expected"),
    [
        ({"k": np.zeros(9)}, "k: invalid camera matrix"),
        ({"k": np.full(9, np.nan)}, "k: invalid camera matrix"),
        ({"binning_x": 2}, "binning_x, binning_y, roi: "),
        ({"roi": Region(1, 0, 0, 0, False)}, "binning_x, binning_y, roi: "),
        ({"d": np.array([0.1]), "distortion_model": "ftheta"}, "distortion_model: 'ftheta' is unknown"),
    ],
)
def test_wrong_cameras_are_rejected(changes, expected):
    with pytest.raises(ValueError) as raised:
        conversion.camera(info(**changes))
    assert str(raised.value).startswith(expected)


def test_stamps():
    assert conversion.nanoseconds(Time(3, 5)) == 3_000_000_005
    for wrong in (Time(-1, 0), Time(0, 10**9)):
        with pytest.raises(ValueError, match="header.stamp"):
            conversion.nanoseconds(wrong)


def test_measured_depth_round_trips_through_cdr():
    metres = np.array([[1.2345, 0, 70.0]], np.float32)
    for measured in (metres, conversion.millimetres(metres)):
        message = Image(header=HEADER, **conversion.depth_fields(measured))
        again = STORE.deserialize_cdr(STORE.serialize_cdr(message, "sensor_msgs/msg/Image"), "sensor_msgs/msg/Image")
        found = conversion.depth(again)
        expected = np.where(metres > 0, metres, np.nan) if measured is metres else [[1234, 0, 0]]
        assert np.array_equal(found, expected, equal_nan=measured is metres)
    message = CameraInfo(header=HEADER, roi=Region(0, 0, 0, 0, False), **conversion.info_fields((640, 480), np.diag([4.0, 4, 1])))
    again = STORE.deserialize_cdr(STORE.serialize_cdr(message, "sensor_msgs/msg/CameraInfo"), "sensor_msgs/msg/CameraInfo")
    assert np.array_equal(conversion.camera(again)["K"], np.diag([4.0, 4, 1])) and len(again.p) == 12


def test_points_are_those_of_the_camera():
    camera = oaktwin.Camera((6, 4), hfov_deg=60)
    metres = np.linspace(1, 2, 24, dtype=np.float32).reshape(4, 6)
    metres[1, 2] = 0
    points = conversion.cloud(metres, camera.K)
    assert np.isnan(points[1, 2]).all()
    assert np.allclose(points[metres > 0], camera.unproject(metres)[metres > 0], atol=1e-6)
    message = PointCloud2(header=HEADER, **conversion.cloud_fields(points, PointField))
    again = STORE.deserialize_cdr(STORE.serialize_cdr(message, "sensor_msgs/msg/PointCloud2"), "sensor_msgs/msg/PointCloud2")
    assert np.array_equal(np.frombuffer(again.data, "<f4").reshape(4, 6, 3), points, equal_nan=True)
    assert not again.is_dense and [field.name for field in again.fields] == ["x", "y", "z"]


def test_parameters_are_the_options_of_the_sensor():
    stub = (ROOT / "crates/python/python/oaktwin/_sensors.pyi").read_text()
    (sensor,) = (node for node in ast.parse(stub).body if isinstance(node, ast.ClassDef) and node.name == "DepthSensor")
    new = next(node for node in sensor.body if isinstance(node, ast.FunctionDef) and node.name == "__new__")
    of_images = {"sensor", "fx", "hfov_deg", "camera", "name"}
    assert set(settings.OPTIONS) - {"params"} == {argument.arg for argument in new.args.kwonlyargs} - of_images
    defaults = oaktwin.DepthSensor(oaktwin.Device("OAK4-D"), **settings.arguments(settings.OPTIONS))
    assert defaults.parameters == oaktwin.DepthSensor(oaktwin.Device("OAK4-D")).parameters
    changed = settings.arguments({"parameters": ["jitter=0.1"], "preset": "robotics", "device_seed": 3, "filters": ["speckle"]})
    sensor = oaktwin.DepthSensor(oaktwin.Device("OAK-D Pro PoE"), **changed)
    assert sensor.parameters["jitter"] == 0.1 and sensor.filters[0].startswith("speckle")
    with pytest.raises(ValueError, match="invalid assignment"):
        settings.arguments({"parameters": ["jitter"]})


def test_every_file_of_the_package_is_python():
    # The node needs rclpy, and the launch file launch, which are not here: only their syntax is checked.
    files = list((ROOT / "ros").rglob("*.py"))
    assert len(files) >= 6
    for path in files:
        compile(path.read_text(), path, "exec")
