"""A data set of many frames, rendered with Ray Data on any number of machines.

    pip install "ray[data]"
    python examples/python/ray_frames.py -o frames/ --frames 200              # on the processors of this machine
    python examples/python/ray_frames.py -o /shared/frames/ --address auto    # on a cluster
    python examples/python/ray_frames.py -o frames/ --local                   # the same bytes without Ray, in one process

A frame is a function of (scene, pose, seed, number) only, so it does not matter which worker renders it, when,
in which order, or how often: a frame is rendered again if its worker is killed, and the files are identical to the files of a single
process. A worker opens the scene once and writes the files of its frames itself; only poses and hashes are transferred.
All machines of a cluster need oaktwin, and access to the scene and the output folder.

This does not hold for temporal filters: a preset with DepthAI's temporal filter is rejected.
"""

import argparse
import hashlib
import io
import json
import math
import os
import signal
from pathlib import Path

import numpy as np

import oaktwin

SCENE = Path(__file__).resolve().parents[1] / "depth_sensor/depth_sensor.usda"
MANIFEST, KILLED = "frames.json", "killed.part"


def trajectory(camera, frames):
    """The number and the pose of each frame: a circle around the scene, facing its centre.

    Poses are data, computed once, so that no machine has its own last digit of a sine.
    """
    for number in range(frames):
        angle = 2 * math.pi * number / frames
        eye = (3 * math.cos(angle), 3 * math.sin(angle), 1.2 + 0.4 * math.sin(3 * angle))
        world_from_camera = oaktwin.look_at(eye, (0, 0, 0.4), frame="body") @ camera.body_from_camera
        yield {"number": number, "world_from_camera": world_from_camera.ravel().tolist()}


class FrameWriter:
    """Renders frames; one object per worker process, created there from plain settings."""

    def __init__(self, settings):
        self.settings = settings
        self.folder = Path(settings["output"])
        device = oaktwin.Device(settings["model"])
        self.camera = device.depth_camera().resized(*settings["size"])
        self.sensor = oaktwin.DepthSensor(device, preset=settings["preset"], seed=settings["seed"])
        if any(name.startswith("temporal") for name in self.sensor.filters):
            raise SystemExit(
                f"preset {settings['preset']}: its temporal filter makes a frame depend on those before it; "
                "use another preset, or filter the finished frames in their order"
            )
        self.scene = oaktwin.Scene.open(settings["scene"])

    def arrays(self, row):
        """The arrays of a frame by file name; images have Replicator's names."""
        pose = np.reshape(row["world_from_camera"], (4, 4))
        seen = self.scene.render(self.camera, pose, annotators=["distance_to_image_plane", "rgb"])
        # Without the colour image, as with the dot projector on: every surface counts as textured.
        measured = self.sensor(seen["distance_to_image_plane"], frame=int(row["number"]))
        return {**seen, "depth_sensor_distance": measured, "world_from_camera": pose}

    def __call__(self, row):
        """Writes the files of a frame and returns their names and hashes."""
        number = int(row["number"])
        hashes = {}
        for name, array in self.arrays(row).items():
            file = io.BytesIO()
            np.save(file, array)
            name = f"{name}_{number:04}.npy"
            hashes[name] = hashlib.sha256(file.getvalue()).hexdigest()
            self.write(number, name, file.getvalue())
        return {"number": number, "sha256": json.dumps(hashes)}

    def part(self, name):
        return self.folder / f"{name}.{os.getpid()}.part"

    def write(self, number, name, content):
        """Writes a file atomically: a killed worker leaves at most a temporary file."""
        self.part(name).write_bytes(content)
        self.part(name).replace(self.folder / name)


class KilledOnce(FrameWriter):
    """For `--kill-at`: the first worker that renders this frame kills itself while writing a file."""

    def write(self, number, name, content):
        if number == self.settings["kill_at"]:
            try:
                (self.folder / KILLED).touch(exist_ok=False)
            except FileExistsError:
                pass  # A worker was killed already; this is the second attempt.
            else:
                self.part(name).write_bytes(content[: len(content) // 2])
                os.kill(os.getpid(), signal.SIGKILL)
        super().write(number, name, content)


def remove_parts(folder):
    """Removes the temporary files of killed workers and interrupted runs."""
    for part in folder.glob("*.part"):
        part.unlink()


def with_ray(rows, settings, address, workers, blocks):
    """Renders the frames with a pool of workers and returns their hashes."""
    # Set before the import: no usage statistics, no progress bars.
    os.environ["RAY_USAGE_STATS_ENABLED"] = "0"
    os.environ.setdefault("RAY_DATA_DISABLE_PROGRESS_BARS", "1")
    import ray

    # Ray assumes one processor per worker.
    own = {"log_to_driver": False, "runtime_env": {"env_vars": {"RAYON_NUM_THREADS": "1"}}}
    if address:
        ray.init(address=address, **own)
    else:
        # Little data is transferred; a large object store is unnecessary.
        ray.init(num_cpus=workers, include_dashboard=False, object_store_memory=100 << 20, **own)
    writer = FrameWriter if settings["kill_at"] is None else KilledOnce
    # Killed workers are restarted, and their rows distributed again.
    made = ray.data.from_items(rows, override_num_blocks=blocks).map(
        writer, fn_constructor_args=[settings], compute=ray.data.ActorPoolStrategy(size=workers)
    )
    hashes = made.take_all()
    ray.shutdown()
    return hashes


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("-o", "--output", type=Path, default=Path("oaktwin-frames"), help="output folder, accessible from all machines")
    parser.add_argument("--scene", type=Path, default=SCENE)
    parser.add_argument("--model", default="OAK-D Pro PoE")
    parser.add_argument("--preset", help="DepthAI preset without a temporal filter: robotics, face, ...")
    parser.add_argument("--size", type=int, nargs=2, default=[640, 400], metavar=("W", "H"))
    parser.add_argument("--frames", type=int, default=24)
    parser.add_argument("--seed", type=int, default=7)
    parser.add_argument("--workers", type=int, default=os.cpu_count())
    parser.add_argument("--blocks", type=int, help="number of blocks in which frames are distributed")
    parser.add_argument("--address", help="address of a running Ray cluster: auto, or ray://host:10001")
    parser.add_argument("--local", action="store_true", help="render without Ray, in this process")
    parser.add_argument("--kill-at", type=int, help="kill a worker while it writes this frame, which must not change the result")
    arguments = parser.parse_args()

    arguments.output.mkdir(parents=True, exist_ok=True)
    remove_parts(arguments.output)
    settings = {**vars(arguments), "scene": str(arguments.scene.resolve()), "output": str(arguments.output.resolve())}
    writer = FrameWriter(settings)  # Also with Ray: reports invalid settings once, before workers start.
    rows = list(trajectory(writer.camera, arguments.frames))
    if arguments.local:
        made = [writer(row) for row in rows]
    else:
        blocks = arguments.blocks or min(4 * arguments.workers, arguments.frames)
        made = with_ray(rows, settings, arguments.address, arguments.workers, blocks)

    hashes = {}
    for frame in sorted(made, key=lambda frame: frame["number"]):
        hashes |= json.loads(frame["sha256"])
    killed = ", a worker was killed" if (arguments.output / KILLED).exists() else ""
    remove_parts(arguments.output)
    manifest = json.dumps(hashes, indent=1)
    (arguments.output / MANIFEST).write_text(manifest)
    print(f"{len(made)} frames, {len(hashes)} files{killed}")
    print(f"sha256 of {MANIFEST}: {hashlib.sha256(manifest.encode()).hexdigest()}")


if __name__ == "__main__":
    main()
