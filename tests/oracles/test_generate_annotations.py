"""Classes, annotations and aligned depth of generated data sets, as the reference tools of their formats see them."""

import json
import subprocess
from pathlib import Path

import numpy as np
import pytest
from pycocotools.coco import COCO
from pycocotools.cocoeval import COCOeval

from generated import Bop, image

# Fixtures are imported as well.
from test_generate import RECIPES, bop, root  # noqa: F401


def evaluated(path: Path, kind: str) -> float:
    """The average precision of detections that equal the annotations."""
    truth = COCO(path)
    annotations = truth.dataset["annotations"]
    found = [
        {key: annotation[key] for key in ("image_id", "category_id", "bbox", "segmentation")} | {"score": 1.0}
        for annotation in annotations
    ]
    evaluation = COCOeval(truth, truth.loadRes(found), kind)
    evaluation.evaluate()
    evaluation.accumulate()
    evaluation.summarize()
    return evaluation.stats[0]


@pytest.mark.parametrize("kind", ["bbox", "segm"])
def test_perfect_detections_have_a_perfect_score(root: Path, bop: Bop, kind: str) -> None:
    assert evaluated(root / "coco/annotations/instances.json", kind) == pytest.approx(1.0)
    for path in (bop.root / "train").glob("*/scene_gt_coco.json"):
        assert evaluated(path, kind) == pytest.approx(1.0)


def test_bops_annotations_are_those_of_its_tools(bop: Bop) -> None:
    for path in (bop.root / "train").glob("*/scene_gt_coco.json"):
        coco = json.loads(path.read_text())
        assert coco["info"] and coco["licenses"] == []
        assert [annotation["id"] for annotation in coco["annotations"]] == list(range(1, len(coco["annotations"]) + 1))
        gt, infos = (json.loads((path.parent / f"scene_gt{name}.json").read_text()) for name in ("", "_info"))
        annotations = iter(coco["annotations"])
        for image_id, poses in gt.items():
            for index, (pose, info) in enumerate(zip(poses, infos[image_id])):
                if info["px_count_visib"] == 0:
                    continue
                annotation = next(annotations)
                whole = image(path.parent / f"mask/{int(image_id):06}_{index:06}.png") > 0
                ys, xs = np.nonzero(whole)
                assert annotation["bbox"] == [xs.min(), ys.min(), np.ptp(xs), np.ptp(ys)]
                assert annotation["ignore"] == (info["visib_fract"] < 0.1)
                assert (annotation["image_id"], annotation["category_id"]) == (int(image_id), pose["obj_id"])
        assert next(annotations, None) is None


def test_depth_aligned_to_colour_is_the_colour_cameras(program: Path, tmp_path: Path) -> None:
    recipe = tmp_path / "recipe.toml"
    recipe.write_text(
        f'''scene = "{RECIPES}/table.usda"
objects = [{{ files = "{RECIPES}/objects/", count = 3, on = "/World/Table" }}]
frames = 2
camera = {{ resolution = [640, 360] }}
sensor = {{ align = "rgb" }}
output = {{ formats = ["basic", "bop", "tum"] }}
'''
    )
    out = tmp_path / "set"
    subprocess.run([program, "generate", recipe, "-o", out], check=True)
    for number in range(2):
        measured = np.load(out / f"basic/depth_sensor_distance_{number:04}.npy")
        exact = np.load(out / f"basic/distance_to_image_plane_{number:04}.npy")
        assert measured.shape == exact.shape == image(out / f"basic/rgb_{number:04}.png").shape[:2] == (360, 640)
        valid = measured > 0
        assert valid.mean() > 0.8
        # The depth is the surface's that the colour camera sees, not the one beside it.
        assert np.median(np.abs(measured - exact)[valid] / exact[valid]) < 0.01
        for path in out.glob(f"bop/train/*/depth/{number:06}.png"):
            np.testing.assert_allclose(image(path) / 1000, np.minimum(measured, 65.535), atol=1e-3)


def test_stereo_formats_write_the_pairs_camera_only(program: Path, tmp_path: Path) -> None:
    recipe = tmp_path / "recipe.toml"
    text = f'''scene = "{RECIPES}/table.usda"
objects = [{{ files = "{RECIPES}/objects/", count = 2, on = "/World/Table" }}]
frames = 1
camera = {{ resolution = [320, 200], cameras = CAMERAS }}
output = {{ formats = "kitti" }}
'''
    recipe.write_text(text.replace("CAMERAS", '["depth", "rgb"]'))
    command = [program, "generate", recipe, "-o", tmp_path / "set"]
    found = subprocess.run(command, check=True, capture_output=True, text=True)
    assert "no-pair" in found.stderr
    assert len(list((tmp_path / "set").glob("**/calib_cam_to_cam/*.txt"))) == 1
    recipe.write_text(text.replace("CAMERAS", '"rgb"'))
    command[-1] = tmp_path / "none"
    found = subprocess.run(command, capture_output=True, text=True)
    assert found.returncode == 2 and "add depth to camera.cameras" in found.stderr


def test_categories_and_classes_do_not_depend_on_the_seed(program: Path, tmp_path: Path) -> None:
    recipe = tmp_path / "recipe.toml"
    recipe.write_text(
        f'''scene = "{RECIPES}/table.usda"
objects = [{{ files = "{RECIPES}/objects/", count = 2, on = "/World/Table" }}]
frames = 2
camera = {{ resolution = [160, 100] }}
output = {{ formats = ["coco", "basic"], annotators = ["rgb", "semantic_segmentation"] }}
'''
    )
    categories, colors = [], {}
    for seed in range(3):
        out = tmp_path / str(seed)
        subprocess.run([program, "generate", recipe, "-o", out, "--seed", str(seed)], check=True, capture_output=True)
        categories.append(json.loads((out / "coco/annotations/instances.json").read_text())["categories"])
        for legend in (out / "basic").glob("semantic_segmentation_labels_*.json"):
            for color, labels in json.loads(legend.read_text()).items():
                assert colors.setdefault(labels["class"], color) == color
    assert categories[0] == categories[1] == categories[2]
    names = [category["name"] for category in categories[0]]
    assert names == sorted(names) and [category["id"] for category in categories[0]] == list(range(1, len(names) + 1))
    assert len(set(colors.values())) == len(colors) > 4
