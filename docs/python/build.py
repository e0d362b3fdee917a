"""Builds the manual of the Python package with pdoc: python docs/python/build.py FOLDER

Its start page is index.md; every other NAME.md here is the page of examples/python/NAME.py, whose text it shows below its own.
The interface is that of the package as it is installed, with the types of its stubs. Ends with 1 and a line for each mistake:
a page without its example or an example without its page, a picture that is missing, a link that leads nowhere.
"""

from __future__ import annotations

import ast
import inspect
import re
import sys
import tempfile
from html.parser import HTMLParser
from importlib.util import find_spec
from pathlib import Path
from urllib.parse import unquote, urlsplit

import pdoc
import pdoc.doc
import pdoc.render

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
EXAMPLES = ROOT / "examples/python"
# pdoc documents modules: the pages are those of a package that is written for it.
PAGES = "examples"

LINK = re.compile(r"(?<!!)\[([^\]]*)\]\(([^)\s]+)\)")
PICTURE = re.compile(r"!\[([^\]]*)\]\(([^)\s]+)\)")
FENCE = re.compile(r"^```.*?^```", re.M | re.S)
# "width, height: px" at the start of a line of a docstring.
ARGUMENT = re.compile(r"^(\w+(?:, \w+)*): ")


def outside_fences(text: str, change) -> str:
    """The text with its prose changed, and its code as it is."""
    parts, end = [], 0
    for fence in FENCE.finditer(text):
        parts += [change(text[end : fence.start()]), fence[0]]
        end = fence.end()
    return "".join([*parts, change(text[end:])])


def page(source: Path, mistakes: list[str]) -> str:
    """A page's Markdown as the site has it: links between pages, none into the checkout."""
    own = source.relative_to(ROOT)
    example = (EXAMPLES / source.name).with_suffix(".py")

    def link(found: re.Match[str]) -> str:
        text, target = found.groups()
        parts = urlsplit(target)
        if parts.scheme or not parts.path:
            return found[0]
        file = (HERE / unquote(parts.path)).resolve()
        if source.stem == "index" and parts.path == "oaktwin.html":
            return found[0]
        if not file.exists():
            mistakes.append(f"{own}: {target}: there is no such file; correct the link")
        if file == example:
            return f"[{text}](#the-whole-example)"
        if file.parent == HERE and file.suffix == ".md":
            return f"[{text}]({file.stem}.html{'#' + parts.fragment if parts.fragment else ''})"
        return text

    def picture(found: re.Match[str]) -> str:
        text, target = found.groups()
        file = (HERE / target).resolve()
        if not file.is_file():
            mistakes.append(f"{own}: {target}: the picture is missing; draw it as the page says")
        return f"![{text}]({file})"

    text = source.read_text("utf-8")
    text = outside_fences(text, lambda prose: LINK.sub(link, PICTURE.sub(picture, prose)))
    if source.stem != "index":
        if not example.is_file():
            mistakes.append(f"{own}: there is no {example.relative_to(ROOT)}; write it, or remove the page")
            return text
        text += f"\n## The whole example\n\n```python\n{example.read_text('utf-8')}```\n"
    return text


def title(text: str, name: str) -> str:
    found = re.search(r"^# (.+)$", text, re.M)
    return found[1] if found else name


def write_pages(folder: Path, mistakes: list[str]) -> list[str]:
    """Writes the package of the pages; the names of its modules."""
    pages = {file.stem: file for file in sorted(HERE.glob("*.md")) if file.stem != "index"}
    for example in sorted(EXAMPLES.glob("*.py")):
        if example.stem not in pages:
            mistakes.append(f"examples/python/{example.name}: has no page; write docs/python/{example.stem}.md")
    texts = {name: page(file, mistakes) for name, file in pages.items()}
    start = page(HERE / "index.md", mistakes)
    start += "\n## Examples\n" + "".join(f"- [{title(text, name)}]({PAGES}/{name}.html)\n" for name, text in texts.items())
    package = folder / PAGES
    package.mkdir()
    for name, text in {"__init__": start, **texts}.items():
        (package / f"{name}.py").write_text(f"__doc__ = {text!r}\n", "utf-8")
    return [PAGES, *(f"{PAGES}.{name}" for name in texts)]


def write_stub(folder: Path) -> dict[str, list[str]]:
    """Writes the native module's stub where pdoc finds it as that of the package; its classes' members in its order."""
    spec = find_spec("oaktwin._oaktwin")
    assert spec is not None and spec.origin is not None
    stub = Path(spec.origin).with_name("_oaktwin.pyi").read_text("utf-8")
    (folder / "oaktwin").mkdir()
    # Only what the package takes from it as it is: not the function that its own `accuracy` wraps.
    stub = re.sub(r"^__all__ = \[.*?^\]\n", "", stub, flags=re.M | re.S).replace("def accuracy(", "def _accuracy(")
    (folder / "oaktwin/__init__.pyi").write_text(f"from __future__ import annotations\n{stub}", "utf-8")
    classes = (node for node in ast.parse(stub).body if isinstance(node, ast.ClassDef))
    return {one.name: [part.name for part in one.body if isinstance(part, ast.FunctionDef)] for one in classes}


def as_markdown(docstring: str) -> str:
    """A docstring with its arguments as a list."""
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
    """Shows what pdoc does not find in a native module: how a class is called, functions whose stubs are overloaded, and the
    order of members."""
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
    """The links of a page, and the places in it that links may lead to."""

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


def check_links(folder: Path, mistakes: list[str]) -> None:
    pages = {file: Links(file.read_text("utf-8")) for file in sorted(folder.rglob("*.html"))}
    for file, found in pages.items():
        for link in found.links:
            parts = urlsplit(link)
            if parts.scheme or parts.netloc:
                continue
            target = (file.parent / unquote(parts.path)).resolve() if parts.path else file
            there = target.is_file()
            if there and parts.fragment and target in pages:
                there = unquote(parts.fragment) in pages[target].places
            if not there:
                mistakes.append(f"{file.relative_to(folder)}: the link {link} leads nowhere")


def build(output: Path) -> list[str]:
    """Writes the site; its mistakes."""
    mistakes: list[str] = []
    output = output.resolve()
    with tempfile.TemporaryDirectory() as made:
        folder = Path(made)
        names = write_pages(folder, mistakes)
        order = write_stub(folder)
        sys.path.insert(0, made)
        modules = {name: pdoc.doc.Module.from_name(name) for name in ["oaktwin", "oaktwin.filters", *names]}
        for name, module in modules.items():
            if name.startswith("oaktwin"):
                prepare(module, order)
        pdoc.render.configure(show_source=False, footer_text="oaktwin")
        for name, module in modules.items():
            file = output / f"{name.replace('.', '/')}.html"
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(pdoc.render.html_module(module, modules), "utf-8")
        (output / "search.js").write_text(pdoc.render.search_index(modules), "utf-8")
        sys.path.remove(made)
    (output / "index.html").write_text(
        f'<!doctype html><meta charset="utf-8"><meta http-equiv="refresh" content="0; url={PAGES}.html">'
        f'<title>oaktwin</title><a href="{PAGES}.html">oaktwin for Python</a>\n',
        "utf-8",
    )
    check_links(output, mistakes)
    return mistakes


def main() -> int:
    if len(sys.argv) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    mistakes = build(Path(sys.argv[1]))
    for mistake in mistakes:
        print(f"error: {mistake}", file=sys.stderr)
    print(Path(sys.argv[1], "index.html"))
    return 1 if mistakes else 0


if __name__ == "__main__":
    sys.exit(main())
