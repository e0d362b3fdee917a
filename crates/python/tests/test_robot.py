from pathlib import Path

import pytest

import oaktwin


def test_export(device, program, tmp_path):
    mount = {"parent": "wrist", "mount": "bottom", "xyz": (0, 0, 0.1), "rpy": (0, 0.5, 0)}
    files = device.export(tmp_path / "ours", "urdf", **mount)
    assert all(isinstance(file, Path) and file.is_file() for file in files)
    said = ["export", "OAK4-D", "--to", "urdf", "-o", tmp_path / "theirs", "--parent", "wrist", "--mount", "bottom"]
    program(*said, "--xyz", 0, 0, 0.1, "--rpy", 0, 0.5, 0)
    for file in files:
        assert file.read_bytes() == (tmp_path / "theirs" / file.relative_to(tmp_path / "ours")).read_bytes()
    assert tmp_path / "ours/oak.urdf" in files


def test_findings_and_errors(device, tmp_path):
    with pytest.warns(oaktwin.FindingWarning, match="another file"):
        device.export(tmp_path / "sdf", "sdf", parent="wrist")
    for wrong, match in [
        ({"format": "urd"}, "urdf"),
        ({"format": "urdf", "mount": "side"}, "mount"),
        ({"format": "urdf", "name": "4 oaks"}, "name: '4 oaks' does not begin with a letter"),
        ({"format": "urdf", "xyz": (0, float("nan"), 0)}, "xyz: must be finite"),
    ]:
        with pytest.raises(oaktwin.Error, match=match):
            device.export(tmp_path / "none", **wrong)
    assert not (tmp_path / "none").exists()
    (tmp_path / "file").write_text("")
    with pytest.raises(OSError, match="file"):
        device.export(tmp_path / "file", "urdf")
