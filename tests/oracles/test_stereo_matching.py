"""The stereo matcher, compared with a NumPy implementation of the documented steps, and with OpenCV's on known disparity."""

from functools import partial

import cv2
import numpy as np
import pytest

import stereo_matching_model as model
from stereo_scenes import box, everywhere, pair, surest

SETTINGS = [
    {},
    {"subpixelFractionalBits": 3, "confidenceThreshold": 15},
    {"subpixelFractionalBits": 0, "leftRightCheck": False, "confidenceThreshold": 0},
    {"subpixelFractionalBits": 4, "subpixelInterpolation": "PARABOLA"},
    {"subpixelInterpolation": "PARABOLA_5", "leftRightCheckThreshold": 0},
    {"paths": 3, "confidenceThreshold": 0},
    {"paths": 8, "confidenceThreshold": 0},
    {"paths": 5, "confidenceThreshold": 0},
    {"paths": 6, "confidenceThreshold": 0},
    {"kernelSize": "KERNEL_5x5", "enableMeanMode": False, "confidenceThreshold": 0},
    {"kernelSize": "KERNEL_7x7", "censusTransform_threshold": 3, "confidenceThreshold": 5},
    {"kernelSize": "KERNEL_7x9", "confidenceThreshold": 5, "paths": 8},
    {"kernelSize": "KERNEL_7x9", "kernelMask": 0x2AA00AA805540155, "enableMeanMode": False},
    {"kernelSize": "KERNEL_7x7", "kernelMask": 0xAA02A8154055, "paths": 5},
    {"kernelMask": 0xA82415, "confidenceThreshold": 5},
    {"alpha": 8, "beta": 1, "confidenceThreshold": 5},
    {"alpha": 200, "beta": 9, "linearEquationParameters_threshold": 100},
    {"penaltyShift": 0, "confidenceThreshold": 0, "paths": 8},
    {"penaltyShift": 3, "horizontalPenaltyCostP1": 100, "verticalPenaltyCostP2": 900, "confidenceThreshold": 0},
    {"divisionFactor": 3, "confidenceThreshold": 0},
    {"blockSize": 1, "confidenceThreshold": 0},
    {"blockSize": 3, "paths": 8, "confidenceThreshold": 5},
    {"blockSize": 7, "confidenceThreshold": 5, "linearEquationParameters_threshold": 2},
    {"blockSize": 5, "blockRows": 1, "paths": 3, "penaltyShift": 2, "confidenceThreshold": 0},
    {"blockSize": 1, "blockRows": 7, "alpha": 3, "confidenceThreshold": 0},
    {"blockSize": 7, "blockRows": 3, "kernelSize": "KERNEL_7x9", "confidenceThreshold": 0},
    {"blockSize": 3, "alpha": 20, "beta": 3, "enableCompanding": True, "penaltyShift": 2, "confidenceThreshold": 0},
    {"disparityWidth": "DISPARITY_64", "confidenceThreshold": 0},
    {"disparityShift": 7, "confidenceThreshold": 0},
    {"enableCompanding": True, "confidenceThreshold": 0},
    {"enableCompanding": True, "disparityWidth": "DISPARITY_64", "disparityShift": 3, "confidenceThreshold": 0},
    {"extendedDisparity": True, "confidenceThreshold": 10},
    {"extendedDisparity": True, "disparityShift": 5, "numInvalidateEdgePixels": 9, "subpixelFractionalBits": 3},
    {"platform": "RVC4", "noiseThresholdOffset": 1, "noiseThresholdScale": 1, "confidenceThreshold": 20},
    {"platform": "RVC4", "noiseThresholdScale": -40, "p1Config_enableAdaptive": False, "p2Config_enableAdaptive": False},
    {"platform": "RVC4", "p1Config_enableAdaptive": False, "p2Config_smoothValue": 90, "paths": 5, "confidenceThreshold": 0},
    {"platform": "RVC4", "holeFilling_enable": False, "adaptiveMedianFilter_enable": False, "confidenceThreshold": 0},
    {"platform": "RVC4", "occlusionConfidenceWeight": 0, "leftRightCheck": False, "motionVectorConfidenceWeight": 32,
     "motionVectorConfidenceThreshold": 0, "confidenceThreshold": 120, "subpixelFractionalBits": 0},
    {"platform": "RVC4", "leftRightCheck": False, "motionVectorConfidenceThreshold": 3, "confidenceThreshold": 0,
     "holeFilling_minValidDisparity": 3, "holeFilling_invalidateDisparities": False, "subpixelFractionalBits": 3},
    {"platform": "RVC4", "flatnessOverride": True, "flatnessConfidenceThreshold": 7, "numInvalidateEdgePixels": 20},
    {"platform": "RVC4", "extendedDisparity": True, "occlusionConfidenceWeight": 14, "motionVectorConfidenceWeight": 16,
     "flatnessConfidenceWeight": 2, "flatnessConfidenceThreshold": 4, "holeFilling_highConfidenceThreshold": 240,
     "holeFilling_fillConfidenceThreshold": 251, "confidenceThreshold": 97},
    {"platform": "RVC4", "occlusionConfidenceWeight": 32, "flatnessConfidenceWeight": 32, "enableCompanding": True,
     "holeFilling_minValidDisparity": 2, "adaptiveMedianFilter_confidenceThreshold": 255, "confidenceThreshold": 0},
    {"platform": "RVC4", "holeFilling_enable": False, "adaptiveMedianFilter_confidenceThreshold": 255, "confidenceThreshold": 0},
]

