import pickle

import numpy as np
import pytest

import oaktwin
from conftest import ROOT

WALL = np.array([[-50, -50, 3], [50, -50, 3], [0, 80, 3]])
EYE = np.eye(4)


@pytest.fixture(scope="module")
def wall():
    return oaktwin.Scene.from_triangles(WALL, np.array([[0, 1, 2]]), label="wall", up="y")


def test_a_wall(wall, device):
    camera = device.cameras["left"].resized(106, 66, rule="depthai")
    seen = wall.render(camera, EYE)
    assert list(seen) == ["distance_to_image_plane"]
    z = seen["distance_to_image_plane"]
    assert z.shape == (66, 106) and z.dtype == np.float32 and np.allclose(z, 3)
    ranges = wall.render(camera, EYE, annotators=["distance_to_camera"])["distance_to_camera"]
    y, x = np.mgrid[:66, :106]
    k = camera.K
    length = np.sqrt(((x - k[0, 2]) / k[0, 0]) ** 2 + ((y - k[1, 2]) / k[1, 1]) ** 2 + 1)
    assert np.allclose(ranges, 3 * length, rtol=1e-6)
    away = wall.render(camera, oaktwin.look_at((0, 0, 0), (0, 0, -1), (0, 1, 0)))
    assert np.isposinf(away["distance_to_image_plane"]).all()
    assert repr(wall) == "<oaktwin.Scene from meshes: 1 meshes, 1 instances, 1 triangles, 0 lights, y up>"
    assert wall.triangle_count == 1 and wall.up == "y" and wall.findings == []
    assert np.array_equal(wall.bounds, [[-50, -50, 3], [50, 80, 3]])


def test_every_annotator(wall, device):
    camera = device.depth_camera().resized(106, 66, rule="depthai")
    names = ["rgb", "normals", "instance_id_segmentation", "semantic_segmentation", "bounding_box_2d_tight",
             "bounding_box_2d_loose", "pointcloud", "distance_to_image_plane"]
    seen = wall.render(camera, EYE, annotators=names)
    assert seen["rgb"].shape == (66, 106, 4) and seen["rgb"].dtype == np.uint8 and (seen["rgb"][..., 3] == 255).all()
    assert seen["normals"].shape == (66, 106, 3) and np.allclose(np.abs(seen["normals"]), [0, 0, 1])
    assert (seen["instance_id_segmentation"] == 1).all() and seen["instance_id_segmentation"].dtype == np.uint32
    assert seen["instance_id_segmentation_prim_paths"] == {1: "/World/Mesh"}
    [label] = np.unique(seen["semantic_segmentation"])
    assert seen["semantic_segmentation_labels"][label] == {"class": "wall"}
    [box] = seen["bounding_box_2d_tight"]
    assert [box[name] for name in ["x_min", "y_min", "x_max", "y_max"]] == [0, 0, 105, 65]
    assert seen["bounding_box_2d_tight"].dtype.names[0] == "semanticId"
    assert seen["pointcloud"].shape == (66 * 106, 3) and np.allclose(seen["pointcloud"][:, 2], 3)

    poses = np.stack([EYE, oaktwin.look_at((0, 0, 0), (0, 0, -1), (0, 1, 0)), EYE])
    poses[2, 2, 3] = 1
    batch = wall.render(camera, poses, annotators=names)
    for name in ["rgb", "normals", "instance_id_segmentation", "semantic_segmentation", "distance_to_image_plane"]:
        assert batch[name].shape == (3, *seen[name].shape) and batch[name].dtype == seen[name].dtype
        assert np.array_equal(batch[name][0], seen[name])
    assert [len(points) for points in batch["pointcloud"]] == [66 * 106, 0, 66 * 106]
    assert [len(boxes) for boxes in batch["bounding_box_2d_tight"]] == [1, 0, 1]
    assert np.allclose(batch["distance_to_image_plane"][2], 2)
    nothing = wall.render(camera, np.empty((0, 4, 4)), annotators=names)
    assert nothing["rgb"].shape == (0, 66, 106, 4) and nothing["pointcloud"] == []


def test_a_file_renders_like_the_program(program, tmp_path, device):
    stage = ROOT / "examples/depth_sensor/depth_sensor.usda"
    eye, target = (3, -2, 1.5), (0, 0, 0.5)
    program("render", stage, "--model", "OAK4-D", "--look-at", *eye, *target, "--resolution", "320x200",
            "--annotators", "distance_to_image_plane,normals,rgb", "-o", tmp_path)
    [written] = tmp_path.rglob("distance_to_image_plane_0000.npy")
    scene = oaktwin.Scene.open(stage)
    camera = device.depth_camera().resized(320, 200, rule="depthai")
    pose = oaktwin.look_at(eye, target, frame="body") @ camera.body_from_camera
    got = scene.render(camera, pose)["distance_to_image_plane"]
    expected = np.load(written)
    assert expected.shape == got.shape and np.array_equal(np.isfinite(expected), np.isfinite(got))
    both = np.isfinite(got)
    assert both.any() and np.allclose(expected[both], got[both], rtol=1e-6)
    assert scene.triangle_count > 1 and stage.name in repr(scene)
    raster, ray = (scene.render(camera, pose, backend=name)["distance_to_image_plane"] for name in ["raster", "ray"])
    assert np.mean(np.isclose(raster, ray, rtol=1e-5)) > 0.999


