"""Poses that know whose they are."""

import copy
import pickle

import numpy as np
import pytest

import oaktwin

EYE, TARGET = (0.3, 2.0, 1.0), (0.1, 0.5, 0.2)


def scene(up):
    return oaktwin.Scene.from_triangles([[-9, 0, -9], [9, 0, -9], [0, 0, 9]], [[0, 1, 2]], up=up)


@pytest.mark.parametrize("up, axis", [("y", 1), ("z", 2)])
def test_scenes_know_their_up_axis(device, up, axis):
    own = scene(up)
    camera = device.cameras["left"]
    body, seen = own.look_at(EYE, TARGET, device), own.look_at(EYE, TARGET, camera)
    assert isinstance(body, oaktwin.BodyPose) and isinstance(seen, oaktwin.CameraPose)
    direction = np.subtract(TARGET, EYE) / np.linalg.norm(np.subtract(TARGET, EYE))
    assert np.allclose(body[:3, 0], direction) and np.allclose(seen[:3, 2], direction)
    # Upright: what points to the left, and to the right, is horizontal.
    assert abs(body[axis, 1]) < 1e-12 and abs(seen[axis, 0]) < 1e-12
    assert body[axis, 2] > 0 and seen[axis, 1] < 0
    assert np.array_equal(seen, own.look_at(EYE, TARGET))
    assert np.array_equal(seen, oaktwin.look_at(EYE, TARGET, np.eye(3)[axis]))
    with pytest.raises(oaktwin.Error, match="of: .*pass a Camera or a Device"):
        own.look_at(EYE, TARGET, "left")


def test_wrong_poses_are_rejected(device):
    own = scene("z")
    camera = device.cameras["left"]
    body = own.look_at(EYE, TARGET, device)
    seen = body @ camera.body_from_camera
    assert isinstance(seen, oaktwin.CameraPose)
    own.render(camera, seen)
    own.render_pair(device, body, size=(64, 40))
    oaktwin.coverage(own, device, body, samples=10)
    for name, call in [
        ("world_from_body", lambda: own.render_pair(device, seen)),
        ("world_from_body", lambda: own.render_pair(device, own.look_at(EYE, TARGET))),
        ("poses", lambda: oaktwin.coverage(own, device, seen)),
        ("poses", lambda: oaktwin.coverage(own, device, np.stack([seen, seen]))),
        ("poses", lambda: oaktwin.simulate_imu(device, [0, 1], np.stack([seen, seen]))),
    ]:
        with pytest.raises(oaktwin.Error, match=f'{name}: is a pose of the frame "camera", not of a device\'s body; pass .*'):
            call()
    for call in [lambda: own.render(camera, body), lambda: camera.project([[0, 0, 1]], body)]:
        with pytest.raises(oaktwin.Error, match='world_from_camera: is a pose of the frame "body", not of a camera; pass .*'):
            call()
    # Other arrays are taken at their word.
    own.render(camera, np.asarray(body))
    assert isinstance(oaktwin.BodyPose(np.eye(4)), oaktwin.BodyPose)


def test_what_remains_a_pose(device):
    body = oaktwin.look_at(EYE, TARGET, frame="body")
    mount = device.cameras["left"].body_from_camera
    for same in [body.copy(), copy.deepcopy(body), pickle.loads(pickle.dumps(body)), np.stack([body, body])[1]]:
        assert type(same) is oaktwin.BodyPose and np.array_equal(same, body)
    assert type(np.stack([body, body]) @ mount) is oaktwin.CameraPose
    assert type(np.asarray(body) @ mount) is oaktwin.CameraPose
    assert np.array_equal(body @ mount, np.asarray(body) @ np.asarray(mount))
    for plain in [np.linalg.inv(body), body @ body, np.eye(4) @ body, body[:3, 3], body[:3, :3], 2 * body, np.stack([body, body @ mount])]:
        assert type(plain) is np.ndarray


def test_parts_have_names():
    mesh = oaktwin.Mesh(np.eye(3), [[0, 1, 2]])
    own = oaktwin.Scene.from_meshes({"m0": mesh, "arm/link": mesh})
    own.set_pose("m0", oaktwin.look_at(EYE, TARGET))
    poses = own.poses
    assert list(poses) == ["/World/m0", "/World/arm/link"]
    assert np.array_equal(poses["m0"], poses["/World/m0"]) and "m0" in poses and "arm/link" in poses
    assert "link" not in poses
    for wrong in ["link", "/m0", 3]:
        with pytest.raises(KeyError):
            poses[wrong]
    own.set_poses(poses)
