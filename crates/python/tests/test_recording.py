"""Recordings, read back with other libraries: mcap with mcap-ros2-support, rosbags, Rerun."""

import os
import subprocess
import sys

import numpy as np
import pytest

import oaktwin

mcap_reader = pytest.importorskip("mcap.reader", reason="mcap is not installed")
mcap_ros2 = pytest.importorskip("mcap_ros2.reader", reason="mcap-ros2-support is not installed")

SIZE = (32, 20)
# The rotation from camera axes (x right, y down, z forward) to body axes (x forward, y left, z up), REP-103.
BODY_FROM_OPTICAL = np.array([[0, 0, 1, 0], [-1, 0, 0, 0], [0, -1, 0, 0], [0, 0, 0, 1.0]])


def messages(path):
    """The messages by topic, in order."""
    topics = {}
    for message in mcap_ros2.read_ros2_messages(path):
        topics.setdefault(message.channel.topic, []).append(message.ros_msg)
    return topics


def array(message):
    kind, channels = {"rgb8": (np.uint8, 3), "32FC1": ("<f4", 1), "16UC1": ("<u2", 1)}[message.encoding]
    assert message.is_bigendian == 0 and message.step == message.width * channels * np.dtype(kind).itemsize
    pixels = np.frombuffer(bytes(message.data), kind).reshape(message.height, message.width, channels)
    return pixels if channels > 1 else pixels[..., 0]


def cloud(message):
    """The points, (H, W, 3), and their colours, (H, W, 3)."""
    names = [(field.name, field.offset, field.datatype, field.count) for field in message.fields]
    assert names[:3] == [("x", 0, 7, 1), ("y", 4, 7, 1), ("z", 8, 7, 1)]
    assert not message.is_bigendian and message.row_step == message.point_step * message.width
    data = np.frombuffer(bytes(message.data), np.uint8).reshape(message.height, message.width, message.point_step)
    colors = data[..., [14, 13, 12]] if names[3:] == [("rgb", 12, 7, 1)] else None
    return data[..., :12].copy().view("<f4"), colors


def matrix(transform):
    """The transform from child to parent, (4, 4)."""
    t, q = transform.transform.translation, transform.transform.rotation
    x, y, z, w = q.x, q.y, q.z, q.w
    result = np.eye(4)
    result[:3, :3] = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
    ]
    result[:3, 3] = [t.x, t.y, t.z]
    return result


def world_from(frame, topics, stamp):
    """The transform from a frame to the world at a time."""
    transforms = [t for m in topics["/tf_static"][-1:] for t in m.transforms]
    transforms += [
        t for m in topics["/tf"] for t in m.transforms if (t.header.stamp.sec, t.header.stamp.nanosec) == stamp
    ]
    parents = {t.child_frame_id: t for t in transforms}
    assert len(parents) == len(transforms)
    result = np.eye(4)
    while frame != "world":
        result = matrix(parents[frame]) @ result
        frame = parents[frame].header.frame_id
    return result


@pytest.fixture(scope="module")
def seen():
    """A camera in front of a tilted wall, its poses, and its ground-truth depth, measured depth and colour images."""
    device = oaktwin.Device("OAK4-D")
    camera = device.depth_camera().resized(*SIZE, rule="depthai")
    sensor = oaktwin.DepthSensor(device, seed=3)
    wall = np.array([[4, -9, -9], [3, 9, -9], [3.5, 0, 1.3]])
    scene = oaktwin.Scene.from_triangles(wall, np.array([[0, 1, 2]]))
    poses = np.stack([oaktwin.look_at((0, y, 1), (3, 0, 1)) for y in (-0.5, 0.0, 0.7)])
    frames = scene.render(camera, poses, annotators=["rgb", "distance_to_image_plane"])
    depth = frames["distance_to_image_plane"]
    assert np.isinf(depth).any() and np.isfinite(depth).any()
    measured = np.stack([sensor(one, frame=frame) for frame, one in enumerate(depth)])
    assert (measured == 0).any()
    return camera, poses, depth, measured, frames["rgb"]


