"""DepthAI's own library, OpenCV and PyYAML on calibrations that the program reads and writes."""

import json
import re
import subprocess
from pathlib import Path

import cv2
import depthai as dai
import numpy as np
import pytest
import yaml

FIXTURES = Path(__file__).resolve().parents[2] / "crates" / "calibration" / "fixtures"
FILES = sorted(FIXTURES.glob("*.json"))
MODELS = ["OAK-D Pro PoE", "OAK-D Pro W PoE", "OAK4-D", "OAK4-D Wide", "OAK-D ToF"]
CM_PER_M = 100.0


def socket(name: str) -> dai.CameraBoardSocket:
    return getattr(dai.CameraBoardSocket, name)


def run(program: Path, *arguments: object) -> str:
    command = [str(program), "calibration", *map(str, arguments)]
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def run_with_findings(program: Path, *arguments: object) -> str:
    """Returns what the program says about the files."""
    command = [str(program), "calibration", *map(str, arguments)]
    return subprocess.run(command, check=True, capture_output=True, text=True).stderr


def show(program: Path, file: Path) -> dict:
    return json.loads(run(program, "show", file, "--json"))


def export(program: Path, what: object, to: str, out: Path) -> Path:
    run(program, "export", what, "--to", to, "-o", out)
    return out


