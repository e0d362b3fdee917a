import json

import numpy as np
import pytest

import depth_models
import stereo_noise_model
import oaktwin


def test_stereo_noise_is_the_numpy_models(device, room):
    depth, rgb = room
    rgb = rgb.copy()
    rgb[:, -depth.shape[1] // 3 :] = 90
    # Single precision rounds a factor differently; the oracles of the engine allow for that.
    for parameters in [{"closeRangeFactor": 1}, {"bias": -0.2, "subpixelFractionalBits": 3}, {"closeRangeFactor": 1, "dropout": 0.05, "window": 3}]:
        sensor = oaktwin.DepthSensor(device, seed=5, parameters=parameters)
        own = sensor.parameters
        model = stereo_noise_model.Parameters(
            float(own["focalLength"]), float(own["baseline"]), int(own["width"]), **parameters
        )
        for frame in [0, 9]:
            expected = stereo_noise_model.stereo_noise(depth, model, 5, "Camera_pseudo_depth", frame)
            assert np.array_equal(sensor(depth, frame=frame), expected)
        batch = np.stack([depth, depth * np.float32(1.1), depth])
        got = sensor(batch, frame=4)
        for item, image in enumerate(batch):
            expected = stereo_noise_model.stereo_noise(image, model, 5, "Camera_pseudo_depth", 4, item)
            assert np.array_equal(got[item], expected)
        rgba = np.dstack([rgb, np.full(depth.shape, 255, np.uint8)])
        expected = stereo_noise_model.stereo_noise(depth, model, 5, "Camera_pseudo_depth", rgb=rgba)
        assert np.array_equal(sensor(depth, rgb, frame=0), expected)
        assert np.array_equal(sensor(depth, rgba, frame=0), expected)
        assert (expected == 0).sum() > (sensor(depth, frame=0) == 0).sum()


def test_single_view_is_the_numpy_models(room):
    depth, rgb = room
    device = oaktwin.Device("OAK-D ToF")
    sensor = oaktwin.DepthSensor(device, engine="single-view", seed=2, name="tof", parameters={"noiseSigma": 0.4})
    assert sensor.engine == "single-view"
    own = {}
    for name, value in sensor.parameters.items():
        if name in depth_models.PARAMETERS:
            own[name] = value if not isinstance(depth_models.PARAMETERS[name], (int, float)) else float(value)
    own["outlierRemovalEnabled"] = int(own["outlierRemovalEnabled"])
    expected = depth_models.single_view(depth, parameters=own, seed=2, camera="tof", frame=3)
    assert np.array_equal(sensor(depth, frame=3), expected["distance"])
    batch = sensor(np.stack([depth, depth]), frame=3)
    assert np.array_equal(batch[0], expected["distance"]) and not np.array_equal(batch[0], batch[1])


@pytest.mark.parametrize(
    "options, said",
    [
        ({}, []),
        ({"preset": "robotics"}, ["--preset", "robotics"]),
        ({"filters": ["median:size=5", "decimation:factor=2"]}, ["--filter", "median:size=5", "--filter", "decimation:factor=2"]),
        ({"engine": "single-view"}, ["--engine", "single-view"]),
        ({"device_seed": 3, "extended_disparity": True}, ["--device-seed", "3", "--extended-disparity"]),
        ({"hfov_deg": 60, "parameters": {"jitter": 0.2, "occlusion": False}},
         ["--hfov", "60", "--param", "jitter=0.2", "--param", "occlusion=false"]),
        ({"fx": 100.5}, ["--fx", "100.5"]),
    ],
)
def test_sensing_is_the_programs(program, tmp_path, device, room, options, said):
    depth, rgb = room
    batch = np.stack([depth, depth + 1])
    np.save(tmp_path / "depth_0007.npy", batch)
    np.save(tmp_path / "rgb.npy", np.stack([rgb, rgb]))
    pictures = ["--rgb", tmp_path / "rgb.npy"]
    program("sense", "--model", "OAK4-D", "-o", tmp_path / "out", "--seed", "4", *said, tmp_path / "depth_0007.npy", *pictures)
    [written] = (tmp_path / "out").rglob("*.npy")
    sensor = oaktwin.DepthSensor(device, seed=4, **options)
    got = sensor(batch, np.stack([rgb, rgb]), frame=7)
    assert np.array_equal(got, np.load(written)) and got.any()


def test_a_sequence_is_the_programs(program, tmp_path, device, room):
    depth, _ = room
    for frame in range(4):
        np.save(tmp_path / f"depth_{frame:04}.npy", depth + np.float32(0.01 * frame))
    program("sense", "--model", "OAK4-D", "-o", tmp_path / "out", "--filter", "temporal", *sorted(tmp_path.glob("*.npy")))
    written = [np.load(file) for file in sorted((tmp_path / "out").rglob("*.npy"))]
    sensor = oaktwin.DepthSensor(device, filters=["temporal"])
    for _ in range(2):
        got = [sensor(depth + np.float32(0.01 * frame), frame=frame) for frame in range(4)]
        assert np.array_equal(got, written)
        sensor.reset()
    # Images and the items of batches remember apart.
    batch = sensor(np.stack([depth, depth]), frame=0)
    assert np.array_equal(batch[0], written[0])
    assert np.array_equal(sensor(depth, frame=0), written[0])


def test_millimetres(device, room):
    depth, _ = room
    valid = np.where(np.isfinite(depth) & (depth > 0), depth, 0)
    whole = np.rint(valid * 1000).astype(np.uint16)
    sensor = oaktwin.DepthSensor(device)
    got = sensor(whole, frame=0)
    assert got.dtype == np.uint16
    metres = sensor((whole / 1000).astype(np.float32), frame=0)
    assert np.array_equal(got, np.rint(metres * 1000))
    out = np.empty(depth.shape, np.float32)
    assert sensor(whole, out=out, frame=0) is out and np.array_equal(out, metres)
    out = np.empty((2, *depth.shape), np.uint16)
    assert sensor(np.stack([whole, whole]), out=out, frame=0) is out and np.array_equal(out[0], got)


def test_noise(device):
    wall = np.full((60, 106), 2.0, np.float32)
    sensor = oaktwin.DepthSensor(device, seed=1)
    assert np.array_equal(sensor(wall, frame=0), sensor(wall, frame=0))
    for other in [sensor(wall, frame=1), oaktwin.DepthSensor(device, seed=2)(wall),
                  oaktwin.DepthSensor(device, seed=1, name="other")(wall)]:
        assert not np.array_equal(sensor(wall, frame=0), other)
    batch = sensor(np.stack([wall] * 3), frame=0)
    assert not np.array_equal(batch[0], batch[1])
    assert np.array_equal(sensor(wall[None], frame=0)[0], sensor(wall, frame=0))
    assert np.array_equal(sensor(np.full((60, 106), 3e9, np.float32)), np.zeros((60, 106)))
    assert sensor(np.empty((0, 60, 106), np.float32)).shape == (0, 60, 106)


def test_decimation_and_what_is_told(device, room):
    depth, _ = room
    sensor = oaktwin.DepthSensor(device, filters=["decimation:factor=2"], seed=3)
    assert sensor(depth).shape == (30, 53) and sensor(depth[None]).shape == (1, 30, 53)
    assert sensor.filters == ["decimation:factor=2,mode=PIXEL_SKIPPING"]
    assert repr(sensor) == (
        "<oaktwin.DepthSensor OAK4-D Camera_pseudo_depth: stereo-noise, decimation:factor=2,mode=PIXEL_SKIPPING, seed 3>"
    )
    [finding] = sensor.findings
    assert finding.code == "own-size" and finding.level == "note" and finding.place == "106x60"
    assert str(finding).startswith("note[own-size]: 106x60: ") and "own-size" in repr(finding)
    assert "77.00°" in finding.message and finding.remedy


def test_alignment_is_the_programs(program, tmp_path, device):
    depth = np.full((800, 1280), 2.0, np.float32)
    depth[200:500, 300:600] = 1.0
    np.save(tmp_path / "depth_0000.npy", depth)
    program("sense", "--model", "OAK4-D", "-o", tmp_path / "out", "--align", "rgb", "--align-size", "400x300",
            tmp_path / "depth_0000.npy")
    measured, aligned = (
        np.load(next(file for file in (tmp_path / "out").rglob("*.npy") if ("align" in file.name or "rgb" in file.name) == is_aligned))
        for is_aligned in [False, True]
    )
    sensor = oaktwin.DepthSensor(device)
    assert np.array_equal(sensor(depth), measured)
    assert np.array_equal(sensor.align(measured, "rgb", size=(400, 300)), aligned)
    rgb = device.cameras["rgb"].resized(400, 300, rule="depthai")
    assert np.array_equal(oaktwin.align(measured, device.depth_camera(), rgb), aligned)
    batch = np.stack([measured, measured])
    out = np.empty((2, 300, 400), np.float32)
    assert oaktwin.align(batch, device.depth_camera(), rgb, out=out) is out
    assert np.array_equal(out[1], aligned)
    millimetres = np.rint(measured * 1000).astype(np.uint16)
    whole = oaktwin.align(millimetres, device.depth_camera(), rgb)
    assert whole.dtype == np.uint16 and np.allclose(whole / 1000, aligned, atol=6e-4)
    large = rgb.resized(1600, 1200, rule="depthai")
    nearest = oaktwin.align(measured, device.depth_camera(), large, fill="nearest")
    assert (nearest == 0).sum() > 2 * (oaktwin.align(measured, device.depth_camera(), large) == 0).sum()
    moved = oaktwin.align(depth, device.depth_camera(), device.depth_camera(), target_from_source=np.eye(4))
    assert np.array_equal(moved, depth)


def test_what_cannot_be_aligned(device, room):
    left, rgb = device.cameras["left"], device.cameras["rgb"]
    with pytest.raises(oaktwin.Error, match="1280x800"):
        oaktwin.align(room[0], left, rgb)
    for text, arguments in {
        "to: invalid value 'rgbb'; did you mean 'rgb'": dict(to="rgbb"),
        "fill: invalid value": dict(fill="holes"),
        "no pixel": dict(size=(0, 3)),
        "tof": dict(to="tof"),
    }.items():
        with pytest.raises(oaktwin.Error, match=text):
            oaktwin.DepthSensor(device).align(room[0], **arguments)
    with pytest.raises(oaktwin.Error, match="not a rotation"):
        oaktwin.align(room[0], left, rgb, target_from_source=2 * np.eye(4) - np.diag([0, 0, 0, 1]))


def test_nothing_names_the_programs_options(device, room, tmp_path, calibration):
    """Errors, findings and remedies use Python's names."""
    said = [str(finding) for finding in [*oaktwin.DepthSensor(device, seed=1).findings]]
    sensor = oaktwin.DepthSensor(device)
    sensor(room[0])
    said += [f"{finding} {finding.remedy}" for finding in sensor.findings]
    (tmp_path / "a.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    (tmp_path / "a.usda").write_text("#usda 1.0\n")
    for call in [
        lambda: oaktwin.DepthSensor(device, fx=-1),
        lambda: oaktwin.DepthSensor(device, hfov_deg=200),
        lambda: oaktwin.DepthSensor(device, sensor="tof"),
        lambda: oaktwin.DepthSensor(device, engine="single-view", parameters={"window": 3}),
        lambda: oaktwin.DepthSensor(oaktwin.Device("OAK-D ToF"), engine="stereo-noise"),
        lambda: sensor.align(room[0], "tof"),
        lambda: sensor.align(room[0], size=(0, 3)),
        lambda: oaktwin.Scene.open(tmp_path / "a.obj", time=1),
        lambda: oaktwin.Scene.open(tmp_path / "a.obj", subdivide=1),
        lambda: oaktwin.Scene.open(tmp_path / "a.usda", up="y"),
        lambda: oaktwin.Scene.open(tmp_path / "a.usda", scale=2),
        lambda: device.write_usd("/nowhere/at/all.usd"),
        lambda: oaktwin.Device.from_calibration(calibration, "OAK-D ToF"),
        lambda: oaktwin.accuracy(device, focal_px=-1),
        lambda: oaktwin.accuracy(device, width_px=1),
        lambda: oaktwin.accuracy(device, distances=[-1]),
        lambda: oaktwin.accuracy(device, region=2),
        lambda: oaktwin.accuracy(device, sensor="tof"),
        lambda: oaktwin.accuracy(device, devices=0),
    ]:
        with pytest.raises((oaktwin.Error, OSError)) as raised:
            call()
        said.append(str(raised.value))
    assert not [text for text in said if " -" in text.replace(" -1", "") or "--" in text]


def test_paths_that_look_like_options_are_unchanged(tmp_path):
    path = tmp_path / "run--time" / "with -o.usd"
    with pytest.raises(FileNotFoundError) as raised:
        oaktwin.Scene.open(path)
    assert str(path) in str(raised.value)


@pytest.mark.parametrize(
    "options, text",
    [
        ({"engine": "steroe-noise"}, "engine: unknown engine 'steroe-noise'; did you mean 'stereo-noise'?"),
        ({"engine": "stereo-noise", "sensor": "tof"}, "has no depth sensor 'tof'; expected one of stereo"),
        ({"preset": "robotic"}, "did you mean 'ROBOTICS'"),
        ({"filters": ["medium"]}, "medium: unknown filter"),
        ({"parameters": {"windw": 7}}, "windw: unknown parameter of stereo-noise; did you mean 'window"),
        ({"parameters": {"window": "wide"}}, "window"),
        ({"parameters": {"noiseSigma": 1}}, "a parameter of single-view, not of stereo-noise"),
        ({"parameters": [1]}, "parameters: invalid value [1]; pass a mapping"),
        ({"isaac": "7"}, "isaac: invalid value '7'"),
        ({"fx": -1}, "fx: must be a finite number > 0 (got -1)"),
        ({"fx": float("nan")}, "fx: must be a finite number > 0"),
        ({"hfov_deg": 180}, "hfov_deg: 180 is out of range"),
        ({"fx": 3, "hfov_deg": 4}, "give one"),
        ({"sensor": "lidar"}, "has no depth sensor 'lidar'; expected one of stereo, Camera_pseudo_depth"),
    ],
)
def test_what_is_no_sensor(device, options, text):
    with pytest.raises(oaktwin.Error) as raised:
        oaktwin.DepthSensor(device, **options)
    assert text in str(raised.value)


def test_errors_have_the_programs_text(program, tmp_path, device, room):
    np.save(tmp_path / "depth_0000.npy", room[0])
    for options, said in [
        ({"parameters": {"windw": 7}}, ["--param", "windw=7"]),
        ({"preset": "robotic"}, ["--preset", "robotic"]),
        ({"filters": ["median:size=4"]}, ["--filter", "median:size=4"]),
        ({"fx": -1}, ["--fx=-1"]),
    ]:
        with pytest.raises(oaktwin.Error) as raised:
            oaktwin.DepthSensor(device, **options)
        printed = program("sense", "--model", "OAK4-D", "-o", tmp_path / "out", *said, tmp_path / "depth_0000.npy", code=2)
        # Python's names for the options.
        assert printed.replace("--fx", "fx") == f"error: {raised.value}\n"


def test_bad_calls(device, room):
    depth, rgb = room
    sensor = oaktwin.DepthSensor(device)
    for error, text, call in [
        (TypeError, "NoneType is not an array", lambda: sensor(None)),
        (TypeError, "int32", lambda: sensor(np.zeros(depth.shape, np.int32))),
        (TypeError, "pass uint8", lambda: sensor(depth, rgb.astype(np.float32))),
        (TypeError, "float64", lambda: sensor(depth, out=np.empty(depth.shape))),
        (TypeError, "", lambda: sensor(depth, rgb, 3)),
        (TypeError, "", lambda: sensor(depth, colour=rgb)),
        (oaktwin.Error, "has shape [106]", lambda: sensor(depth[0])),
        (oaktwin.Error, "has shape []", lambda: sensor(np.float32(3).reshape(()))),
        (oaktwin.Error, "has no pixel", lambda: sensor(depth[:0])),
        (oaktwin.Error, "has no pixel", lambda: sensor(np.empty((3, 4, 0), np.float32))),
        (oaktwin.Error, "rgb: has shape", lambda: sensor(depth, rgb[:-1])),
        (oaktwin.Error, "3 or 4 channels", lambda: sensor(depth, rgb[..., :2])),
        (oaktwin.Error, "rgb: has shape", lambda: sensor(depth[None], rgb)),
        (oaktwin.Error, "out: has shape", lambda: sensor(depth, out=np.empty((3, 3), np.float32))),
        (oaktwin.Error, "C-contiguous", lambda: sensor(depth, out=np.empty(depth.shape, np.float32, order="F"))),
        (oaktwin.Error, "pass a separate array", lambda: sensor(depth, out=depth)),
        (oaktwin.Error, "frame: invalid value -1", lambda: sensor(depth, frame=-1)),
        (oaktwin.Error, "frame: invalid value", lambda: sensor(depth, frame=1 << 64)),
        (oaktwin.Error, "annotators: must be a list", lambda: sensor.annotate(depth, annotators="rgb")),
        (oaktwin.Error, "size: invalid value (-640, 400)", lambda: sensor.align(depth, size=(-640, 400))),
        (oaktwin.Error, "device_seed: is for batches", lambda: sensor(depth, device_seed=[1])),
        (oaktwin.Error, "seed: has 2 numbers for 1 images", lambda: sensor(depth[None], seed=[1, 2])),
        (oaktwin.Error, "seed: invalid value -1; pass a whole number", lambda: oaktwin.DepthSensor(device, seed=-1)),
        (oaktwin.Error, "filters: must be a list", lambda: oaktwin.DepthSensor(device, filters="median")),
        (TypeError, "did you mean 'seed'?", lambda: oaktwin.DepthSensor(device, sed=1)),
    ]:
        with pytest.raises(error) as raised:
            call()
        assert text in str(raised.value)
    frozen = np.zeros(depth.shape, np.float32)
    frozen.flags.writeable = False
    with pytest.raises(oaktwin.Error, match="read-only"):
        sensor(depth, out=frozen)
    assert not frozen.any()
    assert sensor(depth, frame=(1 << 64) - 1).shape == depth.shape
