"""Nodes that turn images into others: Gate, VideoEncoder, EdgeDetector, FeatureTracker."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import depthai as dai
import numpy as np

from .._findings import Error
from ._frames import Image, grey_frame, grey_of
from ._library import warn_once
from ._node import VirtualNode
from ._video import Video

if TYPE_CHECKING:
    from typing_extensions import Self

_Kind = dai.DatatypeEnum
_Encoded = dai.EncodedFrame
_RealEncoder, _RealGate = dai.node.VideoEncoder, dai.node.Gate
Profile = dai.VideoEncoderProperties.Profile


def _opencv(node: str) -> Any:
    try:
        import cv2
    except ImportError as error:
        raise Error(f"{node}: it needs OpenCV; install it: pip install opencv-python-headless") from error
    return cv2


class Gate(VirtualNode):
    """DepthAI's Gate: passes messages while it is open, or a number of them."""

    Properties = getattr(_RealGate, "Properties", None)

    def __init__(self) -> None:
        super().__init__()
        self.input: Any = self.createInput(name="input")
        self.output = self.createOutput(name="output")
        self.inputControl = self.message_input("inputControl", _Kind.GateControl)
        self.initialConfig = dai.GateControl()

    def setRunOnHost(self, runOnHost: bool) -> None:
        """Has no effect: the node runs on the host."""

    def work(self) -> None:
        """Passes messages until the pipeline stops."""
        control = self.initialConfig
        left = control.numMessages
        while self.runs():
            message = self.input.get()
            while (changed := self.inputControl.tryGet()) is not None:
                control, left = changed, changed.numMessages
            if control.open and left != 0:
                left -= left > 0
                self.output.send(message)


