"""What `oaktwin generate` makes of the table-top recipe, made by a script with Open3D's ray casting and NumPy; and its fusion.

    python bench_generate.py PROGRAM RECIPE FRAMES [PYTHON]

The program makes a data set in BOP's layout. The script then makes the same frames again from its poses: colour with one light, shadows and
no antialiasing, exact depth, the same stereo noise without occlusion, masks, visible masks and their boxes, with all cores.

With the interpreter of an environment with Blender and pyrender, these render colour and depth of the first frames from the same poses, without noise
and masks (bench_generate_peers.py).

Then 60 views of one arrangement are fused by Open3D's TSDF volume with voxels of 2 mm, from exact and from measured depth, and the vertices are
compared with the models at their poses.
"""

import json
import resource
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
from PIL import Image
from scipy.ndimage import gaussian_filter

from open3d_import import open3d

o3d = open3d()
WALLS = [((6, 0.02, 2.5), (0, 3, 1.25)), ((6, 0.02, 2.5), (0, -3, 1.25)), ((0.02, 6, 2.5), (-3, 0, 1.25)), ((0.02, 6, 2.5), (3, 0, 1.25))]
LEGS = [((0.05, 0.05, 0.7), (x, y, 0.35)) for x in (-0.525, 0.525) for y in (-0.325, 0.325)]
BOXES = [((1.2, 0.8, 0.04), (0, 0, 0.72)), ((6, 6, 0.02), (0, 0, -0.01)), *WALLS, *LEGS]
LIGHT = np.array([0.5, 0.3, 3.0], np.float32)


class Peer:
    """The data set of the program, rendered again."""

    def __init__(self, root: Path, output: Path) -> None:
        self.root, self.output, self.models = root, output, {}
        for folder in ("rgb", "depth", "mask", "mask_visib"):
            (output / folder).mkdir(parents=True)

    def model(self, number: int) -> o3d.t.geometry.TriangleMesh:
        if number not in self.models:
            mesh = o3d.io.read_triangle_mesh(str(self.root / f"models/obj_{number:06}.ply"))
            self.models[number] = o3d.t.geometry.TriangleMesh.from_legacy(mesh).scale(1e-3, np.zeros(3))
        return self.models[number]

    def scene(self, camera: dict, poses: list) -> tuple:
        """The scene in the world, the scene of each object alone, and the ids of objects."""
        world = np.linalg.inv(transform(camera["cam_R_w2c"], camera["cam_t_w2c"]))
        whole, alone, ids = o3d.t.geometry.RaycastingScene(), [], {}
        for size, center in BOXES:
            box = o3d.t.geometry.TriangleMesh.create_box(*size).translate(np.array(center) - np.array(size) / 2)
            whole.add_triangles(box)
        for index, pose in enumerate(poses):
            placed = self.model(pose["obj_id"]).clone().transform(world @ transform(pose["cam_R_m2c"], pose["cam_t_m2c"]))
            ids[whole.add_triangles(placed)] = index
            scene = o3d.t.geometry.RaycastingScene()
            scene.add_triangles(placed)
            alone.append(scene)
        return whole, alone, ids

    def frame(self, number: int, camera: dict, poses: list, size: tuple, scenes: tuple) -> None:
        whole, alone, ids = scenes
        width, height = size
        matrix = np.array(camera["cam_K"]).reshape(3, 3)
        x, y = np.meshgrid(np.arange(width, dtype=np.float32), np.arange(height, dtype=np.float32))
        rays = np.stack([(x - matrix[0, 2]) / matrix[0, 0], (y - matrix[1, 2]) / matrix[1, 1], np.ones_like(x)], axis=-1)
        world = np.linalg.inv(transform(camera["cam_R_w2c"], camera["cam_t_w2c"])).astype(np.float32)
        directions = rays @ world[:3, :3].T
        origins = np.broadcast_to(world[:3, 3], directions.shape)
        cast = np.concatenate([origins, directions], axis=-1).astype(np.float32)
        hits = whole.cast_rays(o3d.core.Tensor(cast))
        depth = hits["t_hit"].numpy()
        seen = np.isfinite(depth)
        safe = np.where(seen, depth, 1)
        points = origins + directions * safe[..., None]
        to_light = LIGHT - points
        shadow = np.concatenate([points + 1e-3 * to_light, to_light * 0.999], axis=-1).astype(np.float32)
        lit = ~whole.test_occlusions(o3d.core.Tensor(shadow), tfar=1.0).numpy()
        normals = hits["primitive_normals"].numpy()
        distance = np.linalg.norm(to_light, axis=-1)
        cosine = np.abs((normals * to_light).sum(axis=-1)) / distance
        shade = (0.2 + 0.8 * lit * cosine) * seen
        colour = np.repeat((255 * np.clip(shade, 0, 1) ** (1 / 2.2))[..., None], 3, axis=-1).astype(np.uint8)
        # Stereo noise: correlated jitter of the disparity, in steps of a thirty-second of a pixel.
        focal_baseline = matrix[0, 0] * 0.075
        random = np.random.default_rng(number)
        jitter = gaussian_filter(random.standard_normal(depth.shape).astype(np.float32), 1.1) * 0.2
        disparity = np.round((focal_baseline / safe + jitter) * 32) / 32
        measured = np.where(seen & (disparity > 0) & (disparity < 190), focal_baseline / np.maximum(disparity, 1e-6), 0)
        found = hits["geometry_ids"].numpy()
        write = lambda folder, name, image: Image.fromarray(image).save(self.output / folder / name, compress_level=1)
        write("rgb", f"{number:06}.png", colour)
        write("depth", f"{number:06}.png", np.clip(np.round(measured * 1000), 0, 65535).astype(np.uint16))
        for geometry, index in ids.items():
            visible = (found == geometry).astype(np.uint8) * 255
            silhouette = np.isfinite(alone[index].cast_rays(o3d.core.Tensor(cast))["t_hit"].numpy()).astype(np.uint8) * 255
            write("mask_visib", f"{number:06}_{index:06}.png", visible)
            write("mask", f"{number:06}_{index:06}.png", silhouette)
            for mask in (visible, silhouette):
                np.flatnonzero(mask.any(axis=0)), np.flatnonzero(mask.any(axis=1))


