# mypy: ignore-errors
"""The kernel of drift: the steps of `crates/depth/src/sensor/drifted.rs`, operation by operation, in double precision."""

from typing import Any

import numpy as np
import warp as wp

from .._oaktwin import _drift

wp.set_module_options({"enable_backward": False, "fast_math": False, "fuse_fp": False})

# The numbers of a pair that neither drifts nor has the baseline of its design, as `_drift` returns them.
_NONE = [1.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 0.0]
_BEYOND = wp.constant(wp.float64(1e6))


@wp.kernel
def assume(depth: wp.array3d(dtype=float), pairs: wp.array2d(dtype=wp.float64), out: wp.array3d(dtype=float)):
    """The depth that the processor assigns to the true disparity of each pixel."""
    n, y, x = wp.tid()
    k = wp.min(n, pairs.shape[0] - 1)
    given = depth[n, y, x]
    if given > 0.0 and given < wp.inf:
        z = wp.float64(given)
        matched = z
        if pairs[k, 19] > wp.float64(0.0):
            fx = pairs[k, 0]
            cx = pairs[k, 2]
            column = wp.float64(x)
            ray_x = (column - cx) / fx * z
            ray_y = (wp.float64(y) - pairs[k, 3]) / pairs[k, 1] * z
            seen_x = ((pairs[k, 4] * ray_x + pairs[k, 7] * ray_y) + pairs[k, 10] * z) + pairs[k, 13]
            seen_z = ((pairs[k, 6] * ray_x + pairs[k, 9] * ray_y) + pairs[k, 12] * z) + pairs[k, 15]
            right = fx * (seen_x / seen_z) + cx
            px_m = pairs[k, 16] * pairs[k, 17]
            exact = px_m / z
            disparity = exact + (column - right - exact)
            matched = wp.float64(wp.inf)
            if disparity > wp.float64(0.0):
                matched = px_m / disparity
        given = float(wp.min(pairs[k, 18] * matched, _BEYOND))
    out[n, y, x] = given


def pairs_of(sensors: list[Any], size: tuple[int, ...], device: Any) -> Any:
    """The numbers of the drifted pairs of sensors for images of a size, or None if none has drifted."""
    height, width = size
    rows = [_drift(sensor, width, height) for sensor in sensors]
    if all(row is None for row in rows):
        return None
    table = np.array([_NONE if row is None else row for row in rows], np.float64)
    return wp.array(table, dtype=wp.float64, device=device)
