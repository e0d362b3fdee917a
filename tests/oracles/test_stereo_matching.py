"""The stereo matcher against a NumPy implementation of the documented steps, and beside OpenCV's on known disparity."""

import json
import os
import subprocess

import numpy as np
import pytest

import stereo_matching_model as model
from stereo_scenes import box, everywhere, pair

SETTINGS = [
    {},
    {"subpixelFractionalBits": 3, "confidenceThreshold": 15},
    {"subpixelFractionalBits": 0, "leftRightCheck": False, "confidenceThreshold": 0},
    {"subpixelFractionalBits": 4, "subpixelInterpolation": "PARABOLA"},
    {"subpixelInterpolation": "LINES", "leftRightCheckThreshold": 0},
    {"paths": 3, "confidenceThreshold": 0},
    {"paths": 4, "confidenceThreshold": 0},
    {"paths": 5, "confidenceThreshold": 0},
    {"paths": 6, "confidenceThreshold": 0},
    {"kernelSize": "KERNEL_5x5", "enableMeanMode": False, "confidenceThreshold": 0},
    {"kernelSize": "KERNEL_7x7", "censusTransform_threshold": 3, "confidenceThreshold": 5},
    {"kernelSize": "KERNEL_7x9", "confidenceThreshold": 5},
    {"kernelSize": "KERNEL_7x9", "kernelMask": 0x2AA00AA805540155, "enableMeanMode": False},
    {"kernelSize": "KERNEL_7x7", "kernelMask": 0xAA02A8154055, "paths": 5},
    {"kernelMask": 0xA82415, "confidenceThreshold": 5},
    {"alpha": 8, "beta": 1, "confidenceThreshold": 5},
    {"alpha": 200, "beta": 9, "linearEquationParameters_threshold": 100},
    {"penaltyShift": 0, "confidenceThreshold": 0},
    {"penaltyShift": 3, "horizontalPenaltyCostP1": 100, "verticalPenaltyCostP2": 900, "confidenceThreshold": 0},
    {"divisionFactor": 3, "confidenceThreshold": 0},
    {"disparityWidth": "DISPARITY_64", "confidenceThreshold": 0},
    {"disparityShift": 7, "confidenceThreshold": 0},
    {"enableCompanding": True, "confidenceThreshold": 0},
    {"enableCompanding": True, "disparityWidth": "DISPARITY_64", "disparityShift": 3, "confidenceThreshold": 0},
    {"extendedDisparity": True, "confidenceThreshold": 10},
    {"extendedDisparity": True, "disparityShift": 5, "numInvalidateEdgePixels": 9, "subpixelFractionalBits": 3},
    {"platform": "RVC4", "noiseThresholdOffset": 1, "noiseThresholdScale": 1, "confidenceThreshold": 20},
    {"platform": "RVC4", "noiseThresholdScale": -40, "p1Config_enableAdaptive": False, "p2Config_enableAdaptive": False},
    {"platform": "RVC4", "p1Config_enableAdaptive": False, "p2Config_smoothValue": 90, "paths": 5, "confidenceThreshold": 0},
]

SIZES = [(24, 200), (17, 131), (9, 300), (30, 61), (3, 700), (1, 40), (20, 1), (2, 3)]


@pytest.fixture(scope="module")
def ask():
    named = os.environ.get("OAKTWIN_DEPTH_EVAL")
    if not named:
        pytest.skip("OAKTWIN_DEPTH_EVAL names no program: run by cargo xtask test")
    process = subprocess.Popen([named], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    def request(**fields):
        process.stdin.write(json.dumps({"op": "stereo_matching", **fields}) + "\n")
        process.stdin.flush()
        answer = json.loads(process.stdout.readline())
        assert "error" not in answer, answer
        return answer

    yield request
    process.stdin.close()
    process.wait()


@pytest.fixture
def matched(ask, tmp_path):
    """What the program finds in a pair: disparity in fixed point, confidence."""

    def run(left, right, **settings):
        names = {"left": left, "right": right}
        for name, image in names.items():
            np.save(tmp_path / f"{name}.npy", image)
        wire = {name.replace("_", "."): str(value).lower() if value in (True, False) and isinstance(value, bool)
                else str(value) for name, value in settings.items()}
        ask(left=str(tmp_path / "left.npy"), right=str(tmp_path / "right.npy"), width=left.shape[1], set=wire,
            disparity=str(tmp_path / "disparity.npy"), confidence=str(tmp_path / "confidence.npy"))
        return np.load(tmp_path / "disparity.npy"), np.load(tmp_path / "confidence.npy")

    return run


def small_pair(random, height, width):
    """Steps and slants, or nothing that fits; of any texture."""
    kind = random.integers(0, 3)
    if kind == 0 or height < 6 or width < 30:
        return random.integers(0, 256, (2, height, width)).astype(np.uint8)
    layers = [
        (everywhere, (random.uniform(1, 12), random.uniform(-0.05, 0.05), random.uniform(-0.1, 0.1))),
        (box(width * 0.4, 2, width * 0.7, height - 2), (random.uniform(15, 60), 0.0, 0.0)),
    ]
    left, right, _, _ = pair(random, height, width, layers, blur=random.choice([1.0, 2.0, 6.0]), sigma=kind)
    return left, right


@pytest.mark.parametrize("number", range(len(SETTINGS)))
def test_equals_the_model(matched, number):
    random = np.random.default_rng(1000 + number)
    settings = SETTINGS[number]
    kept = 0
    for height, width in SIZES:
        left, right = small_pair(random, height, width)
        if random.random() < 0.3:
            left, right = (image.astype(np.uint16) * 4 + 1 for image in (left, right))
        ours, sure = matched(left, right, **settings)
        theirs, sure_too = model.match(left, right, model.Parameters(**settings))
        assert np.array_equal(sure, sure_too), (settings, height, width)
        assert np.array_equal(ours, theirs), (settings, height, width)
        kept += np.count_nonzero(ours)
    assert kept > 0
