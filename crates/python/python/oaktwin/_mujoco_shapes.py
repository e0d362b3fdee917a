"""The shapes of MuJoCo's geoms as meshes."""

from __future__ import annotations

import importlib
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _shapes
from ._scenes import Mesh

Float64 = npt.NDArray[np.float64]
# A plane of MuJoCo without limits is drawn so large, in metres from its centre.
_PLANE_M = 20.0


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
    data = int(model.geom_dataid[index])
    known = {
        kinds.mjGEOM_PLANE: lambda: _shapes.plane(*(one if one > 0 else _PLANE_M for one in size[:2])),
        kinds.mjGEOM_BOX: lambda: _shapes.box(size),
        kinds.mjGEOM_MESH: lambda: _stored(model, data),
        kinds.mjGEOM_HFIELD: lambda: _field(model, data),
        kinds.mjGEOM_SPHERE: lambda: _shapes.ellipsoid([size[0]] * 3),
        kinds.mjGEOM_ELLIPSOID: lambda: _shapes.ellipsoid(size),
        kinds.mjGEOM_CYLINDER: lambda: _shapes.cylinder(size[0], size[1]),
        kinds.mjGEOM_CAPSULE: lambda: _shapes.capsule(size[0], size[1]),
    }
    make = known.get(kinds(kind))
    return str(kinds(kind).name) if make is None else make()


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
    half_x, half_y, height, _ = model.hfield_size[number]
    heights = np.array(model.hfield_data[first : first + rows * columns], np.float64).reshape(rows, columns) * height
    return _shapes.height_field(heights, half_x, half_y, rising=True)


def _stored(model: Any, number: int) -> tuple[Any, Any]:
    vertices = model.mesh_vert[model.mesh_vertadr[number] :][: model.mesh_vertnum[number]]
    faces = model.mesh_face[model.mesh_faceadr[number] :][: model.mesh_facenum[number]]
    return np.array(vertices), np.array(faces)
