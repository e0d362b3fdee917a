"""Devices and the names of their parameters."""

from ._oaktwin import Device, _device, models, parameters, presets

__all__ = ["Device", "models", "parameters", "presets"]
