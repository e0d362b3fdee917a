"""OpenCV's matcher as the engine of an OAK."""

import cv2
import numpy as np
import numpy.typing as npt

import oaktwin

matcher = cv2.StereoSGBM.create(numDisparities=96, blockSize=5, P1=200, P2=800)


def sgbm(left: npt.NDArray[np.uint8], right: npt.NDArray[np.uint8]) -> npt.NDArray[np.float64]:
    disparity: npt.NDArray[np.float64] = matcher.compute(left, right) / 16
    return np.maximum(disparity, 0)


device = oaktwin.Device("OAK4-D")
scene = oaktwin.Scene.open("scene.usda", micro_texture=True)
pose = scene.look_at((3, 0, 0.6), (0, 0, 0.5), device)
sensor = oaktwin.DepthSensor(device, engine=sgbm, filters=["speckle"])
shot = sensor.shoot(scene, pose, size=(640, 400))
assert np.mean(shot.depth > 0) > 0.5
assert abs(oaktwin.accuracy(sensor, distances=[1.0], devices=1, captures=1).rows[0]["error_percent"]) < 2
