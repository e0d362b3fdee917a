"""Networks of the user's on a virtual device, which the tests make themselves."""

import numpy as np
import pytest

dai = pytest.importorskip("depthai")
onnx = pytest.importorskip("onnx")
pytest.importorskip("onnxruntime")

import oaktwin  # noqa: E402
from oaktwin.depthai import virtual_device  # noqa: E402
from virtual_scene import MODEL, WALL_M, first, textured_scene  # noqa: E402

CAM_A, CAM_B, CAM_C = (getattr(dai.CameraBoardSocket, f"CAM_{letter}") for letter in "ABC")
Type = dai.ImgFrame.Type
SIZE = (96, 64)


def network(path, inputs, nodes, outputs, constants=(), names=None):
    """Writes a network of float32 tensors. inputs, outputs: (name, shape)."""
    from onnx import TensorProto, helper, numpy_helper

    def ports(listed):
        return [helper.make_tensor_value_info(name, TensorProto.FLOAT, shape) for name, shape in listed]

    graph = helper.make_graph(
        [helper.make_node(kind, taken, made, **settings) for kind, taken, made, settings in nodes],
        "test", ports(inputs), ports(outputs), [numpy_helper.from_array(value, name) for name, value in constants],
    )  # fmt: skip
    model = helper.make_model(graph, opset_imports=[helper.make_opsetid("", 13)], ir_version=8)
    if names is not None:
        helper.set_model_props(model, {"names": str(dict(enumerate(names)))})
    onnx.save(model, str(path))
    return path


@pytest.fixture
def means(tmp_path):
    """The mean of each colour of an image."""
    taken = [("images", [1, 3, SIZE[1], SIZE[0]])]
    return network(tmp_path / "means.onnx", taken, [("ReduceMean", ["images"], ["means"], {"axes": [2, 3]})], [("means", [1, 3, 1, 1])])


@pytest.fixture
def detections(tmp_path):
    """Two detections, the second of which is unlikely; the first one's right edge is the mean of the image, px."""
    taken = [("images", [1, 3, SIZE[1], SIZE[0]])]
    rows = np.array([[[24, 16, 0, 48, 0.9, 1], [0, 0, 5, 5, 0.2, 0]]], np.float32)
    pick = np.zeros((1, 2, 6), np.float32)
    pick[0, 0, 2] = 1
    nodes = [
        ("ReduceMean", ["images"], ["mean"], {"axes": [1, 2, 3], "keepdims": 0}),
        ("Mul", ["mean", "pick"], ["edge"], {}),
        ("Add", ["edge", "rows"], ["out"], {}),
    ]
    return network(tmp_path / "detector.onnx", taken, nodes, [("out", [1, 2, 6])], [("rows", rows), ("pick", pick)], ["box", "cup"])


@pytest.fixture
def constant_disparity(tmp_path):
    """A disparity of 12 px everywhere, whatever the images."""
    shape = [1, 1, 100, 160]
    nodes = [
        ("Sub", ["left", "left"], ["nothing"], {}),
        ("Mul", ["right", "zero"], ["none"], {}),
        ("Add", ["nothing", "none"], ["empty"], {}),
        ("Add", ["empty", "twelve"], ["disparity"], {}),
    ]
    constants = [("zero", np.zeros(1, np.float32)), ("twelve", np.full(1, 12, np.float32))]
    return network(tmp_path / "stereo.onnx", [("left", shape), ("right", shape)], nodes, [("disparity", shape)], constants)


@pytest.fixture
def plug():
    def make(**networks):
        return virtual_device(MODEL, scene=textured_scene(), fast=True, networks=networks)

    return make


def test_a_network_gets_the_images_of_a_camera(plug, means):
    with plug(means=means), dai.Pipeline() as pipeline:
        camera = pipeline.create(dai.node.Camera).build(CAM_A)
        node = pipeline.create(dai.node.NeuralNetwork).build(camera, dai.NNModelDescription("means"))
        queues = node.out.createOutputQueue(), node.passthrough.createOutputQueue()
        pipeline.start()
        data, image = (first(queue, 2) for queue in queues)
    pixels = image.getCvFrame()
    assert pixels.shape == (SIZE[1], SIZE[0], 3) and data.getSequenceNum() == image.getSequenceNum()
    assert data.getTensor("means").ravel() == pytest.approx(pixels.reshape(-1, 3).mean(axis=0), rel=1e-4)


