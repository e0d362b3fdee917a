from typing import final, overload

import numpy.typing as npt

from ._cameras import Camera
from ._types import _AlignedZ, _Array, _Depth, _Fill, _Image, _Items, _Measured, _Out

__all__ = ["Filter", "align"]

@final
class Filter:
    """A chain of DepthAI's filters, bit-identical to its host implementation.

    filters: the filters as text, NAME or NAME:SETTING=VALUE,..., in order; omitted settings have DepthAI's defaults:
        "median:size=3|5|7", "spatial:alpha,delta,radius,iterations", "temporal:alpha,delta,persistency",
        "speckle:range,difference", "decimation:factor,mode", "threshold:min,max" (mm), "brightness:min,max".

    Raises oaktwin.Error for unknown names and settings, with the nearest names, and for invalid values.

    A call, `filter(image, rgb=None, *, out=None)`, filters an image (H, W), the next of a sequence, or a batch (N, H, W), the
    next images of N sequences.

    image: uint16 (millimetres, or fixed-point disparity), uint8 (integer disparities) or float32 metres, which are
        filtered as integer millimetres. 0 is invalid; in metres, so are values that are not finite and above 0, or beyond
        65.535 m.
    rgb: the colour images of the same camera, (..., H, W, 3 or 4) uint8, required by "brightness".
    out: the output array: C-contiguous, with the result's shape and the image's dtype; must not overlap the image.

    Returns `out`, or a new array of the same dtype; smaller if a filter decimates.

    Raises TypeError for an object that is not an array or has another dtype, oaktwin.Error for an invalid shape.

    A temporal filter remembers the (H, W) images of earlier calls, and of batches the images of each item, until the image size
    changes; see `reset()`. Thread-safe; calls of one filter run one after another. Copies and pickles have the settings, but not
    the state of temporal filters.
    """
    def __new__(cls, *filters: str) -> Filter: ...
    @overload
    def __call__(
        self, image: npt.NDArray[_Image], rgb: _Array | None = None, *, out: None = None
    ) -> npt.NDArray[_Image]:
        """Filters an image or a batch; see the class."""
    @overload
    def __call__(self, image: _Array, rgb: _Array | None = None, *, out: None = None) -> _Measured: ...
    @overload
    def __call__(self, image: _Array, rgb: _Array | None = None, *, out: _Out) -> _Out: ...
    def __getnewargs__(self) -> tuple[str, ...]: ...
    def reset(self, items: _Items | None = None) -> None:
        """Starts a new sequence: temporal filters forget earlier images.

        items: the numbers of the items of batches that start a new sequence, or a mask; the others, and the (H, W) images, go on.
        """

@overload
def align(
    depth: npt.NDArray[_Depth],
    source: Camera,
    target: Camera,
    *,
    target_from_source: npt.ArrayLike | None = None,
    z: _AlignedZ = "geometric",
    fill: _Fill = "footprint",
    out: None = None,
) -> npt.NDArray[_Depth]:
    """Aligns depth images to another camera; each target pixel gets the nearest sample that falls into it.

    depth: (H, W) or (N, H, W) of the source camera's size, float32 metres or uint16 millimetres along its optical axis;
        values that are not finite and above 0 are invalid.
    source, target: the cameras.
    target_from_source: (4, 4) transform in metres; by default computed from the cameras' poses on their device.
    z: "geometric" (default): depth along the target's axis; "measured": the samples' own, as RVC2's alignment reports it.
    fill: "footprint" (default): a sample fills all pixels that it covers; "nearest": only the one that contains its centre.
    out: the output array, as for a call of DepthSensor.

    Returns an array of depth's dtype, (H, W) or (N, H, W) of the target's size, 0 where invalid.

    Raises oaktwin.Error if the size of depth is not the source's.
    """
@overload
def align(
    depth: _Array,
    source: Camera,
    target: Camera,
    *,
    target_from_source: npt.ArrayLike | None = None,
    z: _AlignedZ = "geometric",
    fill: _Fill = "footprint",
    out: None = None,
) -> _Measured: ...
@overload
def align(
    depth: _Array,
    source: Camera,
    target: Camera,
    *,
    target_from_source: npt.ArrayLike | None = None,
    z: _AlignedZ = "geometric",
    fill: _Fill = "footprint",
    out: _Out,
) -> _Out: ...
