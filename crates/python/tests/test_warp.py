"""`oaktwin.warp.DepthSensor` measures the bits of `oaktwin.DepthSensor`."""

import itertools

import numpy as np
import pytest

import oaktwin

wp = pytest.importorskip("warp")
ow = pytest.importorskip("oaktwin.warp")

SIZES = [(3, 60, 106), (2, 1, 2), (2, 7, 33), (2, 64, 64), (1, 45, 320), (2, 37, 129)]
# Two values besides the default of every parameter that changes a measurement, and what it needs to have an effect.
STEREO = {
    "focalLength": [300.0, 1500.0],
    "baseline": [0.03, 0.2],
    "width": [320, 640],
    "subpixel": [False],
    "subpixelFractionalBits": ["3", "4"],
    "extendedDisparity": [True],
    "disparityShift": [10, 60],
    "occlusion": [False],
    "leftRightCheck": [False],
    "leftRightCheckThreshold": [0, 40],
    "numInvalidateEdgePixels": [1, 100],
    "edgeDilation": [6.0, 25.0],
    "dropout": [0.001, 0.3],
    "bias": [-0.4, 2.0],
    "pixelLocking": [0.0, 0.9],
    "jitter": [0.0, 3.0],
    "closeRangeFactor": [1.0, 4.0],
    "window": [1, 21, 63],
    "depthRounding": ["truncate"],
}
WITH = {
    "max-disparity": {"maxDisparityPixel": 2.0},
    "max-disparity-unit": {"maxDisparityPixel": 20.0},
    "leftRightCheck": {"edgeDilation": 20.0},
    "leftRightCheckThreshold": {"edgeDilation": 20.0},
    "occlusion": {"edgeDilation": 20.0},
}
SINGLE = {
    "baselineMM": [-75.0, 20.0],
    "focalLengthPixel": [300.0],
    "sensorSizePixel": [640.0],
    "maxDisparityPixel": [3.0, 400.0],
    "minDistance": [0.0, 1.5],
    "maxDistance": [3.5, 1e30],
    "noiseMean": [0.0, 2.0],
    "noiseSigma": [0.0, 3.0],
    "noiseDownscaleFactorPixel": [1.0, 2.5, 9.0],
    "outlierRemovalEnabled": [0, 1, 12, 63],
    "depth": ["recomputed"],
    "max-disparity-unit": ["sensor"],
    "max-disparity": ["clamp"],  # with a limit that is reached
    "range-cut": ["after"],
    "direction": ["left"],
    "target-rounding": ["floor"],
    "collision": ["last"],
    "quantizer": ["floor"],
    "sigma-unit": ["steps"],
    "outlier-neighbourhood": ["4"],
}
FLIGHT = {
    "focalLength": [200.0],
    "width": [320],
    "principalPoint": ["300,250.5"],
    "modulationFrequencies": ["20,100", "83.1,97.3"],
    "enablePhaseUnwrapping": [False],
    "phaseUnwrappingLevel": [0, 1, 5],
    "phaseUnwrapErrorThreshold": [0, 30],
    "enablePhaseShuffleTemporalFilter": [False],
    "enableBurstMode": [True],
    "enableOpticalCorrection": [False],
    "enableWiggleCorrection": [False],
    "wiggling": [0.0, 0.4],
    "wigglingResidual": [0.0, 0.1],
    "enableFPPNCorrection": [False],
    "fixedPattern": [0.05],
    "bias": [-0.2],
    "signal": [50.0, 1e6],
    "contrast": [0.1],
    "ambient": ["outdoor"],
    "readNoise": [0.0, 100.0],
    "fullWell": [3000.0],
    "albedo": [0.05],
    "pixelMixing": [0.0, 0.25],
    "radialVelocity": [-3.0],
    "measurementInterval": [0.1],
    "minAmplitude": [0.0, 60.0],
    "confidenceThreshold": [0.0, 120.0],
}
WITH |= {"fixedPattern": {"enableFPPNCorrection": False}, "measurementInterval": {"radialVelocity": 2.0}}
TABLES = {"stereo-noise": STEREO, "single-view": SINGLE, "time-of-flight": FLIGHT}


