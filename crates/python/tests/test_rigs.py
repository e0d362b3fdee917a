"""Rigs: all cameras of a device at once, as the program renders them."""

import json
import pickle
import subprocess
import sys

import numpy as np
import pytest

import oaktwin
from conftest import PATIENCE_S, ROOT

STAGE = ROOT / "examples/depth_sensor/depth_sensor.usda"
SIZE = (320, 200)
OUTPUTS = ["rgb", "distance_to_image_plane", "depth_sensor_distance", "depth_sensor_reason"]


@pytest.fixture(scope="module")
def scene():
    return oaktwin.Scene.open(STAGE, micro_texture=True)


@pytest.fixture(scope="module")
def pose(scene, device):
    return scene.look_at((3, 0, 0.6), (0, 0, 0.5), device)


@pytest.mark.parametrize("engine", [None, "stereo-matching"])
def test_shots_are_those_of_the_program(program, tmp_path, scene, engine):
    """To the byte: the exact depth and the measured one of each camera."""
    device = oaktwin.Device("OAK-D Pro PoE")
    rig = oaktwin.Rig(
        device, cameras=["rgb", "depth"], size=SIZE, annotators=OUTPUTS, engine=engine, seed=5, pair={"projector": 0.5, "ambient": 0.4}
    )
    shots = rig.shoot(scene, scene.look_at((3, 0, 0.6), (0, 0, 0.5), device), frame=0)
    options = ["--engine", engine] if engine else []
    program(
        *("render", str(STAGE), "--model", "OAK-D Pro PoE", "--camera", "rgb", "--camera", "depth", "--resolution", "320x200"),
        *("--look-at", "3", "0", "0.6", "0", "0", "0.5", "--projector", "0.5", "--ambient", "0.4", "--seed", "5", "--micro-texture"),
        *("--annotators", ",".join(OUTPUTS), "-o", str(tmp_path / "out"), *options),
    )
    assert list(shots) == list(rig.cameras) == ["rgb", "stereo_depth"]
    for (name, shot), folder in zip(shots.items(), ["Camera_rgb", "Camera_pseudo_depth"], strict=True):
        for output in OUTPUTS[1:3]:
            files = sorted((tmp_path / "out").rglob(f"{output}/{output}_*.npy"))
            files = [file for file in files if any(part.startswith(folder) for part in file.parts)]
            assert bool(files) == (output in shot), (name, output)
            for file in files:
                assert np.array_equal(np.load(file), shot[output]), file


def test_a_rig_measures_as_its_sensor(device, scene, pose):
    rig = oaktwin.Rig(device, filters=["speckle"], seed=3)
    (name,) = rig.cameras
    (shot,) = rig.shoot(scene, pose, frame=4).values()
    sensor = oaktwin.DepthSensor(device, filters=["speckle"], seed=3)
    expected = sensor.shoot(scene, pose, frame=4)
    assert set(shot) == set(expected)
    assert all(np.array_equal(shot[layer], expected[layer]) for layer in shot if layer != "depth_sensor_reason_names")
    measured = rig.measure(shot.exact_depth, shot.rgb, frame=4)
    assert np.array_equal(measured["depth_sensor_distance"], shot.depth)
    assert rig.cameras[name].size == shot.image_camera.size
    assert shot.camera == expected.camera and shot.seed == rig.seed == 3


def test_numbers_and_pickles(device, scene, pose):
    rig = oaktwin.Rig(device, size=SIZE, pair={"imager": {"readNoise": np.float32(4)}}, parameters={"window": 7})
    first, second = (next(iter(rig.shoot(scene, pose).values())) for _ in range(2))
    assert (first.frame, second.frame) == (0, 1) and not np.array_equal(first.depth, second.depth)
    other = pickle.loads(pickle.dumps(rig))
    assert other.spec == rig.spec
    third, again = (next(iter(one.shoot(scene, pose).values())) for one in (other, rig))
    assert third.frame == 2 and np.array_equal(third.depth, again.depth)


def test_the_specification_is_text(device):
    rig = oaktwin.Rig(device, cameras=["left"], annotators=["normals"], pair={"imager": {"readNoise": 4}}, parameters={"window": 7})
    spec = json.loads(json.dumps(rig.spec))
    assert spec["cameras"] == ["left"] and spec["annotators"] == ["normals"]
    assert spec["pair"]["imager"]["readNoise"] == 4 and spec["sensor"]["parameters"] == {"window": 7}


