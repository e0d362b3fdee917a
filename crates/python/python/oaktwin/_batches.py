"""The depth sensors of many environments."""

from ._oaktwin import SensorBatch

__all__ = ["SensorBatch"]
