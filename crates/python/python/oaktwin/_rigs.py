"""Rigs: a device whose cameras all see a scene."""

from ._oaktwin import Rig

__all__ = ["Rig"]
