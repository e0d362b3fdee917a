"""Colour and depth of a data set in BOP's layout, rendered again by one peer on the processor; noise and masks are not made.

    python bench_generate_peers.py PEER SET FRAMES

PEER is `pyrender-osmesa`, `pyrender-egl` or an engine of Blender: `BLENDER_WORKBENCH`, `BLENDER_EEVEE`, `CYCLES` with one ray per pixel. Prints the seconds
without loading, or why the peer does not run.
"""

import json
import os
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

WALLS = [((6, 0.02, 2.5), (0, 3, 1.25)), ((6, 0.02, 2.5), (0, -3, 1.25)), ((0.02, 6, 2.5), (-3, 0, 1.25)), ((0.02, 6, 2.5), (3, 0, 1.25))]
LEGS = [((0.05, 0.05, 0.7), (x, y, 0.35)) for x in (-0.525, 0.525) for y in (-0.325, 0.325)]
BOXES = [((1.2, 0.8, 0.04), (0, 0, 0.72)), ((6, 6, 0.02), (0, 0, -0.01)), *WALLS, *LEGS]
LIGHT = (0.5, 0.3, 2.3)
OPENGL_FROM_OPENCV = np.diag([1.0, -1.0, -1.0, 1.0])


def transform(rotation: list, translation_mm: list) -> np.ndarray:
    matrix = np.eye(4)
    matrix[:3, :3] = np.array(rotation).reshape(3, 3)
    matrix[:3, 3] = np.array(translation_mm) * 1e-3
    return matrix


def frames(root: Path, count: int) -> list[tuple]:
    """The number, the camera matrix, world_from_camera, and the poses of the objects in the world of each frame."""
    found = []
    for scene in sorted((root / "train").iterdir()):
        cameras, poses = (json.loads((scene / f"scene_{name}.json").read_text()) for name in ("camera", "gt"))
        for key, camera in cameras.items():
            world = np.linalg.inv(transform(camera["cam_R_w2c"], camera["cam_t_w2c"]))
            placed = [(pose["obj_id"], world @ transform(pose["cam_R_m2c"], pose["cam_t_m2c"])) for pose in poses[key]]
            found.append((int(key), np.array(camera["cam_K"]).reshape(3, 3), world, placed))
    return found[:count]


class Pyrender:
    def __init__(self, platform: str, root: Path, size: tuple) -> None:
        os.environ["PYOPENGL_PLATFORM"] = platform
        import pyrender
        import trimesh
        from PIL import Image

        self.pyrender, self.save = pyrender, lambda path, image: Image.fromarray(image).save(path, compress_level=1)
        self.load = lambda number: pyrender.Mesh.from_trimesh(
            trimesh.load(root / f"models/obj_{number:06}.ply").apply_scale(1e-3), smooth=False
        )
        boxes = [trimesh.creation.box(extents, trimesh.transformations.translation_matrix(at)) for extents, at in BOXES]
        self.room = pyrender.Mesh.from_trimesh(boxes, smooth=False)
        self.renderer, self.models = pyrender.OffscreenRenderer(*size), {}

    def frame(self, number: int, matrix: np.ndarray, world: np.ndarray, placed: list, output: Path) -> None:
        pyrender = self.pyrender
        scene = pyrender.Scene(ambient_light=[0.2] * 3)
        scene.add(self.room)
        for model, pose in placed:
            if model not in self.models:
                self.models[model] = self.load(model)
            scene.add(self.models[model], pose=pose)
        light = np.eye(4)
        light[:3, 3] = LIGHT
        scene.add(pyrender.PointLight(intensity=30), pose=light)
        camera = pyrender.IntrinsicsCamera(matrix[0, 0], matrix[1, 1], matrix[0, 2] + 0.5, matrix[1, 2] + 0.5, znear=0.05, zfar=20)
        scene.add(camera, pose=world @ OPENGL_FROM_OPENCV)
        color, depth = self.renderer.render(scene)
        self.save(output / f"rgb_{number}.png", color)
        self.save(output / f"depth_{number}.png", np.round(depth * 1000).astype(np.uint16))


