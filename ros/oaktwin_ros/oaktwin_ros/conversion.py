"""Conversion between messages and NumPy arrays, without rclpy: any classes with the fields of ROS's messages will do.

Functions that make messages return their fields except the header, as keyword arguments of a message class.
"""

from __future__ import annotations

from typing import Any

import numpy as np

DEPTH = {"32FC1": np.dtype("f4"), "16UC1": np.dtype("u2"), "mono16": np.dtype("u2")}
COLORS = {
    "rgb8": [0, 1, 2],
    "8UC3": [0, 1, 2],
    "bgr8": [2, 1, 0],
    "rgba8": [0, 1, 2],
    "bgra8": [2, 1, 0],
    "mono8": [0, 0, 0],
    "8UC1": [0, 0, 0],
}
CHANNELS = {"rgba8": 4, "bgra8": 4, "mono8": 1, "8UC1": 1}
LENSES = {"plumb_bob": "opencv", "rational_polynomial": "opencv", "equidistant": "fisheye"}
FLOAT32 = 7


def _pixels(message: Any, dtype: np.dtype, channels: int) -> np.ndarray:
    """The pixels (H, W, channels) of a message, a view of its data."""
    width, height, step = message.width, message.height, message.step
    if width == 0 or height == 0:
        raise ValueError(f"width, height: an image of {width}x{height} has no pixels; publish images with pixels")
    row = width * channels * dtype.itemsize
    if step < row:
        raise ValueError(f"step: {step} bytes for rows of {row}; set step to the number of bytes from one row to the next")
    data = np.frombuffer(message.data, np.uint8)
    needed = step * (height - 1) + row
    if len(data) < needed:
        raise ValueError(f"data: {len(data)} bytes instead of {needed} for {width}x{height}; publish whole images")
    # The bytes after the last row are optional.
    rows = np.lib.stride_tricks.as_strided(data, (height, row), (step, 1), writeable=False)
    order = dtype.newbyteorder(">" if message.is_bigendian else "<")
    return np.ascontiguousarray(rows).view(order).reshape(height, width, channels)


def depth(message: Any) -> np.ndarray:
    """The depth of a sensor_msgs/Image: (H, W) float32 metres of 32FC1, uint16 millimetres of 16UC1."""
    dtype = DEPTH.get(message.encoding)
    if dtype is None:
        raise ValueError(
            f"encoding: '{message.encoding[:40]}' is not an encoding of depth; publish 32FC1 (metres) or 16UC1 (millimetres)"
        )
    return _pixels(message, dtype, 1)[..., 0].astype(dtype, copy=False)


def color(message: Any) -> np.ndarray:
    """The colours of a sensor_msgs/Image: (H, W, 3) uint8."""
    order = COLORS.get(message.encoding)
    if order is None:
        raise ValueError(
            f"encoding: '{message.encoding[:40]}' is not an encoding of 8-bit colours; publish rgb8, bgr8, rgba8, bgra8 or mono8"
        )
    pixels = _pixels(message, np.dtype("u1"), CHANNELS.get(message.encoding, 3))
    return np.ascontiguousarray(pixels[..., order])


def camera(message: Any) -> dict[str, Any]:
    """The arguments of an oaktwin.Camera for a sensor_msgs/CameraInfo: size, K and the lens."""
    size = (message.width, message.height)
    roi = message.roi
    is_whole = (roi.width, roi.height) in ((0, 0), size)
    if message.binning_x > 1 or message.binning_y > 1 or not is_whole or roi.x_offset or roi.y_offset:
        raise ValueError(
            "binning_x, binning_y, roi: describe another image than the published one; publish the camera info of the image "
            "itself, without binning and region"
        )
    matrix = np.array(message.k, float).reshape(3, 3)
    if not (np.isfinite(matrix).all() and matrix[0, 0] > 0 and matrix[1, 1] > 0):
        raise ValueError(f"k: invalid camera matrix {matrix.tolist()}; publish the intrinsics of the depth image")
    found = {"size": size, "K": matrix}
    coefficients = [float(number) for number in message.d]
    if any(coefficients):
        lens = LENSES.get(message.distortion_model)
        if lens is None:
            raise ValueError(
                f"distortion_model: '{message.distortion_model[:40]}' is unknown; expected plumb_bob, rational_polynomial or "
                "equidistant"
            )
        found |= {"distortion": coefficients, "lens": lens}
    return found


def nanoseconds(stamp: Any) -> int:
    """The time of a builtin_interfaces/Time."""
    if stamp.sec < 0 or stamp.nanosec >= 10**9:
        raise ValueError(f"header.stamp: {stamp.sec} s and {stamp.nanosec} ns are no time; publish the time since the epoch")
    return stamp.sec * 10**9 + stamp.nanosec


def depth_fields(measured: np.ndarray) -> dict[str, Any]:
    """The fields of a sensor_msgs/Image of measured depth (H, W): 16UC1 of uint16 millimetres, or 32FC1 of float32 metres, in
    which NaN is what was not measured (REP-118).
    """
    height, width = measured.shape
    if measured.dtype == np.uint16:
        encoding, little = "16UC1", measured.astype("<u2")
    else:
        encoding, little = "32FC1", np.where(measured > 0, measured, np.nan).astype("<f4")
    return {
        "height": height,
        "width": width,
        "encoding": encoding,
        "is_bigendian": 0,
        "step": width * little.itemsize,
        "data": np.frombuffer(little.tobytes(), np.uint8),
    }


def millimetres(metres: np.ndarray) -> np.ndarray:
    """Depth in uint16 millimetres, 0 where it is not measured or beyond 65.535 m."""
    rounded = np.round(metres * np.float32(1000))
    return np.where((rounded > 0) & (rounded < 65536), rounded, 0).astype(np.uint16)


def info_fields(size: tuple[int, int], matrix: np.ndarray) -> dict[str, Any]:
    """The fields of a sensor_msgs/CameraInfo of an image without distortion."""
    width, height = size
    return {
        "height": height,
        "width": width,
        "distortion_model": "plumb_bob",
        "d": np.zeros(5),
        "k": np.asarray(matrix, float).ravel(),
        "r": np.eye(3).ravel(),
        "p": np.hstack([matrix, np.zeros((3, 1))]).ravel(),
        "binning_x": 0,
        "binning_y": 0,
    }


def cloud(metres: np.ndarray, matrix: np.ndarray) -> np.ndarray:
    """The points (H, W, 3) of depth in metres, float32 in the optical frame; NaN where nothing was measured."""
    height, width = metres.shape
    x = (np.arange(width, dtype=np.float32) - np.float32(matrix[0, 2])) / np.float32(matrix[0, 0])
    y = (np.arange(height, dtype=np.float32)[:, None] - np.float32(matrix[1, 2])) / np.float32(matrix[1, 1])
    z = np.where(metres > 0, metres, np.nan).astype(np.float32)
    return np.stack([x * z, y * z, z], -1)


def cloud_fields(points: np.ndarray, point_field: Any) -> dict[str, Any]:
    """The fields of a sensor_msgs/PointCloud2, whose fields are of the class `point_field`."""
    height, width, _ = points.shape
    names = enumerate("xyz")
    return {
        "height": height,
        "width": width,
        "fields": [point_field(name=name, offset=4 * at, datatype=FLOAT32, count=1) for at, name in names],
        "is_bigendian": False,
        "point_step": 12,
        "row_step": 12 * width,
        "data": np.frombuffer(points.astype("<f4").tobytes(), np.uint8),
        "is_dense": bool(np.isfinite(points).all()),
    }
