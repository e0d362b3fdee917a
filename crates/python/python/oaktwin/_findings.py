"""Errors and findings."""

from ._oaktwin import Error, Finding, FindingWarning, _finding

__all__ = ["Error", "Finding", "FindingWarning"]
