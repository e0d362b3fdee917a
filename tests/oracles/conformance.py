"""Compares renderings of the program with Isaac Sim's: `conformance.py PROGRAM DATA`.

DATA/isaac-pointcloud holds scenes (`isaac-X.usda`) and Isaac Sim's own points for them
(`vX/pointcloud_data_{world,camera}_{frame,from_depth}_res_W_H.npy`): `from_depth` are row by row, `frame` in an order of
their own. DATA/isaac-camera-params holds camera matrices as Isaac Sim's pose writer put them out, rounded to 1e-5.
Prints a table. Exit code 1 where something differs, 2 where there is nothing to compare with.
"""

import json
import re
import subprocess
import sys
from collections import defaultdict
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import product
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

# Tolerances: distance of corresponding points in metres; difference of matrix entries.
POINTS, MATRICES = 2e-5, 1e-5

BACKENDS = ("raster", "ray")

# OpenCV's camera axes from USD's.
OPENCV_FROM_USD = np.diag([1.0, -1.0, -1.0])


@dataclass
class Comparison:
    """A file of Isaac Sim's, and the difference of ours from it."""

    what: str
    count: int
    # The number of points without a counterpart, or of entries that differ.
    missing: int
    worst: float
    limit: float

    @property
    def is_same(self) -> bool:
        return self.count > 0 and self.missing == 0 and self.worst <= self.limit


@dataclass
class Rendered:
    """The program's output for one camera."""

    depth: np.ndarray
    points: np.ndarray
    parameters: dict

    @classmethod
    def of(cls, program: Path, scene: Path, size: tuple[int, int], folder: Path, backend: str) -> "Rendered":
        annotators = "pointcloud,distance_to_image_plane,camera_params"
        command = [program, "render", scene, "--resolution", f"{size[0]}x{size[1]}", "--annotators", annotators]
        options = ["--backend", backend, "--output", folder]
        subprocess.run([*command, *options], check=True, capture_output=True, text=True)
        return cls(
            np.load(folder / "distance_to_image_plane_0000.npy").squeeze(),
            np.load(folder / "pointcloud_0000.npy"),
            json.loads((folder / "camera_params_0000.json").read_text()),
        )

    def opencv_from_world(self) -> np.ndarray:
        """4 × 4, for column vectors."""
        usd_from_world = np.array(self.parameters["cameraViewTransform"]).reshape(4, 4).T
        return np.block([[OPENCV_FROM_USD, np.zeros((3, 1))], [np.zeros((1, 3)), np.ones((1, 1))]]) @ usd_from_world

    def camera_points(self) -> np.ndarray:
        """The points row by row, computed from the depth and the camera parameters, in OpenCV's axes."""
        width, height = self.parameters["renderProductResolution"]
        assert self.depth.shape == (height, width)
        focal = width * self.parameters["cameraFocalLength"] / self.parameters["cameraAperture"][0]
        x, y = np.meshgrid(np.arange(width) + 0.5 - width / 2, np.arange(height) + 0.5 - height / 2)
        z = self.depth.astype(float)
        return np.stack([x * z / focal, y * z / focal, z], -1).reshape(-1, 3)

    def world_points(self) -> np.ndarray:
        """[`camera_points`] in the world frame."""
        world_from_opencv = np.linalg.inv(self.opencv_from_world())
        return self.camera_points() @ world_from_opencv[:3, :3].T + world_from_opencv[:3, 3]

    def annotated(self, frame: str) -> np.ndarray:
        """The program's point cloud, transformed to `frame`."""
        if frame == "world":
            return self.points
        opencv_from_world = self.opencv_from_world()
        return self.points @ opencv_from_world[:3, :3].T + opencv_from_world[:3, 3]


def matched(ours: np.ndarray, theirs: np.ndarray, within: float) -> tuple[int, float]:
    """Matches each of their points with one of ours; returns the number of points without a match, and the largest distance."""
    reach = 50 * within
    cells = defaultdict(list)
    for index, cell in enumerate(map(tuple, np.floor(ours / reach).astype(int))):
        cells[cell].append(index)
    steps = list(product((-1, 0, 1), repeat=3))
    free = np.ones(len(ours), bool)
    missing, worst = abs(len(ours) - len(theirs)), 0.0
    for point, (i, j, k) in zip(theirs, np.floor(theirs / reach).astype(int).tolist(), strict=True):
        near = [index for a, b, c in steps for index in cells.get((i + a, j + b, k + c), ()) if free[index]]
        distances = np.linalg.norm(ours[near] - point, axis=1)
        if len(near) == 0 or not distances.min() <= reach:
            missing += 1
            continue
        free[near[distances.argmin()]] = False
        worst = max(worst, float(distances.min()))
    return missing, worst


def row_by_row(ours: np.ndarray, theirs: np.ndarray) -> tuple[int, float]:
    """The same for ordered points."""
    if ours.shape != theirs.shape:
        return max(len(ours), len(theirs)), 0.0
    distances = np.linalg.norm(ours - theirs, axis=1)
    return int(np.sum(~np.isfinite(distances))), float(np.nanmax(distances))


