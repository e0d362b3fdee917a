"""`oaktwin.Stream`: rate, delay, losses and history of the frames that a policy sees."""

import math
import pickle

import numpy as np
import pytest

import oaktwin


class Clock:
    """A sensor whose images show the exact depth, and that records its calls."""

    def __init__(self):
        self.calls = []

    def __call__(self, depth, rgb=None, *, frame=None, seed=None):
        self.calls.append((len(depth), frame, tuple(seed)))
        return depth


def scenes(step, envs, size=(3, 4)):
    """Depth that tells the step and the environment."""
    return np.broadcast_to((1 + step + 1000 * np.asarray(envs))[:, None, None], (len(envs), *size)).astype(np.float32)


def run(stream, steps, envs, resets=()):
    seen = []
    for step in range(steps):
        for at, ids in resets:
            if at == step:
                stream.reset(ids)
        seen.append(stream(scenes(step, envs)))
    return seen


def steps_shown(seen, env=0):
    return [[int(z) - 1 - 1000 * env for z in observation.depth[env, :, 0, 0]] for observation in seen]


@pytest.mark.parametrize("latency, late", [(0.0, 0), (0.02, 1), (0.05, 3), (0.1, 5)])
def test_a_fixed_delay_at_the_rate_of_control(latency, late):
    """With both rates equal, the delay is rounded up to whole steps, and every frame arrives."""
    seen = run(oaktwin.Stream(Clock(), latency=latency, camera_hz=50, control_hz=50), 20, [0])
    assert [shown[0] for shown in steps_shown(seen)] == [max(step - late, 0) for step in range(20)]
    for step, observation in enumerate(seen):
        if step > late:
            assert observation.fresh[0] and observation.age[0, 0] == pytest.approx(late * 0.02, abs=1e-6)
        # Before, the view stood still.
        assert latency <= observation.age[0, 0] + 1e-6 and observation.age[0, 0] < latency + 0.02 + 1e-6


@pytest.mark.parametrize("camera_hz, control_hz", [(30, 50), (15, 50), (29.97, 60), (50, 50)])
@pytest.mark.parametrize("latency, jitter, drop", [(0.0, 0.0, 0.0), ((0.02, 0.06), 0.0, 0.2), (0.04, 0.05, 0.0)])
def test_what_is_seen_obeys_rate_and_delay(camera_hz, control_hz, latency, jitter, drop):
    """The properties of the definition, from the observations alone."""
    envs, steps, history = 16, 60, 3
    stream = oaktwin.Stream(
        Clock(), latency=latency, jitter=jitter, drop=drop, camera_hz=camera_hz, control_hz=control_hz, history=history, seed=9
    )
    seen = run(stream, steps, range(envs))
    low, high = (latency, latency) if isinstance(latency, float) else latency
    exposures = 0
    for env in range(envs):
        shown = steps_shown(seen, env)
        newest = [item[-1] for item in shown]
        assert all(a <= b for item in shown for a, b in zip(item, item[1:]))
        assert all(a <= b for a, b in zip(newest, newest[1:]))
        for step, observation in enumerate(seen):
            ages = observation.age[env]
            assert all(a >= b for a, b in zip(ages, ages[1:])) and ages[-1] >= low - 1e-6
            for image, age in zip(shown[step], ages):
                # A frame is as old as the step that it shows, except for the view before the episode.
                assert age == pytest.approx((step - image) / control_hz, abs=1e-5) if image else age > 0 or low == 0
            if drop == 0:
                assert ages[-1] < high + jitter + 1 / camera_hz + 1 / control_hz + 1e-6
            assert observation.fresh[env] == (step == 0 or newest[step] != newest[step - 1])  or newest[step] == 0
        exposures += len(set(newest) - {0})
    # With jitter, frames overtake others, and hide them.
    if jitter == 0:
        expected = envs * (steps / control_hz - (low + high) / 2) * camera_hz * (1 - drop)
        assert exposures == pytest.approx(expected, rel=0.15)


