"""Delivery, latency and memory of `oaktwin bridge`, and its load on a network; run by `cargo xtask bench bridge`."""

import argparse
import os
import subprocess
from pathlib import Path

from ros_network import IN_NETWORK, Bridge, Lan, isolated, lan, result, start_peer, wait_for_peer

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


def measure_network(network: Lan, program: Path, arguments: argparse.Namespace, is_far: bool) -> str:
    """What reaches the other machine of a network while a publisher and a bridge run on this one."""
    bridge = Bridge(network.here, program, environment=IN_NETWORK)
    start = network.there if is_far else network.here
    images = start_peer(start, "subscribe", environment=IN_NETWORK)
    sniffer = start_peer(network.there, script="ros_sniffer.py", environment=IN_NETWORK)
    wait_for_peer(sniffer)
    seconds = min(arguments.seconds, 10)
    publisher = start_peer(
        network.here, "publish", "--size", arguments.size, "--seconds", str(seconds), "--wait", "3", environment=IN_NETWORK
    )
    published = result(publisher, seconds + 60)["published"]
    image = result(images)
    counts = result(sniffer)
    state, _ = bridge.stop()
    return (
        f"| {'the other' if is_far else 'the same'} | {published} | {100 * state['published'] / published:.2f} % | {100 * image['received'] / published:.2f} % "
        f"| {image.get('median_ms', float('nan')):.1f} ms | {counts['multicast_data']} | {counts['unicast']} | {counts['discovery']} |"
    )


def network_table(program: Path, arguments: argparse.Namespace) -> None:
    print("\nTwo machines (network namespaces), publisher and bridge on one, nodes found in the whole network:\n")
    with lan() as network:
        if network is None:
            print("skipped: network namespaces are not permitted")
            return
        print("| subscriber on machine | published | filtered | delivered | from stamp to subscriber | multicast datagrams of data | unicast | discovery |")
        print("|---|---:|---:|---:|---:|---:|---:|---:|")
        for is_far in (False, True):
            print(measure_network(network, program, arguments, is_far), flush=True)


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
    network_table(arguments.program, arguments)
    print(f"\nLatencies are medians and 95th percentiles. Load at the end: {os.getloadavg()[0]:.1f} on {os.cpu_count()} cores.")


if __name__ == "__main__":
    main()
