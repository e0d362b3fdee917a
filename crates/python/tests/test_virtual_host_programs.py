"""Small programs for DepthAI on a virtual device: nodes that process, host nodes and the device itself."""

import threading
import time

import numpy as np
import pytest

dai = pytest.importorskip("depthai")

from virtual_scene import SIZE, first, run  # noqa: E402

CAM_A, CAM_B, CAM_C = (getattr(dai.CameraBoardSocket, f"CAM_{letter}") for letter in "ABC")
Type = dai.ImgFrame.Type


def image_manip(pipeline):
    camera = pipeline.create(dai.node.Camera).build(CAM_A)
    node = pipeline.create(dai.node.ImageManip)
    node.initialConfig.setOutputSize(100, 60)
    node.initialConfig.setFrameType(Type.BGR888i)
    camera.requestOutput(SIZE).link(node.inputImage)
    queue = node.out.createOutputQueue()
    pipeline.start()
    assert first(queue).getCvFrame().shape == (60, 100, 3)


def sync(pipeline):
    node = pipeline.create(dai.node.Sync)
    for socket, name in ((CAM_B, "left"), (CAM_C, "right")):
        pipeline.create(dai.node.Camera).build(socket).requestOutput((80, 50)).link(node.inputs[name])
    queue = node.out.createOutputQueue()
    pipeline.start()
    group = first(queue, 3)
    assert group["left"].getSequenceNum() == group["right"].getSequenceNum()
    assert group["left"].getTimestampDevice() == group["right"].getTimestampDevice()


def host_node(pipeline):
    class Mean(dai.node.HostNode):
        def build(self, source):
            self.link_args(source)
            self.means = []
            return self

        def process(self, frame):
            self.means.append(frame.getCvFrame().mean())

    camera = pipeline.create(dai.node.Camera).build(CAM_B)
    output = camera.requestOutput((80, 50))
    queue = output.createOutputQueue()
    node = pipeline.create(Mean).build(output)
    pipeline.start()
    first(queue, 3)
    until = time.monotonic() + 20
    while not node.means and time.monotonic() < until:
        time.sleep(0.01)
    assert node.means[0] > 20


def threaded_host_node(pipeline):
    class Doubled(dai.node.ThreadedHostNode):
        def __init__(self):
            super().__init__()
            self.input, self.output = self.createInput(), self.createOutput()

        def run(self):
            while self.isRunning():
                message = dai.Buffer()
                message.setSequenceNum(2 * self.input.get().getSequenceNum())
                self.output.send(message)

    node = pipeline.create(Doubled)
    pipeline.create(dai.node.Camera).build(CAM_B).requestOutput((80, 50)).link(node.input)
    queue = node.output.createOutputQueue()
    pipeline.start()
    assert first(queue, 3).getSequenceNum() == 4


def script(pipeline):
    node = pipeline.create(dai.node.Script)
    pipeline.create(dai.node.Camera).build(CAM_B).requestOutput((80, 50)).link(node.inputs["images"])
    node.setScript("""
while True:
    image = node.inputs["images"].get()
    if image.getSequenceNum() % 2:
        node.outputs["odd"].send(image)
""")
    queue = node.outputs["odd"].createOutputQueue()
    pipeline.start()
    assert [queue.get().getSequenceNum() for _ in range(2)] == [1, 3]


def indented_script(pipeline):
    node = pipeline.create(dai.node.Script)
    node.setScript("""
        count = 0
        while node.mainLoop():
            with node.outputBlockEvent():
                message = Buffer()
                message.setSequenceNum(count)
                node.io["numbers"].send(message)
            count += 1
            with node.inputBlockEvent():
                node.inputs["next"].get()
    """)
    numbers, following = node.outputs["numbers"].createOutputQueue(), node.inputs["next"].createInputQueue()
    pipeline.start()
    assert numbers.get().getSequenceNum() == 0
    following.send(dai.Buffer())
    assert numbers.get().getSequenceNum() == 1