def test_the_average_age_is_delay_and_half_a_period():
    stream = oaktwin.Stream(Clock(), latency=(0.02, 0.06), camera_hz=25, control_hz=100)
    seen = run(stream, 200, range(64))
    # Half a step of rounding up on arrival; 25 Hz is a whole number of steps.
    mean = np.mean([observation.age[:, -1] for observation in seen[20:]])
    assert mean == pytest.approx(0.04 + 0.005 + 0.015, abs=0.003)
    first = np.mean(seen[0].age[:, -1])
    assert first == pytest.approx(0.04 + 0.02, abs=0.006)


def test_lost_frames():
    seen = run(oaktwin.Stream(Clock(), latency=0.0, camera_hz=50, control_hz=50, drop=0.3), 400, [0, 1, 2])
    share = np.mean([observation.fresh for observation in seen[1:]])
    assert share == pytest.approx(0.7, abs=0.05)
    # Even when nearly all are lost, the history is of frames that arrived.
    sparse = oaktwin.Stream(Clock(), latency=0.0, camera_hz=50, control_hz=50, drop=0.9, history=4)
    shown = steps_shown(run(sparse, 300, [0]))
    assert all(len(set(item)) == 4 for item in shown[150:])


def test_only_exposing_environments_are_measured():
    clock = Clock()
    run(oaktwin.Stream(clock, latency=0.0, camera_hz=10, control_hz=50), 51, range(10))
    counts = [count for count, _, _ in clock.calls]
    assert counts[0] == 10 and sum(counts[1:]) == 100
    assert [frame for _, frame, _ in clock.calls] == sorted(frame for _, frame, _ in clock.calls)


