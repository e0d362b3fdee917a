"""Recording frames with point clouds as MCAP, compared with the Python package `mcap` writing the same messages.

`bench_record.py PROGRAM FRAMES [WIDTHxHEIGHT]`, run by `cargo xtask bench record`. The program renders, measures and records a
room along a trajectory. The peer gets its messages serialized, from the recording; reading them is not timed. Both compress chunks
of 4 MiB with zstd at level 1, and the peer does nothing else. Memory is sampled while the program runs.
"""

import math
import os
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import zstandard
from mcap import writer as mcap_writer
from mcap.reader import make_reader

CHUNK = 4 << 20
# Exact and measured depth, and the points of the measured one, whose colours are rendered. Nothing is lost for lack of texture.
SENSOR = (
    "--annotators distance_to_image_plane,depth_sensor_distance --engine stereo-noise --param confidenceThreshold=0"
)


def room():
    """A floor, a wall and pillars as OBJ."""
    boxes = [(-6, -6, -0.1, 6, 6, 0), (5.9, -6, 0, 6, 6, 3)]
    boxes += [(x - 0.1, y - 0.1, 0, x + 0.1, y + 0.1, 1.5) for x in range(-4, 5, 2) for y in range(-4, 5, 2)]
    lines = []
    for number, (x0, y0, z0, x1, y1, z1) in enumerate(boxes):
        lines += [f"v {x} {y} {z}" for x in (x0, x1) for y in (y0, y1) for z in (z0, z1)]
        for face in ((1, 2, 4, 3), (5, 7, 8, 6), (1, 5, 6, 2), (3, 4, 8, 7), (1, 3, 7, 5), (2, 6, 8, 4)):
            lines.append("f " + " ".join(str(corner + 8 * number) for corner in face))
    return "\n".join(lines) + "\n"


def trajectory(frames):
    """A circle, one pose in each thirtieth of a second."""
    poses = []
    for k in range(frames):
        half = math.pi * k / 97
        x, y, sine, cosine = math.cos(2 * half), math.sin(2 * half), math.sin(half), math.cos(half)
        poses.append(f"{k / 30:.3f} {x:.9f} {y:.9f} 0.8 0 0 {sine:.9f} {cosine:.9f}\n")
    return "".join(poses)


def processor_s(who):
    used = resource.getrusage(who)
    return used.ru_utime + used.ru_stime


def record(program, folder, frames, size):
    """Runs the program. Returns elapsed and processor time, and the samples of its resident memory in MiB."""
    (folder / "room.obj").write_text(room())
    (folder / "poses.txt").write_text(trajectory(frames))
    words = f"render room.obj --up z --model OAK4-D --resolution {size} --trajectory poses.txt {SENSOR}"
    before, start = processor_s(resource.RUSAGE_CHILDREN), time.perf_counter()
    command = [program, *words.split(), "--record", "own.mcap"]
    process = subprocess.Popen(command, cwd=folder, stdout=subprocess.DEVNULL)
    samples = []
    while process.poll() is None:
        try:
            pages = int(Path(f"/proc/{process.pid}/statm").read_text().split()[1])
            samples.append(pages * os.sysconf("SC_PAGE_SIZE") / 2**20)
        except (OSError, IndexError):
            pass  # It has just ended.
        time.sleep(0.02)
    if process.returncode:
        sys.exit(f"the program ended with {process.returncode}")
    elapsed = time.perf_counter() - start
    return elapsed, processor_s(resource.RUSAGE_CHILDREN) - before, samples


def write_again(folder):
    """Writes the recording's messages with `mcap`. Returns elapsed and processor time, and the number and bytes of messages."""
    # The package has no option for the level; its default is 3.
    mcap_writer.zstandard = type("Level1", (), {"compress": staticmethod(lambda data: zstandard.compress(data, 1))})
    elapsed = processor = 0.0
    count = size = 0
    channels = {}
    with (folder / "own.mcap").open("rb") as source, (folder / "peer.mcap").open("wb") as target:
        writer = mcap_writer.Writer(target, chunk_size=CHUNK, compression=mcap_writer.CompressionType.ZSTD)
        writer.start("ros2")
        for schema, channel, message in make_reader(source).iter_messages():
            start, used = time.perf_counter(), processor_s(resource.RUSAGE_SELF)
            if channel.id not in channels:
                made = writer.register_schema(schema.name, schema.encoding, schema.data)
                channels[channel.id] = writer.register_channel(channel.topic, "cdr", made, channel.metadata)
            writer.add_message(
                channels[channel.id], message.log_time, message.data, message.publish_time, message.sequence
            )
            elapsed += time.perf_counter() - start
            processor += processor_s(resource.RUSAGE_SELF) - used
            count, size = count + 1, size + len(message.data)
        start, used = time.perf_counter(), processor_s(resource.RUSAGE_SELF)
        writer.finish()
        target.flush()
        os.fsync(target.fileno())
        elapsed += time.perf_counter() - start
        processor += processor_s(resource.RUSAGE_SELF) - used
    return elapsed, processor, count, size


def main():
    program, frames = Path(sys.argv[1]).resolve(), int(sys.argv[2])
    size = sys.argv[3] if len(sys.argv) > 3 else "1280x800"
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        own, own_processor, samples = record(program, folder, frames, size)
        peer, peer_processor, count, bytes_written = write_again(folder)
        files = [(folder / name).stat().st_size / 2**20 for name in ("own.mcap", "peer.mcap")]
    print(f"{frames} frames of {size}: {count} messages, {bytes_written / 2**20:.0f} MiB\n")
    print("| | frames/s | processor time, ms/frame | file, MiB |\n|---|---:|---:|---:|")
    print(f"| oaktwin, rendering included | {frames / own:.1f} | {1e3 * own_processor / frames:.1f} | {files[0]:.0f} |")
    print(f"| mcap in Python, writing only | {frames / peer:.1f} | {1e3 * peer_processor / frames:.1f} | {files[1]:.0f} |")
    print(f"| ratio | {peer / own:.2f} x | {peer_processor / own_processor:.2f} x | |")
    if len(samples) >= 8:
        early, late = max(samples[: len(samples) // 4]), max(samples[len(samples) // 2 :])
        print(f"\nmemory: at most {early:.1f} MiB in the first quarter, {late:.1f} MiB in the second half")


main()
