"""Units of a population: DepthAI reads their calibrations, and their spread matches real calibrations."""

import csv
import json
import math
import os
import subprocess
from pathlib import Path

import depthai as dai
import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[2]
SPREADS = ROOT / "crates" / "calibration" / "data" / "spreads.toml"
SOCKETS = {"CAM_A": dai.CameraBoardSocket.CAM_A, "CAM_B": dai.CameraBoardSocket.CAM_B, "CAM_C": dai.CameraBoardSocket.CAM_C}
# The calibrations that the spread is computed from, and the models of the units.
UNITS = {
    "oak-d-pro-af_v7_depthai-ros-cal.json": "OAK-D Pro AF",
    "oak-d-pro-af_v7_18443010F116631200_old-factory-4k.json": "OAK-D Pro AF",
    "oak-d_bw1098obc_v5.json": "OAK-D",
    "oak-d_bw1098obc_v6.json": "OAK-D",
}
COLOR, LEFT, RIGHT = 0, 1, 2


def written_spread() -> dict[str, list[float]]:
    """The numbers of the file; Python 3.10 has no TOML reader."""
    numbers = {}
    for line in SPREADS.read_text().splitlines():
        name, _, value = line.partition(" = ")
        if value and not value.startswith('"'):
            numbers[name] = np.atleast_1d(json.loads(value)).tolist()
    return numbers


def low_order(matrix: list, size: tuple[int, int], coefficients: list[float]) -> np.ndarray:
    """k1, k2, p1 and p2 that best reproduce the distortion over the image."""
    (fx, _, cx), (_, fy, cy), _ = matrix
    u, v = np.meshgrid(np.linspace(0, size[0] - 1, 33), np.linspace(0, size[1] - 1, 21))
    x, y = (u.ravel() - cx) / fx, (v.ravel() - cy) / fy
    k1, k2, p1, p2, k3, k4, k5, k6 = coefficients[:8]
    r = x * x + y * y
    radial = (1 + r * (k1 + r * (k2 + r * k3))) / (1 + r * (k4 + r * (k5 + r * k6)))
    shift = [
        x * (radial - 1) + 2 * p1 * x * y + p2 * (r + 2 * x * x),
        y * (radial - 1) + p1 * (r + 2 * y * y) + 2 * p2 * x * y,
    ]
    columns = [
        np.stack([x * r, x * r * r, 2 * x * y, r + 2 * x * x], 1),
        np.stack([y * r, y * r * r, r + 2 * y * y, 2 * x * y], 1),
    ]
    return np.linalg.lstsq(np.concatenate(columns), np.concatenate(shift), rcond=None)[0]


def camera(data: dict) -> dict:
    matrix, size = data["intrinsicMatrix"], (data["width"], data["height"])
    found = {
        "f": math.log(matrix[0][0] / size[0]),
        "c": [(matrix[0][2] - (size[0] - 1) / 2) / size[0], (matrix[1][2] - (size[1] - 1) / 2) / size[0]],
        "brown": low_order(matrix, size, data["distortionCoeff"]),
    }
    links = data["extrinsics"]
    if links["toCameraSocket"] >= 0:
        r = np.array(links["rotationMatrix"])
        found["rotation"] = 500 * np.array([r[2, 1] - r[1, 2], r[0, 2] - r[2, 0], r[1, 0] - r[0, 1]])
        found["translation"] = [links["translation"][axis] * 10 for axis in "xyz"]
    return found


def deviation(units: list[tuple[str, dict]], value) -> np.ndarray:
    """The standard deviation within the models, pooled over them."""
    squares, degrees = 0.0, 0
    for model in {model for model, _ in units}:
        of_model = np.array([value(unit) for name, unit in units if name == model])
        squares = squares + ((of_model - of_model.mean(0)) ** 2).sum(0)
        degrees += len(of_model) - 1
    return np.sqrt(squares / degrees)


def test_the_spread_is_that_of_the_calibrations() -> None:
    data = os.environ.get("OAKTWIN_TEST_DATA")
    if not data:
        pytest.skip("OAKTWIN_TEST_DATA names no test data")
    units = []
    for name, model in UNITS.items():
        text = json.loads((Path(data) / "data" / "calibration" / name).read_text())
        units.append((model, {socket: camera(own) for socket, own in text["cameraData"]}))

    def both(key: str) -> np.ndarray:
        of = [deviation(units, lambda unit, socket=socket: unit[socket][key]) for socket in (LEFT, RIGHT)]
        return np.sqrt(np.mean(np.square(of), axis=0))

    brown = both("brown")
    between = [(unit[LEFT]["f"] - unit[RIGHT]["f"]) ** 2 for _, unit in units]
    computed = {
        "units": [len(units)],
        "models": [len({model for model, _ in units})],
        "focal_length_pair": [deviation(units, lambda unit: (unit[LEFT]["f"] + unit[RIGHT]["f"]) / 2)],
        "focal_length": [math.sqrt(np.mean(between) / 2)],
        "focal_length_color": [deviation(units, lambda unit: unit[COLOR]["f"])],
        "principal_point": both("c"),
        "k1": [brown[0]],
        "p": [math.sqrt((brown[2] ** 2 + brown[3] ** 2) / 2)],
        "rotation_mrad": both("rotation") / math.sqrt(2),
        "position_mm": both("translation") / math.sqrt(2),
    }
    written = written_spread()
    assert written.keys() == computed.keys()
    for name, numbers in computed.items():
        # The file has two digits.
        np.testing.assert_allclose(written[name], numbers, rtol=0.035, err_msg=name)


@pytest.mark.parametrize("model", ["OAK-D Pro PoE", "OAK-D Pro W PoE", "OAK4-D", "OAK-D Lite", "OAK-D SR"])
def test_depthai_reads_units(program: Path, tmp_path: Path, model: str) -> None:
    command = [program, "population", model, "-n", "5", "--seed", "3", "-o", tmp_path]
    subprocess.run(command, check=True, capture_output=True)
    rows = list(csv.DictReader((tmp_path / "units.csv").open()))
    assert len(rows) == 5
    for row in rows:
        handler = dai.CalibrationHandler(str(tmp_path / row["file"]))
        for side, socket in [("left", "CAM_B"), ("right", "CAM_C")]:
            matrix, *_ = handler.getDefaultIntrinsics(SOCKETS[socket])
            assert matrix[0][0] == pytest.approx(float(row[f"{side}_focal_length_px"]), rel=1e-6)
        left, right = SOCKETS["CAM_B"], SOCKETS["CAM_C"]
        assert handler.getBaselineDistance(right, left, False) * 10 == pytest.approx(float(row["baseline_mm"]), rel=1e-5)
        designed = handler.getBaselineDistance(right, left, True) * 10
        assert designed == pytest.approx(20 if model == "OAK-D SR" else 75, rel=1e-5)
        # The rotation from the right camera's frame to the left one's turns its optical axis by the yaw.
        rotation = np.array(handler.getCameraExtrinsics(right, left))[:3, :3]
        np.testing.assert_allclose(rotation @ rotation.T, np.eye(3), atol=1e-6)
        angles = 500 * np.array(
            [rotation[2, 1] - rotation[1, 2], rotation[0, 2] - rotation[2, 0], rotation[1, 0] - rotation[0, 1]]
        )
        expected = [float(row[f"{name}_mrad"]) for name in ("pitch", "yaw", "roll")]
        np.testing.assert_allclose(angles, expected, atol=0.02)
