"""Poses that know whose they are, and the poses of a scene's parts."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np

from ._findings import Error

if TYPE_CHECKING:
    from typing_extensions import Self

    from ._types import _Float64

    _Array64 = np.ndarray[Any, np.dtype[np.float64]]
    _Poses = dict[str, _Float64]
else:
    _Array64, _Poses = np.ndarray, dict

__all__ = ["BodyPose", "CameraPose"]


class _Pose(_Array64):
    """An array (4, 4) or (N, 4, 4). Items and stacks are poses, too; what is computed from it is a plain array."""

    frame: ClassVar[str]

    def __new__(cls, matrix: object) -> Self:
        return np.asarray(matrix, np.float64).view(cls)

    def __getitem__(self, index: Any) -> Any:
        part = np.asarray(self)[index]
        return part.view(type(self)) if isinstance(part, np.ndarray) and part.shape[-2:] == (4, 4) else part

    def __matmul__(self, other: Any) -> Any:
        product = np.asarray(self) @ np.asarray(other)
        return CameraPose(product) if isinstance(other, Mount) else product

    def __array_wrap__(self, array: Any, *_: object) -> Any:
        return np.asarray(array)[()]

    # The functions of NumPy 1 ask this, too.
    def __array_prepare__(self, array: Any, *_: object) -> Any:
        return np.asarray(array)

    def __array_function__(self, func: Any, types: Any, args: Any, kwargs: Any) -> Any:
        result = super().__array_function__(func, types, args, kwargs)
        if func is np.stack and {type(one) for one in args[0]} == {type(self)} and result.shape[-2:] == (4, 4):
            return result.view(type(self))
        return result


class BodyPose(_Pose):
    """Poses of a device's body: float64 (4, 4) or (N, 4, 4) world_from_body, whose source frame is x forward, y left, z up, metres.

    `BodyPose(matrix)` marks an array. `pose @ camera.body_from_camera` is the `CameraPose` of a camera of the device.
    """

    frame = "body"


class CameraPose(_Pose):
    """Poses of a camera: float64 (4, 4) or (N, 4, 4) world_from_camera, whose source frame is OpenCV's (x right, y down, z forward),
    metres. `CameraPose(matrix)` marks an array.
    """

    frame = "camera"

    @classmethod
    def of(cls, pose: object, convention: str) -> CameraPose:
        """Returns the pose that another library has in its convention; see `to`."""
        matrix = np.asarray(pose, np.float64)
        if convention == "open3d":
            return CameraPose(np.linalg.inv(matrix))
        return CameraPose(matrix @ _opencv_from(convention).T)

    def to(self, convention: str) -> _Float64:
        """The pose in the convention of another library, float64 (4, 4) or (N, 4, 4), metres.

        "opengl", "mujoco": world_from_camera, whose camera has x right, y up and z backward, as Blender's and USD's have.
        "ros": world_from_camera, whose camera has x forward, y left and z up: a camera frame of ROS that is not an optical one.
        "open3d": camera_from_world, the extrinsic matrix, with OpenCV's axes.
        """
        matrix = np.asarray(self)
        if convention == "open3d":
            return np.asarray(np.linalg.inv(matrix), np.float64)
        return matrix @ _opencv_from(convention)


def _opencv_from(convention: str) -> _Float64:
    """The transform from the axes of a convention to OpenCV's."""
    axes = {
        "opengl": np.diag([1.0, -1.0, -1.0, 1.0]),
        "mujoco": np.diag([1.0, -1.0, -1.0, 1.0]),
        "ros": np.array([[0.0, -1, 0, 0], [0, 0, -1, 0], [1, 0, 0, 0], [0, 0, 0, 1]]),
    }
    if convention not in axes:
        raise Error(f"convention: invalid value {convention!r}; pass opengl, mujoco, ros or open3d")
    return axes[convention]


class Mount(CameraPose):
    """The pose of a camera on its device: what is multiplied by it is a pose of the camera."""

    def __rmatmul__(self, other: Any) -> Any:
        return CameraPose(np.asarray(other) @ np.asarray(self))


class Poses(_Poses):
    """(4, 4) poses by prim path, which are found by the names of the parts, too."""

    def __missing__(self, name: object) -> _Float64:
        path = f"/World/{name}"
        if str(name).startswith("/") or path not in self.keys():
            raise KeyError(name)
        return self[path]

    def __contains__(self, name: object) -> bool:
        return super().__contains__(name) or super().__contains__(f"/World/{name}")
