"""Scenes and recordings."""

from ._oaktwin import Mesh, Recording, Scene, annotators

__all__ = ["Mesh", "Recording", "Scene", "annotators"]
