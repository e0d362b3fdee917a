"""Writes the objects and the table of the example recipes as USD text files.

    python make_objects.py

Objects stand on z = 0 and are in metres. Every file is small enough to read.
"""

import math
from pathlib import Path

HERE = Path(__file__).resolve().parent
HEADER = '#usda 1.0\n(\n    defaultPrim = "{name}"\n    metersPerUnit = 1\n    upAxis = "Z"\n)\n'


def tuples(values):
    return "[" + ", ".join("(" + ", ".join(f"{x:.5g}" for x in value) + ")" for value in values) + "]"


def numbers(values):
    return "[" + ", ".join(str(value) for value in values) + "]"


def mesh(name, points, faces, color, uvs=None):
    """A polygon mesh; uvs has a coordinate for each corner of each face."""
    st = ""
    if uvs:
        st = f'    texCoord2f[] primvars:st = {tuples(uvs)} (interpolation = "faceVarying")\n'
    return (
        f'def Mesh "{name}"\n{{\n'
        f"    float3[] extent = {tuples([[f(p[i] for p in points) for i in range(3)] for f in (min, max)])}\n"
        f"    point3f[] points = {tuples(points)}\n"
        f"    int[] faceVertexCounts = {numbers(len(face) for face in faces)}\n"
        f"    int[] faceVertexIndices = {numbers(index for face in faces for index in face)}\n"
        f'    uniform token subdivisionScheme = "none"\n'
        f'    color3f[] primvars:displayColor = {tuples([color])} (interpolation = "constant")\n{st}}}\n'
    )


def lathe(name, profile, color, sides=40):
    """A surface of revolution around z from (radius, height) pairs, closed where the radius is 0."""
    points, rings = [], []
    for radius, height in profile:
        if radius == 0:
            rings.append([len(points)])
            points.append((0, 0, height))
            continue
        rings.append(list(range(len(points), len(points) + sides)))
        turn = [2 * math.pi * side / sides for side in range(sides)]
        points += [(radius * math.cos(angle), radius * math.sin(angle), height) for angle in turn]
    faces, uvs = [], []
    for row, (lower, upper) in enumerate(zip(rings, rings[1:])):
        for side in range(sides):
            after = (side + 1) % sides
            v = [row / (len(rings) - 1), (row + 1) / (len(rings) - 1)]
            u = [side / sides, (side + 1) / sides]
            if len(lower) == 1:
                faces.append([lower[0], upper[after], upper[side]])
                uvs += [(u[0], v[0]), (u[1], v[1]), (u[0], v[1])]
            elif len(upper) == 1:
                faces.append([lower[side], lower[after], upper[0]])
                uvs += [(u[0], v[0]), (u[1], v[0]), (u[0], v[1])]
            else:
                faces.append([lower[side], lower[after], upper[after], upper[side]])
                uvs += [(u[0], v[0]), (u[1], v[0]), (u[1], v[1]), (u[0], v[1])]
    return mesh(name, points, faces, color, uvs)


def box(name, size, color, center=(0, 0, 0.5)):
    """A box; center is in units of its size."""
    points = [
        tuple(size[axis] * ((corner >> axis & 1) - 0.5 + center[axis]) for axis in range(3)) for corner in range(8)
    ]
    faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
    return mesh(name, points, faces, color, [(0, 0), (1, 0), (1, 1), (0, 1)] * 6)


def xform(name, children, labels=None):
    body = "".join("    " + line + "\n" for child in children for line in child.splitlines())
    schema = ""
    if labels:
        schema = ' (\n    prepend apiSchemas = ["SemanticsLabelsAPI:class"]\n)'
        body = f'    token[] semantics:labels:class = ["{labels}"]\n' + body
    return f'def Xform "{name}"{schema}\n{{\n{body}}}\n'


def write(path, name, *children):
    (HERE / path).write_text(HEADER.format(name=name) + xform(name, children))


def handle(color):
    """A bent tube: the handle of the mug."""
    points, faces = [], []
    steps, sides, radius = 14, 8, 0.006
    for step in range(steps + 1):
        angle = math.pi * (step / steps - 0.5)
        out, up = math.cos(angle), math.sin(angle)
        for side in range(sides):
            turn = 2 * math.pi * side / sides
            reach = 0.025 + radius * math.cos(turn)
            points.append((0.036 + reach * out, radius * math.sin(turn), 0.048 + 1.2 * reach * up))
    for step in range(steps):
        for side in range(sides):
            a, b = step * sides + side, step * sides + (side + 1) % sides
            faces.append([a, b, b + sides, a + sides])
    return mesh("Handle", points, faces, color)


def main():
    (HERE / "objects").mkdir(exist_ok=True)
    blue, red, white, green, brown = (0.1, 0.2, 0.5), (0.6, 0.08, 0.06), (0.75, 0.74, 0.7), (0.15, 0.4, 0.15), (0.4, 0.25, 0.12)
    mug = [(0, 0), (0.036, 0), (0.04, 0.004), (0.04, 0.095), (0.036, 0.095), (0.036, 0.008), (0, 0.008)]
    write("objects/mug.usda", "Mug", lathe("Cup", mug, blue), handle(blue))
    can = [(0, 0), (0.031, 0), (0.033, 0.004), (0.033, 0.111), (0.031, 0.115), (0, 0.115)]
    write("objects/can.usda", "Can", lathe("Body", can, red))
    bowl = [(0, 0), (0.03, 0), (0.05, 0.015), (0.068, 0.05), (0.065, 0.05), (0.047, 0.018), (0, 0.006)]
    write("objects/bowl.usda", "Bowl", lathe("Body", bowl, white))
    bottle = [(0, 0), (0.034, 0), (0.036, 0.01), (0.036, 0.13), (0.014, 0.175), (0.014, 0.21), (0, 0.21)]
    write("objects/bottle.usda", "Bottle", lathe("Body", bottle, green))
    write("objects/carton.usda", "Carton", box("Body", (0.16, 0.06, 0.21), brown))
    write("objects/block.usda", "Block", box("Body", (0.05, 0.05, 0.05), red))

    wood, grey, wall = (0.42, 0.3, 0.18), (0.35, 0.35, 0.36), (0.6, 0.6, 0.57)
    legs = [
        box(f"Leg_{index}", (0.05, 0.05, 0.7), wood, (x, y, 0.5))
        for index, (x, y) in enumerate([(-10.5, -6.5), (10.5, -6.5), (10.5, 6.5), (-10.5, 6.5)])
    ]
    top = box("Top", (1.2, 0.8, 0.04), wood, (0, 0, 18))
    room = [
        xform("Table", [top, *legs], "table"),
        xform("Floor", [box("Slab", (6, 6, 0.02), grey, (0, 0, -0.5))], "floor"),
        xform("Wall", [box("Slab", (6, 0.02, 2.5), wall, (0, 150, 0.5))], "wall"),
    ]
    write("table.usda", "World", *room)

    sides = [
        box("Bottom", (0.6, 0.4, 0.01), grey, (0, 0, 0.5)),
        box("Left", (0.01, 0.4, 0.22), grey, (-29.5, 0, 0.5)),
        box("Right", (0.01, 0.4, 0.22), grey, (29.5, 0, 0.5)),
        box("Front", (0.6, 0.01, 0.22), grey, (0, -19.5, 0.5)),
        box("Back", (0.6, 0.01, 0.22), grey, (0, 19.5, 0.5)),
    ]
    floor = xform("Floor", [box("Slab", (3, 3, 0.02), wall, (0, 0, -0.5))], "floor")
    write("bin.usda", "World", xform("Bin", sides, "bin"), floor)


main()
