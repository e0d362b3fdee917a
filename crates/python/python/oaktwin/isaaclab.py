# mypy: ignore-errors
"""OAK depth for tasks of Isaac Lab: `OakDepth`, an observation term with noise, rate, delay and losses, and `OakDepthNoiseCfg`, noise alone.

Needs Isaac Lab, version 3 or 2. Three lines of a task:

    from oaktwin.isaaclab import OakDepth

    depth = ObsTerm(func=OakDepth, params={"sensor_cfg": SceneEntityCfg("camera"), "model": "OAK4-D", "stream": {"latency": (0.02, 0.06)}})

The camera renders "distance_to_image_plane". On a GPU, measuring takes place there, with Warp.
"""

from __future__ import annotations

from dataclasses import field
from typing import Any

try:
    from isaaclab.managers import ManagerTermBase
    from isaaclab.utils import configclass
    from isaaclab.utils.noise import NoiseModel, NoiseModelCfg
except ImportError as error:
    raise ImportError("oaktwin.isaaclab needs Isaac Lab: pip install isaaclab") from error

from ._depth_term import DepthNoise, DepthStream, with_optics
from ._findings import Error

__all__ = ["OakDepth", "OakDepthNoise", "OakDepthNoiseCfg"]

_DATA_TYPE = "distance_to_image_plane"


class OakDepth(ManagerTermBase):
    """An observation term: what a policy sees of an OAK at each step, (N, history, h, w) float32; see `oaktwin.Stream`.

    params: "sensor_cfg": the camera or ray caster camera of the scene; "model": the model, or an `oaktwin.Device`; "sensor": arguments
        of `oaktwin.DepthSensor`, by default the focal length of the camera; "stream": arguments of `oaktwin.Stream`, which must contain
        "latency". The rate of control is the environment's.

    Time passes once for each step of the environment, however often observations are computed. Raises oaktwin.Error for a camera
    without "distance_to_image_plane", and as `DepthSensor` and `Stream` do.
    """

    def __init__(self, cfg: Any, env: Any) -> None:
        super().__init__(cfg, env)
        self._depth = DepthStream()

    def reset(self, env_ids: Any = None) -> None:
        """Begins new episodes."""
        self._depth.reset(env_ids)

    def __call__(
        self,
        env: Any,
        sensor_cfg: Any,
        model: Any = "OAK4-D",
        sensor: dict[str, Any] | None = None,
        stream: dict[str, Any] | None = None,
    ) -> Any:
        """Observes; see the class."""
        data = env.scene.sensors[sensor_cfg.name].data
        if _DATA_TYPE not in data.output:
            raise Error(f"sensor_cfg: {sensor_cfg.name} renders {', '.join(data.output)}; add '{_DATA_TYPE}' to its data_types")
        options = with_optics(sensor, lambda: {"fx": float(_tensor(data.intrinsic_matrices)[0, 0, 0])})
        return self._depth.observe(env, _tensor(data.output[_DATA_TYPE]), model, options, stream or {})


def _tensor(value: Any) -> Any:
    """The tensor of an array of version 3, or a tensor of version 2."""
    return getattr(value, "torch", value)


class OakDepthNoise(NoiseModel):
    """Replaces exact depth by what an OAK measures; see `OakDepthNoiseCfg`."""

    def __init__(self, noise_model_cfg: Any, num_envs: int, device: str) -> None:
        super().__init__(noise_model_cfg, num_envs, device)
        self._noise = DepthNoise(noise_model_cfg.model, noise_model_cfg.sensor)

    def __call__(self, data: Any) -> Any:
        """Measures (N, H, W, 1) metres, of `mdp.image_depth` with normalize=False."""
        return self._noise(data)


@configclass
class OakDepthNoiseCfg(NoiseModelCfg):
    """The noise of an OAK without delay, for `mdp.image_depth` (`mdp.image` in version 2) of "distance_to_image_plane" with normalize=False.

    model: the model, or an `oaktwin.Device`.
    sensor: arguments of `oaktwin.DepthSensor`, such as {"hfov_deg": 77.0}.
    """

    class_type: Any = OakDepthNoise
    noise_cfg: Any = None
    model: Any = "OAK4-D"
    sensor: dict[str, Any] = field(default_factory=dict)
