"""The peers of `cargo xtask bench stereo`: OpenCV's semi-global matching in three of its modes, and our own Python package.

`bench_stereo.py FOLDER THREADS FRAMES` matches the pair of FOLDER and prints a JSON object for each: elapsed and processor
time per frame in seconds, and the peak memory of the process. RAYON_NUM_THREADS sets the threads of our package.
"""

import json
import resource
import sys
import time
from pathlib import Path

import cv2
import numpy as np

BLOCK = 5
MODES = {
    "OpenCV, 5 paths": cv2.STEREO_SGBM_MODE_SGBM,
    "OpenCV, 3-way": cv2.STEREO_SGBM_MODE_SGBM_3WAY,
    "OpenCV, 8 paths": cv2.STEREO_SGBM_MODE_HH,
}


PACKAGE = "a call of StereoMatcher, 4 paths"


def package():
    """Returns our matcher, with the camera and the settings of `stereo-bench`."""
    import oaktwin

    return oaktwin.StereoMatcher(fx=800, baseline=0.075, parameters={"subpixelFractionalBits": 3})


def opencv(mode: int):
    return cv2.StereoSGBM_create(
        minDisparity=0,
        numDisparities=96,
        blockSize=BLOCK,
        P1=8 * BLOCK**2,
        P2=32 * BLOCK**2,
        disp12MaxDiff=1,
        uniquenessRatio=10,
        mode=mode,
    ).compute


def main() -> None:
    folder, threads, frames = Path(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3])
    left, right = (np.load(folder / f"{name}.npy") for name in ("left", "right"))
    cv2.setNumThreads(threads)
    matchers = {PACKAGE: package()} | {name: opencv(mode) for name, mode in MODES.items()}
    for name, match in matchers.items():
        wall, cpu = [], []
        # The first is the warm-up.
        for frame in range(frames + 1):
            start, start_cpu = time.perf_counter(), time.process_time()
            match(left, right)
            if frame:
                wall.append(time.perf_counter() - start)
                cpu.append(time.process_time() - start_cpu)
        peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024
        print(json.dumps({"peer": name, "wall_s": wall, "cpu_s": cpu, "peak_bytes": peak}), flush=True)


if __name__ == "__main__":
    main()
