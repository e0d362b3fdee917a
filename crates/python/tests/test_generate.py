"""Data sets from recipes."""

import copy
import json
import multiprocessing
import pickle
from pathlib import Path

import numpy as np
import pytest

import oaktwin
from conftest import files

RECIPES = Path(__file__).resolve().parents[3] / "examples/recipes"
RECIPE = f"""
frames = 6
frames_per_scene = 2
scene = '{RECIPES}/table.usda'
[[objects]]
files = '{RECIPES}/objects/'
count = 3
on = '/World/Table'
[camera]
resolution = [160, 100]
"""


@pytest.fixture
def recipe(tmp_path: Path) -> Path:
    path = tmp_path / "recipe.toml"
    path.write_text(RECIPE)
    return path


def make(recipe: Path, output: Path, frames: tuple[int, int]) -> None:
    oaktwin.generate(recipe, output, frames=frames, only_frames=True)


def test_generates_and_resumes(recipe: Path, tmp_path: Path) -> None:
    first = oaktwin.generate(recipe, tmp_path / "set", frames=(0, 2), workers=1)
    assert (first["frames"], first["skipped"], first["missing"]) == (2, 0, 4)
    rest = oaktwin.generate(str(recipe), str(tmp_path / "set"), resume=True)
    assert (rest["frames"], rest["skipped"], rest["missing"]) == (4, 2, 0)
    depth = np.load(tmp_path / "set/distance_to_image_plane_0005.npy")
    assert depth.shape == (100, 160) and depth.dtype == np.float32
    manifest = json.loads((tmp_path / "set/manifest.json").read_text())
    assert len(manifest["files"]) == rest["files"]


def test_verify_makes_changed_frames_again(recipe: Path, tmp_path: Path) -> None:
    folder = tmp_path / "set"
    oaktwin.generate(recipe, folder)
    image = sorted(folder.rglob("*.png"))[0]
    made = image.read_bytes()
    # Another byte, the same length.
    image.write_bytes(made[:-1] + bytes([made[-1] ^ 1]))
    assert oaktwin.generate(recipe, folder, resume=True)["frames"] == 0
    assert image.read_bytes() != made
    assert oaktwin.generate(recipe, folder, resume=True, verify=True)["frames"] == 1
    assert image.read_bytes() == made
    with pytest.raises(oaktwin.Error, match="verify: applies to existing data sets; pass resume=True"):
        oaktwin.generate(recipe, tmp_path / "new", verify=True)


def test_several_processes_make_the_same_data_set(recipe: Path, tmp_path: Path) -> None:
    """Also if they make the same frames."""
    oaktwin.generate(recipe, tmp_path / "whole", formats=["tum", "coco"], seed=4)
    recipe.write_text(RECIPE.replace("frames = 6", "frames = 6\nseed = 4\noutput.formats = ['tum', 'coco']"))
    spawn = multiprocessing.get_context("spawn")
    parts = [(0, 3), (2, 5), (5, 6)]
    workers = [spawn.Process(target=make, args=(recipe, tmp_path / "parts", part)) for part in parts]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()
        assert worker.exitcode == 0
    done = oaktwin.generate(recipe, tmp_path / "parts", resume=True)
    assert (done["frames"], done["skipped"]) == (0, 6)
    assert files(tmp_path / "whole") == files(tmp_path / "parts")


def test_errors(recipe: Path, tmp_path: Path) -> None:
    with pytest.raises(oaktwin.Error, match=r"recipe.toml:7: unknown key 'cuont'; did you mean 'count'"):
        recipe.write_text(RECIPE.replace("count", "cuont"))
        oaktwin.generate(recipe, tmp_path / "set")
    recipe.write_text(RECIPE)
    with pytest.raises(oaktwin.Error, match="frames 4..9 are beyond the 6 frames"):
        oaktwin.generate(recipe, tmp_path / "set", frames=(4, 9))
    with pytest.raises(oaktwin.Error, match="unknown format 'cocoa'; did you mean 'coco'"):
        oaktwin.generate(recipe, tmp_path / "set", formats=["cocoa"])
    oaktwin.generate(recipe, tmp_path / "set", frames=(0, 1))
    with pytest.raises(oaktwin.Error, match="already has a data set; add to it with resume, or"):
        oaktwin.generate(recipe, tmp_path / "set")
    with pytest.raises(FileNotFoundError, match="there is no such file"):
        oaktwin.generate(tmp_path / "none.toml", tmp_path / "other")


def test_a_recipe_explains_and_previews(recipe: Path, tmp_path: Path) -> None:
    own = oaktwin.Recipe(recipe, seed=4, formats=["tum"])
    assert own.frames == 6 and repr(own).endswith("recipe.toml (6 frames)>")
    drawn = own.explain(5)
    assert drawn["frame"] == 5 and len(drawn["arrangement"]["objects"]) == 3
    for other in [pickle.loads(pickle.dumps(own)), copy.deepcopy(own)]:
        assert other.explain(5) == drawn
        other.generate(tmp_path / str(id(other)), frames=(5, 6))
        assert len(list((tmp_path / str(id(other))).rglob("groundtruth.txt"))) == 1
    assert oaktwin.Recipe(recipe).explain(5) != drawn
    sheet = own.preview(4)
    assert sheet.dtype == np.uint8 and sheet.ndim == 3 and sheet.shape[2] == 3 and sheet.std() > 10
    with pytest.raises(FileNotFoundError, match="cannot list the folder"):
        oaktwin.Recipe(recipe, catalog=tmp_path / "nothing")


def test_the_preview_has_frames(recipe: Path) -> None:
    with pytest.raises(oaktwin.Error, match="frames: is 0; pass at least 1"):
        oaktwin.Recipe(recipe).preview(0)
