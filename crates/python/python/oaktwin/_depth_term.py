"""What the observation terms and noise models for training frameworks share."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ._devices import Device
from ._findings import Error
from ._sensors import DepthSensor
from ._stream import Stream

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping


def make_sensor(model: Any, options: Mapping[str, Any], device: str) -> Any:
    """A depth sensor for tensors on a device: in Warp's kernels on a GPU."""
    oak = model if isinstance(model, Device) else Device(model)
    if not device.startswith("cuda"):
        return DepthSensor(oak, **options)
    from . import warp

    return warp.DepthSensor(oak, on=device if ":" in device else "cuda:0", **options)


def with_optics(options: Mapping[str, Any] | None, own: Callable[[], dict[str, float]]) -> dict[str, Any]:
    """The arguments of a sensor, with the optics of the simulator's camera, which `own` returns, unless they name others."""
    given = dict(options or {})
    return given if {"hfov_deg", "fx", "camera"} & set(given) else given | own()


class DepthStream:
    """A `Stream` that follows the steps and resets of an environment of a framework."""

    def __init__(self) -> None:
        self._stream: Stream | None = None
        self._step: int | None = None
        self._pending: list[Any] = []
        self._shown: Any = None

    def reset(self, env_ids: Any) -> None:
        """Notes that environments begin a new episode."""
        if self._stream is not None:
            ids = None if env_ids is None or isinstance(env_ids, slice) else env_ids
            self._stream.reset(ids)
            self._pending.append(ids)

    def observe(self, env: Any, depth: Any, model: Any, sensor: Mapping[str, Any], stream: Mapping[str, Any]) -> Any:
        """The observation (N, history, h, w), a tensor on the device of `depth`, which is (N, H, W, 1) metres."""
        import torch  # type: ignore[import-not-found, unused-ignore]

        if self._stream is None:
            if "latency" not in stream:
                raise Error('stream: has no latency; pass {"latency": (low, high)} in seconds, 0 for none')
            options = {"control_hz": 1 / env.step_dt, **stream}
            options["camera_hz"] = options.get("camera_hz", min(30.0, options["control_hz"]))
            self._stream = Stream(make_sensor(model, sensor, str(depth.device)), **options)
        step = getattr(env, "common_step_counter", None)
        if step is None or step != self._step or self._shown is None:
            shown = self._stream(depth)
        elif self._pending:
            mask = torch.zeros(len(depth), dtype=torch.bool)
            for ids in self._pending:
                mask[slice(None) if ids is None else ids] = True
            shown = self._stream(depth, env_ids=mask)
        else:  # the same step again
            return self._shown.clone()
        self._step, self._pending = step, []
        self._shown = shown.depth if torch.is_tensor(shown.depth) else torch.from_numpy(shown.depth)
        return self._shown.clone()


class DepthNoise:
    """Noise without delay for batches of images of a framework."""

    def __init__(self, model: Any, options: Mapping[str, Any]) -> None:
        self._model, self._options = model, options
        self._sensor: Any = None

    def __call__(self, data: Any) -> Any:
        """Measures (N, H, W), (N, H, W, 1) or (N, 1, H, W) metres: a tensor of the same shape."""
        import torch  # type: ignore[import-not-found, unused-ignore]

        shape = tuple(data.shape)
        if len(shape) == 4 and 1 in (shape[1], shape[3]):
            images = data.reshape(shape[0], *(shape[1:3] if shape[3] == 1 else shape[2:]))
        elif len(shape) == 3:
            images = data
        else:
            raise Error(f"data: has the shape {shape}; use the noise for depth images, (N, H, W, 1) or (N, 1, H, W)")
        if self._sensor is None:
            self._sensor = make_sensor(self._model, self._options, str(data.device))
        measured = self._sensor(images.detach().contiguous())
        return (measured if torch.is_tensor(measured) else torch.from_numpy(measured)).reshape(shape)
