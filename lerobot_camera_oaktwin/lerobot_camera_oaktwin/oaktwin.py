import time
from typing import Any

import numpy as np
import oaktwin
from lerobot.cameras import Camera
from lerobot.utils.errors import DeviceAlreadyConnectedError, DeviceNotConnectedError
from numpy.typing import NDArray

from .config_oaktwin import OaktwinCameraConfig


class OaktwinCamera(Camera):
    """An OAK in a scene, whose frames come at the rate of the configuration.

    scene: the `oaktwin.Scene` once it is connected, whose parts can be moved.
    world_from_body: the pose of the device, (4, 4), metres; it can be set.
    """

    def __init__(self, config: OaktwinCameraConfig) -> None:
        super().__init__(config)
        self.config = config
        self._device = oaktwin.Device(config.model)
        if "rgb" not in self._device.cameras:
            raise oaktwin.Error(f"model: {config.model} has no colour camera; choose one that has")
        self.scene: Any = None
        self.world_from_body: Any = None
        self._rig: Any = None
        self._frame, self._due = -1, 0.0
        self._shots: dict[str, Any] = {}

    def __str__(self) -> str:
        return f"OaktwinCamera({self.config.model}, {self.config.scene})"

    @property
    def is_connected(self) -> bool:
        return self._rig is not None

    @staticmethod
    def find_cameras() -> list[dict[str, Any]]:
        """The models that can be simulated."""
        return [{"type": "oaktwin", "name": name, "id": name} for name in oaktwin.models()]

    def connect(self, warmup: bool = True) -> None:
        """Reads the scene."""
        if self.is_connected:
            raise DeviceAlreadyConnectedError(f"{self} is already connected")
        self.scene = oaktwin.Scene.open(self.config.scene)
        self.world_from_body = self.scene.look_at(self.config.eye, self.config.target, self._device)
        size = (self.width, self.height) if self.width and self.height else None
        cameras, annotators = ["rgb"], ["rgb"]
        if self.config.use_depth and self._device.depth_sensors:
            cameras, annotators = [*cameras, "depth"], [*annotators, "depth_sensor_distance"]
        options = {"seed": self.config.seed, **self.config.sensor}
        self._rig = oaktwin.Rig(self._device, cameras=cameras, size=size, annotators=annotators, **options)
        self._frame, self._due = -1, time.perf_counter()
        if warmup:
            height, width = self.read().shape[:2]
            self.width, self.height = width, height

    def _shoot(self) -> None:
        if not self.is_connected:
            raise DeviceNotConnectedError(f"{self} is not connected")
        self._frame += 1
        self._shots = self._rig.shoot(self.scene, self.world_from_body, frame=self._frame)
        self._due = max(self._due, time.perf_counter() - 1 / (self.fps or 30)) + 1 / (self.fps or 30)

    def _wait(self, timeout_ms: float) -> None:
        rest = self._due - time.perf_counter()
        if rest > timeout_ms / 1000:
            time.sleep(timeout_ms / 1000)
            raise TimeoutError(f"{self}: no frame within {timeout_ms} ms, because frames come at {self.fps} Hz; wait longer")
        time.sleep(max(rest, 0.0))

    def _colour(self) -> NDArray[Any]:
        return np.ascontiguousarray(self._shots["rgb"]["rgb"][..., :3])

    def read(self) -> NDArray[Any]:
        """The next colour image, (H, W, 3) uint8 sRGB."""
        return self.async_read(timeout_ms=float("inf"))

    def async_read(self, timeout_ms: float = 200) -> NDArray[Any]:
        """The next colour image, for which it waits up to `timeout_ms`."""
        if self.is_connected:
            self._wait(timeout_ms)
        self._shoot()
        return self._colour()

    def read_latest(self, max_age_ms: int = 500) -> NDArray[Any]:
        """The present colour image."""
        if not self._shots or time.perf_counter() >= self._due:
            self._shoot()
        return self._colour()

    def read_depth(self) -> NDArray[Any]:
        """What the depth sensor measured in the last frame, (H, W) uint16 millimetres, 0 where it measured nothing."""
        if not self._shots:
            self._shoot()
        name = next((name for name in self._shots if name.endswith("_depth")), None)
        if name is None:
            raise oaktwin.Error(f"use_depth: {self} has no depth; set it, with a model that has a depth sensor")
        metres = self._shots[name]["depth_sensor_distance"]
        return np.where(metres < 65.5355, np.rint(metres * 1000), 0).astype(np.uint16)

    def disconnect(self) -> None:
        """Forgets the scene."""
        if not self.is_connected:
            raise DeviceNotConnectedError(f"{self} is not connected")
        self.scene = self._rig = None
        self._shots = {}
