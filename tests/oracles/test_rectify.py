"""Rectified pairs, compared with OpenCV: stereoRectify, initUndistortRectifyMap and remap, warpPerspective for a homography;
and with DepthAI's own node that rectifies on a host."""

from dataclasses import dataclass, field
from datetime import timedelta
from functools import partial
from pathlib import Path

import cv2
import depthai as dai
import numpy as np
import pytest

SIZE = (1280, 800)

# Stopped pipelines, kept because destroying one can hang.
STOPPED = []

RATIONAL = [
    -2.1, 3.4, 4e-4, -6e-4, 11.2, -2.15, 3.6, 11.0, 8e-4, -2e-4, 5e-4, -1e-4, -0.008, 0.003,
]  # fmt: skip


@dataclass
class Camera:
    focal: float
    centre: tuple[float, float]
    coefficients: list[float]
    fisheye: bool = False
    matrix: np.ndarray = field(init=False)

    def __post_init__(self) -> None:
        self.matrix = np.array(
            [[self.focal, 0, self.centre[0]], [0, self.focal + 0.6, self.centre[1]], [0, 0, 1.0]]
        )

    def request(self) -> dict:
        return {
            "matrix": self.matrix.tolist(),
            "coefficients": self.coefficients,
            "fisheye": self.fisheye,
        }

    def map(self, rotation: np.ndarray, target: np.ndarray, coefficients: list[float]) -> np.ndarray:
        """The position in this camera's image of each pixel of a rectified image."""
        make = cv2.fisheye.initUndistortRectifyMap if self.fisheye else cv2.initUndistortRectifyMap
        x, y = make(self.matrix, np.array(coefficients), rotation, target, SIZE, cv2.CV_32FC1)
        return np.stack([x, y], axis=-1)


def pair(focal: float, coefficients: list[float], fisheye: bool = False) -> tuple[Camera, Camera, np.ndarray]:
    rotation, _ = cv2.Rodrigues(np.array([0.004, -0.017, 0.012]))
    right_from_left = np.eye(4)
    right_from_left[:3, :3] = rotation
    right_from_left[:3, 3] = [-0.0745, 0.0006, -0.0009]
    left = Camera(focal, (645.3, 411.8), coefficients, fisheye)
    right = Camera(focal + 1.7, (628.1, 395.2), [1.1 * k for k in coefficients[:4]] + coefficients[4:], fisheye)
    return left, right, right_from_left


@pytest.fixture
def ask(depth_eval):
    return partial(depth_eval, "rectify")


