"""Models, lenses and scenes of generated data sets, and depth files of other programs, as reference readers see them."""

import json
import subprocess
from pathlib import Path

import cv2
import numpy as np
import pycolmap
import pytest
import trimesh
from PIL import Image
from test_generate import RECIPES


def generate(program: Path, folder: Path, recipe: str, *options: str) -> Path:
    (folder / "recipe.toml").write_text(recipe)
    command = [program, "generate", folder / "recipe.toml", "-o", folder / "set", *options]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return folder / "set"


def objects(folder: Path) -> None:
    """A cube with a texture of four colours, and one with two colours and no texture."""
    folder.mkdir()
    box = trimesh.creation.box((0.2, 0.2, 0.2))
    pixels = np.array([[[255, 0, 0], [0, 255, 0]], [[0, 0, 255], [255, 255, 0]]], np.uint8)
    Image.fromarray(np.kron(pixels, np.ones((8, 8, 1), np.uint8))).save(folder / "four.png")
    for name in ("painted", "plain"):
        lines = [f"mtllib {name}.mtl"]
        lines += ["v {} {} {}".format(*vertex) for vertex in box.vertices]
        lines += ["vt 0.25 0.25", "vt 0.75 0.25", "vt 0.25 0.75"]
        for index, face in enumerate(box.faces):
            lines += [f"usemtl {'ab'[index // 6]}"] if index % 6 == 0 else []
            lines += ["f {}/1 {}/2 {}/3".format(*(face + 1))]
        (folder / f"{name}.obj").write_text("\n".join(lines))
    (folder / "painted.mtl").write_text("newmtl a\nKd 1 1 1\nmap_Kd four.png\nnewmtl b\nKd 1 1 1\nmap_Kd four.png\n")
    (folder / "plain.mtl").write_text("newmtl a\nKd 1 0 0\nnewmtl b\nKd 0 0.2140411 0\n")


def test_models_have_their_colours_and_scenes_are_saved(program: Path, tmp_path: Path) -> None:
    objects(tmp_path / "objects")
    recipe = f"""scene = '{RECIPES}/table.usda'
frames = 4
frames_per_scene = 2
objects = [{{ files = 'objects/', count = 3, on = '/World/Table' }}]
camera = {{ resolution = [160, 100] }}
output = {{ formats = ['bop', 'basic', 'euroc'] }}
"""
    root = generate(program, tmp_path, recipe, "--save-scenes")
    painted, plain = (trimesh.load(root / f"bop/models/obj_{number:06}.ply", process=False) for number in (1, 2))
    texture = np.asarray(painted.visual.material.image)
    assert texture.shape == (16, 16, 3)
    corners = painted.visual.uv[painted.faces]
    np.testing.assert_allclose(corners, np.broadcast_to([[0.25, 0.25], [0.75, 0.25], [0.25, 0.75]], corners.shape))
    # The lower left, the lower right and the upper left of the image.
    at = [texture[int((1 - v) * 16), int(u * 16)].tolist() for u, v in corners[0]]
    assert at == [[0, 0, 255], [255, 255, 0], [255, 0, 0]]
    colours = plain.visual.vertex_colors[plain.faces][:, :, :3]
    assert (colours[:6] == [255, 0, 0]).all() and (colours[6:] == [0, 127, 0]).all() or (colours[6:] == [0, 128, 0]).all()
    assert len(plain.faces) == 12 and np.ptp(plain.vertices, axis=0) == pytest.approx([200, 200, 200], rel=1e-5)

    manifest = {file["path"] for file in json.loads((root / "manifest.json").read_text())["files"]}
    assert {"scenes/000000.usda", "scenes/000001.usda", "bop/models/obj_000001.png"} <= manifest
    for number in range(4):
        # A saved scene gives the same depth.
        sequence = f"{number // 2:06}"
        states = np.loadtxt(root / f"euroc/{sequence}/mav0/state_groundtruth_estimate0/data.csv", delimiter=",")
        expected = np.load(root / f"basic/distance_to_image_plane_{number:04}.npy")
        ours = saved_depth(program, root / f"scenes/{sequence}.usda", states[number % 2], tmp_path / f"again{number}")
        both = np.isfinite(expected) & np.isfinite(ours)
        assert both.mean() > 0.5
        assert np.isclose(ours, expected, rtol=1e-5)[both].mean() > 0.999


def saved_depth(program: Path, stage: Path, state: np.ndarray, out: Path) -> np.ndarray:
    """The depth of the device's depth camera in a saved scene; the state is a line of EuRoC's ground truth."""
    position, (w, *xyz) = state[1:4], state[4:8]
    command = [program, "render", stage, "--model", "OAK-D-Pro-PoE", "--camera", "depth", "--resolution", "160x100"]
    command += ["--pose", *map(repr, map(float, [*position, *xyz, w])), "-o", out, "--annotators", "distance_to_image_plane"]
    subprocess.run(command, check=True, capture_output=True)
    (file,) = out.glob("distance_to_image_plane*.npy")
    return np.load(file)


