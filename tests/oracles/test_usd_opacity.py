"""Surfaces that the opacity of their material cuts out, against the values of the images computed here."""

import os
import subprocess
from pathlib import Path

import cv2
import numpy as np
import pytest
from pxr import Gf, Sdf, UsdGeom, UsdShade
from usd_scenes import new_stage

CARD_M, WALL_M = 4.0, 10.0
SIZE = 96
WRAPS = {
    "repeat": lambda i, n: i % n,
    "mirror": lambda i, n: np.where(i % (2 * n) < n, i % (2 * n), 2 * n - 1 - i % (2 * n)),
    "clamp": lambda i, n: np.clip(i, 0, n - 1),
    "black": lambda i, n: np.where((i < 0) | (i >= n), -1, i),
}


def depth(program: Path, stage: Path, out: Path, camera: str = "/Cam") -> tuple[np.ndarray, str]:
    command = [program, "render", stage, "--camera", camera, "-o", out, "--resolution", f"{SIZE}x{SIZE}"]
    command += ["--annotators", "distance_to_image_plane"]
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    (file,) = out.rglob("*distance_to_image_plane*.npy")
    return np.load(file), done.stderr


def sampled(pixels: np.ndarray, u: np.ndarray, v: np.ndarray, wrap_s: str, wrap_t: str) -> np.ndarray:
    """Bilinear interpolation between the centres of pixels; the first row is at the top."""
    height, width = pixels.shape
    x, y = u * width - 0.5, (1 - v) * height - 0.5
    left, top = np.floor(x).astype(int), np.floor(y).astype(int)
    total = np.zeros(u.shape)
    for right, below in ((0, 0), (1, 0), (0, 1), (1, 1)):
        column, row = WRAPS[wrap_s](left + right, width), WRAPS[wrap_t](top + below, height)
        value = np.where((column < 0) | (row < 0), 0, pixels[row, column])
        total += value * abs(1 - right - (x - left)) * abs(1 - below - (y - top))
    return total


def card(path: Path, rng: np.random.Generator, channel: str, wrap: tuple[str, str], placed: dict, threshold: float):
    pixels = rng.integers(0, 256, (7, 5, 4), dtype=np.uint8)
    assert cv2.imwrite(str(path.parent / "mask.png"), pixels[..., [2, 1, 0, 3]])
    stage = new_stage(path, unit=1.0)
    for name, half, z in (("Card", 1.5, -CARD_M), ("Wall", 50.0, -WALL_M)):
        mesh = UsdGeom.Mesh.Define(stage, f"/{name}")
        mesh.CreateFaceVertexCountsAttr([4])
        mesh.CreateFaceVertexIndicesAttr([0, 1, 2, 3])
        mesh.CreatePointsAttr([(-half, -half, z), (half, -half, z), (half, half, z), (-half, half, z)])
        mesh.CreateSubdivisionSchemeAttr("none")
    mesh = UsdGeom.Mesh.Get(stage, "/Card")
    coordinates = UsdGeom.PrimvarsAPI(mesh).CreatePrimvar("st", Sdf.ValueTypeNames.TexCoord2fArray, "vertex")
    coordinates.Set([(0, 0), (1, 0), (1, 1), (0, 1)])
    material = UsdShade.Material.Define(stage, "/Look")
    shaders = {name: UsdShade.Shader.Define(stage, f"/Look/{name}") for name in "STRX"}
    for name, kind in zip("STRX", ("PreviewSurface", "UVTexture", "PrimvarReader_float2", "Transform2d")):
        shaders[name].CreateIdAttr("Usd" + kind)
    types = Sdf.ValueTypeNames
    shaders["R"].CreateInput("varname", types.String).Set("st")
    transform = shaders["X"]
    transform.CreateInput("in", types.Float2).ConnectToSource(shaders["R"].CreateOutput("result", types.Float2))
    transform.CreateInput("scale", types.Float2).Set(placed["scale"])
    transform.CreateInput("rotation", types.Float).Set(placed["rotation"])
    transform.CreateInput("translation", types.Float2).Set(placed["translation"])
    texture = shaders["T"]
    texture.CreateInput("file", types.Asset).Set("mask.png")
    texture.CreateInput("sourceColorSpace", types.Token).Set("raw")
    texture.CreateInput("wrapS", types.Token).Set(wrap[0])
    texture.CreateInput("wrapT", types.Token).Set(wrap[1])
    texture.CreateInput("scale", types.Float4).Set(Gf.Vec4f(1.5, 1.25, 0.75, 1.125))
    texture.CreateInput("bias", types.Float4).Set(Gf.Vec4f(-0.25, 0, 0.125, -0.0625))
    texture.CreateInput("st", types.Float2).ConnectToSource(transform.CreateOutput("result", types.Float2))
    surface = shaders["S"]
    surface.CreateInput("opacity", types.Float).ConnectToSource(texture.CreateOutput(channel, types.Float))
    surface.CreateInput("opacityThreshold", types.Float).Set(threshold)
    material.CreateSurfaceOutput().ConnectToSource(surface.CreateOutput("surface", types.Token))
    UsdShade.MaterialBindingAPI.Apply(mesh.GetPrim()).Bind(material)
    camera = UsdGeom.Camera.Define(stage, "/Cam")
    camera.CreateFocalLengthAttr(20.0)
    camera.CreateHorizontalApertureAttr(20.0)
    camera.CreateVerticalApertureAttr(20.0)
    stage.Save()
    return pixels


