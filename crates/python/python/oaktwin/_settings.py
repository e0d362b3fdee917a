"""The settings of a depth sensor for functions that measure with it."""

from __future__ import annotations

import json
import os
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from . import _oaktwin
from ._findings import Error

if TYPE_CHECKING:
    from ._types import _SensorOptions


def settings_of(
    sensor: _oaktwin.DepthSensor, name: str | None, options: _SensorOptions
) -> tuple[_oaktwin.Device, str | None, _SensorOptions]:
    """The device, the name and the options of a sensor, which other options override."""
    (device,), own = sensor.__getnewargs_ex__()
    settings: dict[str, Any] = dict(own)
    for foreign in ("fx", "hfov_deg", "camera"):
        if settings.pop(foreign, None) is not None:
            raise _oaktwin.Error(f"sensor: has {foreign}, for images of another camera; use a sensor without it")
    settings.pop("name", None)
    own_name = settings.pop("sensor", None)
    merged: _SensorOptions = {**settings, **options}  # type: ignore[typeddict-item]
    return device, own_name if name is None else name, merged


def as_json(argument: str, value: Any) -> str:
    """The text of dictionaries, lists, numbers and strings; NumPy's numbers and arrays, too."""

    def plain(one: Any) -> Any:
        if hasattr(one, "tolist"):
            return one.tolist()
        if hasattr(one, "__fspath__"):
            return os.fspath(one)
        raise TypeError(f"{argument}: contains {type(one).__name__}; pass texts, numbers, lists and dictionaries")

    if not hasattr(value, "items"):
        raise TypeError(f"{argument}: expected a mapping, got {type(value).__name__}")
    try:
        return json.dumps(dict(value), default=plain, allow_nan=False)
    except ValueError:
        raise _oaktwin.Error(f"{argument}: contains NaN or infinity; pass finite numbers") from None


def indices(name: str, given: Any, count: int) -> npt.NDArray[np.int64]:
    """The numbers of environments: of all if None is given, otherwise numbers or a mask, in ascending order."""
    if given is None:
        return np.arange(count)
    ids = np.asarray(given.cpu() if hasattr(given, "cpu") else given.numpy() if hasattr(given, "numpy") else given)
    if ids.dtype == np.bool_:
        if ids.shape != (count,):
            raise Error(f"{name}: a mask of shape {ids.shape}; pass one of shape ({count},), or numbers")
        return np.flatnonzero(ids)
    if ids.size and (not np.issubdtype(ids.dtype, np.integer) or ids.ndim != 1 or ids.min() < 0 or ids.max() >= count):
        raise Error(f"{name}: {given!r} are not numbers of environments; pass numbers from 0 to {count - 1}, or a mask")
    return np.unique(ids.astype(np.int64))
