"""Frames per second of a virtual OAK in real time: two cameras, StereoDepth and a program that reads disparities, as in DepthAI's example
stereo.py. Run by `cargo xtask bench depthai`.

The cameras are asked for more frames than can be made, so that the rate is what the simulation reaches. Each measurement has a process of its
own, which waits until frames arrive evenly.
"""

import subprocess
import sys
import time

SIZES = ((640, 400), (1280, 800))
ENGINES = ("stereo-matching", "stereo-noise")
MODEL, LOOK_AT = "OAK-D Pro PoE", (0, 0, 1.15, 1, 0, 1.03)
# Where nothing moves, light is rendered once.
MOVING = "demo room, moving"
WARM_UP, FPS = 5, 200


def main(seconds, room):
    print("| scene | engine | size | frames/s | processor time of a frame |\n|---|---|---|---:|---:|")
    for scene, path in (("demo room", room), (MOVING, room), ("textured wall", "")):
        for engine in ENGINES:
            for width, height in SIZES:
                command = [sys.executable, __file__, str(seconds), path, engine, str(width), str(height), scene]
                rate, cost = subprocess.run(command, check=True, capture_output=True, text=True).stdout.split()[-2:]
                print(f"| {scene} | `{engine}` | {width} × {height} | {rate} | {cost} ms |", flush=True)


def wall():
    """A rectangle with a random texture, 2 m in front of the device."""
    import numpy as np

    import oaktwin

    texture = np.repeat(np.random.default_rng(3).integers(40, 220, (384, 512, 1), np.uint8), 3, axis=2)
    vertices = [(2, 4, -3), (2, -4, -3), (2, -4, 3), (2, 4, 3)]
    mesh = oaktwin.Mesh(vertices, [(0, 1, 2), (0, 2, 3)], uvs=[(0, 0), (1, 0), (1, 1), (0, 1)], texture=texture)
    return oaktwin.Scene.from_meshes({"wall": mesh})


def forward(seconds):
    """A walk to the table and back."""
    import oaktwin

    x = 0.1 * abs(seconds % 4 - 2)
    return oaktwin.look_at((x, *LOOK_AT[1:3]), LOOK_AT[3:], frame="body")


def measure(seconds, path, engine, size, scene):
    import depthai as dai

    from oaktwin.depthai import virtual_device

    place = {"scene": path} | ({"pose": forward} if scene == MOVING else {"look_at": LOOK_AT}) if path else {"scene": wall()}
    with virtual_device(MODEL, engine=engine, **place), dai.Pipeline() as pipeline:
        left, right = (pipeline.create(dai.node.Camera).build(getattr(dai.CameraBoardSocket, name)) for name in ("CAM_B", "CAM_C"))
        stereo = pipeline.create(dai.node.StereoDepth)
        left.requestOutput(size, fps=FPS).link(stereo.left)
        right.requestOutput(size, fps=FPS).link(stereo.right)
        stereo.setRectification(True)
        stereo.setExtendedDisparity(True)
        stereo.setLeftRightCheck(True)
        queue = stereo.disparity.createOutputQueue()
        pipeline.start()
        for _ in range(WARM_UP):
            queue.get()
        start, used, count = time.perf_counter(), time.process_time(), 0
        while time.perf_counter() < start + seconds:
            queue.get()
            count += 1
        print(f"{count / (time.perf_counter() - start):.1f} {1000 * (time.process_time() - used) / count:.0f}")


if __name__ == "__main__":
    if len(sys.argv) > 3:
        measure(float(sys.argv[1]), sys.argv[2], sys.argv[3], (int(sys.argv[4]), int(sys.argv[5])), sys.argv[6])
    else:
        main(float(sys.argv[1]), sys.argv[2])
