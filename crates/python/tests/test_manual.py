"""The manual's hooks find what is wrong with its pages, and everything in the package is documented."""

import importlib.util
import inspect

import pytest

import oaktwin
from conftest import ROOT

pytest.importorskip("mkdocs")


@pytest.fixture
def hooks(tmp_path, monkeypatch):
    """The hooks, for a manual of one example."""
    spec = importlib.util.spec_from_file_location("manual_hooks", ROOT / "docs/hooks.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    pages, examples = tmp_path / "docs/python", tmp_path / "examples/python"
    pages.mkdir(parents=True)
    examples.mkdir(parents=True)
    (pages / "index.md").write_text("# Start\n")
    (pages / "one.md").write_text("# One\n\n[it](../../examples/python/one.py) ![p](one.png)\n\n```\n[no](link.md)\n```\n")
    (pages / "one.png").write_bytes(b"\x89PNG")
    (examples / "one.py").write_text("print(1)\n")
    for name, value in {"DOCS": tmp_path / "docs", "ROOT": tmp_path, "EXAMPLES": examples}.items():
        monkeypatch.setattr(module, name, value)
    return module


def page(hooks):
    """Returns the page of the example and the mistakes in it."""
    mistakes = []
    source = hooks.DOCS / "python/one.md"
    text = hooks.page_text(source, source.read_text(), mistakes.append)
    return text, mistakes


def test_a_page_ends_with_its_example(hooks):
    text, mistakes = page(hooks)
    assert mistakes == []
    assert "[it](#the-whole-example)" in text and "print(1)" in text and "[no](link.md)" in text


@pytest.mark.parametrize(
    "change, mistake",
    [
        (lambda pages, examples: (pages / "one.png").unlink(), "docs/python/one.md: one.png: the picture is missing"),
        (lambda pages, examples: (examples / "one.py").unlink(), "there is no examples/python/one.py"),
        (lambda pages, examples: (pages / "one.md").write_text("[a](../gone.md)"), "../gone.md: there is no such file"),
    ],
)
def test_mistakes_are_reported(hooks, change, mistake):
    change(hooks.DOCS / "python", hooks.EXAMPLES)
    assert any(mistake in found for found in page(hooks)[1])


def test_dead_links_are_reported(hooks, tmp_path):
    site = tmp_path / "site"
    site.mkdir()
    (site / "a.html").write_text('<p id="here"><a href="#here"></a><a href="b.html#x"></a><a href="https://a.b/c"></a>')
    (site / "b.html").write_text('<p id="x"><a href="a.html">')
    found = []
    hooks.check_links(site, found.append)
    assert found == []
    (site / "b.html").write_text('<img src="c.png"><a href="a.html#there">')
    hooks.check_links(site, found.append)
    assert [mistake.split(": ")[1] for mistake in found] == [
        "the link b.html#x leads nowhere", "the link c.png leads nowhere", "the link a.html#there leads nowhere"
    ]


def public():
    """Everything that a user calls or reads, by name."""
    for module in [oaktwin, oaktwin.filters]:
        for name in module.__all__:
            item = getattr(module, name)
            if name in ["__version__", "filters"]:
                continue
            yield f"{module.__name__}.{name}", item
            if inspect.isclass(item) and not issubclass(item, Exception):
                for member in sorted(vars(item)):
                    if not member.startswith("_"):
                        yield f"{module.__name__}.{name}.{member}", getattr(item, member)


@pytest.mark.parametrize("name, item", list(public()), ids=lambda value: value if isinstance(value, str) else "")
def test_everything_is_documented(name, item):
    text = inspect.getdoc(item)
    if name.startswith("oaktwin.Finding."):
        # Documented by the class.
        text = inspect.getdoc(oaktwin.Finding)
        assert f"{name.rpartition('.')[2]}: " in text
    assert text and len(text) > 15
    try:
        arguments = inspect.signature(getattr(item, "__func__", item)).parameters
    except (TypeError, ValueError):
        return
    whole = text + (inspect.getdoc(oaktwin.filters) if name.startswith("oaktwin.filters") else "")
    if name in ["oaktwin.accuracy", "oaktwin.coverage"]:
        # "All other arguments are those of `DepthSensor`."
        whole += inspect.getdoc(oaktwin.DepthSensor)
    undocumented = [one for one in arguments if one not in ("self", "cls", "args", "kwargs") and one not in whole]
    assert not undocumented, f"{name} does not document {undocumented}"


# Functions with arrays document their shapes and invalid values.
@pytest.mark.parametrize("name", ["DepthSensor", "Filter", "align", "DepthSensor.align", "DepthSensor.annotate", "Scene.render",
                                  "Scene.render_pair", "StereoMatcher"])
def test_shapes_and_invalid_values_are_documented(name):
    item = oaktwin
    for part in name.split("."):
        item = getattr(item, part)
    text = " ".join(inspect.getdoc(item).split())
    assert "(H, W" in text and ("metres" in text) and (any(words in text for words in ["0 where", "0 is invalid", "0 is no", "0 for", "0 outside"]))


@pytest.mark.parametrize(
    "name",
    ["Camera", "Camera.cropped", "Camera.resized", "Device", "Device.extrinsics", "Device.from_calibration", "Device.rectification",
     "Device.write_usd", "DepthSensor", "DepthSensor.annotate", "Filter", "Rectification", "Scene.open", "Scene.from_triangles",
     "Scene.render", "Scene.render_pair", "StereoMatcher", "accuracy", "align", "coverage", "look_at", "models", "DepthSensor.align", "filters"],
)
def test_errors_are_documented(name):
    item = oaktwin
    for part in name.split("."):
        item = getattr(item, part)
    text = inspect.getdoc(item)
    assert "aise" in text and "oaktwin.Error" in text