def record(path, seen, **options):
    camera, poses, depth, measured, rgb = seen
    with oaktwin.Recording(path) as recording:
        for frame, pose in enumerate(poses):
            recording.log(
                camera, pose, frame=frame, depth=depth[frame], measured=measured[frame], rgb=rgb[frame], **options
            )
        assert not path.exists()
    assert os.listdir(path.parent) == [path.name]


def test_everything_is_read_back(tmp_path, seen):
    camera, poses, depth, measured, rgb = seen
    path = tmp_path / "a.mcap"
    record(path, seen, name="oak")
    topics = messages(path)
    assert {topic: len(found) for topic, found in topics.items()} == {
        "/oak/rgb": 3,
        "/oak/depth": 3,
        "/oak/measured": 3,
        "/oak/measured_points": 3,
        "/oak/camera_info": 3,
        "/tf": 3,
        "/tf_static": 1,
    }
    for frame, pose in enumerate(poses):
        stamp = (0, round(frame * 1e9 / 30))
        of = {name: topics[f"/oak/{name}"][frame] for name in ["rgb", "depth", "measured", "measured_points", "camera_info"]}
        for message in of.values():
            assert message.header.frame_id == "oak_optical_frame"
            assert (message.header.stamp.sec, message.header.stamp.nanosec) == stamp
        np.testing.assert_array_equal(array(of["rgb"]), rgb[frame, ..., :3])
        np.testing.assert_array_equal(array(of["depth"]), depth[frame])
        np.testing.assert_array_equal(array(of["measured"]), np.where(measured[frame] > 0, measured[frame], np.nan))

        info = of["camera_info"]
        assert (info.width, info.height, info.distortion_model) == (*SIZE, "plumb_bob")
        np.testing.assert_array_equal(np.reshape(info.k, (3, 3)), camera.K)
        np.testing.assert_array_equal(np.reshape(info.p, (3, 4)), np.hstack([camera.K, np.zeros((3, 1))]))
        np.testing.assert_array_equal(np.reshape(info.r, (3, 3)), np.eye(3))
        assert list(info.d) == [0] * 5

        # The poses of the body frame and of the optical frame.
        np.testing.assert_allclose(world_from("oak_optical_frame", topics, stamp), pose, atol=1e-12)
        np.testing.assert_allclose(
            world_from("oak", topics, stamp), pose @ np.linalg.inv(BODY_FROM_OPTICAL), atol=1e-12
        )

        # Points agree with the measured depth, in the image and in the world.
        points, colors = cloud(of["measured_points"])
        valid = measured[frame] > 0
        assert np.isnan(points[~valid]).all() and not of["measured_points"].is_dense
        np.testing.assert_array_equal(colors, rgb[frame, ..., :3])
        v, u = np.nonzero(valid)
        projected = points[valid] @ camera.K.T
        np.testing.assert_allclose(projected[:, :2] / projected[:, 2:], np.stack([u, v], axis=1), atol=1e-4)
        np.testing.assert_array_equal(points[valid][:, 2], measured[frame][valid])
        # Ground-truth points are on the wall's plane in the world.
        exact = points[valid] * (depth[frame] / np.where(measured[frame] > 0, measured[frame], 1))[valid][:, None]
        exact = exact[np.isfinite(exact[:, 2])]
        in_world = exact @ pose[:3, :3].T + pose[:3, 3]
        a, b, c = np.array([[4, -9, -9], [3, 9, -9], [3.5, 0, 1.3]])
        normal = np.cross(b - a, c - a)
        distance = (in_world - a) @ (normal / np.linalg.norm(normal))
        assert len(distance) > 100 and np.abs(distance).max() < 1e-5


