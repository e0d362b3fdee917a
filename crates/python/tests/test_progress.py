"""Progress of long calls."""

import time

import numpy as np
import pytest

import oaktwin
from conftest import ROOT
from oaktwin._progress import Bar

BLOCK = (ROOT / "examples/recipes/objects/block.usda").as_posix()

CALLS = {"distances": [1.0, 2.0, 3.0], "devices": 3, "captures": 2}


def test_a_callable_gets_the_numbers(device):
    seen = []
    oaktwin.accuracy(device, progress=lambda done, total: seen.append((done, total)), **CALLS)
    done, totals = zip(*seen)
    assert list(done) == sorted(set(done)) and done[-1] == totals[-1]


def test_every_long_call_has_it(device, tmp_path):
    seen = set()

    def of(name):
        return lambda done, total: seen.add((name, done == total))

    scene = oaktwin.Scene.from_triangles(np.eye(3) * 2, [[0, 1, 2]])
    oaktwin.coverage(scene, device, np.eye(4), size=(64, 40), samples=50, progress=of("coverage"))
    recipe = tmp_path / "recipe.toml"
    recipe.write_text(f'frames = 2\n[[objects]]\nfiles = "{BLOCK}"\n[camera]\nresolution = [64, 40]\n')
    oaktwin.generate(recipe, tmp_path / "set", progress=of("generate"))
    oaktwin.Recipe(recipe).preview(1, progress=of("preview"))
    images = {metres: np.full((2, 60, 80), metres, np.float32) + np.float32(0.001) for metres in (1.0, 2.0)}
    oaktwin.fit(device, images, progress=of("fit"))
    assert {name for name, is_last in seen if is_last} >= {"coverage", "generate"}
    assert {name for name, _ in seen} == {"coverage", "generate", "preview", "fit"}


def test_an_exception_interrupts(device):
    def fail(done, total):
        raise KeyError("stop")

    with pytest.raises(KeyError, match="stop"):
        oaktwin.accuracy(device, progress=fail, **CALLS)
    with pytest.raises(oaktwin.Error, match="progress: invalid value 'yes'; pass True, False or a callable"):
        oaktwin.accuracy(device, progress="yes", **CALLS)


def test_bars(capsys, monkeypatch):
    now = [100.0]
    monkeypatch.setattr(time, "monotonic", lambda: now[0])
    bar = Bar()
    bar(1, 4)
    assert capsys.readouterr().err == "", "a short call has no bar"
    now[0] += 2
    bar(2, 4)
    now[0] += 0.05
    bar(3, 4)
    shown = capsys.readouterr().err
    assert shown == "\r" + "█" * 15 + "░" * 15 + " 2/4, 2 s, 2 s left"
    now[0] += 1
    bar(4, 4)
    assert capsys.readouterr().err.rstrip(" \n") == "\r" + "█" * 30 + " 4/4, 3 s"
    short = Bar()
    short(4, 4)
    assert capsys.readouterr().err == ""
