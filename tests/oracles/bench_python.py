"""What calls of the Python package cost, beside the noise that people write in NumPy, in turns.

Run by `cargo xtask bench python`.
"""

import statistics
import sys
import time

import numpy as np

import oaktwin

DEVICE = oaktwin.Device("OAK4-D")
SENSOR = oaktwin.DepthSensor(DEVICE)
FOCAL_TIMES_BASELINE = float(SENSOR.parameters["focalLength"]) * float(SENSOR.parameters["baseline"])
RANDOM = np.random.default_rng(0)


def numpy_noise(depth, out):
    """Gaussian disparity to first order: no quantization, no shadows, no losses, neighbours apart."""
    RANDOM.standard_normal(out=out, dtype=np.float32)
    out *= np.float32(0.05 / FOCAL_TIMES_BASELINE)
    out *= depth
    out *= depth
    out += depth


def wall(*shape):
    x = np.linspace(1, 4, shape[-1], dtype=np.float32)
    return np.ascontiguousarray(np.broadcast_to(x, shape))


def seconds(call, least=0.05):
    """Of one call, of as many as take a while."""
    count, start = 0, time.perf_counter()
    while (took := time.perf_counter() - start) < least:
        call()
        count += 1
    return took / count


def cases():
    for shape in [(60, 106), (800, 1280), (1024, 60, 106)]:
        depth = wall(*shape)
        out, theirs = np.empty_like(depth), np.empty_like(depth)
        yield (
            f"stereo-noise {shape}",
            depth.size,
            lambda depth=depth, out=out: SENSOR(depth, out=out),
            lambda depth=depth, out=theirs: numpy_noise(depth, out),
        )
    one = wall(1, 1)
    nothing = np.empty_like(one)
    yield "stereo-noise (1, 1): the call itself", 1, lambda: SENSOR(one), lambda: numpy_noise(one, nothing)


def main(rounds):
    print(f"{'case':40} {'oaktwin':>12} {'Mpx/s':>8} {'NumPy':>12} {'ratio':>7}")
    for name, pixels, ours, theirs in cases():
        ours(), theirs()
        turns = [(seconds(ours), seconds(theirs)) for _ in range(rounds)]
        own, peer = (statistics.median(times) for times in zip(*turns))
        print(f"{name:40} {own * 1e6:9.1f} us {pixels / own / 1e6:8.1f} {peer * 1e6:9.1f} us {peer / own:7.2f}")
    scene = oaktwin.Scene.from_triangles(np.array([[-50, -50, 3], [50, -50, 3], [0, 80, 3]]), np.array([[0, 1, 2]]))
    camera = DEVICE.depth_camera()
    own = statistics.median(seconds(lambda: scene.render(camera, np.eye(4))) for _ in range(rounds))
    print(f"{'render of one triangle, 1280 x 800':40} {own * 1e6:9.1f} us {camera.width * camera.height / own / 1e6:8.1f}")


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 7)