class VideoEncoder(VirtualNode):
    """DepthAI's VideoEncoder: MJPEG by OpenCV, H.264 and H.265 by PyAV."""

    Properties = getattr(_RealEncoder, "Properties", None)

    def __init__(self) -> None:
        super().__init__()
        self.input = self.image_input("input")
        self.out = self.message_output("out", _Kind.EncodedFrame)
        self.bitstream = self.image_output("bitstream")
        self._profile, self._rate, self._quality, self._lossless = Profile.H264_BASELINE, 30.0, 80, False
        self._bitrate, self._keyframes = 0, 30

    def build(
        self,
        input: dai.Node.Output,
        bitrate: float = 0,
        frameRate: float = 30.0,
        profile: Any = Profile.H264_BASELINE,
        keyframeFrequency: int = 30,
        lossless: bool = False,
        quality: int = 80,
    ) -> Self:
        """Links its input and sets the profile."""
        input.link(self.input)
        self._profile, self._rate, self._quality, self._lossless = profile, float(frameRate), int(quality), lossless
        self._bitrate, self._keyframes = int(bitrate), keyframeFrequency
        return self

    def setDefaultProfilePreset(self, fps: float, profile: Any) -> None:
        """Sets the rate and the profile."""
        self._rate, self._profile = float(fps), profile

    def setProfile(self, profile: Any) -> None:
        """Sets the profile."""
        self._profile = profile

    def getProfile(self) -> Any:
        """The profile."""
        return self._profile

    def setFrameRate(self, frameRate: float) -> None:
        """The frames per second that the stream states."""
        self._rate = float(frameRate)

    def getFrameRate(self) -> float:
        """The frames per second that the stream states."""
        return self._rate

    def setQuality(self, quality: int) -> None:
        """The quality of MJPEG, 0 to 100."""
        self._quality = int(quality)

    def getQuality(self) -> int:
        """The quality of MJPEG, 0 to 100."""
        return self._quality

    def setLossless(self, lossless: bool) -> None:
        """Asks for a lossless stream, which is not simulated."""
        self._lossless = lossless

    def setBitrate(self, bitrate: int) -> None:
        """The bits per second of H.264 and H.265; 0 for the encoder's own quality."""
        self._bitrate = int(bitrate)

    def setBitrateKbps(self, bitrateKbps: int) -> None:
        """As `setBitrate`, in thousands."""
        self._bitrate = 1000 * int(bitrateKbps)

    def getBitrate(self) -> int:
        """The bits per second of H.264 and H.265."""
        return self._bitrate

    def setKeyframeFrequency(self, freq: int) -> None:
        """The number of frames from one key frame to the next."""
        self._keyframes = int(freq)

    def getKeyframeFrequency(self) -> int:
        """The number of frames from one key frame to the next."""
        return self._keyframes

    setNumBFrames = setRateControlMode = setNumFramesPool = setMaxOutputFrameSize = VirtualNode.ignore

    def work(self) -> None:
        """Encodes images until the pipeline stops."""
        encode = self._jpeg() if self._profile == Profile.MJPEG else self._video()
        while self.runs():
            image = self.input.get()
            data, profile, kind = encode(image.getCvFrame())
            if self.is_wanted(self.out):
                self.out.send(self._encoded(image, data, profile, kind))
            if self.is_wanted(self.bitstream):
                stream = dai.ImgFrame()
                stream.setMetadata(image)
                stream.setType(dai.ImgFrame.Type.BITSTREAM)
                stream.setData(data)
                self.bitstream.send(stream)

    def _video(self) -> Callable[[Image], Any]:
        if self._lossless:
            warn_once("VideoEncoder: lossless video is not simulated")
        video = Video(self._profile, self._rate, self._bitrate, self._keyframes)

        def encode(image: Image) -> Any:
            data, kind = video.encode(image)
            return data, video.profile, kind

        return encode

    def _jpeg(self) -> Callable[[Image], Any]:
        if self._lossless:
            warn_once("VideoEncoder: lossless MJPEG is not simulated; the quality is 100")
        cv2 = _opencv("VideoEncoder")
        quality = 100 if self._lossless else self._quality

        def encode(image: Image) -> Any:
            done, data = cv2.imencode(".jpg", image, [cv2.IMWRITE_JPEG_QUALITY, quality])
            if not done:
                raise Error("VideoEncoder: OpenCV could not encode the image")
            return bytes(data), _Encoded.Profile.JPEG, _Encoded.FrameType.I

        return encode

    def _encoded(self, image: dai.ImgFrame, data: Any, profile: Any, kind: Any) -> dai.EncodedFrame:
        frame = _Encoded()
        frame.setData(data)
        frame.frameSize = len(data)
        frame.setSize(image.getWidth(), image.getHeight())
        frame.setProfile(profile)
        frame.setFrameType(kind)
        frame.setQuality(self._quality)
        frame.setLossless(False)
        frame.setBitrate(self._bitrate)
        frame.setInstanceNum(image.getInstanceNum())
        frame.cam = image.cam
        frame.setTransformation(image.getTransformation())
        frame.setSequenceNum(image.getSequenceNum())
        frame.setTimestamp(image.getTimestamp())
        frame.setTimestampDevice(image.getTimestampDevice())
        return frame


class EdgeDetector(VirtualNode):
    """DepthAI's EdgeDetector: the sum of the absolute responses of two kernels, by default Sobel's."""

    Properties = getattr(dai.node.EdgeDetector, "Properties", None)

    def __init__(self) -> None:
        super().__init__()
        self.inputImage = self.image_input("inputImage")
        self.inputConfig = self.message_input("inputConfig", _Kind.EdgeDetectorConfig)
        self.outputImage, self.passthroughInputImage = self.image_output("outputImage"), self.image_output("passthroughInputImage")
        self.initialConfig = dai.EdgeDetectorConfig()

    setNumFramesPool = setMaxOutputFrameSize = VirtualNode.ignore

    def work(self) -> None:
        """Detects edges until the pipeline stops."""
        config = self.initialConfig
        while self.runs():
            image = self.inputImage.get()
            while (changed := self.inputConfig.tryGet()) is not None:
                config = changed
            data = config.getConfigData()
            grey = grey_of(image)
            response = np.abs(_filtered(grey, data.sobelFilterHorizontalKernel or _SOBEL))
            response += np.abs(_filtered(grey, data.sobelFilterVerticalKernel or _SOBEL_T))
            edges = grey_frame(np.clip(response, 0, 255).astype(np.uint8))
            edges.setMetadata(image)
            edges.setType(dai.ImgFrame.Type.GRAY8)
            edges.setStride(grey.shape[1])
            self.outputImage.send(edges)
            self.passthroughInputImage.send(image)


