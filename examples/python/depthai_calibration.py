"""One calibration file, read by DepthAI's own library and by oaktwin: all numbers side by side.

    pip install depthai
    python examples/python/depthai_calibration.py calibration.json [--model OAK-D-Pro-PoE] [-o rows.json]

The file is written by `CalibrationHandler.eepromToJsonFile`; no camera is required. Each row ends with the maximum difference
of its numbers in oaktwin's units: px, metres, degrees. DepthAI computes in single precision, oaktwin in double, so about
seven digits agree. A row marked * is a convention in which the two differ intentionally.
"""

import argparse
import json
from pathlib import Path

import depthai as dai
import numpy as np

import oaktwin

EXAMPLE = Path(__file__).resolve().parents[2] / "crates/calibration/fixtures/example-oak-d-pro-poe.json"
SOCKETS = {"rgb": "CAM_A", "tof": "CAM_A", "left": "CAM_B", "right": "CAM_C"}
SIZES = [(1280, 800), (1280, 720), (640, 400), (640, 480)]
CM_PER_M = 100.0


def socket(role):
    return getattr(dai.CameraBoardSocket, SOCKETS[role])


def row(what, unit, theirs, ours, note=""):
    """One row. DepthAI's lengths are shown in centimetres; the difference is in oaktwin's unit."""
    theirs, ours = np.ravel(theirs).astype(float), np.ravel(ours).astype(float)
    scale = 1 / CM_PER_M if unit == "m" else 1.0
    return {
        "what": what,
        "unit": unit,
        "depthai_unit": "cm" if unit == "m" else unit,
        "depthai": theirs.tolist(),
        "oaktwin": ours.tolist(),
        "difference": float(np.abs(theirs * scale - ours).max(initial=0.0)),
        "convention": note,
    }


def camera_rows(handler, device, role):
    """Intrinsics at several resolutions, distortion, field of view."""
    camera, where = device.cameras[role], socket(role)
    stored = (handler.getSourceWidth(where), handler.getSourceHeight(where))
    for size in dict.fromkeys([camera.size, *SIZES]):
        # DepthAI extends a wide calibration image by the additional rows of a 4:3 image, but not vice versa.
        if size[0] / size[1] <= 1.34 and not 1.5 < stored[0] / stored[1] <= 1.778:
            continue
        theirs = np.array(handler.getCameraIntrinsics(where, *size))
        ours = camera.resized(*size, rule="depthai").K
        pick = lambda k: [k[0, 0], k[1, 1], k[0, 2], k[1, 2]]  # noqa: E731
        yield row(f"{role} fx fy cx cy, {size[0]}x{size[1]}", "px", pick(theirs), pick(ours))
    # DepthAI returns as many coefficients as the file, oaktwin as many as the lens model; missing ones are 0.
    both = np.zeros((2, 14))
    for coefficients, found in zip(both, [handler.getDistortionCoefficients(where), camera.distortion]):
        coefficients[: len(found)] = found
    yield row(f"{role} distortion, {camera.lens}", "", *both)
    # getFov() ignores the lens; hfov_deg of a fisheye camera is its lens's.
    field = np.degrees(2 * np.arctan(camera.size[0] / 2 / camera.K[0, 0]))
    yield row(f"{role} field of view", "deg", handler.getFov(where, useSpec=False), field)
    note = "getFov() gives the data sheet's; oaktwin's follows from the calibrated fx"
    yield row(f"{role} field of view, by default", "deg", handler.getFov(where), field, note)


def pair_rows(handler, device, source, target):
    """Extrinsics: both transform points from the first camera to the second; DepthAI's are in centimetres."""
    try:
        theirs = np.array(handler.getCameraExtrinsics(socket(source), socket(target)))
    except RuntimeError:
        return  # The file has no such extrinsics; oaktwin uses the nominal pose and reports it in its findings.
    ours = device.extrinsics(source, target)
    yield row(f"{target}_from_{source} rotation", "", theirs[:3, :3], ours[:3, :3])
    yield row(f"{target}_from_{source} translation", "m", theirs[:3, 3], ours[:3, 3])


