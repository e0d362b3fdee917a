"""Open3D and Mitsuba as engines of `cargo xtask bench render`.

`bench_render.py open3d|mitsuba` answers the requests of the program `render-bench` (crate oaktwin-testkit, which says
what they mean in `protocol.rs`): one JSON object a line in, one out.
"""

import json
import os
import sys
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np

from open3d_import import open3d


def status(field: str) -> int:
    """Returns the resident memory in bytes; 0 where the kernel does not report it."""
    try:
        lines = Path("/proc/self/status").read_text().splitlines()
    except OSError:
        return 0
    return next((int(line.split()[1]) * 1024 for line in lines if line.startswith(field)), 0)


def rays_of(view: dict) -> tuple[np.ndarray, np.ndarray]:
    """Origin (3) and directions (height, width, 3) in float32, the same bits as the Rust side's."""

    def along(count: int) -> np.ndarray:
        return ((np.arange(count) + 0.5 - count / 2) / view["focal"]).astype(np.float32)

    x, y = along(view["width"])[None, :], along(view["height"])[:, None]
    rotation = np.array(view["rotation"]).astype(np.float32)
    directions = np.stack([a * x + (b * y + c) for a, b, c in rotation], -1)
    assert directions.dtype == np.float32
    return np.array(view["translation"]).astype(np.float32), directions


class Open3d:
    def __init__(self, positions: np.ndarray, triangles: np.ndarray, view: dict, threads: int) -> None:
        self.near = view["near"]
        self.scene = open3d().t.geometry.RaycastingScene(nthreads=threads)
        self.scene.add_triangles(positions, triangles)
        # The hierarchy is built by the first query.
        self.scene.cast_rays(np.zeros((1, 6), np.float32), nthreads=threads)

    def prepare(self, view: dict) -> None:
        origin, directions = rays_of(view)
        # Rays have no minimum distance, so they start at the near plane, which is not timed.
        rays = np.concatenate([origin + np.float32(self.near) * directions, directions], -1)
        self.rays = open3d().core.Tensor(np.ascontiguousarray(rays))

    def frame(self, threads: int) -> object:
        return self.scene.cast_rays(self.rays, nthreads=threads)["t_hit"]

    def depth(self, frame: object) -> np.ndarray:
        return frame.numpy() + np.float32(self.near)


class Mitsuba:
    def __init__(self, positions: np.ndarray, triangles: np.ndarray, view: dict, threads: int) -> None:
        import drjit
        import mitsuba

        mitsuba.set_variant("llvm_ad_rgb")
        self.drjit, self.mitsuba, self.near = drjit, mitsuba, view["near"]
        drjit.set_thread_count(threads)
        mesh = mitsuba.Mesh("triangles", len(positions), len(triangles))
        parameters = mitsuba.traverse(mesh)
        parameters["vertex_positions"] = mitsuba.Float(positions.ravel())
        parameters["faces"] = mitsuba.UInt32(triangles.ravel())
        parameters.update()
        self.scene = mitsuba.load_dict({"type": "scene", "mesh": mesh})

    def prepare(self, view: dict) -> None:
        origin, directions = rays_of(view)
        near, direction = np.float32(self.near), directions.reshape(-1, 3).T
        vector = self.mitsuba.Vector3f(*(self.mitsuba.Float(np.ascontiguousarray(d)) for d in direction))
        self.rays = self.mitsuba.Ray3f(self.mitsuba.Point3f(*map(float, origin)) + near * vector, vector)
        self.drjit.eval(self.rays)
        self.drjit.sync_thread()

    def frame(self, threads: int) -> object:
        if self.drjit.thread_count() != threads:
            self.drjit.set_thread_count(threads)
        t = self.scene.ray_intersect_preliminary(self.rays, coherent=True).t
        self.drjit.eval(t)
        self.drjit.sync_thread()
        return t

    def depth(self, frame: object) -> np.ndarray:
        return frame.numpy() + np.float32(self.near)


class Worker:
    def __init__(self, engine: Callable) -> None:
        self.make = engine

    def load(self, positions: str, triangles: str, view: dict, threads: int) -> dict:
        before = status("VmRSS:")
        vertices = np.fromfile(positions, "<f4").reshape(-1, 3)
        corners = np.fromfile(triangles, "<u4").reshape(-1, 3)
        start = time.perf_counter()
        self.engine = self.make(vertices, corners, view, threads)
        build = time.perf_counter() - start
        peak = status("VmHWM:") - before
        resident = status("VmRSS:") - before
        # The rays are given and not part of the scene.
        self.engine.prepare(view)
        self.threads = threads
        self.engine.frame(threads)
        return {"modes": [""], "build_s": build, "resident_bytes": resident, "peak_bytes": peak}

    def frames(self, mode: str, threads: int, count: int) -> dict:
        wall, cpu = [], []
        for _ in range(count):
            start, used = time.perf_counter(), time.process_time()
            frame = self.engine.frame(threads)
            wall.append(time.perf_counter() - start)
            cpu.append(time.process_time() - used)
            del frame
        return {"wall_s": wall, "cpu_s": cpu}

    def depth(self, mode: str, path: str) -> dict:
        frame = self.engine.frame(self.threads)
        self.engine.depth(frame).astype("<f4").tofile(path)
        return {}


def main() -> None:
    # Standard output carries the results, so other output of libraries is redirected.
    answers = os.fdopen(os.dup(1), "w")
    os.dup2(2, 1)
    engines = {"open3d": Open3d, "mitsuba": Mitsuba}
    worker = Worker(engines[sys.argv[1]])
    if sys.argv[1] == "open3d":
        open3d()
    for line in sys.stdin:
        request = json.loads(line)
        try:
            answer = getattr(worker, request.pop("op"))(**request)
        except Exception as error:  # noqa: BLE001 - it is the answer
            answer = {"error": f"{type(error).__name__}: {error}"}
        print(json.dumps(answer), file=answers, flush=True)


if __name__ == "__main__":
    main()
