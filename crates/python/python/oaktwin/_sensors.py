"""Depth sensors, filters and matchers."""

from ._oaktwin import DepthSensor, Filter, StereoMatcher, align

__all__ = ["DepthSensor", "Filter", "StereoMatcher", "align"]