def test_a_lens_and_single_precision(wall):
    camera = oaktwin.Camera((80, 60), hfov_deg=60, distortion=[-0.1])
    seen = wall.render(camera, EYE.astype(np.float32))["distance_to_image_plane"]
    assert np.allclose(seen, 3, atol=1e-4)
    turned = oaktwin.look_at((1, 2, 0), (0, 0, 3), (0, 1, 0)).astype(np.float32)
    assert np.isfinite(wall.render(camera, turned)["distance_to_image_plane"]).all()
    near = oaktwin.Camera((8, 6), hfov_deg=60, far=2.5)
    assert np.isposinf(wall.render(near, EYE)["distance_to_image_plane"]).all()


def test_look_at():
    pose = oaktwin.look_at((1, 2, 3), (1, 7, 3))
    assert pose.dtype == np.float64 and np.allclose(pose[:3, 2], [0, 1, 0]) and np.allclose(pose[:3, 1], [0, 0, -1])
    body = oaktwin.look_at(np.array([1.0, 2, 3]), (1, 7, 3), frame="body")
    assert np.allclose(body[:3, 0], [0, 1, 0]) and np.allclose(body[:3, 3], [1, 2, 3])
    for text, arguments in {
        "the eye and the target are equal": ((1, 1, 1), (1, 1, 1)),
        "parallel to the up direction": ((0, 0, 0), (0, 0, 1)),
        "finite": ((0, 0, float("inf")), (0, 0, 1)),
    }.items():
        with pytest.raises(oaktwin.Error, match=text):
            oaktwin.look_at(*arguments)
    with pytest.raises(oaktwin.Error, match="frame: invalid value"):
        oaktwin.look_at((0, 0, 0), (1, 0, 0), frame="usd")
    with pytest.raises((TypeError, ValueError)):
        oaktwin.look_at((0, 0), (1, 0, 0))


def test_bad_scenes(tmp_path):
    faces = np.array([[0, 1, 2]])
    endless = np.full((3, 3), np.inf)
    for text, arguments in {
        "vertices: has shape": (WALL[:, :2], faces),
        "faces: has shape": (WALL, faces[0]),
        "pass integers": (WALL, faces.astype(float)),
        "3 is out of range: there are 3 vertices": (WALL, faces + 1),
        "-1 is out of range": (WALL, faces - 1),
        "non-finite": (endless, faces),
    }.items():
        with pytest.raises(oaktwin.Error, match=text):
            oaktwin.Scene.from_triangles(*arguments)
    with pytest.raises(TypeError, match="not an array"):
        oaktwin.Scene.from_triangles(None, faces)
    assert oaktwin.Scene.from_triangles(np.empty((0, 3)), np.empty((0, 3), int)).bounds is None
    with pytest.raises(FileNotFoundError, match="check the path"):
        oaktwin.Scene.open(tmp_path / "none.usd")
    with pytest.raises(IsADirectoryError):
        oaktwin.Scene.open(tmp_path)
    (tmp_path / "a.txt").write_text("")
    with pytest.raises(oaktwin.Error, match=r"unknown scene format \.txt; give a usd"):
        oaktwin.Scene.open(tmp_path / "a.txt")
    (tmp_path / "a.usda").write_text("nonsense")
    with pytest.raises(oaktwin.Error):
        oaktwin.Scene.open(tmp_path / "a.usda")


def test_mesh_files(tmp_path, device):
    (tmp_path / "wall.obj").write_text("v -50 -50 30\nv 50 -50 30\nv 0 80 30\nf 1 2 3\n")
    scene = oaktwin.Scene.open(tmp_path / "wall.obj", up="y", scale=0.1)
    assert scene.up == "y" and scene.bounds[1][2] == pytest.approx(3)
    camera = oaktwin.Camera((4, 4), hfov_deg=20)
    assert np.allclose(scene.render(camera, EYE)["distance_to_image_plane"], 3)
    with pytest.raises(oaktwin.Error, match="time"):
        oaktwin.Scene.open(tmp_path / "wall.obj", time=1)


