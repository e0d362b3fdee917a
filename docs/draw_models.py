"""Draws docs/images/models.png: the five assets as `oaktwin asset sheet` writes them.

    oaktwin asset sheet -o ASSETS && python docs/draw_models.py ASSETS docs/images/models.png

Needs usd-core, numpy and opencv-python-headless: the environment that `cargo xtask test` makes has them.
A small software rasterizer with a made-up studio around it; nothing of it is part of the program.
"""

import sys
from dataclasses import dataclass
from pathlib import Path

import cv2
import numpy as np
from pxr import Usd, UsdGeom, UsdShade

NAMES = ["oak_d_pro_poe", "oak_d_pro_w_poe", "oak4_d", "oak4_d_wide", "oak_d_tof"]
TITLES = ["OAK-D Pro PoE", "OAK-D Pro W PoE", "OAK4-D", "OAK4-D Wide", "OAK-D ToF"]
WIDTH, HEIGHT, SAMPLES = 430, 320, 3
FIELD_OF_VIEW, DISTANCE = np.radians(20.0), 0.42
AZIMUTH, ELEVATION = np.radians(32.0), np.radians(18.0)


@dataclass
class Surface:
    """Triangles of one material: points and normals (n, 3, 3), and the shader's inputs."""

    points: np.ndarray
    normals: np.ndarray
    diffuse: np.ndarray
    metallic: float
    roughness: float
    clearcoat: float


def surfaces(path: Path) -> list[Surface]:
    stage = Usd.Stage.Open(str(path))
    found = []
    for prim in stage.Traverse():
        mesh = UsdGeom.Mesh(prim)
        if not mesh or UsdGeom.Imageable(prim).ComputePurpose() != UsdGeom.Tokens.default_:
            continue
        points = np.array(mesh.GetPointsAttr().Get())
        normals = np.array(mesh.GetNormalsAttr().Get())
        corners, at, first = np.array(mesh.GetFaceVertexIndicesAttr().Get()), [], 0
        for count in mesh.GetFaceVertexCountsAttr().Get():
            at += [(first, first + k, first + k + 1) for k in range(1, count - 1)]
            first += count
        at = np.array(at)
        shader = UsdShade.MaterialBindingAPI(prim).ComputeBoundMaterial()[0].ComputeSurfaceSource()[0]
        value = {name: shader.GetInput(name).Get() for name in ("diffuseColor", "metallic", "roughness", "clearcoat")}
        found.append(
            Surface(points[corners[at]], normals[at], np.array(value["diffuseColor"]), value["metallic"], value["roughness"], value["clearcoat"])
        )
    return found


def studio(direction: np.ndarray) -> np.ndarray:
    """Light from a direction: a bright ceiling, two strips at the sides, a dim floor."""
    x, y, z = np.moveaxis(direction, -1, 0)
    light = 0.25 + 0.25 * z
    light += 2.2 * np.clip((z - 0.55) / 0.25, 0, 1) * np.clip((0.9 - np.abs(x - 0.2)) / 0.3, 0, 1)
    light += 1.2 * np.clip((np.abs(y) - 0.75) / 0.1, 0, 1) * np.clip((z + 0.3) / 0.2, 0, 1)
    return np.maximum(light, 0.05)


def shade(surface: Surface, normal: np.ndarray, view: np.ndarray) -> np.ndarray:
    facing = np.clip(-(normal * view).sum(-1), 0, 1)
    mirrored = view - 2 * (view * normal).sum(-1, keepdims=True) * normal
    blur = min(surface.roughness * 2.2, 1.0)
    reflected = studio(mirrored) * (1 - blur) + (0.55 + 0.5 * mirrored[:, 2] + 0.1 * mirrored[:, 0]) * blur
    direct = 0.6 + 0.4 * normal[:, 2] + 0.25 * np.clip(normal @ np.array([0.6, 0.35, 0.7]), 0, 1)
    base = 0.04 * (1 - surface.metallic) + surface.diffuse * surface.metallic
    grazing = (1 - facing)[:, None] ** 5
    colour = surface.diffuse * (1 - surface.metallic) * direct[:, None]
    colour = colour + (base + (1 - base) * grazing * (1 - surface.roughness)) * reflected[:, None]
    return colour + surface.clearcoat * (0.04 + 0.96 * grazing) * studio(mirrored)[:, None]


