# mypy: ignore-errors
"""The kernels of "time-of-flight": the steps of `crates/depth/src/time_of_flight`, operation by operation, for depth without colours."""

import math
from typing import Any

import numpy as np
import warp as wp

from .._findings import Error
from ._random import box_muller, key, philox, sine_of_turns
from ._single_view import draw, of_each

wp.set_module_options({"enable_backward": False, "fast_math": False, "fuse_fp": False})

CORRELATION, FIXED_PATTERN = 5, 6
_LIGHT_M_S = 299_792_458.0
# The tolerance for a whole number of periods.
_SAME = 1e-6
# The codes of reasons.
_NO_SURFACE, _TOO_NEAR, _TOO_FAR, _SATURATED, _WRAPPED, _DARK = (wp.constant(code) for code in (1, 2, 3, 7, 13, 14))
_STEEPEST = wp.constant(float(np.float32(57.28996)))


@wp.struct
class Camera:
    """The parameters in single precision, for images of one size."""

    focal_length: float
    signal: float
    contrast: float
    ambient: float
    turns_per_m: wp.vec2
    age: wp.vec2
    mixing: float
    wiggling: float
    residual: float
    read_variance: float
    noise: float
    shares: int
    min_amplitude: float
    full_well: float
    is_depth: int
    albedo: float
    bias: float
    fixed_pattern: float
    velocity: float
    confidence: float
    turn_m: wp.vec2
    weights: wp.vec2
    threshold: float
    stride: int


