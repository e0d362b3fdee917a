"""A calibrated unit has one rectified depth camera, the device's: of assets, sensors, matchers and rendered pairs."""

import numpy as np
import oaktwin
import pytest
from conftest import ROOT

UNITS = {
    "example-oak-d-pro-poe": "right",
    "oak-d-pro-w-poe": "right",
    # OAK 4 devices rectify to the left camera's intrinsics, RVC2 to the right camera's.
    "oak-4-d": "left",
}


@pytest.fixture(scope="module", params=UNITS)
def unit(request):
    device = oaktwin.Device.from_calibration(ROOT / "crates/calibration/fixtures" / f"{request.param}.json")
    return device, UNITS[request.param]


def test_all_agree(unit):
    device, _ = unit
    own = device.depth_camera("stereo")
    for camera in [oaktwin.StereoMatcher(device).camera, oaktwin.DepthSensor(device, sensor="stereo").camera]:
        assert camera.size == own.size and camera.lens == own.lens == "pinhole"
        np.testing.assert_allclose(camera.K, own.K, rtol=1e-12)
        np.testing.assert_allclose(camera.body_from_camera, own.body_from_camera, atol=1e-12)


def test_it_is_opencvs_rectification(unit):
    cv2 = pytest.importorskip("cv2")
    device, target = unit
    left, right = device.cameras["left"], device.cameras["right"]
    right_from_left = device.extrinsics("left", "right")
    arguments = [left.K, left.distortion, right.K, right.distortion, left.size]
    R1, *_ = cv2.stereoRectify(*arguments, right_from_left[:3, :3], right_from_left[:3, 3])
    own = device.depth_camera("stereo")
    np.testing.assert_allclose(own.body_from_camera[:3, :3], left.body_from_camera[:3, :3] @ R1.T, atol=1e-9)
    np.testing.assert_allclose(own.body_from_camera[:3, 3], left.body_from_camera[:3, 3], atol=1e-12)
    np.testing.assert_allclose(own.K, device.cameras[target].K)
    assert not np.allclose(own.body_from_camera[:3, :3], left.body_from_camera[:3, :3], atol=1e-4)
    rectification = device.rectification(intrinsics=f"{target}-camera")
    np.testing.assert_allclose(rectification.P1[:, :3], own.K)
    np.testing.assert_allclose(rectification.P2[:, :3], own.K)
    np.testing.assert_allclose(rectification.R1, R1, atol=1e-9)


def test_a_rendered_pair_has_the_depth_of_the_depth_camera(unit):
    device, _ = unit
    vertices = np.array([[4, -9, -9], [5, 9, -9], [4.5, 9, 9], [3.5, -9, 9]], np.float32)
    scene = oaktwin.Scene.from_triangles(vertices, np.array([[0, 1, 2], [0, 2, 3]]))
    size = (320, 200)
    pair = scene.render_pair(device, np.eye(4), size=size, frame=0)
    camera = device.depth_camera("stereo").resized(*size, rule="depthai")
    truth = scene.render(camera, camera.body_from_camera, annotators=["distance_to_image_plane"])
    np.testing.assert_allclose(pair["z"], truth["distance_to_image_plane"], rtol=1e-5)


def test_nominal_devices_keep_the_sheets_camera():
    for model in ["OAK-D Pro PoE", "OAK4-D", "OAK-D Pro W PoE"]:
        device = oaktwin.Device(model)
        own, left = device.depth_camera("stereo"), device.cameras["left"]
        assert np.array_equal(own.K, left.K) and np.array_equal(own.body_from_camera, left.body_from_camera)


def test_a_map_is_finite_or_an_error(unit):
    device, target = unit
    maps = device.rectification(intrinsics=f"{target}-camera").maps("left")
    assert np.isfinite(maps).all()
    left = device.cameras["left"]
    for coefficient in range(len(left.distortion)):
        broken = left.distortion.copy()
        broken[coefficient] = 1e300
        try:
            camera = oaktwin.Camera(left.size, K=left.K, distortion=list(broken), body_from_camera=left.body_from_camera)
            rectification = oaktwin.Rectification(camera, device.cameras["right"], intrinsics=f"{target}-camera")
            assert np.isfinite(rectification.P1).all() and not np.isinf(rectification.maps("left")).any()
        except oaktwin.Error as error:
            assert "finite" in str(error)
