"""Rendered images, each made once and shared by all nodes that want it."""

from __future__ import annotations

import threading
from collections import OrderedDict
from collections.abc import Callable, Hashable
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np
import numpy.typing as npt

from .._cameras import Camera
from .._devices import Device
from .._poses import BodyPose
from ._exposure import Shutter, imager_settings
from ._library import warn_once
from ._world import World

if TYPE_CHECKING:
    from ._twin import Light

_Result = TypeVar("_Result")
# Images of several outputs of one frame, and of the next one, each by its time and by its view.
_KEPT = 48


class Shots:
    """The images of a device in its world. One is rendered at a time, because each uses all processors."""

    def __init__(self, device: Device, world: World, seed: int, ambient: float, light: Light) -> None:
        self.device, self.world, self.seed, self.ambient, self.light = device, world, seed, ambient, light
        self._cache: OrderedDict[object, Any] = OrderedDict()
        self._lock = threading.Lock()

    def _shared(self, key: Hashable, seconds: float, make: Callable[[BodyPose], _Result], *, is_noisy: bool = False) -> _Result:
        """What `make` makes of the body's pose at a time. A still view is made once, unless its images differ in noise."""
        now = key, seconds
        with self._lock:
            if now not in self._cache:
                self.world.advance(seconds)
                pose = self.world.body_pose(seconds)
                view = key, self.world.scene.version, np.asarray(pose).tobytes(), seconds if is_noisy else None
                if view not in self._cache:
                    self._cache[view] = make(pose)
                self._cache[now] = self._cache[view]
                self._cache.move_to_end(view)
                while len(self._cache) > _KEPT:
                    self._cache.popitem(last=False)
            result: _Result = self._cache[now]
            return result

    def pair(self, seconds: float, frame: int, size: tuple[int, int], shutter: Shutter) -> dict[str, Any]:
        """The images of the stereo pair at a time, see `oaktwin.Scene.render_pair`.

        frame: the number of the frame, which determines the noise.
        """
        dots = self._dots()

        def make(pose: BodyPose) -> dict[str, Any]:
            return dict(
                self.world.scene.render_pair(
                    self.device,
                    pose,
                    size=size,
                    projector=dots,
                    ambient=self.ambient,
                    imager=imager_settings(shutter),
                    seed=self.seed,
                    frame=frame,
                )
            )

        return self._shared(("pair", size, shutter, dots), seconds, make, is_noisy=True)

    def _dots(self) -> float:
        if self.light.flood:
            warn_once("Device: the infrared flood light is not simulated and does not change images")
        if self.light.dots and not self.has_projector:
            warn_once(f"Device: {self.device.name} has no dot projector; its intensity has no effect")
            return 0.0
        return self.light.dots

    @property
    def has_projector(self) -> bool:
        """Whether the device has a dot projector."""
        body = self.device.report()["body"]
        return bool(body and body.get("projector_mm"))

    def colour(self, seconds: float, camera: Camera) -> npt.NDArray[np.uint8]:
        """What a camera sees at a time, (H, W, 3) uint8 sRGB, without noise."""

        def make(pose: BodyPose) -> npt.NDArray[np.uint8]:
            return self.world.scene.render(camera, pose @ camera.body_from_camera, annotators=["rgb"])["rgb"][..., :3]

        return self._shared(("rgb", camera), seconds, make)

    def depth(self, seconds: float, camera: Camera) -> npt.NDArray[np.float32]:
        """The exact depth of a camera at a time, (H, W) float32 metres along its axis, inf for a miss."""

        def make(pose: BodyPose) -> npt.NDArray[np.float32]:
            return self.world.scene.render(camera, pose @ camera.body_from_camera)["distance_to_image_plane"]

        return self._shared(("depth", camera), seconds, make)
