"""The stereo error model: a straightforward NumPy implementation of the documented steps.

What the program is compared with, and timed against.
"""

from dataclasses import dataclass

import numpy as np

JITTER, DROPOUT = 1, 2
MASK = (1 << 64) - 1


@dataclass
class Parameters:
    """The program's parameters with their defaults."""

    focalLength: float
    baseline: float
    width: int
    subpixelFractionalBits: int = 5
    extendedDisparity: bool = False
    disparityShift: int = 0
    occlusion: bool = True
    leftRightCheck: bool = True
    leftRightCheckThreshold: int = 10
    confidenceThreshold: int = 55
    dotContrast: float = 0.0
    ambient: float = 1.0
    numInvalidateEdgePixels: int = 0
    edgeDilation: float = 0.0
    dropout: float = 0.0
    bias: float = 0.0
    pixelLocking: float = 0.13
    jitter: float = 0.05
    closeRangeFactor: float = 1.0
    window: int = 7
    depthRounding: str = "nearest"

    @property
    def max_fixed(self):
        """The largest disparity above the shift, in steps."""
        largest = 95 + self.disparityShift
        if self.extendedDisparity:
            largest *= 2
        return (largest - self.disparityShift) << self.subpixelFractionalBits


def splitmix64(value):
    value = (value + 0x9E3779B97F4A7C15) & MASK
    value = ((value ^ value >> 30) * 0xBF58476D1CE4E5B9) & MASK
    value = ((value ^ value >> 27) * 0x94D049BB133111EB) & MASK
    return value ^ value >> 31


def philox4x32(counter, key):
    """Philox4x32-10 on arrays of counters."""
    a, b, c, d = (np.asarray(word, np.uint64) for word in counter)
    low, half = np.uint64(0xFFFFFFFF), np.uint64(32)
    first, second = key
    for _ in range(10):
        p = a * np.uint64(0xD2511F53)
        q = c * np.uint64(0xCD9E8D57)
        a, b, c, d = (q >> half) ^ b ^ np.uint64(first), q & low, (p >> half) ^ d ^ np.uint64(second), p & low
        first, second = (first + 0x9E3779B9) & 0xFFFFFFFF, (second + 0xBB67AE85) & 0xFFFFFFFF
    return np.stack(np.broadcast_arrays(a, b, c, d)).astype(np.uint32)


