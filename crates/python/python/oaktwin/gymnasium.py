# mypy: ignore-errors
"""OAK depth for environments of Gymnasium: `OakDepthObservation`, a wrapper.

Needs `pip install gymnasium`.
"""

from __future__ import annotations

from typing import Any

import numpy as np

try:
    import gymnasium as _gymnasium
except ImportError as error:
    raise ImportError("oaktwin.gymnasium needs Gymnasium: pip install gymnasium") from error

from ._findings import Error
from ._stream import Stream

__all__ = ["OakDepthObservation"]


class OakDepthObservation(_gymnasium.ObservationWrapper[Any, Any, Any]):
    """Replaces the exact depth in observations by what a policy sees of a depth camera.

    env: an environment whose observation is a depth image, (H, W) or (H, W, 1) float32 metres, or a dictionary that contains one.
    sensor: the sensor, as of `oaktwin.Stream`.
    key: the key of the depth image in a dictionary; None if the observation is the image.
    options: the other arguments of `oaktwin.Stream`; `latency` is required, and `control_hz` is the rate of steps.

    The depth image becomes (history, h, w) float32. Raises oaktwin.Error for an observation space without such an image.
    """

    def __init__(self, env: Any, sensor: Any, *, key: str | None = None, **options: Any) -> None:
        super().__init__(env)
        space = env.observation_space
        if key is not None:
            if not isinstance(space, _gymnasium.spaces.Dict) or key not in space.spaces:
                raise Error(f"key: the observation has no '{key}'; expected one of {', '.join(getattr(space, 'spaces', ['None']))}")
            image = space[key]
        else:
            image = space
        shape = getattr(image, "shape", None) or ()
        if len(shape) == 3 and shape[2] == 1:
            shape = shape[:2]
        if len(shape) != 2 or image.dtype != np.float32:
            raise Error(f"env: the observation is {image}; pass key= of a depth image, (H, W) or (H, W, 1) float32 metres")
        self._shape: tuple[int, ...] = shape
        self._key = key
        self._stream = Stream(sensor, **options)
        seen = _gymnasium.spaces.Box(-np.inf, np.inf, self._stream.shape(*shape), np.float32)
        self.observation_space = seen if key is None else _gymnasium.spaces.Dict({**space.spaces, key: seen})

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[Any, dict[str, Any]]:
        """Begins a new episode."""
        self._stream.reset()
        return super().reset(seed=seed, options=options)

    def observation(self, observation: Any) -> Any:
        """Replaces the depth."""
        depth = observation if self._key is None else observation[self._key]
        seen = self._stream(np.asarray(depth, np.float32).reshape(1, *self._shape)).depth[0]
        return seen if self._key is None else {**observation, self._key: seen}
