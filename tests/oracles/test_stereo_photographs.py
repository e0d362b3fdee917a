"""The stereo matcher, compared with OpenCV's on a photographed pair with ground truth.

The pair `aloe` belongs to OpenCV's samples, which Debian's package `opencv-doc` installs; OAKTWIN_OPENCV_SAMPLES names
another folder.
"""

import os
import subprocess
from pathlib import Path

import cv2
import numpy as np
import pytest

from stereo_scenes import surest

SAMPLES = Path(os.environ.get("OAKTWIN_OPENCV_SAMPLES", "/usr/share/doc/opencv-doc/examples/data"))
NAMES = ["aloeL.jpg", "aloeR.jpg", "aloeGT.png"]
# The last disparity of the full-size images, with a margin for subpixel interpolation.
RANGE_END = 94


def aloe(factor):
    """Both images reduced by a factor, the left image's disparity, and the pixels whose counterpart the right image sees."""
    if not all((SAMPLES / name).is_file() for name in NAMES):
        pytest.skip(f"{SAMPLES} has no aloe: install opencv-doc, or set OAKTWIN_OPENCV_SAMPLES")
    left, right, truth = (cv2.imread(str(SAMPLES / name), cv2.IMREAD_GRAYSCALE) for name in NAMES)
    full_height, full_width = truth.shape
    width, height = (round(side / factor) for side in (full_width, full_height))
    left, right = (cv2.resize(image, (width, height), interpolation=cv2.INTER_AREA) for image in (left, right))
    y, x = (((np.arange(n) + 0.5) * full / n).astype(int) for n, full in ((height, full_height), (width, full_width)))
    truth = truth[y][:, x] * (width / full_width)
    return left, right, truth, seen(truth)


def seen(truth):
    """The pixels with a ground truth (0 is none) that no nearer surface covers in the right image."""
    height, width = truth.shape
    there = np.round(np.arange(width) - truth).astype(int)
    is_known = (truth > 0) & (there >= 0)
    rows = np.broadcast_to(np.arange(height)[:, None], truth.shape)
    nearest = np.zeros(truth.shape)
    np.maximum.at(nearest, (rows[is_known], there[is_known]), truth[is_known])
    beside = np.max([nearest[rows, np.clip(there + k, 0, width - 1)] for k in (-1, 0, 1)], 0)
    return is_known & (beside - truth < 1)


def opencv(left, right, search):
    matcher = cv2.StereoSGBM_create(0, search, 5, 8 * 25, 32 * 25, 1, 63, 10, 0, 0, cv2.STEREO_SGBM_MODE_HH)
    # Padded on the left, so that every column is matched.
    left, right = (cv2.copyMakeBorder(image, 0, 0, search, 0, cv2.BORDER_CONSTANT) for image in (left, right))
    found = matcher.compute(left, right)[:, search:] / 16
    return np.where(found > 0, found, 0)


def quality(found, truth, where):
    """The fraction of the pixels that is found, and the fractions of these more than 1 and 3 px off."""
    kept = (found > 0) & where
    off = np.abs(found - truth)[kept]
    return np.array([kept.sum() / where.sum(), (off > 1).mean(), (off > 3).mean()])


@pytest.fixture
def matched(program, tmp_path):
    """The program's disparity and confidence, with OpenCV's left-right check and no confidence threshold."""

    def run(left, right, *options):
        paths = [tmp_path / "left.png", tmp_path / "right.png"]
        for path, image in zip(paths, (left, right)):
            cv2.imwrite(str(path), image)
        every = ["--platform", "rvc2", "--param", "confidenceThreshold=0", "--param", "leftRightCheckThreshold=1"]
        command = [program, "stereo", *paths, "--model", "OAK-D-Pro-PoE", "--annotators", "disparity,confidence"]
        done = subprocess.run([*command, *every, *options, "-o", tmp_path], capture_output=True, text=True)
        assert done.returncode in (0, 1), done.stderr
        return [np.load(next(tmp_path.glob(f"*{name}*.npy"))) for name in ("disparity", "confidence")]

    return run


@pytest.mark.parametrize("factor, search, options", [
    pytest.param(2.4, 96, [], id="standard"),
    pytest.param(2.0, 112, ["--extended-disparity"], id="extended"),
])
def test_no_worse_than_opencv(matched, factor, search, options):
    left, right, truth, where = aloe(factor)
    theirs = quality(opencv(left, right, search), truth, where)
    disparity, confidence = matched(left, right, *options)
    ours = quality(surest(disparity, confidence, where, theirs[0]), truth, where)
    for who, row in (("oaktwin", ours), ("OpenCV", theirs)):
        print(f"{who}: {row[0]:.2%} found, {row[1]:.2%} > 1 px, {row[2]:.2%} > 3 px")
    assert abs(ours[0] - theirs[0]) < 0.002 and (ours[1:] <= theirs[1:]).all()


def test_extended_disparity_does_not_affect_the_range_of_the_full_size_images(matched):
    left, right, truth, where = aloe(2.0)
    where &= truth < RANGE_END
    standard, extended = (
        quality(matched(left, right, *options)[0], truth, where) for options in ([], ["--extended-disparity"])
    )
    print(standard, extended)
    assert (np.abs(extended - standard) < 0.001).all()
