"""Every output of a sensor is an image of the camera that it states: a slanted wall, against analytic geometry."""

import json

import numpy as np
import pytest

import oaktwin

# The wall n · p = C in the frame of the images' camera, n_z = 1.
NORMAL, C = np.array([0.25, 0.15, 1.0]), 2.5
PLANE = np.array([C, -NORMAL[0], -NORMAL[1]])
FLIP = np.diag([1.0, -1, -1, 1])
POSITION, COLOR = "depth_sensor_point_cloud_position", "depth_sensor_point_cloud_color"
QUIET = {
    "stereo-noise": {"jitter": 0, "pixelLocking": 0, "bias": 0, "confidenceThreshold": 0},
    "single-view": {"noiseMean": 0, "confidenceThreshold": 1},
    "time-of-flight": {},
}
DECIMATIONS = [["decimation:factor=2"], ["decimation:factor=3,mode=NON_ZERO_MEAN"]]
DECIMATIONS += [["decimation:factor=2,mode=NON_ZERO_MEDIAN", "median:size=3"], ["spatial"], []]
RVC2 = ["default", "face", "high-detail", "robotics", "accuracy"]
CASES = [("OAK-D Pro PoE", "stereo-noise", {"preset": preset}) for preset in RVC2]
CASES += [("OAK4-D", "stereo-noise", {"preset": "default"}), ("OAK-D ToF", "time-of-flight", {"preset": "TOF_MID_RANGE"})]
for filters in DECIMATIONS:
    CASES += [("OAK-D Pro PoE", engine, {"filters": filters}) for engine in ["stereo-noise", "single-view"]]
    CASES += [("OAK-D ToF", "time-of-flight", {"filters": filters})]


def rays(camera):
    v, u = np.mgrid[0 : camera.height, 0 : camera.width].astype(float)
    K = camera.K
    return np.stack([(u - K[0, 2]) / K[0, 0], (v - K[1, 2]) / K[1, 1], np.ones_like(u)], -1)


def wall(camera):
    return (C / (rays(camera) @ NORMAL)).astype(np.float32)


