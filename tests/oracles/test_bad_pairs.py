"""Pairs that do not fit: swapped, unrectified, or rectified with the calibration of another unit. OpenCV makes raw pairs of real
calibrations from a real rectified pair."""

import itertools
import json
import os
import subprocess
from pathlib import Path

import cv2
import numpy as np
import pytest

DATA = os.environ.get("OAKTWIN_TEST_DATA")
UNITS = [
    ("oak-d-pro-af_v7_depthai-ros-cal.json", "OAK-D-Pro"),
    ("oak-d-pro-af_v7_18443010F116631200_old-factory-4k.json", "OAK-D-Pro"),
    ("oak-d_bw1098obc_v6.json", "OAK-D"),
]
SIZE = (1280, 720)
# The intrinsics of the rectified pair are unknown; any will do.
RECTIFIED = np.array([[800, 0, 640], [0, 800, 360], [0, 0, 1.0]])

pytestmark = pytest.mark.skipif(DATA is None, reason="OAKTWIN_TEST_DATA names the test data")


def rectified_pair():
    folder = Path(DATA) / "data/real/keembay"
    return [cv2.imread(str(folder / f"{side}.png"), cv2.IMREAD_GRAYSCALE) for side in ("left", "right")]


def raw(image, camera, rotation):
    """What the camera records of a rectified image: at 1280x720, the middle rows of its 1280x800."""
    k = np.array(camera["intrinsicMatrix"]) * [[SIZE[0] / camera["width"]]] * 1.0
    k[2] = 0, 0, 1
    k[1, 2] -= (camera["height"] * SIZE[0] / camera["width"] - SIZE[1]) / 2
    x, y = np.meshgrid(np.arange(SIZE[0], dtype=float), np.arange(SIZE[1], dtype=float))
    pixels = np.stack([x, y], -1).reshape(-1, 1, 2)
    criteria = (cv2.TERM_CRITERIA_COUNT | cv2.TERM_CRITERIA_EPS, 100, 1e-9)
    coefficients = np.array(camera["distortionCoeff"])
    at = cv2.undistortPointsIter(pixels, k, coefficients, np.array(rotation), RECTIFIED, criteria)
    at = at.reshape(SIZE[1], SIZE[0], 2).astype(np.float32)
    return cv2.remap(image, at[..., 0], at[..., 1], cv2.INTER_LINEAR)


def raw_pair(unit):
    file = json.loads((Path(DATA) / "data/calibration" / unit).read_text())
    cameras, rectification = dict(file["cameraData"]), file["stereoRectificationData"]
    sockets = rectification["leftCameraSocket"], rectification["rightCameraSocket"]
    rotations = rectification["rectifiedRotationLeft"], rectification["rectifiedRotationRight"]
    return [raw(image, cameras[s], r) for image, s, r in zip(rectified_pair(), sockets, rotations)]


@pytest.fixture
def findings(program, tmp_path):
    """The codes and the remedies of what the program finds in a pair."""

    def run(pair, *options):
        names = []
        for side, image in zip(("left", "right"), pair):
            names.append(str(tmp_path / f"{side}.png"))
            cv2.imwrite(names[-1], image)
        command = [str(program), "stereo", *names, "--force", "--json", "--output", str(tmp_path / "out"), *options]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        assert done.returncode in (0, 1), done.stderr
        found = {f["code"]: f["remedy"] for f in json.loads(done.stdout)["findings"]}
        return {code: found[code] for code in ("pair-swapped", "vertical-offset", "unrelated") if code in found}

    return run


def of_unit(unit, model):
    return "--model", model, "--calibration", str(Path(DATA) / "data/calibration" / unit)


def test_rectified_pairs(findings):
    left, right = rectified_pair()
    rig = "--hfov", "70", "--baseline", "0.075"
    assert findings([left, right], *rig) == {}
    assert list(findings([right, left], *rig)) == ["pair-swapped"]
    assert list(findings([left, right[::-1]], *rig)) == ["unrelated"]


@pytest.mark.parametrize("unit, model", UNITS)
def test_raw_pairs_of_their_own_unit(findings, unit, model):
    left, right = raw_pair(unit)
    assert findings([left, right], *of_unit(unit, model)) == {}
    assert "pair-swapped" in findings([right, left], *of_unit(unit, model))


@pytest.mark.parametrize("unit, model", UNITS)
def test_raw_pairs_without_rectification(findings, unit, model):
    found = findings(raw_pair(unit), "--hfov", "70", "--baseline", "0.075")
    assert list(found) == ["vertical-offset"]
    assert "calibration" in found["vertical-offset"]


@pytest.mark.parametrize("pair", list(itertools.permutations(UNITS, 2)))
def test_raw_pairs_of_another_unit(findings, pair):
    (unit, _), (other, model) = pair
    found = findings(raw_pair(unit), *of_unit(other, model))
    assert list(found) == ["vertical-offset"]
    assert found["vertical-offset"].startswith("check that the calibration is this unit's")
