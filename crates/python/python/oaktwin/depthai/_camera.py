"""The node Camera: images of one camera of the device."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import depthai as dai
import numpy as np

from .._cameras import Camera as Lens
from .._findings import Error
from ._capability import Capability
from ._exposure import UNIT_ISO, Shutter, expose_colour, mosaic
from ._frames import CAMERA_TYPES, Image, Type, colour_frame, grey_frame, raw_frame, resample, transformation
from ._library import warn_once
from ._node import VirtualNode

if TYPE_CHECKING:
    from typing_extensions import Self

Socket = dai.CameraBoardSocket
Resize = dai.ImgResizeMode
_DEFAULT_FPS = 30.0


@dataclass
class Request:
    """One output that a program asked for."""

    output: dai.Node.Output
    size: tuple[int, int]
    kind: dai.ImgFrame.Type
    resize: dai.ImgResizeMode = Resize.CROP
    fps: float = _DEFAULT_FPS
    undistort: bool = False
    is_still: bool = False
    # Whether a narrower image is cut out of the sensor's. Otherwise DepthAI's rule applies, by which an image of 4:3 shows more than the
    # calibrated part of a sensor that is higher.
    is_cut: bool = False


class CameraNode(VirtualNode):
    """Takes the images of one socket and sends them to the outputs that were requested: the common part of all camera nodes."""

    is_source = True

    def __init__(self) -> None:
        super().__init__()
        self.requests: list[Request] = []
        self.initialControl = dai.CameraControl()
        self.inputControl = self.message_input("inputControl", dai.DatatypeEnum.CameraControl)
        self._wants_still = False

    def mount(self, socket: dai.CameraBoardSocket) -> None:
        """Takes the images of this socket."""
        self.role, self.lens = self.twin.camera(socket)
        self.socket = socket
        self.is_of_pair = bool(self.twin.stereo_sockets and socket in self.twin.stereo_sockets)
        self.has_colour = self.twin.has_colour(socket)

    def work(self) -> None:
        """Takes frames until the pipeline stops."""
        if not self.requests:
            return
        exposure = self.twin.exposure(self.socket)
        self._wants_still = exposure.apply(self.initialControl)
        fps = max(request.fps for request in self.requests)
        schedule = self.twin.clock.schedule(fps)
        for one in self.requests:
            one.is_cut = self.is_of_pair
        device, described = self.twin.described, self._described()
        needed = [self._shows_its_image(one.output) for one in self.requests]
        frame = -1
        sent = [-1] * len(self.requests)
        while (taken := schedule.next(frame, self.runs)) is not None:
            frame = taken
            while (control := self.inputControl.tryGet()) is not None:
                self._wants_still |= exposure.apply(control)
            if not exposure.is_streaming:
                continue
            if device is not self.twin.described:
                device, described = self.twin.described, self._described()
            seconds = schedule.time(frame)
            shutter = self.twin.shutter(self.socket, seconds, frame) if any(needed) else exposure.shutter
            for index, request in enumerate(self.requests):
                # An output with a lower rate gets the frames at which its own count advances.
                count = int(frame * request.fps / fps + 1e-9)
                if count == sent[index] or (request.is_still and not self._wants_still):
                    continue
                sent[index] = count
                message = self._message(request, seconds, frame, shutter) if needed[index] else _without_image(request)
                message.setSourceSize(*request.size)
                message.setTransformation(described[index])
                self._stamp(message, seconds, frame, shutter, request.fps)
                request.output.send(message)
            self._wants_still = False

    def _described(self) -> list[dai.ImgTransformation]:
        """What the messages of each output say about their images: what the device takes for its calibration."""
        socket, origin = self.twin.origin
        lens = self.twin.described.cameras[self.role]
        return [transformation(view_of(lens, one), origin, socket) for one in self.requests]

    def _shows_its_image(self, output: dai.Node.Output) -> bool:
        """Whether anything looks at the images of an output: not if only StereoDepth receives them, which measures exact depth."""
        if self.twin.settings.engine != "stereo-noise" or output.getName() in self.queued_outputs:
            return True
        pipeline = self.getParentPipeline()
        links = [one for one in pipeline.getConnections() if one.outputId == self.id and one.outputName == output.getName()]
        return any(getattr(pipeline.getNode(one.inputId), "needs_images", True) for one in links)

    def _message(self, request: Request, seconds: float, frame: int, shutter: Shutter) -> dai.ImgFrame:
        if not self.has_colour and not request.undistort:
            grey = self._grey(request, seconds, frame, shutter)
            return raw_frame(np.left_shift(grey, 2, dtype=np.uint16)) if request.kind == Type.RAW10 else grey_frame(grey, request.kind)
        if self.twin.light.dots and self.is_of_pair:
            warn_once("Camera: undistorted images and colour images of the stereo pair do not show the dots of the projector")
        view = inner_view(self.lens, request)
        image = self.twin.shots.colour(seconds, view)
        light = self.twin.settings.ambient * shutter.light
        seed = (self.twin.settings.seed, int(self.socket), frame)
        image = expose_colour(image, light, shutter.iso / UNIT_ISO, seed)
        return raw_frame(mosaic(image)) if request.kind == Type.RAW10 else colour_frame(letterboxed(image, request), request.kind)

    def _grey(self, request: Request, seconds: float, frame: int, shutter: Shutter) -> Image:
        """The image of a camera of the stereo pair, whose imager also shows the dots of the projector."""
        # Every pair is rendered at the size that is cropped; what is scaled in another way, from the full image.
        is_cropped = request.resize == Resize.CROP
        size = cover_size(self.lens, request.size) if is_cropped else self.lens.size
        grey: Image = self.twin.shots.pair(seconds, frame, size, shutter)[self.role]
        if is_cropped:
            (width, height), (left, top) = request.size, corner(size, request.size)
            return grey[top : top + height, left : left + width]
        inner = inner_view(self.lens, request)
        return letterboxed(resample(grey, inner.width, inner.height), request)

    def _stamp(self, message: dai.ImgFrame, seconds: float, frame: int, shutter: Shutter, fps: float) -> None:
        self.twin.clock.stamp(message, seconds, frame)
        message.setInstanceNum(int(self.socket))
        message.cam.exposureTimeUs = round(shutter.time_us)
        message.cam.sensitivityIso = round(shutter.iso)
        message.cam.fps = fps
        message.cam.wbColorTemp = 5000
        message.cam.lensPosition = 0


def _without_image(request: Request) -> dai.ImgFrame:
    """The message of an output whose pixels nobody looks at: its size and type, without an image."""
    message = dai.ImgFrame()
    message.setSize(*request.size)
    message.setType(request.kind)
    return message


def view_of(lens: Lens, request: Request) -> Lens:
    """The camera of the images of an output, after resizing, and without distortion where it was requested."""
    inner = inner_view(lens, request)
    if request.resize != Resize.LETTERBOX:
        return inner
    matrix = inner.K.copy()
    left, top = (request.size[0] - inner.width) // 2, (request.size[1] - inner.height) // 2
    matrix[0, 2] += left
    matrix[1, 2] += top
    return _rebuilt(inner, request.size, matrix)


def cover_size(lens: Lens, size: tuple[int, int]) -> tuple[int, int]:
    """The size of the whole image, scaled so that it covers an output of this size."""
    scale = max(size[0] / lens.width, size[1] / lens.height)
    return max(round(lens.width * scale), size[0]), max(round(lens.height * scale), size[1])


def corner(whole: tuple[int, int], part: tuple[int, int]) -> tuple[int, int]:
    """The upper left corner of a part in the middle of an image."""
    return (whole[0] - part[0]) // 2, (whole[1] - part[1]) // 2


def cut(camera: Lens, size: tuple[int, int]) -> Lens:
    """The camera of the middle of an image that is scaled to cover an output of this size."""
    whole = cover_size(camera, size)
    return camera.resized(*whole, rule="depthai", keep_aspect_ratio=False).cropped(*corner(whole, size), *size)


def inner_view(lens: Lens, request: Request) -> Lens:
    """The camera of the part of an output's image that shows the scene: all but the bars of a letterbox."""
    width, height = request.size
    if request.resize == Resize.CROP and request.is_cut:
        view = cut(lens, request.size)
    elif request.resize == Resize.CROP:
        view = lens.resized(width, height, rule="depthai")
    elif request.resize == Resize.STRETCH:
        view = lens.resized(width, height, rule="depthai", keep_aspect_ratio=False)
    else:
        scale = min(width / lens.width, height / lens.height)
        view = lens.resized(max(round(lens.width * scale), 1), max(round(lens.height * scale), 1), rule="depthai", keep_aspect_ratio=False)
    return _rebuilt(view, view.size, view.K, pinhole=True) if request.undistort else view


