"""World-space triangles and materials of Collada files, compared with pycollada through trimesh, and robots that wear them with yourdfpy."""

import json
import os
import subprocess
from pathlib import Path

import numpy as np
import pytest
import trimesh
import yourdfpy

TOLERANCE = 1e-5


@pytest.fixture(scope="session")
def dump(tmp_path_factory):
    """The triangles in the world, in metres, and the whole description, of a file."""
    named = os.environ.get("OAKTWIN_SCENE_DUMP")
    if not named:
        pytest.skip("OAKTWIN_SCENE_DUMP names no program: run by cargo xtask test")

    def read(path: Path):
        folder = tmp_path_factory.mktemp("dump")
        subprocess.run([named, path, folder], check=True)
        scene = json.loads((folder / "scene.json").read_text())
        data = (folder / "arrays.bin").read_bytes()

        def array(where):
            count = int(np.prod(where["shape"]))
            return np.frombuffer(data, where["dtype"], count, where["offset"]).reshape(where["shape"])

        found = []
        for instance in scene["instances"]:
            mesh = scene["meshes"][instance["mesh"]]
            matrix = np.array(instance["world_from_mesh"])
            points = array(mesh["positions"]).astype(np.float64) @ matrix[:, :3].T + matrix[:, 3]
            found.append(points[array(mesh["triangles"])])
        return np.concatenate(found), scene

    return read


def theirs(path: Path, meters: float) -> np.ndarray:
    """The triangles that trimesh reads, which leaves the unit to its caller."""
    loaded = trimesh.load_scene(path, process=False)
    return meters * np.concatenate(
        [
            trimesh.transform_points(
                loaded.geometry[loaded.graph[node][1]].vertices, loaded.graph[node][0]
            )[loaded.geometry[loaded.graph[node][1]].faces]
            for node in loaded.graph.nodes_geometry
        ]
    )


def assert_same(ours: np.ndarray, theirs: np.ndarray) -> None:
    """The same triangles in any order; each may begin at any of its corners."""
    assert len(ours) == len(theirs)
    turned = np.stack([np.roll(theirs, turn, axis=1) for turn in range(3)])
    left = np.ones(len(theirs), bool)
    for triangle in ours:
        near = np.abs(turned - triangle).max(axis=(2, 3)).min(axis=0) < TOLERANCE
        twins = np.flatnonzero(near & left)
        assert len(twins), triangle
        left[twins[0]] = False


def numbers(values) -> str:
    return " ".join(repr(float(x)) for x in np.asarray(values).ravel())


def source(name: str, values: np.ndarray, params: str) -> str:
    return f"""<source id="{name}"><float_array id="{name}-array" count="{values.size}">{numbers(values)}</float_array>
      <technique_common><accessor source="#{name}-array" count="{len(values)}" stride="{values.shape[1]}">
      {"".join(f'<param name="{p}" type="float"/>' for p in params)}</accessor></technique_common></source>"""


def geometry(name: str, random: np.random.Generator, kind: str) -> str:
    """A lumpy ball, of which a part has another material and polygons with more corners."""
    ball = trimesh.creation.icosphere(subdivisions=1)
    points = ball.vertices * (1 + 0.2 * random.random((len(ball.vertices), 1)))
    points = np.round(points * 256) / 256
    inputs = f"""<input semantic="VERTEX" source="#{name}-vertices" offset="1"/>
      <input semantic="NORMAL" source="#{name}-normals" offset="0"/>"""
    half = len(ball.faces) // 2
    first, second = ball.faces[:half], ball.faces[half:]

    def corners(faces):
        return np.stack([np.zeros_like(faces), faces], axis=-1).ravel().tolist()

    shown = " ".join(map(str, corners(first)))
    if kind == "triangles":
        body = f'<triangles material="A" count="{half}">{inputs}<p>{shown}</p></triangles>'
    elif kind == "polylist":
        body = f'<polylist material="A" count="{half}">{inputs}<vcount>{"3 " * half}</vcount><p>{shown}</p></polylist>'
    else:
        each = "".join(f"<p>{' '.join(map(str, corners(face)))}</p>" for face in first)
        body = f'<polygons material="A" count="{half}">{inputs}{each}</polygons>'
    rest = " ".join(map(str, corners(second)))
    # Two neighbours as a polygon with four corners, which both divide from the first one.
    a, b, c = ball.faces[0]
    (d,) = next(set(face) - {b, c} for face in ball.faces[1:] if b in face and c in face)
    quad = f"0 {a} 0 {b} 0 {d} 0 {c}"
    return f"""<geometry id="{name}"><mesh>
      {source(f"{name}-points", points, "XYZ")}{source(f"{name}-normals", np.array([[0.0, 0.0, 1.0]]), "XYZ")}
      <vertices id="{name}-vertices"><input semantic="POSITION" source="#{name}-points"/></vertices>
      {body}<triangles material="B" count="{len(second)}">{inputs}<p>{rest}</p></triangles>
      <polylist material="B" count="1">{inputs}<vcount>4</vcount><p>{quad}</p></polylist></mesh></geometry>"""


