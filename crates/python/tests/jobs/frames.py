"""Frames and seeds, and poses that know whose they are."""

import pickle

import numpy as np

import oaktwin

device = oaktwin.Device("OAK4-D")
scene = oaktwin.Scene.open("scene.usda", micro_texture=True)
pose = scene.look_at((3, 0, 0.6), (0, 0, 0.5), device)
sensor = oaktwin.DepthSensor(device, seed=3)
shots = [sensor.shoot(scene, pose, size=(160, 100)) for _ in range(2)]
assert [shot.frame for shot in shots] == [0, 1] and not np.array_equal(shots[0].depth, shots[1].depth)
again = pickle.loads(pickle.dumps(sensor)).shoot(scene, pose, size=(160, 100), frame=1)
assert np.array_equal(again.depth, shots[1].depth)
assert np.allclose(pose @ shots[0].camera.body_from_camera, shots[0].world_from_camera)
try:
    sensor.shoot(scene, shots[0].world_from_camera)
except oaktwin.Error as error:
    assert "CameraPose" in str(error) or "camera" in str(error)
else:
    raise AssertionError("a camera's pose was taken for a body's")
