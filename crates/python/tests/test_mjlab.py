"""`oaktwin.mjlab` in a task of mjlab, on a CPU."""

from dataclasses import asdict

import numpy as np
import pytest

import oaktwin

pytest.importorskip("mjlab")
torch = pytest.importorskip("torch")
pytestmark = pytest.mark.slow

CAMERA, TERM = "camera_d405", "camera_d405_depth"
SENSOR = {"extended_disparity": True}


def lift_cube(envs, term):
    """mjlab's task of lifting a cube with depth, with another observation term."""
    from mjlab.envs import ManagerBasedRlEnv
    from mjlab.tasks.manipulation.config.yam.env_cfgs import yam_lift_cube_vision_env_cfg

    cfg = yam_lift_cube_vision_env_cfg(cam_type="depth")
    cfg.scene.num_envs = envs
    cfg.observations["camera"].terms[TERM] = term
    return ManagerBasedRlEnv(cfg, device="cpu")


def test_a_policy_trains():
    from mjlab.managers.observation_manager import ObservationTermCfg
    from mjlab.rl import MjlabOnPolicyRunner, RslRlVecEnvWrapper
    from mjlab.tasks.manipulation.config.yam.rl_cfg import yam_lift_cube_vision_ppo_runner_cfg

    from oaktwin.mjlab import OakDepth

    stream = {"latency": 0.05, "camera_hz": 50, "clip": (0.05, 0.5), "normalize": True, "history": 1}
    params = {"sensor_name": CAMERA, "model": "OAK-D Lite", "sensor": SENSOR, "stream": stream}
    env = lift_cube(4, ObservationTermCfg(func=OakDepth, params=params))
    # What is observed is a stream of the exact depth, whose first view stands still.
    observed, _ = env.reset()
    exact = [env.scene[CAMERA].data.depth.clone()]
    seen = [observed["camera"]]
    hfov = float(env.sim.mj_model.cam_fovy[env.scene[CAMERA].camera_idx])  # square images
    for _ in range(8):
        observed, *_ = env.step(torch.rand(4, env.action_manager.total_action_dim) - 0.5)
        assert torch.equal(env.get_observations()["camera"], observed["camera"])
        exact.append(env.scene[CAMERA].data.depth.clone())
        seen.append(observed["camera"])
    reference = oaktwin.Stream(oaktwin.DepthSensor(oaktwin.Device("OAK-D Lite"), hfov_deg=hfov, **SENSOR), control_hz=50, **stream)
    expected = [reference(image).depth for image in exact]
    # The manager calls the term once before the first episode, which differs in the numbers of frames: compared is the delay.
    for step in range(4, 9):
        near = (expected[step] > 0) & (expected[step] < 1) & (seen[step].numpy() > 0)
        assert near.any() and np.abs(expected[step] - seen[step].numpy())[near].mean() < 0.05
    cfg = asdict(yam_lift_cube_vision_ppo_runner_cfg())
    cfg |= {"num_steps_per_env": 4, "logger": "tensorboard"}
    runner = MjlabOnPolicyRunner(RslRlVecEnvWrapper(env), cfg, None, "cpu")
    runner.learn(num_learning_iterations=2, init_at_random_ep_len=True)
    env.close()


def test_noise_alone():
    from mjlab.managers.observation_manager import ObservationTermCfg

    from oaktwin.mjlab import OakDepthNoiseCfg

    def image(env, sensor_name):
        return env.scene[sensor_name].data.depth.permute(0, 3, 1, 2)

    noise = OakDepthNoiseCfg(model="OAK-D Lite", sensor={"hfov_deg": 70.0, **SENSOR})
    env = lift_cube(2, ObservationTermCfg(func=image, params={"sensor_name": CAMERA}, noise=noise))
    env.observation_manager.cfg["camera"].enable_corruption = True
    observed, _ = env.reset()
    assert observed["camera"].shape == (2, 1, 32, 32)
    env.close()
    noisy = noise.class_type(noise, num_envs=2, device="cpu")
    exact = torch.full((2, 1, 20, 30), 0.5)
    sensor = oaktwin.DepthSensor(oaktwin.Device("OAK-D Lite"), hfov_deg=70.0, **SENSOR)
    assert np.array_equal(noisy(exact)[:, 0].numpy(), sensor(exact[:, 0].numpy(), frame=0))
    assert np.array_equal(noisy(exact.permute(0, 2, 3, 1))[..., 0].numpy(), sensor(exact[:, 0].numpy(), frame=1))
    with pytest.raises(oaktwin.Error, match="data: has the shape"):
        noisy(torch.ones(2, 7))