@pytest.fixture(scope="module", params=[*FILES, *MODELS], ids=lambda p: p.stem if isinstance(p, Path) else p)
def file(request: pytest.FixtureRequest, program: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A fixture as it is, or a nominal device as the program exports it."""
    if isinstance(request.param, Path):
        return request.param
    out = tmp_path_factory.mktemp("nominal") / "calibration.json"
    return export(program, request.param, "depthai", out)


@pytest.fixture(scope="module")
def ours(program: Path, file: Path) -> dict:
    return show(program, file)


@pytest.fixture(scope="module")
def theirs(file: Path) -> dai.CalibrationHandler:
    return dai.CalibrationHandler(str(file))


def assert_transform(ours: list, theirs: list, what: str) -> None:
    """Rotations and centimetres, computed in 32 bits there and in 64 here."""
    np.testing.assert_allclose(np.array(ours), np.array(theirs), rtol=3e-6, atol=3e-6, err_msg=what)


def test_cameras(ours: dict, theirs: dai.CalibrationHandler) -> None:
    sockets = {camera["socket"] for camera in ours["cameras"]}
    assert sockets == {s.name for s in theirs.getEepromData().cameraData}
    for camera in ours["cameras"]:
        where = socket(camera["socket"])
        intrinsics = theirs.getCameraIntrinsics(where, camera["width"], camera["height"])
        np.testing.assert_allclose(camera["camera_matrix"], intrinsics, rtol=1e-6)
        coefficients = theirs.getDistortionCoefficients(where)
        np.testing.assert_allclose(camera["distortion"], coefficients, rtol=1e-6)
        assert camera["model"] == theirs.getDistortionModel(where).name
        assert camera["hfov_deg"] == pytest.approx(theirs.getFov(where, useSpec=False), rel=1e-5)
        assert camera["spec_hfov_deg"] == pytest.approx(theirs.getFov(where, useSpec=True), rel=1e-6)
        assert camera["lens_position"] == theirs.getLensPosition(where)
        assert (camera["width"], camera["height"]) == (theirs.getSourceWidth(where), theirs.getSourceHeight(where))


def test_pairs(ours: dict, theirs: dai.CalibrationHandler) -> None:
    n = len(ours["cameras"])
    assert len(ours["pairs"]) == n * (n - 1)
    for pair in ours["pairs"]:
        ends = socket(pair["from"]), socket(pair["to"])
        for use_spec, prefix in ((False, ""), (True, "spec_")):
            found = pair[f"{prefix}to_from_from_cm"]
            try:
                expected = theirs.getCameraExtrinsics(*ends, useSpecTranslation=use_spec)
            except RuntimeError:
                assert found is None and pair[f"{prefix}baseline_cm"] is None
                continue
            assert_transform(found, expected, f"{pair['from']} {pair['to']} {use_spec}")
            distance = theirs.getBaselineDistance(*ends, useSpecTranslation=use_spec)
            assert pair[f"{prefix}baseline_cm"] == pytest.approx(distance, rel=1e-5)


def test_rectification(ours: dict, theirs: dai.CalibrationHandler) -> None:
    stereo = ours["stereo"]
    assert socket(stereo["left"]) == theirs.getStereoLeftCameraId()
    assert socket(stereo["right"]) == theirs.getStereoRightCameraId()
    assert_transform(stereo["rectified_from_left"], theirs.getStereoLeftRectificationRotation(), "R1")
    assert_transform(stereo["rectified_from_right"], theirs.getStereoRightRectificationRotation(), "R2")


def test_imu(ours: dict, theirs: dai.CalibrationHandler) -> None:
    found = {imu["camera"]: imu for imu in ours["imu"]}
    for camera in ours["cameras"]:
        name = camera["socket"]
        for use_spec, key in ((False, "camera_from_imu_cm"), (True, "spec_camera_from_imu_cm")):
            try:
                expected = theirs.getImuToCameraExtrinsics(socket(name), use_spec)
            except RuntimeError:
                assert name not in found or found[name][key] is None
                continue
            assert_transform(found[name][key], expected, f"{name} {use_spec}")


def test_depthai_export_is_what_depthai_writes(program: Path, file: Path, tmp_path: Path) -> None:
    """Keys and numbers survive their reader; the layout of files that they wrote survives ours."""
    out = export(program, file, "depthai", tmp_path / "out.json")
    assert json.loads(out.read_text()) == json.loads(file.read_text())
    if file.parent == FIXTURES:
        assert out.read_bytes() == file.read_bytes()
        return
    dai.CalibrationHandler(str(out)).eepromToJsonFile(str(tmp_path / "theirs.json"))
    written = json.loads((tmp_path / "theirs.json").read_text())
    ours = json.loads(out.read_text())
    assert ours.keys() <= written.keys()
    assert (tmp_path / "theirs.json").read_text().startswith("{\n    ")


def projected(points: np.ndarray, k: np.ndarray, d: np.ndarray, fisheye: bool) -> np.ndarray:
    zero = np.zeros(3)
    if fisheye:
        return cv2.fisheye.projectPoints(points.reshape(-1, 1, 3), zero, zero, k, d.reshape(-1, 1))[0].reshape(-1, 2)
    return cv2.projectPoints(points, zero, zero, k, d)[0].reshape(-1, 2)


def named(ours: dict) -> dict[str, dict]:
    """The cameras by their names in exports."""
    product = "".join(c for c in ours["board"]["product_name"].lower() if c.isalnum())
    names = {"CAM_A": "tof" if "tof" in product or "srpoe" in product else "rgb"}
    names |= {ours["stereo"]["left"]: "left", ours["stereo"]["right"]: "right"}
    return {names.get(c["socket"], c["socket"].lower()): c for c in ours["cameras"]}


def residual_of(said: str, file: Path, camera: dict) -> tuple[float, float]:
    """The stated residual of a camera, px: root mean square and maximum; 0 if it was not fitted."""
    sockets = [number for number, _ in json.loads(file.read_text())["cameraData"]]
    place = f"cameraData[{sockets.index(ord(camera['socket'][-1]) - ord('A'))}].distortionCoeff"
    found = [line for line in said.splitlines() if "[distortion-fitted]" in line and place in line]
    assert len(found) <= 1, place
    if not found:
        return 0.0, 0.0
    rms, worst = re.search(r"residual is ([\d.]+) px .*at most ([\d.]+) px", found[0]).groups()
    return float(rms), float(worst)


def assert_residual(k: np.ndarray, d: list, fisheye: bool, source: dict, stated: tuple[float, float]) -> None:
    """OpenCV's projections of rays by the exported model differ from the file's by no more than the program states."""
    width, height = source["width"], source["height"]
    x, y = np.meshgrid(np.linspace(0, width - 1, 33), np.linspace(0, height - 1, 33))
    pixels = np.stack([x.ravel(), y.ravel()], axis=1)
    own, coefficients = np.array(source["camera_matrix"]), np.array(source["distortion"])
    is_fisheye = source["model"] == "Fisheye"
    if is_fisheye:
        flat = cv2.fisheye.undistortPoints(pixels[:, None], own, coefficients.reshape(-1, 1))
    else:
        flat = cv2.undistortPoints(pixels[:, None], own, coefficients)
    points = np.concatenate([flat.reshape(-1, 2), np.ones((len(pixels), 1))], axis=1)
    back = projected(points, own, coefficients, is_fisheye)
    reached = np.abs(back - pixels).max(axis=1) < 0.5
    errors = np.linalg.norm(projected(points, k, np.array(d), fisheye) - back, axis=1)[reached]
    assert np.sqrt((errors**2).mean()) < 1.15 * stated[0] + 0.02
    assert errors.max() < 1.1 * stated[1] + 0.05


def test_opencv_export(program: Path, file: Path, ours: dict, tmp_path: Path) -> None:
    out = export(program, file, "opencv", tmp_path / "opencv")
    loaded = {path.stem: cv2.FileStorage(str(path), cv2.FILE_STORAGE_READ) for path in out.glob("*.yml")}
    assert all(storage.isOpened() for storage in loaded.values())
    names = ("M1", "D1", "M2", "D2", "R", "T", "E", "F", "R1", "R2", "P1", "P2", "Q")
    stereo = {name: loaded["stereo"].getNode(name).mat() for name in names}
    assert len(loaded) == len(ours["cameras"]) + 1
    for name, storage in loaded.items():
        if name != "stereo":
            k, d = (storage.getNode(n).mat() for n in ("camera_matrix", "distortion_coefficients"))
            size = (int(storage.getNode("image_width").real()), int(storage.getNode("image_height").real()))
            same = [c for c in ours["cameras"] if np.array_equal(c["camera_matrix"], k)]
            assert (same[0]["width"], same[0]["height"]) == size
            padded = np.zeros(14)
            padded[: d.size] = d.ravel()
            expected = np.zeros(14)
            expected[: len(same[0]["distortion"])] = same[0]["distortion"]
            np.testing.assert_array_equal(padded, expected)
    pair = next(p for p in ours["pairs"] if (p["from"], p["to"]) == (ours["stereo"]["left"], ours["stereo"]["right"]))
    transform = np.array(pair["to_from_from_cm"])
    np.testing.assert_allclose(stereo["R"], transform[:3, :3], atol=1e-12)
    np.testing.assert_allclose(stereo["T"].ravel() * CM_PER_M, transform[:3, 3], atol=1e-12)
    np.testing.assert_allclose(stereo["R1"], ours["stereo"]["rectified_from_left"], atol=1e-12)
    if "fisheye" not in file.stem:
        size = tuple(int(loaded["stereo"].getNode(n).real()) for n in ("image_width", "image_height"))
        answers = cv2.stereoRectify(*(stereo[n] for n in names[:4]), size, stereo["R"], stereo["T"])
        for name, expected in zip(("R1", "R2"), answers, strict=False):
            np.testing.assert_allclose(stereo[name], expected, atol=1e-8, err_msg=name)
        # The rectified principal point is free, and OpenCV 4 and 5 choose it differently: by the image's outer corners,
        # or by its corner pixels. What the choice has to fulfil comes below.
        for name, expected in zip(("P1", "P2"), answers[2:4], strict=True):
            for entry in ((0, 0), (1, 1), (0, 3)):
                assert stereo[name][entry] == pytest.approx(expected[entry], rel=1e-7), name
    # A point that both cameras see fulfils x2' F x1 = 0, and rectified it lies in one row.
    point = np.array([[0.1, -0.05, 1.5], [-0.3, 0.2, 2.5]])
    in_right = point @ stereo["R"].T + stereo["T"].ravel()
    for a, b in zip(point, in_right, strict=True):
        x1, x2 = stereo["M1"] @ a / a[2], stereo["M2"] @ b / b[2]
        assert abs(x2 @ stereo["F"] @ x1) < 1e-6
        left = stereo["P1"] @ np.append(stereo["R1"] @ a, 1)
        right = stereo["P2"] @ np.append(stereo["R1"] @ a, 1)
        assert left[1] / left[2] == pytest.approx(right[1] / right[2], abs=1e-9)
        disparity = left[0] / left[2] - right[0] / right[2]
        back = stereo["Q"] @ [left[0] / left[2], left[1] / left[2], disparity, 1]
        assert back[2] / back[3] == pytest.approx((stereo["R1"] @ a)[2], rel=1e-9)


def test_ros_export(program: Path, file: Path, ours: dict, tmp_path: Path) -> None:
    out = tmp_path / "ros"
    said = run_with_findings(program, "export", file, "--to", "ros", "-o", out, "--force")
    cameras = named(ours)
    infos = {path.stem: yaml.safe_load(path.read_text()) for path in out.glob("*.yaml")}
    assert len(infos) == len(ours["cameras"])
    assert {"left", "right"} < set(infos)
    lengths = {"plumb_bob": 5, "rational_polynomial": 8, "equidistant": 4}
    for name, info in infos.items():
        assert info["camera_name"] == name
        for key in ("camera_matrix", "distortion_coefficients", "rectification_matrix", "projection_matrix"):
            matrix = info[key]
            assert len(matrix["data"]) == matrix["rows"] * matrix["cols"]
            assert all(isinstance(x, float) for x in matrix["data"]), key
        assert info["distortion_coefficients"]["cols"] == lengths[info["distortion_model"]]
        k = np.reshape(info["camera_matrix"]["data"], (3, 3))
        camera = cameras[name]
        assert (info["image_width"], info["image_height"]) == (camera["width"], camera["height"])
        kept = info["distortion_coefficients"]["data"]
        full = [*camera["distortion"], *([0.0] * 14)]
        if any(full[8:14]) and camera["model"] != "Fisheye":
            assert_residual(k, kept, False, camera, residual_of(said, file, camera))
        else:
            np.testing.assert_array_equal(k, camera["camera_matrix"])
            np.testing.assert_array_equal(kept, full[: len(kept)])
    left, right = (np.reshape(infos[n]["projection_matrix"]["data"], (3, 4)) for n in ("left", "right"))
    pair = next(p for p in ours["pairs"] if (p["from"], p["to"]) == (ours["stereo"]["left"], ours["stereo"]["right"]))
    assert right[0, 3] == pytest.approx(-right[0, 0] * pair["baseline_cm"] / CM_PER_M, rel=1e-6)
    assert left[0, 3] == 0


def test_kalibr_export(program: Path, file: Path, ours: dict, tmp_path: Path) -> None:
    out = tmp_path / "kalibr"
    said = run_with_findings(program, "export", file, "--to", "kalibr", "-o", out, "--force")
    cameras = named(ours)
    chain = yaml.safe_load((out / "camchain.yaml").read_text())
    assert list(chain) == [f"cam{i}" for i in range(len(ours["cameras"]))]
    assert [chain["cam0"]["rostopic"], chain["cam1"]["rostopic"]] == ["/left/image_raw", "/right/image_raw"]
    pair = next(p for p in ours["pairs"] if (p["from"], p["to"]) == (ours["stereo"]["left"], ours["stereo"]["right"]))
    found = np.array(chain["cam1"]["T_cn_cnm1"])
    found[:3, 3] *= CM_PER_M
    np.testing.assert_allclose(found, pair["to_from_from_cm"], atol=1e-12)
    for camera in chain.values():
        fx, fy, cx, cy = camera["intrinsics"]
        k = np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1]])
        source = cameras[camera["rostopic"].split("/")[1]]
        assert camera["resolution"] == [source["width"], source["height"]]
        coefficients, model = camera["distortion_coeffs"], camera["distortion_model"]
        assert model in ("radtan", "equidistant") and len(coefficients) == 4
        assert_residual(k, coefficients, model == "equidistant", source, residual_of(said, file, source))


@pytest.mark.parametrize("to", ["ros", "opencv", "kalibr"])
def test_import(program: Path, file: Path, ours: dict, to: str, tmp_path: Path) -> None:
    """DepthAI reads what the program imports from its own exports."""
    run(program, "export", file, "--to", to, "-o", tmp_path / "files", "--force")
    inputs = sorted(path for path in (tmp_path / "files").iterdir() if path.name != "imu.yaml")
    out = tmp_path / "imported.json"
    run(program, "import", *inputs, "-o", out, "--force")
    theirs = dai.CalibrationHandler(str(out))
    sockets = {camera["socket"] for camera in ours["cameras"]}
    left, right = ours["stereo"]["left"], ours["stereo"]["right"]
    if (left, right) == ("CAM_B", "CAM_C"):
        assert {s.name for s in theirs.getEepromData().cameraData} == sockets
        pair = next(p for p in ours["pairs"] if (p["from"], p["to"]) == (left, right))
        found = theirs.getCameraExtrinsics(socket(left), socket(right))
        assert_transform(pair["to_from_from_cm"], found, to)
        assert_transform(ours["stereo"]["rectified_from_left"], theirs.getStereoLeftRectificationRotation(), "R1")
    if to == "opencv":
        for name, camera in named(ours).items():
            where = socket({"left": "CAM_B", "right": "CAM_C"}.get(name, camera["socket"]))
            intrinsics = theirs.getCameraIntrinsics(where, camera["width"], camera["height"])
            np.testing.assert_allclose(camera["camera_matrix"], intrinsics, rtol=1e-6)
            assert camera["model"] == theirs.getDistortionModel(where).name
            found = theirs.getDistortionCoefficients(where)[: len(camera["distortion"])]
            np.testing.assert_allclose(camera["distortion"], found, rtol=1e-6)
