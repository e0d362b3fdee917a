"""The exported Blender script, whose cameras Cycles renders: its depth agrees with `oaktwin render`'s."""

import subprocess
import sys
from pathlib import Path

import bpy
import numpy as np
import pytest

FIXTURE = Path(__file__).resolve().parents[2] / "crates/calibration/fixtures/example-oak-d-pro-poe.json"
# Slanted faces, and edges of several depths.
SCENE = """v 4 -6 -4
v 5.5 6 -4
v 5 6 4
v 4.5 -6 4
v 2 -0.9 -0.5
v 2.6 0.2 -0.5
v 2.4 0.1 0.6
v 1.8 -0.8 0.5
v 3 0.3 -0.3
v 3.2 1.4 -0.4
v 3.1 0.9 0.7
f 1 2 3 4
f 5 6 7 8
f 9 10 11
"""
POSE = ["0.1", "-0.2", "0.05", "0", "0.0871557427476582", "0", "0.9961946980917455"]


def shader_of_depth() -> bpy.types.Material:
    """A material that emits the distance along the optical axis."""
    material = bpy.data.materials.new("depth")
    material.use_nodes = True
    tree = material.node_tree
    tree.nodes.clear()
    camera, emission, output = (
        tree.nodes.new(f"ShaderNode{kind}") for kind in ("CameraData", "Emission", "OutputMaterial")
    )
    tree.links.new(camera.outputs["View Z Depth"], emission.inputs["Strength"])
    tree.links.new(emission.outputs["Emission"], output.inputs["Surface"])
    return material


def render(script: Path, scene_file: Path, role: str, image: Path) -> np.ndarray:
    """The depth image of a camera of the script, metres; 0 for a miss."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    names = {"__file__": str(script), "__name__": "oak"}
    exec(script.read_text(), names)
    body = names["add"]()
    x, y, z, qx, qy, qz, qw = map(float, POSE)
    body.location = (x, y, z)
    body.rotation_mode = "QUATERNION"
    body.rotation_quaternion = (qw, qx, qy, qz)
    # The housing is around the cameras, and not part of the scene.
    for part in [one for one in bpy.data.objects if one.type == "MESH"]:
        part.hide_render = True
    bpy.ops.wm.obj_import(filepath=str(scene_file), forward_axis="Y", up_axis="Z")
    scene = bpy.context.scene
    names["use"](role)
    scene.render.engine = "CYCLES"
    scene.cycles.device, scene.cycles.samples = "CPU", 1
    scene.cycles.use_adaptive_sampling = scene.cycles.use_denoising = False
    # One ray through the centre of each pixel.
    scene.cycles.pixel_filter_type, scene.cycles.filter_width = "BLACKMAN_HARRIS", 0.01
    scene.cycles.max_bounces = 0
    scene.view_settings.view_transform = "Raw"
    bpy.context.view_layer.material_override = shader_of_depth()
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    scene.render.filepath = str(image)
    bpy.ops.render.render(write_still=True)
    loaded = bpy.data.images.load(str(image))
    width, height = loaded.size
    pixels = np.empty(width * height * 4, np.float32)
    loaded.pixels.foreach_get(pixels)
    # Blender's first row is the lowest.
    return pixels.reshape(height, width, 4)[::-1, :, 0]


@pytest.mark.parametrize("unit", ["OAK-D Pro W PoE", str(FIXTURE)])
def test_cycles_sees_what_the_twin_sees(program: Path, tmp_path: Path, unit: str) -> None:
    """A wide nominal camera, and a unit whose principal point and focal lengths differ."""
    (tmp_path / "scene.obj").write_text(SCENE)
    subprocess.run([program, "export", unit, "--to", "blender", "-o", tmp_path / "oak"], check=True, capture_output=True)
    model = ["--model", "OAK-D-Pro-PoE", "--calibration", unit] if unit.endswith(".json") else ["--model", unit]
    command = [program, "render", "scene.obj", "--up", "z", *model, "--camera", "depth", "--pose", *POSE]
    command += ["--annotators", "distance_to_image_plane", "-o", "out"]
    subprocess.run(command, check=True, cwd=tmp_path, capture_output=True)
    expected = np.load(tmp_path / "out/distance_to_image_plane_0000.npy")
    found = render(tmp_path / "oak/oak_blender.py", tmp_path / "scene.obj", "stereo_depth", tmp_path / "depth.exr")
    assert found.shape == expected.shape
    hit = np.isfinite(expected)
    assert ((found > 0) == hit).mean() > 0.9999
    both = hit & (found > 0)
    error = np.abs(found[both] / expected[both] - 1)
    # Of about 1 million pixels, some hundred at the edges may see the other side.
    assert (error > 1e-4).sum() < 300, (error > 1e-4).sum()
    # An image that is moved by a twentieth of a pixel has larger errors, on every face.
    with np.errstate(invalid="ignore"):
        slopes = [np.abs(np.diff(expected, axis=axis)) / 4.5 for axis in (0, 1)]
    moved = 0.05 * min(np.median(slope[np.isfinite(slope) & (slope > 0)]) for slope in slopes)
    assert np.median(error) < moved / 2, (np.median(error), moved)
