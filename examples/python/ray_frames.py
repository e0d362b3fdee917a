"""A data set of many frames over Ray Data, on however many machines there are.

    pip install "ray[data]" oaktwin
    python ray_frames.py -o frames/ --frames 200                   # on this machine's processors
    python ray_frames.py -o /shared/frames/ --address auto         # on a cluster whose machines all see /shared
    python ray_frames.py -o frames/ --local                        # the same bytes without Ray, in one process

A frame is a function of (scene, pose, seed, number) and of nothing else, so it does not matter which worker makes it, when, in
which order, or how often: a frame whose worker died is made again, and the files are those of a single process, byte for
byte. Each worker opens the scene once and writes its frames' files itself; what travels are numbers and hashes.

That holds for everything but filters that remember earlier frames: a preset with DepthAI's temporal filter is refused.
"""

import argparse
import hashlib
import io
import json
import math
import os
import signal
import sys
from pathlib import Path

import numpy as np

import oaktwin

SCENE = Path(__file__).resolve().parents[1] / "depth_sensor/depth_sensor.usda"
MANIFEST, KILLED = "frames.json", "killed.part"


def world_from_body(number, frames):
    """Where the device stands in frame `number`: once around the scene's middle, looking at it."""
    angle = 2 * math.pi * number / frames
    eye = (3 * math.cos(angle), 3 * math.sin(angle), 1.2 + 0.4 * math.sin(3 * angle))
    return oaktwin.look_at(eye, (0, 0, 0.4), frame="body")


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

    def images(self, number):
        """The images of a frame by Replicator's names."""
        pose = world_from_body(number, self.settings["frames"]) @ self.camera.body_from_camera
        seen = self.scene.render(self.camera, pose, annotators=["distance_to_image_plane", "rgb"])
        measured = self.sensor(seen["distance_to_image_plane"], seen["rgb"], frame=number)
        return {**seen, "depth_sensor_distance": measured}

    def __call__(self, row):
        """Writes the files of the frame `row["id"]`; their names and hashes."""
        number = int(row["id"])
        hashes = {}
        for name, image in self.images(number).items():
            file = io.BytesIO()
            np.save(file, image)
            name = f"{name}_{number:04}.npy"
            hashes[name] = hashlib.sha256(file.getvalue()).hexdigest()
            self.write(number, name, file.getvalue())
        return {"id": number, "sha256": json.dumps(hashes)}

    def part(self, name):
        return self.folder / f"{name}.{os.getpid()}.part"

    def write(self, number, name, content):
        """The whole file or none: a worker that dies leaves at most a part of it under another name."""
        self.part(name).write_bytes(content)
        self.part(name).replace(self.folder / name)


class KilledOnce(FrameWriter):
    """For `--kill-at`: the first worker that comes to that frame dies in the middle of a file, as if the system killed it."""

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


def with_ray(settings, address, workers, blocks):
    """The frames' rows, made by a pool of workers."""
    # Before the import: nothing is sent anywhere, no progress bars.
    os.environ["RAY_USAGE_STATS_ENABLED"] = "0"
    os.environ.setdefault("RAY_DATA_DISABLE_PROGRESS_BARS", "1")
    import ray

    if address:
        ray.init(address=address, log_to_driver=False)
    else:
        # Rows are small; no store of gigabytes is needed.
        ray.init(num_cpus=workers, include_dashboard=False, object_store_memory=100 << 20, log_to_driver=False)
    numbers = ray.data.range(settings["frames"], override_num_blocks=blocks)
    # Ray restarts a worker that died and gives its rows to another.
    writer = FrameWriter if settings["kill_at"] is None else KilledOnce
    rows = numbers.map(writer, fn_constructor_args=[settings], compute=ray.data.ActorPoolStrategy(size=workers))
    found = rows.take_all()
    ray.shutdown()
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("-o", "--output", type=Path, default=Path("oaktwin-frames"), help="a folder that all machines see")
    parser.add_argument("--scene", type=Path, default=SCENE)
    parser.add_argument("--model", default="OAK-D Pro PoE")
    parser.add_argument("--preset", default="robotics", help="DepthAI's, without a filter over time")
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
    if arguments.local:
        make = FrameWriter(settings)
        rows = [make({"id": number}) for number in range(arguments.frames)]
    else:
        FrameWriter(settings)  # What is wrong with the settings is said here, once.
        blocks = arguments.blocks or 4 * arguments.workers
        rows = with_ray(settings, arguments.address, arguments.workers, blocks)

    hashes = {}
    for row in sorted(rows, key=lambda row: row["id"]):
        hashes |= json.loads(row["sha256"])
    print(f"{len(rows)} frames, {len(hashes)} files" + (", a worker was killed" if (arguments.output / KILLED).exists() else ""))
    remove_parts(arguments.output)
    manifest = json.dumps(hashes, indent=1)
    (arguments.output / MANIFEST).write_text(manifest)
    print(f"sha256 of all: {hashlib.sha256(manifest.encode()).hexdigest()}")


if __name__ == "__main__":
    sys.exit(main())
