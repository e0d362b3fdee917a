"""The sensors of many environments: `DepthSensor.batch`."""

import copy
import pickle

import numpy as np
import pytest

import oaktwin

N, SIZE = 4, (60, 107)


@pytest.fixture(scope="module")
def depth():
    y, x = np.mgrid[: SIZE[0], : SIZE[1]]
    slopes = np.arange(1, N + 1)[:, None, None] * 0.01
    return (1.5 + slopes * x + 0.005 * y).astype(np.float32)


@pytest.fixture
def sensor():
    return oaktwin.DepthSensor(oaktwin.Device("OAK-D-Pro-PoE"), seed=3)


@pytest.mark.parametrize("engine", ["stereo-noise", "single-view"])
@pytest.mark.parametrize("filters", [[], ["median"], ["decimation:factor=2"], ["temporal"]])
def test_a_plain_batch_is_a_call_of_the_sensor(depth, engine, filters):
    device = oaktwin.Device("OAK-D-Pro-PoE")
    sensor = oaktwin.DepthSensor(device, engine=engine, filters=filters, seed=3)
    rgb = np.random.default_rng(1).integers(0, 256, (*depth.shape, 3), dtype=np.uint8)
    batch = sensor.batch(N)
    assert len(batch) == N
    for _ in range(3):
        np.testing.assert_array_equal(batch(depth), sensor(depth))
    np.testing.assert_array_equal(batch(depth, rgb), sensor(depth, rgb))
    assert batch.frames.tolist() == [4] * N


def test_items_have_their_own_parameters_and_units(depth, sensor):
    device = oaktwin.Device("OAK-D-Pro-PoE")
    jitter = np.array([0.0, 0.1, 0.2, 0.4])
    batch = sensor.batch(N, seeds=range(N), parameters={"jitter": jitter, "subpixel": True}, device_seeds=[5, 6, 7, 8])
    got = batch(depth)
    for item in range(N):
        own = oaktwin.DepthSensor(
            device, seed=item, device_seed=5 + item, parameters={"jitter": jitter[item], "subpixel": True}
        )
        np.testing.assert_array_equal(got[item], own(depth[item]))
    units = device.population(N, seed=1)
    got = sensor.batch(N, seeds=range(N), units=units, drift={"yaw": [0.0, 0.2, 0.4, 0.6]})(depth)
    for item in range(N):
        own = oaktwin.DepthSensor(units[item], seed=item, drift={"yaw": 0.2 * item if item else 0.0})
        # 0.2 * 3 is not 0.6 in binary.
        np.testing.assert_allclose(got[item], own(depth[item]), rtol=1e-6)


@pytest.mark.parametrize("filters", [[], ["temporal"]])
def test_an_episode_repeats_whatever_the_others_do(depth, filters):
    sensor = oaktwin.DepthSensor(oaktwin.Device("OAK-D-Pro-PoE"), seed=3, filters=filters)
    batch = sensor.batch(N)
    first = [batch(depth) for _ in range(3)]
    batch.reset([1], episode=7)
    assert batch.episodes.tolist() == [0, 7, 0, 0]
    assert batch.frames.tolist() == [3, 0, 3, 3]
    seventh = [batch(depth)[1] for _ in range(2)]
    assert not np.array_equal(seventh[0], first[0][1])
    batch.reset(np.array([True, True, False, False]), episode=[2, 7])
    again = [batch(depth)[1] for _ in range(2)]
    np.testing.assert_array_equal(seventh, again)
    batch.reset(episode=0)
    np.testing.assert_array_equal([batch(depth) for _ in range(3)], first)
    # Without an episode, the numbering goes on.
    batch.reset()
    assert batch.frames.tolist() == [3] * N
    assert not np.array_equal(batch(depth), first[0])
    # A frame that is given is one of the present episode.
    batch.reset([1], episode=7)
    if not filters:
        np.testing.assert_array_equal(batch(depth, frame=1)[1], seventh[1])
        assert batch.frames[1] == 0


