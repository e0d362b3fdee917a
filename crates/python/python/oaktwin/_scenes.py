"""Scenes, recordings and data sets."""

from ._oaktwin import Mesh, Recording, Scene, annotators, generate

__all__ = ["Mesh", "Recording", "Scene", "annotators", "generate"]