def test_a_network_by_the_name_of_its_node(plug, means):
    with plug(NeuralNetwork=means), dai.Pipeline() as pipeline:
        output = pipeline.create(dai.node.Camera).build(CAM_B).requestOutput(SIZE)
        node = pipeline.create(dai.node.NeuralNetwork)
        output.link(node.input)
        queues = node.out.createOutputQueue(), output.createOutputQueue()
        pipeline.start()
        data, image = (first(queue) for queue in queues)
    # A grey image has the same value in each channel.
    assert data.getFirstTensor().ravel() == pytest.approx([image.getCvFrame().mean()] * 3, rel=1e-4)


def test_detections(plug, detections):
    with plug(detector=detections), dai.Pipeline() as pipeline:
        camera = pipeline.create(dai.node.Camera).build(CAM_A)
        node = pipeline.create(dai.node.DetectionNetwork).build(camera, "detector")
        queues = node.out.createOutputQueue(), node.passthrough.createOutputQueue()
        pipeline.start()
        found, image = (first(queue) for queue in queues)
        assert node.getClasses() == ["box", "cup"]
    [one] = found.detections
    assert (one.label, one.labelName, one.confidence) == (1, "cup", pytest.approx(0.9))
    right = min(image.getCvFrame().mean() / SIZE[0], 1)
    assert (one.xmin, one.ymin, one.xmax, one.ymax) == pytest.approx((24 / 96, 16 / 64, right, 48 / 64), abs=1e-4)


def test_neural_depth(plug, constant_disparity):
    with plug(NeuralDepth=constant_disparity), dai.Pipeline() as pipeline:
        left, right = (pipeline.create(dai.node.Camera).build(socket).requestOutput((320, 200)) for socket in (CAM_B, CAM_C))
        node = pipeline.create(dai.node.NeuralDepth).build(left, right, dai.DeviceModelZoo.NEURAL_DEPTH_LARGE)
        queues = node.depth.createOutputQueue(), node.disparity.createOutputQueue()
        handler = pipeline.getDefaultDevice().readCalibration()
        pipeline.start()
        depth, disparity = (first(queue) for queue in queues)
    # 12 px at 160 px are 24 px at 320 px.
    expected = handler.getCameraIntrinsics(CAM_C, 320, 200)[0][0] * 10 * handler.getBaselineDistance() / 24
    assert np.median(depth.getFrame()) == pytest.approx(expected, abs=1) and expected < 1000 * WALL_M
    assert np.median(disparity.getFrame()) == 8 * 24


def build_unknown(pipeline):
    pipeline.create(dai.node.NeuralNetwork).build(pipeline.create(dai.node.Camera).build(CAM_A), "yolo")


def link_a_wrong_size(pipeline):
    node = pipeline.create(dai.node.NeuralNetwork)
    node.setModelFromDeviceZoo("means")
    pipeline.create(dai.node.Camera).build(CAM_A).requestOutput((80, 50)).link(node.input)
    queue = node.out.createOutputQueue()
    pipeline.start()
    queue.get()


def detect_with_another_output(pipeline):
    camera = pipeline.create(dai.node.Camera).build(CAM_A)
    queue = pipeline.create(dai.node.DetectionNetwork).build(camera, "means").out.createOutputQueue()
    pipeline.start()
    queue.get()


@pytest.mark.parametrize(
    ("program", "message"),
    [
        (build_unknown, r"pass --network yolo=FILE.onnx or --network NeuralNetwork=FILE.onnx \(given: means\)"),
        (link_a_wrong_size, "the network takes images of 96x64, not 80x50"),
        (detect_with_another_output, r"its first output has the shape \(1, 3, 1, 1\)"),
    ],
)
def test_what_does_not_fit(plug, means, program, message):
    with pytest.raises(oaktwin.Error, match=message), plug(means=means), dai.Pipeline() as pipeline:
        program(pipeline)


def test_files_that_are_no_networks(plug, tmp_path):
    with pytest.raises(oaktwin.Error, match="missing.onnx: networks: this file does not exist"), plug(one=tmp_path / "missing.onnx"):
        pass
    text = tmp_path / "text.onnx"
    text.write_text("no network")
    with pytest.raises(oaktwin.Error, match="text.onnx: NeuralNetwork: ONNX Runtime cannot open it"), plug(text=text), dai.Pipeline() as pipeline:
        pipeline.create(dai.node.NeuralNetwork).build(pipeline.create(dai.node.Camera).build(CAM_A), "text")
