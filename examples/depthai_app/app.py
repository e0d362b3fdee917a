"""Says how far the nearest thing in front of an OAK is: `python app.py [--frames N]`. It knows nothing of virtual devices."""

from __future__ import annotations

import argparse

import depthai as dai
import numpy as np

# The share of the image, in the middle, that is looked at; and the distance in metres at which the program warns.
MIDDLE, NEAR_M = 0.3, 0.8


def nearest(depth: np.ndarray) -> float | None:
    """The distance of the nearest thing in the middle of a depth image (H, W) in millimetres: metres, or None without a measurement."""
    rows, columns = (slice(round(size * (1 - MIDDLE) / 2), round(size * (1 + MIDDLE) / 2)) for size in depth.shape)
    valid = depth[rows, columns][depth[rows, columns] > 0]
    # A few wrong pixels are no obstacle.
    return float(np.percentile(valid, 5)) / 1000 if valid.size > 100 else None


def main(frames: int | None = None) -> list[float | None]:
    """Prints the distance of each frame, and returns all of them. frames: the number of frames, or None for no end."""
    distances: list[float | None] = []
    with dai.Pipeline() as pipeline:
        cameras = [pipeline.create(dai.node.Camera).build(socket) for socket in (dai.CameraBoardSocket.CAM_B, dai.CameraBoardSocket.CAM_C)]
        left, right = (camera.requestOutput((640, 400), fps=15) for camera in cameras)
        stereo = pipeline.create(dai.node.StereoDepth).build(left, right, presetMode=dai.node.StereoDepth.PresetMode.ROBOTICS)
        queue = stereo.depth.createOutputQueue()
        pipeline.start()
        while pipeline.isRunning() and (frames is None or len(distances) < frames):
            distance = nearest(queue.get().getFrame())
            distances.append(distance)
            if distance is None:
                print("nothing was measured")
            else:
                print(f"{distance:.2f} m" + (" STOP" if distance < NEAR_M else ""))
    return distances


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--frames", type=int, help="end after so many frames")
    main(parser.parse_args().frames)
