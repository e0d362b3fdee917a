# mypy: ignore-errors
"""An engine with its filters, which work where the engine's own do: see `crates/depth/src/engines/filters.rs`."""

from typing import Any

import warp as wp

from ._drift import assume
from ._filters import Filters, parsed

wp.set_module_options({"enable_backward": False, "fast_math": False, "fuse_fp": False})

_TOO_NEAR, _TOO_FAR = (wp.constant(code) for code in (2, 3))
# The range over which disparities are spread where filters change them.
_FILTERED_RANGE = 8192.0


@wp.func
def in_millimetres(metres: float) -> wp.uint16:
    """To whole millimetres, halves to even; 0 for what they cannot represent."""
    millimetres = metres * 1000.0
    if not (millimetres > 0.0 and millimetres < 65535.5):
        millimetres = 0.0
    return wp.uint16((millimetres + 8388608.0) - 8388608.0)


@wp.kernel
def to_millimetres(metres: wp.array3d(dtype=float), out: wp.array3d(dtype=wp.uint16)):
    n, y, x = wp.tid()
    out[n, y, x] = in_millimetres(metres[n, y, x])


@wp.kernel
def to_metres(millimetres: wp.array3d(dtype=wp.uint16), out: wp.array3d(dtype=float)):
    n, y, x = wp.tid()
    out[n, y, x] = float(millimetres[n, y, x]) / 1000.0


@wp.kernel
def to_whole(values: wp.array3d(dtype=float), out: wp.array3d(dtype=wp.uint16)):
    n, y, x = wp.tid()
    out[n, y, x] = wp.uint16(values[n, y, x])


@wp.kernel
def look_up(fixed: wp.array3d(dtype=wp.uint16), depths: wp.array(dtype=float), out: wp.array3d(dtype=float)):
    n, y, x = wp.tid()
    out[n, y, x] = depths[wp.int32(fixed[n, y, x])]


@wp.kernel
def explain_metres(metres: wp.array3d(dtype=float), whole: int, reasons: wp.array3d(dtype=wp.uint8)):
    """The reasons of pixels without a depth, or without one in whole millimetres."""
    n, y, x = wp.tid()
    z = metres[n, y, x]
    has_value = z > 0.0
    code = int(_TOO_FAR)
    if whole == 1:
        has_value = in_millimetres(z) > wp.uint16(0)
        if not z > 1.0:
            code = _TOO_NEAR
    if has_value:
        reasons[n, y, x] = wp.uint8(0)
    elif reasons[n, y, x] == wp.uint8(0):
        reasons[n, y, x] = wp.uint8(code)


@wp.kernel
def copy_codes(codes: wp.array3d(dtype=wp.uint8), out: wp.array3d(dtype=wp.uint8)):
    n, y, x = wp.tid()
    out[n, y, x] = codes[n, y, x]


class Chain:
    """Kernels of an engine and of its filters for images of one size, with the arrays that they need.

    kernels: the engine's, for this size. One with `disparities` measures fixed-point disparities for filters.
    pairs: the numbers of drifted pairs, or None.
    """

    def __init__(self, kernels: Any, texts: list[str], shape: tuple[int, int, int], device: Any, pairs: Any = None) -> None:
        self._kernels, self._shape, self._device, self._pairs = kernels, shape, device, pairs
        self._assumed = None if pairs is None else wp.empty(shape, dtype=float, device=device)
        of_disparity = [text for text in texts if parsed(text)[0] != "threshold"] if hasattr(kernels, "disparities") else []
        changing = [parsed(text)[0] for text in of_disparity if parsed(text)[0] != "brightness"]
        self._depths = None
        self._before = Filters([], shape, device)
        if changing:
            spreads = changing[-1] != "median"
            self._depths, level, most = kernels.disparities(_FILTERED_RANGE if spreads else None)
            self._before = Filters(of_disparity, shape, device, level, most)
        between = self._before.shape
        self._after = Filters([text for text in texts if text not in of_disparity], between, device)
        self.shape = self._after.shape
        if not (self._before or self._after):
            return
        self._measured = wp.empty(shape, dtype=float, device=device)
        self._codes = wp.empty(shape, dtype=wp.uint8, device=device)
        if self._before:
            self._fixed = wp.empty(shape, dtype=wp.uint16, device=device)
        self._metres = wp.empty(between, dtype=float, device=device) if self._before else self._measured
        self._millimetres = wp.empty(between, dtype=wp.uint16, device=device)

    def reset(self, items: Any) -> None:
        """Forgets the earlier images of some items, an array of numbers."""
        self._before.reset(items)
        self._after.reset(items)

    def launch(self, depth: Any, keys: Any, items: Any, frame: Any, out: Any, reasons: Any) -> None:
        """Measures and filters a batch."""
        if self._pairs is not None:
            wp.launch(assume, self._shape, [depth, self._pairs], [self._assumed], device=self._device)
            depth = self._assumed
        random = (keys, items, frame)
        if not (self._before or self._after):
            self._kernels.launch(depth, *random, out, reasons)
            if reasons.shape[0]:
                wp.launch(explain_metres, self._shape, [out, 0], [reasons], device=self._device)
            return
        explains, device = reasons.shape[0] > 0, self._device
        codes = self._codes if explains else reasons
        self._kernels.launch(depth, *random, self._measured, codes)
        metres = self._metres if self._after else out
        if self._before:
            wp.launch(to_whole, self._shape, [self._measured], [self._fixed], device=device)
            fixed, codes = self._before.run(self._fixed, codes)
            wp.launch(look_up, fixed.shape, [fixed, self._depths], [metres], device=device)
        if explains:
            wp.launch(explain_metres, metres.shape, [metres, 0], [codes], device=device)
        if self._after:
            wp.launch(to_millimetres, metres.shape, [metres], [self._millimetres], device=device)
            if explains:
                wp.launch(explain_metres, metres.shape, [metres, 1], [codes], device=device)
            filtered, codes = self._after.run(self._millimetres, codes)
            wp.launch(to_metres, self.shape, [filtered], [out], device=device)
        if explains:
            wp.launch(copy_codes, self.shape, [codes], [reasons], device=device)
