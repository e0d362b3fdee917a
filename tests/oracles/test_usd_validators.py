"""OpenUSD opens every asset without a warning, and no validator reports a finding."""

from collections.abc import Iterable
from contextlib import suppress
from pathlib import Path

import pytest

from assets import CASES, FORMATS, PLAIN, Builder, Case, openusd_says, schema_folder

Findings = dict[tuple[str, str], dict[str, list[str]]]

# The text is the same in all formats, as other tests prove; how a file holds it depends on neither the model nor the options.
FILES = [(case, extension) for case in CASES for extension in (FORMATS if case.variant is PLAIN else ("usda",))]

# Asks for OpenUSD's binary format wherever an array is longer than 64. A body's meshes are, and this project writes
# text only, so the rule is skipped for assets with a body.
ASCII_RULE = "UsdAsciiPerformanceChecker"


@pytest.fixture(scope="module")
def said(builder: Builder) -> Findings:
    """The validators' findings for every file, with the schema of its version of Isaac Sim."""
    found: Findings = {}
    for isaac in ("5.1", "6"):
        files = [(case, extension) for case, extension in FILES if case.variant.isaac == isaac]
        found |= ask(builder, files, schema_folder(isaac, builder.folder))
    return found


@pytest.fixture(scope="module")
def said_without_schema(builder: Builder) -> Findings:
    """OpenUSD's own messages while it opens every file and reads every value."""
    return ask(builder, FILES, None, "composition")


def ask(builder: Builder, files: Iterable[tuple[Case, str]], schema: Path | None, *checks: str) -> Findings:
    """One process for all files; assets that cannot be built are left to the tests that need them."""
    paths = {}
    for case, extension in files:
        with suppress(AssertionError):
            paths[str(case), extension] = builder.asset(case, extension)
    return dict(zip(paths, openusd_says(paths.values(), schema, *checks), strict=True))


@pytest.mark.parametrize(("case", "extension"), FILES, ids=str)
def test_nothing_is_found(builder: Builder, said: Findings, case: Case, extension: str) -> None:
    builder.asset(case, extension)
    answer = said[str(case), extension]
    if case.variant.body:
        nvidia = answer.get("usd-validation-nvidia", [])
        answer = answer | {"usd-validation-nvidia": [line for line in nvidia if not line.startswith(ASCII_RULE)]}
    assert {name: lines for name, lines in answer.items() if lines} == {}


@pytest.mark.parametrize(("case", "extension"), FILES, ids=str)
def test_opens_in_silence_without_any_schema(
    builder: Builder, said_without_schema: Findings, case: Case, extension: str
) -> None:
    builder.asset(case, extension)
    assert said_without_schema[str(case), extension] == {"composition": []}


WRONG = {
    "type": ("float omni:rtx:post:depthSensor:baselineMM", "double omni:rtx:post:depthSensor:baselineMM", "baselineMM"),
    "unknown": ("depthSensor:noiseSigma", "depthSensor:noiseSigmas", "noiseSigmas"),
    "syntax": ('def Xform "Root"', 'def Xform Root"', ""),
    "default prim": ('defaultPrim = "Root"', 'defaultPrim = "Boot"', ""),
}


@pytest.mark.parametrize("wrong", WRONG)
def test_the_checks_can_fail(builder: Builder, tmp_path: Path, wrong: str) -> None:
    before, after, named = WRONG[wrong]
    text = builder.asset(Case(CASES[0].model, PLAIN)).read_text()
    assert before in text
    broken = tmp_path / "broken.usda"
    broken.write_text(text.replace(before, after))
    [answer] = openusd_says([broken], schema_folder("5.1", tmp_path))
    lines = [line for name, lines in answer.items() for line in lines if not line.startswith(ASCII_RULE)]
    assert any(named in line for line in lines), answer


def test_the_schema_is_known(builder: Builder, tmp_path: Path) -> None:
    """An Isaac Sim 6 asset against 5.1's schema has exactly its one mistyped attribute."""
    case = next(case for case in CASES if case.variant.name == "isaac-6")
    [answer] = openusd_says([builder.asset(case)], schema_folder("5.1", tmp_path), "types")
    assert [line.split(":", 1)[0].rsplit("/", 1)[-1].split(".")[0] for line in answer["types"]] == [
        f"{case.model.depths[0].prim}_render_product"
    ]
    assert "outlierRemovalEnabled: bool, the schema has int" in answer["types"][0]
