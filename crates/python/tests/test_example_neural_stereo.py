"""A stereo network in an ONNX file, made here, as an engine: a cost volume and the mean of a softmax."""

import subprocess
import sys

import numpy as np
import pytest

import oaktwin
from conftest import ROOT

onnx = pytest.importorskip("onnx")
pytest.importorskip("onnxruntime")
pytest.importorskip("PIL")

FOLDER = ROOT / "examples/python"
SCENE = ROOT / "examples/depth_sensor/depth_sensor.usda"
# The camera of the scene.
VIEW = ["--eye", "3", "0", "0.6", "--target", "0", "0", "0.5"]


def network(path, size=(None, None), disparities=48, channels=1):
    """Writes a network that compares blocks of 5 x 5 pixels and returns the mean disparity of a softmax of their differences."""
    from onnx import TensorProto, helper, numpy_helper

    nodes, constants = [], []

    def constant(name, values):
        constants.append(numpy_helper.from_array(np.asarray(values), name))
        return name

    def node(kind, inputs, output, **attributes):
        nodes.append(helper.make_node(kind, inputs, [output], **attributes))
        return output

    mean = constant("mean", np.full((1, channels, 1, 1), 1 / channels, np.float32))
    left, right = (node("Conv", [side, mean], f"{side}_grey") for side in ("left", "right"))
    costs = []
    for d in range(disparities):
        # The right image, moved to the right by d columns.
        pad = constant(f"pad{d}", np.array([0, 0, 0, d, 0, 0, 0, -d], np.int64))
        moved = node("Pad", [right, pad], f"moved{d}", mode="edge")
        difference = node("Abs", [node("Sub", [left, moved], f"sub{d}")], f"abs{d}")
        costs.append(node("AveragePool", [difference], f"cost{d}", kernel_shape=[5, 5], pads=[2, 2, 2, 2]))
    volume = node("Mul", [node("Concat", costs, "volume", axis=1), constant("sharpness", np.float32(-0.8))], "scores")
    shares = node("Softmax", [volume], "shares", axis=1)
    steps = constant("steps", np.arange(disparities, dtype=np.float32).reshape(1, -1, 1, 1))
    axis = constant("channels", np.array([1], np.int64))
    node("ReduceSum", [node("Mul", [shares, steps], "weighted"), axis], "disparity", keepdims=1)
    image = [1, channels, *(side or name for side, name in zip(size, ("H", "W")))]
    inputs = [helper.make_tensor_value_info(side, TensorProto.FLOAT, image) for side in ("left", "right")]
    output = [helper.make_tensor_value_info("disparity", TensorProto.FLOAT, [1, 1, *image[2:]])]
    graph = helper.make_graph(nodes, "stereo", inputs, output, constants)
    model = helper.make_model(graph, opset_imports=[helper.make_opsetid("", 18)])
    model.ir_version = 9
    onnx.checker.check_model(model)
    onnx.save(model, path)
    return path


def run(*arguments, code=0):
    command = [sys.executable, "neural_stereo.py", *map(str, arguments)]
    done = subprocess.run(command, capture_output=True, text=True, encoding="utf-8", cwd=FOLDER)
    assert done.returncode == code, done.stderr
    return done.stderr if code else done.stdout


@pytest.fixture
def example(monkeypatch):
    monkeypatch.syspath_prepend(str(FOLDER))
    import neural_stereo

    return neural_stereo


def test_the_comparison(tmp_path, example):
    path = network(tmp_path / "softmax.onnx", (200, 320))
    printed = run(path, SCENE, *VIEW, "--distances", 0.8, 2)
    board, room = ([line.split() for line in printed.splitlines() if line.startswith(name)] for name in ("softmax", "stereo-matching"))
    errors = {rows[0][0]: [abs(float(rows[0][1])), abs(float(rows[0][3]))] for rows in (board, room)}
    # The network sees images of a quarter of the width, with whole disparities that a mean makes finer.
    assert 0 < errors["stereo-matching"][0] < 1 and errors["stereo-matching"][0] < errors["softmax"][0] < 5
    density = {rows[1][0]: float(rows[1][1].rstrip("%")) for rows in (board, room)}
    assert density["softmax"] == 100 and density["stereo-matching"] < 95
    # The same numbers by the interface.
    device, scene = oaktwin.Device("OAK4-D"), oaktwin.Scene.open(SCENE, micro_texture=True)
    pose = scene.look_at((3, 0, 0.6), (0, 0, 0.5), device)
    sensor = oaktwin.DepthSensor(device, engine=example.StereoNetwork(path))
    shot = sensor.shoot(scene, pose, frame=0)
    exact = scene.render(shot.camera, shot.world_from_camera)["distance_to_image_plane"]
    _, median_mm, outliers = example.compare(shot.depth, exact)
    assert f"{median_mm:.1f} mm" in printed and f"{outliers:.1%}" in printed
    assert sensor.engine == "softmax"


@pytest.mark.parametrize(("size", "channels"), [((None, None), 1), ((None, None), 3), ((60, 100), 3)])
def test_networks_of_any_size(tmp_path, example, textured, size, channels):
    """Its disparities are those of the images, whether it is resized for them or they for it."""
    left, right, disparity, clear = textured
    engine = example.StereoNetwork(network(tmp_path / "n.onnx", size, channels=channels), multiple=16)
    found = engine(left, right)
    assert found.shape == left.shape and found.dtype == np.float32
    if size == (None, None):
        inner = clear & (np.arange(320) > 60)
        assert np.median(np.abs(found - disparity)[inner]) < 0.5
        wide = oaktwin.StereoMatcher(fx=300, baseline=0.075, engine=engine)(left, right)
        assert np.allclose(wide["disparity"], found, rtol=1e-3, atol=1e-3)


def test_filters_and_figures(tmp_path):
    pytest.importorskip("matplotlib")
    path = network(tmp_path / "softmax.onnx", (50, 80), 16)
    run(path, SCENE, *VIEW, "--distances", 2, "--filters", "median:size=5", "--figure", "-o", tmp_path)
    assert (tmp_path / "neural.png").read_bytes().startswith(b"\x89PNG")


def test_files_that_are_no_network(tmp_path):
    (tmp_path / "text.onnx").write_text("no network")
    assert "text.onnx: cannot be loaded; give an ONNX file" in run(tmp_path / "text.onnx", SCENE, code=1)
    from onnx import TensorProto, helper

    image = helper.make_tensor_value_info("image", TensorProto.FLOAT, [1, 3, 4, 4])
    out = helper.make_tensor_value_info("out", TensorProto.FLOAT, [1, 3, 4, 4])
    graph = helper.make_graph([helper.make_node("Relu", ["image"], ["out"])], "one", [image], [out])
    model = helper.make_model(graph, opset_imports=[helper.make_opsetid("", 18)])
    model.ir_version = 9
    onnx.save(model, tmp_path / "one.onnx")
    assert "its inputs are image [1, 3, 4, 4]; use a network of two images" in run(tmp_path / "one.onnx", SCENE, code=1)
