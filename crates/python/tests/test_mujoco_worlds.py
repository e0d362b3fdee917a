"""Worlds of MuJoCo models."""

import numpy as np
import pytest

mujoco = pytest.importorskip("mujoco")

import oaktwin  # noqa: E402
import oaktwin.mujoco  # noqa: E402

MODEL = """
<mujoco>
  <asset><hfield name="hills" nrow="5" ncol="7" size="3 2 0.5 0.1"/></asset>
  <worldbody>
    <geom type="hfield" hfield="hills"/>
    <geom type="box" size="0.2 0.2 0.2" pos="1 1 1"/>
    <body name="arm" pos="0 0 1">
      <joint name="turn" type="hinge" axis="0 0 1"/>
      <geom type="capsule" size="0.1" fromto="0 0 0 1 0 0"/>
      <body pos="1 0 0"><joint type="slide" axis="0 0 1"/><geom type="sphere" size="0.15"/></body>
    </body>
  </worldbody>
</mujoco>
"""


@pytest.fixture
def model():
    model = mujoco.MjModel.from_xml_string(MODEL)
    model.hfield_data[:] = np.random.default_rng(0).uniform(0, 1, model.hfield_data.shape)
    return model


def rays(model, data, camera, pose):
    """The z-depth of MuJoCo's own rays."""
    directions = camera.rays() @ np.asarray(pose)[:3, :3].T
    depth = np.full(directions.shape[:2], np.inf)
    geom, normal = np.empty(1, np.int32), np.zeros(3)
    for place in np.ndindex(depth.shape):
        ray = np.ascontiguousarray(directions[place])
        distance = mujoco.mj_ray(model, data, np.ascontiguousarray(pose[:3, 3]), ray, None, True, -1, geom, normal)
        if distance >= 0:
            depth[place] = distance * float(ray @ np.asarray(pose)[:3, 2])
    return depth


def test_worlds_are_mujocos(model):
    """Against MuJoCo's ray caster: round shapes are polyhedra, whose error is below a percent of their radius."""
    count, camera = 5, oaktwin.Camera((32, 20), hfov_deg=80)
    qpos = np.random.default_rng(1).uniform(-1, 1, (count, model.nq))
    worlds = oaktwin.mujoco.Worlds(model, count)
    assert len(worlds) == count and len(worlds.geoms) == 2
    worlds.update(qpos)
    view = np.asarray(oaktwin.look_at((2.5, 0.5, 2.5), (0, 0, 0.5)))
    depth = worlds.render(camera, view)
    data = mujoco.MjData(model)
    positions, rotations = [], []
    for number in range(count):
        data.qpos[:] = qpos[number]
        mujoco.mj_forward(model, data)
        expected = rays(model, data, camera, view)
        both = np.isfinite(expected) & np.isfinite(depth[number])
        assert np.mean(np.isfinite(expected) == np.isfinite(depth[number])) > 0.98
        errors = np.abs(depth[number] - expected)[both]
        # Pixels at outlines see one surface or the other.
        assert np.median(errors) < 1e-6 and np.mean(errors < 0.01) > 0.97
        positions.append(data.geom_xpos.copy())
        rotations.append(data.geom_xmat.copy())
    other = oaktwin.mujoco.Worlds(model, count)
    other.update(geom_xpos=positions, geom_xmat=np.reshape(rotations, (count, model.ngeom, 3, 3)))
    assert np.array_equal(other.render(camera, view), depth)
    other.update(qpos[[3]], worlds=[0])
    assert np.array_equal(other.render(camera, view, worlds=[0]), depth[[3]])


def test_a_scene(model):
    scene = oaktwin.mujoco.scene(model)
    assert sorted(scene.poses) == [f"/World/geom_{index}" for index in range(model.ngeom)]


def test_what_is_wrong(model):
    worlds = oaktwin.mujoco.Worlds(model, 2)
    for arguments, expected in [
        ({}, "pass either qpos, or geom_xpos and geom_xmat"),
        ({"qpos": np.zeros((2, 5))}, r"qpos: has shape \(2, 5\); pass \(N, 2\)"),
        ({"qpos": np.full((2, 2), np.nan)}, "qpos: has values that are not finite"),
        ({"geom_xpos": np.zeros((2, 1, 3)), "geom_xmat": np.zeros((2, 1, 9))}, r"geom_xpos: has shape \(2, 1, 3\)"),
        ({"qpos": np.zeros((3, 2))}, "poses: has shape"),
    ]:
        with pytest.raises(oaktwin.Error, match=expected):
            worlds.update(**arguments)
    with pytest.raises(oaktwin.Error, match="it has no geoms"):
        oaktwin.mujoco.scene(mujoco.MjModel.from_xml_string("<mujoco><worldbody/></mujoco>"))