_SOBEL = [[1, 0, -1], [2, 0, -2], [1, 0, -1]]
_SOBEL_T = [[1, 2, 1], [0, 0, 0], [-1, -2, -1]]


def _filtered(grey: Image, kernel: Any) -> np.ndarray[Any, np.dtype[np.int32]]:
    padded = np.pad(grey.astype(np.int32), 1, mode="edge")
    height, width = grey.shape
    total = np.zeros((height, width), np.int32)
    for row in range(3):
        for column in range(3):
            total += int(kernel[row][column]) * padded[row : row + height, column : column + width]
    return total


class FeatureTracker(VirtualNode):
    """DepthAI's FeatureTracker, by OpenCV's corners and optical flow: not the algorithm of the device."""

    Properties = getattr(dai.node.FeatureTracker, "Properties", None)

    def __init__(self) -> None:
        super().__init__()
        self.inputImage = self.image_input("inputImage")
        self.inputConfig = self.message_input("inputConfig", _Kind.FeatureTrackerConfig)
        self.outputFeatures = self.message_output("outputFeatures", _Kind.TrackedFeatures)
        self.passthroughInputImage = self.image_output("passthroughInputImage")
        self.initialConfig = dai.FeatureTrackerConfig()

    setHardwareResources = VirtualNode.ignore

    def work(self) -> None:
        """Tracks features until the pipeline stops."""
        cv2 = _opencv("FeatureTracker")
        warn_once("FeatureTracker: OpenCV's corners and optical flow take the place of the device's algorithm")
        wanted = int(self.initialConfig.cornerDetector.numTargetFeatures) or 320
        before: Any = None
        points = np.zeros((0, 2), np.float32)
        names, ages = np.zeros(0, int), np.zeros(0, int)
        total = 0
        while self.runs():
            image = self.inputImage.get()
            grey = np.ascontiguousarray(grey_of(image))
            if before is not None and len(points):
                moved, found, _ = cv2.calcOpticalFlowPyrLK(before, grey, points.reshape(-1, 1, 2), None)
                kept = found.ravel() == 1
                points, names, ages = moved.reshape(-1, 2)[kept], names[kept], ages[kept] + 1
            if len(points) < wanted // 2:
                mask = np.full(grey.shape, 255, np.uint8)
                for x, y in points:
                    cv2.circle(mask, (int(x), int(y)), 8, 0, -1)
                new = cv2.goodFeaturesToTrack(grey, wanted - len(points), 0.01, 8, mask=mask)
                new = np.zeros((0, 2), np.float32) if new is None else new.reshape(-1, 2)
                points = np.concatenate([points, new])
                names = np.concatenate([names, np.arange(total, total + len(new))])
                ages = np.concatenate([ages, np.zeros(len(new), int)])
                total += len(new)
            before = grey
            self.outputFeatures.send(_tracked(image, points, names, ages))
            self.passthroughInputImage.send(image)


def _tracked(image: dai.ImgFrame, points: Any, names: Any, ages: Any) -> dai.TrackedFeatures:
    message = dai.TrackedFeatures()
    features = []
    for (x, y), name, age in zip(points, names, ages):
        feature = dai.TrackedFeature()
        feature.position = dai.Point2f(float(x), float(y))
        feature.id, feature.age = int(name), int(age)
        features.append(feature)
    message.trackedFeatures = features
    message.setSequenceNum(image.getSequenceNum())
    message.setTimestamp(image.getTimestamp())
    message.setTimestampDevice(image.getTimestampDevice())
    return message