def transform(rotation: list, translation_mm: list) -> np.ndarray:
    matrix = np.eye(4)
    matrix[:3, :3] = np.array(rotation).reshape(3, 3)
    matrix[:3, 3] = np.array(translation_mm) * 1e-3
    return matrix


FUSION = """
frames = 60
frames_per_scene = 60
scene = "{folder}/table.usda"
[[objects]]
files = "{folder}/objects/"
count = 6
on = "/World/Table"
region = {{ min = [-0.3, -0.25, 0.7], max = [0.3, 0.25, 0.8] }}
[light]
projector = 1
[camera]
rgb_imager = false
sphere = {{ distance_m = {{ uniform = [0.6, 0.9] }}, elevation_deg = {{ uniform = [20, 75] }} }}
[sensor]
engine = "stereo-noise"
extended_disparity = true
[output]
formats = ["basic", "bop"]
"""


def fusion(program: str, recipes: Path) -> None:
    """Fuses 60 views of one arrangement."""
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder)
        (root / "fusion.toml").write_text(FUSION.format(folder=recipes))
        subprocess.run([program, "generate", root / "fusion.toml", "-o", root / "set", "--json"], check=True, capture_output=True)
        scene = root / "set/bop/train/000000"
        cameras, poses = (json.loads((scene / f"scene_{name}.json").read_text()) for name in ("camera", "gt"))
        truth = o3d.t.geometry.RaycastingScene()
        truth.add_triangles(o3d.t.geometry.TriangleMesh.create_box(1.2, 0.8, 0.04).translate([-0.6, -0.4, 0.7]))
        peer = Peer(root / "set/bop", root / "peer")
        world = np.linalg.inv(transform(cameras["0"]["cam_R_w2c"], cameras["0"]["cam_t_w2c"]))
        for pose in poses["0"]:
            mesh = peer.model(pose["obj_id"]).clone()
            truth.add_triangles(mesh.transform(world @ transform(pose["cam_R_m2c"], pose["cam_t_m2c"])))
        for title, name in (("exact", "distance_to_image_plane"), ("measured", "depth_sensor_distance")):
            floats = o3d.core.float32
            grid = o3d.t.geometry.VoxelBlockGrid(("tsdf", "weight"), (floats, floats), ((1), (1)), 0.002, 16, 60000)
            for key, camera in cameras.items():
                depth = np.load(root / f"set/basic/{name}_{int(key):04}.npy")[..., None]
                depth = o3d.t.geometry.Image(o3d.core.Tensor(np.where(depth < 1.4, depth, 0).astype(np.float32)))
                matrix = o3d.core.Tensor(np.array(camera["cam_K"]).reshape(3, 3))
                pose = o3d.core.Tensor(transform(camera["cam_R_w2c"], camera["cam_t_w2c"]))
                blocks = grid.compute_unique_block_coordinates(depth, matrix, pose, 1.0, 1.4, 4.0)
                grid.integrate(blocks, depth, matrix, pose, 1.0, 1.4, 4.0)
            points = grid.extract_triangle_mesh(3.0).vertex.positions.numpy()
            near = (np.abs(points[:, :2]) < [0.45, 0.35]).all(axis=1) & (points[:, 2] > 0.735)
            errors = 1e3 * truth.compute_distance(o3d.core.Tensor(np.ascontiguousarray(points[near]))).numpy()
            print(
                f"  TSDF of {title} depth: {near.sum()} vertices, median {np.median(errors):.2f} mm, 95 % within "
                f"{np.percentile(errors, 95):.2f} mm, {100 * (errors < 2).mean():.2f} % within 2 mm"
            )


