"""The calibration that a program sets, colour cameras of stereo pairs, and animated stages."""

import json

import numpy as np
import pytest

dai = pytest.importorskip("depthai")

import oaktwin  # noqa: E402
from oaktwin.depthai import virtual_device  # noqa: E402
from virtual_scene import MODEL, SIZE, WALL_M, first, textured_scene  # noqa: E402

CAM_A, CAM_B, CAM_C = (getattr(dai.CameraBoardSocket, f"CAM_{letter}") for letter in "ABC")


def wider(handler, factor):
    """A calibration with another baseline."""
    content = handler.eepromToJson()
    for camera in content["cameraData"]:
        for key in ("translation", "specTranslation"):
            place = camera[1]["extrinsics"][key]
            place.update({axis: factor * place[axis] for axis in "xyz"})
    return dai.CalibrationHandler.fromJson(content)


def test_stereo_measures_with_the_calibration_that_is_set():
    with virtual_device(MODEL, scene=textured_scene(), fast=True), dai.Pipeline() as pipeline:
        device = pipeline.getDefaultDevice()
        before = device.readCalibration()
        queue = pipeline.create(dai.node.StereoDepth).build(True, size=SIZE).depth.createOutputQueue()
        with pytest.warns(oaktwin.FindingWarning, match="not the images"):
            device.setCalibration(wider(before, 2))
        assert device.readCalibration().getBaselineDistance() == pytest.approx(2 * before.getBaselineDistance(), rel=1e-5)
        pipeline.start()
        depth = first(queue, 2).getFrame()
        # The images are still those of the narrow pair, so that everything seems to be at twice its distance; at run time, too.
        assert np.median(depth[depth > 0]) == pytest.approx(2000 * WALL_M, rel=0.03)
        device.setCalibration(before)
        for _ in range(30):
            depth = queue.get().getFrame()
            if np.median(depth[depth > 0]) < 1500 * WALL_M:
                break
        assert np.median(depth[depth > 0]) == pytest.approx(1000 * WALL_M, rel=0.03)


def test_images_state_the_intrinsics_that_are_set():
    with virtual_device(MODEL, scene=textured_scene(), fast=True), dai.Pipeline() as pipeline:
        handler = pipeline.getDefaultDevice().readCalibration()
        content = handler.eepromToJson()
        matrix = content["cameraData"][1][1]["intrinsicMatrix"]
        matrix[0][0] = matrix[1][1] = 1.1 * matrix[0][0]
        pipeline.setCalibrationData(dai.CalibrationHandler.fromJson(content))
        queue = pipeline.create(dai.node.Camera).build(CAM_B).requestOutput(SIZE).createOutputQueue()
        pipeline.start()
        found = first(queue).getTransformation().getIntrinsicMatrix()[0][0]
    assert found == pytest.approx(1.1 * handler.getCameraIntrinsics(CAM_B, *SIZE)[0][0], rel=1e-4)


@pytest.mark.filterwarnings("ignore:.*not the images")
def test_the_calibration_of_a_unit_is_set_on_a_nominal_device():
    [unit] = oaktwin.Device(MODEL).population(1, seed=3)
    [text] = unit.to_depthai().values()
    handler = dai.CalibrationHandler.fromJson(json.loads(text))
    with virtual_device(MODEL, scene=textured_scene(), fast=True), dai.Device() as device:
        device.setCalibration(handler)
        assert device.readCalibration().getCameraIntrinsics(CAM_B) == handler.getCameraIntrinsics(CAM_B)


def test_a_calibration_of_another_model_is_refused():
    other = oaktwin.Device("OAK-D ToF").to_depthai()
    [text] = other.values()
    with virtual_device(MODEL, scene=textured_scene()), dai.Device() as device:
        with pytest.raises(oaktwin.Error, match="one of another model than"):
            device.setCalibration(dai.CalibrationHandler.fromJson(json.loads(text)))


def test_cameras_of_a_pair_with_colour_filters():
    with virtual_device("OAK-D ToF", scene=textured_scene(), fast=True), dai.Pipeline() as pipeline:
        kinds = {one.socket: one.supportedTypes for one in pipeline.getDefaultDevice().getConnectedCameraFeatures()}
        assert kinds[CAM_B] == [dai.CameraSensorType.COLOR] and kinds[CAM_A] == [dai.CameraSensorType.TOF]
        frames = pipeline.create(dai.node.Camera).build(CAM_C).requestOutput(SIZE).createOutputQueue()
        tof = pipeline.create(dai.node.ToF).build()
        queues = tof.amplitude.createOutputQueue(), tof.confidence.createOutputQueue()
        depth = pipeline.create(dai.node.StereoDepth).build(True, size=SIZE).depth.createOutputQueue()
        pipeline.start()
        assert first(frames).getType() == dai.ImgFrame.Type.NV12
        amplitude, confidence = (first(queue).getFrame() for queue in queues)
        assert np.array_equal(amplitude, confidence) and amplitude.any()
        measured = first(depth).getFrame()
    # The disparity of the wall is 2 px, and has no fractions.
    assert np.median(measured[measured > 0]) == pytest.approx(1000 * WALL_M, rel=0.05)


STAGE = """#usda 1.0
(
    metersPerUnit = 1
    upAxis = "Z"
    startTimeCode = 10
    endTimeCode = 30
    timeCodesPerSecond = 20
)
def Cube "Wall"
{
    double size = 2
    double3 xformOp:translate.timeSamples = { 10: (3, 0, 0), 30: (5, 0, 0) }
    uniform token[] xformOpOrder = ["xformOp:translate"]
}
"""


def test_an_animated_stage_plays(tmp_path):
    path = tmp_path / "stage.usda"
    path.write_text(STAGE)
    assert oaktwin.Scene.open(path).animation == (10, 30, 20)
    assert textured_scene().animation is None
    with virtual_device(MODEL, scene=path, fast=True, engine="stereo-noise"), dai.Pipeline() as pipeline:
        queue = pipeline.create(dai.node.StereoDepth).build(True, size=(640, 400), fps=10).depth.createOutputQueue()
        pipeline.start()
        found = {}
        for _ in range(16):
            frame = queue.get()
            height, width = frame.getFrame().shape
            middle = frame.getFrame()[height // 3 : -height // 3, width // 3 : -width // 3]
            found[frame.getTimestampDevice().total_seconds()] = np.median(middle)
    # The face of the cube is 1 m before its centre, which moves at 2 m/s for one second, and then stands still.
    for seconds, depth in found.items():
        assert depth / 1000 == pytest.approx(2 + 2 * min(seconds, 1), rel=0.04), seconds
