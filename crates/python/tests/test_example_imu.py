"""The numbers of the example of the inertial sensor."""

import csv
import subprocess
import sys

import numpy as np
import pytest

from conftest import ROOT

FOLDER = ROOT / "examples/python"


def run(folder, *arguments, code=0):
    command = [sys.executable, "imu.py", "-o", folder, *arguments]
    done = subprocess.run([*map(str, command)], capture_output=True, text=True, encoding="utf-8", cwd=FOLDER)
    assert done.returncode == code, done.stderr
    return done.stderr if code else done.stdout


def deviations(printed, name):
    """The Allan deviations by averaging time."""
    (line,) = [line for line in printed.splitlines() if line.startswith(f"Allan deviation of the {name}")]
    parts = line.split(": ", 1)[1].replace("]", "").split(", ")
    return {float(part.split(" s [")[0]): np.array(part.split("[")[1].split(), float) for part in parts}


def test_drift_and_noise(tmp_path):
    printed = run(tmp_path, "--seconds", "10")
    with (tmp_path / "drift.csv").open(newline="") as lines:
        rows = [{name: float(value) for name, value in row.items()} for row in csv.DictReader(lines)]
    assert [row["time_s"] for row in rows] == [1, 3, 10]
    for row in rows:
        assert f"{row['position_m']:7.3f} m" in printed
    positions = [row["position_m"] for row in rows]
    assert positions == sorted(positions)
    # White noise of 10 m°/s/√Hz over 10 s is 0.03°, of 1.3 mm/s²/√Hz is 2.4 cm; tilted gravity adds the rest.
    assert 0.005 < rows[-1]["orientation_deg"] < 0.2 and 0.01 < positions[-1] < 0.3
    gyroscope = deviations(printed, "angular velocity")[1]
    assert gyroscope == pytest.approx([7.754, 9.767, 6.512], rel=0.16)
    accelerometer = deviations(printed, "linear acceleration")[1]
    assert accelerometer == pytest.approx(np.array([117.68, 126.12, 144.80]) * 9.80665e-3, rel=0.16)
    samples = np.loadtxt(tmp_path / "data.csv", delimiter=",", skiprows=1)
    assert samples.shape == (2001, 7) and samples[-1, 0] == 10e9


def test_another_part(tmp_path):
    gyroscope = deviations(run(tmp_path, "--seconds", "1", "--part", "BMI270"), "angular velocity")[1]
    assert gyroscope == pytest.approx([7, 7, 7], rel=0.16)


def test_a_model_without_sensor(tmp_path):
    assert "OAK-1" in run(tmp_path, "--model", "OAK-1", code=1)
