"""Straightforward NumPy implementations of the engines, with which the program is compared.

Arithmetic on pixels is in float32, step by step as the program's documentation says, so that roundings agree.
"""

import numpy as np

F = np.float32
MASK = (1 << 64) - 1
STAGE_JITTER, STAGE_GRAIN = 1, 4

# The schema's defaults in Isaac Sim 5.1.
PARAMETERS = {
    "baselineMM": 55.0,
    "confidenceThreshold": 0.95,
    "focalLengthPixel": 897.0,
    "maxDisparityPixel": 110.0,
    "maxDistance": 1e7,
    "minDistance": 0.5,
    "noiseDownscaleFactorPixel": 1.0,
    "noiseMean": 0.25,
    "noiseSigma": 0.25,
    "outlierRemovalEnabled": 3,
    "rgbDepthOutputMode": 0,
    "sensorSizePixel": 1280.0,
}

ASSUMPTIONS = {
    "depth": "carried",
    "max-disparity-unit": "rendered",
    "max-disparity": "drop",
    "range-cut": "before",
    "direction": "right",
    "target-rounding": "nearest",
    "collision": "nearest",
    "confidence-at": "source",
    "confidence-comparison": "complement",
    "sobel-gain": 255 / 8,
    "grain": 0.0,
    "luma": "rec709",
    "luma-rounding": "8-bit",
    "quantizer": "round",
    "sigma-unit": "px",
    "invalid": "zero",
    "outlier-neighbourhood": "8",
}


def mix(value):
    """SplitMix64's finalizer."""
    value = (value + 0x9E3779B97F4A7C15) & MASK
    value = ((value ^ (value >> 30)) * 0xBF58476D1CE4E5B9) & MASK
    value = ((value ^ (value >> 27)) * 0x94D049BB133111EB) & MASK
    return value ^ (value >> 31)


def plane_key(seed, camera, stage):
    """The Philox key of a stage of a camera."""
    name = 0xCBF29CE484222325
    for byte in camera.encode():
        name = ((name ^ byte) * 0x100000001B3) & MASK
    key = mix(mix(mix(seed) ^ name) ^ mix(stage + 1))
    return key & 0xFFFFFFFF, key >> 32


def philox(counter, key):
    """Philox4x32-10 of four broadcast arrays of 32-bit counters: four arrays of words."""
    low = np.uint64(0xFFFFFFFF)
    half = np.uint64(32)
    w = [np.asarray(c, np.uint64) for c in np.broadcast_arrays(*counter)]
    k0, k1 = key
    for _ in range(10):
        p0 = w[0] * np.uint64(0xD2511F53)
        p1 = w[2] * np.uint64(0xCD9E8D57)
        w = [
            (p1 >> half) ^ w[1] ^ np.uint64(k0),
            p1 & low,
            (p0 >> half) ^ w[3] ^ np.uint64(k1),
            p0 & low,
        ]
        k0, k1 = (k0 + 0x9E3779B9) & 0xFFFFFFFF, (k1 + 0xBB67AE85) & 0xFFFFFFFF
    return w


