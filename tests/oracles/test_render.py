"""Depth, compared with Open3D's RaycastingScene (Embree): the chess set as OpenUSD extracts it, random meshes, pinholes
and a fisheye lens. Slow: its environment is large."""

import os
import subprocess
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest

from extract_triangles import extract
from open3d_import import open3d

pytestmark = pytest.mark.slow

CHESS_SET = Path(os.environ.get("OAKTWIN_TEST_DATA", "no-such-folder")) / "data/scenes/OpenChessSet/chess_set.usda"

# Tolerances: relative difference of depth; distance of an edge; fraction of pixels at an edge.
SAME, EDGE_PX, SILHOUETTES = 1e-5, 0.02, 2e-4

SIZE = (640, 400)


@dataclass
class Camera:
    """A camera prim: its world transform (rows are USD's axes and the position) and its lens."""

    world_from_camera: np.ndarray
    # 127 degrees from left to right if so, else 77.
    is_fisheye: bool = False

    K = (-0.023, -0.0012, 0.002, -0.0024)

    @property
    def focal(self) -> float:
        angle = np.radians(127 / 2)
        return float(SIZE[0] / 2 / (self.distorted(angle) if self.is_fisheye else np.tan(np.radians(38.5))))

    def distorted(self, theta: np.ndarray) -> np.ndarray:
        """OpenCV's fisheye model: the radius on the image, in focal lengths, of an angle from the axis."""
        return theta * (1 + sum(k * theta ** (2 * i + 2) for i, k in enumerate(self.K)))

    def prim(self) -> str:
        """As text of a USD stage."""
        rows = ", ".join(str(tuple(row)) for row in self.world_from_camera.tolist())
        aperture = 20.0
        lens = ""
        if self.is_fisheye:
            prefix = "omni:lensdistortion:opencvFisheye:"
            # OpenCV's convention: the centre of the first pixel is 0.
            numbers = {"fx": self.focal, "fy": self.focal, "cx": (SIZE[0] - 1) / 2, "cy": (SIZE[1] - 1) / 2}
            numbers |= {f"k{i + 1}": k for i, k in enumerate(self.K)}
            lens = '    uniform token omni:lensdistortion:model = "opencvFisheye"\n'
            lens += f"    int2 {prefix}imageSize = ({SIZE[0]}, {SIZE[1]})\n"
            lens += "".join(f"    float {prefix}{name} = {value!r}\n" for name, value in numbers.items())
        schema = '(prepend apiSchemas = ["OmniLensDistortionOpenCvFisheyeAPI"])' if lens else ""
        return f"""def Camera "camera" {schema}
{{
    float2 clippingRange = (0.001, 1000)
    float focalLength = {aperture * self.focal / SIZE[0]!r}
    float horizontalAperture = {aperture}
    float verticalAperture = {aperture * SIZE[1] / SIZE[0]}
    matrix4d xformOp:transform = ( {rows} )
    uniform token[] xformOpOrder = ["xformOp:transform"]
{lens}}}
"""

    def rays(self, offset: tuple[float, float]) -> tuple[np.ndarray, np.ndarray]:
        """Unit directions (height, width, 3) in OpenCV's camera axes and in the world, a bit beside each pixel's centre."""
        x, y = np.meshgrid(np.arange(SIZE[0]) + 0.5 + offset[0], np.arange(SIZE[1]) + 0.5 + offset[1])
        x, y = (x - SIZE[0] / 2) / float(np.float32(self.focal)), (y - SIZE[1] / 2) / float(np.float32(self.focal))
        if self.is_fisheye:
            radius = np.hypot(x, y)
            theta = radius.copy()
            for _ in range(20):
                # Newton's method, with the slope by a small step.
                slope = (self.distorted(theta + 1e-6) - self.distorted(theta - 1e-6)) / 2e-6
                theta -= (self.distorted(theta) - radius) / slope
            scale = np.sin(theta) / np.maximum(radius, 1e-300)
            directions = np.stack([x * scale, y * scale, np.cos(theta)], -1)
        else:
            directions = np.stack([x, y, np.ones_like(x)], -1)
            directions /= np.linalg.norm(directions, axis=-1, keepdims=True)
        return directions, (directions * [1, -1, -1]) @ self.world_from_camera[:3, :3]


def looking(eye: list[float], target: list[float], up: list[float]) -> np.ndarray:
    """USD's camera axes and place as rows."""
    eye, back = np.array(eye), np.subtract(eye, target).astype(float)
    back /= np.linalg.norm(back)
    right = np.cross(up, back)
    right /= np.linalg.norm(right)
    rows = np.eye(4)
    rows[0, :3], rows[1, :3], rows[2, :3], rows[3, :3] = right, np.cross(back, right), back, eye
    return rows


