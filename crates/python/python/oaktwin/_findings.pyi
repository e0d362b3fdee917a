from typing import Literal, final

__all__ = ["Error", "Finding", "FindingWarning"]

class Error(ValueError):
    """Raised for invalid input; the message says where, what is wrong and what to do."""

class FindingWarning(UserWarning):
    """A non-fatal problem with a result."""

@final
class Finding:
    """A note, warning or error about an input or result; str() is the line that the program prints.

    code: a short stable identifier, such as "own-focal-length".
    level: "note", "warning" or "error".
    place: the path of the field or prim concerned.
    message: what was found.
    remedy: what to do about it; empty if nothing is required.
    """
    @property
    def code(self) -> str: ...
    @property
    def level(self) -> Literal["note", "warning", "error"]: ...
    @property
    def place(self) -> str: ...
    @property
    def message(self) -> str: ...
    @property
    def remedy(self) -> str: ...
    def __reduce__(self) -> tuple[object, ...]: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...

def _finding(code: str, level: str, place: str, message: str, remedy: str, line: str) -> Finding: ...
