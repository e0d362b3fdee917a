"""The depth accuracy of a twin, measured by the vendor's method."""

from __future__ import annotations

import html
from collections.abc import Sequence
from os import PathLike
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from . import _oaktwin
from ._plot import finished, new_axes
from ._settings import settings_of

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from typing_extensions import Unpack

    from ._types import _Json, _Progress, _SensorOptions

_COLUMNS = (
    "distance_m",
    "error_percent",
    "fill_rate",
    "plane_fit_rms_mm",
    "subpixel_rms_px",
    "temporal_noise_mm",
    "precision_mm",
    "z_accuracy_mm",
    "pixel_error_percent",
)


class Accuracy:
    """The results of an accuracy measurement, in order of distance.

    report: all results, as printed by `oaktwin accuracy --json`; names contain the units.
    """

    def __init__(self, report: _Json) -> None:
        self.report = report

    @property
    def rows(self) -> list[_Json]:
        """One dictionary per distance: "distance_m", "error_percent" (None if nothing was measured), "fill_rate", ...,
        "bands" (the published accuracy at this distance) and "verdict"."""
        rows: list[_Json] = self.report["distances"]
        return rows

    @property
    def passed(self) -> bool:
        """Whether no distance lies outside its band and something was measured."""
        return bool(self.report["passed"])

    def to_numpy(self) -> npt.NDArray[np.void]:
        """Returns a structured array with one row per distance: the numbers of `rows` as float64, NaN if nothing was measured."""
        table = np.full(len(self.rows), np.nan, dtype=[(name, np.float64) for name in _COLUMNS])
        for place, row in zip(table, self.rows):
            for name in _COLUMNS:
                if row.get(name) is not None:
                    place[name] = row[name]
        return table

    def plot(self, ax: Axes | None = None) -> Axes:
        """Plots error over distance with the published bands and returns the axes.

        ax: the Matplotlib axes; by default a new figure's.

        Raises ImportError without Matplotlib: `pip install oaktwin[plot]`.
        """
        ax = new_axes() if ax is None else ax
        table = self.to_numpy()
        ax.plot(table["distance_m"], table["error_percent"], marker="o", label=f"{self.report['engine']}")
        limits = [(row["distance_m"], row["bands"][0]["error_percent"]) for row in self.rows if row["bands"]]
        if limits:
            distances, errors = zip(*limits)
            ax.fill_between(distances, 0.0, errors, step="pre", alpha=0.2, label="published")
        return finished(ax, self.report)

    def __repr__(self) -> str:
        verdict = "within the published accuracy" if self.passed else "NOT within the published accuracy"
        return f"<oaktwin.Accuracy {self.report['model']}: {len(self.rows)} distances, {verdict}>"

    def _repr_html_(self) -> str:
        def cell(value: object) -> str:
            shown = "" if value is None else f"{value:.4g}" if isinstance(value, float) else str(value)
            return f"<td>{html.escape(shown)}</td>"

        names = (*_COLUMNS, "verdict")
        head = "".join(f"<th>{name}</th>" for name in names)
        body = "".join("<tr>" + "".join(cell(row.get(name)) for name in names) + "</tr>" for row in self.rows)
        return f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"


def accuracy(
    device: _oaktwin.Device | _oaktwin.DepthSensor,
    *,
    sensor: str | None = None,
    distances: Sequence[float] | str | None = None,
    devices: int | None = None,
    population: bool = False,
    captures: int = 10,
    region: float = 0.05,
    measured: str | PathLike[str] | None = None,
    measured_from: float = 0.0,
    focal_px: float | None = None,
    width_px: int | None = None,
    progress: _Progress = False,
    **options: Unpack[_SensorOptions],
) -> Accuracy:
    """Measures a twin's depth accuracy by the vendor's method: a textured board at each distance, and the median unit.

    device: the device, or a `DepthSensor` with its engine, filters and parameters, which `options` override.
    sensor: "stereo", "tof" or the name of a prim; by default the device's own depth sensor.
    distances: the true distances in metres, or the program's range syntax "0.5:4:0.5"; by default about twenty.
    devices: the number of units; by default 200 if units differ and `device_seed` is None, otherwise 1.
    population: whether the units are drawn from the factory population, which also differ in their cameras: `rows` then have
        "error_5_to_95_percent", and `drift` gives the standard deviations of the units' drifts.
    captures: the number of images of each board, 1 to 1000.
    region: the side of the evaluated region as a share of the image's side, above 0, up to 1.
    measured: a CSV file with the columns distance_m and depth_error_percent, measured with a real unit: `report["measured"]`
        compares it with the twin.
    measured_from: the minimum distance of measurements that are compared, metres.
    focal_px: the focal length of the measured unit, px of images `width_px` wide; by default the device's own.
    width_px: the width of the unit's images: 1280 at 800P, 640 at 480P and 400P.
    progress: whether a progress bar is shown on standard error; or a callable that gets the numbers of items that are done and in total.
    options: the options of `DepthSensor` from `engine` on. An engine that matches pairs gets image pairs of the board; one that is
        written in Python is called for each capture of each unit, so that fewer `distances`, `devices` and `captures` save time.

    Ctrl-C interrupts the measurement. Raises `oaktwin.Error` for invalid arguments, FileNotFoundError or another OSError if
    the file cannot be read.
    """
    if isinstance(device, _oaktwin.DepthSensor):
        device, sensor, options = settings_of(device, sensor, options)
    report = _oaktwin.accuracy(
        device,
        sensor=sensor,
        distances=distances,
        devices=devices,
        population=population,
        captures=captures,
        region=region,
        measured=measured,
        measured_from=measured_from,
        focal_px=focal_px,
        width_px=width_px,
        progress=progress,
        **options,
    )
    return Accuracy(report)
