"""Checks the example's rows with fixtures and real exports."""

import json
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from conftest import ROOT

dai = pytest.importorskip("depthai", reason="depthai is not installed")

EXAMPLE = ROOT / "examples/python/depthai_calibration.py"
FIXTURES = ROOT / "crates/calibration/fixtures"
# Single precision of 4000 px, of metres, of 100 degrees, of 1.
TOLERANCES = {"px": 2e-4, "m": 2e-8, "deg": 2e-5, "": 5e-7}
FILES = {
    "example-oak-d-pro-poe.json": "OAK-D Pro PoE",
    "oak-d-pro-w-poe.json": "OAK-D Pro W PoE",
    "oak-4-d.json": "OAK4-D",
    "oak-d-sr-poe.json": "OAK-D ToF",
    "fisheye-two-roots.json": "OAK-D Pro PoE",
}


def run(*arguments):
    command = [sys.executable, EXAMPLE, *map(str, arguments)]
    # DepthAI reports a missing USB on standard output.
    environment = {**os.environ, "DEPTHAI_LEVEL": "error"}
    return subprocess.run(command, capture_output=True, text=True, encoding="utf-8", env=environment)


def compared(path, model, folder):
    """Checks all rows and returns them by name."""
    done = run(path, "--model", model, "-o", folder / "rows.json")
    assert done.returncode == 0, done.stderr
    rows = json.loads((folder / "rows.json").read_text())
    for row in rows:
        theirs, ours = np.array(row["depthai"]), np.array(row["oaktwin"])
        assert theirs.shape == ours.shape and theirs.size and np.isfinite(ours).all()
        difference = np.abs(theirs * {"cm": 0.01}.get(row["depthai_unit"], 1.0) - ours).max()
        assert difference == pytest.approx(row["difference"], abs=1e-15)
        if not row["convention"]:
            assert difference <= TOLERANCES[row["unit"]], row
    return {row["what"]: row for row in rows}, done.stdout


@pytest.mark.parametrize("name", FILES)
def test_fixtures(name, tmp_path):
    rows, shown = compared(FIXTURES / name, FILES[name], tmp_path)
    handler = dai.CalibrationHandler(str(FIXTURES / name))
    left, right = dai.CameraBoardSocket.CAM_B, dai.CameraBoardSocket.CAM_C
    k = np.array(handler.getCameraIntrinsics(left, 640, 400))
    assert rows["left fx fy cx cy, 640x400"]["depthai"] == [k[0, 0], k[1, 1], k[0, 2], k[1, 2]]
    moved = np.array(handler.getCameraExtrinsics(left, right))
    assert rows["right_from_left translation"]["depthai"] == moved[:3, 3].tolist()
    assert rows["baseline"]["depthai"] == [handler.getBaselineDistance(right, left, False)]
    assert rows["baseline, by default"]["depthai"] == [handler.getBaselineDistance()]
    for which in ["left distortion, ", "right distortion, ", "R1, ", "R2, ", "left field of view"]:
        assert any(what.startswith(which) for what in rows), which
    worst = max(row["difference"] for row in rows.values() if row["unit"] == "px")
    assert f"largest difference, px: {worst:.1e}" in shown


def test_conventions_are_marked(tmp_path):
    """DepthAI's defaults from the board's design differ and are marked. The default file is the project's example."""
    done = run("-o", tmp_path / "rows.json")
    rows = {row["what"]: row for row in json.loads((tmp_path / "rows.json").read_text())}
    assert done.stdout.startswith("OAK-D Pro PoE, example-oak-d-pro-poe.json: DepthAI ")
    assert rows["baseline, by default"]["depthai"] == [7.5]
    assert rows["baseline, by default"]["oaktwin"] == pytest.approx([0.0745845], abs=1e-7)
    assert rows["left field of view, by default"]["depthai"] == pytest.approx([71.86])
    assert "* getBaselineDistance() gives" in done.stdout and "* getFov() gives" in done.stdout
    # This file has extrinsics of the IMU.
    assert rows["left_from_imu translation"]["depthai_unit"] == "cm"


def test_invalid_files_are_rejected(tmp_path):
    (tmp_path / "bad.json").write_text("{}")
    done = run(tmp_path / "bad.json")
    assert done.returncode == 1 and "Traceback" not in done.stderr and "bad.json" in done.stderr


def test_a_rig_of_no_model_is_compared():
    done = run(FIXTURES / "fisheye-two-roots.json")
    assert done.returncode == 0 and "productName: of no model in the catalog" in done.stdout


def test_real_exports(tmp_path):
    data = os.environ.get("OAKTWIN_TEST_DATA")
    if not data:
        pytest.skip("OAKTWIN_TEST_DATA is not set: no real exports")
    files = sorted(Path(data, "data/calibration").glob("*.json"))
    compared_files = 0
    for path in files:
        raw = json.loads(path.read_text())
        if raw["version"] < 6 or raw.get("productName") == "OAK-D-EVOLV":
            # DepthAI rejects the first, oaktwin the second, whose right camera is on the left.
            done = run(path, "--model", "OAK-D Pro PoE")
            assert done.returncode == 1 and "Traceback" not in done.stderr
            assert "cameraType" in done.stderr or "not to its left" in done.stderr
            continue
        compared(path, "OAK-D Pro PoE", tmp_path)
        compared_files += 1
    assert compared_files >= len(files) - 2
