"""What `oaktwin render` writes, as NumPy, OpenCV and Python's own JSON read it."""

import io
import json
import os
import subprocess
from pathlib import Path

import numpy as np
import pytest

os.environ["OPENCV_IO_ENABLE_OPENEXR"] = "1"  # read when the first such file is

import cv2  # noqa: E402

SCENE = Path(__file__).parent / "dataset.usda"
SIZE = (320, 200)
METERS_PER_UNIT = 0.01
DEPTHS = ("distance_to_image_plane", "distance_to_camera")
BOXES = ("bounding_box_2d_tight", "bounding_box_2d_loose")
BOX = np.dtype(
    [
        ("semanticId", "<u4"),
        ("x_min", "<i4"),
        ("y_min", "<i4"),
        ("x_max", "<i4"),
        ("y_max", "<i4"),
        ("occlusionRatio", "<f4"),
    ]
)

# What BasicWriter 0.0.2 writes for one frame of one camera.
PLAIN = {
    "rgb_0000.png",
    *(f"{depth}_0000.npy" for depth in DEPTHS),
    "normals_0000.png",
    "semantic_segmentation_0000.png",
    "semantic_segmentation_labels_0000.json",
    "instance_id_segmentation_0000.png",
    "instance_id_segmentation_mapping_0000.json",
    *(f"{box}_{file}" for box in BOXES for file in ("0000.npy", "labels_0000.json", "prim_paths_0000.json")),
    "pointcloud_0000.npy",
    *(f"pointcloud_{part}_0000.npy" for part in ("rgb", "normals", "semantic", "instance")),
    "camera_params_0000.json",
}
EXTRAS = {
    *(f"{depth}_{kind}_0000.png" for depth in DEPTHS for kind in ("millimetres", "preview")),
    *(f"{depth}_0000.exr" for depth in DEPTHS),
    "pointcloud_0000.ply",
}


def render(program: Path, folder: Path, *args: str) -> Path:
    size = "x".join(map(str, SIZE))
    command = [program, "render", SCENE, "-o", folder, "--resolution", size, "--annotators", "all", *args]
    subprocess.run(command, check=True, capture_output=True)
    return folder


