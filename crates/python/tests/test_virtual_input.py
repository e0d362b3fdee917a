"""What virtual devices say about programs and arguments that cannot work."""

import sys
from importlib import metadata

import numpy as np
import pytest

dai = pytest.importorskip("depthai")

import oaktwin  # noqa: E402
from oaktwin.depthai import _library, virtual_device  # noqa: E402
from virtual_scene import MODEL, textured_scene  # noqa: E402

CAM_B = dai.CameraBoardSocket.CAM_B


@pytest.fixture
def pipeline():
    with virtual_device(MODEL, scene=textured_scene(), fast=True), dai.Pipeline() as one:
        yield one


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({}, "scene: it is missing"),
        ({"scene": "SCENE", "pose": np.eye(4), "look_at": (0, 0, 0, 1, 0, 0)}, "pass one of them"),
        ({"scene": "SCENE", "look_at": (0, 0, 1)}, "3 numbers; pass six"),
        ({"scene": "SCENE", "pose": np.eye(3)}, r"its shape is \(3, 3\)"),
        ({"scene": "SCENE", "pose": 2 * np.eye(4)}, "is not a rotation"),
        ({"scene": "SCENE", "pose": ([0.0, 0.0], [np.eye(4)] * 2)}, "do not increase"),
        ({"scene": "SCENE", "engine": "magic"}, "engine: 'magic' is unknown"),
    ],
)
def test_arguments(arguments, message):
    if "scene" in arguments:
        arguments = {**arguments, "scene": textured_scene()}
    names = dai.Device, dai.Pipeline
    with pytest.raises(oaktwin.Error, match=message), virtual_device(MODEL, **arguments):
        pass
    assert names == (dai.Device, dai.Pipeline)


def test_a_missing_scene_and_an_unknown_model():
    with pytest.raises(FileNotFoundError), virtual_device(MODEL, scene="no.usd"):
        pass
    with pytest.raises(oaktwin.Error, match="OAK-D Pro"), virtual_device("OAK-D Por", scene=textured_scene()):
        pass


@pytest.mark.parametrize(
    ("pose", "message"), [(lambda _: 1 / 0, "the function raised ZeroDivisionError"), (lambda _: np.full((4, 4), np.nan), "not finite")]
)
def test_a_pose_that_fails_ends_the_program_with_its_reason(pose, message, capfd):
    with pytest.raises(oaktwin.Error, match=message):
        with virtual_device(MODEL, scene=textured_scene(), pose=pose, fast=True), dai.Pipeline() as pipeline:
            queue = pipeline.create(dai.node.Camera).build(CAM_B).requestOutput((80, 50)).createOutputQueue()
            pipeline.start()
            queue.get()
    assert "oaktwin: Camera: pose: " in capfd.readouterr().err


def test_a_host_node_that_raises_ends_the_program_with_its_exception(capfd):
    class Broken(dai.node.HostNode):
        def build(self, source):
            self.link_args(source)
            return self

        def process(self, frame):
            raise ValueError("out of order")

    with pytest.raises(ValueError, match="out of order"):
        with virtual_device(MODEL, scene=textured_scene(), fast=True), dai.Pipeline() as pipeline:
            pipeline.create(Broken).build(pipeline.create(dai.node.Camera).build(CAM_B).requestOutput((80, 50)))
            pipeline.run()
    assert "oaktwin: Broken: the node raised an exception" in capfd.readouterr().err


def test_a_socket_that_the_model_lacks(pipeline):
    with pytest.raises(RuntimeError, match="Camera socket not found on the connected device: CAM_D"):
        pipeline.create(dai.node.Camera).build(dai.CameraBoardSocket.CAM_D)


def test_sizes_and_types_that_a_camera_does_not_send(pipeline):
    camera = pipeline.create(dai.node.Camera)
    with pytest.raises(RuntimeError, match="must be built"):
        camera.requestOutput((80, 50))
    camera.build(CAM_B)
    with pytest.raises(RuntimeError, match="has no pixels"):
        camera.requestOutput((0, 50))
    with pytest.raises(RuntimeError, match="even sizes"):
        camera.requestOutput((81, 50), dai.ImgFrame.Type.NV12)
    with pytest.raises(RuntimeError, match="RAW32"):
        camera.requestOutput((80, 50), dai.ImgFrame.Type.RAW32)
    with pytest.raises(RuntimeError, match="already built"):
        camera.build(CAM_B)


