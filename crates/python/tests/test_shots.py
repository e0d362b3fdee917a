"""What a depth sensor measures of a scene in one call."""

import pickle

import numpy as np
import pytest

import oaktwin
from conftest import ROOT

SIZE = (320, 200)


@pytest.fixture(scope="module")
def scene():
    return oaktwin.Scene.open(ROOT / "examples/depth_sensor/depth_sensor.usda", micro_texture=True)


@pytest.fixture(scope="module")
def pose(scene, device):
    return scene.look_at((3, 0, 0.6), (0, 0, 0.5), device)


@pytest.mark.parametrize("engine", ["stereo-noise", "single-view"])
def test_shots_are_measurements_of_renders(device, scene, pose, engine):
    """To the byte."""
    sensor = oaktwin.DepthSensor(device, engine=engine, seed=3, filters=["speckle"])
    shot = sensor.shoot(scene, pose, frame=4)
    camera = device.depth_camera()
    seen = scene.render(camera, pose @ camera.body_from_camera, annotators=["rgb", "distance_to_image_plane"])
    assert np.array_equal(shot["distance_to_image_plane"], seen["distance_to_image_plane"])
    assert np.array_equal(shot.rgb, seen["rgb"]) and shot.exact_depth is shot["distance_to_image_plane"]
    assert np.array_equal(shot.depth, sensor(seen["distance_to_image_plane"], seen["rgb"], frame=4))
    made = sensor.annotate(
        seen["distance_to_image_plane"], seen["rgb"], annotators=["depth_sensor_reason", "depth_sensor_confidence"], frame=4
    )
    assert np.array_equal(shot.reasons, made["depth_sensor_reason"])
    assert np.array_equal(shot.confidence, made["depth_sensor_confidence"])
    assert shot.reasons.legend == made["depth_sensor_reason_names"]
    assert np.array_equal(shot.reasons == 0, shot.depth > 0)
    assert np.allclose(shot.camera.K, sensor.camera.K)
    assert np.allclose(shot.world_from_camera, pose @ sensor.camera.body_from_camera)


def test_sizes_and_pickles(device, scene, pose):
    shot = oaktwin.DepthSensor(device, filters=["decimation:factor=2"]).shoot(scene, pose, size=SIZE)
    assert shot.depth.shape == (100, 160) and shot.rgb.shape == (200, 320, 4)
    assert (shot.camera.size, shot.image_camera.size) == ((160, 100), SIZE)
    other = pickle.loads(pickle.dumps(shot))
    assert np.array_equal(other.depth, shot.depth) and other.frame == shot.frame and other.camera == shot.camera
    reasons = pickle.loads(pickle.dumps(shot.reasons))
    assert reasons.legend == shot.reasons.legend and np.array_equal(reasons, shot.reasons)
    assert type(other.world_from_camera) is oaktwin.CameraPose


def test_light_of_a_projector(scene):
    device = oaktwin.Device("OAK-D Pro PoE")
    plain = oaktwin.Scene.from_triangles([[2, -9, -9], [2, 9, -9], [2, 0, 9]], [[0, 1, 2]])
    sensor = oaktwin.DepthSensor(device, engine="stereo-matching")
    off, on = (sensor.shoot(plain, np.eye(4), size=SIZE, projector=power, ambient=0.2) for power in (0.0, 1.0))
    assert np.mean(on.depth > 0) > np.mean(off.depth > 0) + 0.3
    with pytest.raises(oaktwin.Error, match="projector"):
        oaktwin.DepthSensor(oaktwin.Device("OAK4-D")).shoot(scene, np.eye(4), projector=1.0)


def test_what_cannot_be_shot(device, scene, pose):
    with pytest.raises(oaktwin.Error, match="fx, hfov_deg, camera: belong to images of another camera"):
        oaktwin.DepthSensor(device, hfov_deg=70).shoot(scene, pose)
    with pytest.raises(oaktwin.Error, match="world_from_body"):
        oaktwin.DepthSensor(device).shoot(scene, oaktwin.CameraPose(np.eye(4)))
    with pytest.raises(oaktwin.Error, match="an image of 0x4 has no pixels"):
        oaktwin.DepthSensor(device).shoot(scene, pose, size=(0, 4))
    with pytest.raises(oaktwin.Error, match="sensor: has hfov_deg"):
        oaktwin.accuracy(oaktwin.DepthSensor(device, hfov_deg=70))


def test_time_of_flight(scene):
    device = oaktwin.Device("OAK-D ToF")
    shot = oaktwin.DepthSensor(device).shoot(scene, scene.look_at((3, 0, 0.6), (0, 0, 0.5), device))
    valid = (shot.depth > 0) & (shot.exact_depth < 4)
    assert valid.any() and np.median(np.abs(shot.depth - shot.exact_depth)[valid]) < 0.1