@pytest.fixture(scope="module")
def one(program: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """One camera's frame with everything beside it."""
    folder = tmp_path_factory.mktemp("dataset") / "one"
    return render(program, folder, "--camera", "/World/Left", "--png16", "--exr", "--ply", "--preview")


def image(path: Path) -> np.ndarray:
    read = cv2.imread(str(path), cv2.IMREAD_UNCHANGED)
    assert read is not None, path
    return read


def rgba(path: Path) -> np.ndarray:
    return cv2.cvtColor(image(path), cv2.COLOR_BGRA2RGBA)


def loaded(path: Path) -> object:
    return json.loads(path.read_text())


def test_one_camera_lies_flat(one: Path) -> None:
    assert {path.name for path in one.iterdir()} == PLAIN | EXTRAS | {"metadata.txt"}
    assert loaded(one / "metadata.txt") == {
        "name": "BasicWriter",
        "version": "0.0.2",
        "replicator_global_seed:": 0,
    }


def test_several_cameras_have_a_folder_each(program: Path, tmp_path: Path) -> None:
    folder = render(program, tmp_path / "two")
    annotator = lambda name: max((a for a in ANNOTATORS if name.startswith(a)), key=len)  # noqa: E731
    expected = {f"{camera}/{annotator(name)}/{name}" for camera in ("Left", "Right") for name in PLAIN}
    files = {str(path.relative_to(folder)) for path in folder.rglob("*") if path.is_file()}
    assert files == expected | {"metadata.txt"}


ANNOTATORS = (
    "rgb",
    *DEPTHS,
    "normals",
    "semantic_segmentation",
    "instance_id_segmentation",
    *BOXES,
    "pointcloud",
    "camera_params",
)


def test_arrays_are_numpys_own_bytes(one: Path) -> None:
    arrays = sorted(one.glob("*.npy"))
    assert len(arrays) == 9
    for path in arrays:
        again = io.BytesIO()
        np.save(again, np.load(path))
        assert path.read_bytes() == again.getvalue(), path.name


def test_types_and_shapes(one: Path) -> None:
    width, height = SIZE
    points = len(np.load(one / "pointcloud_0000.npy"))
    expected = {
        **{depth: ("<f4", (height, width)) for depth in DEPTHS},
        "pointcloud": ("<f4", (points, 3)),
        "pointcloud_rgb": ("|u1", (points, 4)),
        "pointcloud_normals": ("<f4", (points, 4)),
        "pointcloud_semantic": ("|u1", (points,)),
        "pointcloud_instance": ("|u1", (points,)),
    }
    for stem, (dtype, shape) in expected.items():
        array = np.load(one / f"{stem}_0000.npy")
        assert (array.dtype.str, array.shape) == (dtype, shape), stem
    for stem in ("rgb", "normals", "semantic_segmentation", "instance_id_segmentation"):
        picture = image(one / f"{stem}_0000.png")
        assert (picture.dtype, picture.shape) == (np.uint8, (height, width, 4)), stem
    for stem in BOXES:
        assert np.load(one / f"{stem}_0000.npy").dtype == BOX, stem


@pytest.mark.parametrize("depth", DEPTHS)
def test_depth_in_every_format(one: Path, depth: str) -> None:
    metres = np.load(one / f"{depth}_0000.npy")
    hit = np.isfinite(metres)
    assert hit.any() and np.isposinf(metres[~hit]).all() and (~hit).any()
    assert 1.5 < metres[hit].min() < metres[hit].max() < 10.0
    assert (image(one / f"{depth}_0000.exr").view(np.uint32) == metres.view(np.uint32)).all()
    millimetres = image(one / f"{depth}_millimetres_0000.png")
    assert millimetres.dtype == np.uint16
    assert (millimetres == np.where(hit, np.rint(metres * np.float32(1000)), 0)).all()
    preview = image(one / f"{depth}_preview_0000.png")
    assert preview.shape[1:] == (SIZE[0], 3) and preview.shape[0] > SIZE[1]
    shown = preview[: SIZE[1]]
    assert (shown[~hit] == 96).all() and (np.ptp(shown[hit], axis=1) > 0).all()


def test_normals_are_coloured_as_basic_writer_does(one: Path) -> None:
    hit = np.isfinite(np.load(one / "distance_to_camera_0000.npy"))
    picture = rgba(one / "normals_0000.png")
    normals = np.load(one / "pointcloud_normals_0000.npy")
    assert np.allclose(np.linalg.norm(normals[:, :3], axis=1), 1, atol=1e-5) and (normals[:, 3] == 1).all()
    coloured = ((normals * np.float32(0.5) + np.float32(0.5)) * np.float32(255)).astype(np.uint8)
    assert (picture[hit] == coloured).all()
    assert (picture[~hit] == (127, 127, 127, 255)).all()


def test_points_land_on_their_pixels(one: Path) -> None:
    params = loaded(one / "camera_params_0000.json")
    assert list(params) == sorted(params, key=str.lower)
    assert params["cameraModel"] == "pinhole" and params["renderProductResolution"] == list(SIZE)
    assert params["metersPerSceneUnit"] == np.float32(METERS_PER_UNIT)
    width, height = SIZE
    view = np.array(params["cameraViewTransform"]).reshape(4, 4)
    projection = np.array(params["cameraProjection"]).reshape(4, 4)
    points = np.load(one / "pointcloud_0000.npy").astype(float)
    in_camera = np.c_[points, np.ones(len(points))] @ view
    clip = in_camera @ projection
    u = (clip[:, 0] / clip[:, 3] + 1) / 2 * width
    v = (1 - clip[:, 1] / clip[:, 3]) / 2 * height

    # Row by row, one point for each pixel that sees something, at its centre and its depth.
    z = np.load(one / "distance_to_image_plane_0000.npy")
    rows, columns = np.nonzero(np.isfinite(z))
    assert len(points) == len(rows)
    assert np.abs(u - columns - 0.5).max() < 2e-3 and np.abs(v - rows - 0.5).max() < 2e-3
    assert np.allclose(-in_camera[:, 2] * METERS_PER_UNIT, z[rows, columns], rtol=1e-5)
    distance = np.load(one / "distance_to_camera_0000.npy")
    assert np.allclose(
        np.linalg.norm(in_camera[:, :3], axis=1) * METERS_PER_UNIT, distance[rows, columns], rtol=1e-5
    )
    # Reversed: 1 at the near plane, 0 at the far one.
    near, far = params["cameraNearFar"]
    for depth, expected in ((near, 1), (far, 0)):
        at = np.array([0, 0, -depth, 1]) @ projection
        assert at[2] / at[3] == pytest.approx(expected, abs=1e-9)


def colours(picture: np.ndarray) -> set[str]:
    return {str(tuple(int(c) for c in colour)) for colour in np.unique(picture.reshape(-1, 4), axis=0)}


def test_segmentations_name_their_colours(one: Path) -> None:
    semantic = rgba(one / "semantic_segmentation_0000.png")
    labels = loaded(one / "semantic_segmentation_labels_0000.json")
    assert colours(semantic) == set(labels)
    assert sorted(label["class"] for label in labels.values()) == ["BACKGROUND", "UNLABELLED", "ball", "box"]
    assert labels["(0, 0, 0, 0)"] == {"class": "BACKGROUND"}
    assert labels["(0, 0, 0, 255)"] == {"class": "UNLABELLED"}
    instances = rgba(one / "instance_id_segmentation_0000.png")
    mapping = loaded(one / "instance_id_segmentation_mapping_0000.json")
    assert colours(instances) <= set(mapping)
    assert set(mapping.values()) == {"BACKGROUND", "UNLABELLED", "/World/Ball", "/World/Box", "/World/Wall"}
    background = ~np.isfinite(np.load(one / "distance_to_camera_0000.npy"))
    for picture in (semantic, instances):
        assert ((picture == 0).all(axis=2) == background).all()


def test_boxes_surround_what_is_seen(one: Path) -> None:
    instances = rgba(one / "instance_id_segmentation_0000.png")
    mapping = loaded(one / "instance_id_segmentation_mapping_0000.json")
    tight, loose = (np.load(one / f"{stem}_0000.npy") for stem in BOXES)
    labels, paths = (loaded(one / f"{BOXES[0]}_{part}_0000.json") for part in ("labels", "prim_paths"))
    assert sorted(paths) == ["/World/Ball", "/World/Box"]
    for box, path in zip(tight, paths, strict=True):
        assert labels[str(box["semanticId"])]["class"] == path.rsplit("/", 1)[1].lower()
        colour = next(key for key, value in mapping.items() if value == path)
        rows, columns = np.nonzero((instances == json.loads(f"[{colour[1:-1]}]")).all(axis=2))
        seen = [columns.min(), rows.min(), columns.max(), rows.max()]
        assert [int(box[name]) for name in BOX.names[1:5]] == seen, path
    for box, outer in zip(tight, loose, strict=True):
        assert outer["x_min"] <= box["x_min"] and outer["x_max"] >= box["x_max"]
        assert outer["y_min"] <= box["y_min"] and outer["y_max"] >= box["y_max"]


def test_the_cloud_is_its_arrays(one: Path) -> None:
    header, data = (one / "pointcloud_0000.ply").read_bytes().split(b"end_header\n", 1)
    lines = header.decode().splitlines()
    assert lines[:2] == ["ply", "format binary_little_endian 1.0"]
    kinds = {"float": "<f4", "uchar": "u1"}
    vertex = np.dtype([(name, kinds[kind]) for _, kind, name in (line.split() for line in lines[3:])])
    cloud = np.frombuffer(data, vertex)
    assert lines[2] == f"element vertex {len(cloud)}"
    points, normals, rgb = (
        np.load(one / f"{stem}_0000.npy") for stem in ("pointcloud", "pointcloud_normals", "pointcloud_rgb")
    )
    columns = lambda *names: np.stack([cloud[name] for name in names], axis=1)  # noqa: E731
    assert (columns("x", "y", "z") == points).all()
    assert (columns("nx", "ny", "nz") == normals[:, :3]).all()
    assert (columns("red", "green", "blue") == rgb[:, :3]).all()
    picture = rgba(one / "rgb_0000.png")
    assert (picture[np.isfinite(np.load(one / "distance_to_camera_0000.npy"))] == rgb).all()
