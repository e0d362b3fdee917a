# mypy: ignore-errors
"""The kernels of "stereo-noise": the steps of `crates/depth/src/stereo_noise`, operation by operation, for depth without colours."""

import math
from typing import Any

import numpy as np
import warp as wp

from ._random import DROPOUT, JITTER, box_muller, key, philox, sine_of_turns

wp.set_module_options({"enable_backward": False, "fast_math": False, "fuse_fp": False})

# The parameters that can differ between environments.
PER_WORLD = ("bias", "pixelLocking", "jitter", "closeRangeFactor", "dropout")
# The columns of the array of these, as the kernels use them.
_BIAS, _LOCKING, _JITTER, _CLOSE, _DROPOUT = (wp.constant(column) for column in range(5))
# The codes of reasons.
_NO_SURFACE, _TOO_NEAR, _TOO_FAR, _OUTSIDE, _OCCLUDED, _LEFT_RIGHT, _DROPPED, _BORDER = (
    wp.constant(code) for code in (1, 2, 3, 4, 5, 8, 9, 10)
)
# Images wider than this have no window sums of 8 bits.
_MAX_SIDE = 255


@wp.struct
class Scale:
    """The parameters in single precision and the pixels of one image size."""

    px_m: float
    image_px: float
    close_from: float
    close_per_px: float
    jitter_mean: float
    shift: float
    steps: float
    max_fixed: int
    window: int
    normals: int
    dilation: int
    invalid_edge: int
    half: int
    occlusion: int
    left_right: int
    left_right_px: float


@wp.func
def disparity(z: float, px_m: float) -> float:
    d = float(0.0)
    if z > 0.0 and z < wp.inf:
        d = wp.min(px_m / z, 8192.0)
    return d


@wp.func
def place(d: float, x: int, image_px: float) -> float:
    """The position of a pixel in the right image."""
    return wp.max(float(x) - d * image_px, -1048576.0)


@wp.kernel
def to_disparities(depth: wp.array3d(dtype=float), s: Scale, d: wp.array3d(dtype=float), least: wp.array3d(dtype=float)):
    """Disparities, and the least position of each pixel and all on its right."""
    n, y = wp.tid()
    width = depth.shape[2]
    leftmost = float(wp.inf)
    for i in range(width):
        x = width - 1 - i
        value = disparity(depth[n, y, x], s.px_m)
        d[n, y, x] = value
        leftmost = wp.min(leftmost, place(value, x, s.image_px))
        least[n, y, x] = leftmost


@wp.kernel
def along_rows(d: wp.array3d(dtype=float), s: Scale, out: wp.array3d(dtype=float)):
    n, y, x = wp.tid()
    largest = d[n, y, x]
    for at in range(wp.max(x - s.dilation, 0), wp.min(x + s.dilation + 1, d.shape[2])):
        largest = wp.max(largest, d[n, y, at])
    out[n, y, x] = largest


@wp.kernel
def across_rows(
    along: wp.array3d(dtype=float), d: wp.array3d(dtype=float), s: Scale, out: wp.array3d(dtype=float), least: wp.array3d(dtype=float)
):
    """Near surfaces that are widened, and the least positions."""
    n, y = wp.tid()
    width = d.shape[2]
    leftmost = float(wp.inf)
    for i in range(width):
        x = width - 1 - i
        largest = float(0.0)
        for at in range(wp.max(y - s.dilation, 0), wp.min(y + s.dilation + 1, d.shape[1])):
            largest = wp.max(largest, along[n, at, x])
        value = d[n, y, x]
        if largest > value + 1.0:
            value = largest
        out[n, y, x] = value
        leftmost = wp.min(leftmost, place(value, x, s.image_px))
        least[n, y, x] = leftmost


