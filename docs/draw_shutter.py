"""Draws docs/images/shutter.png: a turning fan before a sensor that rolls, as a moment and exposed for two times.

    python docs/draw_shutter.py target/release/oaktwin docs/images/shutter.png

Needs numpy and pillow. The program renders; this lays out. The camera is the colour camera of an OAK-D Pro PoE, whose IMX378 reads its rows in 24 ms,
and the fan turns eight times a second.
"""

import math
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
from PIL import Image

HEAD = """#usda 1.0
(
    upAxis = "Z"
    metersPerUnit = 1
    timeCodesPerSecond = 24
    startTimeCode = 0
    endTimeCode = 24
)
def Plane "Wall"
{
    uniform token axis = "X"
    double width = 6
    double length = 8
    double3 xformOp:translate = (2.6, 0, 0)
    uniform token[] xformOpOrder = ["xformOp:translate"]
    color3f[] primvars:displayColor = [(0.8, 0.78, 0.72)]
}
def Cube "Post"
{
    double size = 1
    double3 xformOp:translate = (1.3, 0, -0.55)
    float3 xformOp:scale = (0.05, 0.05, 1.1)
    uniform token[] xformOpOrder = ["xformOp:translate", "xformOp:scale"]
    color3f[] primvars:displayColor = [(0.2, 0.2, 0.2)]
}
def DomeLight "Sky"
{
    float inputs:intensity = 1
}
def Xform "Fan"
{
    double3 xformOp:translate = (1.2, 0, 0)
    float xformOp:rotateX.timeSamples = { 0: 0, 24: 2880 }
    uniform token[] xformOpOrder = ["xformOp:translate", "xformOp:rotateX"]
    def Cylinder "Hub"
    {
        uniform token axis = "X"
        double radius = 0.06
        double height = 0.06
        color3f[] primvars:displayColor = [(0.1, 0.1, 0.12)]
    }
"""
BLADE = """
    def Mesh "Blade{number}"
    {{
        uniform token subdivisionScheme = "none"
        int[] faceVertexCounts = [4]
        int[] faceVertexIndices = [0, 1, 3, 2]
        point3f[] points = [{points}]
        color3f[] primvars:displayColor = [{color}]
    }}
"""
# The file name, the options and the caption of each image.
IMAGES = [[], ["--exposure", "1"], ["--exposure", "8"]]


def fan() -> str:
    """Returns a stage with a fan of five blades, of which one is red."""
    stage = HEAD
    for number in range(5):
        angle = 2 * math.pi * number / 5
        corners = [(0.02 * side, side * half, radius) for radius, half in ((0.05, 0.03), (0.42, 0.11)) for side in (-1, 1)]
        turned = [
            (x, y * math.cos(angle) - z * math.sin(angle), y * math.sin(angle) + z * math.cos(angle)) for x, y, z in corners
        ]
        color = "(0.7, 0.1, 0.08)" if number == 0 else "(0.1, 0.28, 0.6)"
        stage += BLADE.format(number=number, points=", ".join(f"({x:.4f}, {y:.4f}, {z:.4f})" for x, y, z in turned), color=color)
    return stage + "}\n"


def main() -> None:
    program, target = sys.argv[1:]
    pictures = []
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "fan.usda").write_text(fan())
        for number, options in enumerate(IMAGES):
            output = folder / str(number)
            command = [program, "render", folder / "fan.usda", "--frames", "3:3", "--model", "OAK-D Pro PoE", "--camera", "rgb", "-o", output]
            command += ["--look-at", "0", "0", "0", "1", "0", "0", "--resolution", "640x480", "--annotators", "rgb", *options]
            subprocess.run([str(part) for part in command], check=True, stdout=subprocess.DEVNULL)
            pictures.append(np.asarray(Image.open(next(output.glob("rgb*.png"))).convert("RGB")))
    gap = np.full((pictures[0].shape[0], 8, 3), 255, np.uint8)
    row = np.concatenate([pictures[0], gap, pictures[1], gap, pictures[2]], axis=1)
    Image.fromarray(row).save(target, optimize=True)


if __name__ == "__main__":
    main()