SIZES = [(24, 200), (17, 131), (9, 300), (30, 61), (3, 1280), (1, 40), (20, 1), (2, 3)]


@pytest.fixture
def ask(depth_eval):
    return partial(depth_eval, "stereo_matching")


@pytest.fixture
def matched(ask, tmp_path):
    """The program's result for a pair: fixed-point disparity and confidence."""

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
    """Pairs with steps and slants, or unrelated images, with any texture."""
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


def scenes():
    """Pairs with known disparity: slants, steps, thin bars, a texture without fine detail."""
    height, width = 240, 700
    steps = [(box(150, 30, 350, 200), (30, 0, 0)), (box(420, 60, 600, 220), (55.5, 0, 0))]
    bars = [(box(150 + 60 * k, 10, 154 + 60 * k, 230), (20.3 + 5 * k, 0, 0)) for k in range(8)]
    cases = {
        "slanted wall": ([(everywhere, (8, 0.03, 0.05))], 1.0),
        "steps": ([(everywhere, (10, 0, 0)), *steps], 1.0),
        "bars 4 px thin": ([(everywhere, (6.4, 0.01, 0)), *bars], 1.0),
        "coarse texture": ([(everywhere, (5, 0.02, 0.02)), (box(200, 50, 500, 180), (40, -0.03, 0))], 4.0),
    }
    random = np.random.default_rng(5)
    for name, (layers, blur) in cases.items():
        yield name, *pair(random, height, width, layers, blur=blur, sigma=2)


def opencv(left, right):
    """OpenCV's matcher with 8 paths, padded on the left so that it matches every column."""
    matcher = cv2.StereoSGBM_create(
        0, 96, 5, 8 * 25, 32 * 25, 1, 63, 10, 0, 0, cv2.STEREO_SGBM_MODE_HH
    )
    left, right = (cv2.copyMakeBorder(image, 0, 0, 96, 0, cv2.BORDER_CONSTANT) for image in (left, right))
    found = matcher.compute(left, right)[:, 96:] / 16
    return np.where(found > 0, found, 0)


def quality(found, truth, seen):
    """Among the pixels that both imagers see: the fraction found, and the fractions of these more than 1 and 3 px off."""
    kept = (found > 0) & seen
    error = np.abs(found - truth)[kept]
    return np.array([kept.sum() / seen.sum(), (error > 1).mean(), (error > 3).mean()])


# With the few bits that DepthAI's mask keeps, 8 paths smooth thin bars away.
@pytest.mark.parametrize(
    "settings", [{}, {"kernelMask": 0xA82415}, {"paths": 8}], ids=["defaults", "DepthAI's mask", "8 paths"]
)
def test_no_worse_than_opencv(matched, settings):
    rows = {"as it is": [], "as many": [], "OpenCV": []}
    for name, left, right, truth, seen in scenes():
        fixed, sure = matched(left, right, **settings)
        theirs = opencv(left, right)
        loose, _ = matched(left, right, **settings, leftRightCheckThreshold=1, confidenceThreshold=0)
        found = {
            "as it is": fixed / 32,
            # With OpenCV's check, at the same density.
            "as many": surest(loose / 32, sure, seen, quality(theirs, truth, seen)[0]),
            "OpenCV": theirs,
        }
        for who, disparity in found.items():
            rows[who].append(quality(disparity, truth, seen))
            density, one, three = rows[who][-1]
            print(f"{name}: {who} {density:.3f} found, {one:.2%} > 1 px, {three:.2%} > 3 px")
    means = {who: np.mean(row, 0) for who, row in rows.items()}
    print(means)
    ours, equal, theirs = means.values()
    assert equal[0] > theirs[0] - 0.002 and (equal[1:] <= theirs[1:]).all()
    # With its own thresholds it finds as many pixels, and as many correct ones.
    assert ours[0] > theirs[0] - 0.005
    assert (ours[0] * (1 - ours[1:]) >= theirs[0] * (1 - theirs[1:])).all()


