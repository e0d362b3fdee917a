"""Copies, pickles, and other processes."""

import copy
import json
import multiprocessing
import pickle

import numpy as np
import pytest

import oaktwin
from conftest import ROOT

WALL = np.array([[-50, -50, 3], [50, -50, 3], [0, 80, 3.1]]), np.array([[0, 1, 2]])


def copies(item):
    for protocol in range(2, pickle.HIGHEST_PROTOCOL + 1):
        yield pickle.loads(pickle.dumps(item, protocol))
    yield copy.copy(item)
    yield copy.deepcopy(item)


def same_camera(a, b):
    assert repr(a) == repr(b) and (a.name, a.size, a.lens, a.clip) == (b.name, b.size, b.lens, b.clip)
    for name in ["K", "distortion", "body_from_camera"]:
        assert getattr(a, name).tobytes() == getattr(b, name).tobytes()


def same_device(a, b):
    assert a.report() == b.report() and repr(a) == repr(b)
    assert [str(finding) for finding in a.findings] == [str(finding) for finding in b.findings]
    assert list(a.cameras) == list(b.cameras)
    for role in a.cameras:
        same_camera(a.cameras[role], b.cameras[role])


def test_cameras(device, calibration):
    unit = oaktwin.Device.from_calibration(calibration)
    turned = oaktwin.look_at((1, 2, 3), (0.3, 0, 0)).astype(np.float32)
    for camera in [
        *device.cameras.values(),
        *unit.cameras.values(),
        device.depth_camera().resized(333, 217),
        oaktwin.Device("OAK4-D Wide", lens="fisheye").cameras["right"],
        oaktwin.Camera((7, 5), hfov_deg=33.3, distortion=[0.1] * 8, body_from_camera=turned, near=0.2, far=9, name="ö"),
    ]:
        for other in copies(camera):
            same_camera(camera, other)


def test_devices(device):
    for model in oaktwin.models():
        one = oaktwin.Device(model)
        for other in copies(one):
            same_device(one, other)
    wide = oaktwin.Device("OAK4-D Wide", lens="fisheye")
    assert pickle.loads(pickle.dumps(wide)).cameras["left"].lens == "fisheye"


def test_a_unit_travels_with_its_calibration(tmp_path, calibration):
    file = tmp_path / calibration.name
    file.write_bytes(calibration.read_bytes())
    unit = oaktwin.Device.from_calibration(file)
    text = pickle.dumps(unit)
    file.unlink()
    for other in [pickle.loads(text), copy.deepcopy(unit)]:
        same_device(unit, other)
        assert other.to_depthai() == unit.to_depthai()
        assert np.array_equal(other.rectification().maps("left"), unit.rectification().maps("left"), equal_nan=True)


def test_rectifications(device, calibration):
    for pair in [device.rectification(), oaktwin.Device.from_calibration(calibration).rectification(intrinsics="left-camera")]:
        for other in copies(pair):
            assert repr(other) == repr(pair)
            for name in ["R1", "R2", "P1", "P2", "Q"]:
                assert getattr(other, name).tobytes() == getattr(pair, name).tobytes()


def test_filters():
    random = np.random.default_rng(0)
    image = random.integers(900, 1100, (20, 30)).astype(np.uint16)
    chain = oaktwin.Filter("spatial:alpha=0.3,delta=40", "median:size=5", "threshold:min=950,max=1050", "temporal:alpha=0.1")
    expected = chain(image)
    for other in copies(chain):
        assert str(other) == str(chain) and np.array_equal(other(image), expected)
    assert str(copy.copy(oaktwin.Filter())) == ""


@pytest.mark.parametrize(
    "options",
    [
        {},
        {"engine": "single-view", "parameters": {"noiseSigma": 0.4, "outlierRemovalEnabled": True}, "isaac": "6"},
        {"preset": "robotics", "seed": (1 << 64) - 1, "device_seed": 3, "extended_disparity": True},
        {"filters": ["median:size=5", "temporal"], "hfov_deg": 61.7, "name": "front"},
        {"fx": 99.9, "sensor": "stereo"},
    ],
)
def test_sensors(device, room, options):
    depth, rgb = room
    sensor = oaktwin.DepthSensor(device, **options)
    expected = sensor(depth, rgb, frame=5)
    sensor.reset()
    for other in copies(sensor):
        assert repr(other) == repr(sensor) and other.filters == sensor.filters
        assert np.array_equal(other(depth, rgb, frame=5), expected)
        assert other.parameters == sensor.parameters