def renderers(root: Path, frames: int) -> list[tuple[str, dict]]:
    """The answers of other renderers, one process each."""
    script, answers = Path(__file__).with_name("bench_generate_peers.py"), []
    for name in ("BLENDER_WORKBENCH", "BLENDER_EEVEE", "CYCLES", "pyrender-osmesa", "pyrender-egl"):
        command = [sys.argv[4], script, name, root, str(frames)]
        done = subprocess.run(command, capture_output=True, text=True)
        lines = [line for line in done.stdout.splitlines() if line.startswith("{")]
        answers.append((name, json.loads(lines[-1]) if lines else {"skipped": f"exit code {done.returncode}"}))
    return answers


def main() -> None:
    program, recipe, frames = sys.argv[1], sys.argv[2], int(sys.argv[3])
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder)
        command = [program, "generate", recipe, "-o", root / "set", "--formats", "bop", "--frames", f"0..{frames}", "--json"]
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        report = json.loads(subprocess.run(command, check=True, capture_output=True).stdout)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        own, busy = report["seconds"], after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        jobs = []
        for scene in sorted((root / "set/train").iterdir()):
            cameras, poses = (json.loads((scene / f"scene_{name}.json").read_text()) for name in ("camera", "gt"))
            jobs += [(int(key), camera, poses[key]) for key, camera in cameras.items()]
        intrinsics = json.loads((root / "set/camera.json").read_text())
        size = intrinsics["width"], intrinsics["height"]
        peer = Peer(root / "set", root / "peer")
        start = time.perf_counter()

        def make(job: tuple) -> None:
            number, camera, poses = job
            peer.frame(number, camera, poses, size, peer.scene(camera, poses))

        # Open3D casts with all cores; more frames at a time overlap NumPy and the encoders with it.
        with ThreadPoolExecutor(4) as pool:
            list(pool.map(make, jobs))
        other = time.perf_counter() - start
        others = renderers(root / "set", min(frames, 8)) if len(sys.argv) > 4 else []
    print(f"table-top recipe, {size[0]}x{size[1]}, {frames} frames in BOP's layout")
    print(f"  oaktwin generate   {frames / own:6.2f} frames per second")
    print(f"  Open3D and NumPy   {frames / other:6.2f} frames per second")
    print(f"  ratio              {other / own:6.2f}")
    for name, answer in others:
        if "skipped" in answer:
            print(f"  {name:<18} skipped: {answer['skipped']}")
        else:
            rate = answer["frames"] / answer["seconds"]
            processor = answer["processor_seconds"] / answer["frames"] / (busy / frames)
            print(
                f"  {name:<18} {rate:6.2f} frames per second, colour and depth only; ratio {frames / own / rate:.2f}, of processor time "
                f"{processor:.2f}"
            )
    fusion(program, Path(recipe).resolve().parent)


main()