COLORS = {"red": (0.8, 0.25, 0.1), "blue": (0.1, 0.3, 0.9)}
MATERIALS = "".join(
    f"""<effect id="{name}-effect"><profile_COMMON><technique sid="common"><phong><diffuse><color>{numbers(color)} 1</color></diffuse>
    </phong></technique></profile_COMMON></effect>"""
    for name, color in COLORS.items()
)
BIND = """<bind_material><technique_common><instance_material symbol="A" target="#red"/>
  <instance_material symbol="B" target="#blue"/></technique_common></bind_material>"""


def document(seed: int, kind: str) -> str:
    """Nodes with transforms of all kinds, in a random order, and a node that two others instance."""
    random = np.random.default_rng(seed)
    # pycollada takes the axis as it is, even if it is no unit vector.
    axis = random.standard_normal(3)
    axis /= np.linalg.norm(axis)
    matrix = np.eye(4)
    matrix[:3] += 0.3 * random.standard_normal((3, 4))
    transforms = [
        f"<translate>{numbers(random.standard_normal(3))}</translate>",
        f"<rotate>{numbers(axis)} {random.uniform(-200, 200)}</rotate>",
        f"<scale>{numbers(random.uniform(0.5, 2, 3))}</scale>",
        f"<matrix>{numbers(matrix)}</matrix>",
        f"<rotate>1 0 0 {random.uniform(-90, 90)}</rotate>",
    ]

    def some() -> str:
        return "".join(random.permutation(transforms)[: random.integers(1, 6)])

    def ball(name: str) -> str:
        return f'<instance_geometry url="#{name}">{BIND}</instance_geometry>'

    materials = "".join(
        f'<material id="{name}" name="{name}"><instance_effect url="#{name}-effect"/></material>' for name in COLORS
    )
    return f"""<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
  <asset><unit meter="0.0254" name="inch"/><up_axis>Z_UP</up_axis></asset>
  <library_effects>{MATERIALS}</library_effects><library_materials>{materials}</library_materials>
  <library_geometries>{geometry("one", random, kind)}{geometry("two", random, kind)}</library_geometries>
  <library_nodes><node id="shared">{some()}{ball("one")}<node id="inner">{some()}{ball("two")}</node></node></library_nodes>
  <library_visual_scenes><visual_scene id="scene">
    <node id="a">{some()}{ball("two")}<node id="b">{some()}<instance_node url="#shared"/></node></node>
    <node id="c">{some()}<instance_node url="#shared"/></node>
  </visual_scene></library_visual_scenes>
  <scene><instance_visual_scene url="#scene"/></scene>
</COLLADA>"""


@pytest.mark.parametrize("kind", ["triangles", "polylist", "polygons"])
@pytest.mark.parametrize("seed", range(4))
def test_nodes_place_the_same_triangles(dump, tmp_path, seed, kind):
    path = tmp_path / "a.dae"
    path.write_text(document(seed, kind))
    ours, described = dump(path)
    assert_same(ours, theirs(path, 0.0254))
    assert described["up"] == [0, 0, 1]
    assert len(described["instances"]) == 5


def test_a_file_of_pycollada(dump, tmp_path):
    ball = trimesh.creation.icosphere(subdivisions=1)
    path = tmp_path / "ball.dae"
    path.write_bytes(trimesh.exchange.dae.export_collada(ball))
    ours, _ = dump(path)
    assert_same(ours, ball.triangles)
    assert_same(ours, theirs(path, 1.0))


