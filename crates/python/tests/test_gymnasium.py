"""`oaktwin.gymnasium.OakDepthObservation`."""

import numpy as np
import pytest

import oaktwin

gymnasium = pytest.importorskip("gymnasium")


class Approach(gymnasium.Env):
    """A camera that approaches a wall."""

    action_space = gymnasium.spaces.Discrete(1)

    def __init__(self, dictionary):
        box = gymnasium.spaces.Box(0, np.inf, (20, 30), np.float32)
        self.dictionary = dictionary
        self.observation_space = gymnasium.spaces.Dict({"depth": box, "step": gymnasium.spaces.Discrete(99)}) if dictionary else box

    def seen(self):
        depth = np.full((20, 30), 4 - 0.1 * self.at, np.float32)
        return {"depth": depth, "step": self.at} if self.dictionary else depth

    def reset(self, *, seed=None, options=None):
        super().reset(seed=seed)
        self.at = 0
        return self.seen(), {}

    def step(self, action):
        self.at += 1
        return self.seen(), 0.0, False, False, {}


@pytest.mark.parametrize("dictionary", [False, True])
def test_a_wrapped_environment(device, dictionary):
    from oaktwin.gymnasium import OakDepthObservation

    options = dict(latency=0.06, camera_hz=50, control_hz=50, history=2, seed=4)
    env = OakDepthObservation(Approach(dictionary), oaktwin.DepthSensor(device), key="depth" if dictionary else None, **options)
    stream = oaktwin.Stream(oaktwin.DepthSensor(device), **options)
    for _ in range(2):
        observation, _ = env.reset(seed=1)
        stream.reset()
        for step in range(8):
            assert env.observation_space.contains(observation)
            depth = observation["depth"] if dictionary else observation
            expected = stream(np.full((1, 20, 30), 4 - 0.1 * step, np.float32)).depth[0]
            assert depth.shape == (2, 20, 30) and np.array_equal(depth, expected)
            assert np.median(depth[1][depth[1] > 0]) == pytest.approx(4 - 0.1 * max(step - 3, 0), abs=0.05)
            if step < 7:
                observation, *_ = env.step(0)


def test_bad_environments(device):
    from oaktwin.gymnasium import OakDepthObservation

    sensor = oaktwin.DepthSensor(device)
    with pytest.raises(oaktwin.Error, match="key: the observation has no 'dept'; expected one of depth, step"):
        OakDepthObservation(Approach(True), sensor, key="dept", latency=0.0)
    with pytest.raises(oaktwin.Error, match="env: the observation is Dict.*; pass key= of a depth image"):
        OakDepthObservation(Approach(True), sensor, latency=0.0)
