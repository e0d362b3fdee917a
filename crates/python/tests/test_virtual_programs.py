"""Small programs for DepthAI, each with calls that the vendor's examples use, on a virtual device: its cameras and sensors."""

import threading
import time

import numpy as np
import pytest

dai = pytest.importorskip("depthai")

from oaktwin.depthai import virtual_device  # noqa: E402
from virtual_scene import BOX_M, MODEL, SIZE, WALL_M, first, run, textured_scene  # noqa: E402

CAM_A, CAM_B, CAM_C = (getattr(dai.CameraBoardSocket, f"CAM_{letter}") for letter in "ABC")
Type = dai.ImgFrame.Type


def camera_output(pipeline):
    queue = pipeline.create(dai.node.Camera).build().requestOutput(SIZE).createOutputQueue()
    pipeline.start()
    frame = first(queue, 3)
    assert isinstance(frame, dai.ImgFrame) and frame.getType() == Type.NV12
    assert frame.getCvFrame().shape == (SIZE[1], SIZE[0], 3) and frame.getSequenceNum() == 2
    assert frame.getTimestampDevice().total_seconds() == pytest.approx(2 / 30, abs=1e-5)
    assert frame.validateTransformations() and frame.getTransformation().getSize() == SIZE


def camera_types(pipeline):
    camera = pipeline.create(dai.node.Camera).build(CAM_A)
    kinds = [Type.NV12, Type.BGR888p, Type.BGR888i, Type.RGB888p, Type.RGB888i]
    queues = [camera.requestOutput((160, 100), kind).createOutputQueue() for kind in kinds]
    pipeline.start()
    frames = [first(queue) for queue in queues]
    assert [frame.getType() for frame in frames] == kinds
    images = [frame.getCvFrame().astype(int) for frame in frames]
    # Chroma has half the resolution in NV12.
    assert all(np.abs(image - images[-1]).max() == 0 for image in images[1:])
    assert np.abs(images[0] - images[-1]).mean() < 6


def camera_all(pipeline):
    queues = {}
    for feature in pipeline.getDefaultDevice().getConnectedCameraFeatures():
        camera = pipeline.create(dai.node.Camera).build(feature.socket)
        capability = dai.ImgFrameCapability()
        capability.size.fixed((160, 100))
        capability.fps.fixed(15)
        queues[feature.socket] = camera.requestOutput(capability, True).createOutputQueue()
    pipeline.start()
    assert {socket: first(queue).getInstanceNum() for socket, queue in queues.items()} == {CAM_A: 0, CAM_B: 1, CAM_C: 2}


def camera_resize_modes(pipeline):
    camera = pipeline.create(dai.node.Camera).build(CAM_B)
    modes = (dai.ImgResizeMode.CROP, dai.ImgResizeMode.STRETCH, dai.ImgResizeMode.LETTERBOX)
    queues = [camera.requestOutput((120, 120), Type.GRAY8, mode).createOutputQueue() for mode in modes]
    pipeline.start()
    crop, stretch, letterbox = (first(queue) for queue in queues)
    matrices = [np.array(one.getTransformation().getIntrinsicMatrix()) for one in (crop, stretch, letterbox)]
    assert matrices[0][0, 0] > matrices[1][0, 0] and matrices[1][1, 1] == pytest.approx(matrices[0][1, 1])
    # The bars of the letterbox, 75 of 120 rows have the image.
    image = letterbox.getCvFrame()
    assert image.shape == (120, 120) and not image[:22].any() and not image[-22:].any() and image[24:96].min() > 0


def camera_full_resolution(pipeline):
    queue = pipeline.create(dai.node.Camera).build(CAM_B).requestFullResolutionOutput(fps=5).createOutputQueue()
    pipeline.start()
    assert first(queue).getCvFrame().shape == (800, 1280)


def camera_two_rates(pipeline):
    camera = pipeline.create(dai.node.Camera).build(CAM_B)
    slow = camera.requestOutput((80, 50), fps=10).createOutputQueue(maxSize=50)
    fast = camera.requestOutput((80, 50), fps=30).createOutputQueue(maxSize=50)
    pipeline.start()
    for _ in range(12):
        fast.get()
    times = [first(slow).getTimestampDevice().total_seconds() for _ in range(3)]
    assert np.diff(times) == pytest.approx([0.1, 0.1], abs=1e-5)


def manual_exposure(pipeline):
    camera = pipeline.create(dai.node.Camera).build(CAM_B)
    queue = camera.requestOutput((80, 50)).createOutputQueue()
    control = camera.inputControl.createInputQueue()
    pipeline.start()
    before = first(queue)
    half = dai.CameraControl()
    half.setManualExposure(int(before.getExposureTime().total_seconds() * 5e5), before.getSensitivity())
    control.send(half)
    for _ in range(20):
        after = queue.get()
        if after.getExposureTime() < before.getExposureTime():
            break
    assert after.getCvFrame().mean() == pytest.approx(before.getCvFrame().mean() / 2, rel=0.1)