def test_findings(ask, tmp_path):
    random = np.random.default_rng(3)
    layers = [(everywhere, (12, 0.01, 0.02)), (box(250, 50, 400, 180), (40, 0, 0))]
    left, right, _, _ = pair(random, 240, 640, layers, sigma=1)
    cases = {
        (): (left, right),
        ("pair-swapped",): (right, left),
        ("vertical-offset",): (left, np.roll(right, 4, axis=0)),
        ("no-texture",): (np.full_like(left, 80), np.full_like(left, 80)),
        ("saturated", "saturated", "no-texture"): (np.full_like(left, 255), np.full_like(left, 255)),
        ("range-beyond-image",): (left[:, 200:295], right[:, 200:295]),
    }
    for codes, images in cases.items():
        for name, image in zip(("left", "right"), images):
            np.save(tmp_path / f"{name}.npy", np.ascontiguousarray(image))
        paths = {name: str(tmp_path / f"{name}.npy") for name in ("left", "right", "disparity", "confidence")}
        found = ask(width=1280, set={}, **paths)["findings"]
        assert set(codes) <= set(found) and (codes or not found), (codes, found)


# Parameters whose name differs from DepthAI's configuration.
PLACES = {
    "subpixel": "algorithmControl.enableSubpixel",
    "subpixelFractionalBits": "algorithmControl.subpixelFractionalBits",
    "extendedDisparity": "algorithmControl.enableExtended",
    "disparityShift": "algorithmControl.disparityShift",
    "leftRightCheck": "algorithmControl.enableLeftRightCheck",
    "leftRightCheckThreshold": "algorithmControl.leftRightCheckThreshold",
    "numInvalidateEdgePixels": "algorithmControl.numInvalidateEdgePixels",
    "censusTransform.threshold": "censusTransform.threshold",
    "alpha": "costMatching.linearEquationParameters.alpha",
    "beta": "costMatching.linearEquationParameters.beta",
    "linearEquationParameters.threshold": "costMatching.linearEquationParameters.threshold",
    "edgeThreshold": "costAggregation.p1Config.edgeThreshold",
    "smoothThreshold": "costAggregation.p1Config.smoothThreshold",
}
SECTIONS = ["", "censusTransform.", "costMatching.", "costAggregation.", "confidenceMetrics.", "postProcessing."]
OURS = {"focalLength", "baseline", "width", "subpixelInterpolation", "platform", "blockSize", "blockRows", "penaltyShift", "paths",
        "depthRounding", "confidenceThresholdV2"}


def depthai_value(config, name):
    """Returns the value of one of our parameters in DepthAI's configuration, as text."""
    for place in [PLACES[name]] if name in PLACES else [section + name for section in SECTIONS]:
        value = config
        for part in place.split("."):
            value = getattr(value, part, None)
        if value is not None:
            value = getattr(value, "name", value)
            return str(value).lower() if isinstance(value, bool) else str(value)
    raise AssertionError(f"DepthAI has no {name}")


def test_defaults_are_depthais(depth_eval):
    config = pytest.importorskip("depthai").StereoDepthConfig()
    for platform in ("RVC2", "RVC4"):
        ours = depth_eval("stereo_matching_parameters", platform=platform)["parameters"]
        for name in set(ours) - OURS:
            # RVC2 has no such thresholds; 0 disables them here.
            if platform == "RVC2" and name.startswith("noiseThreshold"):
                assert ours[name] == "0"
                continue
            theirs = depthai_value(config, name)
            assert ours[name] == (hex(int(theirs)) if name == "kernelMask" else theirs), name


def blank_pair(random, height=200, width=1280, level=60, sigma=2.0):
    """A wall without texture in too little light: nothing but noise."""
    return [
        np.clip(np.round(level + sigma * random.standard_normal((height, width))), 0, 255).astype(np.uint8)
        for _ in range(2)
    ]


def test_a_blank_wall_of_rvc4(matched):
    """RVC4's steps reduce its fill rate, and leave a textured wall's unchanged."""
    random = np.random.default_rng(11)
    rvc4 = {"platform": "RVC4", "noiseThresholdOffset": 1, "noiseThresholdScale": 1}
    plain = {**rvc4, "holeFilling_enable": False, "adaptiveMedianFilter_enable": False}
    left, right = blank_pair(random)
    kept = {}
    for name, settings in (("RVC2", {}), ("RVC4, without", plain), ("RVC4", rvc4)):
        found, _ = matched(left, right, **settings)
        kept[name] = (found > 0).mean()
        figures = np.mean([quality(matched(l, r, **settings)[0] / 32, d, seen) for _, l, r, d, seen in scenes()], 0)
        print(f"{name}: blank {kept[name]:.2%} kept; scenes {figures[0]:.3f} found, {figures[1]:.2%} > 1 px")
        assert figures[0] > 0.985 and figures[1] < 0.02
    assert kept["RVC4"] < 0.08 and kept["RVC4"] < kept["RVC2"] / 1.5
    assert kept["RVC4"] < kept["RVC4, without"] / 4
