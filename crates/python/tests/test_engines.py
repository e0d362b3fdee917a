"""Engines written in Python: what they get, what becomes of what they return, and what they do wrong."""

import copy
import pickle
import threading

import numpy as np
import pytest

import oaktwin
from conftest import run_and_interrupt

BODY = oaktwin.BodyPose(np.eye(4))
SIZE = (160, 100)


class Wall:
    """A matcher that sees a wall at a distance everywhere."""

    name = "wall"

    def __init__(self, metres=2.0):
        self.metres, self.calls = metres, []

    def __call__(self, left, right, focal_length, baseline):
        self.calls.append((left, right, focal_length, baseline, threading.current_thread()))
        return np.full(left.shape, focal_length * baseline / self.metres)


def halves(depth):
    """A sensor that measures the left half of an image."""
    measured = depth.copy()
    measured[:, depth.shape[1] // 2 :] = 0
    return measured


@pytest.fixture(scope="module")
def scene():
    """A wall at 2 m, with a checkerboard of 10 cm."""
    y, z = np.meshgrid(np.arange(-30, 30) / 10, np.arange(-20, 20) / 10)
    corners = np.stack([np.full_like(y, 2), y, z], -1)[..., None, :] + [[0, 0, 0], [0, 0.1, 0], [0, 0.1, 0.1], [0, 0, 0.1]]
    vertices = corners.reshape(-1, 3)
    quads = np.arange(len(vertices)).reshape(-1, 4)
    grey = np.repeat(np.random.default_rng(1).uniform(0.1, 0.9, len(quads)), 4)
    faces = np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
    mesh = oaktwin.Mesh(vertices, faces, color=np.repeat(grey[:, None], 3, 1))
    return oaktwin.Scene.from_meshes({"wall": mesh})


def test_a_matcher_gets_the_rectified_pair(device, scene):
    wall = Wall()
    sensor = oaktwin.DepthSensor(device, engine=wall, seed=4)
    shot = sensor.shoot(scene, BODY, size=SIZE, frame=3)
    pair = scene.render_pair(device, BODY, size=SIZE, seed=4, frame=3)
    [(left, right, focal_length, baseline, thread)] = wall.calls
    assert np.array_equal(left, pair["rectified_left"]) and np.array_equal(right, pair["rectified_right"])
    assert focal_length == pytest.approx(pair["camera"].K[0, 0]) and baseline == pytest.approx(pair["baseline"])
    # Libraries that are bound to a thread work.
    assert thread is threading.current_thread()
    assert np.allclose(shot.depth, 2.0) and shot.depth.dtype == np.float32
    assert sensor.engine == "wall" and sensor.parameters == {} and "wall" in repr(sensor)
    assert np.allclose(shot.camera.K, pair["camera"].K)


def test_a_matcher_matches_pairs_of_images(device, scene):
    pair = scene.render_pair(device, BODY, size=SIZE)
    matched = oaktwin.StereoMatcher(device, engine=Wall())(pair["left"], pair["right"])
    assert np.allclose(matched["depth"], 2.0)
    assert np.allclose(matched["disparity"], pair["camera"].K[0, 0] * pair["baseline"] / 2, rtol=1e-5)
    batch = oaktwin.StereoMatcher(device, engine=Wall())(*(np.stack([pair[side]] * 3) for side in ("left", "right")))
    assert batch["depth"].shape == (3, 100, 160) and np.allclose(batch["depth"], 2.0)


def test_depth_in_depth_out(device, room):
    depth, rgb = room
    seen = {}

    def engine(depth, rgb, focal_length, baseline, frame, seed):
        seen.update(depth=depth, rgb=rgb, focal_length=focal_length, baseline=baseline, frame=frame, seed=seed)
        return np.where(np.isfinite(depth) & (depth > 0), depth, 0)

    sensor = oaktwin.DepthSensor(device, engine=engine, seed=2)
    measured = sensor(depth, rgb, frame=7)
    assert np.array_equal(seen["depth"], depth, equal_nan=True) and np.array_equal(seen["rgb"], rgb)
    assert seen["frame"] == 7 and seen["baseline"] == pytest.approx(0.075)
    valid = np.isfinite(depth) & (depth > 0)
    assert np.array_equal(measured[valid], depth[valid]) and not measured[~valid].any()
    first = seen["seed"]
    sensor(depth, frame=8)
    assert seen["seed"] != first and seen["rgb"] is None
    sensor(depth, frame=7)
    assert seen["seed"] == first
    assert sensor((1000 * np.where(valid, depth, 0)).astype(np.uint16)).dtype == np.uint16


def test_batches_and_noise(device):
    def noise(depth, seed):
        return depth + np.random.default_rng(seed).normal(0, 0.01, depth.shape)

    batch = np.full((3, 40, 60), 2.0, np.float32)
    sensor = oaktwin.DepthSensor(device, engine=noise)
    measured = sensor(batch, frame=0)
    assert 0.009 < measured.std() < 0.011 and (measured[0] != measured[1]).mean() > 0.99
    assert np.array_equal(measured[0], sensor(batch[0], frame=0))
    assert np.array_equal(sensor(batch, frame=0, seed=[5, 6, 5])[0], sensor(batch, frame=0, seed=[5, 6, 5])[2])


def test_filters_run_on_what_it_measures(device, scene):
    rough = np.random.default_rng(3)

    def engine(left, right, focal_length, baseline):
        return focal_length * baseline / 2 + rough.normal(0, 0.3, left.shape)

    def roughness(**options):
        return oaktwin.DepthSensor(device, engine=engine, **options).shoot(scene, BODY, size=SIZE).depth.std()

    plain = roughness()
    assert roughness(filters=["spatial:alpha=0.3,delta=100"]) < 0.7 * plain and roughness(filters=["median:size=5"]) < 0.6 * plain
    # The filters of a preset, of which one decimates.
    sensor = oaktwin.DepthSensor(device, engine=Wall(), filters=["decimation:factor=2"])
    shot = sensor.shoot(scene, BODY, size=SIZE)
    assert shot.depth.shape == (50, 80) and shot.camera.width == 80 and shot.exact_depth.shape == (100, 160)
    assert oaktwin.DepthSensor(device, engine=Wall(), preset="robotics").filters


def test_a_temporal_filter_remembers(device, scene):
    values = iter([2.0, 2.1, 2.0])
    sensor = oaktwin.DepthSensor(
        device, engine=lambda depth: np.full_like(depth, next(values)), filters=["temporal:alpha=0.5,delta=200"]
    )
    image = np.full((20, 30), 2.0, np.float32)
    assert np.allclose(sensor(image), 2.0) and np.allclose(sensor(image), 2.05, atol=1e-3)
    sensor.reset()
    assert np.allclose(sensor(image), 2.0)
    distances = iter([2.0, 2.0, 2.1])
    wall = oaktwin.DepthSensor(
        device, engine=lambda depth: np.full_like(depth, next(distances)), filters=["temporal:alpha=0.5,delta=200"]
    )
    assert np.allclose(wall.shoot(scene, BODY, size=SIZE).depth, 2.0)
    wall.shoot(scene, BODY, size=SIZE)
    assert np.allclose(wall.shoot(scene, BODY, size=SIZE).depth, 2.05, atol=1e-3)


def test_alignment(device):
    sensor = oaktwin.DepthSensor(device, engine=halves)
    measured = sensor(np.full((100, 160), 2.0, np.float32))
    aligned = sensor.align(measured, "rgb", size=(192, 108))
    assert aligned.shape == (108, 192) and 0.3 < (aligned > 0).mean() < 0.7


def test_accuracy_and_coverage_measure_with_it(device, scene):
    sensor = oaktwin.DepthSensor(device, engine=Wall(2.02))
    report = oaktwin.accuracy(sensor, distances=[2.0, 4.0], devices=2, captures=1)
    errors = report.to_numpy()["error_percent"]
    # The wall is 1 % too far at 2 m.
    assert report.report["engine"] == "wall" and errors[0] == pytest.approx(1.0, abs=0.01) and errors[1] > 40
    same = oaktwin.accuracy(device, engine=Wall(2.02), distances=[2.0, 4.0], devices=2, captures=1)
    assert same.report == report.report
    found = oaktwin.coverage(scene, [sensor, oaktwin.DepthSensor(device, engine=halves), device], BODY, samples=2000)
    wall, half, own = found.candidates
    assert [one["engine"] for one in found.candidates] == ["wall", "halves", "stereo-noise"]
    assert wall["measured"] == wall["seen"] > 0.2 and wall["median_error_mm"] == pytest.approx(20, abs=0.1)
    assert half["measured"] == pytest.approx(half["seen"] / 2, abs=0.03) and half["lost"]["not_measured"] > 0
    # Options override the sensor's own.
    other = oaktwin.coverage(scene, sensor, BODY, samples=2000, engine="stereo-noise")
    assert other.best["measured"] == own["measured"]


def test_an_engine_may_use_oaktwin(device, scene):
    """Even where several units are measured at once."""
    inner = oaktwin.DepthSensor(device, engine=Wall())

    def engine(left, right, focal_length, baseline):
        matched = oaktwin.StereoMatcher(fx=focal_length, baseline=baseline, platform="rvc4")(left, right)
        assert np.allclose(inner.shoot(scene, BODY, size=SIZE).depth, 2.0)
        return {"depth": matched["depth"], "confidence": matched["confidence"]}

    report = oaktwin.accuracy(device, engine=engine, distances=[1.0], devices=3, captures=1, region=0.2)
    assert 0 < report.rows[0]["error_percent"] < 2
    pair = scene.render_pair(device, BODY, size=(320, 200))
    ours, own = (oaktwin.StereoMatcher(device, **options)(pair["left"], pair["right"]) for options in ({}, {"engine": engine}))
    assert np.array_equal(ours["depth"], own["depth"]) and np.array_equal(ours["confidence"], own["confidence"])


def test_stereo_matching_shoots(device, scene):
    """The package's own matcher measures what a matcher of rendered pairs measures."""
    sensor = oaktwin.DepthSensor(device, engine="stereo-matching", seed=5)
    pair = scene.render_pair(device, BODY, size=(320, 200), seed=5, frame=2)
    matched = oaktwin.StereoMatcher(device)(pair["left"], pair["right"])
    assert np.array_equal(sensor.shoot(scene, BODY, size=(320, 200), frame=2).depth, matched["depth"])
    with pytest.raises(oaktwin.Error, match="stereo-matching matches image pairs.*use shoot"):
        sensor(np.full((200, 320), 2.0, np.float32))


def test_copies_and_pickles(device, scene):
    sensor = oaktwin.DepthSensor(device, engine=Wall(3.0), seed=1)
    for other in [copy.copy(sensor), pickle.loads(pickle.dumps(sensor))]:
        assert np.allclose(other.shoot(scene, BODY, size=SIZE).depth, 3.0) and other.engine == "wall"
    matcher = pickle.loads(pickle.dumps(oaktwin.StereoMatcher(device, engine=Wall(3.0))))
    pair = scene.render_pair(device, BODY, size=SIZE)
    assert np.allclose(matcher(pair["left"], pair["right"])["depth"], 3.0)


def test_threads_take_turns(device):
    sensor = oaktwin.DepthSensor(device, engine=halves)
    images = [np.full((40, 60), metres, np.float32) for metres in (1.0, 2.0, 3.0, 4.0)]
    found = {}
    threads = [threading.Thread(target=lambda image=image: found.update({image[0, 0]: sensor(image)})) for image in images]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert all(np.array_equal(found[image[0, 0]], halves(image)) for image in images)


def test_confidence(device, scene):
    for confidence, expected in [(np.full((100, 160), 0.5), 128), (np.full((100, 160), 7, np.uint8), 7)]:
        sensor = oaktwin.DepthSensor(device, engine=lambda left, right: {"disparity": left * 0.0 + 5, "confidence": confidence})
        assert (sensor.shoot(scene, BODY, size=SIZE).confidence == expected).all()
    shot = oaktwin.DepthSensor(device, engine=Wall()).shoot(scene, BODY, size=SIZE)
    with pytest.raises(AttributeError, match="has no confidence"):
        shot.confidence
    assert not hasattr(shot, "reasons") and not shot.findings


@pytest.mark.parametrize(
    ("engine", "message"),
    [
        (7, "engine: invalid value 7; pass the name of an engine, or a callable"),
        ("my-network", "unknown engine 'my-network'"),
        (Wall, "engine: wall is a class; pass .* an instance"),
        (lambda image: image, "engine: lambda takes neither an image pair nor depth; name its parameters"),
        (lambda left, right, depth: left, "takes both an image pair and depth"),
        (lambda left, right, network: left, "unknown parameter network; use left, right, focal_length, baseline"),
        (max, "has no signature|takes neither"),
    ],
)
def test_what_is_no_engine(device, engine, message):
    with pytest.raises(oaktwin.Error, match=message):
        oaktwin.DepthSensor(device, engine=engine)


def test_names_of_engines(device):
    class Named:
        name = "Stereo-Noise"

        def __call__(self, depth):
            return depth

    with pytest.raises(oaktwin.Error, match="already an engine named Stereo-Noise; give it another name"):
        oaktwin.DepthSensor(device, engine=Named())
    with pytest.raises(oaktwin.Error, match="gain: unknown parameter of halves"):
        oaktwin.DepthSensor(device, engine=halves, parameters={"gain": 2})
    with pytest.raises(oaktwin.Error, match="engine: halves measures depth images and matches no pairs"):
        oaktwin.StereoMatcher(device, engine=halves)
    with pytest.raises(oaktwin.Error, match="nothing to fit in halves"):
        oaktwin.fit(device, __file__, engine=halves)


@pytest.mark.parametrize(
    ("result", "message"),
    [
        (lambda d: d[1:], r"returned a disparity of shape \(99, 160\); return one of its input's shape, \(100, 160\)"),
        (lambda d: d[None], r"shape \(1, 100, 160\)"),
        (lambda d: (16 * d).astype(np.int16), "dtype int16; return floating-point pixels; divide fixed point by its scale"),
        (lambda d: 160 * d, "returned a disparity of 800 px in images that are 160 px wide"),
        (lambda d: np.where(d > 0, np.nan, d), "is NaN in 16000 of 16000 pixels; return 0 where nothing is measured"),
        (lambda d: d - 6, "is negative in 16000"),
        (lambda d: d + np.inf, "is infinite"),
        (lambda d: None, "returned 'disparity'|returned a NoneType"),
        (lambda d: [[d, 1], 2], "returned a list as disparity"),
        (lambda d: {"depth": d.astype(int)}, "returned a depth of dtype int64; return floating-point metres"),
        (lambda d: {"depth": d, "disparity": d}, "returned 'depth', 'disparity'; return \"disparity\" or \"depth\""),
        (lambda d: {"disparities": d}, "returned 'disparities'"),
        (lambda d: {}, "returned nothing"),
        (lambda d: {"disparity": d, "confidence": 2 * d}, "returned a confidence beyond 0 to 1"),
        (lambda d: {"disparity": d, "confidence": d.astype(np.int32)}, "a confidence of dtype int32; return uint8"),
    ],
)
def test_wrong_results(device, scene, result, message):
    sensor = oaktwin.DepthSensor(device, engine=lambda left, right: result(np.full(left.shape, 5.0)))
    with pytest.raises(oaktwin.Error, match=f"engine: lambda .*({message})"):
        sensor.shoot(scene, BODY, size=SIZE)


def test_exceptions_are_the_cause(device, scene):
    def broken(left, right):
        raise ZeroDivisionError("no texture")

    def broken_too(depth):
        raise ZeroDivisionError("no texture")

    pair = scene.render_pair(device, BODY, size=SIZE)
    of_pairs, of_depth = (oaktwin.DepthSensor(device, engine=engine) for engine in (broken, broken_too))
    image = np.full((2, 20, 30), 2.0, np.float32)
    for call in [
        lambda: of_pairs.shoot(scene, BODY, size=SIZE),
        lambda: of_depth(image[0]),
        lambda: of_depth(image),
        lambda: of_depth.annotate(image[0], annotators=["depth_sensor_distance"]),
        lambda: oaktwin.StereoMatcher(device, engine=broken)(pair["left"], pair["right"]),
        lambda: oaktwin.accuracy(of_pairs, distances=[1.0]),
        lambda: oaktwin.coverage(scene, of_depth, BODY),
    ]:
        with pytest.raises(oaktwin.Error, match="engine: broken.* raised ZeroDivisionError: no texture; correct") as raised:
            call()
        assert isinstance(raised.value.__cause__, ZeroDivisionError)

    def interrupted(depth):
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        oaktwin.DepthSensor(device, engine=interrupted)(image)


def test_an_engine_that_calls_itself(device):
    sensor = oaktwin.DepthSensor(device, engine=lambda depth: sensor(depth))
    with pytest.raises(oaktwin.Error, match="calls a sensor whose engine it is itself; call another sensor"):
        sensor(np.full((20, 30), 2.0, np.float32))


def test_an_engine_may_ask_its_sensor(device):
    """Also of a sensor with a memory."""
    sensor = oaktwin.DepthSensor(device, engine=lambda depth: depth * (sensor.camera.width > 0), filters=["temporal"])
    assert np.allclose(sensor(np.full((20, 30), 2.0, np.float32)), 2.0)


@pytest.mark.parametrize(
    "call", ["sensor(depth)", "sensor(depth[None])", "oaktwin.accuracy(sensor, distances=[1.0])", "sensor.shoot(scene, numpy.eye(4))"]
)
def test_ctrl_c_interrupts_an_engine(call):
    answer = run_and_interrupt(f"""
import time, numpy, oaktwin
def engine(depth):
    print("ready", flush=True)
    for _ in range(3000):
        time.sleep(0.1)
    return depth
depth = numpy.full((20, 30), 2, numpy.float32)
scene = oaktwin.Scene.from_triangles([[2, -9, -9], [2, 9, -9], [2, 0, 9]], [[0, 1, 2]])
sensor = oaktwin.DepthSensor(oaktwin.Device("OAK4-D"), engine=engine)
try:
    {call}
except KeyboardInterrupt:
    print("interrupted")
""")
    assert answer.splitlines()[-1] == "interrupted"
