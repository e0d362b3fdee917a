"""Delivery, latency and memory of `oaktwin bridge` over the loopback interface; run by `cargo xtask bench bridge`."""

import argparse
import os
import subprocess
from pathlib import Path

from ros_network import Bridge, isolated, result, start_peer

# Images, the encoding of both sides, and whether point clouds are published, too.
CASES = [("16UC1", False), ("32FC1", False), ("16UC1", True)]


def measure(start: list[str], program: Path, arguments: argparse.Namespace, encoding: str, points: bool) -> str:
    size = arguments.size
    bridge = Bridge(start, program, "--encoding", encoding, *(["--points"] if points else []))
    images = start_peer(start, "subscribe")
    clouds = start_peer(start, "subscribe", "--topic", "/oak/points", "--message", "points") if points else None
    wait = 2.0
    publisher = start_peer(
        start, "publish", "--size", size, "--encoding", encoding, "--seconds", str(arguments.seconds), "--wait", str(wait)
    )
    memory = []
    # The first seconds fill the caches of the DDS library.
    for until in (wait + 10, max(1.0, arguments.seconds - 20)):
        try:
            publisher.wait(until)
        except subprocess.TimeoutExpired:
            memory.append(bridge.memory() / 2**20)
    published = result(publisher, arguments.seconds + 60)["published"]
    image = result(images)
    cloud = result(clouds) if clouds else None
    state, _ = bridge.stop()
    own = state["latency_ms"]
    delivered = f"{100 * image['received'] / published:.2f} %"
    if cloud:
        delivered += f", points {100 * cloud['received'] / published:.2f} %"
    return (
        f"| {encoding}{', points' if points else ''} | {published} | {100 * state['published'] / published:.2f} % | {delivered} "
        f"| {own['median']:.1f} / {own['p95']:.1f} ms | {image['median_ms']:.1f} / {image['p95_ms']:.1f} ms "
        f"| {' → '.join(f'{mib:.0f}' for mib in memory)} MiB |"
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", type=Path)
    parser.add_argument("--seconds", type=float, default=60)
    parser.add_argument("--size", default="1280x800")
    arguments = parser.parse_args()
    limit = Path("/proc/sys/net/core/rmem_max").read_text().strip()
    print(f"{arguments.size} at 30 Hz for {arguments.seconds:.0f} s; net.core.rmem_max {limit}\n")
    print("| images | published | filtered | delivered | latency in the bridge | from stamp to subscriber | memory |")
    print("|---|---:|---:|---:|---:|---:|---:|")
    with isolated() as start:
        for encoding, points in CASES:
            print(measure(start, arguments.program, arguments, encoding, points), flush=True)
    print(f"\nLatencies are medians and 95th percentiles. Load at the end: {os.getloadavg()[0]:.1f} on {os.cpu_count()} cores.")


if __name__ == "__main__":
    main()
