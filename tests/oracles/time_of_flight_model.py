"""The time-of-flight engine: a straightforward NumPy implementation of the documented steps, in double precision.

What the program is compared with, and timed against.
"""

from dataclasses import dataclass

import numpy as np

from stereo_noise_model import random_words

CORRELATION, FIXED_PATTERN = 5, 6
LIGHT = 299792458.0


@dataclass
class Parameters:
    """The program's parameters with their defaults."""

    focalLength: float = 457.0
    width: int = 640
    principalPoint: tuple[float, float] | None = None
    modulationFrequencies: tuple[float, float] = (80.0, 100.0)
    enablePhaseUnwrapping: bool = True
    phaseUnwrappingLevel: int = 4
    phaseUnwrapErrorThreshold: int = 100
    enablePhaseShuffleTemporalFilter: bool = True
    enableBurstMode: bool = False
    enableOpticalCorrection: bool = True
    enableWiggleCorrection: bool = True
    wiggling: float = 0.071
    wigglingResidual: float = 0.003
    enableFPPNCorrection: bool = True
    fixedPattern: float = 0.01
    bias: float = 0.0
    signal: float = 3000.0
    contrast: float = 0.8
    ambient: float = 50.0
    readNoise: float = 5.0
    fullWell: float = 135000.0
    albedo: float = 0.5
    pixelMixing: float = 0.125
    multipath: float = 0.0
    radialVelocity: float = 0.0
    measurementInterval: float = 1 / 60
    minAmplitude: float = 5.0
    confidenceThreshold: float = 0.1


def normal_pairs(words):
    """Two normal numbers per word: the upper half is the radius, the lower the angle."""
    radius = np.sqrt(-2 * np.log(((words >> 16) + 0.5) / 65536))
    angle = (words & 0xFFFF) / 65536 * 2 * np.pi
    return radius * np.exp(1j * angle)


