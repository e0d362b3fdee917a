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
