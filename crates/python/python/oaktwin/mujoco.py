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
    camera_poses: (count, ncam, 4, 4) world_from_camera of the model's cameras, whose axes are OpenCV's, as `update` left them.
    """

    def __init__(self, model: Any, count: int) -> None:
        self._model, self._data = model, _initial(model)
        shown, geoms = drawn(model, self._data)
        # The world is body 0, and what is welded to it does not move.
        self.geoms = [index for index in geoms if model.body_weldid[model.geom_bodyid[index]] != 0]
        self._names = [f"geom_{index}" for index in self.geoms]
        self.worlds = _Worlds(shown, count)
        self.camera_poses = np.repeat(_views(self._data.cam_xpos, self._data.cam_xmat)[None], count, axis=0)

    def __len__(self) -> int:
        return len(self.worlds)

    def update(
        self,
        qpos: npt.ArrayLike | None = None,
        *,
        geom_xpos: npt.ArrayLike | None = None,
        geom_xmat: npt.ArrayLike | None = None,
        cam_xpos: npt.ArrayLike | None = None,
        cam_xmat: npt.ArrayLike | None = None,
        worlds: Sequence[int] | npt.NDArray[Any] | None = None,
    ) -> None:
        """Moves the bodies of worlds.

        qpos: (N, nq), the positions of the joints in N worlds, from which MuJoCo computes where the geoms and cameras are. Or
        geom_xpos, geom_xmat: (N, ngeom, 3) and (N, ngeom, 9) or (N, ngeom, 3, 3), where they are: from mujoco_warp's data, or stacked from several
            mujoco.MjData. That is faster than qpos.
        cam_xpos, cam_xmat: (N, ncam, 3) and (N, ncam, 9) or (N, ncam, 3, 3), where the cameras are then, if they move.
        worlds: the numbers of the N worlds, or a mask; by default all.

        Raises oaktwin.Error for other shapes, and numbers that are not finite.
        """
        if qpos is not None and geom_xpos is None and geom_xmat is None:
            geom_xpos, geom_xmat, cam_xpos, cam_xmat = self._kinematics(np.asarray(qpos, np.float64))
        elif qpos is not None or geom_xpos is None or geom_xmat is None:
            raise Error("qpos: pass either qpos, or geom_xpos and geom_xmat")
        positions, rotations = np.asarray(geom_xpos, np.float64), np.asarray(geom_xmat, np.float64)
        _check("geom", positions, rotations, self._model.ngeom)
        if (cam_xpos is None) != (cam_xmat is None):
            raise Error("cam_xpos: pass cam_xpos and cam_xmat, or neither")
        if self.geoms:
            poses = pose_of(positions[:, self.geoms], rotations[:, self.geoms])
            self.worlds.set_poses(self._names, poses, worlds=worlds)
        if cam_xpos is not None:
            places, turns = np.asarray(cam_xpos, np.float64), np.asarray(cam_xmat, np.float64)
            _check("cam", places, turns, self._model.ncam)
            self.camera_poses[slice(None) if worlds is None else np.asarray(worlds)] = _views(places, turns)

    def camera(self, name: str, size: tuple[int, int] | None = None) -> Camera:
        """Returns a camera of the model.

        name: its name.
        size: the (width, height) of its images; by default the model's own resolution.

        Raises oaktwin.Error for an unknown camera, and without a size for one whose resolution the model does not state.
        """
        number, model = self._camera(name), self._model
        width, height = (int(one) for one in (model.cam_resolution[number] if size is None else size))
        if size is None and (width, height) == (1, 1):
            raise Error(f"camera: the model states no resolution of {name}; pass size=(width, height)")
        fov = np.radians(model.cam_fovy[number])
        focal = 0.5 * height / np.tan(0.5 * fov)
        centre = np.array([width, height]) / 2
        fx = fy = focal
        if model.cam_sensorsize[number].any():
            # The sensor is cropped to the images' aspect.
            pixels_per_m = float(max(np.array([width, height]) / model.cam_sensorsize[number]))
            (fx, fy), offset = model.cam_intrinsic[number].reshape(2, 2) * pixels_per_m
            centre = centre - offset
        # A principal point has the centre of the first pixel at 0.
        return Camera((width, height), K=[[fx, 0, centre[0] - 0.5], [0, fy, centre[1] - 0.5], [0, 0, 1]])

    def _camera(self, name: str) -> int:
        names = [self._model.camera(number).name for number in range(self._model.ncam)]
        if name not in names:
            raise Error(f"camera: the model has no camera '{name}'; it has {', '.join(names) or 'none'}")
        return names.index(name)

    def _kinematics(self, qpos: npt.NDArray[np.float64]) -> tuple[npt.NDArray[np.float64], ...]:
        mujoco: Any = importlib.import_module("mujoco")
        model, data = self._model, self._data
        if qpos.ndim != 2 or qpos.shape[1] != model.nq:
            raise Error(f"qpos: has shape {qpos.shape}; pass (N, {model.nq})")
        if not np.isfinite(qpos).all():
            raise Error("qpos: has values that are not finite; reset these worlds")
        arrays = tuple(np.empty((len(qpos), count, part)) for count in (model.ngeom, model.ncam) for part in (3, 9))
        for number, own in enumerate(qpos):
            data.qpos[:] = own
            mujoco.mj_kinematics(model, data)
            if model.ncam:
                mujoco.mj_comPos(model, data)
                mujoco.mj_camlight(model, data)
            for array, values in zip(arrays, (data.geom_xpos, data.geom_xmat, data.cam_xpos, data.cam_xmat), strict=True):
                array[number] = values
        return arrays

    def render(
        self,
        camera: Camera | str,
        world_from_camera: npt.ArrayLike | None = None,
        *,
        size: tuple[int, int] | None = None,
        worlds: Sequence[int] | npt.NDArray[Any] | None = None,
        **options: Any,
    ) -> npt.NDArray[np.float32]:
        """Renders the depth of a camera in each world.

        camera: a camera, or the name of one of the model.
        world_from_camera: (N, 4, 4) or (4, 4), where it is, with OpenCV's axes; by default where the model's camera is.
        size: the (width, height) of the images of a model's camera; by default its own resolution.
        worlds, options: as of `oaktwin.Worlds.render`, which says what is returned.
        """
        if isinstance(camera, str):
            if world_from_camera is None:
                poses = self.camera_poses[:, self._camera(camera)]
                world_from_camera = poses if worlds is None else poses[np.asarray(worlds)]
            camera = self.camera(camera, size)
        elif world_from_camera is None:
            raise Error("world_from_camera: pass the poses of the camera, or the name of a camera of the model")
        return self.worlds.render(camera, world_from_camera, worlds=worlds, **options)


def _views(positions: npt.NDArray[np.float64], rotations: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    """The poses of cameras. MuJoCo's look along -z, with y up."""
    poses = pose_of(positions, rotations)
    poses[..., :3, 1:3] *= -1
    return poses


def _check(kind: str, positions: npt.NDArray[np.float64], rotations: npt.NDArray[np.float64], count: int) -> None:
    for name, array in ((f"{kind}_xpos", positions), (f"{kind}_xmat", rotations)):
        if array.ndim < 3 or array.shape[1] != count:
            raise Error(f"{name}: has shape {array.shape}; pass (N, {count}, …), with all of the model")


def _initial(model: Any) -> Any:
    mujoco: Any = importlib.import_module("mujoco")
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    return data
