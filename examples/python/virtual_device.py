"""A program for DepthAI that runs without a camera: an OAK drives towards a wall, and warns.

    pip install depthai==3.12.*
    python examples/python/virtual_device.py

The function `warn_of_obstacles` is the program: it imports depthai as always, and a real OAK runs it as well. Everything below it is its test
on a virtual device.
"""

import argparse
from collections.abc import Iterator

import depthai as dai
import numpy as np

import oaktwin
import oaktwin.depthai

NEAR_M = 1.0


def warn_of_obstacles(frames: int) -> Iterator[tuple[float, float, bool]]:
    """Yields the time in seconds, the distance to what is ahead in metres, and whether it is too near."""
    with dai.Pipeline() as pipeline:
        stereo = pipeline.create(dai.node.StereoDepth).build(autoCreateCameras=True, size=(640, 400), fps=5)
        queue = stereo.depth.createOutputQueue()
        pipeline.start()
        for _ in range(frames):
            depth = queue.get()
            image = depth.getFrame()
            height, width = image.shape
            middle = image[3 * height // 8 : 5 * height // 8, 3 * width // 8 : 5 * width // 8]
            distance_m = float(np.median(middle[middle > 0])) / 1000
            yield depth.getTimestampDevice().total_seconds(), distance_m, distance_m < NEAR_M


def corridor() -> oaktwin.Scene:
    """A wall with a texture across the x axis, 3 m from the origin."""
    texture = np.repeat(np.random.default_rng(1).integers(40, 220, (384, 512, 1), np.uint8), 3, axis=2)
    corners = [(3.0, 4.0, -3.0), (3.0, -4.0, -3.0), (3.0, -4.0, 3.0), (3.0, 4.0, 3.0)]
    uvs = [(0, 0), (1, 0), (1, 1), (0, 1)]
    return oaktwin.Scene.from_meshes({"wall": oaktwin.Mesh(corners, [(0, 1, 2), (0, 2, 3)], uvs=uvs, texture=texture)})


def drive(seconds: float) -> np.ndarray:
    """world_from_body: half a metre per second along x."""
    pose = np.eye(4)
    pose[0, 3] = 0.5 * seconds
    return pose


def main() -> None:
    parser = argparse.ArgumentParser(description="A program for DepthAI on a virtual OAK.")
    parser.add_argument("--model", default="OAK-D Pro PoE", help="one of oaktwin.models() with a stereo pair")
    parser.add_argument("--frames", type=int, default=25, help="number of frames, a fifth of a second apart")
    parser.add_argument("--engine", choices=["stereo-matching", "stereo-noise"], default="stereo-matching")
    options = parser.parse_args()

    with oaktwin.depthai.virtual_device(options.model, scene=corridor(), pose=drive, fast=True, engine=options.engine):
        for seconds, distance_m, is_near in warn_of_obstacles(options.frames):
            true_m = 3.0 - 0.5 * seconds
            print(f"{seconds:4.1f} s  measured {distance_m:.3f} m  true {true_m:.3f} m{'  too near' if is_near else ''}")


if __name__ == "__main__":
    main()
