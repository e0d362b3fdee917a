# mypy: ignore-errors
"""The kernels of filters: the steps of `crates/depth/src/filter`, operation by operation, on 16-bit images whose invalid value is 0."""

from typing import Any

import numpy as np
import warp as wp

wp.set_module_options({"enable_backward": False, "fast_math": False, "fuse_fp": False})

# The names of the filters in the order of their reasons.
NAMES = ("median", "spatial", "temporal", "speckle", "decimation", "threshold", "brightness")
# The recent frames that each persistency regards, and in how many of them a pixel must have been valid.
_PERSISTENCIES = {
    "PERSISTENCY_OFF": (0, 1),
    "VALID_8_OUT_OF_8": (8, 8),
    "VALID_2_IN_LAST_3": (3, 2),
    "VALID_2_IN_LAST_4": (4, 2),
    "VALID_2_OUT_OF_8": (8, 2),
    "VALID_1_IN_LAST_2": (2, 1),
    "VALID_1_IN_LAST_5": (5, 1),
    "VALID_1_IN_LAST_8": (8, 1),
    "PERSISTENCY_INDEFINITELY": (0, 0),
}
# The reason of the first filter.
_FIRST_REASON = 32


@wp.kernel
def explain(image: wp.array3d(dtype=wp.uint16), code: int, reasons: wp.array3d(dtype=wp.uint8)):
    """A pixel with a value needs no reason, and one that lost its value has this one."""
    n, y, x = wp.tid()
    if image[n, y, x] > wp.uint16(0):
        reasons[n, y, x] = wp.uint8(0)
    elif reasons[n, y, x] == wp.uint8(0):
        reasons[n, y, x] = wp.uint8(code)


@wp.kernel
def median(image: wp.array3d(dtype=wp.uint16), radius: int, bits: int, out: wp.array3d(dtype=wp.uint16)):
    """The median of a square: the largest number that at most half of the others are below, found bit by bit."""
    n, y, x = wp.tid()
    side = 2 * radius + 1
    half = (side * side) // 2
    found = int(0)
    for i in range(bits):
        trial = found + (1 << (bits - 1 - i))
        below = int(0)
        for dy in range(side):
            row = wp.clamp(y + dy - radius, 0, image.shape[1] - 1)
            for dx in range(side):
                column = wp.clamp(x + dx - radius, 0, image.shape[2] - 1)
                if wp.int32(image[n, row, column]) < trial:
                    below += 1
        if below <= half:
            found = trial
    out[n, y, x] = wp.uint16(found)


@wp.func
def mixed(first: int, second: int, alpha: float) -> int:
    return int(float(first) * alpha + float(second) * (1.0 - alpha) + 0.5)


@wp.func
def smooth_row(image: wp.array3d(dtype=wp.uint16), n: int, y: int, back: int, alpha: float, delta: int, radius: int):
    """One direction along a row, of which the last pixel is left alone."""
    width = image.shape[2]
    start = (width - 1) * back
    before = wp.int32(image[n, y, start])
    filled = int(0)
    for i in range(1, width - 1 + back):
        x = i
        if back == 1:
            x = width - 1 - i
        pixel = wp.int32(image[n, y, x])
        is_hole = pixel <= back
        begun = before != 0
        distance = wp.abs(pixel - before)
        longer = wp.min(filled + 1, 65535)
        kept = pixel
        if begun and is_hole and longer < radius:
            kept = before
        if begun and not is_hole and distance + back > 0 and distance <= delta:
            kept = mixed(pixel, before, alpha)
        if begun:
            filled = 0
            if is_hole:
                filled = longer
        image[n, y, x] = wp.uint16(kept)
        before = kept


@wp.kernel
def smooth_rows(image: wp.array3d(dtype=wp.uint16), alpha: float, delta: int, radius: int):
    n, y = wp.tid()
    smooth_row(image, n, y, 0, alpha, delta, radius)
    smooth_row(image, n, y, 1, alpha, delta, radius)


