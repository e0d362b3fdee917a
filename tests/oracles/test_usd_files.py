"""The files themselves: the same text in three formats, stable to the byte, packaged as the format requires."""

import struct
import zipfile
from pathlib import Path
from typing import Any

import pytest
from pxr import Sdf

from assets import CASES, FORMATS, Builder, Case


def packaged_text(path: Path) -> bytes:
    with zipfile.ZipFile(path) as package:
        return package.read(package.namelist()[0])


@pytest.mark.parametrize("case", CASES, ids=str)
def test_the_three_formats_hold_the_same_text(builder: Builder, case: Case) -> None:
    text = builder.asset(case, "usda").read_bytes()
    assert text.startswith(b"#usda 1.0\n")
    assert builder.asset(case, "usd").read_bytes() == text
    assert packaged_text(builder.asset(case, "usdz")) == text


@pytest.mark.parametrize("case", CASES, ids=str)
def test_package_is_stored_and_aligned(builder: Builder, case: Case) -> None:
    path = builder.asset(case, "usdz")
    data = path.read_bytes()
    with zipfile.ZipFile(path) as package:
        assert package.testzip() is None
        first = package.infolist()[0].filename
        assert Path(first).suffix in {".usd", ".usda"}, "the first file is the one that opens"
        for entry in package.infolist():
            assert entry.compress_type == zipfile.ZIP_STORED
            assert not entry.flag_bits & 0x1, "not encrypted"
            name, extra = struct.unpack_from("<HH", data, entry.header_offset + 26)
            assert (entry.header_offset + 30 + name + extra) % 64 == 0


@pytest.mark.parametrize(("case", "extension"), [(case, FORMATS[n % 3]) for n, case in enumerate(CASES)], ids=str)
def test_written_again_it_is_the_same(builder: Builder, case: Case, extension: str, tmp_path: Path) -> None:
    builder.write(case, extension, tmp_path)
    assert (tmp_path / f"{case.model.stem}.{extension}").read_bytes() == builder.asset(case, extension).read_bytes()
    assert len(list(tmp_path.iterdir())) == 1, "nothing else is left behind"


def content(layer: Sdf.Layer) -> dict[str, dict[str, Any]]:
    """Every spec with its type and every field."""
    specs: dict[str, dict[str, Any]] = {}

    def visit(path: Sdf.Path) -> None:
        spec = layer.GetObjectAtPath(path)
        if spec is not None:
            specs[str(path)] = {key: spec.GetInfo(key) for key in spec.ListInfoKeys()} | {"": type(spec)}

    layer.Traverse(Sdf.Path.absoluteRootPath, visit)
    return specs


def differences(a: Sdf.Layer, b: Sdf.Layer) -> list[str]:
    """The paths at which two layers differ."""
    ours, theirs = content(a), content(b)
    assert len(ours) > 50
    return [path for path in sorted(ours.keys() | theirs.keys()) if ours.get(path) != theirs.get(path)]


@pytest.mark.parametrize("case", CASES, ids=str)
def test_openusd_writes_it_with_the_same_meaning(builder: Builder, case: Case) -> None:
    ours = Sdf.Layer.FindOrOpen(str(builder.asset(case)))
    theirs = Sdf.Layer.CreateAnonymous(".usda")
    assert theirs.ImportFromString(ours.ExportToString())
    assert differences(ours, theirs) == []
    # Also compared in OpenUSD's binary format.
    binary = Sdf.Layer.CreateAnonymous(".usdc")
    binary.TransferContent(ours)
    assert differences(ours, binary) == []


def test_a_difference_is_seen(builder: Builder) -> None:
    ours = Sdf.Layer.FindOrOpen(str(builder.asset(CASES[0])))
    theirs = Sdf.Layer.CreateAnonymous(".usda")
    text = ours.ExportToString()
    assert theirs.ImportFromString(text.replace("prepend apiSchemas", "append apiSchemas", 1))
    assert len(differences(ours, theirs)) == 1


@pytest.mark.parametrize("case", CASES, ids=str)
def test_numbers_are_as_short_as_can_be(builder: Builder, case: Case) -> None:
    """`2.4138` and not the float's nearest double, `2.4137999999523163`."""
    for line in builder.asset(case).read_text().splitlines():
        words = line.replace("(", " ").replace(")", " ").replace("[", " ").replace("]", " ").replace(",", " ").split()
        if words[:1] == ["float"]:
            assert all(len(word) <= 16 for word in words[words.index("=") + 1 :]), line
