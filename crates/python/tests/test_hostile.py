"""Arrays that repeat their memory, sizes that no machine has and pickles of others end in an `oaktwin.Error`, never in an abort."""

import pickle

import numpy as np
import pytest

import oaktwin

ROWS = 10**9


@pytest.fixture(autouse=True)
def limit():
    # So that the test does not depend on the machine.
    oaktwin.set_memory_limit("2G")
    yield
    oaktwin.set_memory_limit(None)


def repeated(*shape, dtype=np.float64):
    """An array of any shape with the memory of one number."""
    return np.broadcast_to(np.zeros((), dtype), shape)


def calls(device):
    camera = device.cameras["left"]
    triangle = np.zeros((3, 3)), np.array([[0, 1, 2]])
    scene = oaktwin.Scene.from_triangles(*triangle)
    sensor = oaktwin.DepthSensor(device)
    yield "vertices", lambda: oaktwin.Mesh(repeated(ROWS, 3), triangle[1])
    yield "faces", lambda: oaktwin.Mesh(triangle[0], repeated(ROWS, 3, dtype=np.int64))
    yield "normals", lambda: oaktwin.Mesh(*triangle, normals=repeated(ROWS, 3))
    yield "texture", lambda: oaktwin.Mesh(*triangle, texture=repeated(ROWS, 30, 3, dtype=np.uint8), uvs=np.zeros((3, 2)))
    yield "points", lambda: camera.project(repeated(ROWS, 3))
    yield "images", lambda: camera.unproject(repeated(ROWS, 800, 1280, dtype=np.float32))
    yield "poses", lambda: scene.render(camera, repeated(ROWS, 4, 4))
    yield "times", lambda: oaktwin.simulate_imu(device, repeated(ROWS), repeated(ROWS, 4, 4))
    yield "depth", lambda: sensor(repeated(100_000, 100_000, dtype=np.float32))


def test_repeated_arrays(device):
    for name, call in calls(device):
        with pytest.raises((oaktwin.Error, TypeError)) as raised:
            call()
        assert str(raised.value), name


@pytest.mark.parametrize("count", [2**40, 2**63, 2**64, -1])
def test_counts(device, count):
    scene = oaktwin.Scene.from_triangles(np.array([[-5, -5, 3], [5, -5, 3], [0, 8, 3]]), np.array([[0, 1, 2]]))
    with pytest.raises((oaktwin.Error, OverflowError)):
        oaktwin.coverage(scene, [device], np.eye(4), samples=count)
    with pytest.raises((oaktwin.Error, OverflowError)):
        device.population(count)
    with pytest.raises((oaktwin.Error, OverflowError)):
        oaktwin.accuracy(device, captures=count)


def of_others(item):
    """Pickles in which each argument is replaced by something else."""
    reduced = item.__reduce_ex__(2)
    made, arguments = reduced[:2]
    for at in range(len(arguments)):
        for other in [None, -1, 2**70, "x" * 1000, b"\0", [], {}, (), 1e300, float("nan"), [[]] * 3]:
            changed = tuple(other if at == place else argument for place, argument in enumerate(arguments))
            yield made, changed, *reduced[2:]


class Other:
    """Is pickled as something else."""

    def __init__(self, reduced):
        self.reduced = reduced

    def __reduce__(self):
        return self.reduced


def test_pickles_of_others(device):
    camera = device.cameras["left"]
    scene = oaktwin.Scene.from_triangles(np.zeros((3, 3)), np.array([[0, 1, 2]]))
    for item in [device, camera, oaktwin.DepthSensor(device), scene]:
        for reduced in of_others(item):
            try:
                stored = pickle.dumps(Other(reduced))
            except pickle.PicklingError:
                continue
            try:
                pickle.loads(stored)
            except Exception as error:
                # A panic is no Exception.
                assert str(error)