@wp.kernel
def smooth_columns(image: wp.array3d(dtype=wp.uint16), alpha: float, delta: int):
    """Downwards, where holes are no edges, and upwards."""
    n, x = wp.tid()
    height = image.shape[1]
    before = wp.int32(image[n, 0, x])
    for y in range(1, height):
        pixel = wp.int32(image[n, y, x])
        if wp.abs(pixel - before) < delta:
            pixel = mixed(pixel, before, alpha)
            image[n, y, x] = wp.uint16(pixel)
        before = pixel
    for i in range(1, height):
        y = height - 1 - i
        pixel = wp.int32(image[n, y, x])
        if pixel != 0 and before != 0 and wp.abs(pixel - before) < delta:
            pixel = mixed(pixel, before, alpha)
            image[n, y, x] = wp.uint16(pixel)
        before = pixel


@wp.kernel
def remember(
    image: wp.array3d(dtype=wp.uint16),
    alpha: float,
    delta: int,
    frames: int,
    wanted: int,
    phase: wp.array(dtype=wp.uint32),
    last: wp.array3d(dtype=wp.uint16),
    history: wp.array3d(dtype=wp.uint8),
):
    """One frame: bit n of a pixel's history says whether it was valid in frame 8 k + n of the last 8."""
    n, y, x = wp.tid()
    at = wp.int32(phase[0])
    new = wp.int32(image[n, y, x])
    old = wp.int32(last[n, y, x])
    past = wp.int32(history[n, y, x])
    valid = int(0)
    for age in range(1, frames + 1):
        valid += (past >> ((at + 8 - age) & 7)) & 1
    own = 1 << at
    kept = new
    begun = own
    if new != 0 and old != 0 and wp.abs(new - old) < delta:
        kept = int(float(new) * alpha + float(old) * (1.0 - alpha))
        begun = past | own
    if new != 0:
        last[n, y, x] = wp.uint16(kept)
        history[n, y, x] = wp.uint8(begun)
    else:
        history[n, y, x] = wp.uint8(past & (255 - own))
        if valid >= wanted:
            kept = old
    image[n, y, x] = wp.uint16(kept)


@wp.kernel
def forget(items: wp.array(dtype=int), last: wp.array3d(dtype=wp.uint16), history: wp.array3d(dtype=wp.uint8)):
    i, y, x = wp.tid()
    last[items[i], y, x] = wp.uint16(0)
    history[items[i], y, x] = wp.uint8(0)


@wp.kernel
def next_phase(phase: wp.array(dtype=wp.uint32)):
    phase[0] = (phase[0] + wp.uint32(1)) % wp.uint32(8)


@wp.func
def signed(value: wp.uint16) -> int:
    """A pixel as OpenCV's speckle filter reads it."""
    number = wp.int32(value)
    if number > 32767:
        number -= 65536
    return number


@wp.func
def similar(a: wp.uint16, b: wp.uint16, threshold: int) -> bool:
    return a != wp.uint16(0) and b != wp.uint16(0) and wp.abs(signed(a) - signed(b)) <= threshold


@wp.func
def root(parents: wp.array2d(dtype=int), n: int, pixel: int) -> int:
    at = pixel
    above = parents[n, at]
    while above != at:
        at = above
        above = parents[n, at]
    return at


@wp.func
def join(parents: wp.array2d(dtype=int), n: int, first: int, second: int):
    """Joins two regions. Parents have smaller numbers; where another thread was faster, its region is joined, too."""
    a = first
    b = second
    joined = bool(False)
    while not joined:
        a = root(parents, n, a)
        b = root(parents, n, b)
        low = wp.min(a, b)
        high = wp.max(a, b)
        if low == high:
            joined = True
        else:
            known = wp.atomic_min(parents, n, high, low)
            joined = known == high
            a = low
            b = known


@wp.kernel
def begin_regions(width: int, parents: wp.array2d(dtype=int), sizes: wp.array2d(dtype=int)):
    n, y, x = wp.tid()
    parents[n, y * width + x] = y * width + x
    sizes[n, y * width + x] = 0


@wp.kernel
def join_regions(image: wp.array3d(dtype=wp.uint16), threshold: int, parents: wp.array2d(dtype=int)):
    n, y, x = wp.tid()
    here = image[n, y, x]
    pixel = y * image.shape[2] + x
    if x > 0:
        if similar(here, image[n, y, x - 1], threshold):
            join(parents, n, pixel, pixel - 1)
    if y > 0:
        if similar(here, image[n, y - 1, x], threshold):
            join(parents, n, pixel, pixel - image.shape[2])


