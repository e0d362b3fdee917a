"""Sequences: numbers of frames, seeds, and the memory of temporal filters."""

import copy
import pickle

import numpy as np
import pytest

import oaktwin
from conftest import BASELINE, FX

WALL = np.full((60, 106), 2.0, np.float32)


def frames(depth, count=5):
    return [depth + np.float32(0.01 * number) for number in range(count)]


@pytest.mark.parametrize("options", [{}, {"device_seed": 3}, {"engine": "single-view"}])
def test_a_batch_of_one_is_an_image(device, room, options):
    depth, rgb = room
    one = oaktwin.DepthSensor(device, filters=["temporal"], seed=2, **options)
    batch = oaktwin.DepthSensor(device, filters=["temporal"], seed=2, **options)
    for depth in frames(depth):
        assert np.array_equal(one(depth, rgb), batch(depth[None], rgb[None])[0])


def test_each_item_of_a_batch_has_a_state(device, room):
    sensor = oaktwin.DepthSensor(device, filters=["temporal:alpha=0.2"], seed=2)
    units = [oaktwin.DepthSensor(device, filters=["temporal:alpha=0.2"], seed=seed, device_seed=seed) for seed in (5, 6, 7)]
    given = {"seed": [5, 6, 7], "device_seed": np.array([5, 6, 7])}
    for number, depth in enumerate(frames(room[0])):
        got = sensor(np.stack([depth] * 3), frame=number, **given)
        assert np.array_equal(got, [unit(depth, frame=number) for unit in units])
    # The others go on.
    sensor.reset(items=[0, 2])
    units[0].reset()
    units[2].reset()
    got = sensor(np.stack([depth] * 3), frame=9, **given)
    assert np.array_equal(got, [unit(depth, frame=9) for unit in units])
    fresh = oaktwin.DepthSensor(device, filters=["temporal:alpha=0.2"], seed=6, device_seed=6)
    assert not np.array_equal(got[1], fresh(depth, frame=9))
    # More items, and images of another size.
    assert sensor(np.stack([depth] * 4), frame=10)[3].any()
    assert np.array_equal(sensor(WALL[None, :50], frame=0), copy.copy(sensor)(WALL[None, :50], frame=0))
    with pytest.raises(oaktwin.Error, match="items: .*pass the numbers of items, or a mask"):
        sensor.reset(items=["a"])
    with pytest.raises(oaktwin.Error, match="seed: is for all items"):
        sensor.reset(items=[0], seed=1)


def test_each_pair_of_a_batch_has_a_state(textured):
    left, right, _, _ = textured
    other = right + np.random.default_rng(0).integers(0, 9, right.shape).astype(np.uint8)
    make = lambda: oaktwin.StereoMatcher(fx=FX, baseline=BASELINE, filters=["temporal:alpha=0.3"])  # noqa: E731
    batch, one, two = make(), make(), make()
    for rights in [(right, other), (other, right)]:
        got = batch(np.stack([left, left]), np.stack(rights))["depth"]
        assert np.array_equal(got, [one(left, rights[0])["depth"], two(left, rights[1])["depth"]])
    batch.reset([1])
    got = batch(np.stack([left, left]), np.stack([right, other]))["depth"]
    assert np.array_equal(got, [one(left, right)["depth"], make()(left, other)["depth"]])


def test_numbers_of_frames_go_on(device):
    sensor = oaktwin.DepthSensor(device, seed=4)
    expected = [sensor(WALL, frame=number) for number in range(4)]
    assert np.array_equal(sensor(WALL), expected[0])
    for other in [copy.copy(sensor), copy.deepcopy(sensor), pickle.loads(pickle.dumps(sensor))]:
        assert np.array_equal(other(WALL), expected[1])
    sensor.reset()
    assert np.array_equal(sensor(WALL), expected[1]), "another episode has other noise"
    sensor.reset(seed=4)
    assert np.array_equal(sensor(WALL), expected[0])
    sensor.reset(seed=5)
    assert sensor.seed == 5 and "seed 5" in repr(sensor)
    assert np.array_equal(sensor(WALL), oaktwin.DepthSensor(device, seed=5)(WALL))
    assert pickle.loads(pickle.dumps(sensor)).seed == 5
    assert np.array_equal(sensor(WALL[None], frame=3, device_seed=[1]), oaktwin.DepthSensor(device, seed=5, device_seed=1)(WALL[None], frame=3))


def test_seeds_of_fresh_entropy(device):
    assert oaktwin.DepthSensor(device).seed == 0
    one, other = (oaktwin.DepthSensor(device, seed=None) for _ in range(2))
    assert one.seed != other.seed and not np.array_equal(one(WALL), other(WALL))
    assert np.array_equal(oaktwin.DepthSensor(device, seed=one.seed)(WALL), one(WALL, frame=0))
    samples = oaktwin.simulate_imu(device, [0, 1], np.stack([np.eye(4)] * 2), seed=None)
    again = oaktwin.simulate_imu(device, [0, 1], np.stack([np.eye(4)] * 2), seed=samples["seed"])
    assert samples["seed"] > 0 and np.array_equal(samples["angular_velocity"], again["angular_velocity"])
    with pytest.raises(oaktwin.Error, match="seed"):
        oaktwin.accuracy(device, distances=[1], devices=1, captures=1, seed=None)


def test_pairs_of_a_scene_differ(device):
    scene = oaktwin.Scene.from_triangles([[2, -9, -9], [2, 9, -9], [2, 0, 9]], [[0, 1, 2]])
    look = lambda scene, **options: scene.render_pair(device, np.eye(4), size=(64, 40), **options)  # noqa: E731
    first, second = look(scene), look(scene)
    assert (first["frame"], second["frame"], first["seed"]) == (0, 1, 0)
    assert not np.array_equal(first["left"], second["left"])
    assert np.array_equal(look(scene, frame=0)["left"], first["left"])
    for other in [copy.copy(scene), pickle.loads(pickle.dumps(scene))]:
        assert look(other)["frame"] == 2
    drawn = look(scene, seed=None, frame=0)
    assert drawn["seed"] > 0 and np.array_equal(look(scene, seed=drawn["seed"], frame=0)["left"], drawn["left"])
    pair = look(scene)
    assert pair["camera"].size == (64, 40) and pair["baseline"] == pytest.approx(0.075, abs=1e-3)
    matcher = oaktwin.StereoMatcher(device)
    matcher(pair["left"], pair["right"])
    assert np.allclose(pair["camera"].K, matcher.camera.K)
