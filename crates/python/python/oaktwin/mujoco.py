"""Scenes and worlds of MuJoCo models. Requires the package mujoco, whose models they are: `pip install mujoco`.

Geoms of the groups 0 to 2 are shown, with the colours of their materials, without textures; of height fields the upper surface.
"""

from __future__ import annotations

import importlib
import warnings
from collections.abc import Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from ._cameras import Camera
from ._findings import Error, FindingWarning
from ._mujoco_shapes import mesh_of, pose_of
from ._scenes import Scene
from ._worlds import Worlds as _Worlds

__all__ = ["Worlds", "scene"]


def drawn(model: Any, data: Any) -> tuple[Scene, list[int]]:
    """The scene of a model in the present state of its data, and the geoms that it shows: the part of geom 3 is "geom_3"."""
    shapes = {index: mesh_of(model, index) for index in range(model.ngeom)}
    unknown = sorted({shape for shape in shapes.values() if isinstance(shape, str)})
    if unknown:
        text = f"model: geoms of the types {', '.join(unknown)} are not shown; only shapes, meshes and height fields are"
        warnings.warn(text, FindingWarning, stacklevel=3)
    meshes = {index: shape for index, shape in shapes.items() if shape is not None and not isinstance(shape, str)}
    if not meshes:
        raise Error("model: it has no geoms of the groups 0 to 2 that can be shown; show some, or move them to these groups")
    geoms = list(meshes)
    poses = pose_of(data.geom_xpos[geoms], data.geom_xmat[geoms])
    parts = {f"geom_{index}": mesh for index, mesh in meshes.items()}
    return Scene.from_meshes(parts, poses=dict(zip(parts, poses, strict=True))), geoms


def scene(model: Any, data: Any = None) -> Scene:
    """Returns the scene of a model, whose parts are named after the numbers of their geoms, such as "geom_3".

    model: the mujoco.MjModel.
    data: its mujoco.MjData after mj_forward; by default the initial state.

    Warns with oaktwin.FindingWarning about geoms that are not shown. Raises oaktwin.Error for a model without any.
    """
    return drawn(model, _initial(model) if data is None else data)[0]


class Worlds:
    """Many worlds of one MuJoCo model, such as the environments of a simulator, in which the bodies move.

    model: the mujoco.MjModel.
    count: the number of worlds.

    worlds: the `oaktwin.Worlds`, for parts that are moved otherwise.
    geoms: the numbers of the geoms that move, in the order of `update`.
    """

    def __init__(self, model: Any, count: int) -> None:
        self._model, self._data = model, _initial(model)
        shown, geoms = drawn(model, self._data)
        # The world is body 0, and what is welded to it does not move.
        self.geoms = [index for index in geoms if model.body_weldid[model.geom_bodyid[index]] != 0]
        self._names = [f"geom_{index}" for index in self.geoms]
        self.worlds = _Worlds(shown, count)

    def __len__(self) -> int:
        return len(self.worlds)

    def update(
        self,
        qpos: npt.ArrayLike | None = None,
        *,
        geom_xpos: npt.ArrayLike | None = None,
        geom_xmat: npt.ArrayLike | None = None,
        worlds: Sequence[int] | npt.NDArray[Any] | None = None,
    ) -> None:
        """Moves the bodies of worlds.

        qpos: (N, nq), the positions of the joints in N worlds, from which MuJoCo computes where the geoms are. Or
        geom_xpos, geom_xmat: (N, ngeom, 3) and (N, ngeom, 9) or (N, ngeom, 3, 3), where they are: those of mujoco_warp's data, or stacked from
            those of several mujoco.MjData, which is faster.
        worlds: the numbers of the N worlds, or a mask; by default all.

        Raises oaktwin.Error for other shapes, and numbers that are not finite.
        """
        if qpos is not None and geom_xpos is None and geom_xmat is None:
            geom_xpos, geom_xmat = self._kinematics(np.asarray(qpos, np.float64))
        elif qpos is not None or geom_xpos is None or geom_xmat is None:
            raise Error("qpos: pass either qpos, or geom_xpos and geom_xmat")
        positions, rotations = np.asarray(geom_xpos, np.float64), np.asarray(geom_xmat, np.float64)
        for name, array in (("geom_xpos", positions), ("geom_xmat", rotations)):
            if array.ndim < 3 or array.shape[1] != self._model.ngeom:
                raise Error(f"{name}: has shape {array.shape}; pass (N, {self._model.ngeom}, …), with all geoms of the model")
        if self.geoms:
            poses = pose_of(positions[:, self.geoms], rotations[:, self.geoms])
            self.worlds.set_poses(self._names, poses, worlds=worlds)

    def _kinematics(self, qpos: npt.NDArray[np.float64]) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.float64]]:
        mujoco: Any = importlib.import_module("mujoco")
        model, data = self._model, self._data
        if qpos.ndim != 2 or qpos.shape[1] != model.nq:
            raise Error(f"qpos: has shape {qpos.shape}; pass (N, {model.nq})")
        if not np.isfinite(qpos).all():
            raise Error("qpos: has values that are not finite; reset these worlds")
        positions, rotations = np.empty((len(qpos), model.ngeom, 3)), np.empty((len(qpos), model.ngeom, 9))
        for number, own in enumerate(qpos):
            data.qpos[:] = own
            mujoco.mj_kinematics(model, data)
            positions[number], rotations[number] = data.geom_xpos, data.geom_xmat
        return positions, rotations

    def render(self, camera: Camera, world_from_camera: npt.ArrayLike, **options: Any) -> npt.NDArray[np.float32]:
        """Renders the depth of a camera in each world: `oaktwin.Worlds.render`."""
        return self.worlds.render(camera, world_from_camera, **options)


def _initial(model: Any) -> Any:
    mujoco: Any = importlib.import_module("mujoco")
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    return data