def test_batches_have_reasons_and_confidence(depth, sensor):
    rgb = np.random.default_rng(1).integers(0, 256, (*depth.shape, 3), dtype=np.uint8)
    rgb[1] = 128
    names = ["depth_sensor_distance", "depth_sensor_confidence", "depth_sensor_reason"]
    got = sensor.batch(N, seeds=range(N)).annotate(depth, rgb, annotators=names)
    for item in range(N):
        own = oaktwin.DepthSensor(oaktwin.Device("OAK-D-Pro-PoE"), seed=item)
        own = own.annotate(depth[item], rgb[item], annotators=names)
        for name in names:
            assert got[name].dtype == own[name].dtype
            np.testing.assert_array_equal(got[name][item], own[name])
        assert got["depth_sensor_reason_names"] == own["depth_sensor_reason_names"]
    assert np.all((got["depth_sensor_reason"] == 0) == (got["depth_sensor_distance"] > 0))


def test_depth_in_millimetres_is_reported(depth, sensor):
    for measure in (sensor.batch(N), lambda images: sensor.batch(N).annotate(images, annotators=["depth_sensor_distance"])):
        with pytest.warns(oaktwin.FindingWarning, match="looks like millimetres"):
            measure(depth * 1000)


def test_copies_and_pickles_continue(depth, sensor):
    batch = sensor.batch(N, parameters={"jitter": [0.0, 0.1, 0.2, 0.3]})
    batch(depth)
    batch.reset([2], episode=9)
    sensor.reset(seed=99)
    twins = [copy.copy(batch), pickle.loads(pickle.dumps(batch))]
    expected = batch(depth)
    for twin in twins:
        assert twin.episodes.tolist() == [0, 0, 9, 0]
        np.testing.assert_array_equal(twin(depth), expected)


def test_millimetres_and_out(depth, sensor):
    mm = (depth * 1000).astype(np.uint16)
    out = np.zeros_like(mm)
    batch = sensor.batch(N, parameters={"jitter": [0.0, 0.1, 0.2, 0.3]})
    assert batch(mm, out=out) is out
    batch.reset(episode=0)
    np.testing.assert_array_equal(batch(mm), out)


def test_a_python_engine_measures_batches(depth):
    sensor = oaktwin.DepthSensor(oaktwin.Device("OAK-D-Pro-PoE"), engine=lambda depth: depth * 2)
    np.testing.assert_array_equal(sensor.batch(N)(depth), depth * 2)


def test_bad_input_names_the_argument_and_the_item(depth, sensor):
    for arguments, expected in [
        ({"count": 0}, "count: is 0; pass 1 to"),
        ({"count": 2**40}, "count: is 1099511627776"),
        ({"count": N, "seeds": [1, 2]}, "seeds: has 2 numbers for 4 images"),
        ({"count": N, "parameters": {"jitter": [1, 2, 3]}}, "jitter.*has 3 values, but the batch 4 items"),
        ({"count": N, "parameters": {"jiter": 1}}, "item 0: .*jitter"),
        ({"count": N, "parameters": {"jitter": [0, 0, -1, 0]}}, "item 2: .*jitter"),
        ({"count": N, "parameters": {"jitter": [0, np.nan, 0, 0]}}, "item 1: .*jitter"),
        ({"count": N, "parameters": "jitter"}, "parameters: invalid value"),
        ({"count": N, "drift": {"yow": 1}}, "yaw"),
        ({"count": N, "units": ["OAK4-D"] * N}, "units: invalid value"),
        ({"count": N, "units": [oaktwin.Device("OAK4-D")]}, "units: has 1 devices, but the batch 4 items"),
        ({"count": 1, "units": [oaktwin.Device("OAK-1")]}, "item 0: "),
    ]:
        with pytest.raises(oaktwin.Error, match=expected):
            sensor.batch(**arguments)
    batch = sensor.batch(N)
    for wrong in (depth[0], depth[:2], depth[None]):
        with pytest.raises(oaktwin.Error, match="depth: has"):
            batch(wrong)
    with pytest.raises(oaktwin.Error, match="items: item 4 is not in the batch; pass numbers below 4"):
        batch.reset([4], episode=1)
    with pytest.raises(oaktwin.Error, match="episode: has 2 numbers for 1 images"):
        batch.reset([1], episode=[1, 2])
    with pytest.raises(oaktwin.Error, match="is not an output of batches"):
        batch.annotate(depth, annotators=["depth_sensor_point_cloud_position"])
    matching = oaktwin.DepthSensor(oaktwin.Device("OAK-D-Pro-PoE"), engine="stereo-matching")
    with pytest.raises(oaktwin.Error, match="matches image pairs"):
        matching.batch(N)
