"""What `mkdocs.yml` adds to MkDocs: generated pages, the example below its page, the Python interface, and a check of every link.

Needs the package oaktwin as it is to be documented. Each mistake is a warning, with which a strict build fails: a page without its
example, an example without its page, a missing picture, a link that leads nowhere.
"""

from __future__ import annotations

import ast
import inspect
import logging
import os
import re
import subprocess
import sys
import tempfile
from html.parser import HTMLParser
from importlib.util import find_spec
from pathlib import Path
from urllib.parse import unquote, urlsplit

import pdoc
import pdoc.doc
import pdoc.render
from mkdocs.structure.files import File

log = logging.getLogger("mkdocs.hooks.oaktwin")

ROOT = Path(__file__).resolve().parents[1]
DOCS = ROOT / "docs"
EXAMPLES = ROOT / "examples/python"

LINK = re.compile(r"(?<!!)\[([^\]]*)\]\(([^)\s]+)\)")
PICTURE = re.compile(r"!\[([^\]]*)\]\(([^)\s]+)\)")
FENCE = re.compile(r"^```.*?^```", re.M | re.S)
# "width, height: px" at the start of a line of a docstring.
ARGUMENT = re.compile(r"^(\w+(?:, \w+)*): ")
# The program's commands in `oaktwin --help`.
COMMAND = re.compile(r"^  ([a-z]+)  ", re.M)


def on_files(files, config):
    """Adds the pages that are generated, and reports examples without a page."""
    for example in sorted(EXAMPLES.glob("*.py")):
        if not (DOCS / f"python/{example.stem}.md").exists():
            log.warning(f"examples/python/{example.name}: has no page; write docs/python/{example.stem}.md")
    files.append(File.generated(config, "manual/reference/commands.md", content=commands()))
    return files


def on_page_markdown(markdown, page, config, files):
    """Checks and rewrites a page's links, and appends the example that it describes."""
    return page_text(DOCS / page.file.src_uri, markdown, log.warning)


def on_post_build(config):
    """Adds the Python interface, and checks every link of the site."""
    site = Path(config.site_dir)
    write_api(site / "api")
    check_links(site, log.warning)


def commands() -> str:
    """The command reference: what the program prints for `--help`."""

    def usage(*command: str) -> str:
        # The help's width follows the terminal's.
        run = [sys.executable, "-m", "oaktwin", *command, "--help"]
        done = subprocess.run(run, check=True, capture_output=True, text=True, encoding="utf-8", env={**os.environ, "COLUMNS": "92"})
        return done.stdout.replace("Usage: python -m oaktwin", "Usage: oaktwin")

    def sections(*command: str) -> str:
        text = usage(*command)
        section = f"```text\n{text}```\n"
        for name in COMMAND.findall(text.partition("\nCommands:")[2].partition("\nOptions:")[0]):
            if name != "help":
                heading = " ".join(["oaktwin", *command, name])
                section += f"\n{'#' * (len(command) + 2)} {heading}\n\n{sections(*command, name)}"
        return section

    return f"# Commands\n\nThis page is generated from the program's own help.\n\n{sections()}"


def outside_fences(text: str, change) -> str:
    """Changes the prose of a text, and leaves its code alone."""
    parts, end = [], 0
    for fence in FENCE.finditer(text):
        parts += [change(text[end : fence.start()]), fence[0]]
        end = fence.end()
    return "".join([*parts, change(text[end:])])


def page_text(source: Path, text: str, report) -> str:
    """Returns a page's Markdown for the site: links into the checkout become plain text, a page of an example ends with it."""
    own = source.relative_to(ROOT)
    is_example = source.parent == DOCS / "python" and source.stem != "index"
    example = (EXAMPLES / source.name).with_suffix(".py")

    def link(found: re.Match[str]) -> str:
        text, target = found.groups()
        parts = urlsplit(target)
        if parts.scheme or not parts.path:
            return found[0]
        file = (source.parent / unquote(parts.path)).resolve()
        if file.is_relative_to(DOCS / "api") or file == DOCS / "manual/reference/commands.md":
            return found[0]
        if not file.exists():
            report(f"{own}: {target}: there is no such file; correct the link")
        if is_example and file == example:
            return f"[{text}](#the-whole-example)"
        return found[0] if file.is_relative_to(DOCS) else text

    def picture(found: re.Match[str]) -> str:
        if not (source.parent / found[2]).is_file():
            report(f"{own}: {found[2]}: the picture is missing; draw it as the page says")
        return found[0]

    text = outside_fences(text, lambda prose: LINK.sub(link, PICTURE.sub(picture, prose)))
    if is_example and not example.is_file():
        report(f"{own}: there is no {example.relative_to(ROOT)}; write it, or remove the page")
    elif is_example:
        text += f"\n## The whole example\n\n```python\n{example.read_text('utf-8')}```\n"
    return text


