"""One's own unit: its calibration, and a pair that it sees."""

import numpy as np

import oaktwin

device = oaktwin.Device.from_calibration("calibration.json", "OAK-D Pro PoE")
scene = oaktwin.Scene.open("scene.usda", micro_texture=True)
pose = scene.look_at((3, 0, 0.6), (0, 0, 0.5), device)
pair = scene.render_pair(device, pose, size=(640, 400), projector=0.5)
matched = oaktwin.StereoMatcher(device)(pair["left"], pair["right"])

valid = (matched["depth"] > 0) & (pair["z"] < 4)
assert np.median(np.abs(matched["depth"] / pair["z"] - 1)[valid]) < 0.05
assert np.allclose(device.rectification().P1[0, 0], pair["camera"].K[0, 0] * 2, rtol=0.01)