@wp.kernel
def count_regions(width: int, parents: wp.array2d(dtype=int), sizes: wp.array2d(dtype=int)):
    n, y, x = wp.tid()
    wp.atomic_add(sizes, n, root(parents, n, y * width + x), 1)


@wp.kernel
def drop_regions(parents: wp.array2d(dtype=int), sizes: wp.array2d(dtype=int), largest: int, image: wp.array3d(dtype=wp.uint16)):
    n, y, x = wp.tid()
    if sizes[n, root(parents, n, y * image.shape[2] + x)] <= largest:
        image[n, y, x] = wp.uint16(0)


@wp.kernel
def decimate(
    image: wp.array3d(dtype=wp.uint16),
    factor: int,
    mode: int,
    codes: wp.array3d(dtype=wp.uint8),
    out: wp.array3d(dtype=wp.uint16),
    out_codes: wp.array3d(dtype=wp.uint8),
):
    """A block becomes its first pixel (mode 0), the lower median of its valid pixels (1), or their mean, rounded down (2)."""
    n, y, x = wp.tid()
    top = y * factor
    left = x * factor
    bottom = wp.min(top + factor, image.shape[1])
    right = wp.min(left + factor, image.shape[2])
    kept = wp.int32(image[n, top, left])
    if mode > 0:
        count = int(0)
        total = int(0)
        for row in range(top, bottom):
            for column in range(left, right):
                value = wp.int32(image[n, row, column])
                total += value
                if value > 0:
                    count += 1
        kept = 0
        if mode == 2 and count > 0:
            kept = total // count
        if mode == 1 and count > 0:
            for row in range(top, bottom):
                for column in range(left, right):
                    value = wp.int32(image[n, row, column])
                    above = int(0)
                    same = int(0)
                    for other_row in range(top, bottom):
                        for other_column in range(left, right):
                            other = wp.int32(image[n, other_row, other_column])
                            if other > value:
                                above += 1
                            elif other == value:
                                same += 1
                    if value > 0 and above <= count // 2 and count // 2 < above + same:
                        kept = value
    out[n, y, x] = wp.uint16(kept)
    if codes.shape[0] > 0:
        out_codes[n, y, x] = codes[n, top, left]


@wp.kernel
def limit(image: wp.array3d(dtype=wp.uint16), least: int, most: int):
    n, y, x = wp.tid()
    value = wp.int32(image[n, y, x])
    if value < least or value > most:
        image[n, y, x] = wp.uint16(0)


def parsed(text: str) -> tuple[str, dict[str, str]]:
    """The name and the settings of a filter, as `oaktwin.DepthSensor.filters` writes it."""
    name, _, settings = text.partition(":")
    return name, dict(setting.split("=") for setting in settings.split(",") if setting)


