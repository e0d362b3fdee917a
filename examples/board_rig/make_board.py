"""Writes the rig's scene, board.usda, and the dots on its board, dots.png.

    python make_board.py

The camera is at the origin and looks along +x, with z up. Sizes and places are the means over the pictures of five units
(OAK-D Pro class, luxonis/depthai-experiments, depth-color-alignment-test): planes fitted to their depth, and the board's outline in
their colour images, which is that of a sheet of 297 mm by 210 mm.
"""

import random
import struct
import zlib
from pathlib import Path

HERE = Path(__file__).resolve().parent
BOARD_MM = (297, 210)
# The side of a dot in millimetres and in texels, and the share of dots that are black: as they look in the colour images.
DOT_MM, DOT_TEXELS, BLACK = 1.1, 3, 0.3
# Distance on the axis in metres, and its slopes to the right and downwards.
WALL = (0.704, -0.024, -0.032)
BOARD = (0.548, 0.023, -0.027)
# The board's middle to the right of the axis and above it, metres.
BOARD_MIDDLE = (-0.032, 0.016)
# Half the wall's width and height, metres.
WALL_HALF = (1.2, 0.8)


def chunk(kind, data):
    body = kind + data
    return struct.pack(">I", len(data)) + body + struct.pack(">I", zlib.crc32(body))


def dots():
    """An 8-bit grey PNG."""
    draw = random.Random(0)
    columns, rows = (round(side / DOT_MM) for side in BOARD_MM)
    lines = b""
    for _ in range(rows):
        cells = [30 if draw.random() < BLACK else 250 for _ in range(columns)]
        line = b"\0" + bytes(cell for cell in cells for _ in range(DOT_TEXELS))
        lines += line * DOT_TEXELS
    header = struct.pack(">IIBBBBB", columns * DOT_TEXELS, rows * DOT_TEXELS, 8, 0, 0, 0, 0)
    parts = chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(lines, 9)) + chunk(b"IEND", b"")
    return b"\x89PNG\r\n\x1a\n" + parts


def corners(plane, middle, half):
    """A rectangle on a plane, counter-clockwise from the lower left as the camera sees it."""
    at_axis, to_right, down = plane
    points = []
    for across, up in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
        x, y = middle[0] + across * half[0], middle[1] + up * half[1]
        points.append((at_axis + to_right * x - down * y, -x, y))
    return "[" + ", ".join(f"({x:.5f}, {y:.5f}, {z:.5f})" for x, y, z in points) + "]"


def mesh(name, points, more):
    return f'''    def Mesh "{name}" (
        prepend apiSchemas = ["MaterialBindingAPI"]
    )
    {{
        uniform bool doubleSided = 1
        int[] faceVertexCounts = [4]
        int[] faceVertexIndices = [0, 1, 2, 3]
        point3f[] points = {points}
        uniform token subdivisionScheme = "none"
{more}    }}
'''


def scene():
    half = tuple(side / 2000 for side in BOARD_MM)
    board = mesh("Board", corners(BOARD, BOARD_MIDDLE, half), """        rel material:binding = </World/Looks/Dots>
        texCoord2f[] primvars:st = [(0, 0), (1, 0), (1, 1), (0, 1)] (
            interpolation = "vertex"
        )
""")
    wall = mesh("Wall", corners(WALL, (0, 0), WALL_HALF), """        rel material:binding = </World/Looks/Green>
""")
    return f'''#usda 1.0
(
    defaultPrim = "World"
    doc = "A board of dots before a plain wall, for an OAK at the origin that looks along +x. Metres, z up. Written by make_board.py."
    metersPerUnit = 1
    upAxis = "Z"
)

def Xform "World"
{{
{board}
{wall}
    def Scope "Looks"
    {{
        def Material "Green"
        {{
            token outputs:surface.connect = </World/Looks/Green/Surface.outputs:surface>

            def Shader "Surface"
            {{
                uniform token info:id = "UsdPreviewSurface"
                color3f inputs:diffuseColor = (0.06, 0.35, 0.22)
                float inputs:roughness = 0.9
                token outputs:surface
            }}
        }}

        def Material "Dots"
        {{
            token outputs:surface.connect = </World/Looks/Dots/Surface.outputs:surface>

            def Shader "Surface"
            {{
                uniform token info:id = "UsdPreviewSurface"
                color3f inputs:diffuseColor.connect = </World/Looks/Dots/Image.outputs:rgb>
                float inputs:roughness = 0.9
                token outputs:surface
            }}

            def Shader "Image"
            {{
                uniform token info:id = "UsdUVTexture"
                asset inputs:file = @./dots.png@
                token inputs:sourceColorSpace = "sRGB"
                float2 inputs:st.connect = </World/Looks/Dots/Coordinates.outputs:result>
                token inputs:wrapS = "clamp"
                token inputs:wrapT = "clamp"
                float3 outputs:rgb
            }}

            def Shader "Coordinates"
            {{
                uniform token info:id = "UsdPrimvarReader_float2"
                string inputs:varname = "st"
                float2 outputs:result
            }}
        }}
    }}
}}
'''


(HERE / "dots.png").write_bytes(dots())
(HERE / "board.usda").write_text(scene())
