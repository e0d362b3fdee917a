"""A depth sensor of images whose camera is known: focal length, principal point, size."""

import pickle

import numpy as np
import oaktwin
import pytest

SIZE = (160, 120)
K = [[110.0, 0, 61.25], [0, 110, 70.5], [0, 0, 1]]


@pytest.fixture(scope="module")
def tof():
    return oaktwin.Device("OAK-D ToF")


@pytest.fixture(scope="module")
def camera():
    """A camera with an off-centre principal point and another focal length than the device's."""
    return oaktwin.Camera(SIZE, K=K)


def room(size=SIZE):
    """A wall that approaches on the right."""
    width, height = size
    return np.tile(np.linspace(3.0, 0.8, width, dtype=np.float32), (height, 1))


def test_the_principal_point_is_the_cameras(tof, camera):
    sensor = oaktwin.DepthSensor(tof, seed=3, camera=camera)
    # The centre of the first pixel is 0 in K, and 0.5 in `principalPoint`.
    assert sensor.parameters["principalPoint"] == "61.75,71"
    assert float(sensor.parameters["focalLength"]) == 110
    measured = sensor(room(), frame=0)
    by_name = oaktwin.DepthSensor(tof, seed=3, fx=110, parameters={"principalPoint": "61.75,71"})
    assert np.array_equal(measured, by_name(room()))
    centred = oaktwin.DepthSensor(tof, seed=3, fx=110)
    assert not np.array_equal(measured, centred(room()))
    assert centred.parameters["principalPoint"] == "80,60"
    # Also for a batch.
    assert np.array_equal(sensor(room()[None], frame=4)[0], sensor(room(), frame=4))


def test_the_models_own_camera_changes_nothing(tof):
    for device in [tof, oaktwin.Device("OAK4-D")]:
        own = device.depth_camera()
        plain, given = (oaktwin.DepthSensor(device, seed=1, **said) for said in [{}, {"camera": own}])
        assert np.array_equal(plain(room(own.size)), given(room(own.size)))
        assert plain.findings == given.findings == []


def test_stereo_has_the_cameras_focal_length(camera):
    device = oaktwin.Device("OAK4-D")
    sensors = [oaktwin.DepthSensor(device, seed=1, **said) for said in [{"camera": camera}, {"fx": 110}]]
    assert np.array_equal(*(sensor(room(), frame=0) for sensor in sensors))
    assert sensors[0].parameters == sensors[1].parameters


def test_points_are_where_the_camera_sees_them(camera):
    sensor = oaktwin.DepthSensor(oaktwin.Device("OAK4-D"), engine="single-view", camera=camera)
    said = sensor.annotate(room(), annotators=["depth_sensor_point_cloud_position", "depth_sensor_distance"])
    x, y, z, measured = np.moveaxis(said["depth_sensor_point_cloud_position"], 2, 0)
    seen = measured > 0
    assert seen.mean() > 0.3
    # A sample may be shifted by columns, never by rows: y up, z backward.
    rows = np.arange(SIZE[1])[:, None] * np.ones(SIZE[0])
    assert np.allclose(y[seen], ((70.5 - rows) / 110 * -z)[seen], atol=1e-5)
    columns = x[seen] / -z[seen] * 110 + 61.25
    assert np.allclose(columns, columns.round(), atol=1e-2)


def test_the_same_said_twice_and_a_contradiction(tof, camera):
    alone = oaktwin.DepthSensor(tof, camera=camera)
    for said in [{"fx": 110}, {"fx": np.float32(110)}, {"hfov_deg": camera.hfov_deg}]:
        sensor = oaktwin.DepthSensor(tof, camera=camera, **said)
        assert sensor.parameters == alone.parameters
    for said, text in [
        ({"fx": 111}, "fx: it is 111, and the camera's 110.0000; leave it out, or the camera"),
        ({"fx": float("nan")}, "fx: it is NaN"),
        ({"hfov_deg": 90}, "hfov_deg: it is 90, and the camera's"),
        ({"fx": 110, "hfov_deg": 90}, "give one"),
    ]:
        with pytest.raises(oaktwin.Error) as raised:
            oaktwin.DepthSensor(tof, camera=camera, **said)
        assert text in str(raised.value)
    with pytest.raises(TypeError):
        oaktwin.DepthSensor(tof, camera=K)


def test_images_of_another_size_are_not_the_cameras(tof, camera):
    sensor = oaktwin.DepthSensor(tof, camera=camera)
    before = sensor(room(), frame=0)
    for call in [lambda: sensor(room((80, 60))), lambda: sensor(room((80, 60))[None]), lambda: sensor.align(room((80, 60)))]:
        with pytest.raises(oaktwin.Error, match="camera: its images are 160x120 instead of 80x60"):
            call()
    assert np.array_equal(sensor(room(), frame=0), before)
    half = oaktwin.DepthSensor(tof, camera=camera.resized(80, 60))
    assert half(room((80, 60))).shape == (60, 80)


def test_a_lens_is_a_finding(tof):
    bent = oaktwin.Camera(SIZE, K=K, distortion=[0.1, -0.05])
    [finding] = [found for found in oaktwin.DepthSensor(tof, camera=bent).findings if found.code == "image-lens"]
    assert finding.level == "warning" and "rectif" in finding.remedy and "--" not in finding.remedy


def test_pickles_have_the_camera(tof, camera):
    sensor = oaktwin.DepthSensor(tof, seed=2, camera=camera, filters=["decimation:factor=2"])
    again = pickle.loads(pickle.dumps(sensor))
    measured = again(room())
    assert again.parameters == sensor.parameters and np.array_equal(measured, sensor(room(), frame=0))
    # The output of a decimating sensor still belongs to its camera.
    assert np.array_equal(again.align(measured, "left"), sensor.align(measured, "left"))
