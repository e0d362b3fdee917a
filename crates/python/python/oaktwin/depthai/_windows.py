"""Windows of OpenCV without a screen: images are counted, and a key is pressed after some of them."""

from __future__ import annotations

import sys
import time
from typing import Any

import numpy as np

_NO_KEY = -1
# A program that waits longer for a key waits again.
_LONGEST_MS = 10
# The functions of windows that have no effect without a screen, and what they return.
_SILENT: dict[str, Any] = {
    "namedWindow": None,
    "destroyWindow": None,
    "destroyAllWindows": None,
    "resizeWindow": None,
    "moveWindow": None,
    "setWindowTitle": None,
    "setWindowProperty": None,
    "setMouseCallback": None,
    "createTrackbar": None,
    "setTrackbarPos": None,
    "getTrackbarPos": 0,
    "getWindowProperty": 1.0,
    "getWindowImageRect": (0, 0, 0, 0),
    "startWindowThread": 0,
}


class Windows:
    """Replaces the windows of OpenCV, if it is installed.

    frames: after so many key presses were awaited with an image on show, `q` is pressed; None for never.
    """

    def __init__(self, frames: int | None) -> None:
        self.frames = frames
        # How often each window was drawn, and its last image.
        self.counts: dict[str, int] = {}
        self.images: dict[str, np.ndarray[Any, Any]] = {}
        self._waits = 0
        self._is_new = False
        self._before: dict[str, Any] = {}
        self._module: Any = None

    def open(self) -> None:
        """Replaces the functions of OpenCV's windows."""
        try:
            import cv2
        except ImportError:
            return
        self._module = cv2
        self._replace("imshow", self._show)
        for name in ("waitKey", "waitKeyEx", "pollKey"):
            self._replace(name, self._wait)
        for name, value in _SILENT.items():
            self._replace(name, lambda *_, value=value, **__: value)
        self._replace("selectROI", lambda *_, **__: (0, 0, 0, 0))

    def _replace(self, name: str, function: Any) -> None:
        self._before[name] = getattr(self._module, name, None)
        setattr(self._module, name, function)

    def close(self) -> None:
        """Puts OpenCV's functions back."""
        for name, function in self._before.items():
            if function is None:
                delattr(self._module, name)
            else:
                setattr(self._module, name, function)
        self._before.clear()

    def _show(self, name: str, image: Any) -> None:
        # OpenCV's own function rejects what is not an image.
        array = np.asarray(image)
        if array.ndim not in (2, 3) or not array.size:
            raise ValueError(f"imshow: window {name!r}: an array of the shape {array.shape} is not an image")
        self.counts[name] = self.counts.get(name, 0) + 1
        self.images[name] = array.copy()
        self._is_new = True

    def _wait(self, delay: int = 0, *_: Any, **__: Any) -> int:
        if self._is_new:
            self._waits += 1
            self._is_new = False
        elif delay > 0:
            # A program that asks again and again leaves the processor to the others meanwhile, as with a real window.
            time.sleep(min(delay, _LONGEST_MS) / 1000)
        return ord("q") if self.frames is not None and self._waits >= self.frames else _NO_KEY

    def report(self) -> None:
        """Prints what the windows have shown."""
        for name, count in self.counts.items():
            shape = "x".join(map(str, self.images[name].shape[1::-1]))
            print(f"oaktwin: window {name!r}: {count} images, {shape} px", file=sys.stderr)