def test_a_batch_can_be_split(device):
    """The bytes of an environment depend on its number, not on the batch."""
    def make(first):
        sensor = oaktwin.DepthSensor(device, parameters={"dropout": 0.1})
        return oaktwin.Stream(sensor, latency=(0.0, 0.05), jitter=0.02, drop=0.1, history=2, seed=5, first_env=first)

    resets = [(4, [1, 5]), (9, [0, 2])]
    whole = run_room(make(0), range(6), resets)
    halves = [run_room(make(3 * half), range(3 * half, 3 * half + 3), [(at, [i - 3 * half for i in ids if i // 3 == half]) for at, ids in resets])
              for half in range(2)]
    for step, observation in enumerate(whole):
        for array, parts in zip(observation, zip(halves[0][step], halves[1][step])):
            assert np.array_equal(array, np.concatenate(parts))
    again = run_room(make(0), range(6), resets)
    assert all(np.array_equal(a.depth, b.depth) and np.array_equal(a.age, b.age) for a, b in zip(whole, again))
    assert not np.array_equal(whole[3].depth[0], whole[3].depth[1])


def run_room(stream, envs, resets):
    seen = []
    for step in range(14):
        for at, ids in resets:
            if at == step:
                stream.reset(np.array(ids, int))
        walls = [np.full((20, 30), 1 + 0.1 * step + 0.2 * env, np.float32) for env in envs]
        seen.append(stream(np.stack(walls)))
    return seen


def test_measured_images_are_the_sensors(device):
    """Every image is a measurement by the sensor with a seed of its own."""
    sensor = oaktwin.DepthSensor(device)
    calls = []

    def recorded(depth, rgb=None, *, frame=None, seed=None):
        calls.append((frame, seed))
        return sensor(depth, rgb, frame=frame, seed=seed)

    stream = oaktwin.Stream(recorded, latency=0.0, camera_hz=50, control_hz=50)
    wall = np.full((2, 20, 30), 2.0, np.float32)
    first, second = stream(wall), stream(wall)
    assert calls[0][0] == 0 and calls[1][0] == 1 and calls[0][1] == calls[1][1] and len(set(calls[0][1])) == 2
    assert np.array_equal(first.depth[:, 0], sensor(wall, frame=0, seed=calls[0][1]))
    assert np.array_equal(second.depth[:, 0], sensor(wall, frame=1, seed=calls[0][1]))


def test_reset_begins_an_episode():
    stream = oaktwin.Stream(Clock(), latency=0.06, camera_hz=50, control_hz=50)
    seen = run(stream, 20, range(3), resets=[(10, [1])])
    assert [shown[0] for shown in steps_shown(seen, 0)][10:14] == [7, 8, 9, 10]
    # No view of the previous episode.
    assert [shown[0] for shown in steps_shown(seen, 1)][10:16] == [10, 10, 10, 10, 11, 12]
    by_mask = run(oaktwin.Stream(Clock(), latency=0.06, camera_hz=50, control_hz=50), 20, range(3), resets=[(10, np.array([False, True, False]))])
    assert all(np.array_equal(a.depth, b.depth) for a, b in zip(seen, by_mask))
    everything = run(oaktwin.Stream(Clock(), latency=0.06, camera_hz=50, control_hz=50), 12, range(3), resets=[(10, None)])
    assert steps_shown(everything, 2)[10] == [10]


def test_some_environments_step():
    """A step of some environments leaves the others as they were, whatever the others see later."""
    options = dict(latency=(0.0, 0.05), camera_hz=30, control_hz=50, history=2, seed=3)
    plain, partial = oaktwin.Stream(Clock(), **options), oaktwin.Stream(Clock(), **options)
    for step in range(30):
        if step == 12:
            partial.reset([1])
            before = last
            seen = partial(scenes(500, range(3)), env_ids=[1])
            for kept in (0, 2):
                assert all(np.array_equal(a[kept], b[kept]) for a, b in zip(before[:2], seen[:2])) and not seen.fresh[kept]
            assert steps_shown([seen], 1) == [[500, 500]] and seen.fresh[1]
        expected, last = plain(scenes(step, range(3))), partial(scenes(step, range(3)))
        for env in (0, 2):
            assert all(np.array_equal(a[env], b[env]) for a, b in zip(expected, last)), step


def test_delays_differ_between_episodes():
    stream = oaktwin.Stream(Clock(), latency=(0.0, 0.2), camera_hz=50, control_hz=50)
    ages = []
    for _ in range(30):
        seen = run(stream, 15, range(2))
        ages.append(tuple(seen[-1].age[:, -1]))
        stream.reset()
    assert len(set(ages)) > 10 and any(a != b for a, b in ages)


def test_the_policys_image():
    picture = np.arange(1, 49, dtype=np.float32).reshape(1, 6, 8)
    picture[0, 2, 3] = 0
    stream = oaktwin.Stream(
        Clock(), latency=0.0, crop=(1, 1, 2, 0), resize=(2, 3), clip=(10, 30), normalize=True, invalid=-1.0
    )
    shown = stream(picture).depth
    # Rows 1 and 3 of the four that remain, columns 1, 3 and 5 of the six.
    rows, columns = [2, 4], [3, 5, 7]
    expected = np.clip((picture[0][np.ix_(rows, columns)] - 10) / 20, 0, 1)
    expected[0, 0] = -1
    assert shown.shape == (1, 1, 2, 3) and shown.dtype == np.float32
    assert np.allclose(shown[0, 0], expected)
    plain = oaktwin.Stream(Clock(), latency=0.0)(picture[..., None])
    assert np.array_equal(plain.depth, picture[:, None])


def test_observations_are_copies():
    stream = oaktwin.Stream(Clock(), latency=0.0, camera_hz=50, control_hz=50)
    first = stream(scenes(0, [0]))
    kept = first.depth.copy()
    stream(scenes(1, [0]))
    assert np.array_equal(first.depth, kept)


def test_no_environments(device):
    stream = oaktwin.Stream(oaktwin.DepthSensor(device), latency=0.02, resize=(4, 5))
    for _ in range(2):
        seen = stream(np.empty((0, 8, 9), np.float32))
        assert seen.depth.shape == (0, 1, 4, 5) and seen.age.shape == (0, 1) and seen.fresh.shape == (0,)
    stream.reset()


def test_a_failed_step_changes_nothing(device):
    stream = oaktwin.Stream(oaktwin.DepthSensor(device), latency=0.0)
    with pytest.raises(TypeError):
        stream(np.full((2, 8, 9), 2.0, np.float32), np.zeros((2, 8, 9)))
    seen = stream(np.full((3, 8, 9), 2.0, np.float32))
    other = oaktwin.Stream(oaktwin.DepthSensor(device), latency=0.0)
    assert np.array_equal(seen.depth, other(np.full((3, 8, 9), 2.0, np.float32)).depth)


def test_a_stream_can_be_pickled(device):
    stream = oaktwin.Stream(oaktwin.DepthSensor(device), latency=0.03)
    wall = np.full((2, 8, 30), 2.0, np.float32)
    stream(wall)
    copy = pickle.loads(pickle.dumps(stream))
    for _ in range(4):
        assert np.array_equal(stream(wall).depth, copy(wall).depth)


@pytest.mark.parametrize(
    "options, message",
    [
        ({"latency": -0.1}, "latency: is -0.1; pass a number at least 0"),
        ({"latency": (0.05, 0.01)}, "latency: low, 0.05, exceeds high, 0.01"),
        ({"latency": (0.05,)}, "latency: has 1 values"),
        ({"latency": 40.0}, "latency: 40 s and a history of 1 keep 1202 frames of each environment, more than 256"),
        ({"latency": math.nan}, "latency: is nan"),
        ({"latency": "fast"}, "latency: "),
        ({"camera_hz": 0}, "camera_hz: is 0; pass a number above 0"),
        ({"camera_hz": 60}, "camera_hz: 60 exceeds control_hz, 50"),
        ({"jitter": math.inf}, "jitter: is inf"),
        ({"drop": 1.0}, "drop: is 1, so that no frame arrives"),
        ({"history": 0}, "history: is 0; pass a whole number of at least 1"),
        ({"seed": -1}, "seed: is -1"),
        ({"crop": (1, 2)}, r"crop: is \(1, 2\); pass \(top, bottom, left, right\)"),
        ({"resize": (0, 4)}, "resize: is"),
        ({"clip": (2, 1)}, "clip: is"),
        ({"normalize": True}, "normalize: needs clip"),
        ({"invalid": math.nan}, "invalid: is nan"),
    ],
)
def test_bad_options(options, message):
    with pytest.raises(oaktwin.Error, match=message):
        oaktwin.Stream(Clock(), **({"latency": 0.02} | options))


def test_bad_steps(device):
    with pytest.raises(oaktwin.Error, match="sensor: has a temporal filter"):
        oaktwin.Stream(oaktwin.DepthSensor(device, filters=["temporal"]), latency=0.0)
    with pytest.raises(TypeError):
        oaktwin.Stream(Clock())
    stream = oaktwin.Stream(Clock(), latency=0.0, crop=(2, 2, 0, 0))
    with pytest.raises(oaktwin.Error, match=r"crop: \(2, 2, 0, 0\) leaves nothing of images of 3 x 4 pixels"):
        stream(scenes(0, [0]))
    stream = oaktwin.Stream(Clock(), latency=0.0)
    with pytest.raises(oaktwin.Error, match=r"depth: has the shape \(3, 4\); pass the images of all environments"):
        stream(scenes(0, [0])[0])
    with pytest.raises(oaktwin.Error, match="depth: has the dtype float16; pass float32 metres"):
        stream(scenes(0, [0]).astype(np.float16))
    stream(scenes(0, [0, 1]))
    with pytest.raises(oaktwin.Error, match=r"depth: has the shape \(1, 3, 4\), but earlier steps had \(2, 3, 4\)"):
        stream(scenes(0, [0]))
    for ids in ([2], [-1], [0.5], [[0]]):
        with pytest.raises(oaktwin.Error, match="env_ids: .* are not numbers of environments"):
            stream.reset(ids)
    with pytest.raises(oaktwin.Error, match="env_ids: a mask of shape"):
        stream.reset([True])


@pytest.mark.parametrize("history", [1, 3])
def test_torch(history):
    torch = pytest.importorskip("torch")
    options = dict(latency=(0.0, 0.05), drop=0.1, history=history, crop=(0, 1, 1, 0), resize=(2, 2), clip=(0.5, 3000), normalize=True)
    tensors, arrays = oaktwin.Stream(Clock(), **options), oaktwin.Stream(Clock(), **options)
    for step in range(20):
        if step == 9:
            tensors.reset(torch.tensor([1, 2]))
            arrays.reset([1, 2])
        seen, expected = tensors(torch.from_numpy(scenes(step, range(4)))), arrays(scenes(step, range(4)))
        assert torch.is_tensor(seen.depth) and np.array_equal(seen.depth.numpy(), expected.depth)
        assert np.array_equal(seen.age, expected.age)
