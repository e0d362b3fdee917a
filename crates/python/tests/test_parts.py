"""Scenes of several meshes: poses, colours, labels, materials, pickles and USD files."""

import pickle
import threading

import numpy as np
import pytest

import oaktwin
from open3d_import import open3d

CAMERA = oaktwin.Camera((160, 120), hfov_deg=70)
EYE = oaktwin.look_at((0, -4, 1), (0, 0, 0.5))


def box(width, depth, height):
    """The vertices and faces of a box around the origin."""
    corners = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], np.float32)
    faces = [[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1], [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4],
             [1, 5, 7], [1, 7, 3]]
    return corners * np.array([width, depth, height], np.float32) / 2, np.array(faces)


def pose(x=0.0, y=0.0, z=0.0, turn=0.0):
    matrix = np.eye(4)
    matrix[:2, :2] = [[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]]
    matrix[:3, 3] = x, y, z
    return matrix


def arm(**options):
    link = oaktwin.Mesh(*box(0.2, 0.2, 1.0), color=(0.8, 0.1, 0.1), roughness=0.3)
    ground = oaktwin.Mesh(*box(6, 6, 0.1), color=np.array([90, 90, 90], np.uint8))
    meshes = {"ground": ground, "arm/link_1": link, "arm/link_2": link}
    poses = {"arm/link_1": pose(z=0.5), "arm/link_2": pose(x=0.7, z=0.5, turn=0.4)}
    return oaktwin.Scene.from_meshes(meshes, poses=poses, labels={"ground": "floor", "arm/link_1": "arm"}, **options)


def seen(scene, backend="auto"):
    names = ["distance_to_image_plane", "rgb", "normals", "instance_id_segmentation", "semantic_segmentation"]
    return scene.render(CAMERA, EYE, annotators=names, backend=backend)


def equal(a, b):
    return all(np.array_equal(a[name], b[name]) for name in a if isinstance(a[name], np.ndarray))


def test_poses_agree_with_open3d():
    try:
        o3d = open3d()
    except ImportError as error:
        pytest.skip(f"Open3D cannot be imported: {error}")
    scene = arm()
    scene.set_pose("arm/link_2", pose(x=-0.4, y=0.3, z=0.7, turn=1.1))
    rays = o3d.t.geometry.RaycastingScene()
    for name, (vertices, faces) in {"ground": box(6, 6, 0.1), "arm/link_1": box(0.2, 0.2, 1), "arm/link_2": box(0.2, 0.2, 1)}.items():
        place = scene.poses["/World/" + name]
        world = (vertices @ place[:3, :3].T + place[:3, 3]).astype(np.float32)
        rays.add_triangles(o3d.core.Tensor(world), o3d.core.Tensor(faces.astype(np.uint32)))
    directions = CAMERA.rays() @ EYE[:3, :3].T.astype(np.float32)
    origins = np.broadcast_to(EYE[:3, 3].astype(np.float32), directions.shape)
    hit = rays.cast_rays(o3d.core.Tensor(np.concatenate([origins, directions], -1).astype(np.float32)))
    z = hit["t_hit"].numpy() * CAMERA.rays()[..., 2]
    own = seen(scene)["distance_to_image_plane"]
    both = np.isfinite(own) & np.isfinite(z)
    assert np.mean(np.isfinite(own) == np.isfinite(z)) > 0.999 and np.mean(np.abs(own - z)[both] < 1e-4) > 0.999