def initial_exposure(pipeline):
    dark, bright = pipeline.create(dai.node.Camera).build(CAM_A), pipeline.create(dai.node.Camera).build(CAM_B)
    dark.initialControl.setManualExposure(1000, 100)
    queues = [camera.requestOutput((80, 50)).createOutputQueue() for camera in (dark, bright)]
    pipeline.start()
    frames = [first(queue) for queue in queues]
    assert frames[0].getExposureTime().total_seconds() == pytest.approx(1e-3) and frames[0].getSensitivity() == 100
    assert frames[0].getCvFrame().mean() < frames[1].getCvFrame().mean() / 2


def stereo(pipeline):
    cameras = [pipeline.create(dai.node.Camera).build(socket) for socket in (CAM_B, CAM_C)]
    node = pipeline.create(dai.node.StereoDepth)
    for camera, port in zip(cameras, (node.left, node.right)):
        camera.requestOutput(SIZE).link(port)
    node.setRectification(True)
    node.setLeftRightCheck(True)
    outputs = node.depth, node.disparity, node.confidenceMap, node.syncedLeft, node.rectifiedRight
    queues = [output.createOutputQueue() for output in outputs]
    pipeline.start()
    depth, disparity, confidence, left, rectified = (first(queue) for queue in queues)
    millimetres = depth.getFrame()
    assert depth.getType() == Type.RAW16 and confidence.getType() == Type.RAW8
    assert (millimetres > 0).mean() > 0.7
    assert np.median(millimetres[:60][millimetres[:60] > 0]) == pytest.approx(1000 * WALL_M, rel=0.04)
    assert np.median(millimetres[90:110, 150:170]) == pytest.approx(1000 * BOX_M, rel=0.02)
    # 32 steps of a pixel.
    f = depth.getTransformation().getIntrinsicMatrix()[0][0]
    pixels = np.median(disparity.getFrame()[90:110, 150:170]) / 32
    assert pixels == pytest.approx(f * 0.075 / BOX_M, rel=0.02)
    assert left.getCvFrame().shape == rectified.getCvFrame().shape == SIZE[::-1]


def stereo_autocreate(pipeline):
    node = pipeline.create(dai.node.StereoDepth).build(True, size=SIZE)
    queue = node.depth.createOutputQueue()
    pipeline.start()
    # The preset DEFAULT halves the image.
    assert first(queue).getFrame().shape == (100, 160)


def stereo_presets(pipeline):
    node = pipeline.create(dai.node.StereoDepth).build(True, dai.node.StereoDepth.PresetMode.ROBOTICS, SIZE)
    config = node.initialConfig
    assert config.postProcessing.thresholdFilter.maxRange == 10000 and config.postProcessing.spatialFilter.delta == 20
    config.postProcessing.decimationFilter.decimationFactor = 1
    config.postProcessing.thresholdFilter.maxRange = 1500
    queue = node.depth.createOutputQueue()
    pipeline.start()
    frame = first(queue).getFrame()
    assert frame.shape == SIZE[::-1] and 0 < frame.max() <= 1500


def stereo_aligned_to_colour(pipeline):
    colour = pipeline.create(dai.node.Camera).build(CAM_A).requestOutput((320, 180))
    node = pipeline.create(dai.node.StereoDepth).build(True, size=SIZE)
    colour.link(node.inputAlignTo)
    queues = node.depth.createOutputQueue(), colour.createOutputQueue()
    pipeline.start()
    depth, image = (first(queue) for queue in queues)
    assert depth.getFrame().shape == (180, 320)
    assert depth.getTransformation().isAlignedTo(image.getTransformation())


def stereo_aligned_to_socket(pipeline):
    node = pipeline.create(dai.node.StereoDepth).build(True, size=SIZE)
    node.setDepthAlign(CAM_A)
    node.setOutputSize(192, 108)
    queue = node.depth.createOutputQueue()
    pipeline.start()
    frame = first(queue)
    calibration = pipeline.getDefaultDevice().readCalibration()
    expected = np.array(calibration.getCameraIntrinsics(CAM_A, 192, 108))
    assert np.allclose(frame.getTransformation().getIntrinsicMatrix(), expected, atol=1e-3)


def stereo_runtime_config(pipeline):
    node = pipeline.create(dai.node.StereoDepth).build(True, size=SIZE)
    queue, config = node.depth.createOutputQueue(), node.inputConfig.createInputQueue()
    pipeline.start()
    assert first(queue).getFrame().max() > 1500
    changed = dai.StereoDepthConfig()
    changed.postProcessing.thresholdFilter.maxRange = 1500
    config.send(changed)
    assert any(queue.get().getFrame().max() <= 1500 for _ in range(30))


