from pathlib import Path
from xml.etree import ElementTree

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


def test_the_parent(device, tmp_path):
    mount = {"parent": "wrist", "xyz": (0, 0, 0.1)}
    device.export(tmp_path, "mjcf", **mount)
    model = ElementTree.parse(tmp_path / "oak.xml")
    wrist = model.find("worldbody/body")
    assert wrist.get("name") == "wrist" and wrist.find("body").get("name") == "oak"
    assert wrist.find("body").get("pos") == "0 0 0.1"
    assert model.find(".//geom[@name='oak_collider']").get("group") == "3"
    device.export(tmp_path, "blender", **mount)
    text = (tmp_path / "oak_blender.py").read_text()
    assert 'PARENT = "wrist"' in text
    device.export(tmp_path, "blender")
    assert "PARENT = None" in (tmp_path / "oak_blender.py").read_text()
    with pytest.warns(oaktwin.FindingWarning, match="a PROTO cannot name wrist.*add the node to the children of that solid"):
        device.export(tmp_path, "webots", **mount)


def test_mujoco_reads_the_parent(device, tmp_path):
    mujoco = pytest.importorskip("mujoco")
    device.export(tmp_path, "mjcf", parent="wrist", xyz=(0, 0, 0.1))
    model = mujoco.MjModel.from_xml_path(str(tmp_path / "oak.xml"))
    assert model.body(model.body("oak").parentid[0]).name == "wrist"
    assert model.geom("oak_collider").group[0] == 3
