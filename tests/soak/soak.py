"""Runs the program and the package for a long time: memory and descriptors must stay flat, and results the same.

Run by `cargo xtask soak`, which builds both. Each load repeats its inputs, so that its outputs can be compared with earlier
ones, and runs in its own process, whose memory and descriptors Linux reports below /proc. Prints a table; the exit code
is 1 if a load failed.
"""

import argparse
import hashlib
import io
import os
import signal
import subprocess
import sys
import tempfile
import threading
import time
from collections import Counter
from pathlib import Path

import numpy as np
from mcap.stream_reader import StreamReader

import oaktwin
import page

MODEL = "OAK4-D"
#: The number of different poses and depth images, which repeat.
PERIOD = 97
#: The size of rendered and streamed images, and the horizontal field of view of the latter, degrees.
WIDTH, HEIGHT, HFOV_DEG = 320, 200, 80
#: The allowed growth of memory after the warm-up: relative, and in MiB.
GROWTH, SLACK_MIB = 0.02, 4.0
#: The share of the time that is warm-up: allocators and caches fill.
WARM_UP = 0.25
#: The time that a load gets to repeat an output, seconds.
PATIENCE = 120
#: The encapsulation and the time stamp at the start of a ROS message with a header, bytes.
STAMP = 12


class Load:
    """A process under load: samples of its memory and descriptors, the outputs compared, and what went wrong."""

    def __init__(self, name, unit, seconds, command, **pipes):
        self.name, self.unit, self.seconds = name, unit, seconds
        self.samples, self.faults, self.outputs, self.compared, self.first = [], Counter(), 0, 0, {}
        self.is_over = False
        self.spare_descriptors = 0
        self.errors = tempfile.TemporaryFile()
        self.process = subprocess.Popen([str(word) for word in command], stderr=self.errors, **pipes)

    def run(self, *threads, expected):
        """Samples the process while threads feed it and read its output; interrupts it when the time is up."""
        threads = [threading.Thread(target=self.guarded, args=(work,), daemon=True) for work in threads]
        for thread in threads:
            thread.start()
        end = time.monotonic() + self.seconds
        while self.process.poll() is None:
            late = time.monotonic() - end
            # A busy machine gets more time to repeat an output.
            if late > (0 if self.compared else PATIENCE):
                break
            self.sample()
            time.sleep(min(1.0, self.seconds / 200))
        self.is_over = True
        self.process.send_signal(signal.SIGINT)
        for thread in threads:
            thread.join(120)
        code = self.process.wait(120)
        if code not in expected:
            self.errors.seek(0)
            self.faults[f"exit code {code}: {self.errors.read()[-300:].decode(errors='replace')}"] += 1

    def guarded(self, work):
        try:
            work()
        except Exception as error:  # The table reports it, unless the output ends because the time is up.
            if self.is_over:
                return
            self.faults[f"{type(error).__name__}: {error}"] += 1

    def sample(self):
        """Samples the resident memory in MiB and the number of descriptors."""
        place = Path(f"/proc/{self.process.pid}")
        try:
            pages = int((place / "statm").read_text().split()[1])
            self.samples.append((pages * os.sysconf("SC_PAGE_SIZE") / 2**20, len(os.listdir(place / "fd"))))
        except (OSError, IndexError):
            pass  # It has just ended.

    def compare(self, key, data):
        """Compares bytes with the first ones of the same key."""
        digest = hashlib.blake2b(data, digest_size=16).digest()
        if key in self.first:
            self.compared += 1
            if self.first[key] != digest:
                self.faults["changed bytes"] += 1
        else:
            self.first[key] = digest

    def row(self):
        """Judges the load, and returns its row of the table."""
        warm = self.samples[int(len(self.samples) * WARM_UP) :]
        if len(warm) < 8 or not self.compared:
            self.faults["too short to judge"] += 1
            return f"| {self.name} | {self.outputs} {self.unit} | | | | {self.verdict()} |"
        halves = warm[: len(warm) // 2], warm[len(warm) // 2 :]
        (before, files_before), (after, files_after) = ([max(column) for column in zip(*half)] for half in halves)
        if after > before * (1 + GROWTH) + SLACK_MIB:
            self.faults["memory grew"] += 1
        if files_after > files_before + self.spare_descriptors:
            self.faults["descriptors leaked"] += 1
        memory = f"{before:.1f} | {after:.1f} | {files_before} → {files_after}"
        return f"| {self.name} | {self.outputs} {self.unit}, {self.compared} compared | {memory} | {self.verdict()} |"

    def verdict(self):
        return "; ".join(f"{fault} ({count} x)" for fault, count in self.faults.items()) or "good"


def write_room(folder):
    """Writes a floor, a wall and rows of pillars."""
    boxes = [((-6, -6, -0.1), (6, 6, 0)), ((5.9, -6, 0), (6, 6, 3))]
    boxes += [((x - 0.1, y - 0.1, 0), (x + 0.1, y + 0.1, 1.5)) for x in range(-4, 5, 2) for y in range(-4, 5, 2)]
    corners = np.array(np.meshgrid([0, 1], [0, 1], [0, 1], indexing="ij")).reshape(3, 8).T
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    faces = np.array([triangle for a, b, c, d in quads for triangle in ((a, b, c), (a, c, d))], np.uint32)
    points = np.concatenate([np.where(corners, high, low) for low, high in boxes]).astype(np.float32)
    triangles = np.concatenate([faces + 8 * index for index in range(len(boxes))]).astype(np.uint32)
    path = folder / "room.usda"
    oaktwin.Scene.from_triangles(points, triangles).save_usd(path)
    return path


def write_trajectory(folder, poses):
    """Writes a circle of PERIOD poses, again and again."""
    circle = []
    for angle in 2 * np.pi * np.arange(PERIOD) / PERIOD:
        x, y, sine, cosine = np.cos(angle), np.sin(angle), np.sin(angle / 2), np.cos(angle / 2)
        circle.append(f"{x:.9f} {y:.9f} 0.8 0 0 {sine:.9f} {cosine:.9f}")
    path = folder / "trajectory.txt"
    path.write_text("".join(f"{k / 30:.3f} {circle[k % PERIOD]}\n" for k in range(poses)))
    return path


def render(program, seconds, folder):
    """A trajectory recorded into a pipe; the exact images of a pose repeat, the sensor's images have new noise."""
    pipe = folder / "soak.mcap"
    os.mkfifo(pipe)
    poses = write_trajectory(folder, int(seconds * 200) + 10 * PERIOD)
    command = [program, "render", write_room(folder), "--model", MODEL, "--resolution", f"{WIDTH}x{HEIGHT}"]
    command += ["--trajectory", poses, "--record", pipe]
    load = Load("`render --record`", "messages", seconds, command, stdout=subprocess.DEVNULL)

    def read():
        topics, moments = {}, Counter()
        with pipe.open("rb") as stream:
            for record in StreamReader(stream).records:
                kind = type(record).__name__
                if kind == "Channel":
                    topics[record.id] = record.topic
                elif kind == "Message":
                    topic = topics[record.channel_id]
                    load.outputs += 1
                    if is_exact(topic):
                        load.compare((topic, moments[topic] % PERIOD), record.data[STAMP:])
                    moments[topic] += 1

    load.run(read, expected=(0, 130))
    return load


def is_exact(topic):
    """Whether the messages of a topic have no noise, and begin with a header."""
    return "sensor" not in topic and not topic.startswith("/tf")


def sense(program, seconds, _folder):
    """A stream of depth images through the program; some results are compared with the package's."""
    x = np.linspace(0.5, 6, WIDTH, dtype=np.float32)
    images = [np.broadcast_to(x + np.float32(k / 100), (HEIGHT, WIDTH)).copy() for k in range(PERIOD)]
    command = [program, "sense", "-", "--model", MODEL, "--input-kind", "z", "--hfov", HFOV_DEG, "--sequence"]
    load = Load("`sense -`", "images", seconds, command, stdin=subprocess.PIPE, stdout=subprocess.PIPE)
    sensor = oaktwin.DepthSensor(oaktwin.Device(MODEL), hfov_deg=HFOV_DEG)
    total = int(seconds * 2000) + 10 * PERIOD

    def feed():
        header = io.BytesIO()
        shape = (total, HEIGHT, WIDTH)
        np.lib.format.write_array_header_1_0(header, {"descr": "<f4", "fortran_order": False, "shape": shape})
        try:
            load.process.stdin.write(header.getvalue())
            for k in range(total):
                load.process.stdin.write(images[k % PERIOD].data)
        except BrokenPipeError:
            pass  # The time is up.

    def read():
        stream = load.process.stdout
        np.lib.format.read_magic(stream)
        np.lib.format.read_array_header_1_0(stream)
        length = 4 * WIDTH * HEIGHT
        while len(data := stream.read(length)) == length:
            if load.outputs % PERIOD == 0:
                expected = sensor(images[load.outputs % PERIOD], frame=load.outputs)
                load.compared += 1
                load.faults += Counter({"changed bytes": int(data != expected.tobytes())})
            load.outputs += 1

    load.run(feed, read, expected=(0, 130))
    return load


def package(_program, seconds, _folder):
    """Calls of the package with random sizes; each cycle of a worker is the same."""
    command = [sys.executable, __file__, "--worker"]
    load = Load("Python loop", "cycles of 60 sizes", seconds, command, stdout=subprocess.PIPE)

    def read():
        for line in load.process.stdout:
            load.outputs += 1
            load.compare("cycle", line)

    load.run(read, expected=(-signal.SIGINT, 1, 130))
    return load


def work():
    """Prints the digest of all results of each cycle, until it is interrupted."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    device = oaktwin.Device(MODEL)
    while True:
        random, digest = np.random.default_rng(0), hashlib.blake2b(digest_size=16)
        for _ in range(60):
            for result in calls(device, random):
                digest.update(np.ascontiguousarray(result).tobytes())
        print(digest.hexdigest(), flush=True)


def calls(device, random):
    """Calls each part of the package with images and meshes of random sizes."""
    height, width = (int(n) for n in random.integers(32, 400, 2))
    depth = random.uniform(0.2, 12, (height, width)).astype(np.float32)
    image = random.integers(0, 256, (height, width), dtype=np.uint8)
    camera = oaktwin.Camera(size=(width, height), K=[[width, 0, width / 2], [0, width, height / 2], [0, 0, 1]])
    corners = (random.uniform(-2, 2, (3 * int(random.integers(1, 500)), 3)) + [0, 0, 4]).astype(np.float32)
    faces = np.arange(len(corners), dtype=np.uint32).reshape(-1, 3)
    scene = oaktwin.Scene.from_triangles(corners, faces)
    yield from scene.render(camera, np.eye(4), annotators=["distance_to_camera", "normals"]).values()
    yield oaktwin.DepthSensor(device, camera=camera)(depth, frame=0)
    yield oaktwin.Filter("speckle")(depth)
    yield oaktwin.StereoMatcher(hfov_deg=HFOV_DEG, baseline=0.075)(image, np.roll(image, -4, axis=1))["depth"]


def studio(program, seconds, folder):
    """The page with hundreds of sockets, floods of requests, documents that are none, and broken uploads."""
    command = [program, "studio", write_room(folder), "--no-open"]
    load = Load("`studio`", "frames", seconds, command, stdout=subprocess.PIPE, text=True)
    # Sockets that leave are closed a little later.
    load.spare_descriptors = page.FLOOD

    def visit():
        link = load.process.stdout.readline().strip()
        page.harass(link.removeprefix("http://").strip("/"), load)

    load.run(visit, expected=(0, 130))
    return load


LOADS = {"render": render, "sense": sense, "python": package, "studio": studio}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", type=Path)
    parser.add_argument("--minutes", type=float, default=60)
    parser.add_argument("--load", choices=LOADS, action="append")
    parser.add_argument("--worker", action="store_true")
    args = parser.parse_args()
    if args.worker:
        return work()
    with tempfile.TemporaryDirectory() as folder:
        loads = {}

        def run(name):
            loads[name] = LOADS[name](args.program, 60 * args.minutes, Path(folder))

        threads = [threading.Thread(target=run, args=(name,)) for name in args.load or LOADS]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
    print(f"{args.minutes:g} minutes; memory is the peak of each half after the warm-up\n")
    print("| load | outputs | MiB, first half | MiB, second half | descriptors | result |")
    print("|---|---|---:|---:|---:|---|")
    for load in loads.values():
        print(load.row())
    return int(len(loads) < len(threads) or any(load.faults for load in loads.values()))


if __name__ == "__main__":
    sys.exit(main())
