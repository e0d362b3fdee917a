"""The cameras of a stage, and the outputs of its depth sensors."""

import numpy as np
import pytest

import oaktwin
from conftest import ROOT

STAGE = ROOT / "examples/depth_sensor/depth_sensor.usda"


def test_cameras_are_the_programs(program, tmp_path):
    scene = oaktwin.Scene.open(STAGE)
    assert scene.cameras
    program("render", STAGE, "--annotators", "distance_to_image_plane", "-o", tmp_path)
    written = sorted(tmp_path.rglob("distance_to_image_plane_0000.npy"))
    assert len(written) == len(scene.cameras)
    for (path, (camera, world_from_camera)), file in zip(sorted(scene.cameras.items()), written):
        assert path.startswith("/") and camera.name == path
        assert world_from_camera.shape == (4, 4) and world_from_camera.dtype == np.float64
        got = scene.render(camera, world_from_camera)["distance_to_image_plane"]
        assert np.array_equal(got, np.load(file)) and np.isfinite(got).any()


def test_none_and_a_mesh_files(tmp_path):
    assert oaktwin.Scene.from_triangles(np.eye(3), np.array([[0, 1, 2]])).cameras == {}
    (tmp_path / "a.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    assert oaktwin.Scene.open(tmp_path / "a.obj").cameras == {}


STAGE_OF = """#usda 1.0
(
    metersPerUnit = 0.01
    upAxis = "Z"
)
def Camera "Good" {{
    float focalLength = 24
    float horizontalAperture = 36
    float verticalAperture = 24
    float2 clippingRange = (1, 1000000)
    matrix4d xformOp:transform = ((1,0,0,0),(0,1,0,0),(0,0,1,0),(100,200,300,1))
    uniform token[] xformOpOrder = ["xformOp:transform"]
}}
def Camera "Other" {{
    float focalLength = {focal}
}}
"""


def test_places_are_metres_and_axes_opencvs(tmp_path):
    (tmp_path / "a.usda").write_text(STAGE_OF.format(focal=24))
    cameras = oaktwin.Scene.open(tmp_path / "a.usda").cameras
    assert list(cameras) == ["/Good", "/Other"]
    camera, pose = cameras["/Good"]
    # Faces along -z, y up.
    assert np.allclose(pose, [[1, 0, 0, 1], [0, -1, 0, 2], [0, 0, -1, 3], [0, 0, 0, 1]])
    assert camera.clip == pytest.approx((0.01, 1e4))


def test_unsupported_cameras_are_skipped(tmp_path):
    (tmp_path / "a.usda").write_text(STAGE_OF.format(focal=0))
    scene = oaktwin.Scene.open(tmp_path / "a.usda")
    assert list(scene.cameras) == ["/Good"]
    assert "camera-left-out" in [finding.code for finding in scene.findings]
    (tmp_path / "b.usda").write_text('#usda 1.0\ndef Camera "Bad" {\n    float focalLength = 0\n}\n')
    scene = oaktwin.Scene.open(tmp_path / "b.usda")
    with pytest.raises(oaktwin.Error, match="/Bad"):
        scene.cameras


SENSED = [
    "depth_sensor_distance",
    "depth_sensor_point_cloud_position",
    "depth_sensor_point_cloud_color",
    "depth_sensor_imager",
    "depth_sensor_output_visualization",
]


def test_sister_outputs_are_the_programs(program, tmp_path, device):
    eye, target = (3, -2, 1.5), (0, 0, 0.5)
    program("render", STAGE, "--model", "OAK4-D", "--look-at", *eye, *target, "--resolution", "320x200", "--seed", "5",
            "--engine", "single-view", "--annotators", ",".join(["rgb", "distance_to_image_plane", *SENSED]), "-o", tmp_path)
    scene = oaktwin.Scene.open(STAGE)
    camera = device.depth_camera().resized(320, 200, rule="depthai")
    pose = oaktwin.look_at(eye, target, frame="body") @ camera.body_from_camera
    seen = scene.render(camera, pose, annotators=["rgb", "distance_to_image_plane"])
    sensor = oaktwin.DepthSensor(device, engine="single-view", seed=5)
    got = sensor.annotate(seen["distance_to_image_plane"], seen["rgb"], annotators=SENSED)
    assert list(got) == SENSED
    for name, shape, dtype in zip(
        SENSED, [(200, 320), (200, 320, 4), (200, 320, 4), (200, 320), (200, 320, 4)],
        [np.float32, np.float32, np.uint8, np.float32, np.uint8],
    ):
        assert got[name].shape == shape and got[name].dtype == dtype and got[name].any(), name
    [distance] = tmp_path.rglob("depth_sensor_distance_0000.npy")
    assert np.array_equal(got["depth_sensor_distance"], np.load(distance))
    assert np.array_equal(got["depth_sensor_distance"], sensor(seen["distance_to_image_plane"], seen["rgb"], frame=0))
    measured = got["depth_sensor_distance"] > 0
    z = got["depth_sensor_point_cloud_position"][..., 2]
    assert (z[~measured] == 0).all() and (z[measured] < 0).all()
    luma = seen["rgb"][..., :3] @ [0.299, 0.587, 0.114] / 255
    assert np.corrcoef(luma.ravel(), got["depth_sensor_imager"].ravel())[0, 1] > 0.9


def test_invalid_annotators_of_a_sensor(device, room):
    depth, rgb = room
    sensor = oaktwin.DepthSensor(device)
    both = sensor.annotate(depth, rgb, annotators=["depth_sensor_distance", "depth_sensor_point_cloud_color"])
    assert np.array_equal(both["depth_sensor_distance"], sensor(depth, rgb, frame=0))
    assert sensor.annotate(depth, annotators=[]) == {}
    for text, call in [
        ("depth_sensor_imager: is not made", lambda: sensor.annotate(depth, rgb, annotators=["depth_sensor_imager"])),
        ("give rgb=", lambda: sensor.annotate(depth, annotators=["depth_sensor_point_cloud_color"])),
        ("is not an annotator of a depth sensor", lambda: sensor.annotate(depth, annotators=["rgb"])),
        ("did you mean", lambda: sensor.annotate(depth, annotators=["depth_sensor_distanc"])),
        ("is a batch", lambda: sensor.annotate(depth[None], annotators=["depth_sensor_distance"])),
    ]:
        with pytest.raises(oaktwin.Error) as raised:
            call()
        assert text in str(raised.value)
    with pytest.raises(TypeError):
        sensor.annotate(depth)
    assert sensor.annotate(depth.astype(float), annotators=[]) == {}
