"""Escape sequences in the strings of text layers, which oaktwin decodes and its USD library does not."""

import re

import pytest
from pxr import Sdf, Usd, UsdUtils

from usd_scenes import labels_of

CONTENTS = [
    r"a\tb\\c\"d\'e",
    r"\a\b\f\n\r\t\v",
    r"\x41 \x4142 \x414 \x4 \x4g",
    r"\101 \1012 \18 \8",
    r"\q \? \é \u00e9",
    r"\xc3\xa9",
    r"\\x41 \\\\ \\\"",
    r"'''\\",
    r"\"\"\"",
    r"ends with \"",
    r"\" and '",
]


def layer(strings: list[str]) -> str:
    prims = "".join(
        f"""
def Plane "P{at}" (prepend references = </Named>)
{{
    token[] semantics:labels:class = [{string}, "plain"]
    string semantic:A:params:semanticType = {string}
    string semantic:A:params:semanticData = {string}
}}
"""
        for at, string in enumerate(strings)
    )
    head = r"""#usda 1.0
(
    defaultPrim = "\x4eamed"
    doc = "\""
)
class "Named"
{
}
"""
    return head + prims


@pytest.mark.parametrize("extension", ["usda", "usdc", "usdz"])
@pytest.mark.parametrize("quote", ['"', '"""', "'", "'''"])
def test_strings_are_those_of_openusd(tmp_path, scene_dump, quote, extension):
    ends = re.compile(rf"(?<!\\){quote[0]}")
    contents = [content for content in CONTENTS if not ends.search(content)]
    text = tmp_path / "text.usda"
    text.write_text(layer([f"{quote}{content}{quote}" for content in contents]))
    path = tmp_path / f"strings.{extension}"
    if extension == "usdz":
        assert UsdUtils.CreateNewUsdzPackage(str(text), str(path))
    elif extension == "usdc":
        assert Sdf.Layer.FindOrOpen(str(text)).Export(str(path))
    else:
        path = text
    stage = Usd.Stage.Open(str(path))
    things = scene_dump(path).things()
    planes = [prim for prim in stage.Traverse() if prim.GetTypeName() == "Plane"]
    assert len(things) == len(planes) == len(contents) > 8
    for prim in planes:
        assert sorted(things[str(prim.GetPath())]["labels"]) == sorted(labels_of(prim)), prim
    assert any("\t" in label for _, label in things["/P0"]["labels"])
