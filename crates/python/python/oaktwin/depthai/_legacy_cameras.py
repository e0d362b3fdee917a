"""The nodes MonoCamera and ColorCamera, which DepthAI v3 keeps for older programs."""

from __future__ import annotations

from typing import Any

import depthai as dai

from .._findings import Error
from ._camera import CameraNode, Request, Resize
from ._frames import Type
from ._node import VirtualNode

Socket = dai.CameraBoardSocket
_RealMono, _RealColor = dai.node.MonoCamera, dai.node.ColorCamera
_SIZES = {
    "THE_400_P": (640, 400),
    "THE_480_P": (640, 480),
    "THE_720_P": (1280, 720),
    "THE_800_P": (1280, 800),
    "THE_1080_P": (1920, 1080),
    "THE_1200_P": (1920, 1200),
    "THE_4_K": (3840, 2160),
    "THE_12_MP": (4056, 3040),
}
_DEFAULT_FPS = 30.0


class _LegacyCamera(CameraNode):
    """What both have in common: a socket, a resolution by its name, and a rate."""

    def __init__(self) -> None:
        super().__init__()
        self._board_socket = Socket.AUTO
        self._fps = _DEFAULT_FPS
        self._size: tuple[int, int] | None = None

    def setBoardSocket(self, boardSocket: dai.CameraBoardSocket) -> None:
        """Chooses the socket."""
        self.twin.camera(boardSocket)
        self._board_socket = boardSocket

    def getBoardSocket(self) -> dai.CameraBoardSocket:
        """The socket."""
        return self._board_socket

    def setCamera(self, name: str) -> None:
        """Chooses the camera by its name: color, left or right."""
        names = {"color": Socket.CAM_A, "rgb": Socket.CAM_A, "left": Socket.CAM_B, "right": Socket.CAM_C}
        if name not in names:
            raise RuntimeError(f"{type(self).__name__}: there is no camera {name!r}; pass color, left or right")
        self.setBoardSocket(names[name])

    def setResolution(self, resolution: Any) -> None:
        """Chooses the resolution by its name."""
        if resolution.name not in _SIZES:
            raise Error(f"{type(self).__name__}: the resolution {resolution.name} is not simulated; use {', '.join(_SIZES)}")
        self._size = _SIZES[resolution.name]

    def getResolutionSize(self) -> tuple[int, int]:
        """The resolution, (width, height) px."""
        return self._resolution()

    def getResolutionWidth(self) -> int:
        """The width of the resolution, px."""
        return self._resolution()[0]

    def getResolutionHeight(self) -> int:
        """The height of the resolution, px."""
        return self._resolution()[1]

    def setFps(self, fps: float) -> None:
        """The rate in frames per second."""
        self._fps = float(fps)

    def getFps(self) -> float:
        """The rate in frames per second."""
        return self._fps

    def _resolution(self) -> tuple[int, int]:
        return self._size or self.twin.camera(self._place())[1].size

    def _place(self) -> dai.CameraBoardSocket:
        raise NotImplementedError

    def _request(self, output: dai.Node.Output, size: tuple[int, int], kind: Any, resize: Any = Resize.CROP, still: bool = False) -> None:
        if self.is_wanted(output):
            self.requests.append(Request(output, size, kind, resize, self._fps, is_still=still))

    setNumFramesPool = setRawNumFramesPool = setIsp3aFps = setRawOutputPacked = setFrameEventFilter = VirtualNode.ignore


class MonoCamera(_LegacyCamera):
    """DepthAI's MonoCamera."""

    Properties = _RealMono.Properties

    def __init__(self) -> None:
        super().__init__()
        self.out, self.raw = self.image_output("out"), self.image_output("raw")

    def _place(self) -> dai.CameraBoardSocket:
        return Socket.CAM_B if self._board_socket == Socket.AUTO else self._board_socket

    def work(self) -> None:
        """Takes frames until the pipeline stops."""
        self.mount(self._place())
        self._request(self.out, self._resolution(), Type.RAW8)
        super().work()


class ColorCamera(_LegacyCamera):
    """DepthAI's ColorCamera: preview, video, isp and still images."""

    Properties = _RealColor.Properties

    def __init__(self) -> None:
        super().__init__()
        self.preview, self.video, self.isp = self.image_output("preview"), self.image_output("video"), self.image_output("isp")
        self.still, self.raw = self.image_output("still"), self.image_output("raw")
        self._preview_size = (300, 300)
        self._video_size: tuple[int, int] | None = None
        self._still_size: tuple[int, int] | None = None
        self._scale = (1.0, 1.0)
        self._keeps_aspect, self._is_interleaved, self._is_bgr = True, False, True

    def setPreviewSize(self, *size: Any) -> None:
        """The size of preview images, px."""
        self._preview_size = _pair(size)

    def setVideoSize(self, *size: Any) -> None:
        """The size of video images, px."""
        self._video_size = _pair(size)

    def setStillSize(self, *size: Any) -> None:
        """The size of still images, px."""
        self._still_size = _pair(size)

    def setIspScale(self, *scale: Any) -> None:
        """The scale of isp images as a fraction, or as one for each axis."""
        numbers = [one for part in scale for one in (part if isinstance(part, (tuple, list)) else (part,))]
        across = numbers[0] / numbers[1]
        self._scale = (across, numbers[2] / numbers[3] if len(numbers) == 4 else across)

    def setPreviewKeepAspectRatio(self, keep: bool) -> None:
        """Whether preview images are cropped instead of stretched."""
        self._keeps_aspect = keep

    def setInterleaved(self, interleaved: bool) -> None:
        """Whether the colours of a preview pixel follow each other."""
        self._is_interleaved = interleaved

    def setColorOrder(self, colorOrder: Any) -> None:
        """The order of the colours of preview images."""
        self._is_bgr = colorOrder.name == "BGR"

    def getPreviewSize(self) -> tuple[int, int]:
        """The size of preview images, px."""
        return self._preview_size

    def getVideoSize(self) -> tuple[int, int]:
        """The size of video images, px."""
        return self._video_size or self.getIspSize()

    def getIspSize(self) -> tuple[int, int]:
        """The size of isp images, px."""
        width, height = self._resolution()
        return round(width * self._scale[0]) // 2 * 2, round(height * self._scale[1]) // 2 * 2

    def _place(self) -> dai.CameraBoardSocket:
        return Socket.CAM_A if self._board_socket == Socket.AUTO else self._board_socket

    def work(self) -> None:
        """Takes frames until the pipeline stops."""
        self.mount(self._place())
        order = "BGR888" if self._is_bgr else "RGB888"
        kind = getattr(Type, order + ("i" if self._is_interleaved else "p"))
        self._request(self.preview, self._preview_size, kind, Resize.CROP if self._keeps_aspect else Resize.STRETCH)
        self._request(self.video, self.getVideoSize(), Type.NV12)
        self._request(self.isp, self.getIspSize(), Type.YUV420p)
        self._request(self.still, self._still_size or self.getIspSize(), Type.NV12, still=True)
        super().work()

    setIspNumFramesPool = setPreviewNumFramesPool = setVideoNumFramesPool = setStillNumFramesPool = VirtualNode.ignore


def _pair(size: tuple[Any, ...]) -> tuple[int, int]:
    width, height = size if len(size) == 2 else size[0]
    return int(width), int(height)
