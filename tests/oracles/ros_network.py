"""A separate network for a bridge and its peers, where that is permitted; otherwise the loopback interface of the machine."""

import json
import os
import shutil
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

# A domain that is hardly used otherwise.
DOMAIN = 77
ENVIRONMENT = os.environ | {"ROS_DOMAIN_ID": str(DOMAIN), "ROS_LOCALHOST_ONLY": "1"}
MODEL = "OAK-D-Pro-PoE"


@contextmanager
def isolated() -> Iterator[list[str]]:
    """The start of commands that run in a network with a loopback interface only."""
    if not all(map(shutil.which, ["unshare", "nsenter", "ip"])):
        yield []
        return
    holder = subprocess.Popen(
        ["unshare", "--net", "sh", "-c", "ip link set lo up && echo up && exec sleep 3600"],
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
    )
    try:
        is_up = holder.stdout.readline() == b"up\n"
        yield ["nsenter", f"--net=/proc/{holder.pid}/ns/net"] if is_up else []
    finally:
        holder.kill()
        holder.wait()


class Bridge:
    """A running bridge."""

    def __init__(self, start: list[str], program: Path, *options: str) -> None:
        topics = ["--depth", "/camera/depth/image_raw", "--info", "/camera/camera_info"]
        self.process = subprocess.Popen(
            [*start, program, "bridge", "--model", MODEL, *topics, "--json", *options],
            env=ENVIRONMENT,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )
        assert json.loads(self.process.stdout.readline())["event"] == "started"

    def memory(self) -> int:
        """The resident memory in bytes."""
        pages = Path(f"/proc/{self.process.pid}/statm").read_text().split()[1]
        return int(pages) * os.sysconf("SC_PAGE_SIZE")

    def stop(self) -> tuple[dict, list[dict]]:
        """Ends the bridge like Ctrl-C, and returns its last state and its findings."""
        self.process.send_signal(signal.SIGINT)
        out, _ = self.process.communicate(timeout=20)
        assert self.process.returncode == 130
        events = [json.loads(line) for line in out.splitlines()]
        assert events[-1]["event"] == "stopped"
        return events[-1], [event for event in events if event["event"] == "finding"]


def start_peer(start: list[str], *arguments: str, script: str = "ros_peer.py") -> subprocess.Popen:
    """Starts a publisher, a subscriber or another script."""
    command = [*start, sys.executable, Path(__file__).with_name(script), *arguments]
    return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)


def result(peer: subprocess.Popen, seconds: float = 90) -> dict:
    """What a peer prints at its end."""
    out, _ = peer.communicate(timeout=seconds)
    assert peer.returncode == 0
    return json.loads(out)
