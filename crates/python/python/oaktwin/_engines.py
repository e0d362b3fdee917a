"""Engines written in Python: what the native module needs to know of them, and what it hands over."""

from __future__ import annotations

import functools
import inspect
from collections.abc import Mapping
from typing import Any

import numpy as np
import numpy.typing as npt

from ._oaktwin import Error

# What an engine may ask for by the names of its parameters.
_OF_PAIR = ("left", "right", "focal_length", "baseline")
_OF_DEPTH = ("depth", "rgb", "focal_length", "baseline", "frame", "seed")
_EXAMPLE = "def engine(left, right) or def engine(depth)"


class Adapter:
    """An engine, with its name, its input and the arguments that it asks for."""

    def __init__(self, engine: Any) -> None:
        self.engine: Any = engine
        self.name = _name(engine)
        if isinstance(engine, type) or not hasattr(engine, "__call__"):
            kind = "is a class" if isinstance(engine, type) else "cannot be called"
            raise Error(f"engine: {self.name} {kind}; pass a function such as {_EXAMPLE}, or an instance with such a __call__")
        try:
            parameters = inspect.signature(engine).parameters.values()
        except (TypeError, ValueError) as error:
            raise Error(f"engine: {self.name} has no signature; wrap it in a function such as {_EXAMPLE}") from error
        names = {one.name for one in parameters}
        is_pair, is_depth = {"left", "right"} <= names, "depth" in names
        if is_pair == is_depth:
            has = "both an image pair and depth" if is_pair else "neither an image pair nor depth"
            raise Error(f"engine: {self.name} takes {has}; name its parameters as in {_EXAMPLE}")
        self.is_pair = is_pair
        self.by_place: list[str] = []
        self.by_name: list[str] = []
        offered = _OF_PAIR if is_pair else _OF_DEPTH
        for one in parameters:
            if one.kind is one.VAR_KEYWORD:
                self.by_name += [name for name in offered if name not in names]
            elif one.name in offered and one.kind is not one.VAR_POSITIONAL:
                (self.by_place if one.kind is one.POSITIONAL_ONLY else self.by_name).append(one.name)
            elif one.default is one.empty and one.kind is not one.VAR_POSITIONAL:
                known = ", ".join(offered)
                raise Error(f"engine: {self.name} has the unknown parameter {one.name}; use {known}, or give it a default")

    def measure(self, given: Mapping[str, Any]) -> tuple[bool, npt.NDArray[np.float32], npt.NDArray[np.uint8] | None]:
        """Calls the engine. Returns whether it measured disparity, its image, and its confidence."""
        places = [given[name] for name in self.by_place]
        names = {name: given[name] for name in self.by_name}
        try:
            result = self.engine(*places, **names)
        except Exception as error:
            cause = f"{type(error).__name__}: {error}".rstrip(": ")
            raise Error(f"engine: {self.name} raised {cause}; correct the engine, whose traceback is the cause") from error
        layers = result if isinstance(result, Mapping) else {"disparity" if self.is_pair else "depth": result}
        measured = [name for name in ("disparity", "depth") if layers.get(name) is not None]
        unknown = [name for name in layers if name not in ("disparity", "depth", "confidence")]
        if len(measured) != 1 or unknown:
            keys = ", ".join(map(repr, layers)) or "nothing"
            raise Error(f'engine: {self.name} returned {keys}; return "disparity" or "depth", and optionally "confidence"')
        is_disparity = measured[0] == "disparity"
        if is_disparity and not given["baseline"]:
            raise Error(f"engine: {self.name} returned disparity of a sensor without a stereo pair; return depth in metres")
        shape = np.shape(given["left" if self.is_pair else "depth"])
        image = self._image(measured[0], layers[measured[0]], shape)
        confidence = layers.get("confidence")
        return is_disparity, image, None if confidence is None else self._confidence(confidence, shape)

    def _array(self, what: str, value: object, shape: tuple[int, ...]) -> npt.NDArray[Any]:
        """What the engine returned as an array of the input's size."""
        try:
            array = np.asarray(value)
        except Exception as error:
            kind = type(value).__name__
            raise Error(f"engine: {self.name} returned a {kind} as {what}; return a NumPy array in CPU memory") from error
        if array.dtype == object:
            kind = type(value).__name__
            raise Error(f"engine: {self.name} returned a {kind} as {what}; return a NumPy array (H, W)")
        if array.shape != shape:
            raise Error(f"engine: {self.name} returned a {what} of shape {array.shape}; return one of its input's shape, {shape}")
        return array

    def _image(self, what: str, value: object, shape: tuple[int, ...]) -> npt.NDArray[np.float32]:
        array = self._array(what, value, shape)
        if array.dtype.kind != "f":
            remedy = "floating-point pixels; divide fixed point by its scale" if what == "disparity" else "floating-point metres"
            raise Error(f"engine: {self.name} returned a {what} of dtype {array.dtype}; return {remedy}")
        with np.errstate(over="ignore"):
            image = np.ascontiguousarray(array, np.float32)
        for problem, bad in (("NaN", np.isnan(image)), ("infinite", np.isinf(image)), ("negative", image < 0)):
            if bad.any():
                count = f"{np.count_nonzero(bad)} of {bad.size} pixels"
                raise Error(f"engine: {self.name} returned a {what} that is {problem} in {count}; return 0 where nothing is measured")
        if what == "disparity" and image.max(initial=0) > shape[1]:
            is_ = f"a disparity of {image.max():g} px in images that are {shape[1]} px wide"
            raise Error(f"engine: {self.name} returned {is_}; return pixels of the left image, and divide fixed point by its scale")
        return image

    def _confidence(self, value: object, shape: tuple[int, ...]) -> npt.NDArray[np.uint8]:
        array = self._array("confidence", value, shape)
        if array.dtype == np.uint8:
            return np.ascontiguousarray(array)
        if array.dtype.kind != "f" or not (np.all(array >= 0) and np.all(array <= 1)):
            is_ = f"a confidence of dtype {array.dtype}" if array.dtype.kind != "f" else "a confidence beyond 0 to 1"
            raise Error(f"engine: {self.name} returned {is_}; return uint8, or floating-point numbers from 0 to 1")
        return np.ascontiguousarray(np.rint(255 * array), np.uint8)


def _name(engine: Any) -> str:
    """The name for messages and reports: the attribute `name`, or the name of the function or class."""
    own = getattr(engine, "name", None)
    if isinstance(own, str) and own:
        return own
    if isinstance(engine, functools.partial):
        return _name(engine.func)
    own = getattr(engine, "__name__", None) or type(engine).__name__
    return "lambda" if own == "<lambda>" else str(own)
