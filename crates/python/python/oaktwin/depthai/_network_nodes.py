"""The nodes NeuralNetwork, DetectionNetwork and NeuralDepth, which run networks of the user's."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import depthai as dai
import numpy as np
import numpy.typing as npt

from .._cameras import Camera as Lens
from .._findings import Error
from .._sensors import StereoMatcher
from ._camera import CameraNode, Resize
from ._frames import Image, Type, depth_frame, grey_frame, grey_of, resample, transformation
from ._network import Network, chosen, pixels_of
from ._node import VirtualNode
from ._script import Ports
from ._stereo import synchronized

if TYPE_CHECKING:
    from typing_extensions import Self

_Kind = dai.DatatypeEnum
_real_input_size = dai.node.NeuralDepth.getInputSize
# The fractions of a disparity's pixel in its message, as for StereoDepth with three bits.
_DISPARITY_SCALE = 8


class NeuralNetwork(VirtualNode):
    """DepthAI's NeuralNetwork: an ONNX network that takes images with values from 0 to 255, in the order blue, green, red."""

    Properties = getattr(dai.node.NeuralNetwork, "Properties", None)

    def __init__(self) -> None:
        super().__init__()
        self.input = self.image_input("input")
        self.inputs = Ports(lambda name: self.image_input(name))
        self.out, self.passthrough = self.message_output("out", _Kind.NNData), self.image_output("passthrough")
        self.passthroughs = Ports(lambda name: self.image_output(f"passthrough_{name}"))
        self._model: Any = None
        self._loaded: Network | None = None

    def build(self, input: Any, model: Any = None, fps: float | None = None, resizeMode: Any = None, **named: Any) -> Self:
        """Links a camera, of which images of the network's size are requested, or an output, and chooses the network of a model."""
        self._model = named.get("nnArchive", model)
        if not isinstance(input, CameraNode):
            input.link(self.input)
            return self
        port = self.network.inputs[0]
        if port.size is None:
            raise Error(f"{type(self).__name__}: the network takes images of any size; request an output of the camera, and pass that")
        kind = Type.GRAY8 if port.channels == 1 else Type.BGR888p
        input.requestOutput(port.size, kind, resizeMode or Resize.CROP, fps).link(self.input)  # type: ignore[attr-defined]
        return self

    def _set_model(self, model: Any, *_: Any, **__: Any) -> None:
        self._model = model

    setNNArchive = setFromModelZoo = setModelFromDeviceZoo = setModelPath = setBlob = setBlobPath = setOtherModelFormat = _set_model
    setBackend = setBackendProperties = setNumInferenceThreads = setNumNCEPerInferenceThread = VirtualNode.ignore
    setNumPoolFrames = setNumShavesPerInferenceThread = VirtualNode.ignore

    def getNumInferenceThreads(self) -> int:
        """A constant: one image is processed at a time."""
        return 1

    @property
    def network(self) -> Network:
        """The network, which is opened when it is first needed."""
        if self._loaded is None:
            self._loaded = chosen(self.twin.settings.networks, type(self).__name__, self._model)
        return self._loaded

    def work(self) -> None:
        """Runs the network until the pipeline stops."""
        network = self.network
        ports = [self.inputs[port.name] for port in network.inputs] if self.inputs else [self.input]
        while self.runs():
            images = [port.get() for port in ports]
            found = network.run([pixels_of(image) for image in images])
            self._send(images, found)
            for name, image in zip(self.inputs, images):
                self.passthroughs[name].send(image)
            self.passthrough.send(images[0])

    def _send(self, images: list[Any], found: dict[str, Any]) -> None:
        self.out.send(_tensors(images[0], found))


class DetectionNetwork(NeuralNetwork):
    """DepthAI's DetectionNetwork, for networks whose first output has rows of six numbers (xmin, ymin, xmax, ymax in pixels of the network's
    input, confidence, class), as Ultralytics exports them with `nms=True`, or of seven as MobileNet-SSD does (image, class, confidence and
    corners from 0 to 1).
    """

    Properties = None

    def __init__(self) -> None:
        super().__init__()
        self.out = self.message_output("detections", _Kind.ImgDetections)
        self.outNetwork = self.message_output("outNetwork", _Kind.NNData)
        self._threshold = 0.5

    @property
    def neuralNetwork(self) -> Self:
        """The node itself."""
        return self

    def setConfidenceThreshold(self, thresh: float) -> None:
        """The smallest confidence of a detection that is sent."""
        self._threshold = float(thresh)

    def getConfidenceThreshold(self) -> float:
        """The smallest confidence of a detection that is sent."""
        return self._threshold

    def getClasses(self) -> list[str] | None:
        """The names of the classes, if the network states them."""
        return self.network.labels

    def _send(self, images: list[Any], found: dict[str, Any]) -> None:
        if self.is_wanted(self.outNetwork):
            self.outNetwork.send(_tensors(images[0], found))
        rows = next(iter(found.values()))
        rows = rows.reshape(-1, rows.shape[-1]) if rows.ndim else rows
        if rows.ndim != 2 or rows.shape[1] not in (6, 7):
            shape = next(iter(found.values())).shape
            raise Error(
                f"{self.network.path}: DetectionNetwork: its first output has the shape {shape}; rows of 6 or 7 numbers are simulated: "
                "export it with non-maximum suppression, for example with nms=True"
            )
        size = images[0].getWidth(), images[0].getHeight()
        self.out.send(_detections(images[0], rows, size, self._threshold, self.network.labels))


