# mypy: ignore-errors
"""The random numbers of the engines in kernels; `crates/depth/src/random` describes them."""

import numpy as np
import warp as wp

wp.set_module_options({"enable_backward": False, "fast_math": False, "fuse_fp": False})

# Constants are rounded to single precision before they are used, as in the engines.
_F = lambda value: float(np.float32(value))  # noqa: E731
MASK = (1 << 64) - 1
JITTER, DROPOUT = 1, 2
_MULTIPLIER0, _MULTIPLIER1 = wp.constant(wp.uint64(0xD2511F53)), wp.constant(wp.uint64(0xCD9E8D57))
_WEYL0, _WEYL1 = wp.constant(wp.uint32(0x9E3779B9)), wp.constant(wp.uint32(0xBB67AE85))


def mix(value: int) -> int:
    """SplitMix64's finalizer."""
    value = (value + 0x9E3779B97F4A7C15) & MASK
    value = ((value ^ value >> 30) * 0xBF58476D1CE4E5B9) & MASK
    value = ((value ^ value >> 27) * 0x94D049BB133111EB) & MASK
    return value ^ value >> 31


def key(seed: int, camera: str, stage: int) -> tuple[int, int]:
    """The key of a stage of a camera."""
    name = 0xCBF29CE484222325
    for byte in camera.encode():
        name = ((name ^ byte) * 0x100000001B3) & MASK
    value = mix(mix(mix(seed) ^ name) ^ mix(stage + 1))
    return value & 0xFFFFFFFF, value >> 32


@wp.func
def philox(block: wp.uint32, row: wp.uint32, frame: wp.uint32, item: wp.uint32, key0: wp.uint32, key1: wp.uint32) -> wp.vec4ui:
    """Philox4x32-10."""
    w0 = block
    w1 = row
    w2 = frame
    w3 = item
    k0 = key0
    k1 = key1
    for _round in range(10):
        p0 = wp.uint64(w0) * _MULTIPLIER0
        p1 = wp.uint64(w2) * _MULTIPLIER1
        w0 = wp.uint32(p1 >> wp.uint64(32)) ^ w1 ^ k0
        w1 = wp.uint32(p1)
        w2 = wp.uint32(p0 >> wp.uint64(32)) ^ w3 ^ k1
        w3 = wp.uint32(p0)
        k0 = k0 + _WEYL0
        k1 = k1 + _WEYL1
    return wp.vec4ui(w0, w1, w2, w3)


@wp.func
def logarithm(x: float) -> float:
    """The natural logarithm of a normal number above 0."""
    shifted = wp.cast(wp.cast(x, wp.uint32) - wp.uint32(0x3F3504F3), wp.int32)
    exponent = float(shifted >> 23)
    m = wp.cast(wp.uint32(shifted & 0x007FFFFF) + wp.uint32(0x3F3504F3), wp.float32)
    t = (m - 1.0) / (m + 1.0)
    u = t * t
    series = 1.0 + u * (wp.static(_F(1 / 3)) + u * (wp.static(_F(1 / 5)) + u * (wp.static(_F(1 / 7)) + u * wp.static(_F(1 / 9)))))
    return exponent * wp.static(_F(0.6931471805599453)) + 2.0 * t * series


@wp.func
def box_muller(a: wp.uint32, b: wp.uint32) -> wp.vec2:
    """Two independent standard normal numbers."""
    uniform = (float(wp.int32(a >> wp.uint32(1))) + 0.5) * wp.static(_F(2.0**-31))
    radius = wp.sqrt(-2.0 * logarithm(uniform))
    quarter = (b + wp.uint32(1 << 29)) >> wp.uint32(30)
    rest = float(wp.cast(b - (quarter << wp.uint32(30)), wp.int32)) * wp.static(_F(2.0**-30))
    t = rest * wp.static(_F(1.5707963267948966))
    u = t * t
    sine = t * (
        1.0
        + u * (wp.static(_F(-1 / 6)) + u * (wp.static(_F(1 / 120)) + u * (wp.static(_F(-1 / 5040)) + u * wp.static(_F(1 / 362880)))))
    )
    cosine = 1.0 + u * (-0.5 + u * (wp.static(_F(1 / 24)) + u * (wp.static(_F(-1 / 720)) + u * wp.static(_F(1 / 40320)))))
    q = wp.int32(quarter)
    if q % 2 == 1:
        other = sine
        sine = cosine
        cosine = other
    if q == 1 or q == 2:
        cosine = -cosine
    if q >= 2:
        sine = -sine
    return wp.vec2(radius * cosine, radius * sine)


@wp.func
def sine_of_turns(x: float) -> float:
    """sin(2π x)."""
    fraction = x - ((x + 12582912.0) - 12582912.0)
    quarter = 0.25 - wp.abs(wp.abs(fraction) - 0.25)
    v = wp.copysign(quarter, fraction)
    w = v * v
    series = ((39.536705 * w - 76.54978) * w + 81.601006) * w - 41.341656
    return v * (series * w + 6.2831855)