def test_glass(tmp_path, device):
    (tmp_path / "pane.mtl").write_text("newmtl pane\nd 0.1\nPr 0\nnewmtl wall\nKd 0.5 0.5 0.5\nPr 1\n")
    quad = "v -50 -50 {0}\nv 50 -50 {0}\nv 50 50 {0}\nv -50 50 {0}\n"
    (tmp_path / "pane.obj").write_text(
        "mtllib pane.mtl\n" + quad.format(2) + quad.format(3) + "usemtl pane\nf 1 2 3 4\nusemtl wall\nf 5 6 7 8\n")
    scene = oaktwin.Scene.open(tmp_path / "pane.obj")
    camera = oaktwin.Camera((4, 4), hfov_deg=20)
    asked = ["distance_to_image_plane", "rgb"]
    surface, through = (scene.render(camera, EYE, annotators=asked, transparent=what) for what in ["surface", "through"])
    assert np.allclose(surface["distance_to_image_plane"], 2) and np.allclose(through["distance_to_image_plane"], 3)
    assert np.array_equal(surface["rgb"], through["rgb"])
    # A sensor measures what it sees through the pane, whatever the truth is.
    facing = np.linalg.inv(device.depth_camera().body_from_camera)
    options = dict(size=(320, 200), parameters={"confidenceThreshold": 0})
    rig = pickle.loads(pickle.dumps(oaktwin.Rig(device, transparent="through", **options)))
    [shot] = rig.shoot(scene, facing, frame=0).values()
    [plain] = oaktwin.Rig(device, **options).shoot(scene, facing, frame=0).values()
    assert np.allclose(shot["distance_to_image_plane"], 3) and np.allclose(plain["distance_to_image_plane"], 2)
    assert np.array_equal(plain["depth_sensor_distance"], shot["depth_sensor_distance"])
    measured = plain["depth_sensor_distance"]
    assert np.median(measured[measured > 0]) == pytest.approx(3, abs=0.2)


def test_bad_renderings(wall):
    camera = oaktwin.Camera((4, 4), hfov_deg=20)
    for text, arguments, options in [
        ("did you mean 'normals'", (camera, EYE), dict(annotators=["normal"])),
        ("is not an image; use the camera", (camera, EYE), dict(annotators=["camera_params"])),
        ("DepthSensor", (camera, EYE), dict(annotators=["depth_sensor_distance"])),
        ("backend: invalid value", (camera, EYE), dict(backend="gpu")),
        ("transparent: invalid value", (camera, EYE), dict(transparent="glass")),
        ("world_from_camera: has shape", (camera, EYE[:3]), {}),
        ("not a rotation", (camera, np.diag([2.0, 2, 2, 1])), {}),
        ("not a rotation", (camera, np.diag([1.0, 1, -1, 1])), {}),
        ("non-finite", (camera, EYE * np.nan), {}),
        ("last row", (camera, np.ones((2, 4, 4))), {}),
        ("not an array of numbers", (camera, "here"), {}),
        ("of memory", (oaktwin.Camera((1 << 15, 1 << 15), hfov_deg=20), np.stack([EYE] * 10000)), {}),
    ]:
        with pytest.raises(oaktwin.Error) as raised:
            wall.render(*arguments, **options)
        assert text in str(raised.value)
    with pytest.raises(TypeError):
        wall.render("left", EYE)



def test_memory_limit():
    scene = oaktwin.Scene.from_triangles(np.array([[-1, -1, 2], [1, -1, 2], [0, 1, 2]]), np.array([[0, 1, 2]]))
    camera = oaktwin.Camera((4000, 3000), hfov_deg=60)
    try:
        oaktwin.set_memory_limit("1M")
        with pytest.raises(oaktwin.Error, match=r"of memory needed, 0.0 MiB available; raise the limit of set_memory_limit\(\), or"):
            scene.render(camera, np.eye(4))
        oaktwin.set_memory_limit(1 << 40)
        assert scene.render(camera, np.eye(4), annotators=["distance_to_image_plane"])
    finally:
        oaktwin.set_memory_limit(None)
    with pytest.raises(oaktwin.Error, match="such as 4G"):
        oaktwin.set_memory_limit("plenty")


def test_a_stage_that_composes_too_much_gives_an_error_that_names_the_argument(tmp_path):
    classes = ['class "A0" { def Cube "c" {} }\nclass "B0" {}\n']
    for at in range(1, 41):
        classes += [f'class "{name}{at}" (inherits = [</A{at - 1}>, </B{at - 1}>]) {{}}\n' for name in "AB"]
    stage = tmp_path / "stage.usda"
    stage.write_text("#usda 1.0\n" + "".join(classes))
    with pytest.raises(oaktwin.Error, match=r"/A40: .* beyond the limit of \d+ sites; .* or raise scene_limit from 1"):
        oaktwin.Scene.open(stage)
    with pytest.raises(oaktwin.Error, match="scene_limit: must be a finite number > 0"):
        oaktwin.Scene.open(stage, scene_limit=0)
    stage.write_text('#usda 1.0\ndef Cube "c" {}\n')
    assert oaktwin.Scene.open(stage, scene_limit=0.5).bounds is not None


def test_infrared_reflectances_are_checked():
    with pytest.raises(oaktwin.Error, match="no material and no label has this name"):
        oaktwin.Scene.open(ROOT / "examples/depth_sensor/depth_sensor.usda", infrared={"no such name": 0.5})
    with pytest.raises(oaktwin.Error, match="out of range; give 0 to 1"):
        oaktwin.Scene.open(ROOT / "examples/depth_sensor/depth_sensor.usda", infrared={"no such name": 1.5})
