"""Worlds of Newton models. Requires the package newton, whose models they are: `pip install newton`.

Visible shapes are shown, with their colours, without textures; of height fields the upper surface. Particles, soft bodies and Gaussians are not.
"""

from __future__ import annotations

import importlib
import warnings
from collections.abc import Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _shapes
from ._cameras import Camera
from ._findings import Error, FindingWarning
from ._scenes import Mesh, Scene
from ._worlds import Worlds as _Worlds

__all__ = ["Worlds"]

# A plane of Newton without limits is drawn so large, in metres from its centre.
_PLANE_M = 20.0
Float64 = npt.NDArray[np.float64]


class Worlds:
    """The worlds of a Newton model, whose shapes are the same in all worlds, and whose bodies move.

    model: the newton.Model, of one world or of several that were replicated.

    worlds: the `oaktwin.Worlds`, for parts that are moved otherwise.
    shapes: (N, P) the numbers of the shapes that move, for each world, in the order in which they are shown.

    Warns with oaktwin.FindingWarning about shapes that are not shown. Raises oaktwin.Error for a model without visible shapes, and
    for worlds with different shapes.
    """

    def __init__(self, model: Any) -> None:
        numbers = _by_world(model)
        self._body = _host(model.shape_body).astype(np.int64)
        self._local = _matrices(_host(model.shape_transform))
        meshes, kinds = {}, set()
        for shape in numbers[0]:
            mesh = _mesh(model, int(shape))
            if isinstance(mesh, Mesh):
                meshes[f"shape_{shape}"] = mesh
            else:
                kinds.add(mesh)
        if kinds:
            text = f"model: shapes of the types {', '.join(sorted(kinds))} are not shown; only geometric shapes, meshes and height fields are"
            warnings.warn(text, FindingWarning, stacklevel=2)
        if not meshes:
            raise Error("model: it has no visible shapes; set their flag VISIBLE")
        shown = [place for place, shape in enumerate(numbers[0]) if f"shape_{shape}" in meshes]
        numbers = numbers[:, shown]
        moves = np.asarray((self._body[numbers] >= 0).any(axis=0))
        self.shapes = numbers[:, moves]
        self._names = [name for name, is_moving in zip(meshes, moves.tolist(), strict=True) if is_moving]
        self._bodies = int(model.body_count)
        poses = self._poses(_host(model.body_q), numbers)
        self.worlds = _Worlds(Scene.from_meshes(meshes, poses=dict(zip(meshes, poses[0], strict=True))), len(numbers))
        self.worlds.set_poses(list(meshes), poses)

    def __len__(self) -> int:
        return len(self.worlds)

    def update(self, state: Any, *, worlds: Sequence[int] | npt.NDArray[Any] | None = None) -> None:
        """Moves the bodies of worlds.

        state: the newton.State, or its `body_q`, (bodies, 7) of all worlds: positions and quaternions (x, y, z, w).
        worlds: the numbers of the worlds that are moved, or a mask; by default all.

        Raises oaktwin.Error for another number of bodies, and numbers that are not finite.
        """
        body_q = _host(getattr(state, "body_q", state))
        if body_q.shape != (self._bodies, 7):
            raise Error(f"state: body_q has shape {body_q.shape}; pass ({self._bodies}, 7), with the bodies of all worlds")
        if not np.isfinite(body_q).all():
            raise Error("state: body_q has values that are not finite; reset these worlds")
        shapes = self.shapes
        if worlds is not None:
            chosen = np.asarray(worlds)
            shapes = shapes[chosen]
            worlds = np.flatnonzero(chosen) if chosen.dtype == np.bool_ else chosen
        if self._names:
            self.worlds.set_poses(self._names, self._poses(body_q, shapes), worlds=worlds)

    def _poses(self, body_q: npt.NDArray[Any], shapes: npt.NDArray[np.int64]) -> Float64:
        """(N, P, 4, 4) world_from_shape of shapes (N, P)."""
        # Shapes of the body -1 are fixed to the world.
        bodies = np.concatenate([_matrices(body_q.reshape(-1, 7)), np.eye(4)[None]])
        return bodies[self._body[shapes]] @ self._local[shapes]

    def render(self, camera: Camera, world_from_camera: npt.ArrayLike, **options: Any) -> npt.NDArray[np.float32]:
        """Renders the depth of a camera in each world: `oaktwin.Worlds.render`."""
        return self.worlds.render(camera, world_from_camera, **options)