def rgbd_autocreate(pipeline):
    node = pipeline.create(dai.node.RGBD).build(True, size=SIZE)
    queue = node.pcl.createOutputQueue()
    pipeline.start()
    points, colours = first(queue).getPointsRGB()
    assert points.shape == (SIZE[0] * SIZE[1], 3) and len(colours) == len(points)


def depth_node(pipeline):
    node = pipeline.create(dai.node.Depth).build(dai.node.Depth.Algorithm.STEREO, size=SIZE)
    queues = node.depth.createOutputQueue(), node.confidence.createOutputQueue()
    pipeline.start()
    assert [first(queue).getType() for queue in queues] == [Type.RAW16, Type.RAW8]


def depth_node_without_configuration(pipeline):
    node = pipeline.create(dai.node.Depth).build(dai.node.Depth.Algorithm.AUTO, None, (320, 200))
    queue = node.depth.createOutputQueue()
    pipeline.build()
    stereo = dai.node.Depth.Algorithm.STEREO
    assert node.getResolvedAlgorithm() == stereo == dai.node.Depth.getDefaultAlgorithm(pipeline.getDefaultDevice())
    assert dai.node.Depth.getSupportedAlgorithms(pipeline.getDefaultDevice()) == [stereo]
    assert node.getResolvedConfig() == node.getRequestedConfig() == dai.node.StereoDepth.PresetMode.DEFAULT
    pipeline.start()
    frame = first(queue)
    # The preset halves the size of the images.
    assert (frame.getWidth(), frame.getHeight()) == (160, 100)


def imu(pipeline):
    node = pipeline.create(dai.node.IMU)
    node.enableIMUSensor(dai.IMUSensor.ACCELEROMETER_RAW, 400)
    node.enableIMUSensor([dai.IMUSensor.GYROSCOPE_RAW, dai.IMUSensor.ROTATION_VECTOR], 200)
    node.setBatchReportThreshold(5)
    node.setMaxBatchReports(10)
    queue = node.out.createOutputQueue(maxSize=50, blocking=False)
    pipeline.start()
    packets = [packet for _ in range(20) for packet in queue.get().packets]
    assert len(packets) == 100
    g = [np.linalg.norm([p.acceleroMeter.x, p.acceleroMeter.y, p.acceleroMeter.z]) for p in packets]
    assert np.mean(g) == pytest.approx(9.81, abs=0.1)
    times = [packet.acceleroMeter.getTimestampDevice().total_seconds() for packet in packets]
    assert np.diff(times) == pytest.approx(1 / 400, abs=2e-6)
    assert abs(np.mean([packet.gyroscope.z for packet in packets])) < 0.05


PROGRAMS = [
    camera_output, camera_types, camera_all, camera_resize_modes, camera_full_resolution, camera_two_rates, manual_exposure,
    initial_exposure, stereo, stereo_autocreate, stereo_presets, stereo_aligned_to_colour, stereo_aligned_to_socket,
    stereo_runtime_config, rgbd_autocreate, depth_node, depth_node_without_configuration, imu,
]  # fmt: skip


@pytest.mark.parametrize("engine", ["stereo-matching", "stereo-noise"])
def test_stereo_of_narrower_images(engine):
    """Depth of images of 4:3, which the sensor's are cut to, is the middle of the depth of whole images."""
    found = {}
    for size in ((320, 200), (266, 200)):
        with virtual_device(MODEL, scene=textured_scene(), fast=True, engine=engine), dai.Pipeline() as pipeline:
            stereo = pipeline.create(dai.node.StereoDepth).build(True, size=size)
            stereo.initialConfig.postProcessing.decimationFilter.decimationFactor = 1
            queues = stereo.depth.createOutputQueue(), stereo.rectifiedLeft.createOutputQueue()
            pipeline.start()
            found[size] = [first(queue) for queue in queues]
    (whole, whole_image), (narrow, narrow_image) = found.values()
    assert narrow.getFrame().shape == narrow_image.getCvFrame().shape == (200, 266)
    assert np.array_equal(narrow_image.getCvFrame(), whole_image.getCvFrame()[:, 27:-27])
    expected, measured = (frame.getFrame().astype(float) for frame in (whole, narrow))
    expected = expected[:, 27:-27]
    is_both = (expected > 0) & (measured > 0)
    # The engines' noise and edges differ, the wall and the box do not.
    assert is_both.mean() > 0.6 and np.mean(np.abs(expected - measured)[is_both] < 0.05 * expected[is_both]) > 0.97
    matrices = [np.array(frame.getTransformation().getIntrinsicMatrix()) for frame in (whole, narrow)]
    assert matrices[0] - matrices[1] == pytest.approx(np.array([[0, 0, 27], [0, 0, 0], [0, 0, 0]]), abs=1e-3)