def test_a_sensor_of_a_unit(calibration, room):
    sensor = oaktwin.DepthSensor(oaktwin.Device.from_calibration(calibration), seed=2)
    assert np.array_equal(pickle.loads(pickle.dumps(sensor))(room[0]), sensor(room[0], frame=0))


def test_a_pickle_has_not_seen_the_images(device, room):
    depth, _ = room
    sensor = oaktwin.DepthSensor(device, filters=["temporal"])
    first, second = sensor(depth, frame=0), sensor(depth, frame=1)
    other = copy.copy(sensor)
    assert np.array_equal(other(depth), first)
    assert np.array_equal(other(depth, frame=1), second) and not np.array_equal(copy.copy(sensor)(depth, frame=1), second)


def test_scenes(tmp_path):
    camera = oaktwin.Camera((40, 30), hfov_deg=60)
    stage = ROOT / "examples/depth_sensor/depth_sensor.usda"
    (tmp_path / "wall.obj").write_text("v -50 -50 30\nv 50 -50 30\nv 0 80 30\nf 1 2 3\n")
    for scene in [
        oaktwin.Scene.from_triangles(*WALL, up="y", label="wall"),
        oaktwin.Scene.from_triangles(np.empty((0, 3)), np.empty((0, 3), int)),
        oaktwin.Scene.open(stage),
        oaktwin.Scene.open(tmp_path / "wall.obj", up="y", scale=0.1),
    ]:
        pose = oaktwin.look_at((3, -2, 1.5), (0, 0, 0.5))
        names = ["distance_to_image_plane", "semantic_segmentation", "rgb"]
        seen = scene.render(camera, pose, annotators=names)
        for other in copies(scene):
            assert repr(other) == repr(scene) and np.array_equal(other.bounds, scene.bounds) and other.up == scene.up
            got = other.render(camera, pose, annotators=names)
            assert all(np.array_equal(got[name], seen[name]) for name in names)
            assert got["semantic_segmentation_labels"] == seen["semantic_segmentation_labels"]
    lost = pickle.dumps(oaktwin.Scene.open(tmp_path / "wall.obj"))
    (tmp_path / "wall.obj").unlink()
    with pytest.raises(FileNotFoundError, match=r"wall\.obj: cannot be read"):
        pickle.loads(lost)


def test_scenes_with_files_outside_their_folder(tmp_path):
    (tmp_path / "scene").mkdir()
    np.array([[2, -1, 0], [2, 1, 0], [2, 0, 2]], np.float32).tofile(tmp_path / "corners.bin")
    document = {
        "asset": {"version": "2.0"},
        "buffers": [{"byteLength": 36, "uri": "../corners.bin"}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "nodes": [{"mesh": 0}],
    }
    path = tmp_path / "scene/a.gltf"
    path.write_text(json.dumps(document))
    with pytest.raises(oaktwin.Error, match="outside the folder of the glTF file; .* add allow_outside"):
        oaktwin.Scene.open(path)
    scene = oaktwin.Scene.open(path, allow_outside=True)
    for other in copies(scene):
        assert np.array_equal(other.bounds, scene.bounds)


def work(arguments):
    scene, camera, sensor, frame = arguments
    return sensor(scene.render(camera, np.eye(4))["distance_to_image_plane"], frame=frame)


def test_other_processes(device):
    scene, camera = oaktwin.Scene.from_triangles(*WALL), device.depth_camera().resized(106, 60)
    sensor = oaktwin.DepthSensor(device, seed=4)
    jobs = [(scene, camera, sensor, frame) for frame in range(4)]
    with multiprocessing.get_context("spawn").Pool(2) as pool:
        theirs = pool.map(work, jobs)
    assert all(np.array_equal(got, work(job)) for got, job in zip(theirs, jobs))


def test_errors_travel():
    with pytest.raises(oaktwin.Error) as raised:
        oaktwin.Device("OAK4-E")
    other = pickle.loads(pickle.dumps(raised.value))
    assert type(other) is oaktwin.Error and str(other) == str(raised.value)


def test_a_pickle_of_nonsense():
    restore, state = oaktwin.Camera((4, 3), hfov_deg=60).__reduce__()
    for place, wrong in [(1, (0, 3)), (3, "wide"), (4, [0.0] * 20)]:
        state = list(state)
        state[place] = wrong
        if place == 4:
            state[3] = "opencv"
        with pytest.raises(oaktwin.Error):
            restore(*state)
    restore, state = oaktwin.Device("OAK4-D").__reduce__()
    with pytest.raises(oaktwin.Error):
        restore("OAK4-D", ("pinhole", "driver", None, None), None, ("a.json", "{", False))
