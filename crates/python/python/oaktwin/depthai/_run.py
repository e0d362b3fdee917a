"""Runs a program, ends it in time, and turns its end into an exit code."""

from __future__ import annotations

import _thread
import contextlib
import os
import runpy
import sys
import threading
import traceback
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ._viewers import Viewers
from ._virtual import VirtualDevice, virtual_device
from ._windows import Windows

# Seconds that a program has to end after its pipelines have stopped, and after it was interrupted.
_PATIENCE_S = 2.0


@dataclass
class Run:
    """A program and how to run it.

    settings: the arguments of `virtual_device`.
    program: the path of the script and its arguments.
    frames: the images after which `q` is pressed, 0 for never; None to leave windows alone.
    seconds: the time after which the program is ended, or None.
    """

    device: Any
    settings: dict[str, Any]
    program: list[str]
    frames: int | None = None
    seconds: float | None = None


def run_program(run: Run) -> int:
    """Runs a program in this process and returns its exit code."""
    with contextlib.ExitStack() as stack:
        if run.frames is not None:
            for screen in (Windows(run.frames or None), Viewers(run.frames or None)):
                screen.open()
                stack.callback(screen.report)
                stack.callback(screen.close)
        virtual = virtual_device(run.device, **run.settings)
        device = virtual.__enter__()
        timer = _Timer(device, run.seconds)
        try:
            with _as_main(run.program):
                timer.start()
                runpy.run_path(run.program[0], run_name="__main__")
            code = 0
        except SystemExit as end:
            code = _exit_code(end)
        except KeyboardInterrupt:
            code = 0 if timer.has_fired else 130
        except BaseException:
            # A queue that closes is how a program notices that its time is over.
            code = 0 if timer.has_fired else 1
            if code and not device.errors:
                traceback.print_exc()
        finally:
            timer.cancel()
        if device.errors:
            code = 1
        # Its errors were shown when they occurred.
        with contextlib.suppress(*{type(error) for error in device.errors}):
            virtual.__exit__(None, None, None)
        return code


class _Timer:
    """Ends the program: stops its pipelines, then interrupts it, then ends the process."""

    def __init__(self, device: VirtualDevice, seconds: float | None) -> None:
        self.device, self.seconds = device, seconds
        self.has_fired = False
        self._is_over = threading.Event()

    def start(self) -> None:
        """Starts the time of the program."""
        if self.seconds is not None:
            threading.Thread(target=self._wait, daemon=True).start()

    def cancel(self) -> None:
        """The program has ended."""
        self._is_over.set()

    def _wait(self) -> None:
        if self._is_over.wait(self.seconds):
            return
        self.has_fired = True
        self.device.stop()
        if self._is_over.wait(_PATIENCE_S):
            return
        _thread.interrupt_main()
        if not self._is_over.wait(_PATIENCE_S):
            sys.stdout.flush()
            sys.stderr.flush()
            os._exit(1 if self.device.errors else 0)


@contextlib.contextmanager
def _as_main(program: list[str]) -> Iterator[None]:
    """The arguments and the search path that the program would have on its own."""
    before = sys.argv, sys.path[:]
    sys.argv = program
    sys.path.insert(0, str(Path(program[0]).resolve().parent))
    try:
        yield
    finally:
        sys.argv, sys.path[:] = before


def _exit_code(end: SystemExit) -> int:
    if end.code is None:
        return 0
    if isinstance(end.code, int):
        return end.code
    print(end.code, file=sys.stderr)
    return 1
