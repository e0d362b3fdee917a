"""Depth sensors and matchers."""

from ._oaktwin import DepthSensor, SensorBatch, StereoMatcher

__all__ = ["DepthSensor", "SensorBatch", "StereoMatcher"]
