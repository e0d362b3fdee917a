"""The node Depth, which chooses an algorithm, and the forms of RGBD that connect it to cameras."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import depthai as dai

from .._findings import Error
from . import _device
from ._camera import Camera
from ._frames import Type
from ._node import VirtualNode, creating_for
from ._stereo import StereoDepth
from ._stereo_config import Preset
from ._tof import ToF

if TYPE_CHECKING:
    from typing_extensions import Self

    from ._twin import Twin

_RealDepth, _RealRGBD = dai.node.Depth, dai.node.RGBD
Algorithm = _RealDepth.Algorithm
_real_build = dai.node.RGBD.build


class Depth(VirtualNode):
    """DepthAI's Depth, by the stereo pair or by time of flight. It has the outputs of the node that it creates."""

    Algorithm = Algorithm

    def __init__(self) -> None:
        super().__init__()
        self._algorithm, self._size = Algorithm.AUTO, (640, 400)
        self._fps: float | None = None
        self._preset = Preset.DEFAULT
        self._inner: Any = None
        self._align_to: dai.Node.Output | None = None

    def build(self, algorithm: Any = None, config: Any = None, fps: Any = None, size: tuple[int, int] | None = None) -> Self:
        """Chooses the algorithm, its preset, the rate and the size."""
        if isinstance(algorithm, (int, float)) and not isinstance(algorithm, Algorithm):
            algorithm, fps = None, float(algorithm)
        if isinstance(fps, tuple):
            # The form without a configuration: the algorithm, the rate and the size.
            fps, size = None, fps
        if isinstance(config, (int, float)) and not isinstance(config, type(Preset.DEFAULT)):
            config, fps = None, float(config)
        if algorithm is not None:
            self.setAlgorithm(algorithm)
        if isinstance(config, type(Preset.DEFAULT)):
            self._preset = config
        self._fps, self._size = fps, size or self._size
        return self

    def setAlgorithm(self, algorithm: Any) -> Self:
        """Chooses the algorithm; those of networks and of graphics processors are not simulated."""
        if algorithm.name not in ("AUTO", "STEREO", "STEREO_DEPTH", "TOF", "ToF"):
            raise Error(f"Depth: the algorithm {algorithm.name} cannot be simulated: it needs a network or hardware; use the stereo pair")
        self._algorithm = algorithm
        return self

    def setConfig(self, config: Any) -> Self:
        """The preset of the stereo pair."""
        self._preset = config
        return self

    def setAlignTo(self, alignTo: dai.Node.Output) -> Self:
        """Aligns depth to the images of an output."""
        self._align_to = alignTo
        return self

    @staticmethod
    def getDefaultAlgorithm(device: Any) -> Any:
        """The algorithm that AUTO chooses on a device: time of flight if it measures it, as on hardware with RVC2, else the stereo pair."""
        return _default(device.twin)

    @staticmethod
    def getSupportedAlgorithms(device: Any) -> list[Any]:
        """The algorithms that can be simulated on a device."""
        return _supported(device.twin)

    def getRequestedAlgorithm(self) -> Any:
        """The algorithm that was chosen."""
        return self._algorithm

    def getRequestedConfig(self) -> Any:
        """The preset that was chosen."""
        return self._preset

    def getResolvedAlgorithm(self) -> Any:
        """The algorithm that measures."""
        return Algorithm.TOF if isinstance(self._node(), ToF) else Algorithm.STEREO

    def getResolvedConfig(self) -> Any:
        """The preset of the stereo pair, or None by time of flight."""
        return None if isinstance(self._node(), ToF) else self._preset

    @property
    def depth(self) -> Any:
        """Depth in millimetres, 0 where invalid."""
        return self._node().depth

    @property
    def confidence(self) -> Any:
        """The confidence of depth."""
        node = self._node()
        return node.confidence if isinstance(node, ToF) else node.confidenceMap

    def _node(self) -> Any:
        if self._inner is None:
            pipeline = self.getParentPipeline()
            chosen = _default(self.twin) if self._algorithm == Algorithm.AUTO else self._algorithm
            with creating_for(self.twin):
                self._inner = pipeline.create(ToF if chosen == Algorithm.TOF else StereoDepth)
            if isinstance(self._inner, ToF):
                self._inner.build(fps=self._fps)
            else:
                self._inner.build(True, self._preset, self._size, self._fps)
                if self._align_to is not None:
                    self._align_to.link(self._inner.inputAlignTo)
        return self._inner

    def work(self) -> None:
        """Does nothing: the node that it created measures."""


def _supported(twin: Twin) -> list[Any]:
    return [algorithm for name, algorithm in (("stereo", Algorithm.STEREO), ("tof", Algorithm.TOF)) if name in twin.device.depth_sensors]


def _default(twin: Twin) -> Any:
    supported = _supported(twin)
    if not supported:
        raise RuntimeError(f"Depth: {twin.device.name} has neither a stereo pair nor a sensor of time of flight")
    return supported[-1]


def build_rgbd(self: dai.node.RGBD, *arguments: Any, **named: Any) -> dai.node.RGBD:
    """RGBD.build: without arguments as in DepthAI; otherwise connects a camera and a source of depth, which are created if asked for."""
    if not arguments and not named:
        return _real_build(self)
    pipeline, twin = _owner(self)
    first = arguments[0] if arguments else named.get("autocreate", named.get("camera"))
    names: tuple[str, ...]
    if isinstance(first, bool):
        names = ("autocreate", "mode", "size", "fps")
        given = {**dict(zip(names, arguments)), **named}
        size = given.get("size", (640, 400))
        with creating_for(twin):
            camera = pipeline.create(Camera).build()
            source = pipeline.create(StereoDepth).build(True, given.get("mode", Preset.DEFAULT), size, given.get("fps"))
    else:
        names = ("camera", "depthSource", "size", "fps")
        given = {**dict(zip(names, arguments)), **named}
        camera, source, size = given["camera"], given["depthSource"], given.get("size", (640, 400))
    colour = camera.requestOutput(size, Type.RGB888i, dai.ImgResizeMode.CROP, given.get("fps"), True)
    colour.link(self.inColor)
    _connect(pipeline, source, colour, self)
    return _real_build(self)


def _connect(pipeline: Any, source: Any, colour: dai.Node.Output, rgbd: dai.node.RGBD) -> None:
    """Links depth to RGBD, aligned to the colour images."""
    if isinstance(source, Depth):
        source = source.setAlignTo(colour)._node()
    if isinstance(source, StereoDepth):
        if not source.is_linked(source.inputAlignTo):
            colour.link(source.inputAlignTo)
        source.depth.link(rgbd.inDepth)
        return
    aligner = pipeline.create(dai.node.ImageAlign)
    aligner.setRunOnHost(True)
    source.depth.link(aligner.input)
    colour.link(aligner.inputAlignTo)
    aligner.outputAligned.link(rgbd.inDepth)


def _owner(node: Any) -> tuple[Any, Any]:
    """The pipeline of a node, and the twin of its device."""
    for twin in _device.plugged:
        for reference in twin.pipelines:
            pipeline = reference()
            if pipeline is not None and any(one is node for one in pipeline._nodes):
                return pipeline, twin
    raise Error("RGBD: it does not belong to a pipeline of a virtual device; create it with pipeline.create(dai.node.RGBD)")
