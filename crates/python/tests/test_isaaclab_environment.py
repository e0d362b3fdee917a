"""`oaktwin.isaaclab` in an environment of Isaac Lab 3 on Newton, on a CPU without Isaac Sim."""

import numpy as np
import pytest

import oaktwin

pytest.importorskip("isaaclab_newton", reason="Isaac Lab 3 is not installed: pip install isaaclab")
torch = pytest.importorskip("torch")
pytestmark = [pytest.mark.slow, pytest.mark.filterwarnings("ignore")]

STREAM = {"latency": 0.05, "camera_hz": 25, "clip": (0.2, 6.0), "normalize": True, "history": 2}
SENSOR = {"hfov_deg": 47.2}


def configuration():
    """Boxes that fall to the ground in front of cameras."""
    import isaaclab.sim as sim
    from isaaclab.assets import AssetBaseCfg, RigidObjectCfg
    from isaaclab.envs import ManagerBasedRLEnvCfg, mdp
    from isaaclab.managers import ObservationGroupCfg, ObservationTermCfg, RewardTermCfg, SceneEntityCfg, TerminationTermCfg
    from isaaclab.scene import InteractiveSceneCfg
    from isaaclab.sensors import CameraCfg
    from isaaclab.utils import configclass
    from isaaclab_newton.physics import MJWarpSolverCfg, NewtonCfg
    from isaaclab_newton.renderers import NewtonWarpRendererCfg

    from oaktwin.isaaclab import OakDepth, OakDepthNoiseCfg

    collides = sim.UsdPhysicsCollisionCfg()
    camera = SceneEntityCfg("camera")

    @configclass
    class Scene(InteractiveSceneCfg):
        ground = AssetBaseCfg(
            prim_path="/World/ground",
            spawn=sim.CuboidCfg(size=(50.0, 50.0, 0.1), collision_props=collides),
            init_state=AssetBaseCfg.InitialStateCfg(pos=(0, 0, -0.05)),
        )
        box = RigidObjectCfg(
            prim_path="{ENV_REGEX_NS}/Box",
            spawn=sim.CuboidCfg(
                size=(0.3, 0.4, 0.5), rigid_props=sim.UsdPhysicsRigidBodyCfg(), mass_props=sim.MassCfg(mass=1.0), collision_props=collides
            ),
            init_state=RigidObjectCfg.InitialStateCfg(pos=(2.0, 0.0, 1.5)),
        )
        camera = CameraCfg(
            prim_path="{ENV_REGEX_NS}/Camera",
            offset=CameraCfg.OffsetCfg(pos=(0.0, 0.0, 0.8), rot=(0.0, 0.0, 0.0, 1.0), convention="world"),
            data_types=["distance_to_image_plane"],
            spawn=sim.PinholeCameraCfg(focal_length=24.0, horizontal_aperture=20.955, clipping_range=(0.1, 20.0)),
            width=64,
            height=40,
            renderer_cfg=NewtonWarpRendererCfg(use_cuda_graph=False),
        )

    @configclass
    class Policy(ObservationGroupCfg):
        depth = ObservationTermCfg(func=OakDepth, params={"sensor_cfg": camera, "model": "OAK4-D", "stream": STREAM})

    @configclass
    class Noisy(ObservationGroupCfg):
        depth = ObservationTermCfg(
            func=mdp.image_depth,
            params={"sensor_cfg": camera, "normalize": False},
            noise=OakDepthNoiseCfg(model="OAK4-D", sensor=SENSOR),
        )

        def __post_init__(self):
            self.enable_corruption = True

    @configclass
    class Observations:
        policy: Policy = Policy()
        noisy: Noisy = Noisy()

    @configclass
    class Nothing:
        pass

    @configclass
    class Rewards:
        alive = RewardTermCfg(func=mdp.is_alive, weight=1.0)

    @configclass
    class Terminations:
        time_out = TerminationTermCfg(func=mdp.time_out, time_out=True)

    @configclass
    class Environment(ManagerBasedRLEnvCfg):
        scene: Scene = Scene(num_envs=2, env_spacing=8.0)
        observations: Observations = Observations()
        actions: Nothing = Nothing()
        rewards: Rewards = Rewards()
        terminations: Terminations = Terminations()

        def __post_init__(self):
            self.decimation, self.episode_length_s = 2, 0.3
            self.sim.dt, self.sim.device = 0.01, "cpu"
            self.sim.physics = NewtonCfg(solver_cfg=MJWarpSolverCfg(njmax=60, nconmax=60), use_cuda_graph=False)

    return Environment()


def test_an_environment_on_newton():
    from isaaclab.envs import ManagerBasedRLEnv

    env = ManagerBasedRLEnv(configuration())

    def exact():
        output = env.scene["camera"].data.output["distance_to_image_plane"]
        return output.torch.clone().numpy()

    intrinsics = env.scene["camera"].data.intrinsic_matrices
    fx = float(getattr(intrinsics, "torch", intrinsics)[0, 0, 0])
    reference = oaktwin.Stream(oaktwin.DepthSensor(oaktwin.Device("OAK4-D"), fx=fx), control_hz=50, **STREAM)
    observed, _ = env.reset()
    assert observed["policy"].shape == (2, 2, 40, 64) and observed["noisy"].shape == (2, 40, 64, 1)
    noise = []
    resets = 0
    for step in range(20):
        observed, _, _, ended, _ = env.step(torch.zeros(2, 0))
        resets += int(ended.any())
        depth = exact()
        expected = reference(depth)
        shown = observed["policy"].numpy()
        assert shown.shape == expected.depth.shape
        seen = (depth > 0.5) & (depth < 6) & (observed["noisy"].numpy() > 0)
        noise.append(np.abs(observed["noisy"].numpy() - depth)[seen] / depth[seen] ** 2)
        if 8 <= step < 14:
            # Delays and phases agree with a stream of the same seed; frames are numbered from the first call of each.
            both = (shown > 0) & (shown < 1) & (expected.depth > 0) & (expected.depth < 1)
            assert both.any() and np.abs(shown - expected.depth)[both].mean() < 0.02, step
    assert resets >= 1
    # Errors of disparity: noise that grows with the square of the distance.
    errors = np.concatenate(noise)
    assert 0 < np.median(errors) < 0.02
    env.close()