def fixed_pattern(seed, camera, shape):
    """One normal number a pixel: of 32 words, words i and 16 + i make numbers i and 16 + i."""
    words = random_words(seed, camera, FIXED_PATTERN, 0, 0, shape[0], -(-shape[1] // 64) * 64)
    a, b = words.reshape(shape[0], -1, 2, 16).transpose(2, 0, 1, 3).astype(np.float64)
    radius = np.sqrt(-2 * np.log((np.floor(a / 2) + 0.5) / 2**31))
    angle = b / 2**32 * 2 * np.pi
    pairs = np.stack([radius * np.cos(angle), radius * np.sin(angle)], axis=2)
    return pairs.reshape(shape[0], -1)[:, : shape[1]]


def flatter(before, here, after):
    """The smaller difference of both sides, the second one if they are equal."""
    a, b = here - before, after - here
    return np.where(np.abs(a) < np.abs(b), a, b)


def blurred(image, weight):
    """Pads by a row or column on each side, replicating the border."""
    for axis in (0, 1):
        padded = np.pad(image, [(int(axis == 0),) * 2, (int(axis == 1),) * 2], mode="edge")
        size = image.shape[axis]
        parts = [np.take(padded, range(start, start + size), axis) for start in range(3)]
        image = (1 - 2 * weight) * parts[1] + weight * (parts[0] + parts[2])
    return image


def albedos(rgb):
    """The luma."""
    r, g, b = (rgb[..., channel].astype(np.int64) for channel in range(3))
    return np.maximum(((77 * r + 150 * g + 29 * b) >> 8) / 255, 0.02)


def multipath(point, normal, albedo, f, turn):
    """The indirect light per strength and signal·albedo: for both frequencies the phasor of half the path
    from the lamp to the other surface and on to each pixel's, and all of it."""
    height, width = albedo.shape
    surface = np.any(normal != 0, axis=-1)
    cell = max(-(-width // 40), -(-height // 30))
    z = np.where(surface, point[..., 2], 1)
    facing = np.where(surface, -(point * normal).sum(axis=-1), 1)
    ray = np.where(surface, np.linalg.norm(point, axis=-1) / z, 1)
    flux = np.where(surface, albedo / f**2 / ray**3, 0)
    area = np.where(surface, z**3 / facing / f**2, 0)
    values = np.dstack([flux, area, flux[..., None] * point, flux[..., None] * normal])
    cells = np.add.reduceat(np.add.reduceat(values, range(0, height, cell), 0), range(0, width, cell), 1)
    patches = cells[cells[..., 0] > 0]
    power, area = patches[:, 0], patches[:, 1]
    at = patches[:, 2:5] / power[:, None]
    facings = patches[:, 5:] / np.linalg.norm(patches[:, 5:], axis=-1, keepdims=True)

    step = -(-cell // 2)
    rows, columns = (np.minimum(np.arange(0, size, step) + step // 2, size - 1) for size in (height, width))
    places, normals = (values[np.ix_(rows, columns)] for values in (point, normal))
    lights = np.zeros((len(rows), len(columns), 3), complex)
    for light, place, towards in zip(lights, places, normals):
        way = at - place[:, None]
        square = (way**2).sum(axis=-1)
        here, there = (towards[:, None] * way).sum(axis=-1), -(facings * way).sum(axis=-1)
        parts = power * np.maximum(here, 0) * np.maximum(there, 0) / ((square + 1e-12) * (np.pi * square + area))
        distance = (np.linalg.norm(at, axis=-1) + np.sqrt(square)) / 2
        for k in range(2):
            light[:, k] = (parts * np.exp(2j * np.pi * distance / turn[k])).sum(axis=-1)
        light[:, 2] = parts.sum(axis=-1)

    def around(receivers, size):
        """The receivers on both sides of each pixel, with their weights."""
        pixels = np.arange(size)
        after = np.searchsorted(receivers, pixels, side="right")
        pair = np.maximum(after - 1, 0), np.minimum(after, len(receivers) - 1)
        apart = np.maximum(receivers[pair[1]] - receivers[pair[0]], 1)
        share = np.clip((pixels - receivers[pair[0]]) / apart, 0, 1)
        return (pair[0], 1 - share), (pair[1], share)

    # The receivers around a pixel whose depth is similar to its own.
    sums, counted = np.zeros((height, width, 3), complex), np.zeros((height, width))
    for y, lower in around(rows, height):
        for x, right in around(columns, width):
            there = np.ix_(y, x)
            off = 20 * (normals[there] * (point - places[there])).sum(axis=-1) / z
            unlike = np.abs(1 - (normals[there] * normal).sum(axis=-1)) + off**2
            counts = (np.outer(lower, right) + 0.02) * np.any(normals[there] != 0, axis=-1) * (0.01 / (0.01 + unlike)) ** 2
            counted += counts
            sums += counts[..., None] * lights[there]
    return np.where(surface[..., None], sums / np.maximum(counted, 1e-3)[..., None], 0)


def measured(depth, p, seed, camera, frame, item=0, rgb=None, velocity=None):
    """The intermediate results: fractional depth in millimetres, whether it is valid apart from the confidence, the margin of that
    decision (relative), and the amplitude."""
    height, width = depth.shape
    scale = width / p.width
    f = p.focalLength * scale
    cx, cy = (width / 2, height / 2) if p.principalPoint is None else np.multiply(p.principalPoint, scale)
    u = ((np.arange(width) + 0.5 - cx) / f)[None, :]
    v = ((np.arange(height) + 0.5 - cy) / f)[:, None]
    z = depth.astype(np.float64)
    surface = (z > 0) & np.isfinite(z) & (z <= 1e4)
    z = np.where(surface, z, 1)
    inverse = np.where(surface, np.minimum(1 / z, 1e4), 0)
    padded = np.pad(inverse, 1)
    gx = f * flatter(padded[1:-1, :-2], inverse, padded[1:-1, 2:])
    gy = f * flatter(padded[:-2, 1:-1], inverse, padded[2:, 1:-1])
    steepest = np.tan(np.radians(89)) * inverse
    gx, gy = (np.where(np.abs(g) > steepest, 0, g) for g in (gx, gy))
    ray = np.sqrt(1 + u**2 + v**2)
    normal = np.sqrt(gx**2 + gy**2 + (inverse - gx * u - gy * v) ** 2)
    cosine = inverse / np.where(surface, normal * ray, 1)
    albedo = np.full(z.shape, p.albedo) if rgb is None else albedos(rgb)
    light = p.signal * albedo * cosine * (inverse / ray) ** 2
    total = light + np.where(surface, p.ambient * albedo, 0)
    distance = z * ray + p.bias
    if not p.enableFPPNCorrection:
        distance = distance + p.fixedPattern * fixed_pattern(seed, camera, z.shape)
    velocity = p.radialVelocity if velocity is None else velocity
    shuffle = p.enablePhaseShuffleTemporalFilter
    ages = np.array([2, 1] if shuffle else [1, 0]) * p.measurementInterval

    # Each frame's measurements, and of a pixel's two random words one a frequency.
    frames = [frame, frame - 1] if shuffle and not p.enableBurstMode else [frame]
    stride = -(-width // 64) * 64
    numbers = 0
    for number in frames:
        words = random_words(seed, camera, CORRELATION, number, item, height, 2 * stride)
        numbers = numbers + normal_pairs(words.astype(np.int64))
    of_mean = (np.sqrt(0.5) if shuffle else 1) / np.sqrt(len(frames))
    turn = LIGHT / (2e6 * np.array(p.modulationFrequencies))
    if p.multipath > 0:
        gradient = np.stack([gx, gy, inverse - gx * u - gy * v], axis=-1)
        towards = np.where(surface, -1, 0)[..., None] * gradient / np.where(surface, normal, 1)[..., None]
        points = np.where(surface, z, 0)[..., None] * np.stack(np.broadcast_arrays(u, v, 1.0), axis=-1)
        others = p.multipath * (p.signal * albedo)[..., None] * multipath(points, towards, albedo, f, turn)
        total = total + others[..., 2].real
    total = blurred(total, p.pixelMixing)
    sigma = of_mean * np.sqrt((total + p.readNoise**2) / 2)
    near, amplitude, full = [], 0, np.zeros(z.shape)
    for i in range(2):
        phase = 2 * np.pi * (distance - velocity * ages[i]) / turn[i]
        phasor = np.where(surface, p.contrast * light * np.exp(1j * phase), 0)
        if p.multipath > 0:
            # The pixel's own half of the way.
            phasor = phasor + p.contrast * others[..., i] * np.exp(1j * (phase - np.pi * z * ray / turn[i]))
        phasor = blurred(phasor.real, p.pixelMixing) + 1j * blurred(phasor.imag, p.pixelMixing)
        fourth = np.exp(4j * np.angle(phasor)) * (phasor != 0)
        residual = p.wigglingResidual if p.enableWiggleCorrection else p.wiggling
        shape = 1 + p.wiggling * fourth.real
        full = np.maximum(full, total + np.abs(phasor) * shape)
        noise = numbers[:, i * stride : i * stride + width]
        phasor = phasor * shape * (1 - 1j * residual * fourth.imag) + sigma * noise
        near.append(np.angle(phasor) / (2 * np.pi) % 1 * turn[i])
        amplitude = amplitude + np.abs(phasor) / 2

    # Everything repeats where both frequencies begin a period.
    square = np.square(p.modulationFrequencies)
    weights = square / square.sum()
    if p.phaseUnwrappingLevel == 0 or not p.enablePhaseUnwrapping:
        best, apart, second, threshold = near[0], np.zeros(z.shape), np.full(z.shape, np.inf), np.inf
    else:
        most = (p.phaseUnwrappingLevel + 1) * turn[1]
        for periods in range(1, p.phaseUnwrappingLevel + 1):
            whole = periods * turn[1] / turn[0]
            if abs(whole - round(whole)) < 1e-6 * whole and round(whole) > 0:
                most = periods * turn[1]
                break
        best, apart, second = (np.full(z.shape, value) for value in (0.0, np.inf, np.inf))
        for low in range(12):
            for high in range(12):
                begin, end = max(low * turn[0], high * turn[1]), min((low + 1) * turn[0], (high + 1) * turn[1])
                if end - begin < 1e-6 or begin > most - 1e-6:
                    continue
                a, b = near[0] + low * turn[0], near[1] + high * turn[1]
                fits = np.abs(a - b) < apart
                second = np.where(fits, apart, np.minimum(second, np.abs(a - b)))
                best = np.where(fits, weights[0] * a + weights[1] * b, best)
                apart = np.where(fits, np.abs(a - b), apart)
        threshold = p.phaseUnwrapErrorThreshold / 1000
    millimetres = 1000 * (best / ray if p.enableOpticalCorrection else best)
    kept = surface & (apart <= threshold) & (amplitude >= p.minAmplitude) & (full <= p.fullWell)
    wraps = np.minimum.reduce([np.minimum(n, t - n) / t for n, t in zip(near, turn)])
    undecided = np.minimum.reduce(
        [
            wraps,
            np.abs(apart - threshold) if np.isfinite(threshold) else np.full(z.shape, np.inf),
            second - apart,
            np.abs(amplitude - p.minAmplitude) / (p.minAmplitude + 1),
            np.abs(full / p.fullWell - 1),
        ]
    )
    return millimetres, kept, undecided, amplitude


def confidences(depth, amplitude, threshold):
    """DepthAI's filter: the filtered depth, and the confidence image."""
    if threshold == 0:
        return depth, amplitude
    a, d = amplitude.astype(np.float32), depth.astype(np.float32)
    with np.errstate(divide="ignore", invalid="ignore"):
        confidence = a / np.sqrt(d / np.float32(2))
    nothing = np.minimum(a, d) < 1e-12
    confidence = np.where(nothing, np.float32(65535), confidence) * np.float32(100)
    bits = np.where(nothing, 65535, confidence.astype(np.int64) & 0xFFFF).astype(np.uint16)
    return np.where(confidence < np.float32(threshold), 0, depth), bits


def time_of_flight(depth, p, *arguments, **named):
    """Metres."""
    millimetres, kept, _, amplitude = measured(depth, p, *arguments, **named)
    whole = np.where(kept, np.rint(millimetres), 0).astype(np.uint16)
    rounded = np.rint(np.minimum(amplitude, 65535)).astype(np.uint16)
    return confidences(whole, rounded, p.confidenceThreshold)[0].astype(np.float32) / np.float32(1000)
