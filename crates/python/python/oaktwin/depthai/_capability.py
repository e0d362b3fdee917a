"""The request of a camera's output by its capability, which DepthAI's own class does not let a program read."""

from __future__ import annotations

from typing import Any

import depthai as dai


class _Range:
    """What a program asked for: one value, several, or the smallest and the largest."""

    def __init__(self) -> None:
        self.values: tuple[Any, ...] = ()

    def fixed(self, value: Any) -> None:
        """Asks for one value."""
        self.values = (value,)

    def minMax(self, first: Any, second: Any = None) -> None:
        """Asks for a value between two."""
        self.values = tuple(first) if second is None else (first, second)

    def discrete(self, values: Any) -> None:
        """Asks for one of several values."""
        self.values = tuple(values)


class Capability:
    """DepthAI's ImgFrameCapability."""

    def __init__(self) -> None:
        self.size, self.fps = _Range(), _Range()
        self.type: dai.ImgFrame.Type | None = None
        self.resizeMode = dai.ImgResizeMode.CROP
        self.enableUndistortion: bool | None = None
        self.alphaScaling: float | None = None
        self.ispOutput = False

    def read(self, full: tuple[int, int]) -> tuple[Any, ...]:
        """The size, type, resize mode, rate, undistortion and scaling; the largest of several sizes and rates."""
        size = max(self.size.values, default=full)
        fps = max(self.fps.values, default=None)
        return size, self.type, self.resizeMode, fps, self.enableUndistortion, self.alphaScaling