def picture(seed: int, dtype: type) -> np.ndarray:
    """Noise of several sizes, and a checkerboard."""
    random = np.random.default_rng(seed)
    coarse = cv2.resize(random.random((50, 80)), SIZE, interpolation=cv2.INTER_CUBIC)
    fine = random.random((SIZE[1], SIZE[0]))
    y, x = np.indices((SIZE[1], SIZE[0]))
    board = ((x // 40 + y // 40) % 2).astype(float)
    mixed = np.clip(0.4 * coarse + 0.2 * fine + 0.4 * board, 0, 1)
    return (mixed * np.iinfo(dtype).max).astype(dtype)


def ours(ask, folder: Path, cameras, right_from_left, images, method, target, edge_fill=0):
    paths = [str(folder / f"{name}.npy") for name in ("left", "right", "left_out", "right_out")]
    for path, image in zip(paths, images):
        np.save(path, image)
    answer = ask(
        images=paths[:2],
        rectified=paths[2:],
        cameras=[camera.request() for camera in cameras],
        right_from_left=right_from_left.tolist(),
        method=method,
        target=target,
        edge_fill=edge_fill,
    )
    return [np.load(path) for path in paths[2:]], answer["method"]


def rotations(left: Camera, right: Camera, right_from_left: np.ndarray) -> list[np.ndarray]:
    # These depend on the transform alone.
    none = np.zeros(5)
    r1, r2, *_ = cv2.stereoRectify(
        left.matrix, none, right.matrix, none, SIZE, right_from_left[:3, :3], right_from_left[:3, 3]
    )
    return [r1, r2]


def mesh(camera: Camera, rotation: np.ndarray, target: np.ndarray) -> np.ndarray:
    """A position every 16 pixels of OpenCV's with the first eight coefficients, and linearly between."""
    nodes = np.zeros((SIZE[1] // 16 + 1, SIZE[0] // 16 + 1, 2))
    for row in range(nodes.shape[0]):
        for column in range(nodes.shape[1]):
            moved = target.copy()
            moved[0, 2] -= 16 * column
            moved[1, 2] -= 16 * row
            x, y = cv2.initUndistortRectifyMap(
                camera.matrix, np.array(camera.coefficients[:8]), rotation, moved, (1, 1), cv2.CV_32FC1
            )
            nodes[row, column] = x[0, 0], y[0, 0]
    y, x = np.indices((SIZE[1], SIZE[0]))
    a, b = (x % 16 / 16)[..., None], (y % 16 / 16)[..., None]
    x, y = x // 16, y // 16
    top = nodes[y, x] * (1 - a) + nodes[y, x + 1] * a
    bottom = nodes[y + 1, x] * (1 - a) + nodes[y + 1, x + 1] * a
    return (top * (1 - b) + bottom * b).astype(np.float32)


def alike(found: np.ndarray, expected: np.ndarray, share: float, most: float) -> None:
    off = np.abs(found.astype(float) - expected.astype(float))
    # OpenCV mixes 16 bits in single precision and rounds halves to even.
    same = np.mean(off <= (found.dtype == np.uint16))
    print(f"same {100 * same:.4f} %, largest {off.max():.0f} of {np.iinfo(found.dtype).max}")
    assert same >= share and off.max() <= most


@pytest.mark.parametrize("dtype", [np.uint8, np.uint16])
@pytest.mark.parametrize("edge_fill", [0, 40, -1])
@pytest.mark.parametrize(
    ("focal", "coefficients", "fisheye"),
    [(794.0, RATIONAL, False), (572.0, RATIONAL[:8], False), (577.5, [-0.02, 0.003, -0.001, 2e-4], True)],
)
def test_every_position(ask, tmp_path, focal, coefficients, fisheye, edge_fill, dtype):
    left, right, transform = pair(focal, coefficients, fisheye)
    images = [picture(1, dtype), picture(2, dtype)]
    found, method = ours(ask, tmp_path, (left, right), transform, images, "full", "left", edge_fill)
    assert method == "full"
    border = {"borderMode": cv2.BORDER_REPLICATE} if edge_fill < 0 else {"borderValue": edge_fill}
    for camera, rotation, image, result in zip((left, right), rotations(left, right, transform), images, found):
        at = camera.map(rotation, left.matrix, camera.coefficients)
        expected = cv2.remap(image, at, None, cv2.INTER_LINEAR, **border)
        # A position midway between two 32nds of a pixel may round either way.
        alike(result, expected, 0.9998, np.iinfo(dtype).max / 16)


def test_homography(ask, tmp_path):
    left, right, transform = pair(794.0, RATIONAL)
    images = [picture(3, np.uint8), picture(4, np.uint8)]
    found, method = ours(ask, tmp_path, (left, right), transform, images, "auto", "right")
    assert method == "homography"
    for camera, rotation, image, result in zip((left, right), rotations(left, right, transform), images, found):
        homography = right.matrix @ rotation @ np.linalg.inv(camera.matrix)
        expected = cv2.warpPerspective(image, homography, SIZE, flags=cv2.INTER_LINEAR)
        alike(result, expected, 0.999, 24)


def test_mesh(ask, tmp_path):
    left, right, transform = pair(572.0, RATIONAL)
    images = [picture(5, np.uint8), picture(6, np.uint8)]
    found, method = ours(ask, tmp_path, (left, right), transform, images, "auto", "right")
    assert method == "mesh"
    for camera, rotation, image, result in zip((left, right), rotations(left, right, transform), images, found):
        at = mesh(camera, rotation, right.matrix)
        expected = cv2.remap(image, at, None, cv2.INTER_LINEAR)
        alike(result, expected, 0.995, 24)


def depthai_frame(image: np.ndarray, camera: Camera, last_from_camera: np.ndarray) -> dai.ImgFrame:
    frame = dai.ImgFrame()
    frame.setWidth(SIZE[0])
    frame.setHeight(SIZE[1])
    frame.setType(dai.ImgFrame.Type.GRAY8)
    frame.setData(image)
    extrinsics = dai.Extrinsics()
    extrinsics.rotationMatrix = last_from_camera[:3, :3].tolist()
    extrinsics.translation = dai.Point3f(*(100 * last_from_camera[:3, 3]).tolist())
    extrinsics.toCameraSocket = dai.CameraBoardSocket.CAM_A
    seen = dai.ImgTransformation()
    seen.setSize(*SIZE)
    seen.setSourceSize(*SIZE)
    seen.setIntrinsicMatrix(camera.matrix.tolist())
    seen.setDistortionCoefficients(camera.coefficients)
    seen.setDistortionModel(dai.CameraModel.Perspective)
    seen.setExtrinsics(extrinsics)
    frame.setTransformation(seen)
    frame.setSequenceNum(1)
    frame.setTimestamp(timedelta(seconds=1))
    return frame


def test_depthai_on_a_host(ask, tmp_path):
    """Its node keeps rotations in single precision: a few positions fall on the other side of a 32nd of a pixel."""
    left, right, transform = pair(794.0, RATIONAL)
    images = [picture(7, np.uint8), picture(8, np.uint8)]
    found, _ = ours(ask, tmp_path, (left, right), transform, images, "full", "left")
    pipeline = dai.Pipeline(False)
    STOPPED.append(pipeline)
    node = pipeline.create(dai.node.Rectification)
    node.setRunOnHost(True)
    inputs = [node.input1.createInputQueue(), node.input2.createInputQueue()]
    outputs = [node.output1.createOutputQueue(), node.output2.createOutputQueue()]
    pipeline.start()
    try:
        for queue, image, camera, place in zip(inputs, images, (left, right), (transform, np.eye(4))):
            queue.send(depthai_frame(image, camera, place))
        frames = [queue.get(timedelta(seconds=30)) for queue in outputs]
    finally:
        pipeline.stop()
    for frame, result in zip(frames, found):
        assert frame is not None
        np.testing.assert_allclose(frame.getTransformation().getIntrinsicMatrix(), left.matrix, rtol=1e-6)
        alike(result, frame.getFrame(), 0.995, 24)
