"""The pipeline of a virtual device: DepthAI's own, without hardware."""

from __future__ import annotations

import functools
import weakref
from typing import TYPE_CHECKING, Any

import depthai as dai

from .._findings import Error
from ._holistic import add_recorders
from ._library import warn_once
from ._node import Closed, VirtualNode, creating_for

if TYPE_CHECKING:
    from typing_extensions import Self

    from ._device import DeviceStandIn
    from ._twin import Twin

RealPipeline = dai.Pipeline
# Seconds after which `run` notices that the pipeline has stopped, if no host node sends it anything.
_TASK_PATIENCE_S = 0.1
# Why nodes of the device cannot run here, and what helps.
_NETWORK = "it runs a neural network on the device's processor; "
_OWN_NETWORK = _NETWORK + "name an ONNX file of yours to run instead, with --network {name}=FILE.onnx or networks={{'{name}': ...}}"
# The nodes that run networks of the user's.
_WITH_NETWORK = ("NeuralNetwork", "DetectionNetwork", "NeuralDepth")
_HARDWARE = "it needs hardware that is not simulated; leave it out"
_CALIBRATION = "DepthAI's own code reads the calibration from hardware there; record images, and run it on them elsewhere"
_REASONS = {
    "BasaltVIO": _CALIBRATION,
    "RTABMapVIO": _CALIBRATION,
    "RTABMapSLAM": _CALIBRATION,
    "DynamicCalibration": _CALIBRATION,
    "SpatialDetectionNetwork": _NETWORK + "use DetectionNetwork with an ONNX file of yours, and SpatialLocationCalculator",
    "NeuralAssistedStereo": _NETWORK + "use StereoDepth, or NeuralDepth with an ONNX file of yours",
    "GPUStereo": "it runs on the graphics processor of an OAK 4; use StereoDepth",
    "Vpp": "its virtual patterns are not simulated; use StereoDepth",
    "AutoCalibration": "the calibration of a twin is exact or drifted as chosen, and does not change; leave it out",
    "Thermal": "thermal images are not simulated; use Camera",
}