def row_words(key, frame, item, rows, columns):
    """The words of rows: sixteen blocks of four words side by side."""
    groups = -(-columns // 64)
    blocks = np.arange(groups * 16).reshape(1, groups, 16)
    row = np.arange(rows).reshape(rows, 1, 1)
    words = np.stack(philox((blocks, row, frame & 0xFFFFFFFF, item), key), axis=2)
    return words.reshape(rows, groups * 64)[:, :columns].astype(np.uint32)


def normals(key, frame, item, rows, columns):
    """Standard normal numbers by Box and Muller, in float32."""
    padded = -(-columns // 64) * 64
    words = row_words(key, frame, item, rows, padded).reshape(rows, padded // 32, 2, 16)
    a, b = words[:, :, 0], words[:, :, 1]
    u = ((a >> 1).astype(F) + F(0.5)) * F(2**-31)
    radius = np.sqrt(F(-2) * logarithm(u))
    quarter = ((b.astype(np.uint64) + (1 << 29)) >> np.uint64(30)).astype(np.int64) % 4
    rest = (b - (quarter << 30).astype(np.uint32)).view(np.int32).astype(F) * F(2**-30)
    t = rest * F(np.pi / 2)
    s = t * t
    sine = t * horner(s, [1, -1 / 6, 1 / 120, -1 / 5040, 1 / 362880])
    cosine = horner(s, [1, -1 / 2, 1 / 24, -1 / 720, 1 / 40320])
    cosine, sine = np.where(quarter % 2 == 0, cosine, sine), np.where(quarter % 2 == 0, sine, cosine)
    cosine = np.where((quarter == 1) | (quarter == 2), -cosine, cosine)
    sine = np.where(quarter >= 2, -sine, sine)
    both = np.stack([radius * cosine, radius * sine], axis=2)
    return both.reshape(rows, padded)[:, :columns]


def logarithm(x):
    mantissa, exponent = np.frexp(x)
    # To √½ … √2.
    small = mantissa < F(np.sqrt(0.5))
    mantissa = np.where(small, mantissa * F(2), mantissa)
    exponent = (exponent - small).astype(F)
    t = (mantissa - F(1)) / (mantissa + F(1))
    series = horner(t * t, [1, 1 / 3, 1 / 5, 1 / 7, 1 / 9])
    return exponent * F(np.log(2)) + F(2) * t * series


def horner(x, coefficients):
    total = F(coefficients[-1])
    for c in coefficients[-2::-1]:
        total = F(c) + x * total
    return total


def luma(rgb, assumptions, levels=1):
    """Luma of 0 to `levels`."""
    weights = {"rec709": (0.2126, 0.7152, 0.0722), "rec601": (0.299, 0.587, 0.114), "mean": (1 / 3,) * 3}
    r, g, b = (F(w / 255 if levels == 1 else w) for w in weights[assumptions["luma"]])
    c = rgb.astype(F)
    return r * c[..., 0] + g * c[..., 1] + b * c[..., 2]


def sobel(y, gain):
    """min(1, gain·|∇|) with the border replicated."""
    p = np.pad(y, 1, mode="edge")
    h, w = y.shape
    a, b, c = ([p[i : i + h, j : j + w] for j in range(3)] for i in range(3))
    gx = (a[2] - a[0]) + F(2) * (b[2] - b[0]) + (c[2] - c[0])
    gy = (c[0] - a[0]) + F(2) * (c[1] - a[1]) + (c[2] - a[2])
    return np.minimum(F(gain) * np.sqrt(gx * gx + gy * gy), F(1))


def outliers(valid, reach, diamond):
    """Valid and missing pixels without another of their kind within `reach`, where there are other pixels."""
    height, width = valid.shape
    if reach == 0 or height * width < 2:
        return np.zeros_like(valid), np.zeros_like(valid)
    alone = []
    for kind in (valid, ~valid):
        p = np.pad(kind, reach)
        others = np.zeros_like(kind)
        for dy in range(-reach, reach + 1):
            for dx in range(-reach, reach + 1):
                distance = abs(dx) + abs(dy) if diamond else max(abs(dx), abs(dy))
                if 0 < distance <= reach:
                    others |= p[reach + dy : reach + dy + height, reach + dx : reach + dx + width]
        alone.append(kind & ~others)
    return alone


def grey(value):
    byte = (np.clip(value, F(0), F(1)) * F(255) + F(0.5)).astype(np.uint8)
    return np.stack([byte, byte, byte, np.full_like(byte, 255)], axis=-1)


def single_view(
    depth, rgb=None, parameters=None, assumptions=None, seed=0, camera="", frame=0, item=0, positions=None
):
    """Isaac Sim's DepthSensorDistance and the other outputs, by name."""
    p = PARAMETERS | (parameters or {})
    a = ASSUMPTIONS | (assumptions or {})
    z = np.asarray(depth, F)
    height, width = z.shape
    columns = np.arange(width)
    near, far = F(p["minDistance"]), F(min(p["maxDistance"], float(np.finfo(F).max)))
    signed = p["baselineMM"] / 1000 * p["focalLengthPixel"] * width / p["sensorSizePixel"]
    bf = F(abs(signed))
    side = 1 if (signed > 0) == (a["direction"] == "right") else -1

    # 1: the range.
    surface = np.isfinite(z) & (z > 0)
    sample = surface & (z >= near) & (z <= far) if a["range-cut"] == "before" else surface

    # 2 and 3: disparity and its limit.
    with np.errstate(all="ignore"):
        d = np.where(sample, bf / np.where(sample, z, F(1)), F(0))
    unit = width / p["sensorSizePixel"] if a["max-disparity-unit"] == "sensor" else 1
    limit = F(p["maxDisparityPixel"] * unit)
    if a["max-disparity"] == "drop":
        sample &= d <= limit
    d = np.minimum(d, limit)

    # 4: steps and jitter.
    if p["noiseMean"] > 0:
        q = F(p["noiseMean"])
        sigma = F(p["noiseSigma"] * (p["noiseMean"] if a["sigma-unit"] == "steps" else 1))
        k = p["noiseDownscaleFactorPixel"]
        px, py = np.floor(columns / k).astype(int), np.floor(np.arange(height) / k).astype(int)
        if sample.size:
            key = plane_key(seed, camera, STAGE_JITTER)
            n = normals(key, frame, item, py[-1] + 1, px[-1] + 1)[py][:, px]
            d = q * (np.floor if a["quantizer"] == "floor" else np.rint)(d / q) + sigma * n

    # The depth that a sample carries.
    carried = z
    if a["depth"] == "recomputed":
        with np.errstate(all="ignore"):
            carried = bf / d
        sample &= (d > 0) & np.isfinite(carried)

    # 5: samples move along their rows.
    lacking = np.zeros(z.shape, bool)
    confidence = np.ones(z.shape, F)
    if rgb is not None:
        key = plane_key(seed, camera, STAGE_GRAIN)
        grain = F(a["grain"]) * normals(key, frame, item, height, width)
        shade = luma(rgb, a, 255)
        if a["luma-rounding"] == "8-bit":
            shade = np.trunc(shade + F(0.5))
        confidence = sobel(shade + grain, a["sobel-gain"] / 255)
        t = F(p["confidenceThreshold"])
        lacking = ~{
            "complement": lambda: confidence >= F(1) - t,
            "strict": lambda: confidence > F(1) - t,
            "literal": lambda: t * confidence >= t,
        }[a["confidence-comparison"]]()
    shift = (np.floor if a["target-rounding"] == "floor" else np.rint)(side * d)
    target = columns + np.where(np.abs(shift) <= width, shift, width).astype(int)
    sample &= (target >= 0) & (target < width)
    source = np.full(z.shape, -1)
    at_source = a["confidence-at"] == "source"
    for y in range(height):
        xs = np.flatnonzero(sample[y])
        if a["collision"] == "nearest":
            # The best is written last.
            order = np.lexsort((-xs, -(lacking[y, xs] & at_source).astype(int), -carried[y, xs]))
            xs = xs[order]
        source[y, target[y, xs]] = xs
    landed = source >= 0
    rows = np.arange(height)[:, None]

    def moved(values):
        return values[rows, np.maximum(source, 0)]

    # 6: confidence.
    keeps = landed & ~(moved(lacking) if at_source else lacking)
    distance = np.where(keeps, moved(carried), F(0))
    if a["range-cut"] == "after":
        distance = np.where((distance >= near) & (distance <= far), distance, F(0))
    before_outliers = distance.copy()
    moved_disparity, moved_confidence = moved(d), moved(confidence) if at_source else confidence

    # 7: outliers.
    lone, hole = outliers(distance > 0, int(p["outlierRemovalEnabled"]), a["outlier-neighbourhood"] == "4")
    if width > 1:
        for y, x in zip(*np.nonzero(hole)):
            from_x = x - 1 if x > 0 else 1
            distance[y, x] = before_outliers[y, from_x]
            source[y, x] = source[y, from_x]
    distance[lone] = 0

    # 8: outputs.
    out = {"distance": distance}
    valid = distance > 0
    if positions is not None:
        empty = {"zero": F(0), "nan": F(np.nan), "input": positions}[a["invalid"]]
        out["positions"] = np.where(valid[..., None], moved(positions), empty).astype(F)
    if rgb is not None:
        empty = rgb if a["invalid"] == "input" else np.uint8(0)
        out["colors"] = np.where(valid[..., None], moved(rgb), empty)
        out["imager"] = luma(rgb, a)
    view = picture(p, z, rgb, distance, before_outliers, landed, moved_disparity / limit, moved_confidence)
    if view is not None:
        out["view"] = view
    return out


def picture(p, z, rgb, distance, before_outliers, landed, disparity, confidence):
    """The image that rgbDepthOutputMode selects."""
    near, far = F(p["minDistance"]), F(min(p["maxDistance"], float(np.finfo(F).max)))
    mode = int(p["rgbDepthOutputMode"])
    shown = {1: distance, 2: distance, 3: distance, 4: z, 5: before_outliers}.get(mode)
    if mode == 0:
        return rgb
    if mode >= 6:
        view = grey(disparity)
        if mode == 6:
            view[..., 0] = grey(confidence)[..., 0]
            view[..., 2] = 0
        view[~landed] = (0, 0, 0, 255)
        return view
    seen = np.isfinite(shown) & (shown > 0)
    shown = np.where(seen, shown, F(1))
    place = (shown - near) / (far - near) if far > near else np.zeros_like(shown)
    if mode == 1:
        view = grey(shown - np.floor(shown))
    elif mode == 3:
        hue = F(4) * np.clip(place, F(0), F(1))
        channels = [F(2) - hue, np.minimum(hue, F(4) - hue), hue - F(2)]
        view = np.stack([*(grey(c)[..., 0] for c in channels), grey(hue)[..., 3]], axis=-1)
    else:
        view = grey(place)
    view[~seen] = (0, 0, 0, 255)
    return view
