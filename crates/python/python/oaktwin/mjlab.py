# mypy: ignore-errors
"""OAK depth for tasks of mjlab: `OakDepth`, an observation term with noise, rate, delay and losses, and `OakDepthNoiseCfg`, noise alone.

Needs `pip install mjlab`. Three lines of a task:

    from oaktwin.mjlab import OakDepth

    depth = ObservationTermCfg(func=OakDepth, params={"sensor_name": "camera", "model": "OAK-D Lite", "stream": {"latency": (0.02, 0.06)}})

The camera is a `CameraSensorCfg` with the data type "depth". On a GPU, measuring takes place there, with Warp.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any

try:
    from mjlab.managers.manager_base import ManagerTermBase
    from mjlab.utils.noise.noise_cfg import NoiseCfg, NoiseModelCfg
    from mjlab.utils.noise.noise_model import NoiseModel
except ImportError as error:
    raise ImportError("oaktwin.mjlab needs mjlab: pip install mjlab") from error

from ._depth_term import DepthNoise, DepthStream, with_optics
from ._findings import Error

__all__ = ["OakDepth", "OakDepthNoise", "OakDepthNoiseCfg"]


class OakDepth(ManagerTermBase):
    """An observation term: what a policy sees of an OAK at each step, (N, history, h, w) float32; see `oaktwin.Stream`.

    params: "sensor_name": the camera sensor of the scene; "model": the model, or an `oaktwin.Device`; "sensor": arguments of
        `oaktwin.DepthSensor`, by default the horizontal field of view of the camera; "stream": arguments of `oaktwin.Stream`, which
        must contain "latency". The rate of control is the environment's.

    Time passes once for each step of the environment, however often observations are computed. Raises oaktwin.Error for a sensor
    without depth, and as `DepthSensor` and `Stream` do.
    """

    def __init__(self, cfg: Any, env: Any) -> None:
        super().__init__(env)
        self._depth = DepthStream()

    def reset(self, env_ids: Any = None) -> None:
        """Begins new episodes."""
        self._depth.reset(env_ids)

    def __call__(
        self,
        env: Any,
        sensor_name: str,
        model: Any = "OAK4-D",
        sensor: dict[str, Any] | None = None,
        stream: dict[str, Any] | None = None,
    ) -> Any:
        """Observes; see the class."""
        camera = env.scene[sensor_name]
        depth = camera.data.depth
        if depth is None:
            raise Error(f"sensor_name: {sensor_name} renders no depth; add 'depth' to its data_types")
        options = with_optics(sensor, lambda: {"hfov_deg": _hfov_deg(env, camera, depth)})
        return self._depth.observe(env, depth, model, options, stream or {})


def _hfov_deg(env: Any, camera: Any, depth: Any) -> float:
    fovy = float(env.sim.mj_model.cam_fovy[camera.camera_idx])
    height, width = depth.shape[1:3]
    return math.degrees(2 * math.atan(math.tan(math.radians(fovy) / 2) * width / height))


class OakDepthNoise(NoiseModel):
    """Replaces exact depth by what an OAK measures; see `OakDepthNoiseCfg`."""

    def __init__(self, noise_model_cfg: Any, num_envs: int, device: str) -> None:
        self._noise_model_cfg, self._num_envs, self._device = noise_model_cfg, num_envs, device
        self._noise = DepthNoise(noise_model_cfg.model, noise_model_cfg.sensor)

    def __call__(self, data: Any) -> Any:
        """Measures (N, H, W, 1) or (N, 1, H, W) metres."""
        return self._noise(data)


@dataclass(kw_only=True)
class OakDepthNoiseCfg(NoiseModelCfg, class_type=OakDepthNoise):
    """The noise of an OAK without delay, for an observation term of exact depth in metres, (N, H, W, 1) or (N, 1, H, W).

    model: the model, or an `oaktwin.Device`.
    sensor: arguments of `oaktwin.DepthSensor`, such as {"hfov_deg": 77.0}.
    """

    model: Any = "OAK4-D"
    sensor: dict[str, Any] = field(default_factory=dict)
    noise_cfg: NoiseCfg | None = None
