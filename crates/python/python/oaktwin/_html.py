"""Objects as tables in notebooks."""

from __future__ import annotations

import html
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ._cameras import Camera
    from ._devices import Device


def table(head: Sequence[str], rows: Iterable[Sequence[object]], caption: str = "") -> str:
    """A table of values, which are escaped; numbers have four digits, and None is an empty cell."""

    def cell(value: object) -> str:
        shown = "" if value is None else f"{value:.4g}" if isinstance(value, float) else str(value)
        return f"<td>{html.escape(shown)}</td>"

    title = f"<caption>{html.escape(caption)}</caption>" if caption else ""
    names = "".join(f"<th>{html.escape(name)}</th>" for name in head)
    body = "".join("<tr>" + "".join(map(cell, row)) + "</tr>" for row in rows)
    return f"<table>{title}<thead><tr>{names}</tr></thead><tbody>{body}</tbody></table>"


_CAMERA = ("camera", "width", "height", "fx", "fy", "cx", "cy", "hfov_deg", "vfov_deg", "lens")


def _row(camera: Camera) -> tuple[object, ...]:
    (fx, _, cx), (_, fy, cy), _ = camera.K.tolist()
    return (camera.name, camera.width, camera.height, fx, fy, cx, cy, camera.hfov_deg, camera.vfov_deg, camera.lens)


def camera(camera: Camera) -> str:
    """A camera."""
    return table(_CAMERA, [_row(camera)])


def device(device: Device) -> str:
    """A device with its cameras."""
    depth = ", ".join(device.depth_sensors) or "none"
    return table(_CAMERA, map(_row, device.cameras.values()), f"{device.name} ({device.origin}), depth: {depth}")