def _by_world(model: Any) -> npt.NDArray[np.int64]:
    """(N, P) the numbers of the visible shapes of each world, those that all worlds share last."""
    newton: Any = importlib.import_module("newton")
    world, flags = _host(model.shape_world), _host(model.shape_flags)
    visible = flags & int(newton.ShapeFlags.VISIBLE) > 0
    shared = np.flatnonzero(visible & (world < 0))
    count = max(int(model.world_count), 1)
    own = [np.flatnonzero(visible & (world == number)) for number in range(count)]
    kinds, scales = _host(model.shape_type), _host(model.shape_scale)
    for number, shapes in enumerate(own[1:], 1):
        same = len(shapes) == len(own[0]) and np.array_equal(kinds[shapes], kinds[own[0]]) and np.array_equal(scales[shapes], scales[own[0]])
        if not same or any(model.shape_source[a] is not model.shape_source[b] for a, b in zip(shapes, own[0], strict=True)):
            raise Error(f"model: world {number} has other shapes than world 0; make a model of each kind of world")
    return np.array([np.concatenate([shapes, shared]) for shapes in own], np.int64).reshape(count, -1)


def _mesh(model: Any, shape: int) -> Mesh | str:
    """The mesh of a shape in its own frame, or the name of a type that has none."""
    newton: Any = importlib.import_module("newton")
    kind = newton.GeoType(int(_host(model.shape_type)[shape]))
    scale, source = _host(model.shape_scale)[shape].astype(np.float64), model.shape_source[shape]
    name = str(kind.name)
    found: tuple[Any, Any]
    if name == "PLANE":
        found = _shapes.plane(*(one / 2 if one > 0 else _PLANE_M for one in scale[:2]))
    elif name == "BOX":
        found = _shapes.box(scale)
    elif name == "SPHERE":
        found = _shapes.ellipsoid([scale[0]] * 3)
    elif name == "ELLIPSOID":
        found = _shapes.ellipsoid(scale)
    elif name in ("CAPSULE", "CYLINDER", "CONE") and (name != "CYLINDER" or scale[2] == 0):
        found = getattr(_shapes, name.lower())(scale[0], scale[1])
    elif name in ("MESH", "CONVEX_MESH"):
        found = np.asarray(source.vertices, np.float64).reshape(-1, 3) * scale, np.asarray(source.indices).reshape(-1, 3)
    elif name == "HFIELD":
        low, high = (one * scale[2] for one in (source.min_z, source.max_z))
        heights = low + np.asarray(source.data, np.float64) * (high - low)
        found = _shapes.height_field(heights, source.hx * scale[0], source.hy * scale[1], rising=False)
    else:
        return name
    colour = _host(model.shape_color)[shape] if model.shape_color is not None else (0.5, 0.5, 0.5)
    return Mesh(*found, color=[float(one) for one in colour])


def _matrices(transforms: npt.NDArray[Any]) -> Float64:
    """(N, 4, 4) of transforms (N, 7): positions and quaternions (x, y, z, w)."""
    numbers = np.asarray(transforms, np.float64).reshape(-1, 7)
    x, y, z, w = (numbers[:, 3:] / np.linalg.norm(numbers[:, 3:], axis=1, keepdims=True)).T
    matrices = np.zeros((len(numbers), 4, 4))
    rows = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
    ]
    for row, columns in enumerate(rows):
        for column, values in enumerate(columns):
            matrices[:, row, column] = values
    matrices[:, :3, 3] = numbers[:, :3]
    matrices[:, 3, 3] = 1
    return matrices


def _host(array: Any) -> npt.NDArray[Any]:
    """An array of Warp, or of NumPy, as one of NumPy."""
    return np.zeros((0, 7), np.float32) if array is None else np.asarray(array.numpy() if hasattr(array, "numpy") else array)
