"""A fixture for tests of programs for DepthAI.

In conftest.py:

    from oaktwin.depthai.pytest import virtual_oak  # noqa: F401

In a test, with the options of `oaktwin.depthai.virtual_device`:

    def test_app(virtual_oak):
        virtual_oak("OAK4-D", scene="room.usd", look_at=(0, 0, 1.1, 1, 0, 1))
        my_app.main()
"""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Iterator

import pytest

from ._viewers import Viewers
from ._virtual import VirtualDevice, virtual_device
from ._windows import Windows

__all__ = ["virtual_oak"]


@pytest.fixture
def virtual_oak() -> Iterator[Callable[..., VirtualDevice]]:
    """A function that plugs in a virtual device until the end of the test, by default one that is fast and deterministic.

    It takes the arguments of `virtual_device`, and `frames`: the images after which the key q is pressed. Windows of OpenCV, Open3D and Rerun are not opened. At the
    end, the test fails if a node has raised an exception.
    """
    with contextlib.ExitStack() as stack:

        def plug(*arguments: object, frames: int | None = 10, fast: bool = True, **options: object) -> VirtualDevice:
            for screen in (Windows(frames), Viewers(frames)):
                screen.open()
                stack.callback(screen.close)
            return stack.enter_context(virtual_device(*arguments, fast=fast, **options))  # type: ignore[arg-type]

        yield plug
