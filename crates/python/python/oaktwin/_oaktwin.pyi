from collections.abc import Mapping, Sequence
from os import PathLike
from typing import Final

import numpy as np
import numpy.typing as npt
from typing_extensions import Unpack

from ._batches import SensorBatch as SensorBatch
from ._cameras import Camera as Camera, Rectification as Rectification, _camera as _camera, look_at as look_at
from ._devices import (
    Device as Device,
    _device as _device,
    models as models,
    parameters as parameters,
    presets as presets,
    simulate_imu as simulate_imu,
)
from ._findings import Error as Error, Finding as Finding, FindingWarning as FindingWarning, _finding as _finding
from ._images import Filter as Filter, align as align
from ._rigs import Rig as Rig
from ._scenes import Mesh as Mesh, Recipe as Recipe, Recording as Recording, Scene as Scene, annotators as annotators
from ._sensors import DepthSensor as DepthSensor, StereoMatcher as StereoMatcher, _drift as _drift
from ._types import _Array, _Json, _Progress, _SensorOptions
from ._worlds import Worlds as Worlds

__all__ = [
    "Camera",
    "DepthSensor",
    "Device",
    "Error",
    "Filter",
    "Finding",
    "FindingWarning",
    "Mesh",
    "Recipe",
    "Recording",
    "Rectification",
    "Rig",
    "Scene",
    "SensorBatch",
    "StereoMatcher",
    "Worlds",
    "__version__",
    "_camera",
    "_device",
    "_drift",
    "_finding",
    "_read_from",
    "accuracy",
    "align",
    "annotators",
    "coverage",
    "fit",
    "fit_latency",
    "look_at",
    "main",
    "models",
    "parameters",
    "presets",
    "set_memory_limit",
    "simulate_imu",
]

__version__: Final[str]

def accuracy(
    device: Device,
    *,
    sensor: str | None = None,
    distances: Sequence[float] | str | None = None,
    devices: int | None = None,
    population: bool = False,
    captures: int = ...,
    region: float = ...,
    measured: str | PathLike[str] | None = None,
    measured_from: float = 0.0,
    focal_px: float | None = None,
    width_px: int | None = None,
    progress: _Progress = ...,
    **options: Unpack[_SensorOptions],
) -> _Json:
    """Wraps the report of `oaktwin accuracy --json` as a dictionary, for `oaktwin.accuracy`."""
def coverage(
    scene: Scene,
    devices: Sequence[tuple[Device, str | None, _SensorOptions]],
    world_from_body: npt.ArrayLike,
    *,
    region: str | Sequence[str] | None = None,
    region_box: npt.ArrayLike | None = None,
    height: Sequence[float] | str | None = None,
    tilt_deg: Sequence[float] | str | None = None,
    size: tuple[int, int] | None = None,
    samples: int | None = None,
    tolerance_mm: float | None = None,
    points: bool = False,
    projector: float | None = None,
    ambient: float = 1.0,
    imager: Mapping[str, float | str | bool] | None = None,
    progress: _Progress = ...,
) -> tuple[_Json, _Json | None]:
    """Wraps the report of `oaktwin coverage --json` as a dictionary, and the outcomes by point, for `oaktwin.coverage`. Each device has the
    name of its sensor and its options.
    """
def fit(
    device: Device,
    recordings: Sequence[str | PathLike[str]] | Sequence[tuple[float, bytes]],
    *,
    sensor: str | None = None,
    region: float = ...,
    depth_scale: float = 0.001,
    measured_from: float = 0.0,
    focal_px: float | None = None,
    width_px: int | None = None,
    fits_focal_length: bool = False,
    progress: _Progress = ...,
    **options: Unpack[_SensorOptions],
) -> tuple[_Json, str]:
    """Wraps the report of `oaktwin fit --json` and its parameter file, for `oaktwin.fit`."""
def fit_latency(
    camera: tuple[Sequence[float] | npt.NDArray[np.float64], Sequence[float] | npt.NDArray[np.float64]],
    reference: tuple[Sequence[float] | npt.NDArray[np.float64], Sequence[float] | npt.NDArray[np.float64]],
    *,
    longest: float = ...,
) -> _Json:
    """Estimates the latency of a camera, the time from the middle of an exposure until its image arrives, from a moving edge; what `oaktwin fit
    --latency` does for files.

    camera: the times at which images arrived in seconds, increasing, and the positions of the edge in them, such as in pixels.
    reference: the times and positions of a reference that moves the edge, such as an encoder, on the same clock, in any unit, sampled densely.
    longest: the longest latency that is searched, seconds; the reference has to begin so much earlier than the images that count.

    Returns a dictionary: "latency_s" for `Stream(latency=)`, its "confidence_interval_95", "jitter_s" (the standard deviation from frame to
    frame), "edge_noise", "correlation", "images", "seconds", "passed".

    Issues an oaktwin.FindingWarning if several latencies explain the motion. Raises oaktwin.Error for times that do not increase, numbers
    that are not finite, fewer than 20 images that count, and positions that do not follow each other.
    """
def main(arguments: Sequence[str]) -> int:
    """Runs the program `oaktwin` in this process and returns its exit code.

    arguments: the command line without the program's name.
    """
def set_memory_limit(limit: str | int | None) -> None:
    """Limits the memory that this process uses: what a call needs is compared with it before the call begins.

    limit: such as "4G" or a number of bytes; None for as much as the system allows.

    A call that needs more raises oaktwin.Error. Up to 64 MiB are never checked. Raises oaktwin.Error for what is not a size.
    """
def _read_from(depth: _Array) -> int: ...
