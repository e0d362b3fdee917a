"""The context in which programs see a virtual device."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from os import PathLike, fspath
from pathlib import Path
from typing import Any

from .._devices import Device
from .._findings import Error
from .._scenes import Scene
from ._patch import plug, unplug
from ._twin import Engine, Settings, Twin
from ._world import Pose, World, device_of, make_world

_numbers = itertools.count(1)


class VirtualDevice:
    """A virtual device that is plugged in.

    twin: the `oaktwin.Device`.
    world: the `World` that it sees.
    """

    def __init__(self, twin: Twin) -> None:
        self._twin = twin

    @property
    def twin(self) -> Device:
        """The twin of the device."""
        return self._twin.device

    @property
    def world(self) -> World:
        """The scene and the motion in it."""
        return self._twin.world

    @property
    def identifier(self) -> str:
        """What `dai.Device.getDeviceId` returns."""
        return self._twin.identifier

    @property
    def errors(self) -> list[BaseException]:
        """What nodes have raised."""
        return list(self._twin.errors)

    def stop(self) -> None:
        """Stops all its pipelines."""
        self._twin.stop()


@contextmanager
def virtual_device(
    model_or_calibration: Device | str | PathLike[str] | dict[str, Any],
    *,
    scene: World | Scene | str | PathLike[str] | None = None,
    pose: Pose | None = None,
    look_at: Sequence[float] | None = None,
    update: Callable[[float], None] | None = None,
    engine: Engine = "stereo-matching",
    fast: bool = False,
    seed: int = 0,
    ambient: float = 1.0,
    networks: Mapping[str, str | PathLike[str]] | None = None,
) -> Iterator[VirtualDevice]:
    """Plugs in a virtual device: within the context, programs for DepthAI find it instead of hardware.

    model_or_calibration: the name of a model, the path of a unit's calibration (.json) or its content, or an `oaktwin.Device`.
    scene: what it sees: a file, an `oaktwin.Scene`, or a `World`.
    pose, look_at, update: where it is and what moves, see `World`; by default at the origin, facing along x.
    engine: how StereoDepth measures: "stereo-matching" (default) matches rendered pairs; "stereo-noise" adds a device's errors to exact
        depth, which is faster.
    fast: whether frames follow each other without waiting and none is dropped: the same bytes on every run. A program must then read
        every queue that it creates.
    seed: the noise seed.
    ambient: the scale of the scene's lights, 0 is darkness.
    networks: ONNX files for NeuralNetwork, DetectionNetwork and NeuralDepth, by the name of the model that a program asks for, or of the node.

    Raises oaktwin.Error for invalid arguments, and at the end of the context for what a node raised.
    """
    device = device_of(model_or_calibration)
    files = {name: fspath(path) for name, path in (networks or {}).items()}
    missing = next((path for path in files.values() if not Path(path).is_file()), None)
    if missing is not None:
        raise Error(f"{missing}: networks: this file does not exist; pass ONNX files by their names")
    world = make_world(scene, pose=pose, look_at=look_at, update=update)
    twin = Twin(device, world, Settings(engine=engine, fast=fast, seed=seed, ambient=ambient, networks=files, number=next(_numbers)))
    plug(twin)
    try:
        yield VirtualDevice(twin)
    except Exception as error:
        # A queue that closes because a node has failed is a consequence.
        if twin.errors and twin.errors[0] is not error:
            raise twin.errors[0] from error
        raise
    finally:
        unplug(twin)
    if twin.errors:
        raise twin.errors[0]