CAMERAS = """
<mujoco>
  <worldbody>
    <geom type="box" size="1 1 0.1"/>
    <camera name="fixed" pos="0 0 3" xyaxes="1 0 0 0 1 0" fovy="50" resolution="40 30"/>
    <camera name="metric" pos="0.3 0 3" xyaxes="1 0 0 0 1 0" resolution="40 30" sensorsize="0.004 0.003" focal="0.005 0.004"
      principal="0.0002 -0.0001"/>
    <body pos="0 0 1">
      <freejoint/><geom type="box" size="0.2 0.1 0.1"/>
      <camera name="head" pos="0.2 0 0.3" xyaxes="0 -1 0 1 0 1" fovy="70"/>
    </body>
  </worldbody>
</mujoco>
"""


@pytest.mark.parametrize("name", ["fixed", "metric", "head"])
def test_cameras_of_the_model(name):
    """Against MuJoCo's rays through the pixels of its own frustum."""
    model = mujoco.MjModel.from_xml_string(CAMERAS)
    worlds = oaktwin.mujoco.Worlds(model, 3)
    qpos = np.tile(model.qpos0, (3, 1))
    qpos[:, :3] += np.random.default_rng(3).uniform(-0.3, 0.3, (3, 3))
    worlds.update(qpos)
    size = None if name != "head" else (40, 30)
    depth = worlds.render(name, size=size)
    data, number = mujoco.MjData(model), model.camera(name).id
    half_y = np.tan(np.radians(model.cam_fovy[number]) / 2)
    bounds = np.array([-half_y * 4 / 3, half_y * 4 / 3, half_y, -half_y])
    if name == "metric":
        fx, fy, cx, cy = model.cam_intrinsic[number]
        bounds = np.array([-(0.002 - cx) / fx, (0.002 + cx) / fx, (0.0015 - cy) / fy, -(0.0015 + cy) / fy])
    columns, rows = (np.arange(40) + 0.5) / 40, (np.arange(30) + 0.5) / 30
    x, y = np.meshgrid(bounds[0] + (bounds[1] - bounds[0]) * columns, bounds[2] + (bounds[3] - bounds[2]) * rows)
    rays = np.stack([x, y, -np.ones_like(x)], -1)
    geom, normal = np.empty(1, np.int32), np.zeros(3)
    for world in range(3):
        data.qpos[:] = qpos[world]
        mujoco.mj_forward(model, data)
        turned = rays @ data.cam_xmat[number].reshape(3, 3).T
        start = np.ascontiguousarray(data.cam_xpos[number])
        # The length of the ray to z = 1 is the unit of distances.
        exact = [mujoco.mj_ray(model, data, start, np.ascontiguousarray(ray), None, True, -1, geom, normal) for ray in turned.reshape(-1, 3)]
        exact = np.array(exact).reshape(30, 40)
        agree = np.abs(np.where(np.isinf(depth[world]), -1, depth[world]) - exact) < 1e-4
        assert agree.mean() > 0.99 and (exact > 0).mean() > 0.2
    # The same from arrays, for some worlds.
    other = oaktwin.mujoco.Worlds(model, 3)
    arrays = dict(geom_xpos=data.geom_xpos[None], geom_xmat=data.geom_xmat[None], cam_xpos=data.cam_xpos[None], cam_xmat=data.cam_xmat[None])
    other.update(**arrays, worlds=[1])
    assert np.array_equal(other.render(name, size=size, worlds=[1])[0], depth[2])


def test_what_is_wrong_with_cameras(model):
    worlds = oaktwin.mujoco.Worlds(mujoco.MjModel.from_xml_string(CAMERAS), 2)
    with pytest.raises(oaktwin.Error, match="camera: the model has no camera 'hand'; it has fixed, metric, head"):
        worlds.camera("hand")
    with pytest.raises(oaktwin.Error, match="camera: the model states no resolution of head; pass size="):
        worlds.render("head")
    with pytest.raises(oaktwin.Error, match="camera: the model has no camera 'head'; it has none"):
        oaktwin.mujoco.Worlds(model, 1).render("head")
    with pytest.raises(oaktwin.Error, match="world_from_camera: pass the poses"):
        worlds.render(oaktwin.Camera((4, 3), hfov_deg=60))
    with pytest.raises(oaktwin.Error, match="cam_xpos: pass cam_xpos and cam_xmat, or neither"):
        worlds.update(geom_xpos=np.zeros((2, 2, 3)), geom_xmat=np.zeros((2, 2, 9)), cam_xpos=np.zeros((2, 3, 3)))
    # The field of view and the centre of the metric camera.
    camera = worlds.camera("metric", (80, 60))
    assert np.allclose(camera.K, [[100, 0, 40 - 4 - 0.5], [0, 80, 30 + 2 - 0.5], [0, 0, 1]])