def unit(program: Path, path: Path, fisheye: bool) -> tuple[np.ndarray, np.ndarray, int]:
    """A calibration whose colour camera has a lens; its matrix, its coefficients and the width of its images."""
    command = [program, "calibration", "export", "OAK-D Pro PoE", "--to", "depthai"]
    calibration = json.loads(subprocess.run(command, check=True, capture_output=True).stdout)
    camera = next(camera for _, camera in calibration["cameraData"] if camera["width"] > 1280)
    terms = [0.02, -0.01, 0.004, -0.002] if fisheye else [-0.12, 0.05, 0.001, -0.002, 0.01, 0.08, -0.02, 0.003]
    camera["cameraType"] = 1 if fisheye else 0
    camera["distortionCoeff"] = terms + [0.0] * (14 - len(terms))
    path.write_text(json.dumps(calibration))
    return np.array(camera["intrinsicMatrix"]), np.array(terms), camera["width"]


@pytest.mark.parametrize("fisheye", [False, True])
def test_lenses_are_those_of_the_calibration(program: Path, tmp_path: Path, fisheye: bool) -> None:
    matrix, terms, full = unit(program, tmp_path / "unit.json", fisheye)
    recipe = f"""scene = '{RECIPES}/table.usda'
frames = 1
objects = [{{ files = '{RECIPES}/objects/', count = 2, on = '/World/Table' }}]
camera = {{ model = 'OAK-D Pro PoE', cameras = 'rgb', resolution = [480, 270] }}
unit = {{ calibration = 'unit.json' }}
output = {{ formats = ['colmap', 'webdataset', 'tum'], annotators = ['rgb', 'distance_to_image_plane'] }}
"""
    root = generate(program, tmp_path, recipe)
    model = pycolmap.Reconstruction(root / "colmap/000000/sparse/0")
    (camera,) = model.cameras.values()
    assert camera.model_name == ("OPENCV_FISHEYE" if fisheye else "FULL_OPENCV")
    described = json.loads((root / "tum/000000/camera.json").read_text())
    kept = described["distortion"]["coefficients"]
    assert described["distortion"]["model"] == ("opencv-fisheye" if fisheye else "opencv-pinhole")
    np.testing.assert_allclose(kept[: len(terms)], terms, atol=1e-12)
    ours = np.reshape(described["camera_matrix"], (3, 3))
    assert ours[0, 0] == pytest.approx(matrix[0, 0] * 480 / full, rel=1e-6)
    points = np.array([[-0.3, 0.2, 1.0], [0.4, 0.1, 1.5], [0.1, -0.25, 0.9]])
    project = cv2.fisheye.projectPoints if fisheye else cv2.projectPoints
    shape = points[None] if fisheye else points
    expected, _ = project(shape, np.zeros(3), np.zeros(3), ours, terms)
    for point, pixel in zip(points, expected.reshape(-1, 2)):
        np.testing.assert_allclose(camera.img_from_cam(point), pixel + 0.5, atol=1e-6)
    (found,) = model.images.values()
    assert len(model.points3D) > 300
    for point in model.points3D.values():
        seen = found.points2D[point.track.elements[0].point2D_idx]
        np.testing.assert_allclose(found.project_point(point.xyz), seen.xy, atol=5e-3)


def test_lenses_that_a_format_cannot_hold_are_refused(program: Path, tmp_path: Path) -> None:
    unit(program, tmp_path / "unit.json", fisheye=False)
    (tmp_path / "recipe.toml").write_text(f"""scene = '{RECIPES}/table.usda'
frames = 1
camera = {{ model = 'OAK-D Pro PoE', cameras = 'rgb', resolution = [480, 270] }}
unit = {{ calibration = 'unit.json' }}
output = {{ formats = 'euroc', annotators = ['rgb', 'distance_to_image_plane'] }}
""")
    command = [program, "generate", tmp_path / "recipe.toml", "-o", tmp_path / "set"]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 2
    assert "euroc requires a lens with fewer radial terms; choose the depth camera" in done.stderr


@pytest.mark.parametrize("kind", ["npz", "npz-compressed", "int16", "int32", "uint32", "int64", "tiff-float", "tiff-uint16", "tiff-lzw"])
def test_depth_files_of_other_programs(program: Path, tmp_path: Path, kind: str) -> None:
    rng = np.random.default_rng(5)
    millimetres = rng.integers(700, 6000, (100, 160)).astype(np.int32)
    millimetres[:10] = 0
    metres = (millimetres / 1000).astype(np.float32)
    np.save(tmp_path / "metres.npy", metres)
    file = tmp_path / f"z.{'tiff' if 'tiff' in kind else 'npz' if 'npz' in kind else 'npy'}"
    match kind:
        case "npz":
            np.savez(file, rgb=np.zeros((2, 2)), depth=metres)
        case "npz-compressed":
            np.savez_compressed(file, metres)
        case "tiff-float":
            assert cv2.imwrite(str(file), metres)
        case "tiff-uint16":
            assert cv2.imwrite(str(file), millimetres.astype(np.uint16))
        case "tiff-lzw":
            Image.fromarray(millimetres, "I").save(file, compression="tiff_lzw")
        case _:
            np.save(file, millimetres.astype(kind))

    def sensed(path: Path) -> np.ndarray:
        out = tmp_path / f"out-{path.name}"
        command = [program, "sense", path, "--model", "OAK-D-Pro-PoE", "--input-kind", "z", "--seed", "1", "-o", out]
        done = subprocess.run(command, capture_output=True, text=True)
        assert done.returncode == 0, done.stderr
        (written,) = out.rglob("*depth_sensor_distance*.npy")
        return np.load(written)

    np.testing.assert_array_equal(sensed(file), sensed(tmp_path / "metres.npy"))
