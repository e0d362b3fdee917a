from collections.abc import Sequence
from typing import final, overload

import numpy as np
import numpy.typing as npt

from ._findings import Finding
from ._types import _Annotated, _Array, _Depth, _Items, _Measured, _Out, _Seeds, _SensorAnnotator

__all__ = ["SensorBatch"]

@final
class SensorBatch:
    """The depth sensors of simultaneous images, such as the environments of a simulator, made by `DepthSensor.batch`. Each item has its own unit,
    parameters, memory of temporal filters, and episodes: frames are numbered from 0 on in each.

    A call, `batch(depth, rgb=None, *, frame=None, out=None)`, measures an image of each item: `depth` (N, H, W), with the arguments and results
    of a call of `DepthSensor`. Without `frame`, the images of an item are numbered from 0 on since its episode began.

    The noise of an item is a function of the sensor's seed and name, the item's number or seed, its episode and the frame. So an item
    repeats its noise if it repeats its episode, whatever the others do.

    Thread-safe; calls with a temporal filter run one after another. Copies and pickles have the settings, and the numbers of the episodes and
    of the next frames, but not the state of temporal filters.
    """
    @overload
    def __call__(
        self, depth: npt.NDArray[_Depth], rgb: _Array | None = None, *, frame: int | None = None, out: None = None
    ) -> npt.NDArray[_Depth]:
        """Measures an image of each item; see the class."""
    @overload
    def __call__(
        self, depth: _Array, rgb: _Array | None = None, *, frame: int | None = None, out: None = None
    ) -> _Measured: ...
    @overload
    def __call__(self, depth: _Array, rgb: _Array | None = None, *, frame: int | None = None, out: _Out) -> _Out: ...
    def __len__(self) -> int: ...
    def __getstate__(self) -> list[tuple[int, int]]: ...
    def __setstate__(self, clocks: Sequence[tuple[int, int]]) -> None: ...
    def annotate(
        self, depth: _Array, rgb: _Array | None = None, *, annotators: Sequence[_SensorAnnotator], frame: int | None = None
    ) -> _Annotated:
        """The outputs of Isaac Sim's depth sensor annotators for an image of each item, from one measurement.

        depth, rgb, frame: as in a call.
        annotators: of "depth_sensor_distance", "depth_sensor_confidence" and "depth_sensor_reason".

        Returns a dictionary by name, as `DepthSensor.annotate` does, with arrays (N, H, W).

        Raises oaktwin.Error for other annotators, and for outputs that the engine does not support.
        """
    def reset(self, items: _Items | None = None, *, episode: int | _Seeds | None = None) -> None:
        """Starts new sequences: temporal filters forget earlier images.

        items: the numbers of the items, or a mask; by default all. The others go on.
        episode: the number of the episode that begins, or one for each of these items: frames are numbered from 0 on, with the noise of that
            episode. By default, the numbering continues, so that no noise repeats. Episode 0 is the one that every item begins with.
        """
    @property
    def episodes(self) -> npt.NDArray[np.uint64]:
        """The number of the present episode of each item, (N,) uint64."""
    @property
    def frames(self) -> npt.NDArray[np.uint64]:
        """The number of the next frame of each item, (N,) uint64."""
    @property
    def findings(self) -> list[Finding]:
        """Findings about the settings of all items, and about the images measured so far, as `DepthSensor.findings`."""
