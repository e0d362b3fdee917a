"""Projection, rays, points and undistortion, compared with OpenCV."""

import numpy as np
import pytest

import oaktwin

cv2 = pytest.importorskip("cv2")

K = np.array([[220.0, 0, 158.5], [0, 225.0, 121.25], [0, 0, 1]])
LENSES = {
    "pinhole": (),
    "opencv": (0.12, -0.2, 0.003, -0.002, 0.05, 0.01, 0.02, -0.01, 0.001, 0.0005, -0.001, 0.0002, 0.01, -0.02),
    "fisheye": (0.02, -0.01, 0.004, -0.001),
}


@pytest.fixture(scope="module", params=LENSES)
def camera(request):
    return oaktwin.Camera((320, 240), K=K, lens=request.param, distortion=LENSES[request.param])


def by_opencv(camera, points):
    """The pixels of points in the camera's frame."""
    zero = np.zeros(3)
    flat = np.asarray(points, np.float64).reshape(-1, 1, 3)
    if camera.lens == "fisheye":
        pixels, _ = cv2.fisheye.projectPoints(flat, zero, zero, K, camera.distortion)
    else:
        pixels, _ = cv2.projectPoints(flat, zero, zero, K, camera.distortion)
    return pixels.reshape(*np.shape(points)[:-1], 2)


def in_front(count):
    random = np.random.default_rng(4)
    points = random.uniform((-1, -0.7, 1), (1, 0.7, 1), (count, 7, 3))
    return points * random.uniform(0.3, 30, (count, 7, 1))


def test_projection_is_opencvs(camera):
    points = in_front(400)
    pixels, depth = camera.project(points)
    assert pixels.shape == (400, 7, 2) and depth.shape == (400, 7)
    assert np.abs(pixels - by_opencv(camera, points)).max() < 1e-7
    assert np.array_equal(depth, points[..., 2])
    pose = oaktwin.look_at((1, 2, 3), (4, -1, 0.5))
    world = points @ pose[:3, :3].T + pose[:3, 3]
    again, depths = camera.project(world, pose)
    assert np.allclose(again, pixels, atol=1e-6) and np.allclose(depths, depth, rtol=1e-9)
    one, z = camera.project([0.1, 0.2, 2])
    assert one.shape == (2,) and z.shape == () and z == 2


def test_what_has_no_pixel_is_nan():
    camera = oaktwin.Camera((320, 240), K=K)
    pixels, depth = camera.project([[0, 0, -1], [0, 0, 0], [np.nan, 0, 1], [0, 0, 1]])
    assert np.isnan(pixels[:3]).all() and np.allclose(pixels[3], K[:2, 2]) and depth[0] == -1
    assert camera.project(np.empty((0, 3)))[0].shape == (0, 2)


def test_rays_and_points_project_to_their_pixels(camera):
    x, y = np.meshgrid(np.arange(320.0), np.arange(240.0))
    rays = camera.rays()
    assert rays.shape == (240, 320, 3) and rays.dtype == np.float32
    assert np.abs(np.linalg.norm(rays, axis=-1) - 1).max() < 1e-6
    assert np.abs(by_opencv(camera, rays) - np.stack([x, y], -1)).max() < 2e-4
    depth = np.random.default_rng(2).uniform(0.3, 8, (240, 320)).astype(np.float32)
    depth[:3, :3] = [0, np.inf, -1]
    points = camera.unproject(depth)
    valid = np.isfinite(depth) & (depth > 0)
    assert np.array_equal(np.isfinite(points).all(-1), valid) and np.isnan(points[~valid]).all()
    assert np.allclose(points[valid][:, 2], depth[valid], rtol=1e-6)
    assert np.abs(by_opencv(camera, points[valid]) - np.stack([x, y], -1)[valid]).max() < 2e-4


def test_points_of_batches_and_poses():
    camera = oaktwin.Camera((32, 24), hfov_deg=70)
    millimetres = np.random.default_rng(2).integers(1, 9000, (3, 24, 32)).astype(np.uint16)
    poses = np.stack([oaktwin.look_at((i, 0, 1), (5, i, 0)) for i in range(3)])
    points = camera.unproject(millimetres, poses)
    assert points.shape == (3, 24, 32, 3)
    for image, pose, own in zip(millimetres, poses, points, strict=True):
        local = camera.unproject((image / 1000).astype(np.float32))
        assert np.allclose(local @ pose[:3, :3].T + pose[:3, 3], own, atol=1e-5)
        _, depth = camera.project(own, pose)
        assert np.allclose(depth * 1000, image, atol=2e-2)
    assert np.array_equal(camera.unproject(millimetres, poses[0])[0], points[0])


