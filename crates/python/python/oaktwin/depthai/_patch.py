"""The names of DepthAI that programs use, replaced while a virtual device is plugged in."""

from __future__ import annotations

import threading
from typing import Any

import depthai as dai

from . import _device
from ._camera import Camera
from ._capability import Capability
from ._depth_group import Depth, build_rgbd
from ._device import DeviceStandIn
from ._image_nodes import EdgeDetector, FeatureTracker, Gate, VideoEncoder
from ._imu import IMU
from ._legacy_cameras import ColorCamera, MonoCamera
from ._network_nodes import DetectionNetwork, NeuralDepth, NeuralNetwork
from ._node import VirtualNode
from ._pipeline import VirtualPipeline
from ._script import Script
from ._stereo import StereoDepth
from ._tof import ToF, ToFBase
from ._twin import Twin
from ._warp import Warp

_NODES = (
    Camera,
    ColorCamera,
    Depth,
    DetectionNetwork,
    EdgeDetector,
    FeatureTracker,
    Gate,
    IMU,
    MonoCamera,
    NeuralDepth,
    NeuralNetwork,
    Script,
    StereoDepth,
    ToF,
    ToFBase,
    VideoEncoder,
    Warp,
)
_lock = threading.RLock()
_before: list[tuple[Any, str, Any]] = []


def plug(twin: Twin) -> None:
    """Makes a twin a device that programs find, and replaces DepthAI's names for the first one."""
    with _lock:
        if not _device.plugged:
            _replace()
        _device.plugged.append(twin)


def unplug(twin: Twin) -> None:
    """Removes a twin, and puts DepthAI's own names back after the last one."""
    with _lock:
        twin.stop()
        _device.plugged.remove(twin)
        if not _device.plugged:
            while _before:
                owner, name, value = _before.pop()
                setattr(owner, name, value)


def _replace() -> None:
    _set(dai, "Device", DeviceStandIn)
    _set(dai, "Pipeline", VirtualPipeline)
    _set(dai, "ImgFrameCapability", Capability)
    for stand_in in _NODES:
        _set(dai.node, stand_in.__name__, stand_in)
    _set(dai.node.RGBD, "build", build_rgbd)
    _set(dai.Node.Output, "createOutputQueue", _create_queue)


def _set(owner: Any, name: str, value: Any) -> None:
    _before.append((owner, name, getattr(owner, name)))
    setattr(owner, name, value)


_real_create_queue = dai.Node.Output.createOutputQueue


def _create_queue(self: dai.Node.Output, maxSize: int = 16, blocking: bool = False) -> dai.MessageQueue:
    """Remembers which outputs a program reads, and makes their queues lossless on a device that drops nothing."""
    node = self.getParent()
    if isinstance(node, VirtualNode):
        node.queued_outputs.add(self.getName())
    is_fast = any(twin.clock.fast for twin in _device.plugged)
    return _real_create_queue(self, maxSize, blocking or is_fast)
