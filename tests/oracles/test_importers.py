"""World-space triangles of glTF, OBJ, STL and PLY files, compared with trimesh."""

import json
import os
import subprocess
from pathlib import Path

import numpy as np
import pytest
import trimesh

# Both transform single-precision points in double precision.
TOLERANCE = 1e-5


@pytest.fixture(scope="session")
def dump(tmp_path_factory):
    """The triangles in the world, and the whole description, of a file."""
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
            triangles = array(mesh["triangles"])
            # A mirrored mesh is wound the other way.
            mirrored = np.linalg.det(matrix[:, :3]) < 0
            found.append(points[triangles[:, ::-1] if mirrored else triangles])
        return np.concatenate(found), scene

    return read


def assert_same(ours, theirs):
    """The same triangles in any order, each from any of its corners but with the same winding."""
    assert len(ours) == len(theirs)
    ours, theirs = np.asarray(ours, np.float64), np.asarray(theirs, np.float64)
    turned = np.stack([np.roll(theirs, turn, axis=1) for turn in range(3)])
    left = np.ones(len(theirs), bool)
    for triangle in ours:
        near = np.abs(turned - triangle).max(axis=(2, 3)).min(axis=0) < TOLERANCE
        twins = np.flatnonzero(near & left)
        assert len(twins), triangle
        left[twins[0]] = False


def theirs(path: Path):
    """The triangles that trimesh reads, in the world."""
    loaded = trimesh.load_scene(path, process=False)
    return np.concatenate([mesh.triangles for mesh in loaded.dump(concatenate=False)])


def lumpy(seed: int) -> trimesh.Trimesh:
    """A ball whose points are on a coarse binary grid: no rounding in any format changes them."""
    random = np.random.default_rng(seed)
    ball = trimesh.creation.icosphere(subdivisions=2)
    ball.vertices = np.round((ball.vertices * (1 + 0.2 * random.random((len(ball.vertices), 1)))) * 256) / 256
    return ball


def scene() -> trimesh.Scene:
    """Shared meshes under nodes that turn, move, mirror and scale."""
    built = trimesh.Scene()
    rotate = trimesh.transformations.rotation_matrix
    built.add_geometry(lumpy(1), node_name="a", geom_name="ball", transform=rotate(0.7, [1, 2, 3], [0.5, 0, 0]))
    mirror = np.diag([-2.0, 1.0, 0.5, 1.0])
    mirror[:3, 3] = [3, 2, 1]
    built.add_geometry(lumpy(2), node_name="b", geom_name="other", parent_node_name="a", transform=mirror)
    built.graph.update("c", "b", matrix=rotate(-1.1, [0, 1, 0]), geometry="ball")
    return built


@pytest.mark.parametrize("extension", ["glb", "gltf"])
def test_a_tree_of_nodes(dump, tmp_path, extension):
    if extension == "glb":
        path = tmp_path / "scene.glb"
        path.write_bytes(scene().export(file_type="glb"))
    else:
        for name, content in scene().export(file_type="gltf").items():
            (tmp_path / name).write_bytes(content)
        path = tmp_path / "model.gltf"
    ours, described = dump(path)
    assert_same(ours, theirs(path))
    assert described["up"] == [0, 1, 0]
    meshes = [instance["mesh"] for instance in described["instances"]]
    assert len(meshes) == 3 and len(set(meshes)) == 2


@pytest.mark.parametrize(
    ("name", "options"),
    [
        ("a.stl", {"file_type": "stl"}),
        ("a.stl", {"file_type": "stl_ascii"}),
        ("a.ply", {"file_type": "ply", "encoding": "binary"}),
        ("a.ply", {"file_type": "ply", "encoding": "ascii"}),
        ("a.obj", {"file_type": "obj"}),
        ("a.glb", {"file_type": "glb"}),
    ],
)
def test_one_mesh_in_every_format(dump, tmp_path, name, options):
    mesh = lumpy(3)
    content = mesh.export(**options)
    (tmp_path / name).write_bytes(content.encode() if isinstance(content, str) else content)
    ours, described = dump(tmp_path / name)
    assert_same(ours, mesh.triangles)
    assert_same(ours, theirs(tmp_path / name))
    # Shared points stay shared, and STL's points are shared again.
    assert described["meshes"][0]["positions"]["shape"][0] == len(mesh.vertices)


def test_objects_of_an_obj_file(dump, tmp_path):
    path = tmp_path / "two.obj"
    path.write_text(
        "o one\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n"
        "o two\nv 0 0 2\nv 1 0 2\nv 1 1 2\nvn 0 0 1\nf -3//1 -2//1 -1//1\nf 1 2 5\n"
    )
    ours, described = dump(path)
    assert_same(ours, theirs(path))
    assert [instance["path"] for instance in described["instances"]] == ["/one", "/two"]


def test_colours_of_points(dump, tmp_path):
    mesh = trimesh.creation.box()
    mesh.visual.vertex_colors = np.arange(32, dtype=np.uint8).reshape(8, 4) * 8
    path = tmp_path / "box.ply"
    path.write_bytes(mesh.export(file_type="ply"))
    ours, described = dump(path)
    assert_same(ours, mesh.triangles)
    assert described["meshes"][0]["colors"]["shape"] == [12, 9]


@pytest.mark.parametrize("extension", ["obj", "ply", "stl"])
def test_large_coordinates(dump, tmp_path, extension):
    """A survey in a national grid: single precision would move its points by up to 0.25 m."""
    mesh = lumpy(5)
    mesh.vertices += [499123.40625, 4649776.203125, 215.703125]
    # trimesh writes PLY and STL with fewer digits.
    if extension == "ply":
        header = f"ply\nformat ascii 1.0\nelement vertex {len(mesh.vertices)}\n"
        header += "".join(f"property double {axis}\n" for axis in "xyz")
        header += f"element face {len(mesh.faces)}\nproperty list uchar int vertex_indices\nend_header\n"
        points = "".join("{!r} {!r} {!r}\n".format(*point) for point in mesh.vertices.tolist())
        content = header + points + "".join("3 {} {} {}\n".format(*face) for face in mesh.faces)
    elif extension == "stl":
        content = "solid a\n"
        for triangle in mesh.triangles.tolist():
            corners = "".join("vertex {!r} {!r} {!r}\n".format(*corner) for corner in triangle)
            content += f"facet normal 0 0 0\nouter loop\n{corners}endloop\nendfacet\n"
        content += "endsolid a\n"
    else:
        content = mesh.export(file_type="obj", digits=9)
    path = tmp_path / f"a.{extension}"
    path.write_text(content)
    ours, _ = dump(path)
    assert_same(ours, mesh.triangles)
    assert_same(ours, theirs(path))


def test_a_hash_in_names(dump, tmp_path):
    (tmp_path / "a.mtl").write_text("newmtl Paint #25\nKd 1 0 0\nnewmtl Paint #26\nKd 0 0 1\n")
    path = tmp_path / "a.obj"
    path.write_text(
        "# two parts\nmtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 1 1 3\n"
        "o Nut#1\nusemtl Paint #25\nf 1 2 3\no Nut#2\nusemtl Paint #26\nf 1 2 4\n"
    )
    ours, described = dump(path)
    assert_same(ours, theirs(path))
    loaded = trimesh.load_scene(path, process=False, split_objects=True)
    assert {instance["path"][1:] for instance in described["instances"]} == {
        name.split("_")[0] for name in loaded.geometry
    }
    assert {material["name"] for material in described["materials"]} == {
        mesh.visual.material.name for mesh in loaded.geometry.values()
    }
