"""The axes of plots of depth error over distance."""

from __future__ import annotations

from importlib import import_module
from typing import Any


def new_axes() -> Any:
    """Returns the axes of a new figure."""
    try:
        plt = import_module("matplotlib.pyplot")
    except ImportError as error:
        raise ImportError("plots require Matplotlib; install it: pip install matplotlib") from error
    return plt.subplots()[1]


def finished(ax: Any, report: dict[str, Any]) -> Any:
    """Adds the labels, the title and the legend, and returns the axes."""
    ax.set_xlabel("distance [m]")
    ax.set_ylabel("depth error [%]")
    ax.set_title(f"{report['model']} {report['sensor']}")
    ax.legend()
    return ax