@pytest.mark.parametrize("backend", ["raster", "ray"])
def test_a_moved_part_looks_as_if_it_had_always_been_there(backend):
    moving, place = arm(), pose(x=-0.9, y=-0.5, z=0.8, turn=2.0)
    before = seen(moving, backend)
    moving.set_pose("arm/link_1", place)
    after = seen(moving, backend)
    meshes = {"ground": oaktwin.Mesh(*box(6, 6, 0.1), color=np.array([90, 90, 90], np.uint8)),
              "arm/link_1": oaktwin.Mesh(*box(0.2, 0.2, 1.0), color=(0.8, 0.1, 0.1), roughness=0.3)}
    meshes["arm/link_2"] = meshes["arm/link_1"]
    poses = {"arm/link_1": place, "arm/link_2": pose(x=0.7, z=0.5, turn=0.4)}
    fresh = oaktwin.Scene.from_meshes(meshes, poses=poses, labels={"ground": "floor", "arm/link_1": "arm"})
    assert equal(after, seen(fresh, backend)) and not equal(after, before)
    assert np.array_equal(moving.poses["/World/arm/link_1"], place)
    moving.set_poses({"arm/link_1": pose(z=0.5)})
    assert equal(seen(moving, backend), before)


def test_colours_labels_and_ids():
    images = seen(arm())
    paths = images["instance_id_segmentation_prim_paths"]
    assert set(paths.values()) >= {"/World/ground", "/World/arm/link_1", "/World/arm/link_2"}
    of = {path: images["instance_id_segmentation"] == number for number, path in paths.items()}
    red, grey = images["rgb"][of["/World/arm/link_1"]][:, :3], images["rgb"][of["/World/ground"]][:, :3]
    # Outlines are mixed with what is behind them.
    (r, g, _), grey = np.median(red, axis=0), np.median(grey, axis=0)
    assert r > 3 * g and np.ptp(grey) <= 12
    labels = images["semantic_segmentation_labels"]
    ids = {str(label): images["semantic_segmentation"] == number for number, label in labels.items()}
    floor = [mask for label, mask in ids.items() if "floor" in label]
    assert len(floor) == 1 and np.array_equal(floor[0], of["/World/ground"])


def test_textures_and_vertex_colours(tmp_path):
    vertices = np.array([[-2, 0, -1], [2, 0, -1], [2, 0, 2], [-2, 0, 2]], np.float32)
    faces, uvs = np.array([[0, 1, 2], [0, 2, 3]]), [[0, 0], [1, 0], [1, 1], [0, 1]]
    image = np.zeros((8, 8, 3), np.uint8)
    image[:, :4], image[:, 4:] = (250, 20, 20), (20, 20, 250)
    wall = oaktwin.Scene.from_meshes({"wall": oaktwin.Mesh(vertices, faces, uvs=uvs, texture=image)})
    rgb = wall.render(CAMERA, EYE, annotators=["rgb"])["rgb"].astype(int)
    assert rgb[60, 30, 0] > 2 * rgb[60, 30, 2] and rgb[60, 130, 2] > 2 * rgb[60, 130, 0]
    each = oaktwin.Mesh(vertices, faces, color=[[1, 0, 0], [0, 0, 1], [0, 0, 1], [1, 0, 0]])
    rgb = oaktwin.Scene.from_meshes({"wall": each}).render(CAMERA, EYE, annotators=["rgb"])["rgb"].astype(int)
    assert rgb[60, 35, 0] > 1.5 * rgb[60, 35, 2] and rgb[60, 125, 2] > 1.5 * rgb[60, 125, 0]
    cv2 = pytest.importorskip("cv2")
    cv2.imwrite(str(tmp_path / "a.png"), image[..., ::-1])
    other = oaktwin.Scene.from_meshes({"wall": oaktwin.Mesh(vertices, faces, uvs=uvs, texture=tmp_path / "a.png")})
    assert np.array_equal(wall.render(CAMERA, EYE, annotators=["rgb"])["rgb"], other.render(CAMERA, EYE, annotators=["rgb"])["rgb"])


