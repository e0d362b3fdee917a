"""Filters of `oaktwin.warp.DepthSensor`, and parameters of each environment: the bits of `oaktwin.DepthSensor`."""

import numpy as np
import pytest

import oaktwin

wp = pytest.importorskip("warp")
ow = pytest.importorskip("oaktwin.warp")

from test_warp import SIZES, TABLES, both, device_of, scene  # noqa: E402

pytestmark = pytest.mark.filterwarnings("ignore::oaktwin.FindingWarning")
CHAINS = [
    ["median:size=3"],
    ["median:size=5"],
    ["median:size=7"],
    ["spatial"],
    ["spatial:alpha=0.3,delta=40,radius=5,iterations=2"],
    ["spatial:alpha=0,delta=255,radius=255"],
    ["speckle"],
    ["speckle:range=7,difference=1"],
    ["speckle:range=0"],
    ["decimation:factor=2,mode=NON_ZERO_MEDIAN"],
    ["decimation:factor=3,mode=NON_ZERO_MEAN"],
    ["decimation:factor=4"],
    ["threshold:min=700,max=4000"],
    ["brightness"],
    [
        "threshold:min=700,max=4000",
        "median:size=3",
        "speckle:range=20,difference=3",
        "spatial:delta=20,radius=3",
        "decimation:factor=2,mode=NON_ZERO_MEDIAN",
        "speckle:range=3",
        "median:size=5",
    ],
]


@pytest.mark.parametrize("engine", TABLES)
@pytest.mark.parametrize("filters", CHAINS, ids=lambda filters: filters[0] if len(filters) == 1 else "all")
def test_filters_have_the_same_bits_and_reasons(engine, filters):
    device = device_of(engine)
    reference, sensor = both(device, engine=engine, filters=filters)
    plain = oaktwin.DepthSensor(device, seed=7, engine=engine)
    changes = False
    for size in SIZES:
        depth = scene(size)
        expected = reference(depth, frame=3)
        codes = np.full(expected.shape, 99, np.uint8)
        measured = sensor(depth, frame=3, reasons=codes)
        assert np.array_equal(measured, expected), size
        assert np.array_equal(sensor(depth, frame=3), expected), size
        reason = reference.annotate(depth[0], annotators=["depth_sensor_reason"], frame=3)["depth_sensor_reason"]
        assert np.array_equal(codes[0], reason), size
        assert np.array_equal(codes == 0, expected > 0)
        changes |= not np.array_equal(expected, plain(depth, frame=3))
    # What is compared depends on the filter.
    idle = {"stereo-noise": [["brightness"]], "time-of-flight": [["brightness"], ["speckle:range=0"]]}
    assert changes == (filters not in idle.get(engine, []))


def test_random_chains_have_the_same_bits():
    random = np.random.default_rng(6)
    settings = {
        "median": lambda: f"size={random.choice([3, 5, 7])}",
        "spatial": lambda: f"alpha={random.random():.3f},delta={random.integers(256)},radius={random.integers(9)}",
        "speckle": lambda: f"range={random.integers(60)},difference={random.integers(9)}",
        "decimation": lambda: f"factor={random.integers(1, 5)},mode={random.choice(['PIXEL_SKIPPING', 'NON_ZERO_MEAN', 'NON_ZERO_MEDIAN'])}",
        "threshold": lambda: f"min={random.integers(1500)},max={random.integers(2000, 9000)}",
        "temporal": lambda: f"alpha={random.random():.3f},delta={random.integers(256)}",
    }
    for number in range(40):
        engine = list(TABLES)[number % len(TABLES)]
        filters = [f"{name}:{settings[name]()}" for name in random.choice(list(settings), random.integers(1, 5))]
        # An image that is one pixel wide would be one with a channel.
        depth = scene((2, random.integers(1, 60), random.integers(2, 60)), seed=number)
        reference, sensor = both(device_of(engine), engine=engine, filters=filters)
        for frame in (number, number + 1):
            assert np.array_equal(sensor(depth, frame=frame), reference(depth, frame=frame)), (filters, depth.shape)


PERSISTENCIES = ["PERSISTENCY_OFF", "VALID_8_OUT_OF_8", "VALID_2_IN_LAST_3", "VALID_2_IN_LAST_4", "VALID_2_OUT_OF_8"] + [
    *(f"VALID_1_IN_LAST_{count}" for count in (2, 5, 8)),
    "PERSISTENCY_INDEFINITELY",
]