def test_rosbags_reads_the_same(tmp_path, seen):
    rosbag2 = pytest.importorskip("rosbags.rosbag2", reason="rosbags is not installed")
    typesys = pytest.importorskip("rosbags.typesys")
    path = tmp_path / "a.mcap"
    record(path, seen, name="oak")
    expected = messages(path)
    # ROS's own types, not those in the file.
    store = typesys.get_typestore(typesys.Stores.ROS2_HUMBLE)
    found = {}
    with rosbag2.Reader(path) as reader:
        assert reader.message_count == 19
        for connection, time, data in reader.messages():
            message = store.deserialize_cdr(data, connection.msgtype)
            # Serializing a message with ROS gives the same bytes.
            assert bytes(store.serialize_cdr(message, connection.msgtype)) == bytes(data)
            found.setdefault(connection.topic, []).append(message)
            if connection.topic == "/oak/rgb":
                assert time == message.header.stamp.sec * 10**9 + message.header.stamp.nanosec
            if connection.topic == "/tf_static":
                assert connection.ext.offered_qos_profiles[0].durability.name == "TRANSIENT_LOCAL"
    assert {topic: len(of) for topic, of in found.items()} == {topic: len(of) for topic, of in expected.items()}
    for frame in range(3):
        for name in ["rgb", "depth", "measured"]:
            topic = f"/oak/{name}"
            np.testing.assert_array_equal(array(found[topic][frame]), array(expected[topic][frame]))
        np.testing.assert_array_equal(found["/oak/camera_info"][frame].k, expected["/oak/camera_info"][frame].k)


def test_rerun_opens_it(tmp_path, seen):
    chunk = pytest.importorskip("rerun.chunk", reason="rerun-sdk is not installed")
    path = tmp_path / "a.mcap"
    record(path, seen, name="oak")
    entities = {found.entity_path for found in chunk.McapReader(path).stream()}
    assert {"/oak/rgb", "/oak/depth", "/oak/measured", "/oak/measured_points", "/oak/camera_info"} <= entities


def test_the_same_calls_give_the_same_bytes(tmp_path, seen):
    for name in "ab":
        (tmp_path / name).mkdir()
        record(tmp_path / name / "x.mcap", seen)
    assert (tmp_path / "a/x.mcap").read_bytes() == (tmp_path / "b/x.mcap").read_bytes()


def test_options(tmp_path, seen):
    camera, poses, depth, _, rgb = seen
    path = tmp_path / "a.mcap"
    millimetres = np.where(np.isfinite(depth[0]), depth[0] * 1000, 0).astype(np.uint16)
    fisheye = oaktwin.Camera(SIZE, hfov_deg=100, distortion=[0.1, 0.02], lens="fisheye", name="2nd cam")
    lens = oaktwin.Camera(SIZE, hfov_deg=60, distortion=[0.1, 0.02, 0, 0, 0, 0, 0, 0.3])
    with oaktwin.Recording(path) as recording:
        recording.log(camera, poses[0], time=12.5, depth=millimetres)
        recording.log(camera, poses[1], time=13.5, depth=np.asfortranarray(depth[1]), rgb=rgb[1, ..., :3], points=False)
        recording.log(fisheye, poses[0].tolist(), time=13.5)
        recording.log(lens, poses[0], time=14, name="lens")
        assert "3 cameras, 4 images" in repr(recording)
    topics = messages(path)
    own = {f"/{camera.name}/{what}" for what in ["camera_info", "depth", "depth_points", "rgb"]}
    assert set(topics) == own | {"/_2nd_cam/camera_info", "/lens/camera_info", "/tf", "/tf_static"}
    of = topics[f"/{camera.name}/depth"]
    assert [message.encoding for message in of] == ["16UC1", "32FC1"]
    np.testing.assert_array_equal(array(of[0]), millimetres)
    points, colors = cloud(topics[f"/{camera.name}/depth_points"][0])
    assert colors is None
    np.testing.assert_array_equal(np.nan_to_num(points[..., 2]), (millimetres / 1000).astype(np.float32))
    info = topics["/_2nd_cam/camera_info"][0]
    assert (info.distortion_model, list(info.d)) == ("equidistant", [0.1, 0.02, 0, 0])
    info = topics["/lens/camera_info"][0]
    assert (info.distortion_model, list(info.d)) == ("rational_polynomial", [0.1, 0.02, 0, 0, 0, 0, 0, 0.3])
    # Late subscribers get only the last message, so it contains all frames.
    assert len(topics["/tf_static"][-1].transforms) == 3


