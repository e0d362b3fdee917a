# mypy: ignore-errors
"""Depth sensors on Warp, PyTorch and JAX arrays, on the device where they are: the bits of `oaktwin.DepthSensor` without a copy to the host.

Needs `pip install warp-lang`. Environments of a simulator are measured where it renders them:

>>> import oaktwin, oaktwin.warp
>>> sensor = oaktwin.warp.DepthSensor(oaktwin.Device("OAK4-D"), hfov_deg=77.0, seed=7)
>>> measured = sensor(depth)  # (N, H, W) metres in, the same kind of array out
"""

try:
    import warp as _warp
except ImportError as error:
    raise ImportError("oaktwin.warp needs Warp: pip install warp-lang") from error

_warp.config.quiet = True

from ._sensor import DepthSensor  # noqa: E402

__all__ = ["DepthSensor"]
