"""The images of virtual devices, measured by DepthAI's own host nodes."""

import os
from pathlib import Path

import numpy as np
import pytest

dai = pytest.importorskip("depthai")

import oaktwin  # noqa: E402
from oaktwin.depthai import virtual_device  # noqa: E402
from virtual_scene import BOX_M, MODEL, SIZE, WALL_M, textured_scene  # noqa: E402

CAM_A, CAM_B, CAM_C = (getattr(dai.CameraBoardSocket, f"CAM_{letter}") for letter in "ABC")
DENSITY = dai.node.StereoDepth.PresetMode.DENSITY
CALIBRATION = "oak-d-pro-af_v7_18443010F116631200.json"


def measured(build, model=MODEL, **options):
    """The first messages of the queues that a function makes."""
    with virtual_device(model, scene=textured_scene(), fast=True, **options) as device, dai.Pipeline() as pipeline:
        queues = build(pipeline)
        pipeline.start()
        return device, [queue.get() for queue in queues]


def fine_stereo(pipeline):
    """Depth of every pixel, without filters."""
    node = pipeline.create(dai.node.StereoDepth).build(True, DENSITY, SIZE)
    return node


def test_point_cloud():
    def build(pipeline):
        stereo = fine_stereo(pipeline)
        node = pipeline.create(dai.node.PointCloud)
        stereo.depth.link(node.inputDepth)
        return stereo.depth.createOutputQueue(), node.outputPointCloud.createOutputQueue()

    device, (depth, cloud) = measured(build)
    camera = device.twin.depth_camera("stereo").resized(*SIZE, rule="depthai")
    # The node's points are in the frame of the colour camera, to which the extrinsics of all images lead.
    colour_from_depth = np.linalg.inv(device.twin.cameras["rgb"].body_from_camera) @ camera.body_from_camera
    own = 1000 * (camera.unproject(depth.getFrame()) @ colour_from_depth[:3, :3].T + colour_from_depth[:3, 3])
    valid = depth.getFrame() > 0
    assert valid.mean() > 0.5 and np.abs(cloud.getPoints() - own[valid]).max() < 1


def test_rgbd():
    def build(pipeline):
        node = pipeline.create(dai.node.RGBD)
        camera = pipeline.create(dai.node.Camera).build(CAM_A)
        stereo = fine_stereo(pipeline)
        node.build(camera, stereo, size=(320, 180))
        return stereo.depth.createOutputQueue(), node.pcl.createOutputQueue()

    device, (depth, cloud) = measured(build)
    camera = device.twin.cameras["rgb"].resized(320, 180, rule="depthai")
    points, _ = cloud.getPointsRGB()
    own = 1000 * camera.unproject(depth.getFrame())
    valid = depth.getFrame() > 0
    assert valid.mean() > 0.5 and np.abs(points.reshape(180, 320, 3) - own)[valid].max() < 1


def rectified_pair(pipeline):
    stereo = fine_stereo(pipeline)
    node = pipeline.create(dai.node.Rectification)
    for socket, port in ((CAM_B, node.input1), (CAM_C, node.input2)):
        pipeline.create(dai.node.Camera).build(socket).requestOutput(SIZE).link(port)
    outputs = node.output1, node.output2, stereo.rectifiedLeft, stereo.rectifiedRight
    return [output.createOutputQueue() for output in outputs]


def test_rectification_of_the_nominal_pair():
    _, frames = measured(rectified_pair)
    host_left, host_right, left, right = (frame.getCvFrame().astype(int) for frame in frames)
    for host, own in ((host_left, left), (host_right, right)):
        # The node interpolates between pixels; within the border of the image it has nothing to interpolate with.
        assert np.abs(host - own)[4:-4, 4:-4].max() <= 1