class VirtualPipeline(RealPipeline):
    """A pipeline whose device nodes are simulated by a twin, and whose other nodes run on the host."""

    _is_started = False
    _record_config: dai.RecordConfig | None = None

    def __init__(self, device: DeviceStandIn | bool | None = None, createImplicitDevice: bool = True) -> None:
        super().__init__(createImplicitDevice=False)
        from ._device import DeviceStandIn

        if isinstance(device, bool):
            createImplicitDevice, device = device, None
        if device is not None and not isinstance(device, DeviceStandIn):
            raise TypeError("Pipeline(): the device is not one of dai.Device()")
        # A pipeline without a device may have host nodes only, as in DepthAI.
        self._owns_device = device is None and createImplicitDevice
        self._device = DeviceStandIn.for_pipeline() if self._owns_device else device
        self._nodes: list[Any] = []
        if self._device is not None:
            self._device.twin.pipelines.append(weakref.ref(self))
            self.update_calibration()

    def update_calibration(self) -> None:
        """Passes the device's calibration to DepthAI, whose nodes on the host ask their pipeline for it."""
        super().setCalibrationData(self.twin.calibration())

    @property
    def twin(self) -> Twin:
        """The twin of the pipeline's device."""
        if self._device is None:
            raise RuntimeError("Pipeline is host only, cannot create device node")
        return self._device.twin

    def create(self, kind: Any, *arguments: Any, **named: Any) -> Any:  # type: ignore[override]
        """Creates a node; those that run on either side run on the host."""
        from ._device import DeviceStandIn

        arguments = tuple(one for one in arguments if not isinstance(one, DeviceStandIn))
        name = getattr(kind, "__name__", str(kind))
        if name in _REASONS:
            raise Error(f"{name}: this node cannot be simulated: {_REASONS[name]}")
        if name in _WITH_NETWORK and not self.twin.settings.networks:
            raise Error(f"{name}: this node cannot be simulated: {_OWN_NETWORK.format(name=name)}")
        if isinstance(kind, type) and issubclass(kind, VirtualNode):
            with creating_for(self.twin):
                node = super().create(kind, *arguments, **named)
        else:
            try:
                node = super().create(self._guarded(kind), *arguments, **named)
            except RuntimeError as error:
                if "host only" not in str(error):
                    raise
                raise Error(f"{name}: this node cannot be simulated: {_HARDWARE}") from error
        if hasattr(node, "setRunOnHost"):
            node.setRunOnHost(True)
        self._nodes.append(node)
        return node

    def _guarded(self, kind: Any) -> Any:
        """A program's own host node, whose exceptions are reported instead of ending the process."""
        is_own = isinstance(kind, type) and issubclass(kind, (dai.node.HostNode, dai.node.ThreadedHostNode))
        if self._device is None or not is_own or kind.__module__.startswith("depthai"):
            return kind
        names = [name for name in ("process", "run") if any(name in base.__dict__ for base in kind.__mro__ if _is_python(base))]
        return type(kind.__name__, (kind,), {"__module__": kind.__module__, **{name: _guard(kind, name, self.twin) for name in names}})

    def start(self) -> None:
        """Starts all nodes on the host."""
        if self._record_config is not None and not self._is_started:
            add_recorders(self, self.twin, self._record_config)
        for node in self.getAllNodes():
            if hasattr(node, "setRunOnHost"):
                node.setRunOnHost(True)
            if self._device is not None and self._device.twin.clock.fast:
                for port in node.getInputs():
                    port.setBlocking(True)
        if self._device is not None:
            self._device.twin.clock.start()
        self._is_started = True
        super().start()

    def run(self) -> None:
        """Starts the pipeline, and runs in this thread what host nodes send to it, until it stops."""
        self.start()
        while self.isRunning():
            self.processTasks(waitForTasks=True, timeoutSeconds=_TASK_PATIENCE_S)
        self.wait()

    def __del__(self) -> None:
        # DepthAI's destructor waits for nodes that are written in Python without letting them run.
        if self._is_started:
            self.stop()
            self.wait()

    def getDefaultDevice(self) -> Any:
        """The device of the pipeline."""
        return self._device

    def getDevices(self) -> list[Any]:
        """All devices of the pipeline."""
        return [] if self._device is None else [self._device]

    def getDefaultDeviceProperties(self) -> Any:
        """Is not simulated: there are no properties of a connection."""
        return None

    def getCalibrationData(self, *_: Any) -> dai.CalibrationHandler:
        """The calibration of the device."""
        return self.twin.calibration()

    def isCalibrationDataAvailable(self, *_: Any) -> bool:
        """Whether the device has a calibration, which a twin always has."""
        return self._device is not None

    def setCalibrationData(self, *calibration: Any, **named: Any) -> None:
        """Sets what the device takes for its calibration, see `dai.Device.setCalibration`. The device may be named first."""
        handler: Any = named.get("calibrationDataHandler", calibration[-1] if calibration else None)
        self.twin.set_calibration(handler)

    def _ignored(self, *_: Any, **__: Any) -> None:
        warn_once("Pipeline: settings of the device's memory, tuning and connection have no effect")

    setXLinkChunkSize = setSippBufferSize = setSippDmaBufferSize = setCameraTuningBlobPath = _ignored
    setBoardConfig = setOpenVINOVersion = setDefaultDeviceProperties = _ignored

    def enableHolisticReplay(self, recordingPath: str) -> None:
        """Is refused: the source of images is the scene."""
        raise Error("Pipeline: recordings are not replayed by a virtual device; its images come from the scene")

    def enableHolisticRecord(self, recordConfig: dai.RecordConfig) -> None:
        """Records all cameras and the inertial sensor into the folder of the configuration, as `enableHolisticReplay` reads it."""
        self._record_config = recordConfig

    def __enter__(self) -> Self:
        super().__enter__()
        return self

    def __exit__(self, *reason: Any) -> None:
        super().__exit__(*reason)
        if self._owns_device and self._device is not None:
            self._device.close()


def _is_python(kind: type) -> bool:
    return not kind.__module__.startswith(("depthai", "pybind11", "builtins"))


def _guard(kind: type, name: str, twin: Twin) -> Any:
    method = getattr(kind, name)

    @functools.wraps(method)
    def guarded(self: Any, *arguments: Any, **named: Any) -> Any:
        try:
            return method(self, *arguments, **named)
        except Closed:
            return None
        except BaseException as error:
            twin.fail(error, kind.__name__)
            return None

    return guarded
