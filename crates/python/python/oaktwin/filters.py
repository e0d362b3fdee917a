"""DepthAI's filters one by one, bit for bit as its host runs them.

Each takes an image (H, W) or a batch (N, H, W): uint16 (millimetres, or disparity in fixed point), uint8 (whole disparities)
or float32 metres, which are filtered as whole millimetres; it returns `out`, where it is given, or a new array of the same
type. 0 is no value. Names and
defaults are DepthAI's. The temporal filter remembers: `temporal` returns a `Filter` to be called with one frame after the
other. All raise `oaktwin.Error` for a setting out of its range, TypeError for what is no array or of another type.
"""

from __future__ import annotations

from typing import Any

import numpy.typing as npt

from ._oaktwin import Filter

__all__ = ["brightness", "decimation", "median", "spatial", "speckle", "temporal", "threshold"]


def _text(name: str, **settings: object) -> str:
    said = ",".join(f"{key}={value}" for key, value in settings.items() if value is not None)
    return f"{name}:{said}"


def _run(text: str, image: object, rgb: object | None, out: Any) -> npt.NDArray[Any]:
    result: npt.NDArray[Any] = Filter(text)(image, rgb, out=out)
    return result


def median(image: object, *, size: int | None = None, out: object | None = None) -> npt.NDArray[Any]:
    """The median of 3x3, 5x5 or 7x7 pixels; `size` is 3, 5 or 7."""
    return _run(_text("median", size=size), image, None, out)


def spatial(
    image: object,
    *,
    alpha: float | None = None,
    delta: int | None = None,
    radius: int | None = None,
    iterations: int | None = None,
    out: object | None = None,
) -> npt.NDArray[Any]:
    """Smooths along rows and columns, and stops at edges.

    alpha: 0 to 1, how much a pixel keeps of itself. delta: a step from here on is an edge, 0 to 255, in the image's units.
    radius: holes as wide as this are filled, px. iterations: passes.
    """
    return _run(_text("spatial", alpha=alpha, delta=delta, radius=radius, iterations=iterations), image, None, out)


def speckle(
    image: object, *, range: int | None = None, difference: int | None = None, out: object | None = None
) -> npt.NDArray[Any]:
    """Removes islands of up to `range` pixels whose neighbours differ by no more than `difference`, in the image's units."""
    return _run(_text("speckle", range=range, difference=difference), image, None, out)


def decimation(
    image: object, *, factor: int | None = None, mode: str | None = None, out: object | None = None
) -> npt.NDArray[Any]:
    """Makes the image smaller by `factor`, 1 to 4; `mode` by DepthAI's name."""
    return _run(_text("decimation", factor=factor, mode=mode), image, None, out)


def threshold(
    image: object, *, min: int | None = None, max: int | None = None, out: object | None = None
) -> npt.NDArray[Any]:
    """Removes what is nearer than `min` or farther than `max`, millimetres."""
    return _run(_text("threshold", min=min, max=max), image, None, out)


def brightness(
    image: object, rgb: object, *, min: int | None = None, max: int | None = None, out: object | None = None
) -> npt.NDArray[Any]:
    """Removes what is darker than `min` or brighter than `max`, 0 to 255, in `rgb`, (..., H, W, 3 or 4) uint8."""
    return _run(_text("brightness", min=min, max=max), image, rgb, out)


def temporal(
    *, alpha: float | None = None, delta: int | None = None, persistency: int | str | None = None
) -> Filter:
    """A filter over time, to be called with one frame (H, W) after the other.

    alpha: 0 to 1, how much of the new frame counts. delta: a change from here on is one, 0 to 255, in the image's units.
    persistency: how long a lost value is kept: 0 to 8, or DepthAI's name.
    """
    return Filter(_text("temporal", alpha=alpha, delta=delta, persistency=persistency))