def test_materials_have_the_same_colours(dump, tmp_path):
    path = tmp_path / "a.dae"
    path.write_text(document(0, "triangles"))
    _, described = dump(path)
    loaded = trimesh.load_scene(path, process=False)
    shown = {tuple(np.round(mesh.visual.material.main_color[:3] / 255, 2)) for mesh in loaded.geometry.values()}
    linear = [np.array(material["base_color"]) for material in described["materials"]]
    srgb = [np.where(c <= 0.0031308, 12.92 * c, 1.055 * c ** (1 / 2.4) - 0.055) for c in linear]
    assert {tuple(np.round(color, 2)) for color in srgb} == shown == {tuple(np.round(c, 2)) for c in COLORS.values()}


def test_a_robot_wears_it_where_yourdfpy_shows_it(program: Path, tmp_path: Path) -> None:
    """The ray through the middle of the image meets the mesh of a link where a ray of trimesh does, in a file whose up axis is y."""
    random = np.random.default_rng(7)
    slab = trimesh.creation.box(extents=[0.6, 0.5, 0.3])
    slab.vertices += 0.02 * random.standard_normal(slab.vertices.shape)
    (tmp_path / "slab.dae").write_bytes(trimesh.exchange.dae.export_collada(slab))
    text = (tmp_path / "slab.dae").read_text()
    assert "Y_UP" in text
    (tmp_path / "slab.urdf").write_text(
        """<robot name="slab"><link name="base"><visual><origin xyz="0.1 -0.2 0.3" rpy="0.4 0.5 -0.6"/>
        <geometry><mesh filename="slab.dae" scale="2 1 1.5"/></geometry></visual></link></robot>"""
    )
    (tmp_path / "floor.usda").write_text(
        '#usda 1.0\n(\n upAxis = "Z"\n metersPerUnit = 1\n)\ndef Cube "Floor"\n{\n double3 xformOp:translate = (0, 0, -20)\n'
        ' uniform token[] xformOpOrder = ["xformOp:translate"]\n}\n'
    )
    subprocess.run(
        [
            program, "render", "floor.usda", "--robot", "slab.urdf", "--model", "OAK-D-Lite", "--camera", "left",
            "--look-at", "2", "1.5", "1", "0.1", "-0.2", "0.3", "--resolution", "64x48",
            "--annotators", "distance_to_camera,camera_params", "-o", "out",
        ],
        check=True, cwd=tmp_path, capture_output=True,
    )  # fmt: skip
    (range_file,) = (tmp_path / "out").rglob("distance_to_camera*.npy")
    (camera_file,) = (tmp_path / "out").rglob("camera_params*.json")
    range_m = np.load(range_file)
    camera = json.loads(camera_file.read_text())
    world_from_usd = np.linalg.inv(np.array(camera["cameraViewTransform"]).reshape(4, 4).T)
    projection = np.array(camera["cameraProjection"]).reshape(4, 4)
    height, width = range_m.shape
    x, y = np.meshgrid((np.arange(width) + 0.5) / width * 2 - 1, 1 - (np.arange(height) + 0.5) / height * 2)
    x, y = (x + projection[2, 0]) / projection[0, 0], (y + projection[2, 1]) / projection[1, 1]
    rays = np.stack([x, y, np.full_like(x, -1)], axis=-1).reshape(-1, 3)
    rays = (rays / np.linalg.norm(rays, axis=-1, keepdims=True)) @ world_from_usd[:3, :3].T
    model = yourdfpy.URDF.load(str(tmp_path / "slab.urdf"))
    shape = model.scene.to_geometry()
    eye = world_from_usd[:3, 3]
    points, index, _ = shape.ray.intersects_location(np.tile(eye, (len(rays), 1)), rays, multiple_hits=False)
    expected = np.full(len(rays), np.inf)
    np.minimum.at(expected, index, np.linalg.norm(points - eye, axis=-1))
    expected = expected.reshape(range_m.shape)
    hit = np.isfinite(expected)
    assert 0.02 < hit.mean() < 0.9
    off = hit != np.isfinite(range_m)
    off[hit] |= np.abs(range_m[hit] - expected[hit]) > 1e-4
    assert off.mean() < 0.005, off.mean()
