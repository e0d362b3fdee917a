"""Depth sensors and matchers."""

from ._oaktwin import DepthSensor, StereoMatcher

__all__ = ["DepthSensor", "StereoMatcher"]