def processing_in_the_main_thread(pipeline):
    class Threads(dai.node.HostNode):
        def build(self, source):
            self.link_args(source)
            self.sendProcessingToPipeline(True)
            self.seen = []
            return self

        def process(self, frame):
            self.seen.append(threading.current_thread())
            if len(self.seen) == 3:
                self.stopPipeline()

    output = pipeline.create(dai.node.Camera).build(CAM_B).requestOutput((80, 50))
    node = pipeline.create(Threads).build(output)
    pipeline.run()
    assert len(node.seen) >= 3 and set(node.seen) == {threading.current_thread()}


def gate(pipeline):
    node = pipeline.create(dai.node.Gate)
    pipeline.create(dai.node.Camera).build(CAM_B).requestOutput((80, 50)).link(node.input)
    queue, control = node.output.createOutputQueue(), node.inputControl.createInputQueue()
    pipeline.start()
    first(queue)
    control.send(dai.GateControl.closeGate())
    time.sleep(0.3)
    while queue.tryGet() is not None:
        pass
    time.sleep(0.2)
    assert queue.tryGet() is None


def edge_detector(pipeline):
    node = pipeline.create(dai.node.EdgeDetector)
    pipeline.create(dai.node.Camera).build(CAM_B).requestOutput((160, 100)).link(node.inputImage)
    queue = node.outputImage.createOutputQueue()
    pipeline.start()
    image = first(queue).getCvFrame()
    assert image.shape == (100, 160) and image.std() > 10


def video_encoder(pipeline):
    cv2 = pytest.importorskip("cv2")
    output = pipeline.create(dai.node.Camera).build(CAM_A).requestOutput((160, 100))
    node = pipeline.create(dai.node.VideoEncoder).build(output, frameRate=30, profile=dai.VideoEncoderProperties.Profile.MJPEG)
    queues = output.createOutputQueue(), node.out.createOutputQueue(), node.bitstream.createOutputQueue()
    pipeline.start()
    image, encoded, stream = (first(queue) for queue in queues)
    assert encoded.getProfile() == dai.EncodedFrame.Profile.JPEG and encoded.getWidth() == 160
    decoded = cv2.imdecode(np.asarray(encoded.getData()), cv2.IMREAD_COLOR).astype(int)
    assert np.abs(decoded - image.getCvFrame()).mean() < 15
    assert np.array_equal(encoded.getData(), stream.getData()) and stream.getType() == Type.BITSTREAM


def video_encoder_h264(pipeline):
    av = pytest.importorskip("av")
    output = pipeline.create(dai.node.Camera).build(CAM_A).requestOutput((160, 100))
    node = pipeline.create(dai.node.VideoEncoder).build(output, frameRate=30, profile=dai.VideoEncoderProperties.Profile.H264_MAIN)
    node.setKeyframeFrequency(4)
    queues = output.createOutputQueue(), node.out.createOutputQueue()
    pipeline.start()
    pairs = [[queue.get() for queue in queues] for _ in range(8)]
    kinds = [encoded.getFrameType().name for _, encoded in pairs]
    assert kinds == ["I", "P", "P", "P"] * 2 and pairs[0][1].getProfile() == dai.EncodedFrame.Profile.AVC
    # Every packet decodes to the image with its number.
    decoder = av.CodecContext.create("h264", "r")
    packets = [av.Packet(bytes(encoded.getData())) for _, encoded in pairs]
    decoded = [frame.to_ndarray(format="bgr24") for packet in [*packets, None] for frame in decoder.decode(packet)]
    assert len(decoded) == len(pairs)
    for (image, encoded), frame in zip(pairs, decoded):
        assert image.getSequenceNum() == encoded.getSequenceNum()
        assert np.abs(frame.astype(int) - image.getCvFrame()).mean() < 15


