"""Filters and alignment of depth images."""

from ._oaktwin import Filter, align

__all__ = ["Filter", "align"]
