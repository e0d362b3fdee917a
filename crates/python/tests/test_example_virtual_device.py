import re
import subprocess
import sys

import pytest

from conftest import ROOT

pytest.importorskip("depthai")
SCRIPT = ROOT / "examples/python/virtual_device.py"
LINE = re.compile(r"([\d.]+) s  measured ([\d.]+) m  true ([\d.]+) m(  too near)?")


@pytest.mark.parametrize("engine", ["stereo-matching", "stereo-noise"])
def test_an_oak_warns_of_the_wall(engine):
    command = [sys.executable, str(SCRIPT), "--engine", engine, "--frames", "22"]
    runs = [subprocess.run(command, capture_output=True, text=True, encoding="utf-8") for _ in range(2)]
    for done in runs:
        assert done.returncode == 0, done.stderr
    lines = [LINE.findall(done.stdout) for done in runs]
    # The same on every run.
    assert lines[0] == lines[1] and len(lines[0]) == 22
    for _, measured, true, is_near in lines[0]:
        assert float(measured) == pytest.approx(float(true), rel=0.04)
        assert bool(is_near) == (float(measured) < 1)
    assert not lines[0][0][3] and lines[0][-1][3]