def random_words(seed, camera, stage, frame, item, rows, count):
    """`count` words of each of `rows` rows: word i is word i // 16 % 4 of block 16 (i // 64) + i % 16."""
    name = 0xCBF29CE484222325
    for byte in camera.encode():
        name = ((name ^ byte) * 0x100000001B3) & MASK
    key = splitmix64(splitmix64(splitmix64(seed) ^ name) ^ splitmix64(stage + 1))
    groups = -(-count // 64)
    blocks = np.arange(16 * groups)
    counter = blocks[None, :], np.arange(rows)[:, None], frame & 0xFFFFFFFF, item
    words = philox4x32(counter, (key & 0xFFFFFFFF, key >> 32))
    words = words.reshape(4, rows, groups, 16).transpose(1, 2, 0, 3)
    return words.reshape(rows, groups * 64)[:, :count]


def random_bytes(*arguments, count):
    words = np.ascontiguousarray(random_words(*arguments, -(-count // 4)), "<u4")
    return words.view(np.uint8)[:, :count]


def normal_field(*arguments, count):
    """Normal numbers in steps of 1/1024: a word makes two, at i and 32 + i of 64."""
    words = random_words(*arguments, -(-count // 64) * 32).astype(np.float64)
    radius = np.sqrt(-2 * np.log((np.floor(words / 65536) + 0.5) / 65536))
    angle = words % 65536 / 65536 * 2 * np.pi
    pairs = np.stack([radius * np.cos(angle), radius * np.sin(angle)])
    pairs = pairs.reshape(2, len(words), -1, 32).transpose(1, 2, 0, 3)
    return np.rint(1024 * pairs.reshape(len(words), -1)[:, :count])


def window_sums(field, side):
    """For pixel (x, y), the sum over columns x to x + side - 1 and rows y to y + side - 1."""
    total = np.zeros((field.shape[0] + 1, field.shape[1] + 1), np.int64)
    total[1:, 1:] = field.astype(np.int64).cumsum(0).cumsum(1)
    return total[side:, side:] - total[:-side, side:] - total[side:, :-side] + total[:-side, :-side]


def rounded(value):
    """To whole image pixels, halves up."""
    return int(np.floor(value + 0.5))


def standard_noise(shape, side, seed, camera, frame, item):
    """Mean 0, variance 1, correlated over the window."""
    height, width = shape
    source = seed, camera, JITTER, frame, item, height + side - 1
    if side < 4:
        return window_sums(normal_field(*source, count=width + side - 1), side) / (1024 * side)
    total = window_sums(random_bytes(*source, count=width + side - 1), side)
    return (total - 127.5 * side**2) / np.sqrt(side**2 * 65535 / 12)


def hidden(d, nearer):
    """The pixels that the second imager does not see, because something `nearer` is in front."""
    height, width = d.shape
    place = np.arange(width) - d
    after = np.full_like(place, np.inf)
    after[:, :-1] = np.minimum.accumulate(place[:, ::-1], 1)[:, ::-1][:, 1:]
    cell = np.floor(place).astype(np.int64)
    front = np.zeros((height, width))
    rows = np.broadcast_to(np.arange(height)[:, None], d.shape)

    def take(who, at):
        inside = who & (at >= 0) & (at < width)
        np.maximum.at(front, (rows[inside], at[inside]), d[inside])

    take(np.ones_like(d, bool), cell)
    stretched = np.zeros(d.shape, bool)
    stretched[:, :-1] = (place[:, 1:] - place[:, :-1] <= 2) & (cell[:, 1:] - cell[:, :-1] == 2)
    take(stretched, cell + 1)
    there = np.take_along_axis(front, np.clip(cell, 0, width - 1), 1)
    return (place >= after) & (place >= 0) & (there >= d + nearer)


def dilated(d, reach):
    """The largest within reach."""
    padded = np.pad(d, reach)
    wide = np.max([padded[:, k : k + d.shape[1]] for k in range(2 * reach + 1)], 0)
    return np.max([wide[k : k + d.shape[0]] for k in range(2 * reach + 1)], 0)


def clearness(light, electrons):
    """The signal-to-noise ratio of the imager's defaults, relative to the one in a bright room, in float32."""
    f = np.float32
    share = np.minimum(light * f(2), f(1))
    return share * np.sqrt((electrons + f(6.25)) / (share * electrons + f(6.25)))


def lit(sums, luma, depth, p, side, factor):
    """The sums of windows in the light, with a projector's dots, in float32."""
    f = np.float32
    if p.dotContrast == 0 and p.ambient >= 0.5:
        return sums
    pattern = 0.53 * 0.046 / np.sqrt(1 + (p.focalLength / 1600) ** 3)
    contrast = 0.0
    if p.dotContrast > 0:
        contrast = 1e9 if p.ambient == 0 else min(p.dotContrast / p.ambient, 1e9)
    level = luma.astype(f)
    electrons = f(6300) * (level * level) / f(255 * 255)
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        nearness = f(1) / (depth * depth)
        peak = level * (np.sqrt(f(1) + f(contrast) * nearness) - f(1))
        peak = np.where(peak < f(255), peak, f(255))
        dots = peak * f(side**2 * pattern / factor) * clearness(f(p.ambient) + f(p.dotContrast) * nearness, electrons)
        surface = np.isfinite(depth) & (depth > 0)
    seen = np.floor(sums.astype(f) * clearness(f(p.ambient), electrons))
    total = seen + np.where(surface, dots, f(0))
    largest = f(255 * side**2)
    return np.where(total < largest, total, largest).astype(np.int64)


def confidence(rgb, window, depth, p):
    """0 to 255, from the differences along the row and a projector's dots."""
    r, g, b = (rgb[..., channel].astype(np.int64) for channel in range(3))
    luma = (77 * r + 150 * g + 29 * b) >> 8
    width = luma.shape[1]
    wanted = 4 * width / p.width
    lag = max(rounded(wanted), 1)
    detail = min(width / p.width, 1)
    factor = np.sqrt(wanted / lag) / (np.sqrt(detail) * np.sqrt(np.sqrt(detail)))
    side = max(window, min(5, p.window))
    apart = min(lag, width - 1)
    before = apart // 2
    difference = np.abs(luma[:, apart:] - luma[:, : width - apart])
    if apart:
        neighbours = np.abs(np.diff(luma, axis=1))[:, before:][:, : width - apart]
        difference = np.maximum(difference, neighbours)
    difference = np.pad(difference, ((0, 0), (before, apart - before)), mode="edge")
    half = side // 2
    padded = np.pad(difference, ((half, side - 1 - half),) * 2, mode="edge")
    sums = lit(window_sums(padded, side), luma, depth, p, side, factor)
    return np.minimum(72 * sums * factor / side**2, 255)


def disparity(depth, p, seed, camera, frame=0, item=0, rgb=None):
    """Fixed-point disparities, before rounding and after: `(steps, fixed)`."""
    height, width = depth.shape
    scale = width / p.width
    side = min(max(rounded(p.window * scale), 1), 255)
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        surface = np.isfinite(depth) & (depth > 0)
        d = np.where(surface, p.focalLength * p.baseline / depth.astype(np.float64), 0)
    d = np.minimum(d, 8192)
    lost = np.zeros(depth.shape, bool)
    reach = rounded(p.edgeDilation * scale)
    if reach:
        wide = dilated(d, reach)
        wide = np.where(wide > d + 1, wide, d)
        if p.occlusion:
            lost |= hidden(d * scale, 1) & (wide == d)
            if p.leftRightCheck:
                lost |= hidden(wide * scale, max(p.leftRightCheckThreshold * scale, 1))
        d = wide
    elif p.occlusion:
        lost |= hidden(d * scale, 1)
    if p.occlusion:
        lost |= np.arange(width) - d * scale < 0
    if rgb is not None and p.confidenceThreshold > 0:
        lost |= confidence(rgb, side, depth, p) < p.confidenceThreshold
    if p.dropout > 0:
        # Low bytes, then high ones, of rows as wide as the program pads them.
        padded = -(-width // 64) * 64
        pair = random_bytes(seed, camera, DROPOUT, frame, item, height, count=2 * padded).astype(np.int64)
        lost |= pair[:, :width] + 256 * pair[:, padded : padded + width] < rounded(p.dropout * 65536)
    full, none = (p.focalLength * p.baseline / z for z in (6, 7))
    factor = 1 + (p.closeRangeFactor - 1) * np.clip((d - none) / (full - none), 0, 1)
    biased = d + factor * p.bias
    noise = factor * p.jitter * standard_noise(depth.shape, side, seed, camera, frame, item)
    measured = biased - factor * p.pixelLocking * np.sin(2 * np.pi * biased) + noise
    steps = (measured - p.disparityShift) * 2**p.subpixelFractionalBits
    fixed = np.rint(np.clip(steps, 0, p.max_fixed + 1))
    lost |= (d == 0) | (fixed > p.max_fixed)
    lost[:, : rounded(p.numInvalidateEdgePixels * scale)] = True
    return steps, np.where(lost, 0, fixed).astype(np.uint16)


def metres(fixed, p):
    """Depth in whole millimetres."""
    with np.errstate(divide="ignore"):
        d = fixed / 2**p.subpixelFractionalBits + p.disparityShift
        millimetres = p.focalLength * p.baseline * 1000 / d
    millimetres = np.floor(millimetres + (0.5 if p.depthRounding == "nearest" else 0))
    return np.where((fixed > 0) & (millimetres <= 65535), millimetres / 1000, 0).astype(np.float32)


def stereo_noise(depth, parameters, seed, camera, frame=0, item=0, rgb=None):
    """Metres, 0 where nothing was measured."""
    return metres(disparity(depth, parameters, seed, camera, frame, item, rgb)[1], parameters)