@pytest.mark.parametrize("name", ["NeuralNetwork", "DetectionNetwork", "NeuralDepth", "Thermal", "UVC", "SPIOut", "SystemLogger", "BasaltVIO", "RTABMapVIO", "DynamicCalibration", "AutoCalibration"])
def test_nodes_that_cannot_be_simulated(pipeline, name):
    with pytest.raises(oaktwin.Error, match=f"{name}: this node cannot be simulated: "):
        pipeline.create(getattr(dai.node, name))


@pytest.mark.parametrize(
    ("model", "name", "message"),
    [("OAK-1", "StereoDepth", "has no stereo pair"), (MODEL, "ToF", "no time-of-flight camera"), ("OAK4-S", "StereoDepth", "stereo pair")],
)
def test_nodes_that_the_model_lacks(model, name, message):
    with virtual_device(model, scene=textured_scene()), dai.Pipeline() as pipeline, pytest.raises(oaktwin.Error, match=message):
        pipeline.create(getattr(dai.node, name))


@pytest.mark.parametrize("model", ["OAK-1", "OAK4-S"])
def test_a_model_without_a_pair_has_a_calibration(model):
    with virtual_device(model, scene=textured_scene()), dai.Device() as device:
        assert device.readCalibration().getCameraIntrinsics(dai.CameraBoardSocket.CAM_A, 640, 480)[0][0] > 0


def test_images_for_stereo_that_the_calibration_does_not_describe():
    with pytest.raises(oaktwin.Error, match="with the resize mode CROP"):
        with virtual_device(MODEL, scene=textured_scene(), fast=True), dai.Pipeline() as pipeline:
            node = pipeline.create(dai.node.StereoDepth)
            for socket, port in ((dai.CameraBoardSocket.CAM_B, node.left), (dai.CameraBoardSocket.CAM_C, node.right)):
                camera = pipeline.create(dai.node.Camera).build(socket)
                camera.requestOutput((160, 160), resizeMode=dai.ImgResizeMode.LETTERBOX).link(port)
            queue = node.depth.createOutputQueue()
            pipeline.start()
            queue.get()


def test_unsupported_controls_warn_once(pipeline):
    _library.forget_warnings()
    camera = pipeline.create(dai.node.Camera).build(CAM_B)
    camera.initialControl.setManualFocus(100)
    queue = camera.requestOutput((80, 50)).createOutputQueue()
    with pytest.warns(oaktwin.FindingWarning, match="the control of focus is not simulated"):
        pipeline.start()
        queue.get()


def test_sensors_of_the_imu_that_are_not_simulated(pipeline):
    with pytest.raises(oaktwin.Error, match="MAGNETOMETER_RAW is not simulated"):
        pipeline.create(dai.node.IMU).enableIMUSensor(dai.IMUSensor.MAGNETOMETER_RAW, 100)


def test_a_device_in_use(pipeline):
    with pytest.raises(RuntimeError, match="in use already"):
        dai.Device()
    with pytest.raises(RuntimeError, match="Cannot find any device"):
        dai.Device(dai.DeviceInfo("1844301041"))
    device = pipeline.getDefaultDevice()
    with pytest.raises(oaktwin.Error, match="no memory to write to"):
        device.flashCalibration(device.readCalibration())
    with pytest.raises(oaktwin.Error, match="crashDevice: this function is not simulated"):
        device.crashDevice()
    with pytest.raises(AttributeError):
        device.noSuchThing()


@pytest.mark.parametrize(("found", "message"), [(None, "it is not installed"), ("2.30.0", "version 2.30.0 is installed"), ("3.13.0", "3.12")])
def test_the_version_of_depthai(monkeypatch, found, message):
    def version(_):
        if found is None:
            raise metadata.PackageNotFoundError("depthai")
        return found

    monkeypatch.setattr(_library, "version", version)
    with pytest.raises(oaktwin.Error, match=message):
        _library.check_version()


def test_a_host_pipeline_needs_no_device():
    with virtual_device(MODEL, scene=textured_scene()):
        pipeline = dai.Pipeline(createImplicitDevice=False)
        pipeline.create(dai.node.ImageManip)
        with pytest.raises(RuntimeError, match="host only"):
            pipeline.create(dai.node.Camera)
    assert "oaktwin" not in dai.Pipeline.__module__ and sys.modules["depthai"] is dai
