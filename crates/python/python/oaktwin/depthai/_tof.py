"""The nodes ToF and ToFBase: the depth of a time-of-flight camera."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import depthai as dai
import numpy as np

from .._findings import Error
from .._sensors import DepthSensor
from ._frames import depth_frame, grey_frame, luma, transformation
from ._library import warn_once
from ._node import VirtualNode

if TYPE_CHECKING:
    from typing_extensions import Self

_Preset = dai.ImageFiltersPresetMode
_PRESETS: dict[str, Any] = {"TOF_LOW_RANGE": "tof-low-range", "TOF_MID_RANGE": "tof-mid-range", "TOF_HIGH_RANGE": "tof-high-range"}
_DEFAULT_FPS = 30.0


class ToF(VirtualNode):
    """DepthAI's ToF: depth with the filters of a preset."""

    def __init__(self) -> None:
        super().__init__()
        if "tof" not in self.twin.device.depth_sensors:
            raise Error(f"{type(self).__name__}: {self.twin.device.name} has no time-of-flight camera; choose OAK-D ToF")
        self.depth, self.rawDepth = self.image_output("depth"), self.image_output("rawDepth")
        self.amplitude, self.intensity = self.image_output("amplitude"), self.image_output("intensity")
        self.confidence, self.phase, self.raw = self.image_output("confidence"), self.image_output("phase"), self.image_output("raw")
        self.inputConfig = self.message_input("inputConfig", dai.DatatypeEnum.ToFConfig)
        self.tofBaseInputConfig = self.message_input("tofBaseInputConfig", dai.DatatypeEnum.ToFConfig)
        self.imageFiltersInputConfig = self.message_input("imageFiltersInputConfig", dai.DatatypeEnum.ImageFiltersConfig)
        self.initialConfig = dai.ToFConfig()
        self._preset: str | None = "tof-mid-range"
        self._fps = _DEFAULT_FPS

    def build(self, boardSocket: Any = dai.CameraBoardSocket.AUTO, presetMode: Any = _Preset.TOF_MID_RANGE, fps: float | None = None, **named: Any) -> Self:
        """Chooses the preset and the rate. The device has one time-of-flight camera, which is used whatever the socket."""
        preset = named.get("profile", named.get("profilePreset", presetMode))
        if getattr(preset, "name", "") not in _PRESETS:
            warn_once(f"ToF: the profile {preset} is not simulated; the preset TOF_MID_RANGE is used")
        self._preset = _PRESETS.get(getattr(preset, "name", ""), "tof-mid-range")
        self._fps = float(fps or _DEFAULT_FPS)
        return self

    def getInitialConfig(self) -> dai.ToFConfig:
        """The configuration, which has no effect on the simulation."""
        return self.initialConfig

    def setInitialConfig(self, config: dai.ToFConfig) -> None:
        """Accepts a configuration; a warning says once that only presets are simulated."""
        self.initialConfig = config
        warn_once("ToF: configurations other than presets are not simulated and have no effect")

    def setOutputUndistortion(self, enable: bool) -> Self:
        """Accepts it: measured depth has no distortion here."""
        return self

    setNumFramesPool = VirtualNode.ignore

    def work(self) -> None:
        """Measures until the pipeline stops."""
        for output in (self.phase, self.raw):
            if self.is_wanted(output):
                raise Error(f"ToF: the output {output.getName()} is not simulated; use depth, rawDepth, amplitude, confidence or intensity")
        twin = self.twin
        camera = twin.device.depth_camera("tof")
        filtered = DepthSensor(twin.device, sensor="tof", camera=camera, preset=self._preset, seed=twin.settings.seed)  # type: ignore[arg-type]
        raw = DepthSensor(twin.device, sensor="tof", camera=camera, seed=twin.settings.seed)
        schedule = twin.clock.schedule(self._fps)
        socket, origin = twin.origin
        frame = -1
        while (taken := schedule.next(frame, self.runs)) is not None:
            frame = taken
            seconds = schedule.time(frame)
            exact = twin.shots.depth(seconds, camera)
            for output, sensor in ((self.depth, filtered), (self.rawDepth, raw)):
                if self.is_wanted(output):
                    measured = np.clip(np.round(1000 * sensor(exact, frame=frame)), 0, 65535).astype(np.uint16)
                    self._deliver(output, depth_frame(measured), transformation(sensor.camera, origin, socket), seconds, frame)
            # On RVC2, the confidence is the amplitude.
            for output in (self.amplitude, self.confidence, self.intensity):
                if self.is_wanted(output):
                    self._deliver(output, self._brightness(seconds, exact, output), transformation(camera, origin, socket), seconds, frame)

    def _brightness(self, seconds: float, exact: Any, output: dai.Node.Output) -> dai.ImgFrame:
        """The luma of the scene; the amplitude also falls with the square of the distance from 1 m."""
        warn_once("ToF: amplitude and intensity show the colours of the scene, because its infrared reflectance is unknown")
        grey = luma(self.twin.shots.colour(seconds, self.twin.device.depth_camera("tof")))
        if output is self.intensity:
            return grey_frame(grey)
        fallen = grey / np.maximum(exact, 1.0) ** 2 * 16
        return depth_frame(np.where(np.isfinite(exact), fallen, 0).astype(np.uint16))

    def _deliver(self, output: dai.Node.Output, frame: dai.ImgFrame, described: dai.ImgTransformation, seconds: float, number: int) -> None:
        frame.setSourceSize(*described.getSize())
        frame.setTransformation(described)
        self.twin.clock.stamp(frame, seconds, number)
        frame.setInstanceNum(int(dai.CameraBoardSocket.CAM_A))
        output.send(frame)


class ToFBase(ToF):
    """DepthAI's ToFBase: depth without filters."""

    def __init__(self) -> None:
        super().__init__()
        self._preset = None
