"""Objects as tables in notebooks."""

from xml.etree import ElementTree

import oaktwin


def cells(text):
    """The cells of the rows of a table, which is well-formed."""
    root = ElementTree.fromstring(text)
    assert root.tag == "table"
    return [[cell.text or "" for cell in row] for row in root.iter("tr")]


def test_cameras_and_devices(device):
    camera = oaktwin.Camera(64, 48, hfov_deg=60, name="<left>")
    head, row = cells(camera._repr_html_())
    assert head[:3] == ["camera", "width", "height"] and row[:3] == ["<left>", "64", "48"] and row[7] == "60"
    assert [row[0] for row in cells(device._repr_html_())[1:]] == list(device.cameras)
    assert "OAK4-D (nominal), depth: stereo" in device._repr_html_()


def test_results(device):
    scene = oaktwin.Scene.from_triangles([[2, -9, -9], [2, 9, -9], [2, 0, 9]], [[0, 1, 2]])
    coverage = oaktwin.coverage(scene, device, scene.look_at((0, 0, 0), (1, 0, 0), device), samples=50)
    assert len(cells(coverage._repr_html_())) == 2
    assert len(cells(oaktwin.accuracy(device, distances=[1, 2], devices=1, captures=1)._repr_html_())) == 3
    known = {"name": "bias", "value": 0.25, "is_fitted": True, "confidence_interval_95": None}
    fit = oaktwin.Fit({"model": "OAK4-D", "engine": "stereo-noise", "parameters": [known]}, "")
    assert cells(fit._repr_html_())[1] == ["bias", "0.25", "", ""]
