"""A MuJoCo model as the world of a virtual device."""

from __future__ import annotations

import importlib
from collections.abc import Callable
from typing import Any

import numpy as np
import numpy.typing as npt

from .._findings import Error
from .._scenes import Mesh, Scene
from ._library import warn_once
from ._world import World

Float64 = npt.NDArray[np.float64]
# A plane of MuJoCo without limits is drawn so large, in metres from its centre.
_PLANE_M = 20.0
_SEGMENTS = 32


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
    meshes = {f"geom_{index}": mesh for index in range(model.ngeom) if (mesh := _mesh(model, index)) is not None}
    if not meshes:
        raise Error("model: it has no geoms of the groups 0 to 2 that can be shown")

    def poses() -> dict[str, Float64]:
        return {name: _pose(data.geom_xpos[int(name[5:])], data.geom_xmat[int(name[5:])]) for name in meshes}

    scene = Scene.from_meshes(meshes, poses=poses())

    def update(seconds: float) -> None:
        if step is not None:
            step(seconds)
        scene.set_poses(poses())

    return World(scene, pose=lambda _: _pose(data.xpos[number], data.xmat[number]), update=update)


def _pose(position: Float64, rotation: Float64) -> Float64:
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = np.asarray(rotation).reshape(3, 3), position
    return matrix


def _mesh(model: Any, index: int) -> Mesh | None:
    """The mesh of a geom in its own frame, or None for one that is hidden."""
    mujoco: Any = importlib.import_module("mujoco")
    kind, size = int(model.geom_type[index]), model.geom_size[index]
    rgba = model.mat_rgba[model.geom_matid[index]] if model.geom_matid[index] >= 0 else model.geom_rgba[index]
    if model.geom_group[index] > 2 or rgba[3] == 0:
        return None
    kinds = mujoco.mjtGeom
    if kind == kinds.mjGEOM_PLANE:
        x, y = (one if one > 0 else _PLANE_M for one in size[:2])
        shape = np.array([(-x, -y, 0), (x, -y, 0), (x, y, 0), (-x, y, 0)]), np.array([(0, 1, 2), (0, 2, 3)])
    elif kind == kinds.mjGEOM_BOX:
        shape = _box(size)
    elif kind == kinds.mjGEOM_MESH:
        shape = _stored(model, int(model.geom_dataid[index]))
    elif kind in (kinds.mjGEOM_SPHERE, kinds.mjGEOM_ELLIPSOID, kinds.mjGEOM_CYLINDER, kinds.mjGEOM_CAPSULE):
        shape = _turned(_outline(kind, size, kinds), size if kind == kinds.mjGEOM_ELLIPSOID else None)
    else:
        warn_once(f"from_mujoco: geoms of the type {kinds(kind).name} are not shown")
        return None
    return Mesh(*shape, color=[float(one) for one in rgba[:3]])


def _box(half: Float64) -> tuple[Any, Any]:
    corners = np.array([(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]) * half
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return corners, np.array([face for a, b, c, d in quads for face in ((a, b, c), (a, c, d))])


def _stored(model: Any, number: int) -> tuple[Any, Any]:
    vertices = model.mesh_vert[model.mesh_vertadr[number] :][: model.mesh_vertnum[number]]
    faces = model.mesh_face[model.mesh_faceadr[number] :][: model.mesh_facenum[number]]
    return np.array(vertices), np.array(faces)


def _outline(kind: int, size: Float64, kinds: Any) -> Float64:
    """The outline (N, 2) of a shape that turns about z: radii and heights, from the bottom to the top."""
    angles = np.linspace(-np.pi / 2, np.pi / 2, _SEGMENTS // 2 + 1)
    if kind == kinds.mjGEOM_CYLINDER:
        return np.array([(0, -size[1]), (size[0], -size[1]), (size[0], size[1]), (0, size[1])])
    radius = 1.0 if kind == kinds.mjGEOM_ELLIPSOID else size[0]
    outline = radius * np.stack([np.cos(angles), np.sin(angles)], 1)
    if kind == kinds.mjGEOM_CAPSULE:
        middle = len(outline) // 2
        lower, upper = outline[: middle + 1] - (0, size[1]), outline[middle:] + (0, size[1])
        outline = np.concatenate([lower, upper])
    return outline


def _turned(outline: Float64, scale: Float64 | None) -> tuple[Any, Any]:
    turns = np.arange(_SEGMENTS) * 2 * np.pi / _SEGMENTS
    radii, heights = outline[:, :1], outline[:, 1:]
    rings = np.stack([radii * np.cos(turns), radii * np.sin(turns), np.broadcast_to(heights, (len(outline), _SEGMENTS))], -1)
    vertices = rings.reshape(-1, 3) * (1.0 if scale is None else scale)
    faces = []
    for ring in range(len(outline) - 1):
        for one in range(_SEGMENTS):
            a, b = ring * _SEGMENTS + one, ring * _SEGMENTS + (one + 1) % _SEGMENTS
            faces += [(a, b, b + _SEGMENTS), (a, b + _SEGMENTS, a + _SEGMENTS)]
    return vertices, np.array(faces)
