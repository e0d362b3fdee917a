"""Scenes, recordings and recipes of data sets."""

from ._oaktwin import Mesh, Recipe, Recording, Scene, annotators

__all__ = ["Mesh", "Recipe", "Recording", "Scene", "annotators"]
