"""The shapes of MuJoCo's geoms as meshes."""

from __future__ import annotations

import importlib
from typing import Any

import numpy as np
import numpy.typing as npt

from ._scenes import Mesh

Float64 = npt.NDArray[np.float64]
# A plane of MuJoCo without limits is drawn so large, in metres from its centre.
_PLANE_M = 20.0
_SEGMENTS = 32


def mesh_of(model: Any, index: int) -> Mesh | str | None:
    """The mesh of a geom in its own frame, None for one that is hidden, or the name of a type that has no mesh."""
    rgba = model.mat_rgba[model.geom_matid[index]] if model.geom_matid[index] >= 0 else model.geom_rgba[index]
    if model.geom_group[index] > 2 or rgba[3] == 0:
        return None
    shape = shape_of(model, index)
    return shape if isinstance(shape, str) else Mesh(*shape, color=[float(one) for one in rgba[:3]])


def shape_of(model: Any, index: int) -> tuple[Any, Any] | str:
    """The vertices and faces of a geom in its own frame, or the name of a type that has none."""
    mujoco: Any = importlib.import_module("mujoco")
    kind, size, kinds = int(model.geom_type[index]), model.geom_size[index], mujoco.mjtGeom
    if kind == kinds.mjGEOM_PLANE:
        x, y = (one if one > 0 else _PLANE_M for one in size[:2])
        return np.array([(-x, -y, 0), (x, -y, 0), (x, y, 0), (-x, y, 0)]), np.array([(0, 1, 2), (0, 2, 3)])
    if kind == kinds.mjGEOM_BOX:
        return _box(size)
    if kind == kinds.mjGEOM_MESH:
        return _stored(model, int(model.geom_dataid[index]))
    if kind == kinds.mjGEOM_HFIELD:
        return _field(model, int(model.geom_dataid[index]))
    if kind in (kinds.mjGEOM_SPHERE, kinds.mjGEOM_ELLIPSOID, kinds.mjGEOM_CYLINDER, kinds.mjGEOM_CAPSULE):
        return _turned(_outline(kind, size, kinds), size if kind == kinds.mjGEOM_ELLIPSOID else None)
    return str(kinds(kind).name)


def pose_of(position: npt.ArrayLike, rotation: npt.ArrayLike) -> Float64:
    """(..., 4, 4) of positions (..., 3) and rotations of 9 numbers or (3, 3)."""
    positions = np.asarray(position, np.float64)
    matrix = np.zeros((*positions.shape[:-1], 4, 4))
    matrix[..., :3, :3] = np.asarray(rotation).reshape(*positions.shape[:-1], 3, 3)
    matrix[..., :3, 3] = positions
    matrix[..., 3, 3] = 1
    return matrix


def _field(model: Any, number: int) -> tuple[Any, Any]:
    """The upper surface of a height field."""
    rows, columns = int(model.hfield_nrow[number]), int(model.hfield_ncol[number])
    first = int(model.hfield_adr[number])
    width, depth, height, _ = model.hfield_size[number]
    heights = np.array(model.hfield_data[first : first + rows * columns]).reshape(rows, columns) * height
    x, y = np.meshgrid(np.linspace(-width, width, columns), np.linspace(-depth, depth, rows))
    corner = (np.arange(rows - 1)[:, None] * columns + np.arange(columns - 1)).ravel()
    # The diagonal is MuJoCo's.
    faces = np.concatenate([np.stack([corner, corner + columns + 1, corner + columns], 1), np.stack([corner, corner + 1, corner + columns + 1], 1)])
    return np.stack([x, y, heights], -1).reshape(-1, 3), faces


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
