"""Frames of a recipe in memory are those of the data set on disk."""

import json
import pickle
from pathlib import Path

import numpy as np
import pytest

import oaktwin
from conftest import files
from test_generate import RECIPE


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "recipe.toml").write_text(RECIPE.replace("frames = 6", "frames = 4"))
    return tmp_path


def same(a: oaktwin.Sample, b: oaktwin.Sample) -> bool:
    arrays = [name for name in a if isinstance(a[name], np.ndarray)]
    return a.keys() == b.keys() and all(a[name].tobytes() == b[name].tobytes() for name in arrays)


def test_samples_are_the_files(folder: Path) -> None:
    recipe = oaktwin.Recipe(folder / "recipe.toml", seed=3)
    oaktwin.generate(folder / "recipe.toml", folder / "set", seed=3)
    for number, sample in enumerate(recipe):
        assert sample.frame == number
        for name in ["distance_to_image_plane", "depth_sensor_distance"]:
            saved = np.load(folder / f"set/{name}_{number:04}.npy")
            assert saved.dtype == sample[name].dtype and saved.tobytes() == sample[name].tobytes()
        saved = json.loads((folder / f"set/camera_params_{number:04}.json").read_text())
        height, width = sample["rgb"].shape[:2]
        assert [width, height] == saved["renderProductResolution"]
        # Replicator's view matrix is for rows, and its camera faces -z.
        view = np.array(saved["cameraViewTransform"]).reshape(4, 4).T
        world_from_camera = np.linalg.inv(view) @ np.diag([1, -1, -1, 1])
        assert np.allclose(world_from_camera, sample.world_from_camera["camera"], atol=1e-5)
    assert number == 3


def test_images_are_those_of_png_files(folder: Path) -> None:
    image = pytest.importorskip("PIL.Image")
    recipe = oaktwin.Recipe(folder / "recipe.toml")
    recipe.generate(folder / "set", frames=(1, 2))
    saved = np.asarray(image.open(folder / "set/rgb_0001.png"))
    assert np.array_equal(saved, recipe[1]["rgb"][..., : saved.shape[-1]])


def test_a_sequence(folder: Path) -> None:
    recipe = oaktwin.Recipe(folder / "recipe.toml")
    assert len(recipe) == recipe.frames == 4
    # In any order: the second and the third frame have different arrangements.
    backwards = [recipe[number] for number in (3, 2, 1, 0)]
    assert all(same(a, b) for a, b in zip(backwards[::-1], recipe))
    assert same(recipe[-1], recipe[3]) and [sample.frame for sample in recipe[1:3]] == [1, 2]
    assert recipe[np.int64(2)].frame == 2
    for number in (4, -5):
        with pytest.raises(IndexError, match=f"frame: {number} is beyond the 4 frames of the recipe"):
            recipe[number]
    with pytest.raises(TypeError, match="frame: is a str; pass a whole number"):
        recipe["0"]  # type: ignore[call-overload]


def test_pickles(folder: Path) -> None:
    """As the workers of a data loader make samples."""
    recipe = oaktwin.Recipe(folder / "recipe.toml", seed=2)
    sample = recipe[1]
    assert same(pickle.loads(pickle.dumps(recipe))[1], sample)
    copy = pickle.loads(pickle.dumps(sample))
    assert same(copy, sample) and copy.frame == 1 and repr(copy) == repr(sample)
    assert isinstance(copy.world_from_camera["camera"], oaktwin.CameraPose)
    assert copy.cameras["camera"].width == 160


def test_several_cameras_and_objects(folder: Path) -> None:
    text = RECIPE.replace("frames = 6", "frames = 2").replace("[camera]", "[camera]\ncameras = ['left', 'right']")
    (folder / "recipe.toml").write_text(text)
    recipe = oaktwin.Recipe(folder / "recipe.toml", formats=["basic", "bop"])
    sample = recipe[0]
    assert len(sample.cameras) == 2 and len(sample.objects) == 3
    recipe.generate(folder / "set")
    saved = files(folder / "set")
    for name in sample.cameras:
        depth = sample[f"{name}/distance_to_image_plane"]
        [path] = [path for path in saved if name in path and path.endswith("distance_to_image_plane_0000.npy")]
        assert np.load(folder / "set" / path).tobytes() == depth.tobytes()
    for thing in sample.objects:
        pose = thing["world_from_object"]
        assert isinstance(pose, np.ndarray) and pose.shape == (4, 4)


