"""Exposure: the controls of a camera, automatic exposure, and the noise of colour images."""

from __future__ import annotations

import functools
import threading
from dataclasses import dataclass

import depthai as dai
import numpy as np
import numpy.typing as npt

from .._devices import parameters
from ._library import warn_once

Image = npt.NDArray[np.uint8]
Command = dai.CameraControl.Command
# 33 ms are twice the exposure at which white has the largest value, see `maxExposureTime` of the imager; the gain is 1 at ISO 100.
WHITE_US, UNIT_ISO = 16_500.0, 100.0
LONGEST_US, SHORTEST_US, HIGHEST_ISO = 33_000.0, 20.0, 1600.0
_IGNORED = {
    Command.AWB_MODE: "white balance",
    Command.AWB_LOCK: "white balance",
    Command.WB_COLOR_TEMP: "white balance",
    Command.AF_MODE: "focus",
    Command.AF_TRIGGER: "focus",
    Command.AF_REGION: "focus",
    Command.AF_LENS_RANGE: "focus",
    Command.MOVE_LENS: "focus",
    Command.MOVE_LENS_RAW: "focus",
    Command.AE_REGION: "the region of automatic exposure",
    Command.ANTIBANDING_MODE: "anti-banding",
    Command.SCENE_MODE: "scene modes",
    Command.EFFECT_MODE: "effects",
    Command.BRIGHTNESS: "brightness",
    Command.CONTRAST: "contrast",
    Command.SATURATION: "saturation",
    Command.SHARPNESS: "sharpness",
    Command.LUMA_DENOISE: "noise reduction",
    Command.CHROMA_DENOISE: "noise reduction",
    Command.HDR: "high dynamic range",
    Command.EXTERNAL_TRIGGER: "external triggers",
    Command.FRAME_SYNC: "frame synchronization",
    Command.STROBE_CONFIG: "strobes",
    Command.CONTROL_MODE: "control modes",
    Command.CAPTURE_INTENT: "capture intents",
}


@dataclass(frozen=True)
class Shutter:
    """The exposure time in microseconds and the sensitivity of one frame."""

    time_us: float = 10_000.0
    iso: float = 100.0

    @property
    def light(self) -> float:
        """Exposure time times gain, 1 where white has the largest value."""
        return self.time_us / WHITE_US * self.iso / UNIT_ISO


class Exposure:
    """The exposure of one camera: manual, or automatic, which aims at the target of the imager."""

    def __init__(self) -> None:
        self.shutter = Shutter(WHITE_US)
        self.is_automatic = True
        self.is_streaming = True
        # The exposures of the latest frames, by their times in seconds.
        self.decided: dict[float, Shutter] = {}
        self._is_locked = False
        self._compensation = 0
        self._longest_us, self._highest_iso = LONGEST_US, HIGHEST_ISO
        self._lock = threading.Lock()

    def apply(self, control: dai.CameraControl) -> bool:
        """Follows the commands of a control message, and returns whether it asks for a still image."""
        with self._lock:
            if control.getCommand(Command.AE_MANUAL):
                manual = control.expManual
                time_us = float(np.clip(manual.exposureTimeUs, 1, 1e6))
                self.shutter = Shutter(time_us, float(np.clip(manual.sensitivityIso, UNIT_ISO, HIGHEST_ISO)))
                self.is_automatic = False
            if control.getCommand(Command.AE_AUTO):
                self.is_automatic = True
            if control.getCommand(Command.AE_LOCK):
                self._is_locked = bool(control.aeLockMode)
            if control.getCommand(Command.EXPOSURE_COMPENSATION):
                self._compensation = int(control.expCompensation)
            if control.getCommand(Command.AE_TARGET_FPS_RANGE) and control.aeMaxExposureTimeUs:
                self._longest_us = float(control.aeMaxExposureTimeUs)
            if control.getCommand(Command.AE_MAX_ISO) and control.aeMaxISO:
                self._highest_iso = float(control.aeMaxISO)
            if control.getCommand(Command.STOP_STREAM):
                self.is_streaming = False
            if control.getCommand(Command.START_STREAM):
                self.is_streaming = True
        for command, what in _IGNORED.items():
            if control.getCommand(command):
                warn_once(f"Camera: the control of {what} is not simulated and has no effect")
        return bool(control.getCommand(Command.STILL_CAPTURE))

    def neutral(self, ambient: float) -> Shutter:
        """The exposure that shows a scene as it is rendered, whatever the scale of its lights; limited as automatic exposure is."""
        return self._limited(2.0 ** (self._compensation / 3) / max(ambient, 1e-6))

    def _limited(self, light: float) -> Shutter:
        time_us = float(np.clip(light * WHITE_US, SHORTEST_US, self._longest_us))
        return Shutter(time_us, float(np.clip(light * WHITE_US / time_us * UNIT_ISO, UNIT_ISO, self._highest_iso)))

    def follow(self, mean: float) -> None:
        """Sets the exposure of the next frame by the mean of an image, from 0 to 1, whose values grow linearly with light."""
        with self._lock:
            if not self.is_automatic or self._is_locked:
                return
            target = exposure_target() * 2.0 ** (self._compensation / 3)
            # A saturated image says only that there is too much light.
            self.shutter = self._limited(self.shutter.light * float(np.clip(target / max(mean, 1e-3), 0.25, 4.0)))


