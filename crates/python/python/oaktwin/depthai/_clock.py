"""The time of a virtual device, and the instants at which its sensors measure."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from datetime import timedelta
from typing import Any

import depthai as dai

# Seconds between two looks at whether a pipeline still runs.
_STEP = 0.02


def _host_now() -> timedelta:
    clock: Any = dai.Clock
    now: timedelta = clock.now()
    return now


class Clock:
    """Time of one virtual device: seconds since its first pipeline has started.

    fast: whether time advances from frame to frame instead of with the wall clock: nothing is dropped, and every run is the same.
    """

    def __init__(self, *, fast: bool) -> None:
        self.fast = fast
        # The time after which no sensor measures, in seconds.
        self.end = float("inf")
        self._start: float | None = None
        self._host_start = timedelta(0)
        self._lock = threading.Lock()
        self._schedules: dict[float, Schedule] = {}

    def start(self) -> None:
        """Starts the clock, unless it runs."""
        with self._lock:
            if self._start is None:
                self._start = time.monotonic()
                self._host_start = timedelta(0) if self.fast else _host_now()

    def now(self) -> float:
        """The present time in seconds, 0 before the start."""
        return 0.0 if self._start is None else time.monotonic() - self._start

    def schedule(self, fps: float) -> Schedule:
        """The common schedule of all sensors with this rate."""
        with self._lock:
            return self._schedules.setdefault(fps, Schedule(self, fps))

    def stamp(self, message: dai.Buffer, seconds: float, sequence: int) -> None:
        """Writes the time stamps of device and host, and the sequence number, to a message."""
        message.setSequenceNum(sequence)
        message.setTimestampDevice(timedelta(seconds=seconds))
        message.setTimestamp(self.host_time(seconds))

    def host_time(self, seconds: float) -> timedelta:
        """The time on the host's clock; with `fast`, the device's."""
        return self._host_start + timedelta(seconds=seconds)


class Schedule:
    """The numbers of the frames that sensors of one rate take. Sensors that ask at nearly the same time take the same frame, so that the
    images of a stereo pair belong together even where frames are dropped.
    """

    def __init__(self, clock: Clock, fps: float) -> None:
        self.clock, self.fps = clock, fps
        self._current = -1
        self._lock = threading.Lock()

    def time(self, frame: int) -> float:
        """The time in seconds at which a frame is taken."""
        return frame / self.fps

    def is_over(self, frame: int) -> bool:
        """Whether a frame is after the end of the clock."""
        return self.time(frame) >= self.clock.end - 1e-9

    def next(self, last: int, is_running: Callable[[], bool]) -> int | None:
        """Waits for the frame after frame `last`, and returns its number, or None if the pipeline stops before."""
        if self.clock.fast:
            return last + 1 if is_running() and not self.is_over(last + 1) else None
        with self._lock:
            if self._current <= last:
                self._current = max(last + 1, int(self.clock.now() * self.fps))
            frame = self._current
        while is_running() and not self.is_over(frame):
            remaining = self.time(frame) - self.clock.now()
            if remaining <= 0:
                return frame
            time.sleep(min(remaining, _STEP))
        return None