def depth_by_open3d(positions: np.ndarray, triangles: np.ndarray, camera: Camera) -> list[np.ndarray]:
    """Depth of every pixel, then of the same pixels moved a little, eight ways."""
    scene = open3d().t.geometry.RaycastingScene()
    # About the camera, so that float32 rays start exactly there.
    eye = camera.world_from_camera[3, :3]
    scene.add_triangles((positions.astype(float) - eye).astype(np.float32), triangles)
    offsets = [(0.0, 0.0)]
    offsets += [(EDGE_PX * np.cos(angle), EDGE_PX * np.sin(angle)) for angle in np.arange(8) * np.pi / 4]
    images = []
    for offset in offsets:
        in_camera, in_world = camera.rays(offset)
        rays = np.concatenate([np.zeros_like(in_world), in_world], -1).astype(np.float32)
        images.append(scene.cast_rays(rays)["t_hit"].numpy() * in_camera[..., 2])
    return images


def compare(ours: np.ndarray, theirs: list[np.ndarray]) -> None:
    """All pixels are equal except some at silhouettes, which equal a neighbouring ray."""
    assert ours.shape == theirs[0].shape

    def same(image: np.ndarray) -> np.ndarray:
        with np.errstate(invalid="ignore"):
            return (np.isinf(ours) & np.isinf(image)) | (np.abs(ours - image) <= SAME * image)

    differs = ~same(theirs[0])
    stack = np.stack(theirs)
    with np.errstate(invalid="ignore"):
        at_edge = ~(np.ptp(stack, axis=0) <= 1e-3 * stack.min(0))
    wrong = np.argwhere(differs & ~at_edge)
    assert len(wrong) == 0, [(tuple(map(int, p)), float(ours[tuple(p)]), float(theirs[0][tuple(p)])) for p in wrong[:5]]
    assert differs.sum() <= SILHOUETTES * differs.size
    assert np.isfinite(ours).mean() > 0.2


def render(program: Path, stage: Path, folder: Path, backend: str) -> np.ndarray:
    command = [program, "render", stage, "--resolution", f"{SIZE[0]}x{SIZE[1]}", "--backend", backend]
    options = ["--annotators", "distance_to_image_plane", "--output", folder]
    done = subprocess.run([*command, *options], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return np.load(folder / "distance_to_image_plane_0000.npy").squeeze()


@pytest.fixture(scope="module")
def chess_set() -> tuple[np.ndarray, np.ndarray]:
    """Its triangles in the world."""
    if not CHESS_SET.exists():
        pytest.skip("OAKTWIN_TEST_DATA has no chess set")
    return extract(str(CHESS_SET))


@pytest.mark.parametrize(("backend", "is_fisheye"), [("raster", False), ("ray", False), ("ray", True)])
def test_chess_set(program: Path, chess_set: tuple, tmp_path: Path, backend: str, is_fisheye: bool) -> None:
    positions, triangles = chess_set
    assert len(triangles) > 799_384, "the pawns' instances too"
    camera = Camera(looking([0.3, 0.2, 0.25], [0.0, 0.03, 0.0], [0, 1, 0]), is_fisheye)
    stage = tmp_path / "stage.usda"
    header = f'#usda 1.0\n(\n    subLayers = [@{CHESS_SET}@]\n    metersPerUnit = 1\n    upAxis = "Y"\n)\n'
    stage.write_text(header + camera.prim())
    compare(render(program, stage, tmp_path / "out", backend), depth_by_open3d(positions, triangles, camera))


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize(("backend", "is_fisheye"), [("raster", False), ("ray", False), ("ray", True)])
def test_random_meshes(program: Path, tmp_path: Path, seed: int, backend: str, is_fisheye: bool) -> None:
    rng = np.random.default_rng(seed)
    # Triangles of all sizes around the camera, also behind it.
    count = 3000
    middles = rng.uniform(-4, 4, (count, 1, 3))
    sizes = np.exp(rng.uniform(np.log(0.01), np.log(1.0), (count, 1, 1)))
    corners = (middles + sizes * rng.uniform(-1, 1, (count, 3, 3))).astype(np.float32)
    corners = corners[np.linalg.norm(corners, axis=-1).min(1) > 0.3]
    positions = corners.reshape(-1, 3)
    triangles = np.arange(len(positions), dtype=np.uint32).reshape(-1, 3)
    camera = Camera(looking([0, 0, 0], rng.uniform(-1, 1, 3).tolist(), [0, 0, 1]), is_fisheye)
    points = ", ".join(f"({x!r}, {y!r}, {z!r})" for x, y, z in positions.astype(float).tolist())
    mesh = f"""def Mesh "mesh"
{{
    int[] faceVertexCounts = {[3] * len(triangles)}
    int[] faceVertexIndices = {triangles.ravel().tolist()}
    point3f[] points = [{points}]
    uniform token subdivisionScheme = "none"
}}
"""
    stage = tmp_path / "stage.usda"
    stage.write_text('#usda 1.0\n(\n    metersPerUnit = 1\n    upAxis = "Z"\n)\n' + camera.prim() + mesh)
    compare(render(program, stage, tmp_path / "out", backend), depth_by_open3d(positions, triangles, camera))
