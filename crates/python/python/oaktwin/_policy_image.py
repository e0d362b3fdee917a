"""The preparation of measured images for a policy."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from ._findings import Error

if TYPE_CHECKING:
    from collections.abc import Sequence


class PolicyImage:
    """Crops, resizes, clips and normalizes batches of measured depth (N, H, W), NumPy arrays or torch tensors."""

    def __init__(
        self,
        crop: Sequence[int] | None,
        resize: Sequence[int] | None,
        clip: Sequence[float] | None,
        normalize: bool,
        invalid: float,
    ) -> None:
        self._crop = _whole_numbers("crop", crop or (0, 0, 0, 0), "(top, bottom, left, right)", 4, 0)
        self._resize = None if resize is None else _whole_numbers("resize", resize, "(height, width)", 2, 1)
        if clip is None:
            if normalize:
                raise Error("normalize: needs clip=(near, far), which becomes 0 to 1; pass it")
            self._clip = None
        else:
            limits = [float(limit) for limit in clip]
            if len(limits) != 2 or not 0 <= limits[0] < limits[1] < math.inf:
                raise Error(f"clip: is {tuple(clip)}; pass (near, far) in metres, near below far")
            self._clip = limits
        self._normalize = bool(normalize)
        self._invalid = float(invalid)
        if not math.isfinite(self._invalid):
            raise Error(f"invalid: is {invalid}; pass a finite number, which a policy can take")

    def size(self, height: int, width: int) -> tuple[int, int]:
        """The height and width of the result."""
        top, bottom, left, right = self._crop
        if top + bottom >= height or left + right >= width:
            raise Error(f"crop: {tuple(self._crop)} leaves nothing of images of {height} x {width} pixels; remove less")
        height, width = height - top - bottom, width - left - right
        return (height, width) if self._resize is None else (self._resize[0], self._resize[1])

    def __call__(self, measured: Any) -> Any:
        images = measured[..., 0] if measured.ndim == 4 else measured
        _, height, width = images.shape
        out_height, out_width = self.size(height, width)
        top, bottom, left, right = self._crop
        images = images[:, top : height - bottom, left : width - right]
        if self._resize is not None:
            rows = _nearest(height - top - bottom, out_height)
            columns = _nearest(width - left - right, out_width)
            images = images[:, rows][:, :, columns]
        valid = images > 0
        if self._clip is not None:
            near, far = self._clip
            images = images.clip(near, far)
            if self._normalize:
                images = (images - near) * (1 / (far - near))
        if hasattr(images, "new_empty"):  # torch
            return images.masked_fill(~valid, self._invalid)
        return np.where(valid, images, np.float32(self._invalid)).astype(np.float32, copy=False)


def _nearest(count: int, wanted: int) -> list[int]:
    """The pixels whose centres are nearest to the centres of `wanted` pixels."""
    return [(2 * i + 1) * count // (2 * wanted) for i in range(wanted)]


def _whole_numbers(name: str, values: Sequence[int], what: str, count: int, least: int) -> list[int]:
    numbers = list(values)
    if len(numbers) != count or any(isinstance(n, bool) or not isinstance(n, (int, np.integer)) or n < least for n in numbers):
        raise Error(f"{name}: is {tuple(numbers)}; pass {what}, whole numbers of at least {least}")
    return [int(number) for number in numbers]
