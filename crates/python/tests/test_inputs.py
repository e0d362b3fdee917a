"""Inputs of many kinds: shapes, precisions, lists, masks; the numbering of frames; units in batches; findings about images."""

import copy
import pickle
import warnings

import numpy as np
import pytest

import oaktwin


@pytest.fixture
def sensor(device):
    return oaktwin.DepthSensor(device, seed=1)


def test_frames_advance(sensor, device):
    wall = np.full((60, 106), 2, np.float32)
    first, second = sensor(wall), sensor(wall)
    assert not np.array_equal(first, second)
    assert np.array_equal(first, sensor(wall, frame=0)) and np.array_equal(second, sensor(wall, frame=1))
    annotated = sensor.annotate(wall, annotators=["depth_sensor_distance"])["depth_sensor_distance"]
    assert np.array_equal(annotated, sensor(wall, frame=2))
    again = oaktwin.DepthSensor(device, seed=1)
    assert np.array_equal([again(wall), again(wall)], [first, second])


def test_a_channel_of_one(sensor, room):
    depth, rgb = room
    expected = sensor(depth, frame=3)
    got = sensor(depth[..., None], frame=3)
    assert got.shape == (*depth.shape, 1) and np.array_equal(got[..., 0], expected)
    batch = np.stack([depth, depth])
    got = sensor(batch[..., None], np.stack([rgb, rgb]), frame=3)
    assert np.array_equal(got[..., 0], sensor(batch, np.stack([rgb, rgb]), frame=3))
    out = np.empty((*depth.shape, 1), np.float32)
    assert sensor(depth[..., None], frame=3, out=out) is out and np.array_equal(out[..., 0], expected)


