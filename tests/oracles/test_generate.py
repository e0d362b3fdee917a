"""Generated data sets, as the reference readers of their formats see them, and by ray casting in NumPy."""

import hashlib
import json
import subprocess
from pathlib import Path

import numpy as np
import pycolmap
import pytest
import trimesh
import webdataset
from evo.tools import file_interface
from pycocotools.coco import COCO
from ruamel.yaml import YAML
from scipy.spatial.distance import pdist
from scipy.spatial.transform import Rotation

from generated import Bop, cast, image, matrix_of, world_from_camera

yaml = YAML(typ="safe")
RECIPES = Path(__file__).resolve().parents[2] / "examples/recipes"
FORMATS = ["basic", "bop", "coco", "tum", "euroc", "nerfstudio", "colmap", "webdataset", "middlebury", "kitti", "sceneflow"]
RECIPE = f"""
frames = 4
frames_per_scene = 2
seed = 3
scene = '{RECIPES}/table.usda'
[[objects]]
files = '{RECIPES}/objects/'
count = {{ uniform = [5, 7] }}
on = '/World/Table'
pose = 'resting'
look = {{}}
[light]
lamps = {{}}
projector = 0
[camera]
resolution = [320, 200]
sphere = {{ distance_m = {{ uniform = [0.5, 1.2] }} }}
min_objects = 3
rgb_imager = false  # the confidence follows from exact colours
[sensor]
extended_disparity = true
[output]
shard_frames = 3
annotators = ['rgb', 'distance_to_image_plane', 'depth_sensor_distance', 'depth_sensor_reason', 'depth_sensor_confidence',
    'camera_params']
"""