def test_colours_are_recorded(device, scene, pose):
    exact, *recorded = [
        next(iter(oaktwin.Rig(device, cameras=["rgb"], size=SIZE, rgb_imager=imager).shoot(scene, pose).values()))
        for imager in (False, True, {"readNoise": 40.0, "autoExposure": False})
    ]
    assert np.array_equal(exact["rgb"][..., 3], recorded[0]["rgb"][..., 3])
    assert not any(np.array_equal(exact["rgb"], other["rgb"]) for other in recorded)
    rig = oaktwin.Rig(device, cameras=["rgb"], size=SIZE, rgb_imager={"redGain": 2.5})
    other = pickle.loads(pickle.dumps(rig))
    assert other.spec == rig.spec and rig.spec["rgb_imager"]["redGain"] == 2.5
    one, two = (next(iter(each.shoot(scene, pose, frame=3).values())) for each in (rig, other))
    assert np.array_equal(one["rgb"], two["rgb"])


def test_cameras_without_a_sensor(device, scene, pose):
    rig = oaktwin.Rig(device, cameras=["rgb"], size=SIZE)
    (shot,) = rig.shoot(scene, pose).values()
    assert set(shot) == {"rgb", "distance_to_image_plane"} and "320x200, frame 0" in repr(shot)
    with pytest.raises(AttributeError, match="has no depth"):
        _ = shot.depth
    with pytest.raises(oaktwin.Error, match="no depth sensor"):
        rig.measure(shot.exact_depth)
    assert "measured" not in shot._repr_html_()


def test_an_engine_in_python(device, scene, pose):
    (shot,) = oaktwin.Rig(device, size=SIZE, engine=lambda depth: depth * 2).shoot(scene, pose).values()
    seen = np.isfinite(shot.exact_depth)
    assert np.allclose(shot.depth[seen], 2 * shot.exact_depth[seen])


def test_an_engine_may_ask_its_rig():
    """Also from another thread, and for a new sequence. In a process of its own, because threads that wait for each other stop all."""
    script = """
import threading, numpy, oaktwin
def engine(depth):
    thread = threading.Thread(target=lambda: print(list(rig.cameras), repr(rig), rig.reset()))
    thread.start()
    thread.join()
    return depth
rig = oaktwin.Rig(oaktwin.Device("OAK4-D"), size=(64, 40), engine=engine)
scene = oaktwin.Scene.from_triangles([[2, -9, -9], [2, 9, -9], [2, 0, 9]], [[0, 1, 2]])
for _ in range(2):
    rig.shoot(scene, numpy.eye(4))
"""
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=PATIENCE_S)
    assert done.stdout == 2 * "['stereo_depth'] <oaktwin.Rig OAK4-D: stereo_depth> None\n", done.stderr


def test_what_is_wrong(device, scene, pose):
    for arguments, expected in [
        ({"cameras": ["lefft"]}, "did you mean 'left'"),
        ({"annotators": ["rgbb"]}, "did you mean 'rgb'"),
        ({"backend": "rays"}, "did you mean 'ray'"),
        ({"pair": {"projektor": 1}}, "pair: unknown field `projektor`"),
        ({"pair": {"imager": {"readNois": 1}}}, "pair: readNois: unknown parameter of imager; did you mean 'readNoise'"),
        ({"rgb_imager": {"readNois": 1}}, "rgb_imager: readNois: unknown parameter of color-imager; did you mean 'readNoise'"),
        ({"pair": {"lens": "fish"}}, "pair: invalid value 'fish'"),
        ({"pair": {"rectify": {"edge_fill": 300}}}, "pair: invalid fill '300'"),
        ({"pair": {"projector": float("nan")}}, "pair: contains NaN"),
        ({"pair": {"projector": 1.0}}, "projector"),
        ({"parameters": {"sigma": 1}}, "sigma: unknown parameter"),
        ({"size": (0, 4)}, "an image of 0x4 has no pixels"),
    ]:
        with pytest.raises(oaktwin.Error, match=expected):
            oaktwin.Rig(device, **arguments)
    with pytest.raises(TypeError, match="unexpected keyword argument 'engin'; did you mean 'engine'"):
        oaktwin.Rig(device, engin="stereo-noise")
    with pytest.raises(TypeError, match="pair: expected a mapping, got float"):
        oaktwin.Rig(device, pair=0.5)
    rig = oaktwin.Rig(device, size=SIZE)
    with pytest.raises(oaktwin.Error, match="world_from_body"):
        rig.shoot(scene, oaktwin.CameraPose(np.eye(4)))
    with pytest.raises(oaktwin.Error, match="an image is 4x3, but the camera is 320x200"):
        rig.measure(np.ones((3, 4), np.float32))
    with pytest.raises(oaktwin.Error, match="depth: is a batch"):
        rig.measure(np.ones((2, 200, 320), np.float32))