@wp.func
def is_hidden(d: wp.array3d(dtype=float), least: wp.array3d(dtype=float), n: int, y: int, x: int, nearer: float, image_px: float) -> bool:
    """Whether something nearer covers the position of a pixel in the right image. What is nearer is on the right."""
    own = d[n, y, x]
    here = place(own, x, image_px)
    width = d.shape[2]
    found = bool(False)
    if here >= 0.0 and x + 1 < width:
        if here >= least[n, y, x + 1]:
            cell = wp.trunc(here)
            after = cell + 1.0
            enough = own * image_px + nearer
            at = x + 1
            this = place(d[n, y, at], at, image_px)
            while at < width:
                if found or least[n, y, at] >= after:
                    break
                next = float(wp.inf)
                if at + 1 < width:
                    next = place(d[n, y, at + 1], at + 1, image_px)
                lies = this >= cell and this < after
                stretches = next >= after and next < after + 1.0 and next - this <= 2.0
                reaches = this >= cell - 1.0 and this < cell and stretches
                if (lies or reaches) and d[n, y, at] * image_px >= enough:
                    found = True
                this = next
                at += 1
    return found


@wp.kernel
def field(
    keys: wp.array2d(dtype=wp.uint32),
    items: wp.array(dtype=wp.uint32),
    frame: wp.array(dtype=wp.uint32),
    s: Scale,
    out: wp.array3d(dtype=wp.uint16),
):
    """The random numbers whose window sums are the jitter: a block of words makes 16 bytes or 8 normal numbers."""
    n, row, block = wp.tid()
    w = wp.min(n, keys.shape[0] - 1)
    words = philox(wp.uint32(block), wp.uint32(row), frame[0], items[n], keys[w, 0], keys[w, 1])
    group = block // 16
    lane = block % 16
    for k in range(4):
        if s.normals == 1:
            both = box_muller(((words[k] >> wp.uint32(16)) << wp.uint32(16)) + wp.uint32(0x8000), words[k] << wp.uint32(16))
            column = 64 * (2 * group + k // 2) + 16 * (k % 2) + lane
            for part in range(2):
                at = column + 32 * part
                if at < out.shape[2]:
                    fixed = both[part] * 1024.0 + 8192.0 + 8388608.0
                    out[n, row, at] = wp.uint16(fixed - 8388608.0)
        else:
            column = 4 * (64 * group + 16 * k + lane)
            for part in range(4):
                if column + part < out.shape[2]:
                    out[n, row, column + part] = wp.uint16((words[k] >> wp.uint32(8 * part)) & wp.uint32(0xFF))


@wp.kernel
def sums_along_rows(numbers: wp.array3d(dtype=wp.uint16), s: Scale, out: wp.array3d(dtype=wp.uint16)):
    n, y = wp.tid()
    total = wp.int32(0)
    for at in range(s.window - 1):
        total += wp.int32(numbers[n, y, at])
    for x in range(out.shape[2]):
        total += wp.int32(numbers[n, y, x + s.window - 1])
        out[n, y, x] = wp.uint16(total)
        total -= wp.int32(numbers[n, y, x])


@wp.func
def row_byte(row: int, at: int, frame: wp.uint32, item: wp.uint32, key0: wp.uint32, key1: wp.uint32) -> wp.uint32:
    """The byte of a row's random words."""
    word = at // 4
    words = philox(wp.uint32(16 * (word // 64) + word % 16), wp.uint32(row), frame, item, key0, key1)
    return (words[word // 16 % 4] >> wp.uint32(8 * (at % 4))) & wp.uint32(0xFF)


@wp.func
def measured(
    n: int,
    y: int,
    x: int,
    narrow: wp.array3d(dtype=float),
    narrow_least: wp.array3d(dtype=float),
    wide: wp.array3d(dtype=float),
    wide_least: wp.array3d(dtype=float),
    sums: wp.array3d(dtype=wp.uint16),
    keys: wp.array2d(dtype=wp.uint32),
    items: wp.array(dtype=wp.uint32),
    frame: wp.array(dtype=wp.uint32),
    worlds: wp.array2d(dtype=float),
    s: Scale,
    metres: wp.array(dtype=float),
    out: wp.array3d(dtype=float),
    reasons: wp.array3d(dtype=wp.uint8),
):
    w = wp.min(n, worlds.shape[0] - 1)
    k = wp.min(n, keys.shape[0] - 1)
    d = narrow[n, y, x]
    bias = worlds[w, _BIAS]
    close_change = worlds[w, _CLOSE]
    code = int(0)
    if d == 0.0:
        code = _NO_SURFACE
    if s.dilation > 0:
        thin = d
        d = wide[n, y, x]
        behind = bool(False)
        if s.occlusion == 1 and thin == d:
            behind = is_hidden(narrow, narrow_least, n, y, x, 1.0, s.image_px)
        differs = bool(False)
        if s.left_right == 1 and not behind:
            differs = is_hidden(wide, wide_least, n, y, x, s.left_right_px, s.image_px)
        if behind:
            code = _OCCLUDED
            d = 0.0
        elif differs:
            code = _LEFT_RIGHT
            d = 0.0
        elif d > 0.0:
            code = 0
    elif s.occlusion == 1 and d > 0.0:
        if is_hidden(narrow, narrow_least, n, y, x, 1.0, s.image_px):
            code = _OCCLUDED
            d = 0.0
    limit = wp.uint32(worlds[w, _DROPOUT])
    if limit > wp.uint32(0):
        low = row_byte(y, x, frame[0], items[n], keys[k, 2], keys[k, 3])
        high = row_byte(y, s.half + x, frame[0], items[n], keys[k, 2], keys[k, 3])
        if d > 0.0 and low + wp.uint32(256) * high < limit:
            code = _DROPPED
            d = 0.0
    total = wp.int32(0)
    for at in range(s.window):
        total += wp.int32(sums[n, y + at, x])
    factor = float(1.0)
    if close_change != 0.0:
        close = (d - s.close_from) * s.close_per_px
        factor = 1.0 + close_change * wp.min(wp.max(close, 0.0), 1.0)
    biased = d + factor * bias
    locked = biased - factor * worlds[w, _LOCKING] * sine_of_turns(biased)
    jitter = (float(total) - s.jitter_mean) * (factor * worlds[w, _JITTER])
    steps = (locked + jitter - s.shift) * s.steps
    bounded = wp.min(wp.max(steps, 0.0), float(s.max_fixed) + 1.0)
    fixed = wp.int32((bounded + 8388608.0) - 8388608.0)
    band = float(0.0)
    if s.occlusion == 1:
        band = s.image_px
    seen = d > 0.0 and float(x) - d * band >= 0.0 and fixed <= s.max_fixed and x >= s.invalid_edge
    if not seen:
        fixed = 0
    out[n, y, x] = metres[fixed]
    if reasons.shape[0] > 0:
        if fixed > 0:
            code = 0
        elif code == 0:
            if s.occlusion == 1 and d * s.image_px > float(x):
                code = _OUTSIDE
            elif x < s.invalid_edge:
                code = _BORDER
            elif (d + bias - s.shift) * s.steps > 1.0:
                code = _TOO_NEAR
            else:
                code = _TOO_FAR
        reasons[n, y, x] = wp.uint8(code)


@wp.kernel
def measure_pixels(
    narrow: wp.array3d(dtype=float),
    narrow_least: wp.array3d(dtype=float),
    wide: wp.array3d(dtype=float),
    wide_least: wp.array3d(dtype=float),
    sums: wp.array3d(dtype=wp.uint16),
    keys: wp.array2d(dtype=wp.uint32),
    items: wp.array(dtype=wp.uint32),
    frame: wp.array(dtype=wp.uint32),
    worlds: wp.array2d(dtype=float),
    s: Scale,
    metres: wp.array(dtype=float),
    out: wp.array3d(dtype=float),
    reasons: wp.array3d(dtype=wp.uint8),
):
    n, y, x = wp.tid()
    measured(n, y, x, narrow, narrow_least, wide, wide_least, sums, keys, items, frame, worlds, s, metres, out, reasons)


@wp.kernel
def measure_rows(
    narrow: wp.array3d(dtype=float),
    narrow_least: wp.array3d(dtype=float),
    wide: wp.array3d(dtype=float),
    wide_least: wp.array3d(dtype=float),
    sums: wp.array3d(dtype=wp.uint16),
    keys: wp.array2d(dtype=wp.uint32),
    items: wp.array(dtype=wp.uint32),
    frame: wp.array(dtype=wp.uint32),
    worlds: wp.array2d(dtype=float),
    s: Scale,
    metres: wp.array(dtype=float),
    out: wp.array3d(dtype=float),
    reasons: wp.array3d(dtype=wp.uint8),
):
    """The same, faster on a CPU."""
    n, y = wp.tid()
    for x in range(narrow.shape[2]):
        measured(n, y, x, narrow, narrow_least, wide, wide_least, sums, keys, items, frame, worlds, s, metres, out, reasons)


class StereoNoise:
    """The engine for images of one size, with the arrays that it needs."""

    PER_WORLD = PER_WORLD
    # The parameters that change the measurement, and those that only colours need.
    PARAMETERS = frozenset(
        {
            *PER_WORLD,
            "focalLength",
            "baseline",
            "width",
            "subpixel",
            "subpixelFractionalBits",
            "extendedDisparity",
            "disparityShift",
            "occlusion",
            "leftRightCheck",
            "leftRightCheckThreshold",
            "numInvalidateEdgePixels",
            "edgeDilation",
            "window",
            "depthRounding",
        }
    )
    COLOURS = frozenset({"confidenceThreshold", "dotContrast", "ambient"})

    def __init__(self, parameters: dict[str, Any], worlds: dict[str, Any], shape: tuple[int, int, int], device: Any) -> None:
        count, height, width = shape
        p = parameters
        image_px = width / p["width"]
        side = min(max(_rounded(p["window"] * image_px), 1), _MAX_SIDE)
        normals = side * side < 16
        bits = int(p["subpixelFractionalBits"])
        largest = (95 + p["disparityShift"]) * (2 if p["extendedDisparity"] else 1)
        full, none = (p["focalLength"] * p["baseline"] / z for z in (6.0, 7.0))
        s = Scale()
        s.px_m = np.float32(p["focalLength"] * p["baseline"])
        s.image_px = np.float32(image_px)
        s.close_from, s.close_per_px = np.float32(none), np.float32(1.0 / (full - none))
        s.jitter_mean = np.float32(side * side * (8192.0 if normals else 127.5))
        s.shift, s.steps = float(p["disparityShift"]), float(1 << bits)
        s.max_fixed = (largest - p["disparityShift"]) << bits
        s.window, s.normals = side, int(normals)
        s.dilation = min(_rounded(p["edgeDilation"] * image_px), _MAX_SIDE // 2)
        s.invalid_edge = _rounded(p["numInvalidateEdgePixels"] * image_px)
        s.half = -(-width // 64) * 64
        s.occlusion = int(p["occlusion"])
        s.left_right = int(p["occlusion"] and p["leftRightCheck"])
        s.left_right_px = max(np.float32(p["leftRightCheckThreshold"]) * np.float32(image_px), np.float32(1.0))
        self._scale, self._shape, self._device = s, shape, device
        self._parameters, self._largest = p, largest
        self._by_rows = not device.is_cuda
        variance = 1024.0**2 if normals else 65535 / 12
        columns = {
            "bias": lambda value: value,
            "pixelLocking": lambda value: value,
            "jitter": lambda value: value / math.sqrt(side * side * variance),
            "closeRangeFactor": lambda value: value - 1.0,
            "dropout": lambda value: np.floor(value * 65536.0 + 0.5),
        }
        values = [columns[name](np.asarray(worlds.get(name, p[name]), np.float64)) for name in PER_WORLD]
        table = np.stack(np.broadcast_arrays(*np.atleast_1d(*values)), axis=1).astype(np.float32)
        self._worlds = wp.array(table, dtype=float, device=device)
        self._metres = wp.array(_depths(p, bits, s.max_fixed), dtype=float, device=device)

        def empty(rows: int, columns: int, dtype: Any = float) -> Any:
            return wp.empty((count, rows, columns), dtype=dtype, device=device)

        self._narrow, self._narrow_least = empty(height, width), empty(height, width)
        self._wide, self._wide_least = self._narrow, self._narrow_least
        if s.dilation:
            self._along, self._wide, self._wide_least = (empty(height, width) for _ in range(3))
        self._field = empty(height + side - 1, width + side - 1, wp.uint16)
        self._sums = self._field if side == 1 else empty(height + side - 1, width, wp.uint16)

    @staticmethod
    def keys(seed: int, camera: str) -> list[int]:
        """The keys of the random numbers of an image."""
        return [*key(seed, camera, JITTER), *key(seed, camera, DROPOUT)]

    def disparities(self, spread_over: float | None) -> tuple[Any, float, int]:
        """Measures fixed-point disparities from now on, in place of metres, for filters: spread over a range, if one is given.

        Returns the depth of each, the value of a disparity of one pixel, and the largest value.
        """
        bits = int(self._parameters["subpixelFractionalBits"])
        scale = 1.0 if spread_over is None else spread_over / (self._largest << bits)
        fixed = np.arange(self._scale.max_fixed + 1)
        values = np.maximum(np.floor(fixed * scale + 0.5), fixed > 0)
        self._metres = wp.array(values.astype(np.float32), dtype=float, device=self._device)
        depths = wp.array(_depths(self._parameters, bits, 65535, scale), dtype=float, device=self._device)
        return depths, scale * (1 << bits), int(values[-1])

    def launch(self, depth: Any, keys: Any, items: Any, frame: Any, out: Any, reasons: Any) -> None:
        """Measures a batch."""
        count, height, width = self._shape
        s, device = self._scale, self._device
        rows = height + s.window - 1
        numbers = width + s.window - 1
        blocks = 16 * -(-numbers // (128 if s.normals else 256))
        wp.launch(field, (count, rows, blocks), [keys, items, frame, s], [self._field], device=device)
        if s.window > 1:
            wp.launch(sums_along_rows, (count, rows), [self._field, s], [self._sums], device=device)
        wp.launch(to_disparities, (count, height), [depth, s], [self._narrow, self._narrow_least], device=device)
        if s.dilation:
            wp.launch(along_rows, self._shape, [self._narrow, s], [self._along], device=device)
            wide = [self._wide, self._wide_least]
            wp.launch(across_rows, (count, height), [self._along, self._narrow, s], wide, device=device)
        images = [self._narrow, self._narrow_least, self._wide, self._wide_least, self._sums]
        random = [keys, items, frame]
        kernel, size = (measure_rows, self._shape[:2]) if self._by_rows else (measure_pixels, self._shape)
        wp.launch(kernel, size, [*images, *random, self._worlds, s, self._metres], [out, reasons], device=device)


def _rounded(value: float) -> int:
    """To whole pixels, halves up."""
    return math.floor(value + 0.5)


def _depths(p: dict[str, Any], bits: int, last: int, scale: float = 1.0) -> Any:
    """The depth of each fixed-point disparity, metres, with `scale` units per step."""
    d = np.arange(1, last + 1) * (1 / (1 << bits) / scale) + p["disparityShift"]
    exact = p["focalLength"] * p["baseline"] / d * 1000.0
    millimetres = np.floor(exact + 0.5) if p["depthRounding"] == "nearest" else np.floor(exact)
    metres = np.where(millimetres > 65535, 0.0, millimetres / 1000.0)
    return np.concatenate([[0.0], metres]).astype(np.float32)
