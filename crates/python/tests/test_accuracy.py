import json
import sys

import numpy as np
import pytest

import oaktwin


def test_it_is_the_programs(program, device):
    got = oaktwin.accuracy(device, distances="1:4:1", devices=7, captures=3)
    said = ["accuracy", "OAK4-D", "--distances", "1:4:1", "--devices", "7", "--captures", "3", "--json"]
    assert got.report == json.loads(program(*said))
    same = oaktwin.accuracy(device, distances=[1, 2, 3, 4], devices=7, captures=3)
    assert same.report == got.report
    assert [row["distance_m"] for row in got.rows] == [1, 2, 3, 4] and got.is_good
    assert repr(got) == "<oaktwin.Accuracy OAK4-D: 4 distances, within the published accuracy>"
    table = got.to_numpy()
    assert table.shape == (4,) and list(table["distance_m"]) == [1, 2, 3, 4]
    assert table["error_percent"][2] == got.rows[2]["error_percent"] and (table["fill_rate"] > 0.9).all()
    page = got._repr_html_()
    assert page.count("<tr>") == 5 and "distance_m" in page and "inside" in page


def test_nothing_measured_is_nan(device):
    got = oaktwin.accuracy(device, distances=[0.05, 2], devices=2, captures=1)
    assert np.isnan(got.to_numpy()["error_percent"][0]) and got.rows[0]["error_percent"] is None


def test_without_matplotlib(device, monkeypatch):
    got = oaktwin.accuracy(device, distances=[2], devices=2, captures=1, device_seed=None)
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    monkeypatch.setitem(sys.modules, "matplotlib.pyplot", None)
    with pytest.raises(ImportError, match="pip install matplotlib"):
        got.plot()


def test_on_somebodys_axes(device):
    """Any object with the methods of Matplotlib's axes will do."""

    class Axes:
        def __init__(self):
            self.calls = []

        def __getattr__(self, name):
            return lambda *arguments, **options: self.calls.append((name, arguments))

    got, axes = oaktwin.accuracy(device, distances=[1, 2], devices=2, captures=1), Axes()
    assert got.plot(axes) is axes
    names = [name for name, _ in axes.calls]
    assert names[:2] == ["plot", "fill_between"] and "legend" in names
    assert list(axes.calls[0][1][0]) == [1, 2]


@pytest.mark.parametrize(
    "options, text",
    [
        ({"sensor": "tof"}, "there is no depth sensor"),
        ({"distances": "x"}, "distances"),
        ({"distances": [-1]}, "distances"),
        ({"devices": 0}, "devices"),
        ({"captures": 0}, "captures"),
        ({"region": 0}, "region"),
        ({"engine": "none"}, "engine"),
        ({"parameters": {"windw": 3}}, "windw"),
    ],
)
def test_what_cannot_be_measured(device, options, text):
    with pytest.raises(oaktwin.Error, match=text):
        oaktwin.accuracy(device, **options)
