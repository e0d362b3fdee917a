"""The share of a surface that depth sensors see and measure."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from . import _oaktwin
from ._html import table
from ._settings import settings_of

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._types import _Json, _Progress, _SensorOptions

_NUMBERS = (
    "height_m",
    "tilt_deg",
    "seen",
    "measured",
    "median_error_mm",
    "median_absolute_error_mm",
    "p95_absolute_error_mm",
)


class Coverage:
    """The coverage of a region by candidates: devices at poses.

    report: all results, as printed by `oaktwin coverage --json`; names contain the units.
    points: the outcomes at each point, if requested, else None. A dictionary: "position" and "normal", (P, 3) float64 in the
        world, metres; "instance", (P,) uint32, an index into "prim_paths"; "outcome", (C, P) uint8 by candidate, codes whose
        names are in "reasons", where 0 is measured; "error_m", (C, P) float32, measured minus true z in metres, NaN where nothing
        is measured.
    """

    def __init__(self, report: _Json, points: _Json | None = None) -> None:
        self.report = report
        self.points = points

    @property
    def candidates(self) -> list[_Json]:
        """One dictionary per candidate, beginning with the first device: "name", "model", "engine", "position_m", "orientation",
        "seen" and "measured" (shares of the surface), "median_absolute_error_mm" (None if nothing is measured), ..., "lost"
        (shares by reason) and "occluders"."""
        candidates: list[_Json] = self.report["candidates"]
        return candidates

    @property
    def ranking(self) -> list[int]:
        """The indices of the candidates by the share that they measure, then by their median absolute error, best first."""
        ranking: list[int] = self.report["ranking"]
        return ranking

    @property
    def best(self) -> _Json:
        """The best candidate."""
        return self.candidates[self.ranking[0]]

    @property
    def together(self) -> _Json:
        """The shares and errors of all candidates together."""
        together: _Json = self.report["together"]
        return together

    def to_numpy(self) -> npt.NDArray[np.void]:
        """Returns a structured array with one row per candidate: its numbers as float64, NaN if nothing is measured."""
        table = np.full(len(self.candidates), np.nan, dtype=[(name, np.float64) for name in _NUMBERS])
        for place, candidate in zip(table, self.candidates):
            for name in _NUMBERS:
                if candidate[name] is not None:
                    place[name] = candidate[name]
        return table

    def __repr__(self) -> str:
        best = self.best
        return (
            f"<oaktwin.Coverage of {self.report['region']['area_m2']:.4g} m²: {len(self.candidates)} candidates, "
            f"best {best['model']}, {best['name']}, measures {100 * best['measured']:.1f} %>"
        )

    def _repr_html_(self) -> str:
        names = ("model", "name", *_NUMBERS)
        rows = (self.candidates[index] for index in self.ranking)
        return table(names, ([row[name] for name in names] for row in rows))


def coverage(
    scene: _oaktwin.Scene,
    devices: _oaktwin.Device | _oaktwin.DepthSensor | Sequence[_oaktwin.Device | _oaktwin.DepthSensor],
    poses: npt.ArrayLike,
    *,
    region: str | Sequence[str] | None = None,
    region_box: npt.ArrayLike | None = None,
    height: Sequence[float] | str | None = None,
    tilt_deg: Sequence[float] | str | None = None,
    sensor: str | None = None,
    size: tuple[int, int] | None = None,
    samples: int = 10_000,
    tolerance_mm: float | None = None,
    points: bool = False,
    projector: float | None = None,
    ambient: float = 1.0,
    imager: Mapping[str, float | str | bool] | None = None,
    progress: _Progress = False,
    **options: Unpack[_SensorOptions],
) -> Coverage:
    """Measures which share of a surface the depth sensors of devices see and measure from poses, with which error, and why the
    rest is lost. Every device is a candidate at every pose.

    scene: the scene; the program opens it with micro_texture=True, without which stereo cameras measure little of plain surfaces.
    devices: a device, or several; or instead of a device a `DepthSensor` with its engine, filters and parameters, which `options`
        override.
    poses: world_from_body, (4, 4), or (N, 4, 4) for several poses, metres; x forward, y left, z up. See
        `Scene.look_at` with a device; a `CameraPose` is rejected.
    region: the path of a prim, or several: the region is the meshes at and below it; by default the whole scene.
    region_box: (2, 3), the minimum and maximum corner of a box in the world, metres: surface outside it does not belong to the
        region.
    height: heights along the up axis that replace the poses', metres, or the program's syntax "0.5:2:0.5".
    tilt_deg: angles below the horizontal that replace the poses', degrees; the heading is kept.
    sensor: "stereo", "tof" or the name of a prim; by default each device's own depth sensor.
    size: (width, height) of the sensor's images in px, resized by DepthAI's rule; by default its own.
    samples: the number of points that are distributed evenly over the surface, 1 to 1000000.
    tolerance_mm: the largest error of a point that counts as measured; by default any.
    points: whether the result has the outcomes at each point.
    projector: the intensity of the dot projector of a model that has one, from 0 (off) to 1; by default 1.
    ambient, imager: as for `Scene.render_pair`; `imager` is for the engine "stereo-matching".
    progress: whether a progress bar is shown on standard error; or a callable that gets the numbers of items that are done and in total.
    options: the options of `DepthSensor` from `engine` on. An engine that matches pairs gets rendered image pairs.

    A point is seen if nothing lies between it and the camera, and measured if its pixel has a value. All faces count, also those
    that no camera can see.

    Ctrl-C interrupts the measurement. Raises `oaktwin.Error` for invalid arguments, unknown prims and regions without surface.
    """
    several = [devices] if isinstance(devices, (_oaktwin.Device, _oaktwin.DepthSensor)) else list(devices)
    chosen: list[tuple[_oaktwin.Device, str | None, _SensorOptions]] = [
        settings_of(one, sensor, options) if isinstance(one, _oaktwin.DepthSensor) else (one, sensor, options) for one in several
    ]
    report, outcomes = _oaktwin.coverage(
        scene,
        chosen,
        poses,
        region=region,
        region_box=region_box,
        height=height,
        tilt_deg=tilt_deg,
        size=size,
        samples=samples,
        tolerance_mm=tolerance_mm,
        points=points,
        projector=projector,
        ambient=ambient,
        imager=imager,
        progress=progress,
    )
    return Coverage(report, outcomes)