def draw(found: list[Surface]) -> np.ndarray:
    """One model, linear RGB in 0 to 1."""
    width, height = WIDTH * SAMPLES, HEIGHT * SAMPLES
    corners = np.concatenate([s.points.reshape(-1, 3) for s in found])
    centre = (corners.min(0) + corners.max(0)) / 2
    towards = np.array([np.cos(ELEVATION) * np.cos(AZIMUTH), np.cos(ELEVATION) * np.sin(AZIMUTH), np.sin(ELEVATION)])
    right = np.cross(-towards, [0, 0, 1])
    right /= np.linalg.norm(right)
    axes = np.stack([right, np.cross(right, -towards), -towards])
    focal = height / 2 / np.tan(FIELD_OF_VIEW / 2)
    depth = np.full((height, width), np.inf)
    normal = np.zeros((height, width, 3))
    owner = np.full((height, width), -1)
    for number, surface in enumerate(found):
        seen = (surface.points - centre - DISTANCE * towards) @ axes.T
        xs, ys = width / 2 + focal * seen[..., 0] / seen[..., 2], height / 2 - focal * seen[..., 1] / seen[..., 2]
        for x, y, inverse, n in zip(xs, ys, 1 / seen[..., 2], surface.normals):
            left, right_, top, bottom = int(max(x.min(), 0)), int(x.max()) + 2, int(max(y.min(), 0)), int(y.max()) + 2
            u, v = np.meshgrid(np.arange(left, min(right_, width)) + 0.5, np.arange(top, min(bottom, height)) + 0.5)
            area = (y[1] - y[2]) * (x[0] - x[2]) + (x[2] - x[1]) * (y[0] - y[2])
            if u.size == 0 or abs(area) < 1e-9:
                continue
            a = ((y[1] - y[2]) * (u - x[2]) + (x[2] - x[1]) * (v - y[2])) / area
            b = ((y[2] - y[0]) * (u - x[2]) + (x[0] - x[2]) * (v - y[2])) / area
            weights = np.stack([a, b, 1 - a - b], -1) * inverse
            z = 1 / weights.sum(-1)
            window = (slice(top, top + u.shape[0]), slice(left, left + u.shape[1]))
            hit = (a >= 0) & (b >= 0) & (a + b <= 1) & (z < depth[window])
            depth[window][hit], owner[window][hit], normal[window][hit] = z[hit], number, (weights @ n)[hit]
    normal /= np.maximum(np.linalg.norm(normal, axis=-1, keepdims=True), 1e-9)
    v, u = np.mgrid[0:height, 0:width] + 0.5
    view = (np.stack([(u - width / 2) / focal, (height / 2 - v) / focal, np.ones_like(u)], -1)) @ axes
    view /= np.linalg.norm(view, axis=-1, keepdims=True)
    picture = np.ones((height, width, 3))
    for number, surface in enumerate(found):
        mine = owner == number
        picture[mine] = np.clip(shade(surface, normal[mine], view[mine]) * occlusion(depth)[mine][:, None] * 1.25, 0, 1) ** (1 / 2.2)
    return picture.reshape(HEIGHT, SAMPLES, WIDTH, SAMPLES, 3).mean((1, 3))


def occlusion(depth: np.ndarray) -> np.ndarray:
    """How open the sky is, from depth alone: what is nearer beside a pixel darkens it."""
    flat, open_sky = np.where(np.isinf(depth), 1e3, depth), np.ones(depth.shape)
    for radius in (6, 14, 30, 60):
        for k in range(8):
            shift = (int(radius * np.sin(k * np.pi / 4)), int(radius * np.cos(k * np.pi / 4)))
            nearer = flat - np.roll(flat, shift, (0, 1))
            open_sky -= 0.02 * ((nearer > 0.0003) & (nearer < 0.02))
    return np.clip(open_sky, 0.25, 1)


def main() -> None:
    assets, output = Path(sys.argv[1]), sys.argv[2]
    panels = []
    for name, title in zip(NAMES, TITLES):
        panel = np.ascontiguousarray((draw(surfaces(assets / f"{name}.usd")) * 255).astype(np.uint8)[..., ::-1])
        (text_width, _), _ = cv2.getTextSize(title, cv2.FONT_HERSHEY_SIMPLEX, 0.6, 1)
        cv2.putText(panel, title, ((WIDTH - text_width) // 2, HEIGHT - 14), cv2.FONT_HERSHEY_SIMPLEX, 0.6, (60, 60, 60), 1, cv2.LINE_AA)
        panels.append(panel)
    blank = np.full((HEIGHT, WIDTH // 2, 3), 255, np.uint8)
    rows = [np.hstack(panels[:3]), np.hstack([blank, *panels[3:], np.full((HEIGHT, WIDTH - WIDTH // 2, 3), 255, np.uint8)])]
    cv2.imwrite(output, np.vstack(rows))


if __name__ == "__main__":
    main()
