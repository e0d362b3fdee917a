"""The stand-in for dai.Device."""

from __future__ import annotations

import weakref
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import depthai as dai

from .._findings import Error
from ._library import warn_once

if TYPE_CHECKING:
    from types import TracebackType

    from typing_extensions import Self

    from ._twin import Twin

RealDevice = dai.Device
Socket = dai.CameraBoardSocket
# The twins that programs find, in the order in which they were plugged in.
plugged: list[Twin] = []
# The names that DepthAI gives to cameras by their sockets.
_NAMES = {Socket.CAM_A: "color", Socket.CAM_B: "left", Socket.CAM_C: "right"}
# Plausible constants, documented as such: degrees Celsius, bytes.
_TEMPERATURE_C = 45.0
_USED_BYTES, _TOTAL_BYTES = 64 << 20, 512 << 20


class _DeviceKind(type):
    """Makes the real class's other attributes, such as its enumerations, those of the stand-in."""

    def __getattr__(cls, name: str) -> Any:
        value = getattr(RealDevice, name)
        if callable(value) and not isinstance(value, type):
            raise Error(f"Device.{name}: this function is not simulated; leave it out")
        return value


class DeviceStandIn(metaclass=_DeviceKind):
    """DepthAI's Device, of a twin. Without an argument, the first virtual device that no program uses."""

    def __init__(self, nameOrDeviceInfo: Any = None, *_: Any, **__: Any) -> None:
        self.twin = _find(nameOrDeviceInfo)
        self._is_closed = False
        self.twin.holder = weakref.ref(self)

    @classmethod
    def for_pipeline(cls) -> DeviceStandIn:
        """The default device of a new pipeline: the first one that is free, or the first one."""
        return cls(next((_info(twin) for twin in plugged if not twin.is_open), _info(plugged[0]) if plugged else None))

    def __enter__(self) -> Self:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None:
        self.close()

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_") or not hasattr(RealDevice, name):
            raise AttributeError(f"Device has no attribute {name!r}")
        raise Error(f"Device.{name}: this function is not simulated; leave it out")

    # Finding devices.
    @staticmethod
    def getAllAvailableDevices() -> list[dai.DeviceInfo]:
        """The virtual devices that no program uses."""
        return [_info(twin) for twin in plugged if not twin.is_open]

    @staticmethod
    def getAllConnectedDevices() -> list[dai.DeviceInfo]:
        """All virtual devices."""
        return [_info(twin) for twin in plugged]

    @staticmethod
    def getFirstAvailableDevice(skipInvalidDevices: bool = True) -> tuple[bool, dai.DeviceInfo]:
        """Whether there is a virtual device, and which."""
        found = DeviceStandIn.getAllAvailableDevices()
        return (True, found[0]) if found else (False, dai.DeviceInfo())

    @staticmethod
    def getAnyAvailableDevice(*_: Any) -> tuple[bool, dai.DeviceInfo]:
        """The same as `getFirstAvailableDevice`."""
        return DeviceStandIn.getFirstAvailableDevice()

    @staticmethod
    def getDeviceById(deviceId: str) -> tuple[bool, dai.DeviceInfo]:
        """Whether a virtual device has this identifier, and which."""
        found = [_info(twin) for twin in plugged if twin.identifier == deviceId]
        return (True, found[0]) if found else (False, dai.DeviceInfo())

    getDeviceByIdOrName = getDeviceById

    # What it is.
    def getDeviceInfo(self) -> dai.DeviceInfo:
        """Its identifier, protocol and platform."""
        return _info(self.twin)

    def getDeviceId(self) -> str:
        """Its identifier, which says that it is virtual."""
        return self.twin.identifier

    getMxId = getDeviceId

    def getDeviceName(self) -> str:
        """The name of the product."""
        return self.twin.name

    getProductName = getDeviceName

    def getPlatform(self) -> dai.Platform:
        """RVC2 or RVC4."""
        return dai.Platform.RVC4 if self.twin.is_rvc4 else dai.Platform.RVC2

    def getPlatformAsString(self) -> str:
        """RVC2 or RVC4."""
        return "RVC4" if self.twin.is_rvc4 else "RVC2"

    def getUsbSpeed(self) -> dai.UsbSpeed:
        """A plausible constant: SUPER, and UNKNOWN where the device has Ethernet."""
        return dai.UsbSpeed.UNKNOWN if "POE" in self.twin.name or self.twin.is_rvc4 else dai.UsbSpeed.SUPER

    def getProtocol(self) -> dai.XLinkProtocol:
        """USB or TCP/IP."""
        return _info(self.twin).protocol

    # Its cameras.
    def getConnectedCameras(self, type: dai.CameraSensorType | None = None) -> list[dai.CameraBoardSocket]:
        """The sockets that have cameras, of one type if it is given."""
        return [one.socket for one in self.getConnectedCameraFeatures() if type is None or type in one.supportedTypes]

    def getConnectedCameraFeatures(self) -> list[dai.CameraFeatures]:
        """The cameras: sensor, size, type and the configurations in which they are simulated."""
        return [_features(self.twin, socket) for socket in self.twin.cameras]

    def getCameraSensorNames(self) -> dict[dai.CameraBoardSocket, str]:
        """The names of the sensors by socket."""
        return {one.socket: one.sensorName for one in self.getConnectedCameraFeatures()}

    def getStereoPairs(self) -> list[dai.StereoPair]:
        """The pair that StereoDepth uses, with its baseline in centimetres."""
        sockets = self.twin.stereo_sockets
        if sockets is None:
            return []
        pair = dai.StereoPair()
        pair.left, pair.right, pair.isVertical = *sockets, False
        pair.baseline = 100 * self.twin.device.rectification().baseline
        return [pair]

    getAvailableStereoPairs = getStereoPairs

    # Its calibration.
    def readCalibration(self) -> dai.CalibrationHandler:
        """The calibration of the unit, or of the nominal model."""
        return self.twin.calibration()

    readCalibration2 = readCalibrationOrDefault = readFactoryCalibration = readCalibration
    readFactoryCalibrationOrDefault = getCalibration = tryGetCalibration = readCalibration

    def isCalibrationAvailable(self) -> bool:
        """True: a twin always has a calibration."""
        return True

    isEepromAvailable = isCalibrationAvailable

    def setCalibration(self, calibrationDataHandler: dai.CalibrationHandler) -> None:
        """Sets what the device takes for its calibration until it is closed. Images stay as they are, because the cameras do."""
        self.twin.set_calibration(calibrationDataHandler)

    def _refuse_to_flash(self, *_: Any, **__: Any) -> bool:
        raise Error("Device: a virtual device has no memory to write to; pass the calibration to virtual_device instead")

    flashCalibration = tryFlashCalibration = flashFactoryCalibration = _refuse_to_flash
    factoryResetCalibration = flashEepromClear = flashFactoryEepromClear = _refuse_to_flash

    # Its light and its inertial sensor.
    def setIrLaserDotProjectorIntensity(self, intensity: float, mask: int = -1) -> bool:
        """Sets the dot projector, from 0 to 1. Returns whether the device has one."""
        self.twin.light.dots = _share(intensity, "setIrLaserDotProjectorIntensity")
        return self.twin.shots.has_projector

    def setIrFloodLightIntensity(self, intensity: float, mask: int = -1) -> bool:
        """Sets the flood light, from 0 to 1, which is not simulated: a warning says so once."""
        self.twin.light.flood = _share(intensity, "setIrFloodLightIntensity")
        return self.twin.shots.has_projector

    def getIrDrivers(self) -> list[tuple[str, int, int]]:
        """The driver of the dot projector, if there is one."""
        return [("LM3644", 2, 0x63)] if self.twin.shots.has_projector else []

    def getIMUFirmwareVersion(self) -> dai.Version:
        """A plausible constant, 0.0.0."""
        return dai.Version(0, 0, 0)

    getEmbeddedIMUFirmwareVersion = getIMUFirmwareVersion

    def getConnectedIMU(self) -> str:
        """The first inertial part, or NONE."""
        imu = self.twin.report.get("imu")
        return str(imu["parts"][0]) if imu and imu.get("parts") else "NONE"

    # Its state: plausible constants.
    def getChipTemperature(self) -> dai.ChipTemperature:
        """A plausible constant, 45 °C."""
        temperature = dai.ChipTemperature()
        for part in ("css", "mss", "upa", "dss", "average"):
            setattr(temperature, part, _TEMPERATURE_C)
        return temperature

    def _memory(self) -> dai.MemoryInfo:
        """A plausible constant."""
        memory = dai.MemoryInfo()
        memory.used, memory.total, memory.remaining = _USED_BYTES, _TOTAL_BYTES, _TOTAL_BYTES - _USED_BYTES
        return memory

    getDdrMemoryUsage = getCmxMemoryUsage = getLeonCssHeapUsage = getLeonMssHeapUsage = _memory

    def _processor(self) -> dai.CpuUsage:
        """A plausible constant."""
        return dai.CpuUsage()

    getLeonCssCpuUsage = getLeonMssCpuUsage = _processor

    def getBootloaderVersion(self) -> None:
        """None: there is no boot loader."""

    def hasCrashDump(self) -> bool:
        """False: a virtual device does not crash."""
        return False

    def hasCrashed(self) -> bool:
        """False, see `hasCrashDump`."""
        return False

    hasGPU = isGpuStereoSupported = isNeuralDepthSupported = hasCrashDump

    def close(self) -> None:
        """Stops its pipelines and frees it."""
        if not self._is_closed:
            self._is_closed = True
            self.twin.stop()

    def isClosed(self) -> bool:
        """Whether it was closed."""
        return self._is_closed

    def isPipelineRunning(self) -> bool:
        """Whether one of its pipelines runs."""
        return bool(self.twin.running())

    def getLogLevel(self) -> dai.LogLevel:
        """The level of messages, WARN."""
        return dai.LogLevel.WARN

    getLogOutputLevel = getLogLevel

    def _has_no_effect(self, *_: Any, **__: Any) -> None:
        """Accepts a setting of the connection or of the log, which has no effect."""

    setLogLevel = setLogOutputLevel = setXLinkChunkSize = setXLinkRateLimit = setTimesync = _has_no_effect
    setSystemInformationLoggingRate = setMaxReconnectionAttempts = registerCrashdumpCallback = _has_no_effect

    def addLogCallback(self, callback: Callable[[dai.LogMessage], None]) -> int:
        """Accepts a function that is never called: a virtual device writes no log."""
        return 0

    def removeLogCallback(self, callbackId: int) -> bool:
        """Accepts the number of a function."""
        return True


