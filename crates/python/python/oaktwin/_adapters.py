"""Cameras of other libraries, recognized by their attributes: nothing is imported."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from ._cameras import Camera
from ._findings import Error

# The coefficients of the models of sensor_msgs/CameraInfo.
_ROS_MODELS = {"plumb_bob": ("opencv", 5), "rational_polynomial": ("opencv", 8), "equidistant": ("fisheye", 4)}

# The side of a pixel on the sensor of a camera for MuJoCo, metres. It does not affect the image.
_PITCH_M = 3e-6


def from_ros(info: Any) -> Camera:
    """`Camera.from_ros`."""

    def field(name: str) -> Any:
        for key in (name, name.upper()):
            if isinstance(info, Mapping):
                if key in info:
                    return info[key]
            elif hasattr(info, key):
                return getattr(info, key)
        raise Error(f"info: has no {name}; pass a sensor_msgs/CameraInfo, or a mapping with its fields")

    model, coefficients = str(field("distortion_model")), np.asarray(field("d"), np.float64).ravel()
    size, matrix = (int(field("width")), int(field("height"))), np.asarray(field("k"), np.float64).reshape(3, 3)
    if not coefficients.any() and model != "equidistant":
        return Camera(size, K=matrix)
    if model not in _ROS_MODELS:
        raise Error(f"info: distortion_model: '{model}' is unknown; expected one of {', '.join(_ROS_MODELS)}")
    lens = "fisheye" if model == "equidistant" else "opencv"
    return Camera(size, K=matrix, distortion=coefficients, lens=lens)  # type: ignore[arg-type]


def to_ros(camera: Camera) -> dict[str, Any]:
    """`Camera.to_ros`."""
    coefficients = camera.distortion
    lens = "opencv" if camera.lens == "pinhole" else camera.lens
    used = np.flatnonzero(coefficients)
    count = used[-1] + 1 if used.size else 0
    for model, (family, most) in _ROS_MODELS.items():
        if family == lens and count <= most:
            d = np.zeros(most)
            d[:count] = coefficients[:count]
            break
    else:
        raise Error(f"{camera.name}: its lens ({camera.lens}) is not one of ROS's; use Device.to_ros(), which fits one")
    projection = np.hstack([camera.K, np.zeros((3, 1))])
    return {
        "width": camera.width,
        "height": camera.height,
        "distortion_model": model,
        "d": d.tolist(),
        "k": camera.K.ravel().tolist(),
        "r": np.eye(3).ravel().tolist(),
        "p": projection.ravel().tolist(),
    }


def from_isaac(cfg: Any, size: Any) -> Camera:
    """`Camera.from_isaac`."""

    def field(of: Any, name: str) -> Any:
        return of.get(name) if isinstance(of, Mapping) else getattr(of, name, None)

    lens = cfg
    for part in ("spawn", "pattern_cfg"):
        lens = lens if field(cfg, part) is None else field(cfg, part)
    if field(lens, "focal_length") is None or field(lens, "horizontal_aperture") is None:
        kind = type(lens).__name__
        raise Error(f"cfg: {kind} has no focal_length and horizontal_aperture; pass a CameraCfg or PinholeCameraCfg of Isaac Lab")
    offsets = [field(lens, f"{side}_aperture_offset") or 0.0 for side in ("horizontal", "vertical")]
    if any(offsets):
        raise Error("cfg: has an aperture offset, whose meaning depends on the renderer; pass one without, or Camera(size, K=matrix)")
    if size is None:
        size = [field(of, name) for of in (cfg, lens) for name in ("width", "height") if field(of, name) is not None]
    if len(size) != 2:
        raise Error("size: the configuration has no width and height; pass (width, height) of its images")
    width, height = (int(side) for side in size)
    horizontal, vertical = float(field(lens, "horizontal_aperture")), field(lens, "vertical_aperture")
    fx = width * float(field(lens, "focal_length")) / horizontal
    fy = fx if vertical is None else height * float(field(lens, "focal_length")) / float(vertical)
    return Camera((width, height), K=np.array([[fx, 0, (width - 1) / 2], [0, fy, (height - 1) / 2], [0, 0, 1]]))


def from_open3d(intrinsic: Any) -> Camera:
    """`Camera.from_open3d`."""
    if not hasattr(intrinsic, "intrinsic_matrix"):
        kind = type(intrinsic).__name__
        raise Error(f"intrinsic: {kind} has no intrinsic_matrix; pass an open3d.camera.PinholeCameraIntrinsic")
    size = (int(intrinsic.width), int(intrinsic.height))
    return Camera(size, K=np.asarray(intrinsic.intrinsic_matrix, np.float64))


def _pinhole(camera: Camera, library: str) -> None:
    if camera.lens != "pinhole":
        raise Error(f"{camera.name}: {library} has no lens such as its own ({camera.lens}); pass a pinhole, such as Device.depth_camera()")


def to_open3d(camera: Camera) -> dict[str, Any]:
    """`Camera.to_open3d`."""
    _pinhole(camera, "Open3D")
    return {"width": camera.width, "height": camera.height, "intrinsic_matrix": np.asarray(camera.K)}


def from_mujoco(model: Any, name: Any, size: Any) -> Camera:
    """`Camera.from_mujoco`."""
    if not hasattr(model, "cam_fovy"):
        raise Error(f"model: {type(model).__name__} has no cameras; pass a mujoco.MjModel")
    number = name if isinstance(name, int) else model.camera(name).id
    width, height = (int(side) for side in (model.cam_resolution[number] if size is None else size))
    if size is None and (width, height) == (1, 1):
        raise Error(f"size: the camera {name} has no resolution in the model; pass (width, height) of its images")
    sensor = np.asarray(model.cam_sensorsize[number], np.float64)
    if sensor.all():
        # Lengths on the sensor: the focal lengths, and how far the principal point is to the left of and above the centre.
        fx, fy, left, up = np.asarray(model.cam_intrinsic[number], np.float64) / [*sensor, *sensor] * [width, height, width, height]
    else:
        fx = fy = height / 2 / np.tan(np.radians(float(model.cam_fovy[number])) / 2)
        left = up = 0.0
    matrix = [[fx, 0, width / 2 - left - 0.5], [0, fy, height / 2 - up - 0.5], [0, 0, 1]]
    return Camera((width, height), K=matrix, name=str(name))


def to_mujoco(camera: Camera) -> dict[str, Any]:
    """`Camera.to_mujoco`."""
    _pinhole(camera, "MuJoCo")
    (width, height), matrix = camera.size, camera.K
    return {
        "resolution": [width, height],
        "sensor_size": [width * _PITCH_M, height * _PITCH_M],
        "focal_pixel": [float(matrix[0, 0]), float(matrix[1, 1])],
        "principal_pixel": [float(width / 2 - matrix[0, 2] - 0.5), float(height / 2 - matrix[1, 2] - 0.5)],
    }
