"""A separate network for a bridge and its peers, where that is permitted; otherwise the loopback interface of the machine."""

import json
import os
import shutil
import signal
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

# Tests that run at the same time on one network do not hear each other; the peers have the domain of who starts them.
DOMAIN = int(os.environ.setdefault("ROS_DOMAIN_ID", str(1 + os.getpid() % 100)))
ENVIRONMENT = os.environ | {"ROS_LOCALHOST_ONLY": "1"}
# Nodes find each other in the whole network, as ROS does by default.
IN_NETWORK = os.environ | {"ROS_LOCALHOST_ONLY": "0"}
# Seconds in which everything happens, however busy the machine is.
PATIENCE_S = 300
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


@dataclass
class Lan:
    """Two machines in a network."""

    # The starts of commands on each.
    here: list[str]
    there: list[str]


def enter(holder: subprocess.Popen) -> list[str]:
    return ["nsenter", f"--net=/proc/{holder.pid}/ns/net"]


@contextmanager
def lan() -> Iterator[Lan | None]:
    """Two network namespaces that are connected by a cable, or nothing where that is not permitted."""
    if not all(map(shutil.which, ["unshare", "nsenter", "ip"])):
        yield None
        return
    hold = "ip link set lo up && echo up && exec sleep 3600"
    holders = [
        subprocess.Popen(["unshare", "--net", "sh", "-c", hold], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL) for _ in range(2)
    ]
    try:
        is_up = all([holder.stdout.readline() == b"up\n" for holder in holders])
        here, there = holders
        cable = f"ip link add eth0 type veth peer name eth0 netns {there.pid}"
        plugs = [
            (holder, f"ip address add 10.77.0.{number}/24 dev eth0 && ip link set eth0 up && ip route add default dev eth0")
            for number, holder in ((1, here), (2, there))
        ]
        for holder, command in [(here, cable), *plugs]:
            is_up = is_up and subprocess.run([*enter(holder), "sh", "-c", command], stderr=subprocess.DEVNULL).returncode == 0
        yield Lan(enter(here), enter(there)) if is_up else None
    finally:
        for holder in holders:
            holder.kill()
            holder.wait()


class Bridge:
    """A running bridge."""

    def __init__(self, start: list[str], program: Path, *options: str, environment: dict[str, str] = ENVIRONMENT) -> None:
        topics = ["--depth", "/camera/depth/image_raw", "--info", "/camera/camera_info"]
        self.process = subprocess.Popen(
            [*start, program, "bridge", "--model", MODEL, *topics, "--json", *options],
            env=environment,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )
        self.events: list[dict] = []
        self.changed, self.is_over = threading.Condition(), False
        self.reader = threading.Thread(target=self.read, daemon=True)
        self.reader.start()
        self.wait(lambda event: event["event"] == "started")

    def read(self) -> None:
        """Collects the events until the output ends."""
        for line in self.process.stdout:
            with self.changed:
                self.events.append(json.loads(line))
                self.changed.notify_all()
        with self.changed:
            self.is_over = True
            self.changed.notify_all()

    def wait(self, is_wanted: Callable[[dict], bool]) -> None:
        """Waits for an event."""
        found = lambda: any(map(is_wanted, self.events))
        with self.changed:
            self.changed.wait_for(lambda: found() or self.is_over, PATIENCE_S)
            assert found(), self.events

    def wait_for_finding(self, code: str) -> None:
        self.wait(lambda event: event["event"] == "finding" and event["code"] == code)

    def memory(self) -> int:
        """The resident memory in bytes."""
        pages = Path(f"/proc/{self.process.pid}/statm").read_text().split()[1]
        return int(pages) * os.sysconf("SC_PAGE_SIZE")

    def stop(self) -> tuple[dict, list[dict]]:
        """Ends the bridge like Ctrl-C, and returns its last state and its findings."""
        self.process.send_signal(signal.SIGINT)
        assert self.process.wait(PATIENCE_S) == 130
        self.reader.join()
        assert self.events[-1]["event"] == "stopped"
        return self.events[-1], [event for event in self.events if event["event"] == "finding"]


def start_peer(
    start: list[str], *arguments: str, script: str = "ros_peer.py", environment: dict[str, str] = ENVIRONMENT
) -> subprocess.Popen:
    """Starts a publisher, a subscriber or another script."""
    command = [*start, sys.executable, Path(__file__).with_name(script), *arguments]
    pipe = subprocess.PIPE
    return subprocess.Popen(command, env=environment, stdin=pipe, stdout=pipe, stderr=subprocess.DEVNULL, text=True)


def wait_for_peer(peer: subprocess.Popen) -> None:
    """Waits until a publisher can be found, or a subscriber has received a message."""
    assert peer.stdout.readline() == "ready\n"


def result(peer: subprocess.Popen, seconds: float = PATIENCE_S) -> dict:
    """Ends the input of a peer, and returns what it prints at its end."""
    out, _ = peer.communicate(timeout=seconds)
    assert peer.returncode == 0
    return json.loads(out.splitlines()[-1])
