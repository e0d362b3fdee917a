"""Worlds of Newton models, against Newton's own ray tracer."""

import numpy as np
import pytest

newton = pytest.importorskip("newton")
wp = pytest.importorskip("warp")

import oaktwin  # noqa: E402
import oaktwin.newton  # noqa: E402

pytestmark = pytest.mark.filterwarnings("ignore::DeprecationWarning")
COUNT, SIZE = 3, (48, 32)


def robot():
    builder = newton.ModelBuilder()
    trunk = builder.add_body(xform=wp.transform((0.1, -0.2, 0.8), wp.quat_from_axis_angle(wp.vec3(1, 2, 3), 0.4)))
    turned = wp.transform((0.1, 0.2, 0.05), wp.quat_from_axis_angle(wp.vec3(0, 1, 0), 0.7))
    builder.add_shape_box(trunk, hx=0.3, hy=0.2, hz=0.1)
    builder.add_shape_sphere(trunk, xform=turned, radius=0.15)
    arm = builder.add_body(xform=wp.transform((0.5, 0.3, 0.6), wp.quat_identity()))
    builder.add_shape_capsule(arm, xform=turned, radius=0.08, half_height=0.2)
    builder.add_shape_cylinder(arm, radius=0.1, half_height=0.15)
    builder.add_shape_cone(trunk, xform=wp.transform((-0.4, 0, 0.2), wp.quat_identity()), radius=0.15, half_height=0.2)
    builder.add_shape_ellipsoid(trunk, xform=wp.transform((-0.3, 0.4, 0.1), wp.quat_identity()), rx=0.2, ry=0.1, rz=0.05)
    vertices = np.array([(0, 0, 0), (0.4, 0, 0), (0, 0.4, 0), (0, 0, 0.4)], np.float32)
    faces = np.array([0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3], np.int32)
    builder.add_shape_mesh(arm, xform=wp.transform((0, -0.5, 0), wp.quat_identity()), mesh=newton.Mesh(vertices, faces), scale=(1, 0.7, 1.3))
    return builder


@pytest.fixture(scope="module")
def model():
    scene = newton.ModelBuilder()
    heights = np.random.default_rng(0).uniform(0, 0.4, (6, 9))
    field = newton.Heightfield(data=heights, nrow=6, ncol=9, hx=3.0, hy=2.0)
    scene.add_shape_heightfield(heightfield=field, xform=wp.transform((0.2, 0.1, -0.3), wp.quat_identity()))
    scene.replicate(robot(), COUNT)
    scene.add_ground_plane(height=-0.5)
    return scene.finalize(device="cpu")


def moved(model, seed=1):
    state, rng = model.state(), np.random.default_rng(seed)
    body_q = state.body_q.numpy()
    body_q[:, :3] += rng.uniform(-0.3, 0.3, (len(body_q), 3))
    body_q[:, 3:] += rng.uniform(-0.5, 0.5, (len(body_q), 4))
    body_q[:, 3:] /= np.linalg.norm(body_q[:, 3:], axis=1, keepdims=True)
    state.body_q.assign(body_q)
    return state


def traced(model, state, pose, camera):
    """The z-depth of Newton's tiled camera, which looks along -z with y up."""
    sensor = newton.sensors.SensorTiledCamera(model)
    fov = 2 * np.arctan(0.5 * SIZE[1] / camera.K[1, 1])
    rays = sensor.utils.compute_camera_rays_pinhole(*SIZE, camera_fovs=float(fov))
    axes = np.asarray(pose)[:3, :3] * (1, -1, -1)
    quaternion = wp.quat_from_matrix(wp.mat33(*axes.ravel().tolist()))
    places = wp.array([[wp.transform(np.asarray(pose)[:3, 3].tolist(), quaternion)] * model.world_count], dtype=wp.transformf, device="cpu")
    depth = sensor.utils.create_forward_depth_image_output(*SIZE)
    model.bvh_refit_shapes(state)
    sensor.update(state, places, rays, forward_depth_image=depth)
    found = depth.numpy()[:, 0]
    return np.where(found <= 0, np.inf, found)


def test_worlds_are_newtons(model):
    camera = oaktwin.Camera(SIZE, hfov_deg=70)
    worlds = oaktwin.newton.Worlds(model)
    assert len(worlds) == COUNT and worlds.shapes.shape == (COUNT, 7)
    state = moved(model)
    worlds.update(state)
    for eye in ((2.5, 0.5, 2.0), (-1.5, -1.5, 2.5)):
        pose = oaktwin.look_at(eye, (0, 0, 0.4))
        exact, ours = traced(model, state, pose, camera), worlds.render(camera, pose)
        both = np.isfinite(exact) & np.isfinite(ours)
        assert both.mean() > 0.5 and np.mean(np.isfinite(exact) == np.isfinite(ours)) > 0.99
        # Round shapes are polyhedra, and pixels at outlines see one surface or the other.
        errors = np.abs(exact - ours)[both]
        assert np.median(errors) < 1e-4 and np.mean(errors < 0.01) > 0.97, np.mean(errors < 0.01)
    assert not np.array_equal(ours[0], ours[1])
    # Some worlds alone.
    again = moved(model, seed=2)
    worlds.update(again, worlds=[False, True, False])
    some = worlds.render(camera, pose)
    assert np.array_equal(some[[0, 2]], ours[[0, 2]]) and not np.array_equal(some[1], ours[1])
    worlds.update(again.body_q.numpy(), worlds=[0, 2])
    other = oaktwin.newton.Worlds(model)
    other.update(again)
    assert np.array_equal(worlds.render(camera, pose), other.render(camera, pose))


def test_what_is_wrong(model):
    worlds = oaktwin.newton.Worlds(model)
    with pytest.raises(oaktwin.Error, match=r"state: body_q has shape \(2, 7\); pass \(6, 7\), with the bodies of all worlds"):
        worlds.update(np.zeros((2, 7)))
    with pytest.raises(oaktwin.Error, match="state: body_q has values that are not finite"):
        worlds.update(np.full((6, 7), np.nan))
    with pytest.raises(oaktwin.Error, match="model: it has no visible shapes"):
        oaktwin.newton.Worlds(newton.ModelBuilder().finalize(device="cpu"))
    mixed = newton.ModelBuilder()
    mixed.add_world(robot())
    other = newton.ModelBuilder()
    other.add_shape_box(other.add_body(), hx=0.1, hy=0.1, hz=0.1)
    mixed.add_world(other)
    with pytest.raises(oaktwin.Error, match="model: world 1 has other shapes than world 0; make a model of each kind of world"):
        oaktwin.newton.Worlds(mixed.finalize(device="cpu"))
