"""Many worlds at once."""

from ._oaktwin import Worlds

__all__ = ["Worlds"]
