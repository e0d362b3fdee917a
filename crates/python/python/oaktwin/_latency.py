"""The latency of a device, from the catalog."""

from __future__ import annotations

from typing import Any

from ._findings import Error


def catalog_latency(sensor: Any) -> tuple[tuple[float, float], float]:
    """The shortest and longest latency of a sensor, and the largest additional delay of a frame, seconds."""
    found = sensor.latency() if hasattr(sensor, "latency") else None
    if found is None:
        raise Error(
            "latency: the catalog has none of this sensor, because no source states it; measure it with oaktwin.fit_latency, and pass seconds"
        )
    low, high = found["ms"]
    # The width of a uniform distribution with the standard deviation of the data.
    return (low * 1e-3, high * 1e-3), found["jitter_ms"] * 1e-3 * 12**0.5
