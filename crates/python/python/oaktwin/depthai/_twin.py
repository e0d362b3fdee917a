"""One virtual device: the twin, its world, its clock, and what it has rendered."""

from __future__ import annotations

import json
import sys
import threading
import traceback
from dataclasses import dataclass, field
from typing import Any, Literal

import depthai as dai
import numpy as np

from .._cameras import Camera
from .._devices import Device
from .._findings import Error
from ._clock import Clock
from ._exposure import Exposure, Shutter
from ._library import warn_once
from ._shots import Shots
from ._world import World

Engine = Literal["stereo-matching", "stereo-noise"]
ENGINES = ("stereo-matching", "stereo-noise")
Socket = dai.CameraBoardSocket
# The images by which automatic exposure settles: (width, height) in px, and how many.
_SETTLING_SIZE, _SETTLING_STEPS = (80, 50), 6
# The frames whose exposures are remembered, for the other camera of the pair.
_DECIDED = 64
# Colour sensors that stereo pairs have.
_COLOUR_SENSORS = ("OV9782",)
# Where the cameras of a device are connected, by their roles.
_SOCKETS = {"rgb": Socket.CAM_A, "left": Socket.CAM_B, "right": Socket.CAM_C}


@dataclass
class Settings:
    """The choices of `virtual_device` that are not about the world."""

    engine: Engine = "stereo-matching"
    fast: bool = False
    seed: int = 0
    ambient: float = 1.0
    # The ONNX files of networks, by the names of models or nodes.
    networks: dict[str, str] = field(default_factory=dict)
    # A fixed number in the identifier of the device, which distinguishes several.
    number: int = 0


@dataclass
class Light:
    """The infrared light of a device, each from 0 to 1."""

    dots: float = 0.0
    flood: float = 0.0