def test_image_align():
    def build(pipeline):
        stereo = fine_stereo(pipeline)
        colour = pipeline.create(dai.node.Camera).build(CAM_A).requestOutput((320, 180))
        node = pipeline.create(dai.node.ImageAlign)
        stereo.depth.link(node.input)
        colour.link(node.inputAlignTo)
        return stereo.depth.createOutputQueue(), node.outputAligned.createOutputQueue()

    device, (depth, aligned) = measured(build, engine="stereo-noise")
    own_camera, target = device.twin.depth_camera("stereo").resized(*SIZE, rule="depthai"), device.twin.cameras["rgb"].resized(320, 180, rule="depthai")
    own = oaktwin.align(depth.getFrame(), own_camera, target).astype(int)
    theirs = aligned.getFrame().astype(int)
    both = (own > 0) & (theirs > 0)
    assert both.mean() > 0.7
    # Pixels at the edges of the box, and the half pixel between the two conventions, differ.
    assert np.median(np.abs(own - theirs)[both]) < 15 and (np.abs(own - theirs)[both] > 100).mean() < 0.06


def test_spatial_location():
    def build(pipeline):
        stereo = fine_stereo(pipeline)
        node = pipeline.create(dai.node.SpatialLocationCalculator)
        config = dai.SpatialLocationCalculatorConfigData()
        config.roi = dai.Rect(dai.Point2f(0.48, 0.47), dai.Point2f(0.52, 0.53))
        config.depthThresholds.lowerThreshold, config.depthThresholds.upperThreshold = 100, 10000
        config.calculationAlgorithm = dai.SpatialLocationCalculatorAlgorithm.MEDIAN
        node.initialConfig.addROI(config)
        stereo.depth.link(node.inputDepth)
        return [node.out.createOutputQueue()]

    for engine in ("stereo-matching", "stereo-noise"):
        _, (message,) = measured(build, engine=engine)
        place = message.getSpatialLocations()[0].spatialCoordinates
        assert place.z == pytest.approx(1000 * BOX_M, rel=0.02)
        # The device's origin is midway between the cameras, 37.5 mm to the right of the left one.
        assert place.x == pytest.approx(37.5, abs=40)
        assert abs(place.y) < 25


def test_the_wall_in_the_cameras_own_frames():
    """Points that DepthAI moves between cameras by their transformations stay on the wall."""

    def build(pipeline):
        left = pipeline.create(dai.node.Camera).build(CAM_B).requestOutput(SIZE)
        colour = pipeline.create(dai.node.Camera).build(CAM_A).requestOutput((320, 180))
        return left.createOutputQueue(), colour.createOutputQueue()

    _, (left, colour) = measured(build)
    one, other = left.getTransformation(), colour.getTransformation()
    moved = one.remap3DPointTo(other, dai.Point3f(0.0, 0.0, 1000 * WALL_M))
    assert (moved.x, moved.y, moved.z) == pytest.approx((-3.75, 0, 1000 * WALL_M), abs=40) and moved.z == pytest.approx(1000 * WALL_M)


TAG_M = 0.3


def tag_scene(device, camera_from_tag):
    """A tag of the family 36h11 with a white margin; the tag's x points to its right, y up and z out of its face."""
    cv2 = pytest.importorskip("cv2")
    marker = cv2.aruco.generateImageMarker(cv2.aruco.getPredefinedDictionary(cv2.aruco.DICT_APRILTAG_36h11), 7, 640)
    texture = np.repeat(np.pad(marker, 80, constant_values=255)[..., None], 3, axis=2)
    half = TAG_M / 2 * texture.shape[0] / marker.shape[0]
    corners = np.array([(-half, -half, 0, 1), (half, -half, 0, 1), (half, half, 0, 1), (-half, half, 0, 1)])
    vertices = corners @ (np.asarray(device.cameras["rgb"].body_from_camera) @ camera_from_tag).T
    uvs = [(0, 0), (1, 0), (1, 1), (0, 1)]
    return oaktwin.Scene.from_meshes({"tag": oaktwin.Mesh(vertices[:, :3], [(0, 1, 2), (0, 2, 3)], uvs=uvs, texture=texture)})