def write_api(output: Path) -> None:
    """Writes the pages of the Python interface."""
    output = output.resolve()
    with tempfile.TemporaryDirectory() as made:
        order = write_stub(Path(made))
        sys.path.insert(0, made)
        modules = {name: pdoc.doc.Module.from_name(name) for name in ["oaktwin", "oaktwin.filters"]}
        for module in modules.values():
            prepare(module, order)
        pdoc.render.configure(show_source=False, footer_text="oaktwin")
        for name, module in modules.items():
            file = output / f"{name.replace('.', '/')}.html"
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(pdoc.render.html_module(module, modules), "utf-8")
        (output / "search.js").write_text(pdoc.render.search_index(modules), "utf-8")
        sys.path.remove(made)
    (output / "index.html").write_text(
        '<!doctype html><meta http-equiv="refresh" content="0; url=oaktwin.html"><a href="oaktwin.html">oaktwin</a>\n', "utf-8"
    )


def write_stub(folder: Path) -> dict[str, list[str]]:
    """Writes the stubs as one where pdoc takes it for the package's; returns each class's members in the stub's order."""
    spec = find_spec("oaktwin._oaktwin")
    assert spec is not None and spec.origin is not None
    package = Path(spec.origin).parent
    texts = [file.read_text("utf-8") for file in sorted(package.glob("_*.pyi"), key=lambda file: file.name != "_types.pyi")]
    relative = r"__all__ = \[.*?\]|from \.\w* import (?:\(.*?^\)|.*?$)"
    stub = "\n".join(re.sub(rf"^(?:{relative})\n", "", text, flags=re.M | re.S) for text in texts)
    # The package wraps these in its own functions.
    stub = re.sub(r"^def (accuracy|coverage|fit)\(", r"def _\1(", stub, flags=re.M)
    (folder / "oaktwin").mkdir()
    (folder / "oaktwin/__init__.pyi").write_text(f"from __future__ import annotations\n{stub}", "utf-8")
    classes = (node for node in ast.parse(stub).body if isinstance(node, ast.ClassDef))
    return {one.name: [part.name for part in one.body if isinstance(part, ast.FunctionDef)] for one in classes}


def as_markdown(docstring: str) -> str:
    """Returns a docstring with its arguments as a list."""
    lines, in_list = [], False
    for line in docstring.splitlines():
        argument = ARGUMENT.match(line)
        if argument:
            lines += [] if in_list else [""]
            line = f"- **{argument[1]}**: {line[argument.end():]}"
        in_list = bool(argument) or (in_list and line.startswith("    "))
        lines.append(line)
    return "\n".join(lines)


def prepare(item: pdoc.doc.Doc, order: dict[str, list[str]]) -> None:
    """Adds what pdoc does not find in a native module: constructors, overloaded functions and the order of members."""
    item.docstring = as_markdown(item.docstring)
    try:
        called = inspect.signature(item.obj) if callable(item.obj) else None
    except (TypeError, ValueError):
        called = None
    if called and getattr(item.obj, "__text_signature__", None) and isinstance(item, pdoc.doc.Class):
        item.docstring = f"```python\n{item.name}{called}\n```\n\n{item.docstring}"
    if called and isinstance(item, pdoc.doc.Function) and str(item.signature).startswith("(*args, **kwds)"):
        item.signature = called
    if isinstance(item, pdoc.doc.Namespace):
        if item.qualname in order:
            place = {name: number for number, name in enumerate(order[item.qualname])}
            item.members = dict(sorted(item.members.items(), key=lambda pair: place.get(pair[0], len(place))))
        for member in item.members.values():
            prepare(member, order)


class Links(HTMLParser):
    """The links of a page, and its anchors."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.links: list[str] = []
        self.places: set[str] = set()
        self.feed(text)

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        for name, value in attributes:
            if value and name == "id":
                self.places.add(value)
            elif value and name in ("href", "src"):
                self.links.append(value)


def check_links(folder: Path, report) -> None:
    """Reports every link to a file or an anchor that the site does not have."""
    pages = {file: Links(file.read_text("utf-8")) for file in sorted(folder.rglob("*.html"))}
    for file, found in pages.items():
        for link in found.links:
            parts = urlsplit(link)
            if parts.scheme or parts.netloc:
                continue
            base = folder if parts.path.startswith("/") else file.parent
            target = (base / unquote(parts.path).lstrip("/")).resolve() if parts.path else file
            target = target / "index.html" if target.is_dir() else target
            there = target.is_file()
            if there and parts.fragment and target in pages:
                there = unquote(parts.fragment) in pages[target].places
            if not there:
                report(f"{file.relative_to(folder)}: the link {link} leads nowhere")
