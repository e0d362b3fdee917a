"""Stereo pairs of generated data sets: the disparities of their formats, against exact depth, photometry and OpenCV."""

import subprocess
from pathlib import Path

import cv2
import numpy as np
import pytest

from generated import Bop, cast, image, matrix_of, pfm

# Fixtures are imported as well.
from test_generate import RECIPES, bop, root  # noqa: F401


def calibration(path: Path) -> dict[str, str]:
    return dict(line.split("=", 1) for line in path.read_text().splitlines())


def test_disparity_is_that_of_exact_depth(root: Path, bop: Bop) -> None:
    for number, (scene, camera, _, _) in bop.frames.items():
        folder = root / f"middlebury/{number:06}"
        disparity, calib = pfm(folder / "disp0.pfm"), calibration(folder / "calib.txt")
        focal = float(calib["cam0"].strip("[").split()[0])
        assert focal == pytest.approx(matrix_of(camera)[0, 0], rel=1e-6)
        depth = float(calib["baseline"]) * focal / (disparity + float(calib["doffs"]))
        exact = image(scene / f"depth_exact/{number:06}.png").astype(float)
        known = np.isfinite(disparity)
        assert np.abs(depth - exact)[known].max() < 0.51
        assert (exact[~known] == 0).all()
        assert disparity[known].max() <= float(calib["vmax"]) < float(calib["ndisp"])
        kitti = image(root / f"kitti/training/disp_occ_0/{number:06}_10.png") / 256
        assert np.abs(kitti - np.where(known, disparity, 0)).max() <= 0.002
        lines = (root / f"kitti/training/calib_cam_to_cam/{number:06}.txt").read_text().splitlines()
        words = dict(line.split(": ", 1) for line in lines)
        assert {"S_rect_02", "R_rect_02", "P_rect_02", "K_03", "D_03", "T_03"} <= set(words)
        assert words["P_rect_02"].split()[0] == words["P_rect_03"].split()[0]
        right = [float(value) for value in words["P_rect_03"].split()]
        assert len(right) == 12
        assert -right[3] / right[0] * 1000 == pytest.approx(float(calib["baseline"]), rel=1e-6)


def test_scene_flow_has_the_same_pairs(root: Path, bop: Bop) -> None:
    # The patterns by which loaders of FlyingThings3D find their files.
    things = root / "sceneflow/FlyingThings3D"
    lefts = sorted(things.glob("frames_cleanpass/TRAIN/*/*/left/*.png"))
    assert sorted(int(path.stem) for path in lefts) == sorted(bop.frames)
    for path in lefts:
        folder = root / f"middlebury/{int(path.stem):06}"
        right = path.parents[1] / "right" / path.name
        for index, file in enumerate([path, right]):
            colour = image(file)
            assert colour.shape[2] == 3 and (colour[..., 0] == image(folder / f"im{index}.png")).all()
            of = Path(str(file).replace("frames_cleanpass", "disparity")).with_suffix(".pfm")
            # OpenCV's reader of PFM.
            disparity = cv2.imread(str(of), cv2.IMREAD_UNCHANGED)
            np.testing.assert_array_equal(disparity, pfm(folder / f"disp{index}.pfm"))
            occluded = image(Path(str(file).replace("frames_cleanpass", "disparity_occlusions")))
            assert ((occluded == 255) == (image(folder / f"mask{index}nocc.png") == 128)).all()


def test_the_disparities_of_both_images_agree(root: Path, bop: Bop) -> None:
    """Where a surface is seen twice, both images have its disparity at the places that it connects."""
    for number in bop.frames:
        folder = root / f"middlebury/{number:06}"
        disparities = [pfm(folder / f"disp{index}.pfm") for index in range(2)]
        masks = [image(folder / f"mask{index}nocc.png") for index in range(2)]
        for own, sign in [(0, -1), (1, 1)]:
            ys, xs = np.nonzero(masks[own] == 255)
            there = np.rint(xs + sign * disparities[own][ys, xs]).astype(int)
            difference = np.abs(disparities[1 - own][ys, there] - disparities[own][ys, xs])
            assert np.median(difference) < 0.1 and np.mean(difference < 1) > 0.97
            # What lies beyond the other image's border is not seen in it.
            ys, xs = np.nonzero(masks[own] == 128)
            there = np.rint(xs + sign * disparities[own][ys, xs]).astype(int)
            outside = (there < 0) | (there >= masks[own].shape[1])
            columns = xs[outside]
            assert outside.any() and (columns < 160 if own == 0 else columns >= 160).all()


