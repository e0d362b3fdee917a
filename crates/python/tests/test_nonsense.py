"""Nonsensical numbers lead to exceptions or results, never to a panic (which is not an `Exception`)."""

import itertools

import numpy as np
import pytest

import oaktwin

NUMBERS = [0, -1, 1e-300, 1e300, float("nan"), float("inf"), -float("inf"), 1 << 31, (1 << 32) - 1, 1 << 40]


def tried(call, *arguments, **options):
    try:
        return call(*arguments, **options)
    except (oaktwin.Error, OverflowError, TypeError, MemoryError):
        return None


@pytest.mark.parametrize("number", NUMBERS)
@pytest.mark.filterwarnings("ignore::oaktwin.FindingWarning", "ignore::RuntimeWarning")
def test_nonsense(device, room, number):
    depth, rgb = room
    left = device.cameras["left"].resized(106, 60)
    tried(left.cropped, number, number, 4, 4)
    wall = oaktwin.Scene.from_triangles(np.array([[-50, -50, 3], [50, -50, 3], [0, 80, 3]]), np.array([[0, 1, 2]]))
    cameras = [
        tried(oaktwin.Camera, (40, 30), hfov_deg=number),
        tried(oaktwin.Camera, (40, 30), K=[[number, 0, number], [0, number, number], [0, 0, 1]]),
        tried(oaktwin.Camera, (40, 30), hfov_deg=60, distortion=[number] * 5),
        tried(oaktwin.Camera, (40, 30), hfov_deg=60, distortion=[number] * 4, lens="fisheye"),
        tried(oaktwin.Camera, (40, 30), hfov_deg=60, near=number),
        tried(oaktwin.Camera, (40, 30), hfov_deg=60, far=number),
        tried(oaktwin.Camera, (40, number), hfov_deg=60),
    ]
    away = np.eye(4)
    away[0, 3] = number
    annotators = ["rgb", "distance_to_camera", "pointcloud", "normals", "bounding_box_2d_loose"]
    for camera, pose in itertools.product([*cameras, left], [np.eye(4), away]):
        if camera is not None and camera.width < 200 and camera.height < 200:
            tried(wall.render, camera, pose, annotators=annotators)
            tried(oaktwin.align, depth, left, camera, target_from_source=pose)
            tried(oaktwin.align, np.ones((camera.height, camera.width), np.float32), camera, left)
    tried(oaktwin.look_at, (number, 0, 0), (1, 2, number))
    for name in ["fx", "hfov_deg", "seed", "device_seed"]:
        sensor = tried(oaktwin.DepthSensor, device, **{name: number})
        if sensor is not None:
            tried(sensor, depth, rgb)
    tried(oaktwin.DepthSensor(device), depth, frame=number)
    for engine in ["stereo-noise", "single-view"]:
        for name in oaktwin.DepthSensor(device, engine=engine).parameters:
            sensor = tried(oaktwin.DepthSensor, device, engine=engine, parameters={name: number})
            if sensor is not None:
                tried(sensor, depth, rgb)
                tried(sensor, depth[None])
                tried(sensor, np.ones((1, 1), np.float32))
    body = oaktwin.Device("OAK-D Pro PoE")
    for options in [{"projector": number}, {"ambient": number}, {"size": (number, 4)}, {"seed": number}, {"frame": number},
                    {"device_seed": number}, {"imager": {"exposure": number, "autoExposure": False}}]:
        tried(wall.render_pair, body, np.eye(4), **{"size": (53, 30), **options})
    tried(wall.render_pair, body, away, size=(53, 30))
    for options in [{"samples": number}, {"height": [number]}, {"tilt_deg": [number]}, {"region_box": [[0] * 3, [number] * 3]}]:
        tried(oaktwin.coverage, wall, body, np.eye(4), **{"samples": 9, "size": (53, 30), **options})
    matchers = [tried(oaktwin.StereoMatcher, **options) for options in
                [{"fx": number, "baseline": 0.1}, {"hfov_deg": number, "baseline": 0.1}, {"fx": 90, "baseline": number}]]
    for name in oaktwin.StereoMatcher(body).parameters:
        matchers.append(tried(oaktwin.StereoMatcher, body, parameters={name: number}))
    for matcher in matchers:
        if matcher is not None:
            tried(matcher, rgb, rgb)
    filters = oaktwin.filters
    image = np.full((9, 12), 800, np.uint16)
    for call, names in [
        (filters.median, ["size"]),
        (filters.spatial, ["alpha", "delta", "radius", "iterations"]),
        (filters.speckle, ["range", "difference"]),
        (filters.decimation, ["factor", "mode"]),
        (filters.threshold, ["min", "max"]),
    ]:
        for name in names:
            tried(call, image, **{name: number})
    for name in ["region", "captures", "devices"]:
        if not (name == "devices" and number in [1 << 31]):
            tried(oaktwin.accuracy, device, **{"distances": [2], "devices": 1, "captures": 1, name: number})
    tried(oaktwin.accuracy, device, distances=[number], devices=1, captures=1)


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf, 0, -1, 1e-38, 1e-45, 3e38])
@pytest.mark.parametrize("shape", [(1, 1), (1, 7), (7, 1), (3, 1, 1), (2, 9, 3)])
def test_every_depth_is_sensed(device, value, shape):
    depth = np.full(shape, value, np.float32)
    for options in [{}, {"engine": "single-view"}, {"preset": "default"},
                    {"filters": [name for name in ["median", "spatial", "temporal", "speckle", "threshold"]]}]:
        got = oaktwin.DepthSensor(device, **options)(depth)
        assert got.shape == shape and np.isfinite(got).all() and (got >= 0).all()
    assert oaktwin.filters.decimation(depth).dtype == np.float32
