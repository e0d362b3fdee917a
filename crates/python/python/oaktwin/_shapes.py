"""The shapes of simulators as vertices (V, 3) and faces (F, 3), in their own frames, metres."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

Float64 = npt.NDArray[np.float64]
Shape = tuple[Any, Any]
_SEGMENTS = 32


def plane(half_x: float, half_y: float) -> Shape:
    """A rectangle at z = 0."""
    corners = [(-half_x, -half_y, 0), (half_x, -half_y, 0), (half_x, half_y, 0), (-half_x, half_y, 0)]
    return np.array(corners, np.float64), np.array([(0, 1, 2), (0, 2, 3)])


def box(half: npt.ArrayLike) -> Shape:
    """A box of these half lengths."""
    corners = np.array([(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]) * np.asarray(half)
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return corners, np.array([face for a, b, c, d in quads for face in ((a, b, c), (a, c, d))])


def ellipsoid(semi_axes: npt.ArrayLike) -> Shape:
    """An ellipsoid, or a sphere."""
    vertices, faces = _turned(_arc(1.0))
    return vertices * np.asarray(semi_axes), faces


def cylinder(radius: float, half_height: float) -> Shape:
    """A cylinder along z."""
    return _turned(np.array([(0, -half_height), (radius, -half_height), (radius, half_height), (0, half_height)]))


def cone(radius: float, half_height: float) -> Shape:
    """A cone along z, whose apex is above."""
    return _turned(np.array([(0, -half_height), (radius, -half_height), (0, half_height)]))


def capsule(radius: float, half_height: float) -> Shape:
    """A capsule along z; the half height is without its caps."""
    arc = _arc(radius)
    middle = len(arc) // 2
    return _turned(np.concatenate([arc[: middle + 1] - (0, half_height), arc[middle:] + (0, half_height)]))


def height_field(heights: Float64, half_x: float, half_y: float, *, rising: bool) -> Shape:
    """The surface of heights (rows along y, columns along x). rising: whether the diagonal of a cell goes from its least x and y to its largest."""
    rows, columns = heights.shape
    x, y = np.meshgrid(np.linspace(-half_x, half_x, columns), np.linspace(-half_y, half_y, rows))
    a = (np.arange(rows - 1)[:, None] * columns + np.arange(columns - 1)).ravel()
    b, c, d = a + 1, a + columns, a + columns + 1
    pairs = ((a, d, c), (a, b, d)) if rising else ((a, b, c), (b, d, c))
    faces = np.concatenate([np.stack(corners, 1) for corners in pairs])
    return np.stack([x, y, heights], -1).reshape(-1, 3), faces


def _arc(radius: float) -> Float64:
    """Half a circle (N, 2), from below to above: radii and heights."""
    angles = np.linspace(-np.pi / 2, np.pi / 2, _SEGMENTS // 2 + 1)
    return radius * np.stack([np.cos(angles), np.sin(angles)], 1)


def _turned(outline: Float64) -> Shape:
    """What an outline of radii and heights makes when it turns about z."""
    turns = np.arange(_SEGMENTS) * 2 * np.pi / _SEGMENTS
    radii, heights = outline[:, :1], outline[:, 1:]
    rings = np.stack([radii * np.cos(turns), radii * np.sin(turns), np.broadcast_to(heights, (len(outline), _SEGMENTS))], -1)
    faces = []
    for ring in range(len(outline) - 1):
        for one in range(_SEGMENTS):
            a, b = ring * _SEGMENTS + one, ring * _SEGMENTS + (one + 1) % _SEGMENTS
            faces += [(a, b, b + _SEGMENTS), (a, b + _SEGMENTS, a + _SEGMENTS)]
    return rings.reshape(-1, 3), np.array(faces)
