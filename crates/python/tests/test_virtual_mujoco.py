"""A virtual device on a body of a MuJoCo model."""

import numpy as np
import pytest

dai = pytest.importorskip("depthai")
mujoco = pytest.importorskip("mujoco")

import oaktwin  # noqa: E402
from oaktwin.depthai import from_mujoco, virtual_device  # noqa: E402

MODEL = """
<mujoco>
  <worldbody>
    <geom type="plane" size="0 0 1" pos="0 0 -1"/>
    <geom type="box" size="0.1 2 2" pos="2.1 0 0" rgba="0.2 0.8 0.2 1"/>
    <geom type="sphere" size="0.2" pos="1.5 0.6 0"/>
    <geom type="capsule" size="0.1 0.2" pos="1.5 -0.6 0"/>
    <geom type="cylinder" size="0.1 0.2" pos="1.5 0 0.5"/>
    <geom type="ellipsoid" size="0.1 0.2 0.1" pos="1.5 0 -0.5"/>
    <body name="oak"><joint name="slide" type="slide" axis="1 0 0"/><geom type="box" size="0.01 0.01 0.01" group="3"/></body>
  </worldbody>
</mujoco>
"""


@pytest.fixture
def simulated():
    model = mujoco.MjModel.from_xml_string(MODEL)
    return model, mujoco.MjData(model)


def test_a_device_on_a_moving_body(simulated):
    model, data = simulated

    def step(seconds):
        data.qpos[0] = seconds
        mujoco.mj_forward(model, data)

    world = from_mujoco(model, data, "oak", step=step)
    with virtual_device("OAK4-D", scene=world, fast=True, engine="stereo-noise"), dai.Pipeline() as pipeline:
        stereo = pipeline.create(dai.node.StereoDepth).build(True, size=(320, 200), fps=10)
        queue = stereo.depth.createOutputQueue()
        pipeline.start()
        middles = [np.median(queue.get().getFrame()[95:105, 155:165]) for _ in range(4)]
    assert middles == pytest.approx([2000, 1900, 1800, 1700], rel=0.02)


def test_shapes_are_mujocos(simulated):
    model, data = simulated
    world = from_mujoco(model, data, "oak")
    camera = oaktwin.Camera((60, 40), hfov_deg=80)
    pose = oaktwin.look_at((0, 0, 0), (1, 0, 0))
    depth = world.scene.render(camera, pose)["distance_to_image_plane"]
    rays = camera.rays() @ np.asarray(pose)[:3, :3].T
    geom, distance, normal = np.empty(1, np.int32), 0.0, np.zeros(3)
    for row, column in ((20, 30), (20, 12), (20, 48), (5, 30), (35, 30), (38, 5)):
        ray = rays[row, column].astype(float)
        distance = mujoco.mj_ray(model, data, np.zeros(3), ray, np.array([1, 1, 1, 0, 0, 0], np.uint8), True, -1, geom, normal)
        along = distance * float(ray @ np.asarray(pose)[:3, 2])
        assert depth[row, column] == pytest.approx(along, rel=0.01), (row, column)


def test_an_unknown_body(simulated):
    with pytest.raises(oaktwin.Error, match="has no body 'oka'"):
        from_mujoco(*simulated, "oka")