@pytest.mark.parametrize(("axis_angle", "place"), [((0.0, 0.5, 0.0), (0.2, -0.1, 1.5)), ((0.4, -0.3, 0.6), (-0.15, 0.1, 1.0))])
def test_april_tag(axis_angle, place):
    """The corners that DepthAI's detector finds give the pose of the tag, by OpenCV's solver and the image's own transformation."""
    cv2 = pytest.importorskip("cv2")
    true = np.eye(4)
    true[:3, :3] = cv2.Rodrigues(np.array(axis_angle))[0] @ np.diag([1.0, -1.0, -1.0])
    true[:3, 3] = place
    with virtual_device(MODEL, scene=tag_scene(oaktwin.Device(MODEL), true), fast=True), dai.Pipeline() as pipeline:
        image = pipeline.create(dai.node.Camera).build(CAM_A).requestOutput((1280, 720))
        node = pipeline.create(dai.node.AprilTag)
        image.link(node.inputImage)
        frames, queue = image.createOutputQueue(), node.out.createOutputQueue()
        pipeline.start()
        described, (tag,) = frames.get().getTransformation(), queue.get().aprilTags
    assert tag.id == 7
    found = np.array([(one.x, one.y) for one in (tag.topLeft, tag.topRight, tag.bottomRight, tag.bottomLeft)])
    # Tags as OpenCV draws them are upside down to DepthAI's detector.
    corners = TAG_M / 2 * np.array([(1.0, -1, 0), (-1, -1, 0), (-1, 1, 0), (1, 1, 0)])
    matrix, lens = np.array(described.getIntrinsicMatrix()), np.array(described.getDistortionCoefficients())
    _, rotation, translation = cv2.solvePnP(corners, found, matrix, lens, flags=cv2.SOLVEPNP_ITERATIVE)
    assert np.linalg.norm(translation.ravel() - place) < 0.01 * np.linalg.norm(place)
    turned = cv2.Rodrigues(rotation)[0].T @ true[:3, :3]
    assert np.degrees(np.linalg.norm(cv2.Rodrigues(turned)[0])) < 0.5


@pytest.mark.skipif("OAKTWIN_TEST_DATA" not in os.environ, reason="OAKTWIN_TEST_DATA is not set")
def test_a_units_calibration_is_the_devices():
    path = Path(os.environ["OAKTWIN_TEST_DATA"]) / "data/calibration" / CALIBRATION

    def build(pipeline):
        handler = pipeline.getDefaultDevice().readCalibration()
        expected = handler.getCameraIntrinsics(CAM_B, *SIZE)
        queue = pipeline.create(dai.node.Camera).build(CAM_B).requestOutput(SIZE).createOutputQueue()
        build.expected = np.array(expected), handler.getDistortionCoefficients(CAM_B)
        return [queue]

    # This unit's baseline is far from the design of its board.
    _, (frame,) = measured(build, model=oaktwin.Device.from_calibration(path, force=True))
    described = frame.getTransformation()
    assert np.allclose(described.getIntrinsicMatrix(), build.expected[0], atol=1e-2)
    assert np.allclose(described.getDistortionCoefficients(), build.expected[1], atol=1e-5)


def test_a_recording_is_video(tmp_path):
    """DepthAI's own recorder writes the encoder's packets, and a player reads them."""
    av = pytest.importorskip("av")
    path = tmp_path / "video.mp4"
    with virtual_device(MODEL, scene=textured_scene(), fast=True), dai.Pipeline() as pipeline:
        output = pipeline.create(dai.node.Camera).build(CAM_A).requestOutput((160, 100), fps=30)
        profile = dai.VideoEncoderProperties.Profile.H264_MAIN
        encoder = pipeline.create(dai.node.VideoEncoder).build(output, frameRate=30, profile=profile)
        recorder = pipeline.create(dai.node.RecordVideo)
        recorder.setRecordVideoFile(path)
        encoder.out.link(recorder.input)
        queue, images = encoder.out.createOutputQueue(), output.createOutputQueue()
        pipeline.start()
        for _ in range(60):
            image, _ = images.get(), queue.get()
        pipeline.stop()
        expected = image.getCvFrame().astype(int)
    with av.open(str(path)) as video:
        frames = [frame.to_ndarray(format="bgr24") for frame in video.decode(video=0)]
    # The recorder begins once it knows the rate, and may not have got the last packets.
    assert frames
    assert np.abs(frames[-1] - expected).mean() < 15