@wp.kernel
def draw_words(
    keys: wp.array2d(dtype=wp.uint32),
    items: wp.array(dtype=wp.uint32),
    frame: wp.array(dtype=wp.uint32),
    before: wp.uint32,
    out: wp.array3d(dtype=wp.uint32),
):
    """The random words of rows, of an earlier frame."""
    n, row, block = wp.tid()
    k = wp.min(n, keys.shape[0] - 1)
    words = philox(wp.uint32(block), wp.uint32(row), frame[0] - before, items[n], keys[k, 0], keys[k, 1])
    for part in range(4):
        out[n, row, 64 * (block // 16) + 16 * part + block % 16] = words[part]


@wp.func
def inverse(depth: wp.array3d(dtype=float), n: int, y: int, x: int) -> float:
    """Inverse depth, 1/m; 0 without a surface and outside the image."""
    found = float(0.0)
    if y >= 0 and y < depth.shape[1] and x >= 0 and x < depth.shape[2]:
        z = depth[n, y, x]
        value = 1.0 / z
        if z > 0.0 and value >= 1e-4:
            found = wp.min(value, 1e4)
    return found


@wp.func
def gradient(before: float, middle: float, after: float, focal_length: float) -> float:
    """The derivative at the middle, from the flatter side; 0 across an edge."""
    a = middle - before
    b = after - middle
    flatter = b * focal_length
    if wp.abs(a) < wp.abs(b):
        flatter = a * focal_length
    if wp.abs(flatter) > _STEEPEST * middle:
        flatter = 0.0
    return flatter


@wp.func
def fraction(x: float) -> float:
    return x - ((x + 12582912.0) - 12582912.0)


@wp.func
def angle_in_turns(x: float, y: float) -> float:
    along = wp.abs(x)
    across = wp.abs(y)
    large = wp.max(along, across)
    small = wp.min(along, across)
    ratio = small / (large + 1.1754943508222875e-38)
    w = ratio * ratio
    series = (
        ((((0.0010841292 * w - 0.0053482736) * w + 0.012672496) * w - 0.021061515) * w + 0.031525116) * w - 0.053026237
    )
    turns = ratio * (series * w + 0.15915433)
    if across > along:
        turns = 0.25 - turns
    if x < 0.0:
        turns = 0.5 - turns
    if y < 0.0:
        turns = 1.0 - turns
    if not turns < 1.0:
        turns = 0.0
    return turns


@wp.kernel
def reflect(
    depth: wp.array3d(dtype=float),
    pattern: wp.array3d(dtype=float),
    u: wp.array(dtype=float),
    v: wp.array(dtype=float),
    cameras: wp.array(dtype=Camera),
    light: wp.array4d(dtype=float),
):
    """The phasors of both frequencies, and all light: electrons per sample."""
    n, y, x = wp.tid()
    c = cameras[wp.min(n, cameras.shape[0] - 1)]
    w = inverse(depth, n, y, x)
    gx = gradient(inverse(depth, n, y, x - 1), w, inverse(depth, n, y, x + 1), c.focal_length)
    gy = gradient(inverse(depth, n, y - 1, x), w, inverse(depth, n, y + 1, x), c.focal_length)
    gz = w - gx * u[x] - gy * v[y]
    normal2 = gx * gx + gy * gy + gz * gz
    ray2 = 1.0 + u[x] * u[x] + v[y] * v[y]
    reflected = float(0.0)
    distance = float(0.0)
    ambient = float(0.0)
    if w > 0.0:
        cosine = w / wp.sqrt(normal2 * ray2)
        reflected = c.signal * c.albedo * cosine * (w * w / ray2)
        shift = c.bias
        if c.fixed_pattern > 0.0:
            shift = c.bias + c.fixed_pattern * pattern[n, y, x]
        distance = depth[n, y, x] * wp.sqrt(ray2) + shift
        ambient = c.ambient * c.albedo
    amplitude = c.contrast * reflected
    for k in range(2):
        turns = fraction((distance - c.velocity * c.age[k]) * c.turns_per_m[k])
        light[n, 2 * k, y, x] = amplitude * sine_of_turns(turns + 0.25)
        light[n, 2 * k + 1, y, x] = amplitude * sine_of_turns(turns)
    light[n, 4, y, x] = reflected + ambient


@wp.func
def mixed_column(light: wp.array4d(dtype=float), n: int, channel: int, y: int, x: int, weight: float) -> float:
    column = wp.clamp(x, 0, light.shape[3] - 1)
    here = light[n, channel, y, column]
    if weight > 0.0:
        above = light[n, channel, wp.max(y - 1, 0), column]
        below = light[n, channel, wp.min(y + 1, light.shape[2] - 1), column]
        here = (1.0 - 2.0 * weight) * here + weight * (above + below)
    return here


@wp.func
def mixed(light: wp.array4d(dtype=float), n: int, channel: int, y: int, x: int, weight: float) -> float:
    """The light of a pixel with a part of its neighbours'."""
    here = mixed_column(light, n, channel, y, x, weight)
    left = mixed_column(light, n, channel, y, x - 1, weight)
    right = mixed_column(light, n, channel, y, x + 1, weight)
    return (1.0 - 2.0 * weight) * here + weight * (left + right)


@wp.func
def normal_pair(word: wp.uint32) -> wp.vec2:
    return box_muller(((word >> wp.uint32(16)) << wp.uint32(16)) + wp.uint32(0x8000), word << wp.uint32(16))


@wp.kernel
def receive(
    depth: wp.array3d(dtype=float),
    light: wp.array4d(dtype=float),
    words: wp.array3d(dtype=wp.uint32),
    earlier: wp.array3d(dtype=wp.uint32),
    u: wp.array(dtype=float),
    v: wp.array(dtype=float),
    candidates: wp.array2d(dtype=float),
    cameras: wp.array(dtype=Camera),
    out: wp.array3d(dtype=float),
    reasons: wp.array3d(dtype=wp.uint8),
):
    """Samples, phases and distances."""
    n, y, x = wp.tid()
    c = cameras[wp.min(n, cameras.shape[0] - 1)]
    turns = wp.vec2()
    strength = wp.vec2()
    fullest = wp.vec2()
    total = mixed(light, n, 4, y, x, c.mixing)
    for k in range(2):
        noise = normal_pair(words[n, y, k * c.stride + x])
        if c.shares == 1:
            other = normal_pair(earlier[n, y, k * c.stride + x])
            noise = wp.vec2(noise[0] + other[0], noise[1] + other[1])
        re = mixed(light, n, 2 * k, y, x, c.mixing)
        im = mixed(light, n, 2 * k + 1, y, x, c.mixing)
        length = wp.sqrt(re * re + im * im)
        per = 1.0 / (length + 1e-30)
        cosine = re * per
        sine = im * per
        cosine2 = cosine * cosine - sine * sine
        sine2 = 2.0 * cosine * sine
        cosine4 = cosine2 * cosine2 - sine2 * sine2
        sine4 = 2.0 * cosine2 * sine2
        shape = 1.0 + c.wiggling * cosine4
        turn = -c.residual * sine4
        sigma = c.noise * wp.sqrt((total + c.read_variance) * 0.5)
        noisy_re = shape * (re - turn * im) + sigma * noise[0]
        noisy_im = shape * (im + turn * re) + sigma * noise[1]
        turns[k] = angle_in_turns(noisy_re, noisy_im)
        strength[k] = wp.sqrt(noisy_re * noisy_re + noisy_im * noisy_im)
        fullest[k] = total + length * shape
    distance = float(0.0)
    apart = float(wp.inf)
    for i in range(candidates.shape[0]):
        a = turns[0] * c.turn_m[0] + candidates[i, 0]
        b = turns[1] * c.turn_m[1] + candidates[i, 1]
        if wp.abs(a - b) < apart:
            apart = wp.abs(a - b)
            distance = c.weights[0] * a + c.weights[1] * b
    z = distance
    if c.is_depth == 1:
        z = distance / wp.sqrt(1.0 + u[x] * u[x] + v[y] * v[y])
    millimetres = z * 1000.0
    amplitude = 0.5 * (strength[0] + strength[1])
    seen = inverse(depth, n, y, x) > 0.0
    full = fullest[0] > c.full_well or fullest[1] > c.full_well
    kept = seen and not full and apart <= c.threshold and amplitude >= c.min_amplitude and millimetres < 65535.5
    whole = float(0.0)
    if kept:
        whole = (millimetres + 8388608.0) - 8388608.0
    if c.confidence != 0.0 and whole > 0.0:
        level = (wp.min(amplitude, 65535.0) + 8388608.0) - 8388608.0
        if level > 0.0 and 100.0 * (level / wp.sqrt(whole / 2.0)) < c.confidence:
            whole = 0.0
    out[n, y, x] = whole / 1000.0
    if reasons.shape[0] > 0:
        code = int(_DARK)
        if whole > 0.0:
            code = 0
        elif not seen:
            code = _NO_SURFACE
        elif full:
            code = _SATURATED
        elif amplitude < c.min_amplitude:
            code = _DARK
        elif apart > c.threshold:
            code = _WRAPPED
        elif distance > 1.0 and distance * 1000.0 >= 65535.5:
            code = _TOO_FAR
        elif distance < 5e-4:
            code = _TOO_NEAR
        reasons[n, y, x] = wp.uint8(code)


class TimeOfFlight:
    """The engine for images of one size, with the arrays that it needs."""

    # What can differ between environments.
    PER_WORLD = (
        "phaseUnwrapErrorThreshold",
        "wiggling",
        "wigglingResidual",
        "fixedPattern",
        "bias",
        "signal",
        "contrast",
        "ambient",
        "readNoise",
        "fullWell",
        "albedo",
        "pixelMixing",
        "radialVelocity",
        "measurementInterval",
        "minAmplitude",
        "confidenceThreshold",
    )
    # The parameters that change the measurement, and those that only colours need.
    PARAMETERS = frozenset(
        {
            *PER_WORLD,
            "focalLength",
            "width",
            "principalPoint",
            "modulationFrequencies",
            "enablePhaseUnwrapping",
            "phaseUnwrappingLevel",
            "enablePhaseShuffleTemporalFilter",
            "enableBurstMode",
            "enableOpticalCorrection",
            "enableWiggleCorrection",
            "enableFPPNCorrection",
        }
    )
    COLOURS = frozenset({"multipath"})

    def __init__(self, parameters: dict[str, Any], worlds: dict[str, Any], shape: tuple[int, int, int], device: Any) -> None:
        p = parameters
        if p["multipath"] > 0:
            raise Error("multipath: does not run in Warp; set it to 0, or use oaktwin.DepthSensor")
        count, height, width = shape
        scale = width / p["width"]
        centre = (width / 2.0, height / 2.0)
        if "," in str(p["principalPoint"]):
            centre = tuple(float(part) * scale for part in p["principalPoint"].split(","))
        per_px = 1.0 / (p["focalLength"] * scale)
        cameras, candidates = [], []
        for own in of_each(parameters, worlds):
            camera, candidates = _camera(own, width)
            cameras.append(camera)
        self._shares, self._stride = cameras[0].shares, cameras[0].stride
        self._has_pattern = any(camera.fixed_pattern > 0 for camera in cameras)
        self._cameras, self._shape, self._device = wp.array(cameras, dtype=Camera, device=device), shape, device

        def row(size: int, middle: float) -> Any:
            return wp.array(((np.arange(size) + 0.5 - middle) * per_px).astype(np.float32), dtype=float, device=device)

        self._rays = [row(width, centre[0]), row(height, centre[1])]
        self._candidates = wp.array(np.array(candidates, np.float32), dtype=float, device=device)
        self._light = wp.empty((count, 5, height, width), dtype=float, device=device)
        self._words = wp.empty((count, height, 2 * self._stride), dtype=wp.uint32, device=device)
        self._earlier = wp.empty_like(self._words) if self._shares else self._words
        self._pattern = wp.empty(shape if self._has_pattern else (0, 0, 0), dtype=float, device=device)
        self._zeros = wp.zeros(max(count, 1), dtype=wp.uint32, device=device)

    @staticmethod
    def keys(seed: int, camera: str) -> list[int]:
        """The keys of the random numbers of an image, and of the fixed pattern."""
        return [*key(seed, camera, CORRELATION), *key(seed, camera, FIXED_PATTERN)]

    def launch(self, depth: Any, keys: Any, items: Any, frame: Any, out: Any, reasons: Any) -> None:
        """Measures a batch."""
        c, device, (count, height, width) = self._cameras, self._device, self._shape
        size = (count, height, 2 * self._stride // 4)
        for before, words in [(0, self._words), (1, self._earlier)][: 1 + self._shares]:
            wp.launch(draw_words, size, [keys, items, frame, before], [words], device=device)
        if self._has_pattern:
            # The same for every frame of the device.
            zeros, blocks = self._zeros, 16 * -(-width // 64)
            wp.launch(draw, (count, height, blocks), [keys[:, 2:], zeros, zeros], [self._pattern], device=device)
        wp.launch(reflect, self._shape, [depth, self._pattern, *self._rays, c], [self._light], device=device)
        images = [depth, self._light, self._words, self._earlier]
        wp.launch(receive, self._shape, [*images, *self._rays, self._candidates, c], [out, reasons], device=device)


def _camera(p: dict[str, Any], width: int) -> tuple[Camera, Any]:
    """The camera of an environment's parameters, and the candidates of its distances."""
    scale = width / p["width"]
    frequencies = [float(part) for part in p["modulationFrequencies"].split(",")]
    turns = [_LIGHT_M_S / (2e6 * frequency) for frequency in frequencies]
    shuffles, bursts = p["enablePhaseShuffleTemporalFilter"], p["enableBurstMode"]
    ages = [age * p["measurementInterval"] for age in ((2.0, 1.0) if shuffles else (1.0, 0.0))]
    weights, candidates, threshold = _unwrapping(p, frequencies, turns)

    def single(value: float) -> float:
        return float(np.float32(value))

    c = Camera()
    c.focal_length = single(p["focalLength"] * scale)
    c.signal, c.contrast, c.ambient = single(p["signal"]), single(p["contrast"]), single(float(p["ambient"]))
    c.turns_per_m = wp.vec2(*(single(1.0 / turn) for turn in turns))
    c.age = wp.vec2(*map(single, ages))
    c.mixing, c.wiggling = single(p["pixelMixing"]), single(p["wiggling"])
    c.residual = single(p["wigglingResidual"] if p["enableWiggleCorrection"] else p["wiggling"])
    c.read_variance = single(p["readNoise"] * p["readNoise"])
    c.noise = single(1.0 if not shuffles else math.sqrt(0.5) if bursts else 0.5)
    c.shares = int(shuffles and not bursts)
    c.min_amplitude, c.full_well = single(p["minAmplitude"]), single(p["fullWell"])
    c.is_depth, c.albedo = int(p["enableOpticalCorrection"]), single(p["albedo"])
    c.bias, c.velocity = single(p["bias"]), single(p["radialVelocity"])
    c.fixed_pattern = 0.0 if p["enableFPPNCorrection"] else single(p["fixedPattern"])
    c.confidence = single(p["confidenceThreshold"])
    c.turn_m, c.weights, c.threshold = wp.vec2(*map(single, turns)), wp.vec2(*map(single, weights)), single(threshold)
    c.stride = -(-width // 64) * 64
    return c, candidates


def _unwrapping(p: dict[str, Any], frequencies: list[float], turns: list[float]) -> tuple[Any, Any, float]:
    """The weights of both distances, the pairs of whole periods from near to far, and the largest difference, metres."""
    level = p["phaseUnwrappingLevel"]
    if level == 0 or not p["enablePhaseUnwrapping"]:
        return (1.0, 0.0), [(0.0, 0.0)], math.inf
    squares = [frequency * frequency for frequency in frequencies]
    weights = [square / (squares[0] + squares[1]) for square in squares]
    anew = level + 1
    for periods in range(1, level + 2):
        low = periods * turns[1] / turns[0]
        if abs(low - round(low)) <= _SAME * low and round(low) >= 1:
            anew = periods
            break
    most = anew * turns[1]
    candidates = []
    low = high = 0.0
    while max(low * turns[0], high * turns[1]) < most * (1.0 - _SAME):
        candidates.append((low * turns[0], high * turns[1]))
        ends = ((low + 1.0) * turns[0], (high + 1.0) * turns[1])
        both = abs(ends[0] - ends[1]) <= _SAME * ends[0]
        low += 1.0 if both or ends[0] < ends[1] else 0.0
        high += 1.0 if both or ends[1] < ends[0] else 0.0
    return weights, candidates, p["phaseUnwrapErrorThreshold"] / 1000.0