@pytest.mark.parametrize("program", PROGRAMS, ids=lambda program: program.__name__)
def test_program(program):
    run(program)


@pytest.mark.parametrize("node", [dai.node.ToF, dai.node.Depth])
def test_time_of_flight(node):
    with virtual_device("OAK-D ToF", scene=textured_scene(), fast=True), dai.Pipeline() as pipeline:
        # The stand-in of the same name.
        queue = pipeline.create(getattr(dai.node, node.__name__)).build().depth.createOutputQueue()
        pipeline.start()
        frame = first(queue).getFrame()
    assert np.median(frame[:60][frame[:60] > 0]) == pytest.approx(1000 * WALL_M, rel=0.02)


def test_the_same_bytes_on_every_run():
    def run():
        with virtual_device(MODEL, scene=textured_scene(), fast=True, seed=4), dai.Pipeline() as pipeline:
            node = pipeline.create(dai.node.StereoDepth).build(True, size=(160, 100))
            colour = pipeline.create(dai.node.Camera).build().requestOutput((80, 50))
            queues = node.depth.createOutputQueue(), colour.createOutputQueue()
            pipeline.start()
            return [np.concatenate([first(queue).getData() for _ in range(4)]) for queue in queues]

    for one, other in zip(run(), run()):
        assert np.array_equal(one, other)


def test_real_time_drops_frames_and_keeps_pairs_together():
    with virtual_device(MODEL, scene=textured_scene()), dai.Pipeline() as pipeline:
        node = pipeline.create(dai.node.StereoDepth).build(True, size=(160, 100), fps=60)
        queues = node.syncedLeft.createOutputQueue(), node.syncedRight.createOutputQueue()
        pipeline.start()
        for _ in range(5):
            left, right = (queue.get() for queue in queues)
            assert left.getSequenceNum() == right.getSequenceNum()
        begin = time.monotonic()
        pipeline.stop()
        pipeline.wait()
        assert time.monotonic() - begin < 10


def test_exact_depth_engine():
    with virtual_device(MODEL, scene=textured_scene(), fast=True, engine="stereo-noise"), dai.Pipeline() as pipeline:
        stereo(pipeline)


def test_a_trajectory_and_a_function_move_the_device():
    def pose(seconds):
        matrix = np.eye(4)
        matrix[0, 3] = seconds
        return matrix

    track = (np.array([0.0, 10.0]), np.stack([pose(0.0), pose(10.0)]))
    for motion in (pose, track):
        with virtual_device(MODEL, scene=textured_scene(), pose=motion, fast=True, engine="stereo-noise"), dai.Pipeline() as pipeline:
            node = pipeline.create(dai.node.StereoDepth).build(True, dai.node.StereoDepth.PresetMode.DENSITY, SIZE, fps=10)
            queue = node.depth.createOutputQueue()
            pipeline.start()
            middles = [np.median(queue.get().getFrame()[45:55, 75:85]) for _ in range(4)]
        assert np.diff(middles) == pytest.approx([-100] * 3, abs=30)


def test_two_devices_at_once():
    scene = textured_scene()
    with virtual_device(MODEL, scene=scene, fast=True), virtual_device("OAK4-D", scene=scene, fast=True):
        found = dai.Device.getAllAvailableDevices()
        devices = [dai.Device(info) for info in found]
        assert [device.getPlatformAsString() for device in devices] == ["RVC2", "RVC4"]
        assert len({device.getDeviceId() for device in devices}) == 2 and not dai.Device.getAllAvailableDevices()
        for device in devices:
            with dai.Pipeline(device) as pipeline:
                camera_output(pipeline)


def test_a_device_is_free_again_after_its_pipeline():
    with virtual_device(MODEL, scene=textured_scene(), fast=True):
        for _ in range(2):
            with dai.Pipeline() as pipeline:
                assert not dai.Device.getAllAvailableDevices()
                camera_output(pipeline)
            with dai.Device() as device:
                assert not device.isClosed()
            with dai.Pipeline(dai.Device()) as pipeline:
                camera_all(pipeline)


def test_a_program_may_end_without_closing_its_pipeline():
    def program():
        pipeline = dai.Pipeline()
        queue = pipeline.create(dai.node.Camera).build(CAM_B).requestOutput((80, 50)).createOutputQueue()
        pipeline.start()
        return queue.get()

    with virtual_device(MODEL, scene=textured_scene()):
        assert program().getWidth() == 80
        # The pipeline is gone, and so is its hold on the device.
        assert len(dai.Device.getAllAvailableDevices()) == 1


def test_threads_end():
    before = threading.active_count()
    for _ in range(3):
        with virtual_device(MODEL, scene=textured_scene(), fast=True), dai.Pipeline() as pipeline:
            stereo_autocreate(pipeline)
    assert threading.active_count() <= before + 2
