"""The peers of `cargo xtask bench depth`: the sensor models in NumPy, DepthAI's host filters, OpenCV's median.

`bench_depth.py FOLDER [NAME]` works on the images of FOLDER and prints a JSON object a case (those with NAME in theirs): seconds
a frame by the clock and of processor time. A DepthAI filter's time is the time of a pipeline with it, less the time of one whose
filter is switched off: what passing images costs is not counted.
"""

import json
import os
import sys
import time
from pathlib import Path

import cv2
import depthai as dai
import numpy as np

from depth_models import single_view
import time_of_flight_model
from stereo_noise_model import Parameters, stereo_noise
from test_filters import PARAMS, depthai_filter

FRAMES = 6
SHEET = {
    "baselineMM": 75.0,
    "focalLengthPixel": 805.0,
    "maxDisparityPixel": 95.0,
    "minDistance": 0.6,
    "maxDistance": 12.0,
    "noiseMean": 0.25,
    "noiseSigma": 0.2,
    "noiseDownscaleFactorPixel": 2.0,
    "confidenceThreshold": 0.8,
}
STEREO = Parameters(focalLength=805.0, baseline=0.075, width=1280)
# The program's name of the case, and the filter.
DEPTHAI = {
    "median:kernel=3x3": ("median", {"size": 3}),
    "median:kernel=5x5": ("median", {"size": 5}),
    "spatial:alpha=0.5,delta=20,holeFillingRadius=2,numIterations=1": (
        "spatial",
        {"alpha": 0.5, "delta": 20, "holeFillingRadius": 2, "numIterations": 1},
    ),
    "temporal:alpha=0.4,delta=20,persistencyMode=VALID_2_IN_LAST_4": (
        "temporal",
        {"alpha": 0.4, "delta": 20, "persistencyMode": 3},
    ),
    "speckle:speckleRange=50,differenceThreshold=2": (
        "speckle",
        {"speckleRange": 50, "differenceThreshold": 2},
    ),
}


def timed(work) -> tuple[float, float]:
    start, cpu = time.perf_counter(), time.process_time()
    work()
    return time.perf_counter() - start, time.process_time() - cpu


class Pipeline:
    """A DepthAI filter, on the host."""

    def __init__(self, made: object) -> None:
        self.pipeline = dai.Pipeline(False)
        node = self.pipeline.create(dai.node.ImageFilters)
        node.setRunOnHost(True)
        node.initialConfig.insertFilter(made)
        self.node, self.into, self.out = node, node.input.createInputQueue(), node.output.createOutputQueue()
        self.pipeline.start()

    def run(self, pixels: np.ndarray) -> None:
        frame = dai.ImgFrame()
        frame.setType(dai.ImgFrame.Type.RAW16)
        frame.setWidth(pixels.shape[1])
        frame.setHeight(pixels.shape[0])
        frame.setData(pixels.view(np.uint8).reshape(-1))
        self.into.send(frame)
        self.out.get()


def depthai_times(name: str, settings: dict, frames: np.ndarray) -> list[tuple[float, float]]:
    off, on = Pipeline(PARAMS.MedianFilter.MEDIAN_OFF), Pipeline(depthai_filter(name, settings))
    times = []
    for i in range(FRAMES + 1):
        pixels = frames[i % len(frames)]
        without, with_it = timed(lambda: off.run(pixels)), timed(lambda: on.run(pixels))
        times.append(tuple(b - a for a, b in zip(without, with_it)))
    for ended in (off, on):
        ended.pipeline.stop()
    PIPELINES.extend((off, on))
    # The first is the warm-up.
    return times[1:]


# Destroying a stopped pipeline can hang.
PIPELINES = []


def say(case: str, peer: str, times: list[tuple[float, float]]) -> None:
    wall, cpu = zip(*times)
    print(json.dumps({"case": case, "peer": peer, "wall_s": wall, "cpu_s": cpu}), flush=True)


def main() -> None:
    folder, wanted = Path(sys.argv[1]), sys.argv[2] if len(sys.argv) > 2 else ""
    depth, far, rgb, frames = (np.load(folder / f"{name}.npy") for name in ("depth", "depth_640", "rgb", "millimetres"))
    cv2.setNumThreads(1)
    camera = "Camera_pseudo_depth"

    def sheet(rgb=None, **other):
        return lambda: single_view(depth, rgb, SHEET | other, {}, 7, camera, 0, 0)

    models = {
        "single_view": sheet(),
        "single_view, jitter by pixel": sheet(noiseDownscaleFactorPixel=1.0),
        "single_view, with a colour image": sheet(rgb),
        "stereo_noise": lambda: stereo_noise(depth, STEREO, 7, camera, 0, 0),
        "time_of_flight, 640 × 480": lambda: time_of_flight_model.time_of_flight(
            far, time_of_flight_model.Parameters(focalLength=402.0), 7, camera, 0
        ),
    }
    for name, work in models.items():
        if wanted in name:
            say(name, "NumPy", [timed(work) for _ in range(2)][1:])
    for name, (kind, settings) in DEPTHAI.items():
        if wanted in name:
            say(name, "DepthAI", depthai_times(kind, settings, frames))
        if wanted in name and kind == "median":
            blurs = (lambda i=i: cv2.medianBlur(frames[i % len(frames)], settings["size"]) for i in range(FRAMES + 1))
            say(name, "OpenCV", [timed(blur) for blur in blurs][1:])


if __name__ == "__main__":
    main()
    sys.stdout.flush()
    # Without destroying the pipelines.
    os._exit(0)
