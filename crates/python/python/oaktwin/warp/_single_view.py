# mypy: ignore-errors
"""The kernels of "single-view": the steps of `crates/depth/src/single_view`, operation by operation, for depth without colours."""

from typing import Any

import numpy as np
import warp as wp

from ._random import JITTER, box_muller, key, philox

wp.set_module_options({"enable_backward": False, "fast_math": False, "fuse_fp": False})

_NONE = wp.constant(wp.uint32(0xFFFFFFFF))
_LARGEST = wp.constant(float(np.finfo(np.float32).max))
# The codes of reasons.
_NO_SURFACE, _TOO_NEAR, _TOO_FAR, _OUTSIDE, _OCCLUDED, _OUTLIER = (wp.constant(code) for code in (1, 2, 3, 4, 5, 12))


@wp.struct
class Plan:
    """The parameters and assumptions for images of one width, in single precision."""

    px_m: float
    side: float
    least: float
    most: float
    reported_least: float
    reported_most: float
    max_disparity: float
    clamps: int
    step: float
    floors: int
    sigma: float
    recomputes: int
    floors_target: int
    last_wins: int
    outlier_range: int
    outlier_diamond: int


@wp.kernel
def draw(
    keys: wp.array2d(dtype=wp.uint32),
    items: wp.array(dtype=wp.uint32),
    frame: wp.array(dtype=wp.uint32),
    out: wp.array3d(dtype=float),
):
    """Standard normal numbers of patches: a block of words makes four."""
    n, row, block = wp.tid()
    k = wp.min(n, keys.shape[0] - 1)
    words = philox(wp.uint32(block), wp.uint32(row), frame[0], items[n], keys[k, 0], keys[k, 1])
    column = 64 * (block // 16) + block % 16
    for half in range(2):
        both = box_muller(words[2 * half], words[2 * half + 1])
        for part in range(2):
            at = column + 32 * half + 16 * part
            if at < out.shape[2]:
                out[n, row, at] = both[part]


@wp.func
def exact_disparity(z: float, p: Plan) -> float:
    """The disparity of a sample, px; infinite for none."""
    d = float(wp.inf)
    if z > 0.0 and z >= p.least and z <= p.most:
        exact = p.px_m / z
        if p.clamps == 1 or exact <= p.max_disparity:
            d = wp.min(exact, p.max_disparity)
    return d


@wp.kernel
def move(
    depth: wp.array3d(dtype=float),
    normals: wp.array3d(dtype=float),
    row_patches: wp.array(dtype=wp.int32),
    column_patches: wp.array(dtype=wp.int32),
    plans: wp.array(dtype=Plan),
    ranks: wp.array3d(dtype=wp.uint32),
    out: wp.array3d(dtype=float),
    reasons: wp.array3d(dtype=wp.uint8),
):
    """Moves the samples of a row; twice the bits of depth are the rank of a sample, and of several the smallest wins."""
    n, y = wp.tid()
    p = plans[wp.min(n, plans.shape[0] - 1)]
    width = depth.shape[2]
    explains = reasons.shape[0] > 0
    for x in range(width):
        ranks[n, y, x] = _NONE
        if explains:
            reasons[n, y, x] = wp.uint8(0)
    for x in range(width):
        z = depth[n, y, x]
        d = exact_disparity(z, p)
        if p.step > 0.0:
            jitter = float(0.0)
            if p.sigma > 0.0:
                jitter = normals[n, row_patches[y], column_patches[x]]
            whole = d / p.step
            if p.floors == 1:
                whole = wp.floor(whole)
            else:
                whole = wp.rint(whole)
            d = p.step * whole + p.sigma * jitter
        carried = z
        if p.recomputes == 1:
            carried = p.px_m / d
            if not (d > 0.0 and carried <= _LARGEST):
                d = float(wp.inf)
        shift = p.side * d
        if p.floors_target == 1:
            shift = wp.floor(shift)
        else:
            shift = wp.rint(shift)
        if wp.abs(shift) <= float(width):
            target = x + wp.int32(shift)
            if target >= 0 and target < width:
                rank = wp.cast(carried, wp.uint32) << wp.uint32(1)
                if p.last_wins == 1:
                    ranks[n, y, target] = rank
                else:
                    ranks[n, y, target] = wp.min(rank, ranks[n, y, target])
        if explains and not wp.isfinite(d):
            # Where the sample that was dropped would have moved.
            true_disparity = float(0.0)
            code = _NO_SURFACE
            if wp.isfinite(z) and z > 0.0:
                true_disparity = p.px_m / z
                code = _TOO_FAR
                if z < p.least or (p.clamps == 0 and true_disparity > p.max_disparity):
                    code = _TOO_NEAR
            away = wp.rint(p.side * true_disparity)
            if wp.abs(away) <= float(width):
                place = x + wp.int32(away)
                if place >= 0 and place < width:
                    if reasons[n, y, place] == wp.uint8(0):
                        reasons[n, y, place] = wp.uint8(code)
    for x in range(width):
        rank = ranks[n, y, x]
        z = float(0.0)
        if rank != _NONE:
            z = wp.cast(rank >> wp.uint32(1), wp.float32)
        if not (z >= p.reported_least and z <= p.reported_most):
            z = 0.0
        out[n, y, x] = z


@wp.kernel
def explain(
    ranks: wp.array3d(dtype=wp.uint32), distance: wp.array3d(dtype=float), plans: wp.array(dtype=Plan), reasons: wp.array3d(dtype=wp.uint8)
):
    """The codes of a row before the removal of outliers."""
    n, y = wp.tid()
    p = plans[wp.min(n, plans.shape[0] - 1)]
    width = distance.shape[2]
    # What moves into the image at its border is outside the view.
    outside = bool(True)
    for i in range(width):
        x = i
        if p.side < 0.0:
            x = width - 1 - i
        rank = ranks[n, y, x]
        code = wp.int32(reasons[n, y, x])
        if rank != _NONE:
            outside = False
        if distance[n, y, x] > 0.0:
            code = 0
        elif rank == _NONE:
            if code == 0:
                code = _OCCLUDED
                if outside:
                    code = _OUTSIDE
        else:
            code = _TOO_FAR
            if wp.cast(rank >> wp.uint32(1), wp.float32) < p.reported_least:
                code = _TOO_NEAR
        reasons[n, y, x] = wp.uint8(code)


@wp.kernel
def remove_outliers(
    distance: wp.array3d(dtype=float), plans: wp.array(dtype=Plan), out: wp.array3d(dtype=float), reasons: wp.array3d(dtype=wp.uint8)
):
    """Lone pixels take the state of their neighbours."""
    n, y, x = wp.tid()
    p = plans[wp.min(n, plans.shape[0] - 1)]
    height = distance.shape[1]
    width = distance.shape[2]
    z = distance[n, y, x]
    measured = z > 0.0
    alone = p.outlier_range > 0
    for away in range(1, 2 * p.outlier_range + 2):
        # Rows from the nearest to the farthest: 0, -1, 1, -2, ...
        dy = away // 2
        if away % 2 == 1:
            dy = -dy
        at = y + dy
        if alone and at >= 0 and at < height:
            reach = p.outlier_range
            if p.outlier_diamond == 1:
                reach = p.outlier_range - wp.abs(dy)
            for column in range(wp.max(x - reach, 0), wp.min(x + reach + 1, width)):
                if (dy != 0 or column != x) and (distance[n, at, column] > 0.0) == measured:
                    alone = False
                    break
    if alone:
        if measured:
            z = 0.0
            if reasons.shape[0] > 0:
                reasons[n, y, x] = wp.uint8(_OUTLIER)
        else:
            near = x - 1
            if x == 0:
                near = wp.min(1, width - 1)
            z = distance[n, y, near]
            if reasons.shape[0] > 0:
                reasons[n, y, x] = wp.uint8(0)
    out[n, y, x] = z


class SingleView:
    """The engine for images of one size, with the arrays that it needs."""

    # What can differ between environments.
    PER_WORLD = (
        "baselineMM",
        "focalLengthPixel",
        "sensorSizePixel",
        "maxDisparityPixel",
        "minDistance",
        "maxDistance",
        "noiseMean",
        "noiseSigma",
        "outlierRemovalEnabled",
    )
    # The parameters that change the measurement, and those that only change what colours show, or nothing.
    PARAMETERS = frozenset(
        {
            *PER_WORLD,
            "noiseDownscaleFactorPixel",
            "depth",
            "max-disparity-unit",
            "max-disparity",
            "range-cut",
            "direction",
            "target-rounding",
            "collision",
            "quantizer",
            "sigma-unit",
            "outlier-neighbourhood",
        }
    )
    COLOURS = frozenset(
        {
            "confidenceThreshold",
            "enabled",
            "rgbDepthOutputMode",
            "showDistance",
            "confidence-at",
            "confidence-comparison",
            "sobel-gain",
            "grain",
            "luma",
            "luma-rounding",
            "invalid",
        }
    )

    def __init__(self, parameters: dict[str, Any], worlds: dict[str, Any], shape: tuple[int, int, int], device: Any) -> None:
        count, height, width = shape
        plans = [_plan(own, height, width) for own in of_each(parameters, worlds)]
        self._plans, self._shape, self._device = wp.array(plans, dtype=Plan, device=device), shape, device
        self._jitters = any(plan.step > 0 and plan.sigma > 0 for plan in plans)
        self._removes = any(plan.outlier_range > 0 for plan in plans)
        patches = [(np.arange(size) / parameters["noiseDownscaleFactorPixel"]).astype(np.int32) for size in (height, width)]
        self._patches = [wp.array(places, dtype=wp.int32, device=device) for places in patches]
        self._normals = wp.empty((count, *(int(places[-1]) + 1 for places in patches)), dtype=float, device=device)
        self._ranks = wp.empty(shape, dtype=wp.uint32, device=device)
        self._moved = wp.empty(shape, dtype=float, device=device)

    @staticmethod
    def keys(seed: int, camera: str) -> list[int]:
        """The keys of the random numbers of an image."""
        return [*key(seed, camera, JITTER)]

    def launch(self, depth: Any, keys: Any, items: Any, frame: Any, out: Any, reasons: Any) -> None:
        """Measures a batch."""
        p, device, rows = self._plans, self._device, self._shape[:2]
        if self._jitters:
            count, patch_rows, patch_columns = self._normals.shape
            blocks = 16 * -(-patch_columns // 64)
            wp.launch(draw, (count, patch_rows, blocks), [keys, items, frame], [self._normals], device=device)
        moved = self._moved if self._removes else out
        wp.launch(move, rows, [depth, self._normals, *self._patches, p], [self._ranks, moved, reasons], device=device)
        if reasons.shape[0]:
            wp.launch(explain, rows, [self._ranks, moved, p], [reasons], device=device)
        if self._removes:
            wp.launch(remove_outliers, self._shape, [moved, p], [out, reasons], device=device)


def of_each(parameters: dict[str, Any], worlds: dict[str, Any]) -> list[dict[str, Any]]:
    """The parameters of each environment; of the first alone, if they do not differ."""
    count = max((len(values) for values in worlds.values()), default=1)
    return [{**parameters, **{name: values[item].item() for name, values in worlds.items()}} for item in range(count)]


def _plan(a: dict[str, Any], height: int, width: int) -> Plan:
    """The plan of an environment's parameters."""
    signed = a["baselineMM"] / 1000.0 * a["focalLengthPixel"] * width / a["sensorSizePixel"]
    whole = (0.0, float(np.finfo(np.float32).max))
    limits = (a["minDistance"], min(a["maxDistance"], whole[1]))
    before = a["range-cut"] == "before"
    p = Plan()
    p.px_m = np.float32(abs(signed))
    p.side = 1.0 if (signed > 0) == (a["direction"] == "right") else -1.0
    p.least, p.most = (np.float32(limit) for limit in (limits if before else whole))
    p.reported_least, p.reported_most = (np.float32(limit) for limit in (whole if before else limits))
    unit = width / a["sensorSizePixel"] if a["max-disparity-unit"] == "sensor" else 1.0
    p.max_disparity = np.float32(a["maxDisparityPixel"] * unit)
    p.clamps = int(a["max-disparity"] == "clamp")
    p.step = np.float32(a["noiseMean"])
    p.floors = int(a["quantizer"] == "floor")
    p.sigma = np.float32(a["noiseSigma"] * (a["noiseMean"] if a["sigma-unit"] == "steps" else 1.0))
    p.recomputes = int(a["depth"] == "recomputed")
    p.floors_target = int(a["target-rounding"] == "floor")
    p.last_wins = int(a["collision"] == "last")
    p.outlier_range = int(a["outlierRemovalEnabled"]) if height * width > 1 else 0
    p.outlier_diamond = int(a["outlier-neighbourhood"] == "4")
    return p
