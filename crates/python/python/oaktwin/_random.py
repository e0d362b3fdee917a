"""Random numbers that are functions of counters."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

_LOW = np.uint64(0xFFFFFFFF)
_HALF = np.uint64(32)


def words(seed: int, counter: tuple[npt.ArrayLike, npt.ArrayLike, npt.ArrayLike, npt.ArrayLike]) -> list[npt.NDArray[np.uint64]]:
    """Four independent words of 32 bits for each counter of four words: Philox4x32-10 (Salmon et al., SC 2011) with the seed as its key."""
    w0, w1, w2, w3 = (np.asarray(word, np.uint64) for word in np.broadcast_arrays(*counter))
    k0, k1 = seed & 0xFFFFFFFF, seed >> 32 & 0xFFFFFFFF
    for _ in range(10):
        p0, p1 = w0 * np.uint64(0xD2511F53), w2 * np.uint64(0xCD9E8D57)
        w0, w1 = (p1 >> _HALF) ^ w1 ^ np.uint64(k0), p1 & _LOW
        w2, w3 = (p0 >> _HALF) ^ w3 ^ np.uint64(k1), p0 & _LOW
        k0, k1 = (k0 + 0x9E3779B9) & 0xFFFFFFFF, (k1 + 0xBB67AE85) & 0xFFFFFFFF
    return [w0, w1, w2, w3]


def uniforms(
    seed: int, counter: tuple[npt.ArrayLike, npt.ArrayLike, npt.ArrayLike, npt.ArrayLike]
) -> list[npt.NDArray[np.float64]]:
    """Four independent numbers in [0, 1) for each counter of four words."""
    return [word.astype(np.float64) * 2.0**-32 for word in words(seed, counter)]


def seeds(seed: int, counter: tuple[npt.ArrayLike, npt.ArrayLike, npt.ArrayLike, npt.ArrayLike]) -> list[int]:
    """A seed of 64 bits for each counter of four words."""
    high, low, _, _ = words(seed, counter)
    return [int(item) for item in (high << _HALF | low).ravel()]