def compare(program: Path, folder: Path, seed: int) -> tuple[int, int]:
    """Returns the numbers of visible and of invisible pixels of a card."""
    folder.mkdir()
    rng = np.random.default_rng(seed)
    wrap = tuple(rng.choice(list(WRAPS), 2))
    at = int(rng.integers(4))
    threshold = float(rng.choice([0.0, 0.25, 0.5, 0.75]))
    placed = {
        "scale": tuple(rng.uniform(0.5, 3, 2).tolist()),
        "rotation": float(rng.uniform(-180, 180)),
        "translation": tuple(rng.uniform(-1, 1, 2).tolist()),
    }
    pixels = card(folder / "stage.usda", rng, "rgba"[at], wrap, placed, threshold)
    seen, _ = depth(program, folder / "stage.usda", folder / "out")
    height, width = seen.shape
    # The horizontal field of view is 53 degrees: 20 mm by 20 mm.
    x = (np.arange(width) + 0.5) / width - 0.5
    y = (0.5 - (np.arange(height) + 0.5) / height) * height / width
    x, y = np.meshgrid(x * CARD_M, y * CARD_M)
    u, v = x / 3 + 0.5, y / 3 + 0.5
    angle = np.radians(placed["rotation"])
    s, t = u * placed["scale"][0], v * placed["scale"][1]
    s, t = np.cos(angle) * s - np.sin(angle) * t, np.sin(angle) * s + np.cos(angle) * t
    s, t = s + placed["translation"][0], t + placed["translation"][1]
    value = sampled(pixels[..., at] / 255.0, s, t, *wrap)
    opacity = value * (1.5, 1.25, 0.75, 1.125)[at] + (-0.25, 0, 0.125, -0.0625)[at]
    on_card = (abs(x) < 1.5) & (abs(y) < 1.5)
    shown = on_card & (opacity > 0) & (opacity >= threshold)
    expected = np.where(shown, CARD_M, WALL_M)
    # Single precision decides near the threshold; the outside of an image is exactly 0.
    decided = (abs(opacity - threshold) > 1e-3) | (value == 0)
    edge = (abs(abs(x) - 1.5) < 1e-3) | (abs(abs(y) - 1.5) < 1e-3)
    compared = (decided | ~on_card) & ~edge
    assert compared.mean() > 0.9
    np.testing.assert_allclose(seen[compared], expected[compared], rtol=1e-6)
    return shown.sum(), (on_card & ~shown).sum()


def test_masks_cut_what_their_image_says(program, tmp_path):
    counts = np.sum([compare(program, tmp_path / str(seed), seed) for seed in range(16)], axis=0)
    assert (counts > 0.2 * counts.sum()).all(), counts


def test_a_leaf_and_a_hidden_object(program, tmp_path):
    data = os.environ.get("OAKTWIN_TEST_DATA")
    if not data:
        pytest.skip("OAKTWIN_TEST_DATA is not set")
    stage = Path(data, "data/cases/opacity/mask.usda")
    seen, log = depth(program, stage, tmp_path / "out")
    assert "warning" not in log
    height, width = seen.shape
    middle = seen[height // 2]
    # The card is a square of 2 m at 5 m, and the wall is 7 m away.
    left, right = middle[int(width * 0.42)], middle[int(width * 0.58)]
    assert {float(left), float(right)} == {5.0, 7.0} and left == 7.0
    # The hidden cube of 1 m stands 1.5 m to the right, 3.5 m away.
    assert middle[int(width * (0.5 + 1.5 / 3.5))] == 7.0