def _rebuilt(camera: Lens, size: tuple[int, int], matrix: Any, *, pinhole: bool = False) -> Lens:
    has_lens = not pinhole and camera.lens != "pinhole"
    return Lens(
        size,
        K=matrix,
        distortion=camera.distortion if has_lens else None,
        lens=camera.lens if has_lens else "pinhole",  # type: ignore[arg-type]
        body_from_camera=camera.body_from_camera,
        name=camera.name,
    )


def letterboxed(image: Image, request: Request) -> Image:
    """An image with the black bars of its output."""
    width, height = request.size
    if image.shape[1::-1] == (width, height):
        return image
    framed = np.zeros((height, width, *image.shape[2:]), image.dtype)
    left, top = (width - image.shape[1]) // 2, (height - image.shape[0]) // 2
    framed[top : top + image.shape[0], left : left + image.shape[1]] = image
    return framed


class Camera(CameraNode):
    """DepthAI's Camera: `build`, then outputs of any size and type."""

    Properties = getattr(dai.node.Camera, "Properties", None)

    def __init__(self) -> None:
        super().__init__()
        self.raw = self.image_output("raw")
        self.mockIsp = self.image_input("mockIsp", blocking=False)
        self.is_built = False
        self._fps: float | None = None

    def build(
        self,
        boardSocket: dai.CameraBoardSocket = Socket.AUTO,
        sensorResolution: tuple[int, int] | None = None,
        sensorFps: float | None = None,
        replayNode: object = None,
    ) -> Self:
        """Chooses the socket, by default the first one that has a camera."""
        if self.is_built:
            raise RuntimeError("Camera node is already built")
        if replayNode is not None or not isinstance(boardSocket, Socket):
            raise Error("Camera: a replay node cannot be its source here; leave it out, so that it sees the scene")
        if boardSocket == Socket.AUTO:
            boardSocket = next(iter(self.twin.cameras))
        self.mount(boardSocket)
        if sensorResolution is not None and tuple(sensorResolution) != self.lens.size:
            warn_once(f"Camera: the sensor keeps its mode of {self.lens.width}x{self.lens.height}; sensorResolution has no effect")
        self._fps = sensorFps
        self.is_built = True
        return self

    def setBoardSocket(self, boardSocket: dai.CameraBoardSocket) -> Self:
        """Chooses the socket, as `build` does."""
        return self.build(boardSocket)

    def getBoardSocket(self) -> dai.CameraBoardSocket:
        """The socket."""
        self._require_built("calling getBoardSocket()")
        return self.socket

    def requestOutput(self, *arguments: Any, **named: Any) -> dai.Node.Output:
        """An output with a size, or with a capability."""
        self._require_built("requesting outputs from it")
        first = arguments[0] if arguments else named.get("capability", named.get("size"))
        if isinstance(first, Capability):
            return self._add(*first.read(self.lens.size))
        names = ("size", "type", "resizeMode", "fps", "enableUndistortion", "alphaScaling")
        return self._add(**{**dict(zip(names, arguments)), **named})

    def requestFullResolutionOutput(
        self, type: dai.ImgFrame.Type | None = None, fps: float | None = None, useHighestResolution: bool = False
    ) -> dai.Node.Output:
        """An output of the size of the camera's images. Without `useHighestResolution`, at most 5000 px wide, as on the device."""
        self._require_built("requesting outputs from it")
        return self._add(self.lens.size, type, fps=fps)

    def requestIspOutput(self, fps: float | None = None) -> dai.Node.Output:
        """An output of the size of the camera's images, without undistortion."""
        self._require_built("requesting outputs from it")
        return self._add(self.lens.size, None, fps=fps)

    def _require_built(self, before: str) -> None:
        if not self.is_built:
            raise RuntimeError(f"Camera node must be built before {before}")

    def _add(
        self,
        size: tuple[int, int],
        type: dai.ImgFrame.Type | None = None,
        resizeMode: dai.ImgResizeMode = Resize.CROP,
        fps: float | None = None,
        enableUndistortion: bool | None = None,
        alphaScaling: float | None = None,
    ) -> dai.Node.Output:
        width, height = (int(value) for value in size)
        if width <= 0 or height <= 0:
            raise RuntimeError(f"Camera: the size {width}x{height} has no pixels")
        kind = type if type is not None else Type.NV12 if self.has_colour else Type.GRAY8
        if kind not in CAMERA_TYPES:
            raise RuntimeError(f"Camera: the type {kind.name} is not one that a camera sends")
        if kind in (Type.NV12, Type.YUV420p) and (width % 2 or height % 2):
            raise RuntimeError(f"Camera: images of the type {kind.name} have even sizes, and {width}x{height} is not")
        if alphaScaling is not None:
            warn_once("Camera: alphaScaling is not simulated; undistorted images keep the focal length")
        rate = float(fps or self._fps or _DEFAULT_FPS)
        output = self.image_output(f"dyn{len(self.requests)}")
        self.requests.append(Request(output, (width, height), kind, resizeMode, rate, bool(enableUndistortion)))
        return output

    def work(self) -> None:
        """Takes frames until the pipeline stops; `raw` has the values before any processing."""
        if self.is_wanted(self.raw):
            self.requests.append(Request(self.raw, self.lens.size, Type.RAW10, fps=self._fps or _DEFAULT_FPS))
        super().work()

    def getMaxWidth(self) -> int:
        """The width of the camera's images, px."""
        self._require_built("calling getMaxWidth()")
        return self.lens.width

    def getMaxHeight(self) -> int:
        """The height of the camera's images, px."""
        self._require_built("calling getMaxHeight()")
        return self.lens.height

    def getMaxRequestedFps(self) -> float:
        """The highest rate of its outputs."""
        return max((one.fps for one in self.requests), default=_DEFAULT_FPS)

    def getMaxRequestedWidth(self) -> int:
        """The largest width of its outputs, px."""
        return max((one.size[0] for one in self.requests), default=0)

    def getMaxRequestedHeight(self) -> int:
        """The largest height of its outputs, px."""
        return max((one.size[1] for one in self.requests), default=0)

    def getSensorType(self) -> dai.CameraSensorType:
        """Whether the sensor has colour filters."""
        return dai.CameraSensorType.COLOR if self.has_colour else dai.CameraSensorType.MONO

    def setSensorType(self, sensorType: dai.CameraSensorType) -> Self:
        """Has no effect: the twin knows its sensor."""
        return self

    def setImageOrientation(self, imageOrientation: dai.CameraImageOrientation) -> Self:
        """Only the normal orientation is simulated."""
        if imageOrientation not in (dai.CameraImageOrientation.AUTO, dai.CameraImageOrientation.NORMAL):
            raise Error("Camera: images are not turned or mirrored here; use ImageManip for that")
        return self

    def _pools(self, *_: int, **__: int) -> Self:
        """Accepts the size of a pool of buffers, which has no meaning here."""
        return self

    setNumFramesPools = setRawNumFramesPool = setIspNumFramesPool = setOutputsNumFramesPool = _pools
    setMaxSizePools = setMaxSizePoolRaw = setMaxSizePoolIsp = setOutputsMaxSizePool = _pools
