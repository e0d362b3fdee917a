"""DepthAI's image messages, and the transformation that tells its nodes what a pixel sees."""

from __future__ import annotations

from typing import Any

import depthai as dai
import numpy as np
import numpy.typing as npt

from .._cameras import Camera
from .._findings import Error

Image = npt.NDArray[Any]
Type = dai.ImgFrame.Type
# What `Camera.requestOutput` delivers, as on the device.
CAMERA_TYPES = (Type.NV12, Type.BGR888p, Type.BGR888i, Type.RGB888p, Type.RGB888i, Type.GRAY8, Type.YUV420p, Type.RAW8)
_MODELS = {"pinhole": dai.CameraModel.Perspective, "opencv": dai.CameraModel.Perspective, "fisheye": dai.CameraModel.Fisheye}


def transformation(camera: Camera, origin: Camera, socket: dai.CameraBoardSocket) -> dai.ImgTransformation:
    """The transformation of images of a camera: its intrinsics, lens and size.

    origin: the camera to whose frame its extrinsics lead, in centimetres.
    socket: the socket of the origin.
    """
    coefficients = [float(value) for value in camera.distortion]
    model = _MODELS[camera.lens]
    if model == dai.CameraModel.Perspective:
        coefficients += [0.0] * (14 - len(coefficients))
    origin_from_camera = np.linalg.inv(np.asarray(origin.body_from_camera)) @ np.asarray(camera.body_from_camera)
    origin_from_camera[:3, 3] *= 100.0
    extrinsics = dai.Extrinsics(origin_from_camera.tolist(), socket, dai.LengthUnit.CENTIMETER)
    return dai.ImgTransformation(camera.width, camera.height, camera.K.tolist(), model, coefficients, extrinsics)


def camera_of(frame: dai.ImgFrame, origin: Camera, name: str = "frame") -> Camera:
    """The camera of an image: what its transformation says. The inverse of `transformation`."""
    is_described: Any = frame.getTransformation()
    if not is_described.isValid():
        raise Error(f"{name}: the image has no transformation; align to the output of a camera")
    matrix = np.asarray(is_described.getIntrinsicMatrix(), np.float64)
    fisheye = is_described.getDistortionModel() == dai.CameraModel.Fisheye
    coefficients = np.asarray(is_described.getDistortionCoefficients(), np.float64)
    lens = "fisheye" if fisheye else "opencv" if coefficients.any() else "pinhole"
    pose = np.asarray(is_described.getExtrinsics().getTransformationMatrix(), np.float64)
    pose[:3, 3] /= 100.0
    return Camera(
        is_described.getSize(),
        K=matrix,
        distortion=None if lens == "pinhole" else coefficients[: 4 if fisheye else 14],
        lens=lens,  # type: ignore[arg-type]
        body_from_camera=np.asarray(origin.body_from_camera) @ pose,
        name=name,
    )


def colour_frame(rgb: Image, kind: dai.ImgFrame.Type) -> dai.ImgFrame:
    """An image message of an sRGB image (H, W, 3) uint8, in the requested type."""
    frame = dai.ImgFrame()
    if kind in (Type.GRAY8, Type.RAW8):
        return grey_frame(luma(rgb), kind)
    frame.setCvFrame(np.ascontiguousarray(rgb[..., ::-1]), kind)
    return frame


def grey_frame(grey: Image, kind: dai.ImgFrame.Type = Type.GRAY8) -> dai.ImgFrame:
    """An image message of a grey image (H, W) uint8, in the requested type."""
    frame = dai.ImgFrame()
    if kind in (Type.GRAY8, Type.RAW8):
        frame.setCvFrame(np.ascontiguousarray(grey), kind)
    else:
        frame.setCvFrame(np.repeat(grey[..., None], 3, axis=2), kind)
    return frame


def raw_frame(values: npt.NDArray[np.uint16]) -> dai.ImgFrame:
    """An image message of raw values (H, W) from 0 to 1023, packed like MIPI's RAW10: four pixels in five bytes, the last of which has the
    lowest bits. As in DepthAI, the stride counts pixels.
    """
    height, width = values.shape
    groups = values.reshape(-1, 4)
    packed = np.empty((len(groups), 5), np.uint8)
    packed[:, :4] = groups >> 2
    packed[:, 4] = ((groups & 3) << np.arange(0, 8, 2, dtype=np.uint16)).sum(axis=1)
    frame = dai.ImgFrame()
    frame.setSize(width, height)
    frame.setType(Type.RAW10)
    frame.setStride(width)
    frame.setData(packed.tobytes())
    return frame


def depth_frame(millimetres: npt.NDArray[np.uint16]) -> dai.ImgFrame:
    """An image message of depth or of subpixel disparity, (H, W) uint16."""
    frame = dai.ImgFrame()
    frame.setCvFrame(np.ascontiguousarray(millimetres), Type.RAW16)
    return frame


def luma(rgb: Image) -> Image:
    """The luma (BT.601) of an sRGB image, (H, W) uint8."""
    weights: Any = rgb[..., 0] * np.uint32(77) + rgb[..., 1] * np.uint32(150) + rgb[..., 2] * np.uint32(29)
    shifted: Image = np.right_shift(weights + np.uint32(128), 8).astype(np.uint8)
    return shifted


def resample(image: Image, width: int, height: int) -> Image:
    """An image at another size, each axis scaled on its own, by bilinear interpolation at pixel centres."""
    rows = np.clip((np.arange(height) + 0.5) * image.shape[0] / height - 0.5, 0, image.shape[0] - 1)
    columns = np.clip((np.arange(width) + 0.5) * image.shape[1] / width - 0.5, 0, image.shape[1] - 1)
    top, left = rows.astype(int), columns.astype(int)
    bottom, right = np.minimum(top + 1, image.shape[0] - 1), np.minimum(left + 1, image.shape[1] - 1)
    extra = (1,) * (image.ndim - 2)
    down, across = (rows - top).reshape(-1, 1, *extra), (columns - left).reshape(1, -1, *extra)
    upper = image[top][:, left] * (1 - across) + image[top][:, right] * across
    lower = image[bottom][:, left] * (1 - across) + image[bottom][:, right] * across
    return np.asarray(np.round(upper * (1 - down) + lower * down)).astype(image.dtype)


def grey_of(frame: dai.ImgFrame) -> Image:
    """The grey image (H, W) uint8 of a message, colours as luma."""
    if frame.getType() in (Type.GRAY8, Type.RAW8):
        return np.asarray(frame.getFrame())
    image = np.asarray(frame.getCvFrame())
    return image if image.ndim == 2 else luma(image[..., ::-1])