@dataclass
class Twin:
    """A device that programs see: what it is, where it is, and its state."""

    device: Device
    world: World
    settings: Settings
    light: Light = field(default_factory=Light)
    errors: list[BaseException] = field(default_factory=list)
    pipelines: list[Any] = field(default_factory=list)
    # A weak reference to the dai.Device that uses it.
    holder: Any = None

    def __post_init__(self) -> None:
        if self.settings.engine not in ENGINES:
            raise Error(f"engine: {self.settings.engine!r} is unknown; pass {' or '.join(ENGINES)}")
        self.clock = Clock(fast=self.settings.fast)
        self.report: dict[str, Any] = self.device.report()
        self.calibration_json: dict[str, Any] = json.loads(next(iter(self.device.to_depthai().values())))
        if not self.calibration_json["stereoRectificationData"]:
            # Without a pair. DepthAI requires the keys.
            turned: list[list[float]] = np.eye(3).tolist()
            self.calibration_json["stereoRectificationData"] = {
                "leftCameraSocket": -1,
                "rightCameraSocket": -1,
                "rectifiedRotationLeft": turned,
                "rectifiedRotationRight": turned,
            }
        # The device as its calibration describes it: another one than that which takes the images after a program has set a calibration.
        self.described = self.device
        self.cameras = self._cameras()
        self.shots = Shots(self.device, self.world, self.settings.seed, self.settings.ambient, self.light)
        self._exposures: dict[Socket, Exposure] = {}
        self._lock, self._settling = threading.Lock(), threading.Lock()

    def _cameras(self) -> dict[Socket, tuple[str, Camera]]:
        """The role and the camera of each socket that is occupied."""
        found = {}
        for role, camera in self.device.cameras.items():
            # The sensor of a time-of-flight device takes the first socket.
            socket = _SOCKETS.get(role, Socket.CAM_A)
            found[socket] = (role, camera)
        return dict(sorted(found.items(), key=lambda item: int(item[0])))

    @property
    def is_open(self) -> bool:
        """Whether a program uses it: whether its dai.Device exists and is not closed."""
        device = self.holder() if self.holder is not None else None
        return device is not None and not device.isClosed()

    @property
    def name(self) -> str:
        """The product name that DepthAI reports."""
        return str(self.calibration_json.get("productName") or self.device.name)

    @property
    def identifier(self) -> str:
        """The identifier of the device. It says that no hardware has it."""
        return f"VIRTUAL{self.settings.number:04d}"

    @property
    def is_rvc4(self) -> bool:
        """Whether the processor of the device is that of the OAK 4."""
        return bool(self.report["generation"] == "RVC4")

    @property
    def platform(self) -> Literal["rvc2", "rvc4"]:
        """The platform, as oaktwin names it."""
        return "rvc4" if self.is_rvc4 else "rvc2"

    @property
    def stereo_sockets(self) -> tuple[Socket, Socket] | None:
        """The sockets of the left and the right camera of the stereo pair, or None without one."""
        if "stereo" in self.device.depth_sensors:
            return Socket.CAM_B, Socket.CAM_C
        return None

    def has_colour(self, socket: Socket) -> bool:
        """Whether the sensor of a socket has colour filters: those of stereo pairs usually have none."""
        role, _ = self.camera(socket)
        if self.stereo_sockets is None or socket not in self.stereo_sockets:
            return True
        return any(one["role"] == role and one["sensor"].startswith(_COLOUR_SENSORS) for one in self.report["cameras"])

    @property
    def origin(self) -> tuple[Socket, Camera]:
        """The camera to which the extrinsics of all images lead."""
        socket, (_, camera) = next(iter(self.cameras.items()))
        return socket, camera

    def camera(self, socket: Socket) -> tuple[str, Camera]:
        """The role and the camera of a socket.

        Raises RuntimeError, as DepthAI does, for a socket without a camera.
        """
        if socket not in self.cameras:
            present = ", ".join(one.name for one in self.cameras)
            raise RuntimeError(f"Camera socket not found on the connected device: {socket.name}; {self.device.name} has {present}")
        return self.cameras[socket]

    def exposure(self, socket: Socket) -> Exposure:
        """The state of the exposure of a camera. The cameras of a stereo pair share theirs, as they do on the device by default."""
        if self.stereo_sockets and socket in self.stereo_sockets:
            socket = self.stereo_sockets[0]
        with self._lock:
            return self._exposures.setdefault(socket, Exposure())

    def shutter(self, socket: Socket, seconds: float, frame: int) -> Shutter:
        """The exposure of a frame, which both cameras of the stereo pair share.

        Automatic exposure of the pair looks at a small image at the same time, so that it does not depend on what a program requests; that
        of other cameras keeps the exposure of the renderer.
        """
        exposure = self.exposure(socket)
        is_of_pair = bool(self.stereo_sockets and socket in self.stereo_sockets)
        with self._settling:
            if seconds in exposure.decided:
                return exposure.decided[seconds]
            if not exposure.is_automatic:
                shutter = exposure.shutter
            elif is_of_pair:
                # A device that has run for a while has settled.
                for _ in range(1 if exposure.decided else _SETTLING_STEPS):
                    images = self.shots.pair(seconds, frame, _SETTLING_SIZE, exposure.shutter)
                    exposure.follow(float(images["left"].mean()) / 255)
                shutter = exposure.shutter
            else:
                shutter = exposure.neutral(self.settings.ambient)
            exposure.decided[seconds] = shutter
            while len(exposure.decided) > _DECIDED:
                exposure.decided.pop(next(iter(exposure.decided)))
            return shutter

    def calibration(self) -> dai.CalibrationHandler:
        """The calibration of the device, as DepthAI's own class."""
        return dai.CalibrationHandler.fromJson(self.calibration_json)

    def set_calibration(self, calibration: dai.CalibrationHandler) -> None:
        """Sets what the device and its nodes take for its calibration. Its cameras stay as they are."""
        content = calibration.eepromToJson()
        described = Device.from_calibration(content, force=True)
        # Units of a model differ in their numbers, not in what they have.
        if any(set(one) != set(other) for one, other in ((described.cameras, self.device.cameras), (described.depth_sensors, self.device.depth_sensors))):
            raise Error(f"Device: the calibration is one of another model than {self.device.name}; pass one of this model")
        self.calibration_json, self.described = content, described
        warn_once("Device: a calibration that a program sets changes what nodes calculate, not the images; with stereo-noise, depth stays as it was")
        for reference in self.pipelines:
            if (pipeline := reference()) is not None:
                pipeline.update_calibration()

    def fail(self, error: BaseException, node: str) -> None:
        """Records the error of a node, shows it, and stops all pipelines."""
        with self._lock:
            is_first = not self.errors
            self.errors.append(error)
        if is_first:
            if isinstance(error, Error):
                print(f"oaktwin: {node}: {error}", file=sys.stderr)
            else:
                print(f"oaktwin: {node}: the node raised an exception; its pipeline stops", file=sys.stderr)
                traceback.print_exception(type(error), error, error.__traceback__)
        self.stop()

    def stop(self) -> None:
        """Stops all pipelines of the device."""
        for pipeline in self.running():
            pipeline.stop()

    def running(self) -> list[Any]:
        """The pipelines that run."""
        present = (reference() for reference in list(self.pipelines))
        return [pipeline for pipeline in present if pipeline is not None and pipeline.isRunning()]