@functools.cache
def _imager() -> dict[str, float]:
    return {one["name"]: float(one["default"]) for one in parameters("imager") if one["type"] in ("number", "boolean")}


def exposure_target() -> float:
    """The mean that automatic exposure aims at, from 0 to 1."""
    return _imager()["exposureTarget"]


def imager_settings(shutter: Shutter) -> dict[str, object]:
    """The parameters of oaktwin's imager for an exposure: its gain is the light over the exposure time."""
    return {
        "autoExposure": False,
        "exposure": shutter.light,
        "maxExposureTime": shutter.time_us / WHITE_US,
        "maxGain": max(shutter.iso / UNIT_ISO, 1.0),
    }


def expose_colour(rgb: Image, light: float, gain: float, seed: tuple[int, ...]) -> Image:
    """What a colour camera records of a rendered image (H, W, 3) sRGB: scaled light, photon noise and read noise.

    light: the exposure, relative to the rendered image's.
    gain: the gain of the amplifier, 1 at ISO 100.
    seed: the noise is a function of these numbers.
    """
    mean_table, spread_table = _tables(round(light, 4), round(gain, 4))
    normal = _normal_numbers()
    start = int(np.random.default_rng(seed).integers(len(normal)))
    noise = np.resize(np.roll(normal, -start), rgb.size).reshape(rgb.shape)
    return _encode(mean_table[rgb] + spread_table[rgb] * noise)


def mosaic(rgb: Image) -> npt.NDArray[np.uint16]:
    """The raw values of an sRGB image (H, W, 3): (H, W) uint16 from 0 to 1023, which grow linearly with light, behind filters in the order
    red, green, green, blue.
    """
    linear = np.round(1023 * _linear()).astype(np.uint16)
    raw = linear[rgb[..., 1]]
    raw[::2, ::2], raw[1::2, 1::2] = linear[rgb[::2, ::2, 0]], linear[rgb[1::2, 1::2, 2]]
    return raw


@functools.cache
def _linear() -> npt.NDArray[np.float64]:
    """The light of each sRGB value, from 0 to 1."""
    values = np.arange(256) / 255
    return np.where(values <= 0.04045, values / 12.92, ((values + 0.055) / 1.055) ** 2.4)


@functools.lru_cache(maxsize=8)
def _tables(light: float, gain: float) -> tuple[npt.NDArray[np.float32], npt.NDArray[np.float32]]:
    """The mean and the standard deviation of the linear signal for each rendered value."""
    linear = _linear() * light
    electrons = _imager()["fullWell"] / gain
    variance = linear / electrons + (_imager()["readNoise"] / electrons) ** 2
    return linear.astype(np.float32), np.sqrt(variance).astype(np.float32)


@functools.cache
def _normal_numbers() -> npt.NDArray[np.float32]:
    return np.random.default_rng(0).standard_normal(1 << 20, dtype=np.float32)


@functools.cache
def _encoding() -> Image:
    linear = np.arange(4096) / 4095
    encoded = np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)
    return np.round(255 * encoded).astype(np.uint8)


def _encode(linear: npt.NDArray[np.float32]) -> Image:
    return _encoding()[(np.clip(linear, 0, 1) * 4095 + 0.5).astype(np.uint16)]