def test_pickles_keep_poses(tmp_path):
    scene = arm(up="y")
    scene.set_pose("arm/link_2", pose(x=-0.4, z=0.9))
    again = pickle.loads(pickle.dumps(scene))
    assert again.up == "y" and equal(seen(again), seen(scene)) and repr(again) == repr(scene)
    (tmp_path / "a.obj").write_text("o a\nv -1 0 0\nv 1 0 0\nv 0 0 1\nf 1 2 3\no b\nv -1 1 0\nv 1 1 0\nv 0 1 2\nf 4 5 6\n")
    opened = oaktwin.Scene.open(tmp_path / "a.obj", up="z", scale=0.5)
    untouched = pickle.loads(pickle.dumps(opened))
    assert equal(seen(untouched), seen(opened))
    assert np.array_equal(opened.poses["/a"], np.eye(4))
    opened.set_pose("/a", pose(y=0.2, z=0.3))
    again = pickle.loads(pickle.dumps(opened))
    assert equal(seen(again), seen(opened)) and not equal(seen(again), seen(untouched))
    # The scale of the file stays.
    assert np.allclose(np.ptp(oaktwin.Scene.open(tmp_path / "a.obj", scale=0.5).bounds, axis=0)[0], 1)


def test_usd_files_are_opens_and_openusds(tmp_path):
    scene = arm()
    scene.set_pose("arm/link_2", pose(x=-0.4, y=0.3, z=0.9, turn=0.3))
    scene.save_usd(tmp_path / "arm.usda")
    again = oaktwin.Scene.open(tmp_path / "arm.usda")
    ours, theirs = seen(scene), seen(again)
    assert not again.findings and np.array_equal(ours["rgb"], theirs["rgb"])
    assert np.array_equal(ours["distance_to_image_plane"], theirs["distance_to_image_plane"])
    assert ours["semantic_segmentation_labels"] == theirs["semantic_segmentation_labels"]
    with pytest.raises(oaktwin.Error, match=r"text format; use a name that ends in \.usda"):
        scene.save_usd(tmp_path / "arm.usdz")
    scene.save_usd(tmp_path / "new/arm.usda")
    assert (tmp_path / "new/arm.usda").read_bytes() == (tmp_path / "arm.usda").read_bytes()
    with pytest.raises(OSError, match="arm.usda"):
        scene.save_usd(tmp_path / "arm.usda/arm.usda")
    Usd = pytest.importorskip("pxr.Usd")
    from pxr import UsdGeom, UsdShade

    stage = Usd.Stage.Open(str(tmp_path / "arm.usda"))
    assert UsdGeom.GetStageUpAxis(stage) == "Z" and UsdGeom.GetStageMetersPerUnit(stage) == 1
    cache = UsdGeom.XformCache()
    for path, place in scene.poses.items():
        prim = stage.GetPrimAtPath(path)
        assert np.allclose(np.array(cache.GetLocalToWorldTransform(prim)).T, place, atol=1e-12)
        mesh, vertices = UsdGeom.Mesh(prim), box(*(0.2, 0.2, 1) if "link" in path else (6, 6, 0.1))
        assert np.array_equal(mesh.GetPointsAttr().Get(), vertices[0])
        material, _ = UsdShade.MaterialBindingAPI(prim).ComputeBoundMaterial()
        shader, *_ = material.ComputeSurfaceSource()
        assert shader.GetIdAttr().Get() == "UsdPreviewSurface"


def test_parts_move_while_others_render():
    scene, places = arm(), [pose(x=0.1 * i, z=0.5) for i in range(8)]
    expected = set()
    for place in places:
        scene.set_pose("arm/link_2", place)
        expected.add(scene.render(CAMERA, EYE, backend="ray")["distance_to_image_plane"].tobytes())
    found, stop = set(), threading.Event()

    def render():
        while not stop.is_set():
            found.add(scene.render(CAMERA, EYE, backend="ray")["distance_to_image_plane"].tobytes())

    threads = [threading.Thread(target=render) for _ in range(3)]
    for thread in threads:
        thread.start()
    for place in places * 5:
        scene.set_pose("arm/link_2", place)
    stop.set()
    for thread in threads:
        thread.join()
    assert found and found <= expected