def _share(intensity: float, name: str) -> float:
    if not 0 <= intensity <= 1:
        warn_once(f"Device.{name}: {intensity} is outside 0 to 1 and is limited")
    return min(max(float(intensity), 0.0), 1.0)


def _find(wanted: Any) -> Twin:
    if not plugged:
        raise RuntimeError("No available devices: no virtual device is plugged in")
    if wanted is None or isinstance(wanted, (dai.UsbSpeed, dai.Device.Config)):
        free = [twin for twin in plugged if not twin.is_open]
        if not free:
            names = ", ".join(twin.identifier for twin in plugged)
            raise RuntimeError(f"No available devices: {names} in use already; close the Device first")
        return free[0]
    name = wanted if isinstance(wanted, str) else wanted.getDeviceId() or wanted.name
    for twin in plugged:
        if name in (twin.identifier, twin.name, ""):
            return twin
    names = ", ".join(twin.identifier for twin in plugged)
    raise RuntimeError(f"Cannot find any device with given deviceInfo: {name}; the virtual devices are {names}")


def _info(twin: Twin) -> dai.DeviceInfo:
    info = dai.DeviceInfo()
    info.deviceId = twin.identifier
    info.name = "127.0.0.1" if "POE" in twin.name or twin.is_rvc4 else "virtual"
    info.state = dai.XLinkDeviceState.X_LINK_UNBOOTED
    has_network = info.name != "virtual"
    info.protocol = dai.XLinkProtocol.X_LINK_TCP_IP if has_network else dai.XLinkProtocol.X_LINK_USB_VSC
    info.platform = dai.XLinkPlatform.X_LINK_RVC4 if twin.is_rvc4 else dai.XLinkPlatform.X_LINK_MYRIAD_X
    return info


def _features(twin: Twin, socket: dai.CameraBoardSocket) -> dai.CameraFeatures:
    role, camera = twin.cameras[socket]
    sensor = next((one["sensor"] for one in twin.report["cameras"] if one["role"] == role), "")
    if role == "tof":
        kind = dai.CameraSensorType.TOF
    else:
        kind = dai.CameraSensorType.COLOR if twin.has_colour(socket) else dai.CameraSensorType.MONO
    features = dai.CameraFeatures()
    features.socket, features.sensorName, features.name = socket, sensor, "tof" if role == "tof" else _NAMES[socket]
    features.width, features.height = camera.size
    features.supportedTypes = [kind]
    features.orientation = dai.CameraImageOrientation.NORMAL
    mode = dai.CameraSensorConfig()
    mode.width, mode.height = camera.size
    mode.minFps, mode.maxFps, mode.type = 1.0, 120.0, kind
    features.configs = [mode]
    return features