def test_invalid_calls_are_rejected(tmp_path, seen):
    camera, poses, depth, _, rgb = seen
    with pytest.raises(oaktwin.Error, match="name an .mcap file"):
        oaktwin.Recording(tmp_path / "a.bag")
    with pytest.raises(FileNotFoundError, match="make the folder first"):
        oaktwin.Recording(tmp_path / "no/a.mcap")
    other = oaktwin.Camera((20, 20), hfov_deg=60, name=camera.name)
    with oaktwin.Recording(tmp_path / "a.mcap") as recording:
        for wrong, message in [
            (dict(depth=depth), "pass an image of the camera"),
            (dict(measured=depth[0, 1:]), "measured: has shape"),
            (dict(rgb=rgb[0, 1:]), "rgb: has shape"),
            (dict(time=-1.0), "out of range"),
            (dict(time=float("nan")), "out of range"),
        ]:
            with pytest.raises(oaktwin.Error, match=message):
                recording.log(camera, poses[0], **wrong)
        with pytest.raises(oaktwin.Error, match="contains several poses"):
            recording.log(camera, poses)
        with pytest.raises(TypeError):
            recording.log(camera, poses[0], depth=depth[0].astype(np.int32))
        recording.log(camera, poses[0], depth=depth[0])
        with pytest.raises(oaktwin.Error, match="is already the name"):
            recording.log(other, poses[0])
    recording.close()
    assert "closed" in repr(recording)
    with pytest.raises(oaktwin.Error, match="is closed"):
        recording.log(camera, poses[0])
    # Rejected calls write no messages.
    assert {topic: len(of) for topic, of in messages(tmp_path / "a.mcap").items()} == {
        f"/{camera.name}/depth": 1,
        f"/{camera.name}/depth_points": 1,
        f"/{camera.name}/camera_info": 1,
        "/tf": 1,
        "/tf_static": 1,
    }


def test_an_exception_leaves_nothing(tmp_path, seen):
    camera, poses, depth, *_ = seen
    with pytest.raises(ZeroDivisionError):
        with oaktwin.Recording(tmp_path / "a.mcap") as recording:
            recording.log(camera, poses[0], depth=depth[0])
            1 / 0
    recording = oaktwin.Recording(tmp_path / "a.mcap")
    recording.log(camera, poses[0], depth=depth[0])
    del recording
    assert list(tmp_path.iterdir()) == []


@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="a disk that is full is Linux's")
def test_a_full_disk_is_an_oserror(tmp_path, seen):
    camera, poses, depth, *_ = seen
    (tmp_path / "a.mcap").symlink_to("/dev/full")
    recording = oaktwin.Recording(tmp_path / "a.mcap")
    recording.log(camera, poses[0], depth=depth[0])
    with pytest.raises(OSError, match="no space left"):
        recording.close()


def rerun(home, *arguments):
    """Rerun's program, with usage statistics disabled."""
    environment = {**os.environ, "HOME": str(home), "XDG_CONFIG_HOME": str(home / "config")}
    command = [sys.executable, "-m", "rerun_cli"]
    for words in [["analytics", "disable"], arguments]:
        done = subprocess.run([*command, *map(str, words)], capture_output=True, text=True, env=environment)
        assert done.returncode == 0, done.stderr
    return done.stdout


