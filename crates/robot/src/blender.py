"""Adds an OAK to a Blender scene: its housing and its cameras. Written by oaktwin.

Run it in Blender's text editor, or import it and call `add()`. `use("left")` makes a camera the scene's: it sets the
resolution and the shape of the pixels, which Blender keeps for the whole scene.
"""

import os

import bpy
from mathutils import Matrix

# DATA

def add(folder=None, parent=None):
    """Adds the OAK and returns the empty object that carries it, whose axes are x forward, y left, z up.

    `folder` is that of this script, for the meshes. `parent` is an object that carries the OAK, by default the one named PARENT.
    """
    if parent is None and PARENT is not None:
        parent = bpy.data.objects.get(PARENT)
        if parent is None:
            raise KeyError(f"the scene has no object named {PARENT}; pass another one as parent")
    body = bpy.data.objects.new(NAME, None)
    bpy.context.collection.objects.link(body)
    body.empty_display_size = 0.05
    body.parent = parent
    body.matrix_local = Matrix(PARENT_FROM_BODY)
    folder = folder or os.path.dirname(os.path.abspath(__file__))
    for path, color, metallic, roughness in MESHES:
        file = os.path.join(folder, path)
        bpy.ops.wm.obj_import(filepath=file, forward_axis="Y", up_axis="Z")
        material = bpy.data.materials.new(os.path.basename(path))
        material.use_nodes = True
        shader = material.node_tree.nodes["Principled BSDF"]
        shader.inputs["Base Color"].default_value = color
        shader.inputs["Metallic"].default_value = metallic
        shader.inputs["Roughness"].default_value = roughness
        for part in bpy.context.selected_objects:
            part.parent = body
            part.data.materials.clear()
            part.data.materials.append(material)
    for role, values in CAMERAS.items():
        data = bpy.data.cameras.new(f"{NAME}_{role}")
        data.sensor_fit = "HORIZONTAL"
        data.sensor_width = values["sensor_width"]
        data.lens = values["lens"]
        data.shift_x = values["shift_x"]
        data.shift_y = values["shift_y"]
        data.clip_start, data.clip_end = values["clip"]
        camera = bpy.data.objects.new(data.name, data)
        bpy.context.collection.objects.link(camera)
        camera.parent = body
        camera.matrix_local = Matrix(values["pose"])
    return body


def use(role, scene=None):
    """Makes a camera, such as "left", the one that a scene is rendered with, and returns it."""
    scene = scene or bpy.context.scene
    values = CAMERAS[role]
    scene.camera = bpy.data.objects[f"{NAME}_{role}"]
    scene.render.resolution_x, scene.render.resolution_y = (int(size) for size in values["resolution"])
    scene.render.resolution_percentage = 100
    aspect = values["pixel_aspect"]
    # Blender accepts aspects of at least 1.
    scene.render.pixel_aspect_x = max(1.0, 1.0 / aspect)
    scene.render.pixel_aspect_y = max(1.0, aspect)
    return scene.camera


if __name__ == "__main__":
    add()