def test_other_precisions_lists_and_masks(sensor, room):
    depth, _ = room
    expected = sensor(depth, frame=0)
    for other in [depth.astype(np.float64), depth.tolist(), np.ma.masked_array(depth, np.zeros(depth.shape, bool))]:
        got = sensor(other, frame=0)
        assert got.dtype == np.float32 and np.array_equal(got, expected)
    mask = np.zeros(depth.shape, bool)
    mask[10:20, 30:40] = True
    holes = np.where(mask, np.float32(0), depth)
    assert np.array_equal(sensor(np.ma.masked_array(depth, mask), frame=0), sensor(holes, frame=0))
    with pytest.raises(oaktwin.Error, match="depth: is not an array"):
        sensor([[1.0, 2.0], [1.0]])
    assert oaktwin.Camera([64, 48], hfov_deg=60) == oaktwin.Camera((64, 48), hfov_deg=60)
    scene = oaktwin.Scene.from_triangles([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
    assert scene.bounds.shape == (2, 3) and scene.triangle_count == 1


class Plain:
    """A tensor whose device type is an enumeration that is not a number, like Open3D's."""

    class Kind:
        value = 1

    def __init__(self, array):
        self.array = array

    def __dlpack__(self, **options):
        return self.array.__dlpack__(**options)

    def __dlpack_device__(self):
        return (self.Kind(), 0)


def test_devices_that_are_no_numbers(sensor, room):
    assert np.array_equal(sensor(Plain(room[0]), frame=0), sensor(room[0], frame=0))


def test_units_of_a_batch(device, room):
    batch = np.stack([room[0]] * 3)
    sensor = oaktwin.DepthSensor(device, seed=5)
    got = sensor(batch, frame=2, seed=[7, 8, 7], device_seed=np.array([1, 1, 2]))
    for one, seed, unit in zip(got, [7, 8, 7], [1, 1, 2]):
        assert np.array_equal(one, oaktwin.DepthSensor(device, seed=seed, device_seed=unit)(room[0], frame=2))
    units = sensor(batch, frame=2, device_seed=[1, 1, 1])
    assert np.array_equal(units, oaktwin.DepthSensor(device, seed=5, device_seed=1)(batch, frame=2))


def test_findings_are_shown_once(device):
    sensor = oaktwin.DepthSensor(device)
    for images, code in [
        (np.full((6, 9), 2000, np.float32), "depth-unit"),
        (np.full((6, 9), 2, np.uint16), "depth-unit"),
        (np.full((6, 9), 0.01, np.float32), "nothing-measured"),
    ]:
        sensor = oaktwin.DepthSensor(device)
        with pytest.warns(oaktwin.FindingWarning, match=code):
            sensor(images)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            sensor(images)
        assert [finding.code for finding in sensor.findings].count(code) == 1
    with pytest.warns(oaktwin.FindingWarning, match="looks like radians"):
        oaktwin.Camera((64, 48), hfov_deg=1.2)


def test_findings_travel(device):
    sensor = oaktwin.DepthSensor(device)
    with pytest.warns(oaktwin.FindingWarning):
        sensor(np.full((6, 9), 2000, np.float32))
    finding = sensor.findings[-1]
    for other in [pickle.loads(pickle.dumps(finding)), copy.deepcopy(finding)]:
        assert other == finding and str(other) == str(finding) and hash(other) == hash(finding)


def test_cameras_are_equal(device):
    left = device.cameras["left"]
    assert left == device.cameras["left"] == pickle.loads(pickle.dumps(left)) != device.cameras["right"]
    assert len({left, device.cameras["left"]}) == 1


def test_arguments_are_named(device):
    for text, call in {
        "eye: has shape": lambda: oaktwin.look_at((0, 0), (1, 0, 0)),
        "size: invalid value": lambda: oaktwin.Camera((-640, 400), hfov_deg=60),
        "near, far": lambda: oaktwin.Camera((640, 400), hfov_deg=60, near=1e-320),
        "distances: is empty": lambda: oaktwin.accuracy(device, distances=[]),
        "rgb: is required by the filter brightness": lambda: oaktwin.filters.brightness(np.ones((4, 4), np.uint16), None),
        "eye: z is NaN": lambda: oaktwin.look_at((0, 0, np.nan), (1, 0, 0)),
        "width: invalid value -640": lambda: device.cameras["left"].resized(-640, 400),
        "height: invalid value 400.5": lambda: device.cameras["left"].cropped(0, 0, 64, 400.5),
        "count: invalid value -1": lambda: device.population(-1),
        "seed: invalid value -1": lambda: oaktwin.simulate_imu(device, [0, 1], np.stack([np.eye(4)] * 2), seed=-1),
        "devices: invalid value -1": lambda: oaktwin.accuracy(device, devices=-1),
        "distances: invalid value 1.0; pass a list": lambda: oaktwin.accuracy(device, distances=1.0),
        "distortion: is not an array": lambda: oaktwin.Camera((4, 4), hfov_deg=60, distortion="x"),
        "recordings: is empty": lambda: oaktwin.fit(device, []),
        "world_from_camera: has shape": lambda: device.cameras["left"].project([[0, 0, 1]], np.eye(4)[None]),
        "reflection": lambda: oaktwin.Camera((4, 4), hfov_deg=60, body_from_camera=np.diag([1, 1, -1, 1])),
    }.items():
        with pytest.raises(oaktwin.Error, match=text):
            call()
    oaktwin.DepthSensor(device, engine="single-view", isaac=6)
    for wrong, nearest in {"hfov": "hfov_deg", "enigne": "engine"}.items():
        with pytest.raises(TypeError, match=f"did you mean '{nearest}'"):
            oaktwin.DepthSensor(device, **{wrong: 1})
    with pytest.raises(FileNotFoundError, match="no/wall"):
        oaktwin.fit(device, "no/wall")
    with pytest.raises(FileNotFoundError, match="no.toml"):
        oaktwin.Recipe("no.toml")
    with pytest.raises(FileNotFoundError, match="no/catalog"):
        oaktwin.Device("OAK4-D", catalog="no/catalog")


def test_values_of_other_types_are_converted(device, tmp_path):
    sensor = oaktwin.DepthSensor(device, parameters={"window": 5.0, "subpixel": np.False_, "jitter": np.float32(1)})
    assert (sensor.parameters["window"], sensor.parameters["subpixel"], sensor.parameters["jitter"]) == (5, False, 1.0)
    device.write_usd(tmp_path / "six.usda", isaac=6)
    flat, nested = ([0.1, 0.01, 0, 0, 0.001], [[0.1, 0.01, 0, 0, 0.001]])
    cameras = [oaktwin.Camera((64, 48), hfov_deg=60, distortion=np.array(values)) for values in (flat, nested)]
    assert cameras[0] == cameras[1]
    left = device.cameras["left"].resized(64, 40)
    assert left.unproject(np.ones((40, 64, 1), np.float32)).shape == (40, 64, 3)


def test_lost_images_of_batches_and_annotators_are_reported(device):
    wall = np.full((60, 106), 2, np.float32)
    for lost, code in [(wall * 1000, "depth-unit"), (wall * 0.05, "nothing-measured")]:
        with pytest.warns(oaktwin.FindingWarning, match=code):
            oaktwin.DepthSensor(device)(np.stack([wall, lost, wall]))
        with pytest.warns(oaktwin.FindingWarning, match=code):
            oaktwin.DepthSensor(device).annotate(lost, annotators=["depth_sensor_distance"])
    with pytest.warns(oaktwin.FindingWarning, match="texture of the colour image"):
        oaktwin.DepthSensor(device)(wall, np.full((60, 106, 3), 128, np.uint8))


def test_dots_give_plain_walls_texture():
    device = oaktwin.Device("OAK-D Pro PoE")
    wall, grey = np.full((60, 106), 2, np.float32), np.full((60, 106, 3), 128, np.uint8)
    sensor = oaktwin.DepthSensor(device, parameters={"dotContrast": 3})
    assert (sensor(wall, grey) > 0).mean() > 0.8


def test_arrays_within_the_limit_of_memory(device):
    images = np.zeros((20, 800, 1280), np.uint16)
    oaktwin.set_memory_limit("70M")
    try:
        with pytest.raises(oaktwin.Error, match="the result: "):
            device.cameras["left"].resized(1280, 800).unproject(images)
    finally:
        oaktwin.set_memory_limit(None)


def test_fields_of_view_of_fisheyes():
    wide = oaktwin.Device("OAK4-D Wide", lens="fisheye").cameras["left"]
    pinhole = oaktwin.Camera(wide.size, K=wide.K)
    assert wide.lens == "fisheye" and abs(wide.hfov_deg - pinhole.hfov_deg) > 1
