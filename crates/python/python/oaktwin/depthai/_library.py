"""The installed DepthAI, whose version is checked before anything else uses it."""

from __future__ import annotations

import warnings
from importlib.metadata import PackageNotFoundError, version

from .._findings import Error, FindingWarning

# The releases that the tests run with.
TESTED = "3.12"


def check_version() -> None:
    """Raises oaktwin.Error without DepthAI, or with a release whose interface was not tested."""
    try:
        found = version("depthai")
    except PackageNotFoundError as error:
        raise Error(f"depthai: it is not installed; install depthai {TESTED}: pip install 'depthai=={TESTED}.*'") from error
    if not (found == TESTED or found.startswith(TESTED + ".")):
        raise Error(
            f"depthai: version {found} is installed, and virtual devices are tested with {TESTED}; "
            f"install that version: pip install 'depthai=={TESTED}.*'"
        )


_warned: set[str] = set()


def warn_once(text: str) -> None:
    """Issues an oaktwin.FindingWarning, the first time that the process has something to say with this text."""
    if text not in _warned:
        _warned.add(text)
        warnings.warn(text, FindingWarning, stacklevel=3)


def forget_warnings() -> None:
    """Lets the warnings of earlier virtual devices be issued again."""
    _warned.clear()