def columns(path):
    """The contents of an .rrd: from (entity, component) to times in nanoseconds (0 if static) and values, in order of time."""
    chunk = pytest.importorskip("rerun.chunk", reason="rerun-sdk is not installed")
    rows = {}
    for found in chunk.RrdReader(path).stream():
        batch = found.to_record_batch()
        has_time = "time" in batch.schema.names
        times = batch.column("time").cast("int64").to_pylist() if has_time else [0] * batch.num_rows
        for name in batch.schema.names:
            if ":" in name:
                values = zip(times, batch.column(name).to_pylist())
                rows.setdefault((found.entity_path, name), []).extend(values)
    return {key: sorted(values, key=lambda row: row[0]) for key, values in rows.items()}


WALL = "v 3 -9 -9\nv 3.5 9 -9\nv 3 0 1.6\nf 1 2 3\n"
PATH = "10.25 0 0 1 0 0 0 1\n10.5 0 0.5 1 0 0 0 1\n"


def by_the_program(program, folder, file):
    """Two frames of an OAK, as files and as a recording."""
    (folder / "wall.obj").write_text(WALL)
    (folder / "path.txt").write_text(PATH)
    options = "--up z --model oak4-d --engine single-view --resolution 64x40 --annotators rgb,distance_to_image_plane,depth_sensor_distance"
    done = subprocess.run(
        [os.path.abspath(program), "render", "wall.obj", *options.split(), "--trajectory", "path.txt", "-o", "out", "--record", file],
        capture_output=True,
        text=True,
        cwd=folder,
    )
    assert done.returncode == 0, done.stderr
    load = lambda name: [np.load(folder / f"out/{name}_{frame:04}.npy") for frame in range(2)]
    return load("distance_to_image_plane"), load("depth_sensor_distance")


def test_the_programs_mcap(tmp_path):
    if not os.environ.get("OAKTWIN_BIN"):
        pytest.skip("OAKTWIN_BIN names no program: run by cargo xtask test")
    depth, measured = by_the_program(os.environ["OAKTWIN_BIN"], tmp_path, "a.mcap")
    topics = messages(tmp_path / "a.mcap")
    name = "Camera_pseudo_depth"
    camera = oaktwin.Device("OAK4-D").depth_camera().resized(64, 40, rule="depthai")
    for frame, (nanosec, y) in enumerate([(250_000_000, 0.0), (500_000_000, 0.5)]):
        np.testing.assert_array_equal(array(topics[f"/{name}/depth"][frame]), depth[frame])
        expected = np.where(measured[frame] > 0, measured[frame], np.nan)
        np.testing.assert_array_equal(array(topics[f"/{name}/measured"][frame]), expected)
        np.testing.assert_array_equal(np.reshape(topics[f"/{name}/camera_info"][frame].k, (3, 3)), camera.K)
        # The body moves, and the camera with it.
        world_from_oak = world_from("oak", topics, (10, nanosec))
        np.testing.assert_allclose(world_from_oak[:3, 3], [0, y, 1], atol=1e-12)
        frame_id = topics[f"/{name}/camera_info"][frame].header.frame_id
        assert frame_id == "oak_stereo_depth_camera_optical_frame"
        pose = world_from(frame_id, topics, (10, nanosec))
        np.testing.assert_allclose(pose, world_from_oak @ camera.body_from_camera, atol=1e-12)
        points, _ = cloud(topics[f"/{name}/measured_points"][frame])
        in_world = points[~np.isnan(points[..., 2])] @ pose[:3, :3].T + pose[:3, 3]
        a, b, c = [np.array(line.split()[1:], float) for line in WALL.splitlines()[:3]]
        normal = np.cross(b - a, c - a)
        distance = (in_world - a) @ (normal / np.linalg.norm(normal))
        assert len(distance) > 100 and np.median(np.abs(distance)) < 0.05