def point_clouds(program: Path, data: Path) -> Iterator[Comparison]:
    """Every scene at every size for which Isaac Sim's points exist."""
    name = re.compile(r"pointcloud_data_(world|camera)_(frame|from_depth)_res_(\d+)_(\d+)\.npy")
    for scene in sorted(data.glob("isaac-pointcloud/isaac-*.usda")):
        version = scene.stem.removeprefix("isaac-")
        files = defaultdict(list)
        for file in sorted(scene.parent.glob(f"v{version}/*.npy")):
            if found := name.fullmatch(file.name):
                frame, order, width, height = found.groups()
                files[int(width), int(height)].append((frame, order, file))
        for (size, of_size), backend in product(sorted(files.items()), BACKENDS):
            with TemporaryDirectory() as folder:
                rendered = Rendered.of(program, scene, size, Path(folder), backend)
            for frame, order, file in of_size:
                theirs = np.load(file).astype(float)
                if order == "from_depth":
                    ours = rendered.world_points() if frame == "world" else rendered.camera_points()
                    missing, worst = row_by_row(ours, theirs)
                else:
                    missing, worst = matched(rendered.annotated(frame).astype(float), theirs, POINTS)
                what = f"{version} {size[0]}x{size[1]} {frame} {order.replace('_', ' ')}, {backend}"
                yield Comparison(what, len(theirs), missing, worst, POINTS)


CAMERA = """#usda 1.0
(
    metersPerUnit = {unit}
    upAxis = "Z"
)

def Camera "camera"
{{
    float2 clippingRange = ({near}, {far})
    float focalLength = {focal}
    float horizontalAperture = {aperture[0]}
    float verticalAperture = {aperture[1]}
    matrix4d xformOp:transform = ( {rows} )
    uniform token[] xformOpOrder = ["xformOp:transform"]
}}

def Mesh "something"
{{
    int[] faceVertexCounts = [3]
    int[] faceVertexIndices = [0, 1, 2]
    point3f[] points = [(0, 0, 0), (1, 0, 0), (0, 1, 0)]
}}
"""

# The clipping range is not in Isaac Sim's files; the folder's README states it.
CLIPPING = {"pinhole": (1, 1e6), "pinholeOpenCV": (0.1, 100)}


def camera_parameters(program: Path, data: Path) -> Iterator[Comparison]:
    """Sets up every camera of the pose writer from its view matrix, and compares both matrices."""
    for file in sorted(data.glob("isaac-camera-params/*.json")):
        theirs = json.loads(file.read_text())["camera_data"]
        near, far = CLIPPING[file.stem.split("_")[0]]
        with TemporaryDirectory() as folder:
            scene = Path(folder) / "camera.usda"
            rows = ", ".join(str(tuple(row)) for row in world_from_camera(theirs["camera_view_matrix"]).tolist())
            scene.write_text(
                CAMERA.format(
                    unit=theirs["meters_per_scene_unit"],
                    near=near,
                    far=far,
                    focal=theirs["focal_length"],
                    aperture=theirs["aperture"],
                    rows=rows,
                )
            )
            ours = Rendered.of(program, scene, tuple(theirs["resolution"]), Path(folder) / "out", "auto").parameters
        pairs = {
            "view": ("cameraViewTransform", "camera_view_matrix"),
            "projection": ("cameraProjection", "camera_projection_matrix"),
            "aperture": ("cameraAperture", "aperture"),
            "focal length": ("cameraFocalLength", "focal_length"),
            "resolution": ("renderProductResolution", "resolution"),
        }
        for what, (our_key, their_key) in pairs.items():
            a, b = np.ravel(ours[our_key]).astype(float), np.ravel(theirs[their_key]).astype(float)
            same_size = a.shape == b.shape
            worst = float(np.abs(a - b).max()) if same_size else np.inf
            yield Comparison(f"{file.stem} {what}", len(b), 0 if same_size else len(b), worst, MATRICES)
        # The projection matrix and the size imply square pixels and a centred principal point.
        width, height = ours["renderProductResolution"]
        projection = np.array(ours["cameraProjection"]).reshape(4, 4)
        implied = [projection[0, 0] * width / 2, projection[1, 1] * height / 2, width / 2, height / 2]
        error = np.abs(np.array(implied) - [theirs["intrinsics"][key] for key in ("fx", "fy", "cx", "cy")])
        # px, of a focal length of some hundreds: the aperture is float32 on both sides.
        yield Comparison(f"{file.stem} intrinsics", 4, 0, float(error.max()), 1e-4)


def world_from_camera(view: list[list[float]]) -> np.ndarray:
    """Returns the inverse of a rounded view matrix for row vectors, with its rotation orthonormalized."""
    view = np.array(view)
    u, _, vt = np.linalg.svd(view[:3, :3])
    rigid = np.eye(4)
    rigid[:3, :3], rigid[3, :3] = u @ vt, view[3, :3]
    return np.linalg.inv(rigid)


def main() -> int:
    program, data = map(Path, sys.argv[1:])
    try:
        points, parameters = list(point_clouds(program, data)), list(camera_parameters(program, data))
    except OSError as error:
        print(f"{error}: missing from the program's output")
        return 1
    except subprocess.CalledProcessError as error:
        print(f"{' '.join(map(str, error.cmd))}: exit code {error.returncode}\n{error.stdout}{error.stderr}")
        return 1
    done = points + parameters
    print("| compared | values | missing | largest difference | allowed | |\n|---|---:|---:|---:|---:|---|")
    for comparison in done:
        verdict = "same" if comparison.is_same else "DIFFERS"
        print(
            f"| {comparison.what} | {comparison.count} | {comparison.missing} | {comparison.worst:.1e} "
            f"| {comparison.limit:.0e} | {verdict} |"
        )
    different = sum(not comparison.is_same for comparison in done)
    print(f"\n{len(done) - different} of {len(done)} are the same")
    if different:
        return 1
    for found, what in ((points, "isaac-pointcloud/isaac-*.usda with points beside it"), (parameters, "isaac-camera-params/*.json")):
        if not found:
            print(f"{data}: holds no {what}")
    return 0 if points and parameters else 2


if __name__ == "__main__":
    sys.exit(main())
