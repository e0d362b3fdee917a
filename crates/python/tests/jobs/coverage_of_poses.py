"""Which of two engines, and which of two poses, measures more of a scene."""

import numpy as np
import numpy.typing as npt

import oaktwin


def near(depth: npt.NDArray[np.float32]) -> npt.NDArray[np.float32]:
    return np.where(depth < 3, depth, np.float32(0))


device = oaktwin.Device("OAK4-D")
scene = oaktwin.Scene.open("scene.usda", micro_texture=True)
poses = np.stack([scene.look_at((3, 0, 0.6), (0, 0, 0.5), device), scene.look_at((3, 0, 0.6), (9, 0, 0.5), device)])
sensors = [oaktwin.DepthSensor(device), oaktwin.DepthSensor(device, engine=near)]
found = oaktwin.coverage(scene, sensors, poses, region_box=[[-3, -3, 0], [2, 3, 2]], samples=1000)
assert len(found.candidates) == 4 and found.best["measured"] > 0.05