def warp(pipeline):
    """A mesh that mirrors an image, and one that shows its left half in twice the width."""
    output = pipeline.create(dai.node.Camera).build(CAM_B).requestOutput((80, 50))
    mirror, half = pipeline.create(dai.node.Warp), pipeline.create(dai.node.Warp)
    mirror.setWarpMesh([dai.Point2f(79, 0), dai.Point2f(0, 0), dai.Point2f(79, 49), dai.Point2f(0, 49)], 2, 2)
    half.setWarpMesh([(0, 0), (20, 0), (40, 0), (0, 49), (20, 49), (40, 49)], 3, 2)
    half.setOutputSize((81, 50))
    half.setInterpolation(dai.Interpolation.BILINEAR)
    for node in (mirror, half):
        output.link(node.inputImage)
    queues = output.createOutputQueue(), mirror.out.createOutputQueue(), half.out.createOutputQueue()
    pipeline.start()
    image, mirrored, doubled = (first(queue).getCvFrame().astype(int) for queue in queues)
    assert np.array_equal(mirrored, image[:, ::-1])
    assert np.array_equal(doubled[:, ::2], image[:, :41])
    assert np.abs(doubled[:, 1::2] - (image[:, :40] + image[:, 1:41]) / 2).max() <= 0.5


def raw_images(pipeline):
    """Four pixels in five bytes; the grey camera's values are those of its image, the colour camera's grow linearly with light."""
    queues = []
    for socket in (CAM_B, CAM_A):
        camera = pipeline.create(dai.node.Camera).build(socket, sensorFps=10)
        kind = Type.GRAY8 if socket == CAM_B else Type.RGB888i
        queues += [camera.raw.createOutputQueue(), camera.requestOutput(camera.twin.camera(socket)[1].size, kind).createOutputQueue()]
    pipeline.start()
    raw, grey, mosaic, colours = (first(queue) for queue in queues)

    def unpacked(frame):
        groups = np.asarray(frame.getData()).reshape(-1, 5).astype(int)
        values = (groups[:, :4] << 2) | ((groups[:, 4:] >> np.array([0, 2, 4, 6])) & 3)
        return values.reshape(frame.getHeight(), frame.getStride())

    assert raw.getType() == Type.RAW10 and np.array_equal(unpacked(raw) >> 2, grey.getCvFrame())
    values, rgb = unpacked(mosaic), colours.getCvFrame()[..., ::-1] / 255
    linear = np.where(rgb <= 0.04045, rgb / 12.92, ((rgb + 0.055) / 1.055) ** 2.4)
    for (row, column), channel in {(0, 0): 0, (0, 1): 1, (1, 0): 1, (1, 1): 2}.items():
        assert np.abs(values[row::2, column::2] - 1023 * linear[row::2, column::2, channel]).max() <= 0.5 + 1e-6


def point_cloud_of_another_camera(pipeline):
    """DepthAI's node asks its pipeline for the calibration."""
    stereo = pipeline.create(dai.node.StereoDepth).build(True, size=SIZE)
    queues = []
    for socket in (CAM_A, CAM_B):
        node = pipeline.create(dai.node.PointCloud)
        node.setRunOnHost(True)
        node.initialConfig.setLengthUnit(dai.LengthUnit.METER)
        node.initialConfig.setTargetCoordinateSystem(socket)
        stereo.depth.link(node.inputDepth)
        queues.append(node.outputPointCloud.createOutputQueue())
    handler = pipeline.getDefaultDevice().readCalibration()
    pipeline.start()
    in_colour, in_left = (first(queue).getPoints() for queue in queues)
    # The cameras are parallel: points are shifted by the distance between them.
    shift = handler.getCameraTranslationVector(CAM_B, CAM_A, useSpecTranslation=False)
    assert abs(shift[0]) > 3 and np.allclose(in_colour - in_left, np.array(shift) / 100, atol=1e-5)


