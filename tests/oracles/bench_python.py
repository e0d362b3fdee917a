"""The cost of calls of the Python package, compared with noise written in NumPy and with Open3D's ray casting, in turns.

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
    """Gaussian disparity noise to first order: no quantization, no occlusion, no losses, independent pixels."""
    RANDOM.standard_normal(out=out, dtype=np.float32)
    out *= np.float32(0.05 / FOCAL_TIMES_BASELINE)
    out *= depth
    out *= depth
    out += depth


def wall(*shape):
    x = np.linspace(1, 4, shape[-1], dtype=np.float32)
    return np.ascontiguousarray(np.broadcast_to(x, shape))


def white_noise(*shape):
    """Independent depths in every pixel, the worst case of occlusion."""
    return np.random.default_rng(1).uniform(0.5, 8, shape).astype(np.float32)


def seconds(call, least=0.05):
    """Returns the time of one call, averaged over enough calls."""
    count, start = 0, time.perf_counter()
    while (took := time.perf_counter() - start) < least:
        call()
        count += 1
    return took / count


def turns(rounds, *calls):
    """Returns the median time of each call; the calls take turns."""
    for call in calls:
        call()
    return [statistics.median(times) for times in zip(*([seconds(call) for call in calls] for _ in range(rounds)))]


def line(name, pixels, own, peer=None):
    against = "" if peer is None else f" {peer * 1e6:9.1f} us {peer / own:7.2f}"
    print(f"{name:44} {own * 1e6:9.1f} us {pixels / own / 1e6:8.1f}{against}")


def senses(rounds):
    print(f"{'case':44} {'oaktwin':>12} {'Mpx/s':>8} {'NumPy':>12} {'ratio':>7}")
    for shape, make in [
        ((1, 1), wall),
        ((60, 106), wall),
        ((800, 1280), wall),
        ((1024, 60, 106), wall),
        ((4096, 60, 106), wall),
        ((4096, 60, 106), white_noise),
    ]:
        depth = make(*shape)
        out, theirs = np.empty_like(depth), np.empty_like(depth)
        own, peer = turns(rounds, lambda: SENSOR(depth, out=out), lambda: numpy_noise(depth, theirs))
        name = "stereo-noise (1, 1): the call itself" if depth.size == 1 else f"stereo-noise {shape}"
        name += ", white noise" if make is white_noise else ""
        line(name, depth.size, own, peer)


def hills(side=400):
    """A field of 2 side^2 triangles, x right, y down, z forward, metres; it fills the image."""
    x, y = np.meshgrid(np.linspace(-6, 6, side + 1), np.linspace(-5, 5, side + 1))
    z = 4 + 0.4 * np.sin(3 * x) * np.cos(2 * y) + 0.05 * np.sin(19 * x + 7 * y)
    vertices = np.stack([x, y, z], -1).reshape(-1, 3).astype(np.float32)
    first = (np.arange(side)[:, None] * (side + 1) + np.arange(side)).ravel()
    a, b, c, d = first, first + 1, first + side + 1, first + side + 2
    return vertices, np.concatenate([np.stack([a, b, c], -1), np.stack([b, d, c], -1)]).astype(np.uint32)


def renders(rounds):
    camera = DEVICE.depth_camera()
    pixels = camera.width * camera.height
    vertices, faces = hills()
    scene = oaktwin.Scene.from_triangles(vertices, faces)
    try:
        from open3d_import import open3d

        o3d = open3d()
    except ImportError as error:
        print(f"\nskipped: Open3D: {error}")
        return
    theirs = o3d.t.geometry.RaycastingScene()
    theirs.add_triangles(o3d.core.Tensor(vertices), o3d.core.Tensor(faces))
    # Open3D's rays go through (x + 0.5, y + 0.5), with a K relative to the corner of the image.
    k = camera.K
    k[:2, 2] += 0.5
    rays = theirs.create_rays_pinhole(k, np.eye(4), camera.width, camera.height)

    def peer():
        # The direction of a ray has length 1 along the axis, so its parameter is z.
        return theirs.cast_rays(rays)["t_hit"].numpy()

    print(f"\n{f'{len(faces)} triangles, 1280 x 800':44} {'oaktwin':>12} {'Mpx/s':>8} {'Open3D':>12} {'ratio':>7}")
    truth = peer()
    for backend in ["auto", "raster", "ray"]:

        def own(backend=backend):
            return scene.render(camera, np.eye(4), backend=backend)["distance_to_image_plane"]

        line(f"Scene.render, {backend}", pixels, *turns(rounds, own, peer))
        depth = own()
        both = np.isfinite(depth) & np.isfinite(truth)
        off = np.abs(depth[both] - truth[both])
        print(f"    hit by both {both.mean():.4%}, by one {np.mean(np.isfinite(depth) != np.isfinite(truth)):.4%}; "
              f"median difference {np.median(off):.1e} m, 99.9 % within {np.quantile(off, 0.999):.1e} m")
        if both.mean() < 0.99 or np.quantile(off, 0.999) > 1e-3:
            sys.exit("error: they do not see the same")
    print("Their rays are made beforehand; ours are part of the call.")


def main(rounds):
    senses(rounds)
    renders(rounds)


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 7)
