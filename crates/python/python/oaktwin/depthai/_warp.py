"""The node Warp: images through a mesh of points."""

from __future__ import annotations

from typing import Any

import depthai as dai
import numpy as np
import numpy.typing as npt

from .._findings import Error
from ._frames import CAMERA_TYPES, Image, Type, colour_frame, grey_frame
from ._library import warn_once
from ._node import VirtualNode

_Interpolation = dai.Interpolation
_NEAREST = (_Interpolation.NEAREST_NEIGHBOR, _Interpolation.BYPASS)
_GREY = (Type.GRAY8, Type.RAW8)


class Warp(VirtualNode):
    """DepthAI's Warp. The points of the mesh are spread evenly over the output, and say which point of the input is seen there."""

    Properties = getattr(dai.node.Warp, "Properties", None)

    def __init__(self) -> None:
        super().__init__()
        self.inputImage, self.out = self.image_input("inputImage"), self.image_output("out")
        self._mesh: npt.NDArray[np.float64] | None = None
        self._size: tuple[int, int] | None = None
        self._interpolation = _Interpolation.AUTO
        self._engines: list[int] = []

    def setWarpMesh(self, meshData: Any, numMeshPointsX: int, numMeshPointsY: int) -> None:
        """The points of the mesh in pixels of the input, row by row."""
        points = [(one.x, one.y) if hasattr(one, "x") else tuple(one) for one in meshData]
        if numMeshPointsX < 2 or numMeshPointsY < 2 or len(points) != numMeshPointsX * numMeshPointsY:
            raise RuntimeError(f"Warp: {len(points)} points are no mesh of {numMeshPointsX}x{numMeshPointsY}; pass at least 2x2 of them")
        mesh = np.asarray(points, np.float64)
        if not np.isfinite(mesh).all():
            raise RuntimeError("Warp: the mesh contains values that are not finite; pass pixels of the input")
        self._mesh = mesh.reshape(numMeshPointsY, numMeshPointsX, 2)

    def setOutputSize(self, *size: Any) -> None:
        """The size of the output, px; by default the input's."""
        width, height = size if len(size) == 2 else size[0]
        if width <= 0 or height <= 0:
            raise RuntimeError(f"Warp: the output size {width}x{height} has no pixels")
        self._size = (int(width), int(height))

    def setInterpolation(self, interpolation: dai.Interpolation) -> None:
        """Chooses the nearest pixel, or bilinear interpolation, which also stands in for bicubic."""
        if interpolation == _Interpolation.BICUBIC:
            warn_once("Warp: bicubic interpolation is not simulated; it is bilinear")
        self._interpolation = interpolation

    def getInterpolation(self) -> dai.Interpolation:
        """The interpolation."""
        return self._interpolation

    def setHwIds(self, ids: list[int]) -> None:
        """Has no effect: there are no engines to choose."""
        self._engines = list(ids)

    def getHwIds(self) -> list[int]:
        """What was passed to `setHwIds`."""
        return self._engines

    setMaxOutputFrameSize = setNumFramesPool = VirtualNode.ignore

    def work(self) -> None:
        """Warps images until the pipeline stops."""
        maps: dict[tuple[int, int], Any] = {}
        while self.runs():
            image = self.inputImage.get()
            if image.getType() not in CAMERA_TYPES:
                raise Error(f"Warp: images of the type {image.getType().name} are not simulated; request another type")
            pixels = np.asarray(image.getCvFrame())
            size = pixels.shape[1], pixels.shape[0]
            if size not in maps:
                maps[size] = _positions(self._mesh, size, self._size or size)
            warped = _sampled(pixels, *maps[size], nearest=self._interpolation in _NEAREST)
            kind = image.getType()
            frame = grey_frame(warped, kind) if kind in _GREY or warped.ndim == 2 else colour_frame(warped[..., ::-1], kind)
            # A warped image has no intrinsics: it keeps none of the input's.
            frame.setSourceSize(*(self._size or size))
            for name in ("SequenceNum", "Timestamp", "TimestampDevice", "InstanceNum"):
                getattr(frame, f"set{name}")(getattr(image, f"get{name}")())
            frame.cam = image.cam
            self.out.send(frame)


def _positions(mesh: Any, size: tuple[int, int], output: tuple[int, int]) -> tuple[Any, Any]:
    """Where each output pixel looks in an input of a size: (H, W) x and y in pixels, with the first pixel's centre at 0."""
    if mesh is None:
        corners = [(0, 0), (size[0] - 1, 0), (0, size[1] - 1), (size[0] - 1, size[1] - 1)]
        mesh = np.array(corners, np.float64).reshape(2, 2, 2)
    rows = np.linspace(0, mesh.shape[0] - 1, output[1])
    columns = np.linspace(0, mesh.shape[1] - 1, output[0])
    top, left = np.minimum(rows.astype(int), mesh.shape[0] - 2), np.minimum(columns.astype(int), mesh.shape[1] - 2)
    down, across = (rows - top)[:, None, None], (columns - left)[None, :, None]
    upper = mesh[top][:, left] * (1 - across) + mesh[top][:, left + 1] * across
    lower = mesh[top + 1][:, left] * (1 - across) + mesh[top + 1][:, left + 1] * across
    places = upper * (1 - down) + lower * down
    return places[..., 0], places[..., 1]


def _sampled(image: Image, x: Any, y: Any, *, nearest: bool) -> Image:
    """The values of an image at positions; black outside it."""
    height, width = image.shape[:2]
    is_inside = (x > -0.5) & (x < width - 0.5) & (y > -0.5) & (y < height - 0.5)
    if nearest:
        values = image[np.clip(np.rint(y).astype(int), 0, height - 1), np.clip(np.rint(x).astype(int), 0, width - 1)]
    else:
        left = np.clip(np.floor(x).astype(int), 0, max(width - 2, 0))
        top = np.clip(np.floor(y).astype(int), 0, max(height - 2, 0))
        right, bottom = np.minimum(left + 1, width - 1), np.minimum(top + 1, height - 1)
        extra = (1,) * (image.ndim - 2)
        across, down = np.clip(x - left, 0, 1).reshape(*x.shape, *extra), np.clip(y - top, 0, 1).reshape(*y.shape, *extra)
        upper = image[top, left] * (1 - across) + image[top, right] * across
        lower = image[bottom, left] * (1 - across) + image[bottom, right] * across
        values = np.rint(upper * (1 - down) + lower * down).astype(image.dtype)
    values[~is_inside] = 0
    return np.asarray(values)