class Blender:
    def __init__(self, engine: str, root: Path, size: tuple) -> None:
        import bpy
        from mathutils import Matrix

        self.bpy, self.matrix, self.root, self.size, self.models = bpy, Matrix, root, size, {}
        bpy.ops.wm.read_factory_settings(use_empty=True)
        scene = self.scene = bpy.context.scene
        for extents, at in BOXES:
            bpy.ops.mesh.primitive_cube_add(size=1, location=at)
            bpy.context.object.scale = extents
        lamp = bpy.data.objects.new("lamp", bpy.data.lights.new("lamp", "POINT"))
        lamp.data.energy, lamp.location = 80, LIGHT
        self.camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
        for one in (lamp, self.camera):
            scene.collection.objects.link(one)
        scene.camera, scene.render.engine = self.camera, engine
        scene.render.resolution_x, scene.render.resolution_y = size
        scene.render.use_persistent_data = True
        scene.view_layers[0].use_pass_z = True
        scene.display.render_aa = "OFF"
        scene.eevee.taa_render_samples = 1
        if engine == "CYCLES":
            scene.cycles.device, scene.cycles.samples, scene.cycles.max_bounces = "CPU", 1, 1
            scene.cycles.use_denoising = scene.cycles.use_adaptive_sampling = False
        settings = scene.render.image_settings
        if hasattr(settings, "media_type"):
            settings.media_type = "MULTI_LAYER_IMAGE"
        settings.file_format, settings.color_depth, settings.exr_codec = "OPEN_EXR_MULTILAYER", "32", "ZIP"

    def model(self, number: int, index: int) -> object:
        """An object for each place of a model in a frame; all have the same mesh."""
        if (number, index) not in self.models:
            if (number, 0) not in self.models:
                self.bpy.ops.wm.ply_import(filepath=str(self.root / f"models/obj_{number:06}.ply"))
                self.models[number, 0] = self.bpy.context.object
            first = self.models[number, 0]
            if index:
                copy = self.models[number, index] = self.bpy.data.objects.new(first.name, first.data)
                self.scene.collection.objects.link(copy)
        return self.models[number, index]

    def frame(self, number: int, matrix: np.ndarray, world: np.ndarray, placed: list, output: Path) -> None:
        for one in self.models.values():
            one.hide_render = True
        used = {}
        for model, pose in placed:
            index = used[model] = used.get(model, -1) + 1
            one = self.model(model, index)
            one.hide_render = False
            one.matrix_world = self.matrix(pose @ np.diag([1e-3, 1e-3, 1e-3, 1]))
        width, height = self.size
        data = self.camera.data
        data.sensor_width, data.lens = width, matrix[0, 0]
        data.shift_x = -(matrix[0, 2] + 0.5 - width / 2) / width
        data.shift_y = (matrix[1, 2] + 0.5 - height / 2) / width
        self.camera.matrix_world = self.matrix(world @ OPENGL_FROM_OPENCV)
        self.scene.render.filepath = str(output / f"{number}.exr")
        self.bpy.ops.render.render(write_still=True)


def main() -> None:
    name, root, count = sys.argv[1], Path(sys.argv[2]), int(sys.argv[3])
    intrinsics = json.loads((root / "camera.json").read_text())
    size = intrinsics["width"], intrinsics["height"]
    with tempfile.TemporaryDirectory() as folder:
        output = Path(folder)
        try:
            kind, _, platform = name.partition("-")
            peer = Pyrender(platform, root, size) if kind == "pyrender" else Blender(name, root, size)
            jobs = frames(root, count)
            # The first frame loads shaders and meshes.
            peer.frame(*jobs[0], output)
            start, busy = time.perf_counter(), time.process_time()
            for job in jobs:
                peer.frame(*job, output)
            seconds, processor = time.perf_counter() - start, time.process_time() - busy
        except Exception as error:
            print(json.dumps({"skipped": f"{type(error).__name__}: {error}".splitlines()[0]}), flush=True)
            return
        written = [path for path in output.iterdir() if path.stat().st_size]
        assert len(written) >= len(jobs), "frames are missing"
    print(json.dumps({"seconds": seconds, "processor_seconds": processor, "frames": len(jobs)}), flush=True)


main()
