"""DepthAI's filters as functions, bit-identical to its host implementation.

image: an image (H, W) or a batch (N, H, W): uint16 (millimetres, or fixed-point disparity), uint8 (integer disparities) or
    float32 metres, which are filtered as integer millimetres. 0 is invalid.
out: the output array; by default a new array of the same dtype is returned.

Names and defaults are DepthAI's. The temporal filter has a state: `temporal` returns a `Filter` to be called with consecutive
frames. All functions raise `oaktwin.Error` for a setting out of range, TypeError for an object that is not an array or has
another dtype.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ._images import Filter

if TYPE_CHECKING:
    from ._types import _Array, _Measured

__all__ = ["brightness", "decimation", "median", "spatial", "speckle", "temporal", "threshold"]


def _text(name: str, **settings: object) -> str:
    settings_text = ",".join(f"{key}={value}" for key, value in settings.items() if value is not None)
    return f"{name}:{settings_text}"


def _run(text: str, image: _Array, rgb: _Array | None, out: Any) -> _Measured:
    result: _Measured = Filter(text)(image, rgb, out=out)
    return result


def median(image: _Array, *, size: int | None = None, out: object | None = None) -> _Measured:
    """Median filter; `size` is the width of its kernel, 3, 5 or 7 px."""
    return _run(_text("median", size=size), image, None, out)


def spatial(
    image: _Array,
    *,
    alpha: float | None = None,
    delta: int | None = None,
    radius: int | None = None,
    iterations: int | None = None,
    out: object | None = None,
) -> _Measured:
    """Edge-preserving smoothing along rows and columns.

    alpha: the weight of the pixel itself, 0 to 1. delta: the minimum step of an edge, 0 to 255, in the image's units.
    radius: the maximum width of holes that are filled, px. iterations: the number of passes.
    """
    return _run(_text("spatial", alpha=alpha, delta=delta, radius=radius, iterations=iterations), image, None, out)


def speckle(
    image: _Array, *, range: int | None = None, difference: int | None = None, out: object | None = None
) -> _Measured:
    """Removes regions of up to `range` pixels, in which neighbours differ by at most `difference` in the image's units."""
    return _run(_text("speckle", range=range, difference=difference), image, None, out)


def decimation(
    image: _Array, *, factor: int | None = None, mode: str | None = None, out: object | None = None
) -> _Measured:
    """Reduces the image size by `factor`, 1 to 4; `mode` is DepthAI's name of the method."""
    return _run(_text("decimation", factor=factor, mode=mode), image, None, out)


def threshold(
    image: _Array, *, min: int | None = None, max: int | None = None, out: object | None = None
) -> _Measured:
    """Invalidates pixels closer than `min` or farther than `max`, millimetres."""
    return _run(_text("threshold", min=min, max=max), image, None, out)


def brightness(
    image: _Array, rgb: _Array, *, min: int | None = None, max: int | None = None, out: object | None = None
) -> _Measured:
    """Invalidates pixels darker than `min` or brighter than `max`, 0 to 255, in the colour image `rgb`, (..., H, W, 3 or 4) uint8."""
    return _run(_text("brightness", min=min, max=max), image, rgb, out)


def temporal(
    *, alpha: float | None = None, delta: int | None = None, persistency: int | str | None = None
) -> Filter:
    """Creates a temporal filter, to be called with consecutive frames (H, W).

    alpha: the weight of the new frame, 0 to 1. delta: the minimum difference that is treated as a change, 0 to 255, in the
    image's units. persistency: how long a missing value is kept, 0 to 8 or DepthAI's name.
    """
    return Filter(_text("temporal", alpha=alpha, delta=delta, persistency=persistency))