@pytest.mark.parametrize("persistency", PERSISTENCIES)
def test_temporal_filters_remember_each_environment(persistency):
    """Frames of which some show nothing, and environments that start anew."""
    for number, (engine, before) in enumerate([("stereo-noise", []), ("time-of-flight", ["median:size=3"]), ("single-view", ["threshold:min=300"])]):
        alpha, delta = [(0.4, 3), (0.15, 200), (1.0, 20)][number]
        filters = [*before, f"temporal:alpha={alpha},delta={delta},persistency={persistency}", "speckle:range=3"]
        reference, sensor = both(device_of(engine), engine=engine, filters=filters)
        kept = False
        for frame in range(22):
            depth = scene((3, 17, 23), seed=frame // 12)
            is_empty = frame % 11 == 10
            if is_empty:
                depth[:] = np.inf
            if frame in (10, 15):
                items = [[0, 2], np.array([False, True, False])][frame == 15]
                reference.reset(items)
                sensor.reset(items)
            expected = reference(depth, frame=frame)
            codes = np.full(expected.shape, 99, np.uint8)
            assert np.array_equal(sensor(depth, frame=frame, reasons=codes), expected), (engine, frame)
            assert np.array_equal(codes == 0, expected > 0)
            kept |= is_empty and bool((expected > 0).any())
        # Noise larger than delta begins anew, so that 8 frames in a row are rare.
        assert kept == (persistency != "PERSISTENCY_OFF") or persistency == "VALID_8_OUT_OF_8", engine
        for one in (reference, sensor):
            one.reset()
        assert np.array_equal(sensor(depth, frame=30), reference(depth, frame=30))


def test_what_a_reset_of_environments_rejects(device):
    sensor = ow.DepthSensor(device, on="cpu", filters=["temporal"])
    sensor.reset()
    sensor(scene((3, 17, 23)))
    for items, message in [([3], "pass numbers from 0 to 2, or a mask"), ([True], r"items: a mask of shape \(1,\)"), (["x"], "are not numbers")]:
        with pytest.raises(oaktwin.Error, match=message):
            sensor.reset(items)


def test_values_of_all_16_bits():
    """Depth of more than 32 m has the highest bit, which OpenCV's speckle filter reads as a sign."""
    depth = np.random.default_rng(2).uniform(20, 70, (2, 30, 40)).astype(np.float32)
    depth[:, 10:20] = np.linspace(32.7, 32.8, 40, dtype=np.float32)
    for filters in (["speckle:range=30,difference=9"], ["median:size=7"], ["spatial:delta=255"], ["decimation:factor=4,mode=NON_ZERO_MEAN"]):
        options = dict(engine="single-view", parameters={"maxDistance": 100.0, "outlierRemovalEnabled": 0}, filters=filters)
        reference, sensor = both(device_of("single-view"), **options)
        assert np.array_equal(sensor(depth, frame=1), reference(depth, frame=1)), filters


def test_presets_and_shapes(device):
    sensor = ow.DepthSensor(device, on="cpu", preset="robotics", filters=["decimation:factor=2"])
    reference = oaktwin.DepthSensor(device, preset="robotics", filters=["decimation:factor=2"])
    depth = scene((3, 60, 107))
    assert sensor.filters == reference.filters == ["decimation:factor=2,mode=PIXEL_SKIPPING"]
    assert np.array_equal(sensor(depth, frame=0), reference(depth, frame=0))
    assert sensor(depth[..., None]).shape == (3, 30, 53, 1)
    assert sensor(depth[:0]).shape == (0, 30, 53)
    out = np.empty((3, 30, 53), np.uint16)
    assert sensor(depth, frame=0, out=out) is out and np.array_equal(out, reference(depth, frame=0, out=np.empty_like(out)))
    with pytest.raises(oaktwin.Error, match=r"out: has the shape \(3, 60, 107\), and measured depth \(3, 30, 53\)"):
        sensor(depth, out=depth)
    with pytest.raises(oaktwin.Error, match=r"reasons: pass a C-contiguous uint8 array of shape \(3, 30, 53\)"):
        sensor(depth, reasons=np.empty((3, 60, 107), np.uint8))


def test_read_only_outputs_are_rejected(device):
    sensor = ow.DepthSensor(device, on="cpu")
    for name, dtype in [("out", np.float32), ("reasons", np.uint8)]:
        given = np.zeros((3, 60, 106), dtype)
        given.flags.writeable = False
        with pytest.raises(oaktwin.Error, match=f"{name}: is read-only; pass an array that can be written to"):
            sensor(scene((3, 60, 106)), **{name: given})
        assert not given.any()


def test_a_stream_of_filtered_images(device):
    filters = ["median:size=3", "decimation:factor=2"]
    reference, sensor = both(device, filters=filters)
    streams = [oaktwin.Stream(sensor, latency=(0.0, 0.06), drop=0.1, history=2) for sensor in (reference, sensor)]
    for step in range(8):
        seen = [stream(scene((4, 30, 53), seed=step)) for stream in streams]
        assert seen[0].depth.shape == (4, 2, 15, 26)
        assert all(np.array_equal(a, b) for a, b in zip(*seen))


VALUES = {
    "time-of-flight": {
        "phaseUnwrapErrorThreshold": [0, 30, 100],
        "wiggling": [0.0, 0.4, 0.1],
        "wigglingResidual": [0.0, 0.1, 0.01],
        "fixedPattern": [0.05, 0.0, 0.02],
        "bias": [-0.2, 0.0, 0.1],
        "signal": [50.0, 1e6, 3000.0],
        "contrast": [0.1, 0.8, 0.5],
        "ambient": [0.0, 5000.0, 50.0],
        "readNoise": [0.0, 100.0, 5.0],
        "fullWell": [3000.0, 1e5, 20000.0],
        "albedo": [0.05, 0.5, 0.9],
        "pixelMixing": [0.0, 0.25, 0.1],
        "radialVelocity": [-3.0, 0.0, 1.0],
        "measurementInterval": [0.1, 0.01, 0.02],
        "minAmplitude": [0.0, 60.0, 5.0],
        "confidenceThreshold": [0.0, 120.0, 0.1],
    },
    "single-view": {
        "baselineMM": [-75.0, 20.0, 55.0],
        "focalLengthPixel": [300.0, 897.0, 500.0],
        "sensorSizePixel": [640.0, 1280.0, 800.0],
        "maxDisparityPixel": [3.0, 400.0, 110.0],
        "minDistance": [0.0, 1.5, 0.5],
        "maxDistance": [3.5, 1e30, 5.0],
        "noiseMean": [0.0, 2.0, 0.25],
        "noiseSigma": [0.0, 3.0, 0.25],
        "outlierRemovalEnabled": [0, 1, 12],
    },
}


@pytest.mark.parametrize("engine", VALUES)
def test_every_parameter_of_each_environment(engine):
    from oaktwin.warp._sensor import ENGINES

    assert set(ENGINES[engine].PER_WORLD) == set(VALUES[engine])
    device, depth = device_of(engine), scene((3, 31, 45))
    needed = {"fixedPattern": {"enableFPPNCorrection": False}, "measurementInterval": {"radialVelocity": 2.0}}
    for name, values in VALUES[engine].items():
        fixed = needed.get(name, {})
        measured = ow.DepthSensor(device, on="cpu", seed=7, engine=engine, parameters={name: values, **fixed})(depth, frame=2)
        references = [oaktwin.DepthSensor(device, seed=7, engine=engine, parameters={name: value, **fixed})(depth, frame=2) for value in values]
        assert all(np.array_equal(measured[item], references[item][item]) for item in range(3)), name


def test_units_of_time_of_flight():
    device, depth = oaktwin.Device("OAK-D ToF"), scene((4, 31, 45))
    units = ow.DepthSensor(device, on="cpu", seed=7, device_seed=range(4))
    assert len(set(units.parameters["bias"])) == 4
    assert np.array_equal(units(depth, frame=2), oaktwin.DepthSensor(device, seed=7)(depth, frame=2, device_seed=[0, 1, 2, 3]))


def test_drift(device):
    depth = scene((4, 31, 45))
    for drift in ({"yaw": 0.3}, {"yaw": -20.0, "pitch": 2.0, "roll": 5.0, "baseline": 500.0}, {"temperature": 30.0}, {"focalLength": -9000.0}):
        reference, sensor = both(device, drift=drift)
        assert np.array_equal(sensor(depth, frame=1), reference(depth, frame=1)), drift
    drifts = [{}, {"yaw": 0.3}, {"baseline": 200.0, "roll": 1.0}, {"yaw": -20.0}]
    own = ow.DepthSensor(device, on="cpu", seed=7, drift=drifts, device_seed=[3, 4, 5, 6], filters=["median:size=3"])
    measured = own(depth, frame=2)
    for item, drift in enumerate(drifts):
        reference = oaktwin.DepthSensor(device, seed=7, drift=drift, device_seed=3 + item, filters=["median:size=3"])
        assert np.array_equal(measured[item], reference(depth, frame=2)[item]), drift
    assert len({image.tobytes() for image in own(np.repeat(depth[:1], 4, axis=0), frame=2)}) == 4
    with pytest.raises(oaktwin.Error, match="drift: has 4 values, and device_seed 1"):
        ow.DepthSensor(device, on="cpu", drift=drifts, device_seed=[1])
    with pytest.raises(oaktwin.Error, match="drift: is empty; pass one for each environment"):
        ow.DepthSensor(device, on="cpu", drift=[])
    with pytest.raises(oaktwin.Error, match="depth: has 1 images, but parameters have 4 values"):
        own(depth[:1])
    with pytest.raises(oaktwin.Error, match="yawn"):
        ow.DepthSensor(device, on="cpu", drift=[{"yawn": 1.0}])


def test_a_unit_with_the_baseline_of_its_design():
    """The processor of a calibrated unit may assume another baseline than its cameras have."""
    unit = oaktwin.Device("OAK-D").population(1, seed=3)[0]
    reference, sensor = both(unit)
    depth = scene((2, 31, 45))
    assert np.array_equal(sensor(depth, frame=1), reference(depth, frame=1))
