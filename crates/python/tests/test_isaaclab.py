"""`oaktwin.isaaclab` with stand-ins that have the interfaces of Isaac Lab 2.3 and 3.0, which itself needs other versions of Python."""

import dataclasses
import sys
from types import ModuleType, SimpleNamespace

import numpy as np
import pytest

import oaktwin

torch = pytest.importorskip("torch")
STREAM = {"latency": 0.04, "camera_hz": 50, "history": 2}


class ManagerTermBase:
    def __init__(self, cfg, env):
        self.cfg, self._env = cfg, env


class NoiseModel:
    def __init__(self, noise_model_cfg, num_envs, device):
        self._noise_model_cfg, self._num_envs, self._device = noise_model_cfg, num_envs, device

    def reset(self, env_ids=None):
        pass


class NoiseModelCfg:
    class_type: type = NoiseModel
    noise_cfg: object = None
    func: object = None


@pytest.fixture
def lab(monkeypatch):
    modules = {
        "isaaclab": {},
        "isaaclab.managers": {"ManagerTermBase": ManagerTermBase},
        "isaaclab.utils": {"configclass": dataclasses.dataclass},
        "isaaclab.utils.noise": {"NoiseModel": NoiseModel, "NoiseModelCfg": dataclasses.dataclass(NoiseModelCfg)},
    }
    for name, contents in modules.items():
        module = ModuleType(name)
        vars(module).update(contents)
        monkeypatch.setitem(sys.modules, name, module)
    monkeypatch.delitem(sys.modules, "oaktwin.isaaclab", raising=False)
    import oaktwin.isaaclab as lab

    yield lab
    sys.modules.pop("oaktwin.isaaclab", None)


class Array3:
    """An array of version 3, whose tensor is an attribute."""

    def __init__(self, tensor):
        self.torch = tensor


def environment(wrap, fx=40.0, name="distance_to_image_plane"):
    data = SimpleNamespace(
        intrinsic_matrices=wrap(torch.tensor([[fx, 0, 15], [0, fx, 10], [0, 0, 1.0]]).repeat(3, 1, 1)),
        output={name: wrap(torch.zeros(3, 20, 30, 1))},
    )
    return SimpleNamespace(scene=SimpleNamespace(sensors={"camera": SimpleNamespace(data=data)}), step_dt=0.02, common_step_counter=0)


def show(env, wrap, depth):
    env.scene.sensors["camera"].data.output["distance_to_image_plane"] = wrap(torch.full((3, 20, 30, 1), float(depth)))


@pytest.mark.parametrize("wrap", [lambda tensor: tensor, Array3], ids=["2.3", "3.0"])
def test_the_term_follows_steps_and_resets(lab, device, wrap):
    env = environment(wrap)
    params = {"sensor_cfg": SimpleNamespace(name="camera"), "model": "OAK4-D", "stream": STREAM}
    term = lab.OakDepth(SimpleNamespace(params=params), env)
    reference = oaktwin.Stream(oaktwin.DepthSensor(device, fx=40.0), control_hz=50, **STREAM)

    def image(depth):
        return np.full((3, 20, 30, 1), depth, np.float32)

    # The manager asks for the shape first, and everything is reset before the first episode.
    show(env, wrap, 5)
    assert term(env, **params).shape == (3, 2, 20, 30)
    reference(image(5))
    term.reset()
    reference.reset()
    show(env, wrap, 4)
    assert np.array_equal(term(env, **params).numpy(), reference(image(4), env_ids=[0, 1, 2]).depth)
    for step in range(1, 12):
        env.common_step_counter = step
        show(env, wrap, 4 - 0.1 * step)
        if step == 6:
            term.reset(torch.tensor([1]))
            reference.reset([1])
        expected = reference(image(4 - 0.1 * step)).depth
        observed = term(env, **params)
        assert np.array_equal(observed.numpy(), expected)
        # Observations of the same step, which may be changed.
        observed.zero_()
        assert np.array_equal(term(env, **params).numpy(), expected)
    # A reset between steps: time passes for the one environment alone.
    term.reset(torch.tensor([2]))
    reference.reset([2])
    show(env, wrap, 1.5)
    observed = term(env, **params)
    assert np.array_equal(observed.numpy(), reference(image(1.5), env_ids=[2]).depth)
    assert np.array_equal(observed[:2].numpy(), expected[:2])


def test_noise_alone(lab, device):
    cfg = lab.OakDepthNoiseCfg(model="OAK4-D", sensor={"hfov_deg": 70.0})
    noise = cfg.class_type(cfg, num_envs=2, device="cpu")
    exact = torch.full((2, 20, 30, 1), 2.0)
    sensor = oaktwin.DepthSensor(device, hfov_deg=70.0)
    for frame in range(2):
        assert np.array_equal(noise(exact)[..., 0].numpy(), sensor(exact[..., 0].numpy(), frame=frame))
        noise.reset([0])


def test_bad_terms(lab):
    env = environment(lambda tensor: tensor, name="rgb")
    term = lab.OakDepth(SimpleNamespace(params={}), env)
    camera = SimpleNamespace(name="camera")
    with pytest.raises(oaktwin.Error, match="sensor_cfg: camera renders rgb; add 'distance_to_image_plane' to its data_types"):
        term(env, camera, stream=STREAM)
    env = environment(lambda tensor: tensor)
    with pytest.raises(oaktwin.Error, match="stream: has no latency"):
        term(env, camera)
    with pytest.raises(oaktwin.Error, match="OAK9"):
        term(env, camera, model="OAK9", stream=STREAM)


@pytest.mark.parametrize(
    "name, package, command",
    [
        ("warp", "warp", "pip install warp-lang"),
        ("gymnasium", "gymnasium", "pip install gymnasium"),
        ("mjlab", "mjlab.managers.manager_base", "pip install mjlab"),
        ("isaaclab", "isaaclab.managers", "pip install isaaclab"),
    ],
)
def test_what_is_missing_is_named(monkeypatch, name, package, command):
    import importlib

    for module in [module for module in sys.modules if module == f"oaktwin.{name}" or module.startswith(f"oaktwin.{name}.")]:
        monkeypatch.delitem(sys.modules, module)
    monkeypatch.setitem(sys.modules, package, None)
    monkeypatch.setitem(sys.modules, package.partition(".")[0], None)
    with pytest.raises(ImportError, match=command):
        importlib.import_module(f"oaktwin.{name}")


def test_nothing_optional_is_imported():
    import subprocess

    code = "import sys, oaktwin; print(sorted({'warp', 'torch', 'gymnasium', 'mjlab', 'isaaclab', 'jax'} & set(sys.modules)))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert done.stdout.strip() == "[]", done.stderr