def test_the_images_of_a_pair_match(root: Path, bop: Bop) -> None:
    for number in bop.frames:
        folder = root / f"middlebury/{number:06}"
        left, right = (image(folder / f"im{index}.png").astype(float) for index in range(2))
        disparity, mask = pfm(folder / "disp0.pfm"), image(folder / "mask0nocc.png")
        ys, xs = np.nonzero(mask == 255)

        def difference(shift: float) -> float:
            at = xs - disparity[ys, xs] + shift
            inside = (at >= 1) & (at < 318)
            low = np.floor(at[inside]).astype(int)
            part = at[inside] - low
            warped = right[ys[inside], low] * (1 - part) + right[ys[inside], low + 1] * part
            return np.abs(warped - left[ys[inside], xs[inside]]).mean()

        best = difference(0)
        assert best < 6 and best < min(difference(-1.5), difference(1.5))
        # Occlusion: surfaces with a larger disparity move over those with a smaller one.
        occluded = mask == 128
        assert 0.002 < occluded.mean() < 0.3
        noc = image(root / f"kitti/training/disp_noc_0/{number:06}_10.png")
        assert ((noc > 0) == ((mask == 255) & (np.rint(disparity * 256) > 0))).all()


def test_occlusion_is_that_of_the_right_view(root: Path, bop: Bop) -> None:
    """A pixel is occluded if something nearer lies on the line of sight of the right camera, or if it is outside its image."""
    random = np.random.default_rng(2)
    found = []
    for number, (_, camera, poses, _) in bop.frames.items():
        folder = root / f"middlebury/{number:06}"
        calib = calibration(folder / "calib.txt")
        disparity, mask = pfm(folder / "disp0.pfm"), image(folder / "mask0nocc.png")
        matrix = matrix_of(camera)
        triangles = np.concatenate([bop.triangles(pose) for pose in poses]) - [float(calib["baseline"]), 0, 0]
        pixels = random.permutation(np.argwhere(mask > 0)[:, ::-1])[:300]
        own = disparity[pixels[:, 1], pixels[:, 0]]
        seen = np.column_stack([pixels[:, 0] - own, pixels[:, 1]])
        depth = float(calib["baseline"]) * matrix[0, 0] / own
        hidden = (cast(triangles, matrix, seen) < depth - 8) & (seen[:, 0] >= 0)
        # The table hides nothing that stands on it.
        found.extend(mask[pixels[hidden, 1], pixels[hidden, 0]] == 128)
    assert len(found) > 10 and np.mean(found) > 0.85


def test_opencv_finds_the_written_disparity(program: Path, tmp_path: Path) -> None:
    """On the stereo recipe, OpenCV's matcher and the device's have errors of a third of a pixel, without bias."""
    command = [program, "generate", RECIPES / "stereo_training.toml", "-o", tmp_path, "--frames", "0..3"]
    subprocess.run(command, check=True)
    for folder in sorted(tmp_path.glob("0*")):
        left, right = (image(folder / f"im{index}.png") for index in range(2))
        truth, calib = pfm(folder / "disp0.pfm"), calibration(folder / "calib.txt")
        matcher = cv2.StereoSGBM_create(
            0, 96, 5, P1=200, P2=800, disp12MaxDiff=1, uniquenessRatio=10, speckleWindowSize=100, speckleRange=2
        )
        found = matcher.compute(left, right) / 16
        depth = pfm(folder / "depth_sensor.pfm")
        focal_baseline = float(calib["cam0"].strip("[").split()[0]) * float(calib["baseline"]) / 1000
        measured = np.where(depth > 0, focal_baseline / np.where(depth > 0, depth, 1), 0)
        known = (image(folder / "mask0nocc.png") == 255) & (truth < 94)
        for disparity in (found, measured):
            valid = known & (disparity > 0)
            error = (disparity - truth)[valid]
            assert valid.sum() > 0.4 * known.sum()
            assert np.median(np.abs(error)) < 0.5 and abs(np.median(error)) < 0.15
