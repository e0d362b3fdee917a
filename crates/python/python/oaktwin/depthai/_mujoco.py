"""A MuJoCo model as the world of a virtual device."""

from __future__ import annotations

import importlib
from collections.abc import Callable
from typing import Any

from .._findings import Error
from .._mujoco_shapes import pose_of
from ..mujoco import drawn
from ._world import World


def from_mujoco(model: Any, data: Any, body: str, *, step: Callable[[float], None] | None = None) -> World:
    """The world of a MuJoCo model, in which a device is mounted on one of its bodies.

    model, data: the mujoco.MjModel and its mujoco.MjData, whose present state is shown.
    body: the name of the body that is the device's: x forward, y left, z up.
    step: a function of the time in seconds that advances `data` before each image, such as one that calls mujoco.mj_step; it runs in a
        thread of a pipeline. Without it, what another thread does to `data` is shown.

    Geoms of the groups 0 to 2 are shown, with the colours of their materials, without textures. Raises oaktwin.Error for an unknown body.
    """
    mujoco: Any = importlib.import_module("mujoco")
    number = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_BODY, body)
    if number < 0:
        raise Error(f"body: the MuJoCo model has no body {body!r}; name the one that is the device's")
    mujoco.mj_forward(model, data)
    scene, geoms = drawn(model, data)
    names = [f"geom_{index}" for index in geoms]

    def update(seconds: float) -> None:
        if step is not None:
            step(seconds)
        scene.set_poses(dict(zip(names, pose_of(data.geom_xpos[geoms], data.geom_xmat[geoms]), strict=True)))

    return World(scene, pose=lambda _: pose_of(data.xpos[number], data.xmat[number]), update=update)
