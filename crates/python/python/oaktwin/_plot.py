"""The axes of plots of depth error over distance."""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from ._types import _Json


def new_axes() -> Axes:
    """Returns the axes of a new figure."""
    try:
        plt = import_module("matplotlib.pyplot")
    except ImportError as error:
        raise ImportError("plots require Matplotlib; install it: pip install matplotlib") from error
    axes: Axes = plt.subplots()[1]
    return axes


def finished(ax: Axes, report: _Json) -> Axes:
    """Adds the labels, the title and the legend, and returns the axes."""
    ax.set_xlabel("distance [m]")
    ax.set_ylabel("depth error [%]")
    ax.set_title(f"{report['model']} {report['sensor']}")
    ax.legend()
    return ax
