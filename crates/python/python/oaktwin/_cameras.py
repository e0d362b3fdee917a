"""Cameras, poses and rectification."""

from ._oaktwin import Camera, Rectification, _camera, look_at

__all__ = ["Camera", "Rectification", "look_at"]
