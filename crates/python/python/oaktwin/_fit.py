"""The parameters of one unit, fitted to recordings of a flat target."""

from __future__ import annotations

import io
from collections.abc import Mapping, Sequence
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _oaktwin
from ._html import table
from ._plot import finished, new_axes

if TYPE_CHECKING:
    import numpy.typing as npt
    from matplotlib.axes import Axes
    from typing_extensions import Unpack

    from ._types import _Json, _Progress, _SensorOptions

    _Images = npt.NDArray[Any] | Sequence[npt.NDArray[Any]]


class Fit:
    """Fitted parameters of a depth sensor.

    report: all results, as printed by `oaktwin fit --json`; names contain the units.
    toml: the parameters as the text of a file, which the program's `--params` reads.

    `DepthSensor(parameters=fit)` uses it.
    """

    def __init__(self, report: _Json, toml: str) -> None:
        self.report = report
        self.toml = toml

    @property
    def parameters(self) -> dict[str, float]:
        """The values by name."""
        return {one["name"]: one["value"] for one in self.report["parameters"] if one["is_fitted"]}

    @property
    def intervals(self) -> dict[str, tuple[float, float] | None]:
        """The interval of 95 % confidence of each value; None if it is not known."""
        found = {one["name"]: one["confidence_interval_95"] for one in self.report["parameters"] if one["is_fitted"]}
        return {name: None if both is None else (both[0], both[1]) for name, both in found.items()}

    @property
    def passed(self) -> bool:
        """Whether all parameters were found and the recording has no oddities."""
        return bool(self.report["passed"])

    def save(self, path: str | PathLike[str]) -> None:
        """Writes the parameters to a TOML file.

        path: the file to write.
        """
        Path(path).write_text(self.toml, encoding="utf-8")

    def plot(self, ax: Axes | None = None) -> Axes:
        """Plots the measured errors over distance with the fitted curve and returns the axes.

        ax: the Matplotlib axes; by default a new figure's.

        Raises ImportError without Matplotlib: `pip install oaktwin[plot]`.
        """
        ax = new_axes() if ax is None else ax
        points = sorted(self.report["points"], key=lambda point: point["distance_m"])
        distances = [point["distance_m"] for point in points]
        ax.plot(distances, [point["error_percent"] for point in points], "o", label="measured")
        fitted = [(point["distance_m"], point["fitted_percent"]) for point in points if point["fitted_percent"] is not None]
        if fitted:
            ax.plot(*zip(*fitted), label="fitted")
        ax.axhline(0.0, color="0.7", linewidth=0.8)
        return finished(ax, self.report)

    def _repr_html_(self) -> str:
        intervals = self.intervals
        rows = [(name, value, *(intervals[name] or (None, None))) for name, value in self.parameters.items()]
        title = f"{self.report['model']}, {self.report['engine']}"
        return table(("parameter", "value", "from (95 %)", "to (95 %)"), rows, title)

    def __repr__(self) -> str:
        values = ", ".join(f"{name} {value:.4g}" for name, value in self.parameters.items())
        return f"<oaktwin.Fit {self.report['model']} {self.report['engine']}: {values or 'no parameter found'}>"


def _npy(distance: float, images: _Images) -> bytes:
    """The images of a target as an NPY file."""
    try:
        array = np.stack([np.asarray(one) for one in images])
    except (TypeError, ValueError) as error:
        raise _oaktwin.Error(f"recordings: {distance} m: {error}; pass images of one size, (N, H, W)") from error
    if array.ndim == 2:
        array = array[None]
    if array.dtype not in (np.float32, np.float64, np.uint16) or array.ndim != 3:
        kind = f"{array.dtype} of shape {array.shape}"
        raise _oaktwin.Error(f"recordings: {distance} m: is {kind}; pass float32 metres or uint16 of (N, H, W)")
    file = io.BytesIO()
    np.save(file, np.ascontiguousarray(array, np.uint16 if array.dtype == np.uint16 else np.float32))
    return file.getvalue()


def fit(
    device: _oaktwin.Device,
    recordings: str | PathLike[str] | Sequence[str | PathLike[str]] | Mapping[float, _Images],
    *,
    sensor: str | None = None,
    region: float = 0.05,
    depth_scale: float = 0.001,
    measured_from: float = 0.0,
    focal_px: float | None = None,
    width_px: int | None = None,
    fits_focal_length: bool = False,
    progress: _Progress = False,
    **options: Unpack[_SensorOptions],
) -> Fit:
    """Fits the parameters of a depth sensor to recordings of one unit.

    recordings: folders of depth images of a flat target perpendicular to the camera, each with a table distances.csv with the
        columns file and distance_m; a folder in the layout of Replicator's BasicWriter with distance_to_image_plane and
        depth_sensor_distance; or a CSV file of errors with the columns distance_m and depth_error_percent. Or a mapping from true
        distances in metres to the images of the target there, such as {1.0: images, 2.0: images}: (N, H, W) or a list of (H, W),
        float32 metres or uint16 in units of `depth_scale`, in chronological order.
    sensor: "stereo", "tof" or the name of a prim; by default the engine's, or the device's own.
    region: the side of the evaluated region as a share of the image's side, above 0, up to 1.
    depth_scale: the metres per unit of integer images.
    measured_from: the minimum distance of errors that count, metres.
    focal_px: the focal length of the unit, px of images `width_px` wide; by default the device's own.
    width_px: the width of the unit's images: 1280 at 800P, 640 at 480P and 400P.
    fits_focal_length: whether to fit the focal length as well.
    progress: whether a progress bar is shown on standard error; or a callable that gets the numbers of items that are done and in total.
    options: what is known of the sensor: the options engine, preset, parameters and extended_disparity of `DepthSensor`, such as
        parameters={"subpixelFractionalBits": 3}.

    Ctrl-C interrupts the fit. Issues an `oaktwin.FindingWarning` for oddities of the recordings. Raises FileNotFoundError for
    recordings that do not exist, `oaktwin.Error` for others that cannot be read and for invalid arguments.
    """
    read: Sequence[str | PathLike[str]] | Sequence[tuple[float, bytes]]
    if isinstance(recordings, Mapping):
        read = [(float(distance), _npy(distance, images)) for distance, images in recordings.items()]
    else:
        read = [recordings] if isinstance(recordings, (str, PathLike)) else list(recordings)
    report, toml = _oaktwin.fit(
        device,
        read,
        sensor=sensor,
        region=region,
        depth_scale=depth_scale,
        measured_from=measured_from,
        focal_px=focal_px,
        width_px=width_px,
        fits_focal_length=fits_focal_length,
        progress=progress,
        **options,
    )
    return Fit(report, toml)