def picture(camera):
    """Red rises from left to right, green from top to bottom; blue is a fine texture."""
    v, u = np.mgrid[0 : camera.height, 0 : camera.width]
    blue = np.random.default_rng(3).integers(0, 256, u.shape)
    return np.stack([255 * u // camera.width, 255 * v // camera.height, blue], -1).astype(np.uint8)


def check_plane(points, tolerance=0.006):
    """Fits z = a + b x + c y to points in the frame of the images' camera."""
    matrix = np.column_stack([np.ones(len(points)), points[:, 0], points[:, 1]])
    assert len(points) > 1000
    fitted, *_ = np.linalg.lstsq(matrix, points[:, 2], rcond=None)
    np.testing.assert_allclose(fitted, PLANE, atol=tolerance)
    # The whole view, not a part of it.
    assert np.ptp(points[:, 0]) > 1.5 and points[:, 0].min() < -0.5 < 0.5 < points[:, 0].max()


def move(matrix, points):
    return points @ matrix[:3, :3].T + matrix[:3, 3]


def unprojected(depth, camera):
    """Points in the frame of the camera."""
    points = rays(camera) * depth[..., None]
    return points[depth > 0]


@pytest.mark.parametrize(("model", "engine", "settings"), CASES)
def test_a_wall_is_where_the_camera_sees_it(model, engine, settings):
    device = oaktwin.Device(model)
    images = device.depth_camera("tof" if engine == "time-of-flight" else "stereo")
    if images.width > 800:
        images = images.resized(640, 400)
    parameters = dict(QUIET[engine])
    kind = "tof" if engine == "time-of-flight" else "stereo"
    sensor = oaktwin.DepthSensor(device, engine=engine, sensor=kind, camera=images, parameters=parameters, **settings)
    rgb = picture(images)
    distance = sensor(wall(images), rgb)
    camera = sensor.camera
    images_from_output = np.linalg.inv(images.body_from_camera) @ camera.body_from_camera
    assert distance.shape == (camera.height, camera.width)
    check_plane(move(images_from_output, unprojected(distance, camera)))
    sensor.reset(seed=0)
    names = ["depth_sensor_distance", POSITION, COLOR, "depth_sensor_confidence"]
    names += ["depth_sensor_imager", "depth_sensor_output_visualization"] if engine == "single-view" else []
    made = sensor.annotate(wall(images), rgb, annotators=names)
    assert {array.shape[:2] for array in made.values()} == {distance.shape}
    assert np.array_equal(made["depth_sensor_distance"], distance)
    confidence = made["depth_sensor_confidence"]
    assert confidence.dtype == np.uint16 and (confidence[distance > 0] > 0).mean() > 0.5
    is_valid = made[POSITION][..., 3] > 0
    assert np.array_equal(is_valid, distance > 0)
    points = move(FLIP, made[POSITION][is_valid][:, :3])
    check_plane(points)
    # A point has the colour of the pixel of the image that it projects to.
    pixels = points / points[:, 2:] @ images.K.T
    expected = 255 * pixels[:, :2] / [images.width, images.height]
    colors = made[COLOR][is_valid]
    seen = colors[:, 3] > 0
    off = np.abs(colors[seen][:, :2] - expected[seen])
    assert seen.mean() > 0.8 and np.median(off) < 1 and np.quantile(off, 0.95) < 4


def test_the_principal_point_is_that_of_the_decimated_pixels():
    device = oaktwin.Device("OAK-D Pro PoE")
    images = device.depth_camera().resized(640, 400)
    for mode, first in [("PIXEL_SKIPPING", 0.0), ("NON_ZERO_MEAN", 1.0), ("NON_ZERO_MEDIAN", 1.0)]:
        filters = [f"decimation:factor=3,mode={mode}"]
        camera = oaktwin.DepthSensor(device, camera=images, filters=filters).camera
        assert camera.size == (213, 133)
        expected = (images.K[:2] - [[0, 0, first], [0, 0, first]]) / 3
        np.testing.assert_allclose(camera.K[:2], expected)


@pytest.mark.parametrize("settings", [{}, {"filters": ["decimation:factor=2"]}, {"preset": "default"}])
def test_matched_depth_is_an_image_of_the_matchers_camera(settings):
    images = oaktwin.Camera((640, 400), K=[[400, 0, 310.5], [0, 400, 205.25], [0, 0, 1]])
    baseline, texture = 0.075, np.random.default_rng(1).uniform(0, 255, (700, 900))

    def look(offset):
        """The wall's texture, bilinear, seen from a place to the right of the left camera."""
        ray = rays(images)
        p = ray * ((C - NORMAL[0] * offset) / (ray @ NORMAL))[..., None] + [offset, 0, 0]
        x, y = (p[..., 0] + 2.6) * 160, (p[..., 1] + 2) * 160
        i, j = np.floor(y).astype(int), np.floor(x).astype(int)
        a, b = y - i, x - j
        top = texture[i, j] * (1 - b) + texture[i, j + 1] * b
        return ((1 - a) * top + a * (texture[i + 1, j] * (1 - b) + texture[i + 1, j + 1] * b)).astype(np.uint8)

    matcher = oaktwin.StereoMatcher(fx=400, baseline=baseline, parameters={"subpixel": True, "subpixelFractionalBits": 5}, **settings)
    found = matcher(look(0.0), look(baseline))
    camera = matcher.camera
    for name in ["depth", "disparity", "confidence"]:
        assert found[name].shape == (camera.height, camera.width)
    batch = matcher(look(0.0)[None], look(baseline)[None])
    assert batch["confidence"].shape == batch["depth"].shape == (1, camera.height, camera.width)
    # The matcher of unknown images has a centred principal point; the wall's is shifted by the difference.
    K = camera.K.copy()
    scale = 640 / camera.width
    K[:2, 2] = images.K[:2, 2] / scale
    own = oaktwin.Camera(camera.size, K=K)
    depth = found["depth"]
    np.testing.assert_allclose(K[0, 0], 400 / scale)
    check_plane(unprojected(depth, own), tolerance=0.03)


def test_the_program_writes_the_camera(tmp_path, program):
    (tmp_path / "wall.obj").write_text("v -9 2 -9\nv 9 3.5 -9\nv 9 3.5 9\nv -9 2 9\nf 1 2 3 4\n")
    options = ["--model", "OAK-D Pro PoE", "--look-at", *"000010", "--up", "z"]
    for engine, filters in [
        ("stereo-noise", ["--filter", "decimation:factor=2"]),
        ("single-view", ["--filter", "decimation:factor=2"]),
        ("single-view", []),
    ]:
        folder = tmp_path / f"{engine}{len(filters)}"
        quiet = [f"{name}={value}" for name, value in QUIET[engine].items()]
        params = [word for pair in quiet for word in ["--param", pair]]
        program(
            "render", str(tmp_path / "wall.obj"), *options, "--resolution", "640x400", "--engine", engine, *filters, *params,
            "--annotators", f"camera_params,depth_sensor_distance,{POSITION}", "--record", str(tmp_path / f"{folder.name}.mcap"),
            "-o", str(folder),
        )  # fmt: skip
        both = [json.loads((folder / f"{name}camera_params_0000.json").read_text()) for name in ["", "depth_sensor_"]]
        depth = np.load(folder / "depth_sensor_distance_0000.npy")
        points = np.load(folder / f"{POSITION}_0000.npy")
        assert both[1]["renderProductResolution"] == [depth.shape[1], depth.shape[0]]
        worlds = []
        for params, at in [(both[1], depth), (both[0], points)]:
            world_from_camera = np.linalg.inv(np.reshape(params["cameraViewTransform"], (4, 4)))
            if at is depth:
                p = np.reshape(params["cameraProjection"], (4, 4))
                v, u = np.mgrid[0 : depth.shape[0], 0 : depth.shape[1]] + 0.5
                x = (2 * u / depth.shape[1] - 1 + p[2, 0]) / p[0, 0]
                y = (1 - 2 * v / depth.shape[0] + p[2, 1]) / p[1, 1]
                seen = (np.stack([x, y, -np.ones_like(x)], -1) * depth[..., None])[depth > 0]
            else:
                seen = at[at[..., 3] > 0][:, :3]
            worlds.append(np.column_stack([seen, np.ones(len(seen))]) @ world_from_camera)
        for world in worlds:
            fitted, *_ = np.linalg.lstsq(np.column_stack([np.ones(len(world)), world[:, 0]]), world[:, 1], rcond=None)
            np.testing.assert_allclose(fitted, [2.75, 0.75 / 9], atol=0.006)
            assert np.ptp(world[:, 0]) > 3
        recorded = pytest.importorskip("test_recording", reason="mcap is not installed")
        topics = recorded.messages(tmp_path / f"{folder.name}.mcap")
        (name,) = [topic.split("/")[1] for topic in topics if topic.endswith("/measured")]
        info = topics.get(f"/{name}/measured_camera_info")[0]
        assert (info.height, info.width) == depth.shape
        message = topics[f"/{name}/measured_points"][0]
        cloud, _ = recorded.cloud(message)
        stamp = (message.header.stamp.sec, message.header.stamp.nanosec)
        matrix = recorded.world_from(message.header.frame_id, topics, stamp)
        world = move(matrix, cloud[np.isfinite(cloud[..., 2])])
        fitted, *_ = np.linalg.lstsq(np.column_stack([np.ones(len(world)), world[:, 0]]), world[:, 1], rcond=None)
        np.testing.assert_allclose(fitted, [2.75, 0.75 / 9], atol=0.006)
        np.testing.assert_allclose(np.reshape(info.k, (3, 3))[0, 0], depth.shape[1] / 1280 * 804.59, rtol=1e-4)


def test_recordings_hold_decimated_depth(tmp_path):
    device = oaktwin.Device("OAK-D Pro PoE")
    images = device.depth_camera().resized(640, 400)
    sensor = oaktwin.DepthSensor(device, camera=images, preset="default")
    measured = sensor(wall(images))
    with pytest.raises(oaktwin.Error, match="measured_camera"), oaktwin.Recording(tmp_path / "no.mcap") as recording:
        recording.log(images, np.eye(4), measured=measured)
    with oaktwin.Recording(tmp_path / "a.mcap") as recording:
        for frame in range(2):
            recording.log(
                images, np.eye(4), depth=wall(images), measured=measured, measured_camera=sensor.camera,
                rgb=picture(images), frame=frame,
            )  # fmt: skip
        with pytest.raises(oaktwin.Error, match="different camera"):
            recording.log(images, np.eye(4))
    recorded = pytest.importorskip("test_recording", reason="mcap is not installed")
    topics = recorded.messages(tmp_path / "a.mcap")
    info, message = (topics[f"/{images.name}/measured_{what}"][0] for what in ["camera_info", "points"])
    np.testing.assert_allclose(np.reshape(info.k, (3, 3)), sensor.camera.K)
    points, colors = recorded.cloud(message)
    is_valid = np.isfinite(points[..., 2])
    check_plane(points[is_valid], tolerance=0.02)
    expected = 255 * (points[is_valid] / points[is_valid][:, 2:] @ images.K.T)[:, :2] / images.size
    assert np.abs(colors[is_valid][:, :2] - expected).max() < 2


def test_sense_states_the_camera_of_its_results(tmp_path, program):
    device = oaktwin.Device("OAK-D Pro PoE")
    images = device.depth_camera()
    np.save(tmp_path / "wall.npy", wall(images))
    program(
        "sense", str(tmp_path / "wall.npy"), "--input-kind", "z", "--model", "OAK-D Pro PoE", "--filter", "decimation:factor=2", "-o", str(tmp_path / "out")
    )
    (path,) = (tmp_path / "out").glob("*depth_sensor_camera_params.json")
    params = json.loads(path.read_text())
    sensor = oaktwin.DepthSensor(device, filters=["decimation:factor=2"])
    assert params["renderProductResolution"] == list(sensor.camera.size)
    projection = np.reshape(params["cameraProjection"], (4, 4))
    np.testing.assert_allclose(projection[0, 0] * sensor.camera.width / 2, sensor.camera.K[0, 0])
    np.testing.assert_allclose((1 - projection[2, 0]) * sensor.camera.width / 2, sensor.camera.K[0, 2] + 0.5)