def stereo_rows(handler, device):
    """Baseline and rectification rotations."""
    rectified = device.rectification()
    calibrated = handler.getBaselineDistance(socket("right"), socket("left"), useSpecTranslation=False)
    yield row("baseline", "m", calibrated, rectified.baseline)
    note = "getBaselineDistance() gives the board's nominal one; oaktwin's is the calibrated one"
    yield row("baseline, by default", "m", handler.getBaselineDistance(), rectified.baseline, note)
    yield row("R1, rectified_from_left", "", handler.getStereoLeftRectificationRotation(), rectified.R1)
    yield row("R2, rectified_from_right", "", handler.getStereoRightRectificationRotation(), rectified.R2)


def imu_rows(handler, device, role):
    try:
        theirs = np.array(handler.getImuToCameraExtrinsics(socket(role)))
    except RuntimeError:
        return  # Many files have no extrinsics of the IMU.
    ours = device.extrinsics("imu", role)
    yield row(f"{role}_from_imu rotation", "", theirs[:3, :3], ours[:3, :3])
    yield row(f"{role}_from_imu translation", "m", theirs[:3, 3], ours[:3, 3])


def compare(path, model=None):
    """All rows, and oaktwin's findings about the file."""
    device = oaktwin.Device.from_calibration(path, model, force=True)
    handler = dai.CalibrationHandler(str(path))
    roles = [role for role in device.cameras if socket(role) in handler.getEepromData().cameraData]
    rows = [found for role in roles for found in camera_rows(handler, device, role)]
    sources = [("left", "right"), *((role, "left") for role in roles if role not in ("left", "right"))]
    for source, target in sources:
        rows += pair_rows(handler, device, source, target)
    rows += stereo_rows(handler, device)
    rows += imu_rows(handler, device, "left")
    return device, rows


def shown(values, unit):
    """The first few numbers."""
    numbers = " ".join(f"{value:.5g}" for value in values[:4])
    more = " ..." if len(values) > 4 else ""
    return f"{numbers}{more} {unit}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("calibration", nargs="?", type=Path, default=EXAMPLE)
    parser.add_argument("--model", help="the model of the unit, if the file does not contain it")
    parser.add_argument("-o", "--output", type=Path, help="write the rows as JSON")
    arguments = parser.parse_args()

    try:
        device, rows = compare(arguments.calibration, arguments.model)
    except (RuntimeError, oaktwin.Error) as error:  # DepthAI's and oaktwin's errors for invalid files
        raise SystemExit(f"{arguments.calibration.name}: {error}") from error
    print(f"{device.name}, {arguments.calibration.name}: DepthAI {dai.__version__} and oaktwin {oaktwin.__version__}")
    print(f"  {'':32}{'DepthAI':47}{'oaktwin':47}largest difference")
    for found in rows:
        mark = "*" if found["convention"] else " "
        theirs = shown(found["depthai"], found["depthai_unit"])
        ours = shown(found["oaktwin"], found["unit"])
        print(f"{mark} {found['what']:32}{theirs:47}{ours:47}{found['difference']:.1e} {found['unit']}".rstrip())
    for note in dict.fromkeys(found["convention"] for found in rows if found["convention"]):
        print(f"* {note}")
    agreeing = [found for found in rows if not found["convention"]]
    for unit in ("px", "m", "deg", ""):
        largest = max(found["difference"] for found in agreeing if found["unit"] == unit)
        print(f"largest difference, {unit or 'rotations and coefficients'}: {largest:.1e}")
    for finding in device.findings:
        print(f"{finding.level}: {finding.place}: {finding.message}")
    if arguments.output:
        arguments.output.write_text(json.dumps(rows, indent=1))


if __name__ == "__main__":
    main()