def scene(shape, seed=1):
    """Walls, near objects, slopes, random depth, and values that are no surface."""
    random = np.random.default_rng(seed)
    count, height, width = shape
    depth = np.full(shape, 3.0, np.float32) + np.linspace(0, 4, width, dtype=np.float32)
    depth[:, height // 3 : height // 2, width // 4 : width // 2] = 0.9
    depth[:, :, width * 2 // 3 : width * 2 // 3 + 2] = 0.6
    depth = np.where(random.random(shape) < 0.2, random.uniform(0.3, 9, shape), depth).astype(np.float32)
    odd = np.array([np.nan, np.inf, 0, -1, 1e-6, 1e9, -np.inf, 1e-40, 65.6, 0.21], np.float32)
    places = random.choice(depth.size, min(depth.size // 2, 10), replace=False)
    depth.ravel()[places] = odd[: len(places)]
    return depth


def device_of(engine):
    return oaktwin.Device("OAK-D ToF" if engine == "time-of-flight" else "OAK4-D")


def both(device, **options):
    return oaktwin.DepthSensor(device, seed=7, **options), ow.DepthSensor(device, on="cpu", seed=7, **options)


@pytest.mark.filterwarnings("ignore::oaktwin.FindingWarning")
@pytest.mark.parametrize("size", SIZES, ids=str)
@pytest.mark.parametrize("engine", TABLES)
def test_every_option_has_the_same_bits(engine, size):
    device, depth = device_of(engine), scene(size)
    effective = set()
    for name, values in TABLES[engine].items():
        for value in values:
            given = {name: value} | WITH.get(name, {})
            reference, sensor = both(device, engine=engine, parameters=given)
            expected = reference(depth, frame=3)
            assert np.array_equal(sensor(depth, frame=3), expected), given
            # What is compared depends on the option.
            others = oaktwin.DepthSensor(device, seed=7, engine=engine, parameters=WITH.get(name, {}))(depth, frame=3)
            if not np.array_equal(expected, others):
                effective.add(name)
    if size == SIZES[0]:
        assert effective == set(TABLES[engine])


@pytest.mark.parametrize("engine", TABLES)
def test_every_parameter_is_known(engine):
    """A parameter that is added to an engine has to be added to its kernels."""
    from oaktwin.warp._sensor import ENGINES

    names = {parameter["name"] for parameter in oaktwin.parameters(engine)}
    kernels = ENGINES[engine]
    assert names == kernels.PARAMETERS | kernels.COLOURS
    assert kernels.PARAMETERS == set(TABLES[engine])


@pytest.mark.filterwarnings("ignore::oaktwin.FindingWarning")
def test_random_combinations_have_the_same_bits():
    random = np.random.default_rng(4)
    for number, engine in itertools.product(range(40), TABLES):
        chosen = {name: values[random.integers(len(values))] for name, values in TABLES[engine].items() if random.random() < 0.4}
        if chosen.get("subpixel") is False:
            chosen.pop("subpixelFractionalBits", None)
        depth = scene((2, *random.integers(2, 70, 2)), seed=number)
        reference, sensor = both(device_of(engine), engine=engine, parameters=chosen)
        frame = int(random.integers(1 << 40))
        assert np.array_equal(sensor(depth, frame=frame), reference(depth, frame=frame)), (chosen, depth.shape)


@pytest.mark.filterwarnings("ignore::oaktwin.FindingWarning")
@pytest.mark.parametrize("parameters", [{}, {"edgeDilation": 25.0, "dropout": 0.05}, {"numInvalidateEdgePixels": 60, "bias": 1.0, "occlusion": False}])
def test_reasons(device, parameters):
    reference, sensor = both(device, parameters=parameters)
    check_reasons(reference, sensor)


@pytest.mark.filterwarnings("ignore::oaktwin.FindingWarning")
@pytest.mark.parametrize("parameters", [{}, {"range-cut": "after", "maxDistance": 3.5}, {"direction": "left", "outlierRemovalEnabled": 0}])
def test_reasons_of_single_view(device, parameters):
    check_reasons(*both(device, engine="single-view", parameters=parameters))


@pytest.mark.filterwarnings("ignore::oaktwin.FindingWarning")
@pytest.mark.parametrize("parameters", [{}, {"signal": 60.0, "fullWell": 500.0}, {"enableBurstMode": True, "confidenceThreshold": 90.0}])
def test_reasons_of_time_of_flight(parameters):
    check_reasons(*both(device_of("time-of-flight"), parameters=parameters))


def check_reasons(reference, sensor):
    for size in SIZES:
        depth = scene(size)
        codes = np.full(size, 99, np.uint8)
        measured = sensor(depth, frame=2, reasons=codes)
        assert np.array_equal(codes == 0, measured > 0)
        expected = reference.annotate(depth[0], annotators=["depth_sensor_reason"], frame=2)["depth_sensor_reason"]
        assert np.array_equal(codes[0], expected), size


def test_the_kernel_of_gpus(device):
    """GPUs measure each pixel in a thread of its own."""
    reference, sensor = both(device, parameters={"edgeDilation": 20.0, "dropout": 0.1})
    for size in SIZES:
        depth = scene(size)
        sensor(depth, frame=1)
        assert sensor._kernels._kernels._by_rows
        sensor._kernels._kernels._by_rows = False
        assert np.array_equal(sensor(depth, frame=1), reference(depth, frame=1))


def test_units_and_shapes(device):
    reference, sensor = both(device)
    depth = scene((3, 60, 106))
    millimetres = np.clip(np.nan_to_num(depth, posinf=0, neginf=0) * 1000, 0, 65535).astype(np.uint16)
    measured = sensor(millimetres, frame=1)
    assert measured.dtype == np.uint16 and np.array_equal(measured, reference(millimetres, frame=1))
    last = sensor(depth[..., None], frame=1)
    assert last.shape == (3, 60, 106, 1) and np.array_equal(last[..., 0], reference(depth, frame=1))
    out = np.empty((3, 60, 106), np.uint16)
    assert sensor(depth, frame=1, out=out) is out
    assert np.array_equal(out, reference(depth, frame=1, out=np.empty_like(out)))
    # In place.
    expected = sensor(depth, frame=1)
    assert sensor(depth, frame=1, out=depth) is depth and np.array_equal(depth, expected)
    assert sensor(np.empty((0, 60, 106), np.float32)).shape == (0, 60, 106)


def test_frames_and_seeds(device):
    reference, sensor = both(device)
    wall = np.full((3, 20, 40), 2.0, np.float32)
    numbered = [sensor(wall) for _ in range(3)]
    assert all(np.array_equal(image, reference(wall, frame=frame)) for frame, image in enumerate(numbered))
    sensor.reset()
    assert np.array_equal(sensor(wall), reference(wall, frame=3))
    sensor.reset(seed=9)
    assert sensor.seed == 9 and np.array_equal(sensor(wall), oaktwin.DepthSensor(device, seed=9)(wall, frame=0))
    seeds = [5, 1 << 63, 0]
    assert np.array_equal(sensor(wall, frame=4, seed=seeds), reference(wall, frame=4, seed=seeds))
    assert np.array_equal(sensor(wall, frame=4), oaktwin.DepthSensor(device, seed=9)(wall, frame=4))


@pytest.mark.parametrize("model, options", [
    ("OAK-D Lite", {}),
    ("OAK-D Pro W", {"device_seed": 3}),
    ("OAK4-D", {"hfov_deg": 60.0, "name": "front"}),
    ("OAK-D LR", {"fx": 100.0, "extended_disparity": True}),
    ("OAK4-D", {"engine": "single-view", "isaac": "6"}),
    ("OAK-D ToF", {"device_seed": 5, "parameters": {"enableFPPNCorrection": False}}),
    ("OAK-D ToF", {"sensor": "tof", "camera": oaktwin.Camera((80, 50), hfov_deg=60.0)}),
])  # fmt: skip
def test_models_and_options(model, options):
    reference, sensor = both(oaktwin.Device(model), **options)
    depth = scene((2, 50, 80))
    assert np.array_equal(sensor(depth, frame=1), reference(depth, frame=1))
    assert sensor.parameters == reference.parameters


def test_parameters_of_each_environment(device):
    count = 5
    wall = scene((count, 30, 53))
    values = {"bias": np.linspace(-0.3, 0.3, count), "jitter": [0.0, 0.1, 0.2, 0.3, 0.4], "dropout": np.full(count, 0.1)}
    sensor = ow.DepthSensor(device, on="cpu", seed=7, parameters={**values, "window": 9})
    measured = sensor(wall, frame=2)
    for item in range(count):
        own = {name: float(array[item]) for name, array in values.items()}
        reference = oaktwin.DepthSensor(device, seed=7, parameters={**own, "window": 9})
        assert np.array_equal(measured[item], reference(wall, frame=2)[item])
    units = ow.DepthSensor(device, on="cpu", seed=7, device_seed=range(count))(wall, frame=2)
    assert np.array_equal(units, oaktwin.DepthSensor(device, seed=7)(wall, frame=2, device_seed=list(range(count))))


def test_a_stream(device):
    """A stream sees the same through both sensors."""
    reference, sensor = both(device)
    options = dict(latency=(0.0, 0.06), jitter=0.01, drop=0.1, history=2, resize=(10, 20), clip=(0.3, 5.0), normalize=True)
    streams = [oaktwin.Stream(sensor, **options) for sensor in (reference, sensor)]
    for step in range(15):
        depth = scene((4, 30, 53), seed=step)
        if step == 7:
            for stream in streams:
                stream.reset([0, 3])
        # Warp's arrays have no indices; observations are NumPy's then.
        seen = [streams[0](depth), streams[1](wp.array(depth, dtype=float, device="cpu") if step % 2 else depth)]
        assert all(np.array_equal(a, b) for a, b in zip(*seen))


def test_arrays_of_warp(device):
    reference, sensor = both(device)
    depth = scene((2, 30, 53))
    given = wp.array(depth, dtype=float, device="cpu")
    out = wp.empty_like(given)
    assert sensor(given, frame=0, out=out) is out
    assert np.array_equal(out.numpy(), reference(depth, frame=0))
    measured = sensor(given, frame=0)
    assert isinstance(measured, wp.array) and np.array_equal(measured.numpy(), out.numpy())


def test_arrays_of_jax(device):
    jax = pytest.importorskip("jax")
    reference, sensor = both(device)
    depth = scene((2, 30, 53))
    measured = sensor(jax.numpy.asarray(depth), frame=0)
    assert isinstance(measured, jax.Array) and np.array_equal(np.asarray(measured), reference(depth, frame=0))


def test_arrays_of_torch(device):
    torch = pytest.importorskip("torch")
    reference, sensor = both(device)
    depth = torch.from_numpy(scene((2, 30, 53)))
    out = torch.empty_like(depth)
    assert sensor(depth, frame=0, out=out) is out
    assert np.array_equal(out.numpy(), reference(depth.numpy(), frame=0))
    assert torch.equal(sensor(depth, frame=0), out)
    with pytest.raises(oaktwin.Error, match="depth: has gradients"):
        sensor(depth.requires_grad_())


@pytest.mark.parametrize(
    "options, message",
    [
        ({"on": "cuda:7"}, "on: 'cuda:7' is not a device of Warp; expected one of cpu"),
        ({"parameters": {"window": [1, 3]}}, "parameters: window cannot differ between environments; those that can: bias, "),
        ({"parameters": {"bias": [0.1, 0.2], "jitter": [0.1]}}, "parameters: have different lengths"),
        ({"parameters": {"bias": [[0.1]]}}, "parameters: bias has the shape"),
        ({"parameters": {"bias": [0.1, 99.0]}}, "bias: 99 is out of range"),
        ({"parameters": {"bias": [-99.0, 0.1]}}, "bias: -99 is out of range"),
        ({"parameters": {"bias": [0.1, np.nan]}}, "bias: must not be NaN"),
        ({"parameters": {"bais": 0.1}}, "bais"),
        ({"engine": "single-view", "device_seed": [1, 2]}, "device_seed: has a seed for each environment, but single-view has no bias"),
    ],
)
def test_bad_options(device, options, message):
    with pytest.raises(oaktwin.Error, match=message):
        ow.DepthSensor(device, **({"on": "cpu"} | options))


def test_other_engines():
    with pytest.raises(oaktwin.Error, match="engine: 'stereo-matching' does not run in Warp; expected stereo-noise, single-view, time-"):
        ow.DepthSensor(oaktwin.Device("OAK4-D"), on="cpu", engine="stereo-matching")
    sensor = ow.DepthSensor(device_of("time-of-flight"), on="cpu", parameters={"multipath": 1.0})
    with pytest.raises(oaktwin.Error, match="multipath: does not run in Warp; set it to 0"):
        sensor(np.ones((2, 3, 4), np.float32))


def test_a_camera_without_depth():
    with pytest.raises(oaktwin.Error):
        ow.DepthSensor(oaktwin.Device("OAK-1"), on="cpu")


def test_bad_calls(device):
    sensor = ow.DepthSensor(device, on="cpu")
    wall = np.full((2, 20, 30), 2.0, np.float32)
    for given, kind, message in [
        (wall[0], oaktwin.Error, r"depth: has the shape \(20, 30\); pass a batch"),
        (wall.astype(np.float16), TypeError, "depth: unsupported dtype float16; pass float32 for metres"),
        (wall.astype(np.float64), TypeError, "depth: unsupported dtype float64"),
        (wall[:, :, ::2], oaktwin.Error, "depth: is not C-contiguous"),
        ([[1.0]], TypeError, "depth: list is not an array; pass one of Warp"),
    ]:
        with pytest.raises(kind, match=message):
            sensor(given)
    for arguments, message in [
        ({"frame": -1}, "frame: is -1; pass a whole number"),
        ({"frame": 1 << 64}, "frame: is"),
        ({"seed": [1]}, "seed: has 1 values for 2 images"),
        ({"seed": [1, -1]}, "seed: pass whole numbers"),
        ({"out": np.empty((2, 20, 31), np.float32)}, r"out: has the shape \(2, 20, 31\), and measured depth \(2, 20, 30\)"),
        ({"reasons": np.empty((2, 20, 30), np.int32)}, "reasons: pass a C-contiguous uint8 array"),
        ({"rgb": np.zeros((2, 20, 30, 3), np.uint8)}, "rgb: colour images are not used in Warp"),
    ]:
        with pytest.raises(oaktwin.Error, match=message):
            sensor(wall, **arguments)
    assert sensor(wall).shape == wall.shape
    own = ow.DepthSensor(device, on="cpu", parameters={"bias": [0.1, 0.2, 0.3]})
    with pytest.raises(oaktwin.Error, match="depth: has 2 images, but parameters have 3 values"):
        own(wall)


def test_what_cannot_be_reproduced_is_an_error(device, monkeypatch):
    """The sensor compares itself with the reference before it measures images of a new size."""
    from oaktwin.warp import _stereo_noise

    monkeypatch.setattr(_stereo_noise, "JITTER", 99)
    with pytest.raises(oaktwin.Error, match="pixels of a test image differ from oaktwin.DepthSensor on cpu"):
        ow.DepthSensor(device, on="cpu")(np.full((2, 20, 30), 2.0, np.float32))