def test_torch_loads_samples(folder: Path) -> None:
    data = pytest.importorskip("torch.utils.data")
    recipe = oaktwin.Recipe(folder / "recipe.toml")

    def only_depth(samples: list[oaktwin.Sample]) -> np.ndarray:
        return np.stack([sample["depth_sensor_distance"] for sample in samples])

    batches = list(data.DataLoader(recipe, batch_size=2, collate_fn=only_depth))
    assert [batch.shape[0] for batch in batches] == [2, 2]


def doubled(depth: np.ndarray) -> np.ndarray:
    """An engine that pickles."""
    return depth * 2


def nearest(left: np.ndarray, right: np.ndarray, focal_length: float, baseline: float) -> np.ndarray:
    """A matcher that sees a wall at 2 m."""
    assert left.shape == right.shape and left.dtype == np.uint8
    return np.full(left.shape, focal_length * baseline / 2)


def test_an_engine_of_ones_own(folder: Path) -> None:
    recipe = oaktwin.Recipe(folder / "recipe.toml", engine=doubled)
    for sample in [recipe[1], pickle.loads(pickle.dumps(recipe))[1]]:
        exact, measured = sample["distance_to_image_plane"], sample["depth_sensor_distance"]
        assert np.array_equal(measured, np.where(np.isfinite(exact), exact * 2, 0))
    oaktwin.generate(folder / "recipe.toml", folder / "set", engine=doubled, frames=range(1, 2), workers=2)
    saved = np.load(folder / "set/depth_sensor_distance_0001.npy")
    assert np.array_equal(saved, measured)
    # The data set names the engine, and is not completed with another one.
    with pytest.raises(oaktwin.Error, match="recipe"):
        oaktwin.generate(folder / "recipe.toml", folder / "set", resume=True)
    oaktwin.generate(folder / "recipe.toml", folder / "set", engine=doubled, resume=True)
    matched = oaktwin.Recipe(folder / "recipe.toml", engine=nearest)[0]["depth_sensor_distance"]
    assert np.allclose(matched[matched > 0], 2.0) and np.mean(matched > 0) > 0.5
    by_name = oaktwin.Recipe(folder / "recipe.toml", engine="single-view")[0]["depth_sensor_distance"]
    assert not np.array_equal(by_name, recipe[0]["depth_sensor_distance"])


def test_an_engine_that_raises(folder: Path) -> None:
    def broken(depth: np.ndarray) -> np.ndarray:
        raise ValueError("no luck")

    recipe = oaktwin.Recipe(folder / "recipe.toml", engine=broken)
    with pytest.raises(oaktwin.Error) as caught:
        recipe[0]
    assert "no luck" in f"{caught.value} {caught.value.__cause__}"
    with pytest.raises(oaktwin.Error):
        recipe.generate(folder / "set")
    with pytest.raises(oaktwin.Error, match="engine: "):
        oaktwin.Recipe(folder / "recipe.toml", engine=3)  # type: ignore[arg-type]


def test_a_recipe_of_a_mapping(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    tomllib = pytest.importorskip("tomllib")
    values = tomllib.loads((folder / "recipe.toml").read_text())
    monkeypatch.chdir(folder)
    recipe = oaktwin.Recipe(values)
    assert same(recipe[2], oaktwin.Recipe(folder / "recipe.toml")[2])
    assert same(pickle.loads(pickle.dumps(recipe))[0], recipe[0])
    assert "4 frames" in repr(recipe)
    changed = {**values, "frames": np.int64(2), "scene": Path(values["scene"])}
    assert oaktwin.Recipe(changed).frames == 2
    oaktwin.generate(changed, folder / "of_mapping", frames=(0, 1))
    oaktwin.generate(folder / "recipe.toml", folder / "of_file", frames=range(1))
    name = "depth_sensor_distance_0000.npy"
    assert (folder / "of_mapping" / name).read_bytes() == (folder / "of_file" / name).read_bytes()
    for wrong, expected in [
        ({**values, "framez": 3}, "recipe: unknown key 'framez'.*frames"),
        ({**values, "frames": 0}, "recipe: frames: 0 is out of range"),
        ({**values, "seed": float("nan")}, "source: contains NaN"),
        (3, "source: invalid value 3; pass the path of a TOML file, or a mapping"),
    ]:
        with pytest.raises(oaktwin.Error, match=expected):
            oaktwin.Recipe(wrong)  # type: ignore[arg-type]
    for frames in [range(0, 4, 2), (1,), "all"]:
        with pytest.raises(oaktwin.Error, match="frames: invalid value"):
            recipe.generate(folder / "no", frames=frames)  # type: ignore[arg-type]
