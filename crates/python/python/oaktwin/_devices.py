"""Devices and the names of their parameters."""

from ._oaktwin import Device, _device, models, parameters, presets, simulate_imu

__all__ = ["Device", "models", "parameters", "presets", "simulate_imu"]
