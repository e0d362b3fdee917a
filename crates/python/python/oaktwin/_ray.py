"""Frames of a data set that are made by Ray, on the processors of one machine or of a cluster."""

from __future__ import annotations

import json
import os
import socket
import sys
import threading
import time
import warnings
from _thread import interrupt_main
from collections.abc import Callable, Iterable, Iterator
from importlib import import_module
from itertools import islice
from typing import Any

from ._oaktwin import Error, Recipe, __version__

Batch = tuple[int, int]
# Tasks in flight for each processor: with one in reserve, no worker waits for the driver, and an autoscaler sees the demand.
RESERVE = 2
# Seconds after which the number of processors is read again, for clusters that grow or shrink.
REFRESH_S = 5
# A worker may be killed this many times in the same frames.
RETRIES = 3


# The recipe of a worker's last task, by its job.
last: dict[str, Recipe] = {}


def opened(job: dict[str, Any]) -> Recipe:
    """Returns the recipe of a job, whose files a worker process keeps open for its next task."""
    key = repr(job)
    if key not in last:
        last.clear()
        options = {name: job[name] for name in ("formats", "seed", "save_scenes", "catalog", "engine") if name in job}
        last[key] = Recipe(job["recipe"], **options)
    return last[key]


def make(batch: Batch, job: dict[str, Any], version: str) -> Batch:
    """Makes consecutive frames in a worker process; frames that a killed worker completed remain."""
    if version != __version__:
        raise Error(f"a worker has oaktwin {__version__}, but the driver {version}; install the same version on all machines")
    with warnings.catch_warnings():
        # The record of a frame contains its findings, about which the driver warns.
        warnings.simplefilter("ignore")
        opened(job).generate(job["output"], frames=batch, only_frames=True, workers=1)
    return batch


def connected(address: str | None, workers: int | None) -> tuple[Any, bool]:
    """Returns the package Ray, connected to a cluster, and whether the connection is ours to end."""
    # No usage statistics: set before the import.
    os.environ.setdefault("RAY_USAGE_STATS_ENABLED", "0")
    try:
        ray = import_module("ray")
    except ImportError as error:
        raise ImportError(f"data sets on several machines require Ray ({error}); install it: pip install oaktwin[ray]") from error
    if ray.is_initialized():
        return ray, False
    address = address or os.environ.get("RAY_ADDRESS", "local")
    quiet = {"log_to_driver": False, "logging_level": "ERROR"}
    try:
        if address == "local":
            # Frames are files, so that little data is transferred: the smallest object store is enough.
            ray.init(address=address, num_cpus=workers, include_dashboard=False, object_store_memory=80 << 20, **quiet)
        else:
            check_connection(address)
            ray.init(address=address, **quiet)
    except (OSError, RuntimeError, ValueError) as error:
        reason = str(error).partition("\n")[0].rstrip(".")
        if address == "local":
            raise Error(f"ray: cannot be started here ({reason}); free memory and disk space, or name a running cluster") from error
        raise Error(f"ray: cannot connect to {address} ({reason}); start a cluster with `ray start --head`, or use 'local'") from error
    return ray, True


def check_connection(address: str) -> None:
    """Raises an OSError if nothing answers at HOST:PORT, for which Ray waits for many minutes."""
    host, _, port = address.removeprefix("ray://").rpartition(":")
    if host and port.isdecimal():
        socket.create_connection((host.strip("[]"), int(port)), timeout=10).close()


def frames(
    batches: Iterable[Batch],
    job: dict[str, Any],
    *,
    address: str | None = None,
    workers: int | None = None,
    task: Callable[[Batch, dict[str, Any], str], Batch] = make,
) -> Iterator[Batch]:
    """Makes batches of frames, and yields each that is complete.

    batches: the first frame and the frame after the last one of each.
    job: the paths "recipe" and "output", which all machines can open, and the options "formats", "seed", "save_scenes", "catalog" and
        "engine" of a recipe, of which the program has not all.
    address: of the cluster: "auto", "host:port", "ray://host:port" or "local"; by default RAY_ADDRESS, else this machine.
    workers: the maximum number of batches that are made at the same time; by default the number of processors.
    task: what a worker does.

    The driver knows a few batches for each processor, however many there are in total.
    """
    ray, is_ours = connected(address, workers)
    # A frame has one processor.
    environment = {"env_vars": {"RAYON_NUM_THREADS": "1"}}
    remote = ray.remote(task).options(num_cpus=1, max_retries=RETRIES, runtime_env=environment)
    rest = iter(batches)
    running: dict[Any, Batch] = {}
    limit, refreshed = 0, -float("inf")
    try:
        # The files of a recipe may have changed since an earlier run with the same workers.
        job = ray.put({**job, "run": os.urandom(8)})
        while True:
            if time.monotonic() - refreshed > REFRESH_S:
                processors = max(1, int(ray.cluster_resources().get("CPU", 1)))
                limit, refreshed = min(RESERVE * processors, workers or sys.maxsize), time.monotonic()
            running |= {remote.remote(batch, job, __version__): batch for batch in islice(rest, max(0, limit - len(running)))}
            if not running:
                return
            for reference in ray.wait(list(running), timeout=1)[0]:
                yield result(ray, reference, running.pop(reference))
    finally:
        if is_ours:
            # Also ends the tasks.
            ray.shutdown()
        else:
            for reference in running:
                ray.cancel(reference)


def result(ray: Any, reference: Any, batch: Batch) -> Batch:
    """Returns the result of a task, or raises its error as if the frames had been made here."""
    try:
        made: Batch = ray.get(reference)
        return made
    except ray.exceptions.RayTaskError as error:
        raise error.cause if isinstance(error.cause, (Error, OSError)) else error
    except ray.exceptions.RayError as error:
        first, end = batch
        reason = str(error).partition("\n")[0].rstrip(".")
        raise Error(
            f"frames {first}..{end}: their worker was killed {RETRIES + 1} times ({reason}), which a lack of memory does; "
            "use fewer workers, and resume"
        ) from error


def main() -> int:
    """Makes frames for the program: reads a job and its batches from standard input, and writes the batches that are complete."""
    # Ray prints to standard output; the lines for the program have their own file.
    lines = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)

    def tell(**line: Any) -> None:
        print(json.dumps(line), file=lines, flush=True)

    def end_with_the_program() -> None:
        sys.stdin.read()
        interrupt_main()

    request = json.loads(sys.stdin.readline())
    threading.Thread(target=end_with_the_program, daemon=True).start()
    try:
        if request["version"] != __version__:
            raise Error(
                f"{sys.executable} has oaktwin {__version__}, but the program is {request['version']}; install the same version"
            )
        for batch in frames(map(tuple, request["batches"]), request["job"], address=request["address"], workers=request["workers"]):
            tell(done=batch)
    except KeyboardInterrupt:
        return 130
    except (Error, ImportError, OSError) as error:
        tell(error=str(error))
        return 2
    return 0

