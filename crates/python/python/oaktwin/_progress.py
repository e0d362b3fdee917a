"""Progress bars."""

from __future__ import annotations

import sys
import time

# Shorter calls have no bar; and no bar is drawn more often.
_DELAY_S = 1.0
_INTERVAL_S = 0.1
_WIDTH = 30


class Bar:
    """A progress bar on standard error, which notebooks show too."""

    def __init__(self) -> None:
        self._start = time.monotonic()
        self._drawn = self._start + _DELAY_S - _INTERVAL_S
        self._width = 0

    def __call__(self, done: int, total: int) -> None:
        now = time.monotonic()
        is_last = done >= total
        if now - self._drawn < _INTERVAL_S and not (is_last and self._width):
            return
        self._drawn = now
        elapsed = now - self._start
        full = _WIDTH * done // max(total, 1)
        left = f", {elapsed / done * (total - done):.0f} s left" if done and not is_last else ""
        text = f"{'█' * full}{'░' * (_WIDTH - full)} {done}/{total}, {elapsed:.0f} s{left}"
        # Blanks remove the rest of a longer line.
        sys.stderr.write(f"\r{text.ljust(self._width)}" + ("\n" if is_last else ""))
        sys.stderr.flush()
        self._width = len(text)