def feature_tracker(pipeline):
    pytest.importorskip("cv2")
    node = pipeline.create(dai.node.FeatureTracker)
    pipeline.create(dai.node.Camera).build(CAM_B).requestOutput(SIZE).link(node.inputImage)
    queue = node.outputFeatures.createOutputQueue()
    pipeline.start()
    features = first(queue, 3).trackedFeatures
    # Nothing moves, so most features are kept.
    assert len(features) > 50 and np.mean([feature.age >= 2 for feature in features]) > 0.8


def undistorted_camera(pipeline):
    camera = pipeline.create(dai.node.Camera).build(CAM_B)
    queue = camera.requestOutput((160, 100), enableUndistortion=True).createOutputQueue()
    pipeline.start()
    assert not np.any(first(queue).getTransformation().getDistortionCoefficients())


def legacy_cameras(pipeline):
    colour, mono = pipeline.create(dai.node.ColorCamera), pipeline.create(dai.node.MonoCamera)
    colour.setPreviewSize(120, 80)
    colour.setInterleaved(False)
    mono.setBoardSocket(CAM_C)
    mono.setResolution(dai.MonoCameraProperties.SensorResolution.THE_400_P)
    queues = colour.preview.createOutputQueue(), mono.out.createOutputQueue()
    pipeline.start()
    assert [first(queue).getCvFrame().shape for queue in queues] == [(80, 120, 3), (400, 640)]


def calibration(pipeline):
    handler = pipeline.getDefaultDevice().readCalibration()
    assert isinstance(handler, dai.CalibrationHandler)
    assert handler.getBaselineDistance(CAM_C, CAM_B) == pytest.approx(7.5, abs=1e-4)
    assert handler.getFov(CAM_B) == pytest.approx(77, abs=0.1)
    assert handler.eepromToJson()["productName"] == "OAK-D-PRO-POE"


def device_information(pipeline):
    device = pipeline.getDefaultDevice()
    assert device.getPlatform() == dai.Platform.RVC2 and device.getPlatformAsString() == "RVC2"
    assert device.getConnectedCameras() == [CAM_A, CAM_B, CAM_C]
    assert device.getCameraSensorNames()[CAM_B] == "OV9282"
    assert device.getConnectedIMU() == "BNO086" and device.getDeviceName() == "OAK-D-PRO-POE"
    assert device.getChipTemperature().average > 0 and device.getDdrMemoryUsage().total > 0
    assert device.getStereoPairs()[0].baseline == pytest.approx(7.5, abs=1e-3) and not device.isClosed()


def dot_projector(pipeline):
    device = pipeline.getDefaultDevice()
    assert device.setIrLaserDotProjectorIntensity(0)
    queue = pipeline.create(dai.node.Camera).build(CAM_B).requestOutput(SIZE).createOutputQueue()
    pipeline.start()
    without = first(queue).getCvFrame().astype(float)
    device.setIrLaserDotProjectorIntensity(1.0)
    assert max(np.abs(first(queue).getCvFrame() - without).max() for _ in range(20)) > 40


def benchmark(pipeline):
    node = pipeline.create(dai.node.BenchmarkIn)
    node.setRunOnHost(True)
    node.sendReportEveryNMessages(5)
    pipeline.create(dai.node.Camera).build(CAM_B).requestOutput((80, 50)).link(node.input)
    queue = node.report.createOutputQueue()
    pipeline.start()
    assert first(queue).numMessagesReceived == 5


PROGRAMS = [
    image_manip, sync, host_node, threaded_host_node, script, indented_script, processing_in_the_main_thread, gate,
    edge_detector, video_encoder, video_encoder_h264, feature_tracker, undistorted_camera, legacy_cameras, calibration, device_information,
    dot_projector, benchmark, warp, raw_images, point_cloud_of_another_camera,
]  # fmt: skip


@pytest.mark.parametrize("program", PROGRAMS, ids=lambda program: program.__name__)
def test_program(program):
    run(program)
