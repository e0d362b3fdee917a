"""The docstrings of the stubs match the native module's. `OAKTWIN_UPDATE_STUBS=1` writes them."""

import ast
import inspect
import os

import pytest

import oaktwin
from conftest import ROOT

PACKAGE = ROOT / "crates/python/python/oaktwin"
STUBS = ["_batches", "_cameras", "_devices", "_findings", "_images", "_oaktwin", "_rigs", "_scenes", "_sensors", "_worlds"]


def documented(body: list[ast.stmt], owner: object) -> list[tuple[ast.ClassDef | ast.FunctionDef, str]]:
    """Returns the definitions with a docstring at run time; of overloads, the first."""
    found, names = [], set()
    for node in body:
        if not isinstance(node, ast.ClassDef | ast.FunctionDef) or node.name in names:
            continue
        names.add(node.name)
        item = inspect.getattr_static(owner, node.name)
        has_own = not node.name.startswith("_") or node.name == "__call__"
        # A static method has the documentation of its type.
        text = inspect.getdoc(getattr(item, "__func__", item))
        if text and has_own:
            found.append((node, text))
        if isinstance(node, ast.ClassDef):
            found += documented(node.body, item)
    return found


def with_docstrings(source: str) -> str:
    """Returns a stub with the native module's docstrings instead of its own."""
    lines = source.splitlines()
    nodes = documented(ast.parse(source).body, oaktwin._oaktwin)
    for node, text in sorted(nodes, key=lambda pair: pair[0].lineno, reverse=True):
        indent = " " * (node.col_offset + 4)
        end = "" if "\n" not in text else "\n"
        docstring = "\n".join(f"{indent}{line}".rstrip() for line in f'"""{text}{end}'.splitlines())
        docstring += f'\n{indent}"""' if end else '"""'
        first = node.body[0]
        assert isinstance(first, ast.Expr | ast.FunctionDef | ast.AnnAssign), node.name
        is_docstring = isinstance(first, ast.Expr) and isinstance(getattr(first.value, "value", None), str)
        is_empty = isinstance(first, ast.Expr) and getattr(first.value, "value", None) is ...
        start = first.lineno - 1
        if is_docstring:
            lines[start : first.end_lineno] = docstring.splitlines()
        elif is_empty:
            lines[start : start + 1] = [lines[start][: first.col_offset].rstrip(), *docstring.splitlines()]
        else:
            start -= len(getattr(first, "decorator_list", []))
            lines[start:start] = docstring.splitlines()
    return "\n".join(lines) + "\n"


@pytest.mark.parametrize("name", STUBS)
def test_docstrings_are_those_of_the_module(name):
    path = PACKAGE / f"{name}.pyi"
    source = path.read_text("utf-8")
    expected = with_docstrings(source)
    if os.environ.get("OAKTWIN_UPDATE_STUBS"):
        path.write_text(expected, "utf-8")
    else:
        assert source == expected, "run this test with OAKTWIN_UPDATE_STUBS=1, and read the difference"


def test_calls_have_signatures():
    device = oaktwin.Device("OAK4-D")
    for item, parameters in [
        (oaktwin.DepthSensor(device), ["depth", "rgb", "frame", "seed", "device_seed", "out"]),
        (oaktwin.StereoMatcher(device), ["left", "right"]),
        (oaktwin.Filter("median"), ["image", "rgb", "out"]),
    ]:
        assert list(inspect.signature(item).parameters) == parameters
        assert "see the class" in inspect.getdoc(type(item).__call__)
        assert str(inspect.signature(type(item))) != str(inspect.signature(item)), "a constructor keeps its own"
