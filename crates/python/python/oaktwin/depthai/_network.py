"""Neural networks that a program's user names, run by ONNX Runtime in place of the device's."""

from __future__ import annotations

import ast
from dataclasses import dataclass
from os import PathLike, fspath
from typing import Any

import depthai as dai
import numpy as np
import numpy.typing as npt

from .._findings import Error
from ._frames import Image, grey_of, luma

_TYPES: dict[str, Any] = {"tensor(float)": np.float32, "tensor(float16)": np.float16, "tensor(uint8)": np.uint8}


@dataclass
class Port:
    """An input of a network: the name, the number of channels, the size (width, height) px or None for any, and the type of its values."""

    name: str
    channels: int
    size: tuple[int, int] | None
    kind: Any
    # Whether the channels of a pixel follow each other.
    is_interleaved: bool

    def tensor(self, image: Image, node: str) -> npt.NDArray[Any]:
        """The values of an image, (H, W) grey or (H, W, 3) BGR uint8, from 0 to 255."""
        if self.size is not None and image.shape[1::-1] != self.size:
            wanted, found = ("x".join(map(str, size)) for size in (self.size, image.shape[1::-1]))
            raise Error(f"{node}: the network takes images of {wanted}, not {found}; request this size, or resize with ImageManip")
        if self.channels == 1:
            image = (image if image.ndim == 2 else luma(image[..., ::-1]))[..., None]
        elif image.ndim == 2:
            image = np.repeat(image[..., None], 3, axis=2)
        values = image if self.is_interleaved else image.transpose(2, 0, 1)
        return np.ascontiguousarray(values[None]).astype(self.kind)


class Network:
    """An ONNX network of images.

    path: its file.
    node: the name of the node that runs it, for messages.
    """

    def __init__(self, path: str | PathLike[str], node: str) -> None:
        try:
            import onnxruntime  # type: ignore[import-untyped]
        except ImportError as error:
            raise Error(f"{node}: networks need ONNX Runtime; install it: pip install onnxruntime") from error
        self.path, self.node = fspath(path), node
        try:
            self._session: Any = onnxruntime.InferenceSession(self.path, providers=["CPUExecutionProvider"])
        except Exception as error:
            raise Error(f"{self.path}: {node}: ONNX Runtime cannot open it: {error}; pass an ONNX file") from error
        self.inputs = [self._port(one) for one in self._session.get_inputs()]
        self.outputs: list[str] = [one.name for one in self._session.get_outputs()]

    def _port(self, described: Any) -> Port:
        shape = list(described.shape)
        kind = _TYPES.get(described.type)
        if len(shape) != 4 or kind is None:
            raise Error(
                f"{self.path}: {self.node}: its input {described.name} is a {described.type} of the shape {shape}; "
                "images need (1, channels, height, width) or (1, height, width, channels) of float, float16 or uint8"
            )
        is_interleaved = shape[3] in (1, 3) and shape[1] not in (1, 3)
        channels, height, width = (shape[3], shape[1], shape[2]) if is_interleaved else shape[1:]
        if channels not in (1, 3):
            raise Error(f"{self.path}: {self.node}: its input {described.name} has {channels} channels; images have 1 or 3")
        size = (width, height) if isinstance(width, int) and isinstance(height, int) else None
        return Port(described.name, channels, size, kind, is_interleaved)

    @property
    def labels(self) -> list[str] | None:
        """The names of the classes, from the metadata entry `names` that Ultralytics writes; None without it."""
        try:
            names = ast.literal_eval(self._session.get_modelmeta().custom_metadata_map["names"])
            return [str(names[index]) for index in range(len(names))]
        except (KeyError, ValueError, SyntaxError, TypeError):
            return None

    def run(self, images: list[Image]) -> dict[str, npt.NDArray[np.float32]]:
        """The outputs by name for one image per input, see `Port.tensor`."""
        if len(images) != len(self.inputs):
            raise Error(f"{self.path}: {self.node}: the network has {len(self.inputs)} inputs, and {len(images)} images came; link one to each")
        feed = {port.name: port.tensor(image, self.node) for port, image in zip(self.inputs, images)}
        found = self._session.run(self.outputs, feed)
        return {name: np.asarray(value, np.float32) for name, value in zip(self.outputs, found)}


def pixels_of(frame: dai.ImgFrame) -> Image:
    """The image of a message as a network takes it: (H, W) grey or (H, W, 3) BGR uint8."""
    if frame.getType() in (dai.ImgFrame.Type.GRAY8, dai.ImgFrame.Type.RAW8):
        return grey_of(frame)
    return np.asarray(frame.getCvFrame())


def model_name(model: Any) -> str:
    """The name of a model that a program asks for: of a description, an archive, a model of the device's, or a string."""
    if isinstance(model, dai.NNModelDescription):
        return str(model.model)
    if isinstance(model, dai.NNArchive):
        return str(model.getConfig().model.metadata.name)
    return str(getattr(model, "name", model))


def chosen(networks: dict[str, str], node: str, model: Any = None) -> Network:
    """Returns the network of a node: the one that is named like the node's model, else the one that is named like the node."""
    names = [node] if model is None else [model_name(model), node]
    for name in names:
        if name in networks:
            return Network(networks[name], node)
    options = " or ".join(f"--network {name}=FILE.onnx" for name in names)
    given = ", ".join(networks) or "none"
    raise Error(f"{node}: this node cannot be simulated without a network of yours; pass {options} (given: {given})")
