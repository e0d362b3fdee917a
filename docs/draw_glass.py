"""Draws docs/images/glass.png: a mirror, a pane and balls of chrome and glass, in colour, as ground truth and as each engine measures them.

    python docs/draw_glass.py target/release/oaktwin docs/images/glass.png

Needs numpy, matplotlib, pillow. The program renders and measures; this lays out. The room is the demo's, and the camera is
an OAK-D Pro PoE, or an OAK-D ToF for time of flight.
"""

import subprocess
import sys
import tempfile
from pathlib import Path

import matplotlib
import numpy as np
from PIL import Image

matplotlib.use("Agg")
from matplotlib import pyplot as plt  # noqa: E402

ROOM = """#usda 1.0
(
    defaultPrim = "Room"
    metersPerUnit = 1
    subLayers = [@demo_room.usda@]
    upAxis = "Z"
)

over "Room"
{
    def Cube "Mirror"
    {
        double size = 1
        float3 xformOp:scale = (0.02, 0.9, 0.7)
        double3 xformOp:translate = (2.1, 0.62, 1.2)
        uniform token[] xformOpOrder = ["xformOp:translate", "xformOp:scale"]
        rel material:binding = </Room/Optics/Silver>
    }
    def Cube "Pane"
    {
        double size = 1
        float3 xformOp:scale = (0.01, 0.9, 0.7)
        double3 xformOp:translate = (1.9, -0.6, 1.2)
        uniform token[] xformOpOrder = ["xformOp:translate", "xformOp:scale"]
        rel material:binding = </Room/Optics/Pane>
    }
    def Sphere "Chrome"
    {
        double radius = 0.15
        double3 xformOp:translate = (1.4, 0.02, 1.05)
        uniform token[] xformOpOrder = ["xformOp:translate"]
        rel material:binding = </Room/Optics/Silver>
    }
    def Sphere "Glass"
    {
        double radius = 0.15
        double3 xformOp:translate = (1.4, -0.3, 1.45)
        uniform token[] xformOpOrder = ["xformOp:translate"]
        rel material:binding = </Room/Optics/Glass>
    }
    def Scope "Optics"
    {
        def Material "Silver"
        {
            token outputs:surface.connect = </Room/Optics/Silver/Surface.outputs:surface>
            def Shader "Surface"
            {
                uniform token info:id = "UsdPreviewSurface"
                color3f inputs:diffuseColor = (0.9, 0.9, 0.9)
                float inputs:metallic = 1
                float inputs:roughness = 0
                token outputs:surface
            }
        }
        def Material "Pane"
        {
            token outputs:surface.connect = </Room/Optics/Pane/Surface.outputs:surface>
            def Shader "Surface"
            {
                uniform token info:id = "UsdPreviewSurface"
                color3f inputs:diffuseColor = (0.4, 0.6, 0.5)
                float inputs:opacity = 0.05
                float inputs:roughness = 0
                token outputs:surface
            }
        }
        def Material "Glass"
        {
            token outputs:mtlx:surface.connect = </Room/Optics/Glass/Surface.outputs:out>
            def Shader "Surface"
            {
                uniform token info:id = "ND_standard_surface_surfaceshader"
                float inputs:transmission = 1
                float inputs:specular_IOR = 1.5
                float inputs:specular_roughness = 0
                token outputs:out
            }
        }
    }
}
"""
SIZE = "640x400"
TITLES = {
    "rgb": "Colour",
    "truth": "Ground truth",
    "single-view": "single-view",
    "stereo-noise": "stereo-noise",
    "stereo-matching": "stereo-matching",
    "time-of-flight": "time-of-flight",
}


def rendered(program: Path, folder: Path, engine: str) -> dict[str, np.ndarray]:
    """The colour, the truth and the measured depth of one engine."""
    out = folder / engine
    camera = ["OAK-D ToF", "--camera", "depth_tof"] if engine == "time-of-flight" else ["OAK-D Pro PoE"]
    place = ["--model", *camera, "--pose", "0", "0", "1.15", "0", "0", "0", "1", "--resolution", SIZE]
    names = "rgb,distance_to_image_plane,depth_sensor_distance"
    words = [program, "render", folder / "glass.usda", *place, "--engine", engine, "--annotators", names, "-o", out]
    subprocess.run([str(word) for word in words], check=True, stdout=subprocess.DEVNULL)
    depth = np.load(out / "depth_sensor_distance_0000.npy").squeeze()
    return {
        "rgb": np.asarray(Image.open(out / "rgb_0000.png"))[..., :3],
        "truth": np.load(out / "distance_to_image_plane_0000.npy").squeeze(),
        engine: np.where(depth > 0, depth, np.nan),
    }


def main(program: Path, picture: Path) -> None:
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary) / "demo" / "demo_room"
        subprocess.run([str(program), "demo", "-o", str(folder.parent)], check=True, stdout=subprocess.DEVNULL)
        (folder / "glass.usda").write_text(ROOM)
        images = {}
        for engine in ("time-of-flight", "single-view", "stereo-matching", "stereo-noise"):
            images |= rendered(program, folder, engine)
    figure, axes = plt.subplots(2, len(TITLES) // 2, figsize=(16, 7.2), layout="constrained")
    colours = plt.get_cmap("turbo_r").with_extremes(bad="0.4")
    for axis, (name, title) in zip(axes.flat, TITLES.items(), strict=True):
        drawn = axis.imshow(images[name], cmap=colours, vmin=0.5, vmax=8)
        axis.set_title(title)
        axis.axis("off")
    figure.colorbar(drawn, ax=axes, label="m", pad=0.01)
    figure.savefig(picture, dpi=110)
    Image.open(picture).convert("RGB").quantize(256).save(picture, optimize=True)


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]))