def test_points_are_those_of_a_rendered_plane():
    corners = np.array([[-50, -50, 0], [50, -50, 0], [50, 50, 0], [-50, 50, 0]], np.float32)
    scene = oaktwin.Scene.from_triangles(corners, np.array([[0, 1, 2], [0, 2, 3]]))
    for lens in LENSES:
        camera = oaktwin.Camera((320, 240), K=K, lens=lens, distortion=LENSES[lens])
        pose = oaktwin.look_at((0, 0, 3), (0.5, 0.2, 0), (0, 1, 0))
        depth = scene.render(camera, pose)["distance_to_image_plane"]
        assert np.isfinite(depth).all()
        assert np.abs(camera.unproject(depth, pose)[..., 2]).max() < 2e-5


def test_undistortion_maps_are_opencvs(camera):
    size = (320, 240)
    if camera.lens == "fisheye":
        maps = cv2.fisheye.initUndistortRectifyMap(K, camera.distortion, np.eye(3), K, size, cv2.CV_32FC1)
    else:
        maps = cv2.initUndistortRectifyMap(K, camera.distortion, None, K, size, cv2.CV_32FC1)
    own = camera.undistortion_maps()
    assert own.dtype == np.float32 and np.abs(own - np.stack(maps, -1)).max() < 1e-3
    image = np.random.default_rng(3).integers(0, 255, (240, 320, 3)).astype(np.uint8)
    image = cv2.GaussianBlur(image, (0, 0), 3)
    ours = cv2.remap(image, own, None, cv2.INTER_LINEAR)
    if camera.lens != "fisheye":
        assert np.abs(ours.astype(int) - cv2.undistort(image, K, camera.distortion)).max() <= 1
    target = oaktwin.Camera((80, 60), hfov_deg=40)
    assert camera.undistortion_maps(target).shape == (60, 80, 2)
    if camera.lens != "pinhole":
        with pytest.raises(oaktwin.Error, match="target: has a lens with distortion"):
            camera.undistortion_maps(camera)


def test_resizing_keeps_the_centre():
    camera = oaktwin.Camera((1280, 800), hfov_deg=77)
    half = camera.resized(640, 400)
    assert np.allclose(half.K[:2, 2], [319.5, 199.5], atol=1e-9)
    assert np.allclose(camera.resized(640, 400, rule="depthai").K[:2, 2], [319.75, 199.75])
    assert np.array_equal(half.K[[0, 1], [0, 1]], camera.resized(640, 400, rule="depthai").K[[0, 1], [0, 1]])
    with pytest.raises(oaktwin.Error, match="rule: invalid value 'opencv'"):
        camera.resized(640, 400, rule="opencv")
    # A point's pixel moves as cv2.resize moves the image: pixels are areas.
    points = in_front(50)
    whole, _ = camera.project(points)
    assert np.allclose((whole + 0.5) / 2 - 0.5, half.project(points)[0], atol=1e-9)


def test_wrong_shapes():
    camera = oaktwin.Camera((32, 24), hfov_deg=70)
    with pytest.raises(oaktwin.Error, match=r"points: has shape \[4, 2\]"):
        camera.project(np.zeros((4, 2)))
    with pytest.raises(oaktwin.Error, match="depth: is 24x32 px, but the camera has 32x24 px"):
        camera.unproject(np.zeros((32, 24), np.float32))
    with pytest.raises(oaktwin.Error, match="has 3 poses for 2 images"):
        camera.unproject(np.zeros((2, 24, 32), np.float32), np.stack([np.eye(4)] * 3))


def test_a_vertical_field_of_view():
    camera = oaktwin.Camera((640, 480), vfov_deg=45)
    assert camera.vfov_deg == pytest.approx(45, abs=1e-9)
    assert camera.K[0, 0] == camera.K[1, 1] == pytest.approx(240 / np.tan(np.radians(22.5)))
    for arguments, expected in [
        ({"vfov_deg": 180}, "vfov_deg: 180 is out of range"),
        ({"vfov_deg": 45, "hfov_deg": 60}, "K, hfov_deg, vfov_deg: exactly one is required"),
    ]:
        with pytest.raises(oaktwin.Error, match=expected):
            oaktwin.Camera((640, 480), **arguments)
