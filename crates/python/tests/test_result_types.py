"""What the stubs say of results is what they are at run time."""

import sys
import types
import typing
from pathlib import Path

import numpy as np
import pytest

import oaktwin

STUB = Path(oaktwin.__file__).with_name("_types.pyi")


@pytest.fixture(scope="module")
def stub():
    """The names of the stub of types."""
    text = STUB.read_text("utf-8").replace("from ._", "from oaktwin._")
    text = "from __future__ import annotations\n" + text
    module = types.ModuleType("oaktwin_types")
    sys.modules[module.__name__] = module
    exec(compile(text, str(STUB), "exec"), module.__dict__)
    return module


def dtypes(kind):
    """The dtypes of an annotation of arrays."""
    for one in typing.get_args(kind) if isinstance(kind, types.UnionType) else [kind]:
        if typing.get_origin(one) is np.ndarray:
            yield np.dtype(typing.get_args(typing.get_args(one)[1])[0])


def compare(stub, name, result, keys=None):
    """Compares a result with its TypedDict; it has some of its keys only if these are given."""
    declared = typing.get_type_hints(getattr(stub, name))
    assert result.keys() == (declared.keys() if keys is None else keys)
    for key, value in result.items():
        kind = declared[key]
        if isinstance(value, np.ndarray):
            allowed = list(dtypes(kind))
            assert value.dtype in allowed or (value.dtype.names and np.dtype(np.void) in allowed), (key, value.dtype, kind)
        else:
            assert isinstance(value, typing.get_origin(kind) or kind), (key, value, kind)


def test_results_are_as_declared(stub, device, room):
    depth, rgb = room
    scene = oaktwin.Scene.from_triangles([[2, -9, -9], [2, 9, -9], [2, 0, 9]], [[0, 1, 2]], label="wall")
    pair = scene.render_pair(device, np.eye(4), size=(128, 80))
    compare(stub, "_Pair", pair)
    compare(stub, "_Matched", oaktwin.StereoMatcher(device)(pair["left"], pair["right"]))
    compare(stub, "_Inertial", oaktwin.simulate_imu(device, [0, 1], np.stack([np.eye(4)] * 2)))


def test_annotators_are_as_declared(stub, device, room):
    depth, rgb = room
    scene = oaktwin.Scene.from_triangles([[2, -9, -9], [2, 9, -9], [2, 0, 9]], [[0, 1, 2]], label="wall")
    of_scene, of_sensor = (typing.get_args(getattr(stub, name)) for name in ["_SceneAnnotator", "_SensorAnnotator"])
    assert {*of_scene, *of_sensor, "camera_params"} == set(oaktwin.annotators())
    camera = oaktwin.Camera(16, 12, hfov_deg=60)
    compare(stub, "_Rendered", scene.render(camera, scene.look_at((0, 0, 0), (1, 0, 0)), annotators=of_scene))
    sensor = oaktwin.DepthSensor(device, engine="single-view")
    seen = sensor.annotate(depth, rgb, annotators=of_sensor)
    compare(stub, "_Annotated", seen)
    names = seen["depth_sensor_reason_names"]
    assert set(np.unique(seen["depth_sensor_reason"])) - {0} <= names.keys() and all(isinstance(name, str) for name in names.values())
    # Every engine has what it says it has.
    for name in of_sensor:
        compare(stub, "_Annotated", sensor.annotate(depth, rgb, annotators=[name]), {
            name, *(["depth_sensor_reason_names"] if name == "depth_sensor_reason" else [])
        })


def test_engines_are_those_of_depth(stub, device):
    for engine in typing.get_args(stub._DepthEngine):
        model = oaktwin.Device("OAK-D ToF") if engine == "time-of-flight" else device
        assert oaktwin.DepthSensor(model, engine=engine).engine == engine
    assert set(typing.get_args(stub._Engine)) - set(typing.get_args(stub._DepthEngine)) == {"stereo-matching"}


def test_seeds_may_be_arrays(device):
    sensor = oaktwin.DepthSensor(device)
    batch = np.full((2, 60, 106), 2.0, np.float32)
    for kind in [np.int64, np.uint32]:
        seeds = np.array([3, 4], kind)
        assert np.array_equal(sensor(batch, frame=0, seed=seeds), sensor(batch, frame=0, seed=[3, 4]))