def decimated(texts: list[str], height: int, width: int) -> tuple[int, int]:
    """The size of a filtered image."""
    for name, settings in map(parsed, texts):
        if name == "decimation":
            factor = int(settings["factor"])
            height, width = (max(side // factor, min(side, 1)) for side in (height, width))
    return height, width


class Filters:
    """Filters of images of one size, with the arrays that they need.

    level: the pixel value of one pixel of disparity; 1 for millimetres.
    most: the largest value of a pixel.
    """

    def __init__(
        self, texts: list[str], shape: tuple[int, int, int], device: Any, level: float = 1.0, most: int = 65535
    ) -> None:
        self._device, self.shape, self._bits, self._any = device, shape, most.bit_length(), bool(texts)
        # Without colours, "brightness" does nothing.
        chosen = [(name, settings) for name, settings in map(parsed, texts) if name != "brightness"]
        self._memories: list[tuple[Any, Any]] = []
        self._steps = [self._step(name, settings, level) for name, settings in chosen]
        self._no_codes = wp.empty((0, 0, 0), dtype=wp.uint8, device=device)

    def __bool__(self) -> bool:
        return self._any

    def reset(self, items: Any) -> None:
        """Forgets the earlier images of some items."""
        for last, history in self._memories:
            wp.launch(forget, (len(items), *last.shape[1:]), [items], [last, history], device=self._device)

    def run(self, image: Any, codes: Any) -> tuple[Any, Any]:
        """Filters images, which may change, and their reasons; returns both, with the size of filtered ones."""
        for code, step in self._steps:
            image, codes = step(image, codes)
            if codes.shape[0]:
                wp.launch(explain, image.shape, [image, code], [codes], device=self._device)
        return image, codes

    def _step(self, name: str, settings: dict[str, str], level: float) -> tuple[int, Any]:
        make = {
            "median": self._median,
            "spatial": self._spatial,
            "temporal": self._temporal,
            "speckle": self._speckle,
            "decimation": self._decimation,
            "threshold": self._threshold,
        }[name]
        return _FIRST_REASON + NAMES.index(name), make(settings, level)

    def _image(self, shape: tuple[int, ...], dtype: Any = wp.uint16) -> Any:
        return wp.empty(shape, dtype=dtype, device=self._device)

    def _median(self, settings: dict[str, str], _level: float) -> Any:
        radius, out = int(settings["size"]) // 2, self._image(self.shape)
        bits, device = self._bits, self._device

        def step(image: Any, codes: Any) -> Any:
            wp.launch(median, image.shape, [image, radius, bits], [out], device=device)
            return out, codes

        return step

    def _spatial(self, settings: dict[str, str], _level: float) -> Any:
        alpha, device = float(np.float32(settings["alpha"])), self._device
        delta, radius, iterations = (int(settings[name]) for name in ("delta", "radius", "iterations"))

        def step(image: Any, codes: Any) -> Any:
            count, height, width = image.shape
            for _ in range(iterations):
                wp.launch(smooth_rows, (count, height), [image, alpha, delta, radius], device=device)
                wp.launch(smooth_columns, (count, width), [image, alpha, delta], device=device)
            return image, codes

        return step

    def _temporal(self, settings: dict[str, str], _level: float) -> Any:
        alpha, delta, device = float(np.float32(settings["alpha"])), int(settings["delta"]), self._device
        frames, wanted = _PERSISTENCIES[settings["persistency"]]
        phase = wp.zeros(1, dtype=wp.uint32, device=device)
        last, history = (wp.zeros(self.shape, dtype=dtype, device=device) for dtype in (wp.uint16, wp.uint8))
        self._memories.append((last, history))

        def step(image: Any, codes: Any) -> Any:
            wp.launch(remember, image.shape, [image, alpha, delta, frames, wanted, phase], [last, history], device=device)
            wp.launch(next_phase, 1, [], [phase], device=device)
            return image, codes

        return step

    def _speckle(self, settings: dict[str, str], level: float) -> Any:
        largest = min(int(settings["range"]), (1 << 31) - 1)
        threshold, device = min(int(int(settings["difference"]) * level + 0.5), 65535), self._device
        count, height, width = self.shape
        parents, sizes = (self._image((count, height * width), int) for _ in range(2))

        def step(image: Any, codes: Any) -> Any:
            if largest > 0:
                wp.launch(begin_regions, image.shape, [width], [parents, sizes], device=device)
                wp.launch(join_regions, image.shape, [image, threshold], [parents], device=device)
                wp.launch(count_regions, image.shape, [width, parents], [sizes], device=device)
                wp.launch(drop_regions, image.shape, [parents, sizes, largest], [image], device=device)
            return image, codes

        return step

    def _decimation(self, settings: dict[str, str], _level: float) -> Any:
        factor, device = int(settings["factor"]), self._device
        mode = ("PIXEL_SKIPPING", "NON_ZERO_MEDIAN", "NON_ZERO_MEAN").index(settings["mode"])
        count, height, width = self.shape
        self.shape = (count, *(max(side // factor, min(side, 1)) for side in (height, width)))
        out, out_codes = self._image(self.shape), self._image(self.shape, wp.uint8)

        def step(image: Any, codes: Any) -> Any:
            wp.launch(decimate, out.shape, [image, factor, mode, codes], [out, out_codes], device=device)
            return out, out_codes if codes.shape[0] else codes

        return step

    def _threshold(self, settings: dict[str, str], _level: float) -> Any:
        least, most, device = int(settings["min"]), int(settings["max"]), self._device

        def step(image: Any, codes: Any) -> Any:
            wp.launch(limit, image.shape, [image, least, most], device=device)
            return image, codes

        return step
