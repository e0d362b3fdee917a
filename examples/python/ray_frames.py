"""A data set of many frames over Ray Data, on however many machines there are.

    pip install "ray[data]"
    python examples/python/ray_frames.py -o frames/ --frames 200              # on the processors of this machine
    python examples/python/ray_frames.py -o /shared/frames/ --address auto    # on a cluster
    python examples/python/ray_frames.py -o frames/ --local                   # the same bytes without Ray, in one process

A frame is a function of (scene, pose, seed, number) and of nothing else, so it does not matter which worker makes it, when,
in which order, or how often: a frame whose worker died is made again, and the files are those of a single process, byte for
byte. A worker opens the scene once and writes its frames' files itself; what travels are poses and hashes.
So the machines of a cluster need oaktwin, and all see the scene and the output folder.

That does not hold for filters that remember earlier frames: a preset with DepthAI's temporal filter is refused.
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
    """What frames are made of, a number and a pose: once around the scene, looking at its middle.

    Poses are data, computed once, so that no machine has its own last digit of a sine.
    """
    for number in range(frames):
        angle = 2 * math.pi * number / frames
        eye = (3 * math.cos(angle), 3 * math.sin(angle), 1.2 + 0.4 * math.sin(3 * angle))
        world_from_camera = oaktwin.look_at(eye, (0, 0, 0.4), frame="body") @ camera.body_from_camera
        yield {"number": number, "world_from_camera": world_from_camera.ravel().tolist()}


class FrameWriter:
    """Makes frames; one in each worker process. What it holds is built there from plain arguments."""

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
        """What a frame has, by the names of its files: Replicator's for the images."""
        pose = np.reshape(row["world_from_camera"], (4, 4))
        seen = self.scene.render(self.camera, pose, annotators=["distance_to_image_plane", "rgb"])
        # Without the picture: with its dot projector on, the device finds texture everywhere.
        measured = self.sensor(seen["distance_to_image_plane"], frame=int(row["number"]))
        return {**seen, "depth_sensor_distance": measured, "world_from_camera": pose}

    def __call__(self, row):
        """Writes a frame's files; their names and hashes."""
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
        """The whole file or none: a worker that dies leaves at most a part of it under another name."""
        self.part(name).write_bytes(content)
        self.part(name).replace(self.folder / name)


class KilledOnce(FrameWriter):
    """For `--kill-at`: the first worker that comes to that frame dies in the middle of a file, killed as by the system."""

    def write(self, number, name, content):
        if number == self.settings["kill_at"]:
            try:
                (self.folder / KILLED).touch(exist_ok=False)
            except FileExistsError:
                pass  # Another worker was, and this is the second try.
            else:
                self.part(name).write_bytes(content[: len(content) // 2])
                os.kill(os.getpid(), signal.SIGKILL)
        super().write(number, name, content)


def remove_parts(folder):
    """What workers that died left, in this run or one that was broken off."""
    for part in folder.glob("*.part"):
        part.unlink()


def with_ray(rows, settings, address, workers, blocks):
    """The frames' hashes, made by a pool of workers."""
    # Before the import: nothing is sent anywhere, no progress bars.
    os.environ["RAY_USAGE_STATS_ENABLED"] = "0"
    os.environ.setdefault("RAY_DATA_DISABLE_PROGRESS_BARS", "1")
    import ray

    # Ray counts a worker as one processor, so it shall use one.
    own = {"log_to_driver": False, "runtime_env": {"env_vars": {"RAYON_NUM_THREADS": "1"}}}
    if address:
        ray.init(address=address, **own)
    else:
        # Little travels; no store of gigabytes is needed.
        ray.init(num_cpus=workers, include_dashboard=False, object_store_memory=100 << 20, **own)
    writer = FrameWriter if settings["kill_at"] is None else KilledOnce
    # A worker that died is started again, and its rows are given out once more.
    made = ray.data.from_items(rows, override_num_blocks=blocks).map(
        writer, fn_constructor_args=[settings], compute=ray.data.ActorPoolStrategy(size=workers)
    )
    hashes = made.take_all()
    ray.shutdown()
    return hashes


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("-o", "--output", type=Path, default=Path("oaktwin-frames"), help="a folder that all machines see")
    parser.add_argument("--scene", type=Path, default=SCENE)
    parser.add_argument("--model", default="OAK-D Pro PoE")
    parser.add_argument("--preset", help="DepthAI's, without a filter over time: robotics, face, ...")
    parser.add_argument("--size", type=int, nargs=2, default=[640, 400], metavar=("W", "H"))
    parser.add_argument("--frames", type=int, default=24)
    parser.add_argument("--seed", type=int, default=7)
    parser.add_argument("--workers", type=int, default=os.cpu_count())
    parser.add_argument("--blocks", type=int, help="how many parts the numbers are handed out in")
    parser.add_argument("--address", help="of a running Ray cluster: auto, or ray://host:10001")
    parser.add_argument("--local", action="store_true", help="without Ray, one frame after the other")
    parser.add_argument("--kill-at", type=int, help="kill a worker in the middle of this frame, to see nothing change")
    arguments = parser.parse_args()

    arguments.output.mkdir(parents=True, exist_ok=True)
    remove_parts(arguments.output)
    settings = {**vars(arguments), "scene": str(arguments.scene.resolve()), "output": str(arguments.output.resolve())}
    writer = FrameWriter(settings)  # Also with Ray: what is wrong with the settings is said here, once.
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