def test_pairs_of_a_still_scene_equal_those_of_a_new_one():
    """The light of a pair is kept while nothing moves; what changes between two calls must not be kept."""
    scene, device = arm(), oaktwin.Device("OAK-D Pro PoE")
    bodies = [oaktwin.look_at((0, -2, 1), (x, 0, 0.5), frame="body") for x in (0, 0.2)]
    steps = [
        (bodies[0], {"frame": 0}), (bodies[0], {"frame": 1}), (bodies[0], {"frame": 1, "seed": 5}),
        (bodies[0], {"imager": {"autoExposure": False, "exposure": 0.3}}), (bodies[0], {"projector": 1.0}), (bodies[0], {"ambient": 0.1}),
        (bodies[1], {}), (bodies[0], {"size": (80, 50)}), (bodies[0], {"device_seed": 3}), (bodies[0], {"drift": {"pitch": 4}}), (bodies[0], {}),
    ]

    def check(fresh):
        for body, options in steps:
            options = {"size": (160, 100), "frame": 0, **options}
            kept, new = (one.render_pair(device, body, **options) for one in (scene, fresh()))
            assert equal(kept, new), options

    check(arm)
    moved, version = pose(x=-0.4, y=0.3, z=0.7), scene.version
    assert scene.version == version
    scene.set_pose("arm/link_2", moved)
    assert scene.version != version

    def fresh():
        other = arm()
        other.set_pose("arm/link_2", moved)
        return other

    check(fresh)
    frames = [scene.render_pair(device, bodies[0], size=(160, 100), frame=frame)["left"] for frame in (0, 1)]
    assert not np.array_equal(*frames)


def test_errors_name_the_argument():
    vertices, faces = box(1, 1, 1)
    link, scene = oaktwin.Mesh(vertices, faces), arm()
    cases = {
        "arm/link_3: the scene has no such part; did you mean": lambda: scene.set_pose("arm/link_3", np.eye(4)),
        "world_from_part: the 3x3 part is not a rotation": lambda: scene.set_pose("ground", np.diag([2, 1, 1, 1])),
        "lnk: there is no mesh of this name; did you mean 'link'": lambda: oaktwin.Scene.from_meshes({"link": link}, poses={"lnk": np.eye(4)}),
        "poses: link: has shape": lambda: oaktwin.Scene.from_meshes({"link": link}, poses={"link": np.eye(3)}),
        "the value of a is not a mesh": lambda: oaktwin.Scene.from_meshes({"a": vertices}),
        "meshes: is not a mapping": lambda: oaktwin.Scene.from_meshes([link]),
        "a//b: is not a valid name": lambda: oaktwin.Scene.from_meshes({"a//b": link}),
        "/World/a: appears twice": lambda: oaktwin.Scene.from_meshes({"a": link, "/World/a": link}),
        r"color: has shape \[2, 3\]": lambda: oaktwin.Mesh(vertices, faces, color=[[0, 0, 0]] * 2),
        "color: contains values out of range": lambda: oaktwin.Mesh(vertices, faces, color=(255, 0, 0)),
        "uvs: has shape": lambda: oaktwin.Mesh(vertices, faces, uvs=np.zeros((8, 3))),
        "texture: requires texture coordinates": lambda: oaktwin.Mesh(vertices, faces, texture=np.zeros((4, 4, 3), np.uint8)),
        "texture: .* does not exist": lambda: oaktwin.Mesh(vertices, faces, uvs=np.zeros((8, 2)), texture="none.png"),
        "roughness: 2 is out of range": lambda: oaktwin.Mesh(vertices, faces, roughness=2),
        "emissive: contains values out of range": lambda: oaktwin.Mesh(vertices, faces, emissive=-1),
    }
    for text, call in cases.items():
        with pytest.raises(oaktwin.Error, match=text):
            call()
    before = scene.poses["/World/ground"]
    with pytest.raises(oaktwin.Error):
        scene.set_poses({"ground": pose(x=1), "none": np.eye(4)})
    assert np.array_equal(scene.poses["/World/ground"], before)
