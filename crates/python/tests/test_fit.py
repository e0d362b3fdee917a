"""The curve fit of `oaktwin fit`, compared with SciPy's least squares, including robust weights and intervals."""

import json
import os
from pathlib import Path

import numpy as np
import pytest

optimize = pytest.importorskip("scipy.optimize")
stats = pytest.importorskip("scipy.stats")

BASELINE_M = 0.075
HUBER = 1.345


def model(parameters, distance, nominal):
    """The error of depth, as a share of it."""
    bias, locking = parameters[:2]
    focal = nominal * (parameters[2] if len(parameters) == 3 else 1.0)
    disparity = focal * BASELINE_M / distance
    measured = disparity + bias - locking * np.sin(2 * np.pi * (disparity + bias))
    return disparity / measured - 1


def fitted(distance, percent, start, nominal):
    """Robust parameters and the half widths of their intervals of 95 %."""
    is_absolute = (percent >= 0).all()

    def deviations(parameters):
        error = model(parameters, distance, nominal)
        error = np.abs(error) if is_absolute else error
        return nominal * BASELINE_M / distance * (error - percent / 100)

    at = np.array(start)
    for _ in range(100):
        scale = 1.4826 * np.sort(np.abs(deviations(at)))[len(distance) // 2]
        found = optimize.least_squares(deviations, at, loss="huber", f_scale=HUBER * scale, xtol=1e-14, ftol=1e-14, gtol=1e-14)
        if np.allclose(found.x, at, rtol=0, atol=1e-10):
            break
        at = found.x
    # The weights that Huber's loss gives to the points, and the plain derivatives.
    off = deviations(at)
    weights = np.minimum(1, HUBER * scale / np.maximum(np.abs(off), 1e-300))
    steps = 1e-6 * np.eye(len(at))
    slopes = np.stack([(deviations(at + s) - deviations(at - s)) / 2e-6 for s in steps], axis=1)
    freedom = len(distance) - len(at)
    variance = (weights * off**2).sum() / freedom
    covariance = variance * np.linalg.inv(slopes.T @ (weights[:, None] * slopes))
    return at, stats.t.ppf(0.975, freedom) * np.sqrt(np.diag(covariance))


def compare(program, file, start, nominal, *options):
    table = np.loadtxt(file, delimiter=",", skiprows=1)
    report = json.loads(program("fit", file, "--model", "oak-d-pro-poe", "--json", "--focal-px", nominal, *options))
    used = np.array([point["is_used"] for point in report["points"]])
    parameters, half = fitted(*table[used].T, start, nominal)
    scales = [1, 1, nominal]
    names = ["bias", "pixelLocking", "focalLength"]
    for name, value, width, scale in zip(names, parameters, half, scales, strict=False):
        (ours,) = [one for one in report["parameters"] if one["name"] == name]
        assert ours["value"] == pytest.approx(value * scale, abs=0.01 * width * scale), name
        low, high = ours["confidence_interval_95"]
        assert (high - low) / 2 == pytest.approx(width * scale, rel=0.02), name
    return report


def curve(path, percent, distance):
    rows = "\n".join(f"{z:.3f},{e:.6f}" for z, e in zip(distance, percent, strict=True))
    path.write_text(f"distance_m,depth_error_percent\n{rows}\n")
    return path


@pytest.mark.parametrize("is_free", [False, True])
@pytest.mark.parametrize("bias", [-0.2, 0.15])
def test_a_signed_curve_with_outliers(program, tmp_path, bias, is_free):
    random = np.random.default_rng(7)
    distance = np.round(np.arange(1.5, 9, 0.13), 3)
    truth = (bias, 0.12, 1.006 if is_free else 1.0)
    percent = 100 * model(truth, distance, 800.0)
    percent += 100 * distance / 60 * random.normal(0, 0.01, len(distance))
    percent[[3, 20, 41]] += [3, -4, 5]
    file = curve(tmp_path / "curve.csv", percent, distance)
    options = ["--fit", "focal"] if is_free else []
    report = compare(program, file, truth if is_free else truth[:2], 800.0, *options)
    # SciPy starts at the truth, the program elsewhere.
    for name, value in zip(["bias", "pixelLocking"], truth, strict=False):
        (ours,) = [one for one in report["parameters"] if one["name"] == name]
        assert ours["value"] == pytest.approx(value, abs=0.01), name


@pytest.mark.parametrize(
    ("name", "start", "nominal", "options"),
    [
        ("800p", (-0.21, 0.13, 794 / 805), 805.0, ["--from", "2.5"]),
        ("480p", (0.0, 0.2, 454 / 450), 450.0, ["--stereo-width", "640"]),
    ],
)
def test_the_vendors_curves(program, name, start, nominal, options):
    data = os.environ.get("OAKTWIN_TEST_DATA")
    if not data:
        pytest.skip("OAKTWIN_TEST_DATA is not set")
    file = Path(data) / f"data/accuracy/depth_error_{name}_75mm_measured.csv"
    compare(program, file, start, nominal, "--fit", "focal", *options)
