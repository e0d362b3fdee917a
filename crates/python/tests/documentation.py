"""The commands and snippets of the README, the manual, the examples and the docstrings."""

import re
import shlex
from dataclasses import dataclass
from pathlib import Path

from conftest import ROOT

BLOCK = re.compile(r"^```(\w*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
# What starts a command that a page or a docstring shows.
PROGRAMS = ("oaktwin ", "python -m oaktwin ", "python examples/python/")


@dataclass(frozen=True)
class Page:
    """A page and its code blocks by language, in order."""

    name: str
    shell: tuple[str, ...]
    python: tuple[str, ...]


def pages() -> list[Page]:
    """Returns all pages with code: README files and the manual."""
    paths = [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md")), *sorted((ROOT / "examples").rglob("README.md"))]
    found = []
    for path in paths:
        blocks = BLOCK.findall(path.read_text(encoding="utf-8"))
        shell = [command for language, text in blocks if language == "sh" for command in commands(text)]
        python = [text for language, text in blocks if language == "python"]
        if shell or python:
            found.append(Page(path.relative_to(ROOT).as_posix(), tuple(shell), tuple(python)))
    return found


def docstrings() -> list[Page]:
    """Returns the commands in the docstrings of the example programs."""
    found = []
    for path in sorted((ROOT / "examples/python").glob("*.py")):
        text = re.match(r'(?:#!.*\n)?r?"""(.*?)"""', path.read_text(encoding="utf-8"), re.DOTALL)
        lines = [line for line in text.group(1).splitlines() if line.startswith("    ")]
        shell = [command for command in commands("\n".join(lines)) if command.startswith(PROGRAMS)]
        found.append(Page(path.relative_to(ROOT).as_posix(), tuple(shell), ()))
    return found


def commands(text: str) -> list[str]:
    """Returns the commands of a shell block, one line each, without comments."""
    joined = re.sub(r"\\\n\s*", "", text)
    lines = (re.sub(r"\s+#.*", "", line).strip() for line in joined.splitlines())
    return [line for line in lines if line and not line.startswith("#")]


def words(command: str) -> tuple[list[str], Path | None, Path | None]:
    """Splits a command into its words and the files of its standard input and output."""
    items = shlex.split(command)
    files: dict[str, Path | None] = {"<": None, ">": None}
    for sign in files:
        if sign in items:
            place = items.index(sign)
            files[sign] = Path(items[place + 1])
            del items[place : place + 2]
    return items, files["<"], files[">"]
