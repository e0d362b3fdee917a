# mypy: ignore-errors
"""Arrays of other libraries as Warp arrays, without copies."""

from contextlib import nullcontext
from typing import Any

import numpy as np
import warp as wp

from .._findings import Error

_DTYPES = {wp.float32: "float32", wp.uint16: "uint16"}


class Images:
    """A batch of images of any library: (N, H, W), or with a last dimension of 1."""

    def __init__(self, name: str, given: Any, device: Any) -> None:
        self.library = type(given).__module__.partition(".")[0]
        self._given = given
        array = _array(name, given, self.library)
        if array.device != device:
            raise Error(f"{name}: is on {array.device}, and the sensor is on {device}; make the sensor with on='{array.device}'")
        if array.dtype not in _DTYPES:
            kind = getattr(given, "dtype", array.dtype)
            raise TypeError(f"{name}: unsupported dtype {kind}; pass float32 for metres or uint16 for millimetres")
        if not array.is_contiguous:
            raise Error(f"{name}: is not C-contiguous; pass a contiguous copy")
        self.dims = tuple(array.shape)
        shape = self.dims[:3] if len(self.dims) == 4 and self.dims[3] == 1 else self.dims
        if len(shape) != 3:
            raise Error(f"{name}: has the shape {self.dims}; pass a batch of images, (N, H, W) or (N, H, W, 1)")
        self.shape = shape
        self.array = array if array.shape == shape else array.reshape(shape)
        self.millimetres = array.dtype == wp.uint16

    def empty(self, dims: tuple[int, ...]) -> Any:
        """A new array of the same library and type."""
        if self.library == "torch":
            import torch

            return torch.empty(dims, dtype=self._given.dtype, device=self._given.device)
        if self.library == "warp":
            return wp.empty(dims, dtype=self.array.dtype, device=self.array.device)
        if self.library == "numpy":
            return np.empty(dims, self._given.dtype)
        return None

    def stream(self) -> Any:
        """The context in which kernels follow what was computed before with the library."""
        if self.library == "torch" and self.array.device.is_cuda:
            import torch

            return wp.ScopedStream(wp.stream_from_torch(torch.cuda.current_stream(self._given.device)))
        return nullcontext()


def _array(name: str, given: Any, library: str) -> Any:
    if isinstance(given, wp.array):
        return given
    if library == "torch":
        if given.requires_grad:
            raise Error(f"{name}: has gradients, which a measurement does not; pass tensor.detach()")
        if not given.is_contiguous():
            raise Error(f"{name}: is not C-contiguous; pass tensor.contiguous()")
        if str(given.dtype) not in ("torch.float32", "torch.uint16"):
            raise TypeError(f"{name}: unsupported dtype {given.dtype}; pass float32 for metres or uint16 for millimetres")
        return wp.from_torch(given)
    if isinstance(given, np.ndarray):
        if given.dtype not in (np.float32, np.uint16):
            raise TypeError(f"{name}: unsupported dtype {given.dtype}; pass float32 for metres or uint16 for millimetres")
        if not given.flags.c_contiguous:
            raise Error(f"{name}: is not C-contiguous; pass numpy.ascontiguousarray(array)")
        # Flat, because a dimension of 1 may have any stride.
        flat = wp.array(given.reshape(-1), dtype=wp.dtype_from_numpy(given.dtype), device="cpu", copy=False)
        return flat.reshape(given.shape)
    if not hasattr(given, "__dlpack__"):
        raise TypeError(f"{name}: {type(given).__name__} is not an array; pass one of Warp, PyTorch, JAX or NumPy")
    return wp.from_dlpack(given)


def returned(array: Any, library: str) -> Any:
    """A Warp array as an array of another library."""
    if library == "jax" or library == "jaxlib":
        import jax

        return jax.dlpack.from_dlpack(array)
    return array
