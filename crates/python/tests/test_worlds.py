"""Many worlds at once."""

import multiprocessing
import os

import numpy as np
import pytest

import oaktwin
from conftest import PATIENCE_S

COUNT = 6


def box(size):
    corners = np.array([(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]) * size / 2
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return oaktwin.Mesh(corners, np.array([face for a, b, c, d in quads for face in ((a, b, c), (a, c, d))]))


@pytest.fixture
def scene():
    floor = oaktwin.Mesh([(-9, -9, 0), (9, -9, 0), (9, 9, 0), (-9, 9, 0)], [(0, 1, 2), (0, 2, 3)])
    return oaktwin.Scene.from_meshes({"floor": floor, "base": box(0.5), "arm/link": box(0.3)})


@pytest.fixture
def camera():
    return oaktwin.Device("OAK4-D").cameras["left"].resized(64, 40)


def poses(seed, *shape):
    rng = np.random.default_rng(seed)
    result = np.zeros((*shape, 4, 4))
    angles = rng.uniform(-3, 3, shape)
    result[..., 0, 0] = result[..., 1, 1] = np.cos(angles)
    result[..., 1, 0], result[..., 0, 1] = np.sin(angles), -np.sin(angles)
    result[..., 2, 2] = result[..., 3, 3] = 1
    result[..., :3, 3] = rng.uniform(-0.5, 0.5, (*shape, 3)) + (0, 0, 0.5)
    return result


@pytest.mark.parametrize("backend", ["raster", "ray"])
def test_worlds_are_scenes_of_their_own(scene, camera, backend):
    """To the byte."""
    worlds = oaktwin.Worlds(scene, COUNT)
    assert len(worlds) == COUNT
    names, own = ["base", "arm/link"], poses(1, COUNT, 2)
    worlds.set_poses(names, own)
    views = np.stack([oaktwin.look_at((2, 0.2 * number, 1.5), (0, 0, 0.4)) for number in range(COUNT)])
    depth = worlds.render(camera, views, backend=backend)
    assert depth.shape == (COUNT, 40, 64) and depth.dtype == np.float32
    for number in range(COUNT):
        scene.set_poses(dict(zip(names, own[number])))
        alone = scene.render(camera, views[number], backend=backend)["distance_to_image_plane"]
        assert np.array_equal(depth[number], alone)
    # Some of the worlds, one pose for all, and an array to write.
    worlds.set_poses(["base"], poses(2, 2, 1), worlds=[4, 1])
    room = np.empty((2, 40, 64), np.float32)
    some = worlds.render(camera, views[[1, 3]], worlds=[1, 3], backend=backend, out=room)
    assert some is room and np.array_equal(some[1], depth[3]) and not np.array_equal(some[0], depth[1])
    odd = worlds.render(camera, views[1::2], worlds=np.arange(COUNT) % 2 == 1, backend=backend)
    assert np.array_equal(odd[:2], some) and odd.shape[0] == COUNT // 2
    one = worlds.render(camera, views[0], backend=backend)
    assert np.array_equal(one[0], depth[0])
    worlds.set_poses(names, poses(3, 2))
    same = worlds.render(camera, views[0], backend=backend)
    assert all(np.array_equal(same[0], image) for image in same)


def test_noise_of_many_worlds(scene, camera):
    """What a sensor measures of them is one call, too."""
    device = oaktwin.Device("OAK4-D")
    worlds = oaktwin.Worlds(scene, COUNT)
    depth = worlds.render(camera, oaktwin.look_at((2, 0, 1.5), (0, 0, 0.4)))
    measured = oaktwin.DepthSensor(device, fx=camera.K[0, 0])(depth)
    assert measured.shape == depth.shape and not np.array_equal(measured[0], measured[1])


def test_what_is_wrong(scene, camera):
    worlds = oaktwin.Worlds(scene, 3)
    view = oaktwin.look_at((2, 0, 1.5), (0, 0, 0.4))
    before = worlds.render(camera, view)
    flat, broken = np.tile(np.eye(4), (3, 1, 1, 1)), np.tile(np.eye(4), (3, 1, 1, 1))
    flat[1, 0, 0, 0], broken[2, 0, 0, 3] = 0, np.nan
    for call, expected in [
        (lambda: worlds.set_poses(["bas"], np.eye(4)[None]), "bas: the scene has no such part; did you mean 'base'"),
        (lambda: worlds.set_poses(["base"], np.eye(4)), r"poses: has shape \[4, 4\], but there are 3 worlds and 1 names; pass \(3, 1, 4, 4\)"),
        (lambda: worlds.set_poses(["base"], np.tile(np.eye(4), (2, 1, 1, 1))), r"pass \(3, 1, 4, 4\)"),
        (lambda: worlds.set_poses(["base"], flat), r"poses\[1, 0\]: the 3x3 part is not a rotation"),
        (lambda: worlds.set_poses(["base"], broken), r"poses\[2, 0\]: has non-finite values"),
        (lambda: worlds.set_poses(["base"], broken[2]), r"poses\[0\]: has non-finite values"),
        (lambda: worlds.set_poses(["base"], np.eye(4)[None], worlds=[3]), "there is no world 3; they are numbered from 0 to 2"),
        (lambda: worlds.render(camera, np.stack([view] * 2)), "has 2 poses, but there are 3 worlds"),
        (lambda: worlds.render(camera, view, backend="rays"), "did you mean 'ray'"),
        (lambda: worlds.render(camera, view, out=np.empty((2, 40, 64), np.float32)), "out: has shape"),
        (lambda: worlds.render(camera, oaktwin.BodyPose(np.eye(4))), "not of a camera"),
        (lambda: oaktwin.Worlds(scene, 2**40), "count"),
    ]:
        with pytest.raises(oaktwin.Error, match=expected):
            call()
    with pytest.raises(TypeError, match="out: unsupported dtype"):
        worlds.render(camera, view, out=np.empty((3, 40, 64)))
    assert np.array_equal(worlds.render(camera, view), before), "nothing moves after an error"
    none = oaktwin.Worlds(scene, 0)
    none.set_poses(["base"], np.eye(4)[None])
    assert none.render(camera, view).shape == (0, 40, 64)


@pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork here")
@pytest.mark.filterwarnings("ignore:.*fork.*:DeprecationWarning", "ignore:.*fork.*:RuntimeWarning")
def test_a_forked_process_renders_the_same(scene, camera):
    worlds = oaktwin.Worlds(scene, COUNT)
    view = oaktwin.look_at((2, 0, 1.5), (0, 0, 0.4))
    before = worlds.render(camera, view)
    context = multiprocessing.get_context("fork")
    answers = context.Queue()
    child = context.Process(target=lambda: answers.put(worlds.render(camera, view).tobytes()))
    child.start()
    try:
        assert answers.get(timeout=PATIENCE_S) == before.tobytes()
    finally:
        child.kill()
