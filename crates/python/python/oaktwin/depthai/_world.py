"""What a virtual device sees: a scene, and where the device is at each time."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from os import PathLike, fspath
from typing import Any, Union

import numpy as np
import numpy.typing as npt

from .._cameras import look_at as camera_looking_at
from .._devices import Device
from .._findings import Error
from .._poses import BodyPose, CameraPose
from .._scenes import Scene

Float64 = npt.NDArray[np.float64]
# A still pose (4, 4), a function of the time in seconds, or (times, poses) of a trajectory.
Pose = Union[npt.ArrayLike, Callable[[float], npt.ArrayLike], tuple[npt.ArrayLike, npt.ArrayLike]]


class World:
    """A scene and the motion of a device's body in it. An animated USD stage plays from its first time code to its last one, and then stands
    still.

    scene: an `oaktwin.Scene`, or the path of its file.
    pose: world_from_body, (4, 4) metres, the body's x forward, y left, z up; a function of the time in seconds that returns one; or
        a trajectory, the pair (times, poses) of (N,) seconds and (N, 4, 4), which ends in standstill.
    look_at: instead of the pose, six numbers: the position, and the point to face, metres in the world.
    update: a function of the time in seconds that moves the parts of the scene, or None for a still scene.
    """

    def __init__(
        self,
        scene: Scene | str | PathLike[str],
        *,
        pose: Pose | None = None,
        look_at: Sequence[float] | None = None,
        update: Callable[[float], None] | None = None,
    ) -> None:
        self.scene = scene if isinstance(scene, Scene) else Scene.open(fspath(scene))
        if pose is not None and look_at is not None:
            raise Error("pose, look_at: both say where the device is; pass one of them")
        self._pose = self._motion(pose, look_at)
        self._update = update
        self._animation = self.scene.animation

    def _motion(self, pose: Pose | None, look_at: Sequence[float] | None) -> Callable[[float], Float64]:
        if look_at is not None:
            numbers = np.asarray(look_at, np.float64).ravel()
            if numbers.shape != (6,):
                raise Error(f"look_at: {numbers.size} numbers; pass six: the position and the point to face, in metres")
            up = (0.0, 0.0, 1.0) if self.scene.up == "z" else (0.0, 1.0, 0.0)
            still = np.asarray(camera_looking_at(numbers[:3], numbers[3:], up, frame="body"))
            return lambda _: still
        if pose is None:
            return lambda _: np.eye(4)
        if callable(pose):
            return lambda seconds: _from_function(pose, seconds)
        if isinstance(pose, tuple) and len(pose) == 2:
            return _trajectory(*pose)
        fixed = _checked(pose, "pose")
        return lambda _: fixed

    def body_pose(self, seconds: float) -> BodyPose:
        """world_from_body at a time."""
        return BodyPose(self._pose(seconds))

    def advance(self, seconds: float) -> None:
        """Moves the parts of the scene to where they are at a time."""
        if self._animation is not None:
            first, last, per_second = self._animation
            code = min(first + seconds * per_second, last)
            if code != self.scene.time:
                self.scene.set_time(code)
        if self._update is not None:
            try:
                self._update(seconds)
            except Exception as error:
                raise Error(f"update: the function that moves the scene raised {error!r} at {seconds:.3f} s") from error


def _from_function(pose: Callable[[float], npt.ArrayLike], seconds: float) -> Float64:
    try:
        value = pose(seconds)
    except Exception as error:
        raise Error(f"pose: the function raised {error!r} at {seconds:.3f} s; it must return a (4, 4) matrix") from error
    return _checked(value, f"pose: at {seconds:.3f} s")


def _checked(pose: npt.ArrayLike, place: str) -> Float64:
    if isinstance(pose, CameraPose):
        raise Error(f"{place}: this is the pose of a camera; pass the pose of the device's body, world_from_body")
    try:
        matrix = np.asarray(pose, np.float64)
    except (TypeError, ValueError) as error:
        raise Error(f"{place}: it is not a matrix of numbers; pass (4, 4) world_from_body, metres") from error
    if matrix.shape != (4, 4):
        raise Error(f"{place}: its shape is {matrix.shape}; pass (4, 4) world_from_body, metres")
    if not np.isfinite(matrix).all():
        raise Error(f"{place}: it contains values that are not finite; pass world_from_body, metres")
    rotation = matrix[:3, :3]
    if np.abs(rotation @ rotation.T - np.eye(3)).max() > 1e-4 or np.linalg.det(rotation) < 0:
        raise Error(f"{place}: its upper left 3x3 part is not a rotation; pass world_from_body without scale")
    return matrix


def _trajectory(times: npt.ArrayLike, poses: npt.ArrayLike) -> Callable[[float], Float64]:
    """Linear positions and the shortest rotations between poses; the first and the last pose outside their times."""
    stamps = np.asarray(times, np.float64)
    matrices = np.asarray(poses, np.float64)
    if stamps.ndim != 1 or len(stamps) < 2 or matrices.shape != (len(stamps), 4, 4):
        raise Error("pose: the trajectory needs (N,) times and (N, 4, 4) poses, at least two")
    if not (np.diff(stamps) > 0).all():
        raise Error("pose: the times of the trajectory do not increase; sort its poses by time")
    for index, matrix in enumerate(matrices):
        _checked(matrix, f"pose: item {index} of the trajectory")

    def at(seconds: float) -> Float64:
        index = int(np.clip(np.searchsorted(stamps, seconds, "right") - 1, 0, len(stamps) - 2))
        share = float(np.clip((seconds - stamps[index]) / (stamps[index + 1] - stamps[index]), 0, 1))
        first, second = matrices[index], matrices[index + 1]
        pose = np.eye(4)
        pose[:3, 3] = (1 - share) * first[:3, 3] + share * second[:3, 3]
        pose[:3, :3] = first[:3, :3] @ _rotation(share * rotation_vector(first[:3, :3].T @ second[:3, :3]))
        return pose

    return at


def rotation_vector(rotation: Float64) -> Float64:
    """The axis of a rotation times its angle in radians; exact enough up to a little less than half a turn."""
    axis = np.array([rotation[2, 1] - rotation[1, 2], rotation[0, 2] - rotation[2, 0], rotation[1, 0] - rotation[0, 1]])
    sine = np.linalg.norm(axis) / 2
    angle = np.arctan2(sine, (np.trace(rotation) - 1) / 2)
    return np.asarray(axis / 2 if sine < 1e-12 else axis * angle / (2 * sine))


def _rotation(vector: Float64) -> Float64:
    angle = float(np.linalg.norm(vector))
    if angle < 1e-12:
        return np.eye(3)
    x, y, z = vector / angle
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.asarray(np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross)


def make_world(scene: World | Scene | str | PathLike[str] | None, **motion: Any) -> World:
    """Returns the world of the arguments of `virtual_device`."""
    if isinstance(scene, World):
        if any(value is not None for value in motion.values()):
            raise Error("scene: this world has a pose already; leave out pose and look_at")
        return scene
    if scene is None:
        raise Error("scene: it is missing; pass an oaktwin.Scene, or the path of a USD, glTF, Collada, OBJ, STL or PLY file")
    return World(scene, **motion)


def device_of(model_or_calibration: Device | str | PathLike[str] | dict[str, Any]) -> Device:
    """The twin of a model's name, of a calibration (the path of a .json file, or its content), or the device itself."""
    if isinstance(model_or_calibration, Device):
        return model_or_calibration
    if isinstance(model_or_calibration, dict) or hasattr(model_or_calibration, "eepromToJson"):
        return Device.from_calibration(model_or_calibration)
    text = fspath(model_or_calibration)
    return Device.from_calibration(text) if text.endswith(".json") else Device(text)
