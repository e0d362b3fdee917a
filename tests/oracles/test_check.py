"""`oaktwin check` against OpenUSD: the cameras it finds, and its OpenUSD view of each against `GfCamera`'s window."""

import json
import subprocess
from pathlib import Path

import pytest
from pxr import Usd, UsdGeom

from assets import CASES, Builder, Case

FIXTURES = Path(__file__).parents[2] / "crates/usd/fixtures/check"
# Values that OpenUSD does not read as authored, which is what these files are about.
NOT_AS_AUTHORED = {"animated_optics.usda", "camera_type.usda"}


def compare(stage: Usd.Stage, report: dict) -> int:
    """The number of cameras compared."""
    found = [str(prim.GetPath()) for prim in stage.Traverse() if prim.IsA(UsdGeom.Camera)]
    assert [camera["path"] for camera in report["cameras"]] == found
    compared = 0
    for camera in report["cameras"]:
        view = camera["openusd"]
        if view is None:
            continue
        gf = UsdGeom.Camera(stage.GetPrimAtPath(camera["path"])).GetCamera()
        window = gf.frustum.GetWindow()
        low, high = window.GetMin(), window.GetMax()
        width, height = camera["resolution"]["width"], camera["resolution"]["height"]
        # On the plane at distance 1 the window is what the image shows.
        assert view["fx"] == pytest.approx(width / (high[0] - low[0]), rel=1e-5)
        assert view["fy"] == pytest.approx(height / (high[1] - low[1]), rel=1e-5)
        assert view["cx"] == pytest.approx(width * -low[0] / (high[0] - low[0]), abs=2e-3)
        assert view["cy"] == pytest.approx(height * high[1] / (high[1] - low[1]), abs=2e-3)
        compared += 1
    return compared


@pytest.mark.parametrize("case", CASES, ids=str)
def test_own_assets(builder: Builder, case: Case) -> None:
    asset = builder.asset(case)
    report = json.loads(builder.run("check", asset, "--json"))
    assert all(finding["level"] == "note" for finding in report["findings"])
    assert compare(Usd.Stage.Open(str(asset)), report) == len(case.model.cameras) + len(case.model.depths)


def test_odd_files(program: Path) -> None:
    compared = 0
    for file in sorted(FIXTURES.glob("*.usda")):
        if file.name in NOT_AS_AUTHORED:
            continue
        done = subprocess.run([program, "check", file, "--json"], capture_output=True, text=True, check=False)
        assert done.returncode in (0, 1), f"{file.name}: {done.stderr}"
        compared += compare(Usd.Stage.Open(str(file)), json.loads(done.stdout))
    assert compared > 40
