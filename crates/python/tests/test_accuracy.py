import json
import sys

import numpy as np
import pytest

import oaktwin


def test_matches_the_program(program, device):
    got = oaktwin.accuracy(device, distances="1:4:1", devices=7, captures=3)
    said = ["accuracy", "OAK4-D", "--distances", "1:4:1", "--devices", "7", "--captures", "3", "--json"]
    assert got.report == json.loads(program(*said))
    same = oaktwin.accuracy(device, distances=[1, 2, 3, 4], devices=7, captures=3)
    assert same.report == got.report
    assert [row["distance_m"] for row in got.rows] == [1, 2, 3, 4] and got.passed
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


def test_a_measured_unit_matches_the_program(program, tmp_path, device):
    curve = tmp_path / "unit.csv"
    curve.write_text("distance_m,depth_error_percent\n1,0.2\n2,0.5\n3,0.9\n4,1.6\n")
    got = oaktwin.accuracy(device, distances=[1, 3], devices=3, captures=2, measured=curve, measured_from=1.5, focal_px=790.0,
                           width_px=1280)
    said = ["accuracy", "OAK4-D", "--distances", "1,3", "--devices", "3", "--captures", "2", "--measured", curve, "--from", "1.5",
            "--focal-px", "790", "--stereo-width", "1280", "--json"]
    assert got.report == json.loads(program(*said, code=0 if got.passed else 1))
    assert got.report["measured"] and "measured" not in oaktwin.accuracy(device, distances=[1], devices=1, captures=1).report
    with pytest.raises(FileNotFoundError):
        oaktwin.accuracy(device, measured=tmp_path / "none.csv")
    curve.write_text("a,b\n1,2\n")
    with pytest.raises(oaktwin.Error, match="no column distance_m"):
        oaktwin.accuracy(device, measured=curve)


def test_a_drawn_figure(device, tmp_path):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    got = oaktwin.accuracy(device, distances="1:8:1", devices=5, captures=2)
    axes = got.plot()
    line, *_ = axes.get_lines()
    table = got.to_numpy()
    assert np.array_equal(line.get_xdata(), table["distance_m"]) and np.array_equal(line.get_ydata(), table["error_percent"])
    assert axes.get_xlabel() == "distance [m]" and "OAK4-D" in axes.get_title()
    assert [text.get_text() for text in axes.get_legend().get_texts()] == ["stereo-noise", "published"]
    axes.figure.savefig(tmp_path / "figure.png")
    picture = matplotlib.image.imread(tmp_path / "figure.png")
    # The line and the band are drawn.
    assert len(np.unique(picture.reshape(-1, picture.shape[-1]), axis=0)) > 50
    own = matplotlib.pyplot.figure().subplots()
    assert got.plot(own) is own and own.get_lines()
    matplotlib.pyplot.close("all")


def test_plots_on_given_axes(device):
    """An object with the methods of Matplotlib's axes."""

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
        ({"sensor": "tof"}, "has no depth sensor"),
        ({"distances": "x"}, "distances"),
        ({"distances": [-1]}, "distances"),
        ({"devices": 0}, "devices"),
        ({"captures": 0}, "captures"),
        ({"region": 0}, "region"),
        ({"engine": "none"}, "engine"),
        ({"parameters": {"windw": 3}}, "windw"),
    ],
)
def test_invalid_arguments(device, options, text):
    with pytest.raises(oaktwin.Error, match=text):
        oaktwin.accuracy(device, **options)
