"""Heaps of generated data sets, as MuJoCo sees them: they stay where they are."""

import json
import math
import subprocess
from pathlib import Path

import mujoco
import numpy as np
import pytest

SIDES = 16
# The sizes and the centres of the boxes of a bin, metres.
BIN = [
    ((0.40, 0.30, 0.01), (0, 0, 0.005)),
    ((0.01, 0.30, 0.16), (-0.195, 0, 0.08)),
    ((0.01, 0.30, 0.16), (0.195, 0, 0.08)),
    ((0.40, 0.01, 0.16), (0, -0.145, 0.08)),
    ((0.40, 0.01, 0.16), (0, 0.145, 0.08)),
]
BLOCK = (0.05, 0.04, 0.03)
# Radius and height, from the middle of the bottom around the outside to the middle of the inside.
CAN = [(0, -0.04), (0.02, -0.04), (0.02, 0.04), (0, 0.04)]
CUP = [(0, -0.035), (0.035, -0.035), (0.04, 0.035), (0.035, 0.035), (0.03, -0.028), (0, -0.028)]
RECIPE = """
frames = {frames}
scene = 'bin.obj'
scene_options = {{ up = 'z' }}
[[objects]]
files = ['block.obj', 'can.obj', 'cup.obj']
up = 'z'
count = {count}
pose = 'piled'
region = {{ min = [-0.14, -0.09, 0.03], max = [0.14, 0.09, 0.3] }}
[camera]
resolution = [160, 100]
min_coverage = 0
look_at = [0, 0, 0.05]
sphere = {{ distance_m = 0.8, elevation_deg = 80 }}
"""


def corners(size: tuple, center: tuple = (0, 0, 0)) -> list:
    return [tuple(center[i] + size[i] * ((corner >> i & 1) - 0.5) for i in range(3)) for corner in range(8)]


def around(radius: float, height: float, sides: range) -> list:
    turns = [2 * math.pi * side / SIDES for side in sides]
    return [(radius * math.cos(turn), radius * math.sin(turn), height) for turn in turns]


def box_faces(sizes_and_centers: list) -> tuple:
    points, faces = [], []
    for size, center in sizes_and_centers:
        first = len(points)
        points += corners(size, center)
        sides = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
        faces += [tuple(first + corner for corner in side) for side in sides]
    return points, faces


def turned(profile: list) -> tuple:
    """A surface of revolution."""
    points, faces = [], []
    for radius, height in profile:
        points += around(radius, height, range(SIDES))
    for row in range(len(profile) - 1):
        for side in range(SIDES):
            a, b = row * SIDES + side, row * SIDES + (side + 1) % SIDES
            ring = [a, b, b + SIDES, a + SIDES]
            if profile[row][0] == 0:
                ring.remove(b)
            if profile[row + 1][0] == 0:
                ring.remove(b + SIDES)
            faces.append(ring)
    return points, faces


def write(path: Path, points: list, faces: list) -> None:
    lines = [f"v {x:.9f} {y:.9f} {z:.9f}" for x, y, z in points]
    lines += ["f " + " ".join(str(index + 1) for index in face) for face in faces]
    path.write_text("\n".join(lines) + "\n")


def write_files(folder: Path) -> None:
    write(folder / "bin.obj", *box_faces(BIN))
    write(folder / "block.obj", *box_faces([(BLOCK, (0, 0, 0))]))
    write(folder / "can.obj", *turned(CAN))
    write(folder / "cup.obj", *turned(CUP))


# The objects as unions of convex parts. The wall of the cup is divided at its sides.
WALL = [[point for radius, height in CUP[1:5] for point in around(radius, height, range(side, side + 2))] for side in range(SIDES)]
BOTTOM = [point for radius, height in (CUP[1], CUP[4]) for point in around(radius, height, range(SIDES))]
PARTS = {
    "block": [corners(BLOCK)],
    "can": [[point for radius, height in CAN[1:3] for point in around(radius, height, range(SIDES))]],
    "cup": [BOTTOM, *WALL],
}


@pytest.fixture(scope="module", params=[8, 30])
def heap(request: pytest.FixtureRequest, program: Path, tmp_path_factory: pytest.TempPathFactory) -> list:
    folder = tmp_path_factory.mktemp("heap")
    write_files(folder)
    (folder / "recipe.toml").write_text(RECIPE.format(frames=4, count=request.param))
    frames = []
    for frame in range(4):
        command = [program, "generate", folder / "recipe.toml", "--explain", str(frame)]
        answer = subprocess.run(command, check=True, capture_output=True)
        frames.append(json.loads(answer.stdout)["arrangement"]["objects"])
        assert len(frames[-1]) == request.param
    return frames


def model(objects: list) -> mujoco.MjModel:
    meshes, bodies = "", ""
    for label, parts in PARTS.items():
        for index, part in enumerate(parts):
            numbers = " ".join(f"{number:.9f}" for point in part for number in point)
            meshes += f'<mesh name="{label}{index}" vertex="{numbers}" inertia="convex"/>'
    for item in objects:
        x, y, z, w = item["world_from_object"]["orientation"]
        place = " ".join(map(str, item["world_from_object"]["position"]))
        geoms = "".join(f'<geom type="mesh" mesh="{item["label"]}{index}"/>' for index in range(len(PARTS[item["label"]])))
        bodies += f'<body pos="{place}" quat="{w} {x} {y} {z}"><freejoint/>{geoms}</body>'
    for size, center in BIN:
        half = " ".join(str(edge / 2) for edge in size)
        bodies += f'<geom type="box" size="{half}" pos="{" ".join(map(str, center))}"/>'
    text = f"""<mujoco><option timestep="0.002" cone="elliptic"/><size memory="500M"/>
      <default><geom density="1000" friction="0.5 0.005 0.0001"/></default>
      <asset>{meshes}</asset><worldbody>{bodies}</worldbody></mujoco>"""
    return mujoco.MjModel.from_xml_string(text)


def test_heaps_stay_where_they_are(heap: list) -> None:
    moved, depths = [], []
    for objects in heap:
        compiled = model(objects)
        data = mujoco.MjData(compiled)
        mujoco.mj_forward(compiled, data)
        depths.append(-min((contact.dist for contact in data.contact), default=0))
        start = data.xipos[1:].copy()
        mujoco.mj_step(compiled, data, nstep=500)
        moved += list(np.linalg.norm(data.xipos[1:] - start, axis=1))
    moved = np.array(moved)
    # Metres. Some objects lean on an edge or a rim, and MuJoCo has the exact walls of cups, which some objects enter.
    assert np.median(moved) < 2e-3
    assert np.mean(moved < 3e-3) > 0.8
    assert np.mean(moved < 5e-3) > 0.9
    assert max(depths) < 6e-3


def test_objects_are_inside_the_bin(heap: list) -> None:
    for objects in heap:
        for item in objects:
            x, y, z = item["world_from_object"]["position"]
            # Half the thickness of a block lies between its centre and a wall, less half a millimetre.
            assert abs(x) < 0.19 - 0.0145 and abs(y) < 0.14 - 0.0145 and z > 0.01 + 0.0145, item["path"]