def _detections(image: Any, rows: Any, size: tuple[int, int], threshold: float, labels: list[str] | None) -> dai.ImgDetections:
    message = dai.ImgDetections()
    detections = []
    for row in rows:
        if len(row) == 6:
            corners, confidence, label = row[:4] / [*size, *size], row[4], row[5]
        else:
            # The first row that belongs to no image ends the list.
            if row[0] < 0:
                break
            label, confidence, corners = row[1], row[2], row[3:]
        if confidence < threshold or confidence <= 0:
            continue
        one = dai.ImgDetection()
        one.xmin, one.ymin, one.xmax, one.ymax = (float(np.clip(value, 0, 1)) for value in corners)
        one.confidence, one.label = float(confidence), int(label)
        if labels is not None and one.label < len(labels):
            one.labelName = labels[one.label]
        detections.append(one)
    message.detections = detections
    message.setTransformation(image.getTransformation())
    _time(message, image)
    return message


def _tensors(image: Any, found: dict[str, Any]) -> dai.NNData:
    data = dai.NNData()
    for name, value in found.items():
        data.addTensor(name, value)
    data.setTransformation(image.getTransformation())
    _time(data, image)
    return data


def _time(message: Any, image: Any) -> None:
    message.setSequenceNum(image.getSequenceNum())
    message.setTimestamp(image.getTimestamp())
    message.setTimestampDevice(image.getTimestampDevice())


class NeuralDepth(VirtualNode):
    """DepthAI's NeuralDepth, for networks with two inputs, the rectified left and right image, whose first output is the disparity of the left
    image in pixels of the input.
    """

    Properties = getattr(dai.node.NeuralDepth, "Properties", None)

    def __init__(self) -> None:
        super().__init__()
        if self.twin.stereo_sockets is None:
            raise Error(f"NeuralDepth: {self.twin.device.name} has no stereo pair; choose a model with one, such as OAK4-D")
        self.left, self.right = self.image_input("left"), self.image_input("right")
        self.inputConfig = self.message_input("inputConfig", _Kind.NeuralDepthConfig)
        self.depth, self.disparity = self.image_output("depth"), self.image_output("disparity")
        self.confidence, self.edge = self.image_output("confidence"), self.image_output("edge")
        self.rectifiedLeft, self.rectifiedRight = self.image_output("rectifiedLeft"), self.image_output("rectifiedRight")
        self.initialConfig = dai.NeuralDepthConfig()
        self._model: Any = None
        self._rectifies = True

    def build(self, leftInput: Any, rightInput: Any, model: Any = None) -> Self:
        """Links the images, and chooses the network of a model."""
        leftInput.link(self.left)
        rightInput.link(self.right)
        self._model = model
        return self

    @staticmethod
    def getInputSize(model: Any) -> tuple[int, int]:
        """The size of the images of a model of the device's, (width, height) px."""
        return _real_input_size(model)

    def setRectification(self, enable: bool) -> Self:
        """Whether images are rectified first."""
        self._rectifies = enable
        return self

    def work(self) -> None:
        """Measures pairs until the pipeline stops."""
        network = chosen(self.twin.settings.networks, "NeuralDepth", self._model)
        for output in (self.confidence, self.edge):
            if self.is_wanted(output):
                raise Error(f"NeuralDepth: the output {output.getName()} is not simulated; use depth or disparity")
        matcher = StereoMatcher(self.twin.described, raw=None if self._rectifies else False, engine=_StereoNetwork(network))
        while self.runs():
            left, right = synchronized(self.left, self.right)
            found = matcher(grey_of(left), grey_of(right))
            for output, values in ((self.depth, 1000 * found["depth"]), (self.disparity, _DISPARITY_SCALE * found["disparity"])):
                if self.is_wanted(output):
                    self._deliver(output, depth_frame(np.clip(np.round(values), 0, 65535).astype(np.uint16)), matcher.camera, left)
            for output, image in ((self.rectifiedLeft, found["rectified_left"]), (self.rectifiedRight, found["rectified_right"])):
                if self.is_wanted(output):
                    self._deliver(output, grey_frame(image), matcher.camera, left)

    def _deliver(self, output: dai.Node.Output, frame: dai.ImgFrame, camera: Lens, source: dai.ImgFrame) -> None:
        socket, origin = self.twin.origin
        frame.setSourceSize(camera.width, camera.height)
        frame.setTransformation(transformation(camera, origin, socket))
        frame.setInstanceNum(source.getInstanceNum())
        _time(frame, source)
        output.send(frame)


class _StereoNetwork:
    """A network as an engine of `oaktwin.StereoMatcher`."""

    name = "NeuralDepth"

    def __init__(self, network: Network) -> None:
        self.network = network

    def __call__(self, left: Image, right: Image) -> npt.NDArray[np.float32]:
        """The disparity of the left image, px."""
        height, width = left.shape
        size = self.network.inputs[0].size or (width, height)
        found = next(iter(self.network.run([resample(left, *size), resample(right, *size)]).values())).squeeze()
        if found.shape != size[::-1]:
            raise Error(f"{self.network.path}: NeuralDepth: its first output has the shape {found.shape}, not {size[::-1]}; it must be the disparity")
        if size == (width, height):
            return found
        # To the nearest pixel, so that no disparity lies between a foreground and its background.
        rows, columns = (np.arange(height) * size[1]) // height, (np.arange(width) * size[0]) // width
        scaled: npt.NDArray[np.float32] = found[rows][:, columns] * np.float32(width / size[0])
        return scaled