@pytest.fixture(scope="session")
def root(program: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("generated")
    (folder / "recipe.toml").write_text(RECIPE)
    command = [program, "generate", folder / "recipe.toml", "-o", folder / "set", "--formats", ",".join(FORMATS)]
    subprocess.run(command, check=True)
    return folder / "set"


@pytest.fixture(scope="session")
def bop(root: Path) -> Bop:
    return Bop(root / "bop")


def test_bop_depth_is_that_of_the_models_at_their_poses(bop: Bop) -> None:
    random = np.random.default_rng(0)
    compared = 0
    for number, (scene, camera, poses, _) in bop.frames.items():
        depth = image(scene / f"depth_exact/{number:06}.png").astype(float)
        for index, pose in enumerate(poses):
            visible = image(scene / f"mask_visib/{number:06}_{index:06}.png") > 0
            pixels = np.argwhere(visible)[:, ::-1]
            if not len(pixels):
                continue
            pixels = random.permutation(pixels)[:60]
            expected = cast(bop.triangles(pose), matrix_of(camera), pixels)
            found = depth[pixels[:, 1], pixels[:, 0]]
            # Half a millimetre of rounding. A camera matrix that is wrong by half a pixel fails on slanted faces.
            assert np.abs(found - expected).max() < 0.51
            compared += len(pixels)
    assert compared > 500


def test_bop_masks_are_silhouettes(bop: Bop) -> None:
    random = np.random.default_rng(1)
    partly_hidden = 0
    for number, (scene, camera, poses, infos) in bop.frames.items():
        depth = image(scene / f"depth/{number:06}.png")
        height, width = depth.shape
        for index, (pose, info) in enumerate(zip(poses, infos)):
            whole = image(scene / f"mask/{number:06}_{index:06}.png") > 0
            visible = image(scene / f"mask_visib/{number:06}_{index:06}.png") > 0
            assert not (visible & ~whole).any()
            triangles = bop.triangles(pose)
            corners = triangles.reshape(-1, 3) @ matrix_of(camera).T
            corners = corners[:, :2] / corners[:, 2:]
            low, high = corners.min(axis=0), corners.max(axis=0)
            pixels = random.uniform(low - 2, high + 2, (80, 2)).round()
            hit = np.isfinite(cast(triangles, matrix_of(camera), pixels))
            inside = ((pixels >= 0) & (pixels < [width, height])).all(axis=1)
            at = pixels[inside].astype(int)
            # A pixel on the outline may differ in the last digit.
            assert (whole[at[:, 1], at[:, 0]] != hit[inside]).sum() <= 1
            x, y, w, h = info["bbox_obj"]
            if visible.any():
                # As in bop_toolkit, the size is the difference between the first and the last pixel.
                assert np.abs(np.array([x, y]) - np.ceil(low - 1e-6)).max() <= 1
                assert np.abs(np.array([x + w, y + h]) - np.floor(high + 1e-6)).max() <= 1
            else:
                assert info["bbox_obj"] == [-1, -1, -1, -1]
            assert info["px_count_visib"] == visible.sum()
            assert info["px_count_valid"] == (whole & (depth > 0)).sum()
            assert info["px_count_all"] >= whole.sum()
            if (low >= 0).all() and (high <= [width - 1, height - 1]).all():
                assert info["px_count_all"] == whole.sum()
            assert info["visib_fract"] == pytest.approx(visible.sum() / info["px_count_all"])
            partly_hidden += 0 < info["visib_fract"] < 0.97
            if visible.any():
                ys, xs = np.nonzero(visible)
                assert info["bbox_visib"] == [xs.min(), ys.min(), np.ptp(xs), np.ptp(ys)]
            else:
                assert info["bbox_visib"] == [-1, -1, -1, -1]
    assert partly_hidden > 2


def test_bop_models_have_their_size(bop: Bop) -> None:
    infos = json.loads((bop.root / "models/models_info.json").read_text())
    assert len(infos) >= 5
    for number, info in infos.items():
        points = bop.model(int(number)).vertices
        assert info["diameter"] == pytest.approx(pdist(np.unique(points, axis=0)).max(), rel=1e-5)
        low, size = ([info[f"{name}_{axis}"] for axis in "xyz"] for name in ("min", "size"))
        np.testing.assert_allclose(low, points.min(axis=0), atol=1e-4)
        np.testing.assert_allclose(size, np.ptp(points, axis=0), atol=1e-4)


def test_objects_do_not_overlap(bop: Bop) -> None:
    """Points inside of one object are not inside of another one, and all are above the table."""
    for number, (_, camera, poses, _) in bop.frames.items():
        if number % 2:
            continue
        world = world_from_camera(camera)
        hulls = []
        for pose in poses:
            points = bop.triangles(pose).reshape(-1, 3) * 1e-3 @ world[:3, :3].T + world[:3, 3]
            assert points[:, 2].min() > 0.74
            hulls.append(trimesh.convex.convex_hull(points))
        for at, hull in enumerate(hulls):
            inner = hull.centroid + 0.98 * (hull.vertices - hull.centroid)
            for other in hulls[:at]:
                faces = other.triangles_center, other.face_normals
                outside = np.einsum("pfi,fi->pf", inner[:, None] - faces[0], faces[1])
                assert (outside.max(axis=1) > 0).all()


def test_coco_has_the_visible_masks(root: Path, bop: Bop) -> None:
    coco = COCO(root / "coco/annotations/instances.json")
    names = json.loads((bop.root / "models/models_names.json").read_text())
    for key, found in coco.imgs.items():
        number = key - 1
        assert image(root / "coco/images" / found["file_name"]).shape == (200, 320, 3)
        scene, _, poses, infos = bop.frames[number]
        annotations = coco.loadAnns(coco.getAnnIds(imgIds=key))
        seen = [index for index, info in enumerate(infos) if info["px_count_visib"]]
        assert len(annotations) == len(seen)
        for annotation, index in zip(annotations, seen):
            mask = image(scene / f"mask_visib/{number:06}_{index:06}.png") > 0
            np.testing.assert_array_equal(coco.annToMask(annotation) > 0, mask)
            assert annotation["area"] == mask.sum()
            x, y, w, h = infos[index]["bbox_visib"]
            assert annotation["bbox"] == [x, y, w + 1, h + 1]
            category = coco.cats[annotation["category_id"]]["name"]
            assert category == names[str(poses[index]["obj_id"])]["label"]


def test_tum_has_the_trajectory(root: Path, bop: Bop) -> None:
    for sequence in range(2):
        folder = root / f"tum/{sequence:06}"
        trajectory = file_interface.read_tum_trajectory_file(folder / "groundtruth.txt")
        np.testing.assert_allclose(trajectory.timestamps, [0, 1 / 30], atol=1e-9)
        for index, pose in enumerate(trajectory.poses_se3):
            scene, camera, _, _ = bop.frames[2 * sequence + index]
            np.testing.assert_allclose(pose, world_from_camera(camera), atol=1e-8)
            line = (folder / "associations.txt").read_text().splitlines()[1 + index].split()
            depth = image(folder / line[1]).astype(float) / 5
            expected = image(scene / f"depth/{2 * sequence + index:06}.png").astype(float)
            assert np.abs(depth - expected).max() <= 0.6
            assert (depth > 0).mean() > 0.3
            assert image(folder / line[3]).shape == (200, 320, 3)


def test_euroc(root: Path, bop: Bop) -> None:
    for sequence in range(2):
        folder = root / f"euroc/{sequence:06}/mav0"
        table = folder / "state_groundtruth_estimate0/data.csv"
        trajectory = file_interface.read_euroc_csv_trajectory(table)
        # Kalibr takes stamps near 0 for missing ones.
        np.testing.assert_allclose(trajectory.timestamps - 1.5e9, [0, 1 / 30], atol=1e-6)
        states = np.loadtxt(table, delimiter=",")
        assert states.shape == (2, 17) and (states[:, 11:] == 0).all()
        moved = (states[1, 1:4] - states[0, 1:4]) * 30
        np.testing.assert_allclose(states[:, 8:11], [moved, moved], atol=1e-6)
        sensor = yaml.load((folder / "cam0/sensor.yaml").read_text())
        body_from_camera = np.reshape(sensor["T_BS"]["data"], (4, 4))
        # x forward, y left, z up, with the camera at most a few centimetres from the middle.
        np.testing.assert_allclose(body_from_camera[:3, :3], [[0, 0, 1], [-1, 0, 0], [0, -1, 0]], atol=1e-9)
        assert np.abs(body_from_camera[:3, 3]).max() < 0.1 and sensor["rate_hz"] == pytest.approx(30)
        lines = (folder / "cam0/data.csv").read_text().splitlines()
        assert lines[0] == "#timestamp [ns],filename" and len(lines) == 3
        for index, pose in enumerate(trajectory.poses_se3):
            scene, camera, _, _ = bop.frames[2 * sequence + index]
            np.testing.assert_allclose(pose @ body_from_camera, world_from_camera(camera), atol=1e-8)
            matrix = matrix_of(camera)
            expected = [matrix[0, 0], matrix[1, 1], matrix[0, 2], matrix[1, 2]]
            np.testing.assert_allclose(sensor["intrinsics"], expected, atol=1e-6)
            time, name = lines[1 + index].split(",")
            assert name == f"{time}.png" and int(time) == 1_500_000_000_000_000_000 + round(index / 30 * 1e9)
            assert np.array_equal(image(folder / "cam0/data" / name), image(scene / f"rgb/{2 * sequence + index:06}.png"))
            assert np.array_equal(image(folder / "depth0/data" / name), image(scene / f"depth/{2 * sequence + index:06}.png"))


def test_nerfstudio_has_opengl_cameras(root: Path, bop: Bop) -> None:
    for sequence in range(2):
        folder = root / f"nerfstudio/{sequence:06}"
        transforms = json.loads((folder / "transforms.json").read_text())
        for index, frame in enumerate(transforms["frames"]):
            _, camera, _, _ = bop.frames[2 * sequence + index]
            pose = np.array(frame["transform_matrix"]) @ np.diag([1, -1, -1, 1])
            np.testing.assert_allclose(pose, world_from_camera(camera), atol=1e-9)
            matrix = matrix_of(camera)
            assert [frame["fl_x"], frame["cx"]] == pytest.approx([matrix[0, 0], matrix[0, 2] + 0.5])
            assert (folder / frame["file_path"]).exists() and (folder / frame["depth_file_path"]).exists()


def test_colmap_projects_as_bop(root: Path, bop: Bop) -> None:
    for sequence in range(2):
        model = pycolmap.Reconstruction(root / f"colmap/{sequence:06}/sparse/0")
        assert len(model.images) == 2 and len(model.rigs) == 1 and len(model.frames) == 2
        assert len(model.points3D) > 500
        for point in model.points3D.values():
            (element,) = point.track.elements
            found = model.images[element.image_id]
            seen = found.points2D[element.point2D_idx]
            np.testing.assert_allclose(found.project_point(point.xyz), seen.xy, atol=2e-3)
            x, y = (int(value) for value in seen.xy)
            number = int(Path(found.name).stem)
            scene = bop.frames[number][0]
            assert abs(image(scene / f"depth_exact/{number:06}.png")[y, x] - (found.cam_from_world() * point.xyz)[2] * 1000) < 0.51
            assert (point.color == image(scene / f"rgb/{number:06}.png")[y, x]).all()
        for found in model.images.values():
            _, camera, _, _ = bop.frames[int(Path(found.name).stem)]
            assert (root / f"colmap/{sequence:06}/images" / found.name).exists()
            point = world_from_camera(camera) @ [0.1, -0.2, 1.5, 1]
            expected = matrix_of(camera) @ [0.1, -0.2, 1.5]
            pixel = found.project_point(point[:3])
            np.testing.assert_allclose(pixel, expected[:2] / expected[2] + 0.5, atol=1e-6)


def test_quaternions_are_rotations(root: Path) -> None:
    line = (root / "tum/000000/groundtruth.txt").read_text().splitlines()[1].split()
    assert len(line) == 8
    assert np.linalg.norm(Rotation.from_quat([float(x) for x in line[4:]]).as_quat()) == pytest.approx(1)


def test_the_manifest_has_every_file(root: Path) -> None:
    manifest = json.loads((root / "manifest.json").read_text())
    listed = {file["path"]: file for file in manifest["files"]}
    present = {str(path.relative_to(root)) for path in root.rglob("*") if path.is_file()}
    assert present - set(listed) == {name for name in present if name.startswith(".oaktwin/")} | {"manifest.json"}
    assert set(listed) <= present
    for path, file in list(listed.items())[::7]:
        assert hashlib.sha256((root / path).read_bytes()).hexdigest() == file["sha256"]


def test_webdataset(root: Path) -> None:
    """Read by its own package; the arrays and images are BasicWriter's."""
    shards = sorted(str(path) for path in (root / "webdataset").glob("*.tar"))
    assert [Path(shard).name for shard in shards] == ["shard-000000.tar", "shard-000001.tar"]
    samples = list(webdataset.WebDataset(shards, shardshuffle=False).decode("rgb8"))
    assert [sample["__key__"] for sample in samples] == [f"{number:08}" for number in range(4)]
    for number, sample in enumerate(samples):
        for name in ["distance_to_image_plane", "depth_sensor_distance"]:
            expected = np.load(root / f"basic/{name}_{number:04}.npy")
            assert np.array_equal(sample[f"{name}.npy"], expected)
        assert np.array_equal(sample["rgb.png"], image(root / f"basic/rgb_{number:04}.png")[..., :3])
        camera = json.loads((root / f"bop/train/{number // 2:06}/scene_camera.json").read_text())[str(number)]
        assert sample["json"]["distortion"] == {"model": "pinhole", "coefficients": []}
        assert sample["json"]["frame"] == number and np.allclose(sample["json"]["camera_matrix"], camera["cam_K"])
        assert np.allclose(sample["json"]["world_from_camera"], world_from_camera(camera), atol=1e-6)
        assert sample["camera_params.json"]["renderProductResolution"] == [320, 200]


def beside_depth(root: Path, folder: str) -> dict[str, list[str]]:
    """The images of this folder in every format with depth, in the order of the frames."""
    return {
        "bop": [f"train/{number // 2:06}/{folder}/{number:06}.png" for number in range(4)],
        "tum": [str(path.relative_to(root / "tum")) for path in sorted((root / "tum").glob(f"*/{folder}/*.png"))],
        "nerfstudio": [f"{number // 2:06}/{folder}/{number:06}.png" for number in range(4)],
        "kitti": [f"training/{folder}/{number:06}_10.png" for number in range(4)],
        "middlebury": [f"{number:06}/{folder}.png" for number in range(4)],
        "sceneflow": [f"FlyingThings3D/{folder}/TRAIN/A/{number // 2:04}/left/{number:04}.png" for number in range(4)],
    }


def test_confidence(root: Path) -> None:
    """In every format with depth: the texture of the matching window, computed here, which the threshold of 55 is compared with."""
    expected = []
    for number in range(4):
        r, g, b = np.moveaxis(image(root / f"basic/rgb_{number:04}.png")[..., :3].astype(int), -1, 0)
        luma = (77 * r + 150 * g + 29 * b) >> 8
        differences = np.abs(np.diff(luma, axis=1))
        field = np.pad(np.hstack([differences, differences[:, -1:]]), 2, mode="edge")
        # 4 px of 1280 are 1 of 320, the smallest window has 5 px, and a quarter of the pixels averages fine texture.
        sums = sum(field[y : y + 200, x : x + 320] for y in range(5) for x in range(5))
        expected.append(np.minimum(sums * 72 * 4**0.75 / 25, 255).astype(int))
        found = image(root / f"basic/depth_sensor_confidence_{number:04}.png")
        assert found.dtype == np.uint16 and np.array_equal(found, expected[-1])
        assert 0.02 < (found < 55).mean() < 0.98
    for name, files in beside_depth(root, "depth_confidence").items():
        assert len(files) == 4
        for file, levels in zip(files, expected):
            assert np.array_equal(image(root / name / file), levels), name


def test_reasons_for_missing_depth(root: Path) -> None:
    """In every format with depth: 0 where there is depth, else a code of the legend."""
    expected = [image(root / f"basic/depth_sensor_reason_{number:04}.png") for number in range(4)]
    measured = [np.load(root / f"basic/depth_sensor_distance_{number:04}.npy") for number in range(4)]
    for name, files in beside_depth(root, "depth_reason").items():
        legend = {int(code) for code in json.loads((root / name / "depth_reasons.json").read_text())}
        assert len(files) == 4
        for file, codes, depth in zip(files, expected, measured):
            found = image(root / name / file)
            assert np.array_equal(found, codes), name
            assert np.array_equal(found == 0, depth > 0) and set(np.unique(found)) - {0} <= legend
