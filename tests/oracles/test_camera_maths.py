"""Our camera maths against OpenCV and OpenUSD.

Asks the program `camera-eval` (crate oaktwin-testkit), whose path is in OAKTWIN_CAMERA_EVAL. Tolerances are 1e-6 px and
1e-9 rad; where an oracle itself computes in float32, the test says so and allows float32's rounding.
"""

import json
import os
import subprocess
from pathlib import Path

import numpy as np
import pytest

cv2 = pytest.importorskip("cv2")

EVAL = os.environ.get("OAKTWIN_CAMERA_EVAL")
DATA = os.environ.get("OAKTWIN_TEST_DATA")
PX, RAD = 1e-6, 1e-9
SIZE = (1280, 800)

pytestmark = pytest.mark.skipif(
    not EVAL, reason="OAKTWIN_CAMERA_EVAL is not set: build crate oaktwin-testkit and give the path of camera-eval"
)


@pytest.fixture(scope="module")
def ask():
    """A running camera-eval: a request in, its answer out."""
    process = subprocess.Popen([EVAL], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    def request(op, **fields):
        process.stdin.write(json.dumps({"op": op, **fields}) + "\n")
        process.stdin.flush()
        answer = json.loads(process.stdout.readline())
        assert not (isinstance(answer, dict) and "error" in answer), answer
        return answer

    yield request
    process.stdin.close()
    assert process.wait() == 0


def matrix(fx, fy, cx, cy):
    return np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1.0]])


def camera(k, coefficients, model="opencv_pinhole", size=SIZE):
    lens = {"model": model, "coefficients": [float(c) for c in coefficients]}
    return {"intrinsics": {"size": list(size), "k": np.asarray(k, float).tolist()}, "lens": lens}


def pairs(answer, width):
    """A list with nulls as an array with NaNs."""
    return np.array([[np.nan] * width if row is None else row for row in answer], float)


def factory_like(rng, count):
    """K and 14 coefficients as factory fits leave them: the numerator of the rational term is the denominator times a
    gentle radial term, so that coefficients of up to some hundreds nearly cancel."""
    for _ in range(count):
        k4 = rng.uniform(-12, 26)
        k5 = k4 * k4 * rng.uniform(0.3, 1.3) if k4 < 0 else rng.uniform(0, 40)
        k6 = rng.uniform(0, 400)
        g1, g2 = rng.uniform(-0.12, 0.12), rng.uniform(-0.05, 0.05)
        k1, k2, k3 = k4 + g1, k5 + k4 * g1 + g2, k6 + k5 * g1 + k4 * g2
        p, s, tau = rng.uniform(-2e-3, 2e-3, 2), rng.uniform(-2e-3, 2e-3, 4), rng.uniform(-0.03, 0.03, 2)
        k = matrix(*(rng.uniform(770, 860) * np.array([1, rng.uniform(0.998, 1.002)])), *rng.uniform(-20, 20, 2) + (640, 400))
        yield k, np.array([k1, k2, *p, k3, k4, k5, k6, *s, *tau])


def brown(rng, count):
    """K and 4, 5, 8, 12 or 14 plain coefficients."""
    for i in range(count):
        c = np.concatenate([
            rng.uniform(-0.15, 0.15, 2), rng.uniform(-2e-3, 2e-3, 2), rng.uniform(-0.02, 0.02, 1),
            rng.uniform(-0.02, 0.02, 3), rng.uniform(-2e-3, 2e-3, 4), rng.uniform(-0.05, 0.05, 2),
        ])[: (4, 5, 8, 12, 14)[i % 5]]
        yield matrix(*rng.uniform(560, 860, 2), *rng.uniform(-30, 30, 2) + (640, 400)), c


def exports():
    """(name, model, size, K, coefficients) of real calibrations, through DepthAI's own library."""
    if not DATA:
        return
    golden = json.loads((Path(DATA) / "data/depthai-golden/calibration_handler.json").read_text())
    for file, content in sorted(golden["files"].items()):
        for socket, c in content.get("cams", {}).items():
            yield f"{file}:{socket}", c["model"], (c["w"], c["h"]), np.array(c["K"]), np.array(c["dist"])


def perspective_cases():
    yield from ((*case, SIZE) for case in brown(np.random.default_rng(1), 60))
    yield from ((*case, SIZE) for case in factory_like(np.random.default_rng(2), 60))
    for _, model, size, k, coefficients in exports():
        if model == "Perspective":
            yield k, coefficients, size


def folds(coefficients, normalized):
    """Whether the radial term of OpenCV's model stops growing before these points: by sampling, not by our algebra."""
    c = np.zeros(14)
    c[: len(coefficients)] = coefficients
    at = np.linalg.norm(normalized, axis=-1)
    r = np.linspace(0, min(at.max(initial=0), 20), 50_001)
    u = r * r
    denominator = 1 + u * (c[5] + u * (c[6] + u * c[7]))
    radius = r * (1 + u * (c[0] + u * (c[1] + u * c[4]))) / denominator
    folded = (np.diff(radius) <= 0) | (denominator[1:] <= 0)
    return at > (r[1:][folded][0] if folded.any() else np.inf)


def poles(coefficients):
    """The radii on the plane z = 1 at which the radial factor of OpenCV's model has a pole."""
    c = np.zeros(14)
    c[: len(coefficients)] = coefficients
    roots = np.roots([c[7], c[6], c[5], 1])
    return np.sqrt([root.real for root in roots if root.real > 0 and abs(root.imag) < 1e-9 * abs(root)])


def beside_a_pole(coefficients, normalized):
    """Whether points are so close to a pole that the model may have no solution there."""
    r = np.linalg.norm(normalized, axis=-1)
    return (np.abs(r[:, None] - poles(coefficients)) < 0.1).any(axis=1)


def test_project_as_opencv(ask):
    rng, compared = np.random.default_rng(3), 0
    for k, c, (w, h) in perspective_cases():
        pixels = rng.uniform([-0.1 * w, -0.1 * h], [1.1 * w, 1.1 * h], (40, 2))
        flat = (pixels - k[:2, 2]) / k[[0, 1], [0, 1]]
        points = np.column_stack([flat, np.ones(40)]) * rng.uniform(0.2, 10, (40, 1))
        expected, _ = cv2.projectPoints(points, np.zeros(3), np.zeros(3), k, c)
        got = pairs(ask("project", camera=camera(k, c, size=(w, h)), points=points.tolist()), 2)
        seen = ~np.isnan(got[:, 0])
        np.testing.assert_allclose(got[seen], expected[:, 0][seen], rtol=0, atol=PX)
        # What we refuse has folded; near a fold the tangential terms decide, which the sampling does not know.
        folded = folds(c, points[:, :2] / points[:, 2:])
        if len(poles(c)):
            continue  # the next test but one compares these cameras
        assert not (folded & seen).any()
        assert (~seen & ~folded).sum() <= 1, (c, points[~seen & ~folded])
        compared += seen.sum()
    assert compared > 4000


def test_undistort_as_opencv(ask):
    """cv2.undistortPointsIter is a fixed-point iteration that need not converge: it is asked for 2000 steps, and compared
    where cv2.projectPoints takes its answer back to the pixel within 1e-9 px and the model has not folded on the way. Our
    own answers are all held against cv2.projectPoints."""
    rng, compared, answered, total = np.random.default_rng(4), 0, 0, 0
    criteria = (cv2.TERM_CRITERIA_COUNT | cv2.TERM_CRITERIA_EPS, 2000, 1e-13)
    for k, c, (w, h) in perspective_cases():
        pixels = rng.uniform([0, 0], [w, h], (40, 2))
        got = pairs(ask("undistort", camera=camera(k, c, size=(w, h)), pixels=pixels.tolist()), 2)
        theirs = cv2.undistortPointsIter(pixels[:, None], k, c, np.eye(3), np.eye(3), criteria)[:, 0]

        def back(flat):
            return cv2.projectPoints(np.column_stack([flat, np.ones(40)]), np.zeros(3), np.zeros(3), k, c)[0][:, 0]

        known = ~np.isnan(got[:, 0])
        ours_back = back(np.nan_to_num(got))
        exact = known & ~beside_a_pole(c, got)
        np.testing.assert_allclose(ours_back[exact], pixels[exact], rtol=0, atol=PX)
        converged = np.abs(back(theirs) - pixels).max(axis=1) < 1e-9
        converged &= ~folds(c, np.nan_to_num(theirs, posinf=0, neginf=0))
        # Where OpenCV finds the ray on this side of the fold, so do we, and it is the same one.
        np.testing.assert_allclose(got[converged], theirs[converged], rtol=0, atol=RAD)
        compared, answered, total = compared + converged.sum(), answered + known.sum(), total + 40
    print(f"{compared} of {total} points compared, {answered} have an inverse")
    assert compared > 3500 and answered > 0.9 * total


def pole_beside(zero, pole, k1=-0.05, k2=0.01):
    """Coefficients whose radial factor is 1 + k1 u + k2 u², times (1 − u/zero²) / (1 − u/pole²)."""
    k3, k2, k1, _ = np.polymul([-1 / zero**2, 1], [k2, k1, 1])
    return np.array([k1, k2, 1e-4, -2e-4, k3, -1 / pole**2, 0, 0])


def cameras_with_poles():
    k = matrix(800, 801, 640.3, 399.2)
    for zero, pole in [(0.80003, 0.8), (0.7, 0.7005), (0.6, 0.6), (0.50001, 0.5)]:
        yield f"zero {zero}, pole {pole}", k, pole_beside(zero, pole), SIZE
    # The pole is exactly on the pixel (1280, 400).
    yield "pole on a pixel", matrix(800, 800, 640, 400), pole_beside(0.80001, 0.8, 0, 1e-9), SIZE
    first, second = pole_beside(0.5002, 0.5), pole_beside(0.70003, 0.7, 0, 1e-12)
    numerator = np.polymul([first[4], first[1], first[0], 1], [-1 / 0.70003**2, 1])[1:]  # its u⁴ is below 0.05
    yield "two poles", k, np.array([*numerator[[2, 1]], 0, 0, numerator[0], first[5] + second[5], first[5] * second[5], 0]), SIZE
    files = sorted(Path(DATA).glob("data/calibration/**/*.json")) if DATA else []
    for file in files:
        for socket, camera in json.loads(file.read_text())["cameraData"]:
            k, size = np.array(camera["intrinsicMatrix"]), (camera["width"], camera["height"])
            if camera.get("cameraType", 0) == 0 and k.size == 9 and k[0, 0] > 0 and min(size) > 0:
                yield f"{file.name}: {socket}", k, np.array(camera["distortionCoeff"]), size


def test_rays_of_whole_images_as_opencv(ask):
    """Pixels of all of the image, of lenses with a pole inside the image and of every real camera. Where OpenCV's iteration
    converges to a ray that projects onto the pixel again, that ray is ours."""
    criteria = (cv2.TERM_CRITERIA_COUNT | cv2.TERM_CRITERIA_EPS, 500, 1e-13)
    compared, past_a_pole = 0, 0
    for name, k, c, (w, h) in cameras_with_poles():
        pixels = np.stack(np.meshgrid(np.linspace(0, w - 1, 97), np.linspace(0, h - 1, 61)), -1).reshape(-1, 2)
        theirs = cv2.undistortPointsIter(pixels[:, None], k, c, np.eye(3), np.eye(3), criteria)[:, 0]
        points = np.nan_to_num(np.column_stack([theirs, np.ones(len(theirs))]))
        back = cv2.projectPoints(points, np.zeros(3), np.zeros(3), k, c)[0][:, 0]
        converged = np.abs(back - pixels).max(axis=1) < PX
        beyond = (np.linalg.norm(theirs, axis=1)[:, None] > poles(c)).any(axis=1)
        converged &= beyond | ~folds(c, theirs)
        got = pairs(ask("undistort", camera=camera(k, c, size=(w, h)), pixels=pixels.tolist()), 2)
        off = np.abs(got - theirs).max(axis=1) * max(k[0, 0], k[1, 1])
        wrong = converged & ~(off < PX)
        if wrong.any():  # near a fold, a small residual is a large angle
            flat = np.column_stack([got[wrong], np.ones(wrong.sum())])
            again = cv2.projectPoints(flat, np.zeros(3), np.zeros(3), k, c)[0][:, 0]
            wrong[wrong] = ~((np.abs(again - pixels[wrong]).max(axis=1) < PX) & (off[wrong] < 1e3 * PX))
        assert not wrong.any(), (name, wrong.mean(), pixels[wrong][:3], got[wrong][:3], theirs[wrong][:3])
        compared += converged.sum()
        past_a_pole += (converged & beyond).sum()
    print(f"{compared} rays are equal, {past_a_pole} of them beyond a pole")
    assert past_a_pole > 10_000


def fisheye_cases():
    rng = np.random.default_rng(5)
    for _ in range(60):
        yield matrix(*rng.uniform(300, 900, 2), *rng.uniform(-30, 30, 2) + (640, 400)), rng.uniform(-0.02, 0.02, 4), SIZE
    for _, model, size, k, coefficients in exports():
        if model == "Fisheye":
            yield k, coefficients, size


def test_fisheye_as_opencv(ask):
    rng, compared = np.random.default_rng(6), 0
    criteria = (cv2.TERM_CRITERIA_COUNT | cv2.TERM_CRITERIA_EPS, 200, 1e-15)
    for k, c, size in fisheye_cases():
        angle, turn = rng.uniform(0, 1.4, 40), rng.uniform(-np.pi, np.pi, 40)
        rays = np.column_stack([np.sin(angle) * np.cos(turn), np.sin(angle) * np.sin(turn), np.cos(angle)])
        expected = cv2.fisheye.projectPoints(rays[:, None], np.zeros(3), np.zeros(3), k, c)[0][:, 0]
        ours = camera(k, c, "opencv_fisheye", size)
        got = pairs(ask("project", camera=ours, points=rays.tolist()), 2)
        seen = ~np.isnan(got[:, 0])
        np.testing.assert_allclose(got[seen], expected[seen], rtol=0, atol=PX)
        slope = np.polynomial.Polynomial([1, 0, 3 * c[0], 0, 5 * c[1], 0, 7 * c[2], 0, 9 * c[3]])
        rises = np.array([(slope(np.linspace(0, a, 2001)) > 0).all() for a in angle])
        np.testing.assert_array_equal(seen, rises)

        again = pairs(ask("unproject", camera=ours, pixels=expected[seen].tolist()), 3)
        gentle = slope(angle[seen]) > 1e-3  # at a fold no answer is sharp
        np.testing.assert_allclose(again[gentle], rays[seen][gentle], rtol=0, atol=RAD)
        theirs = cv2.fisheye.undistortPoints(expected[seen][:, None], k, c, criteria=criteria)[:, 0]
        theirs = np.column_stack([theirs, np.ones(seen.sum())])
        theirs /= np.linalg.norm(theirs, axis=1, keepdims=True)
        right = np.abs(theirs - rays[seen]).max(axis=1) < 1e-8  # OpenCV's Newton strays, or answers −1e6, here and there
        np.testing.assert_allclose(again[right & gentle], theirs[right & gentle], rtol=0, atol=RAD)
        compared += (right & gentle).sum()
    assert compared > 2000


def rigs():
    rng = np.random.default_rng(7)
    cases = list(factory_like(rng, 30)) + list(brown(rng, 30))
    for i, ((k1, d1), (k2, d2)) in enumerate(zip(cases[::2], cases[1::2])):
        vertical, sign = i % 3 == 2, (-1, 1)[i % 2]
        t = rng.normal(0, 0.002, 3)
        t[1 if vertical else 0] = sign * rng.uniform(0.02, 0.1)
        yield k1, d1, k2, d2, cv2.Rodrigues(rng.normal(0, 0.02, 3))[0], t, SIZE
    yield *cases[0], *cases[1], np.eye(3), np.array([-0.075, 0, 0]), SIZE
    yield *cases[0], *cases[1], cv2.Rodrigues(np.array([0.01, 0.5, -0.02]))[0], np.array([-0.075, 0.01, 0.02]), (1279, 799)


def rectify(ask, k1, d1, k2, d2, r, t, size, **options):
    transform = np.eye(4)
    transform[:3, :3], transform[:3, 3] = r, t
    left, right = camera(k1, d1, size=size), camera(k2, d2, size=size)
    return ask("rectify", left=left, right=right, right_from_left=transform.tolist(), **options)


@pytest.mark.parametrize("flags, intrinsics", [(cv2.CALIB_ZERO_DISPARITY, "zero_disparity"), (0, "free_disparity")])
def test_rectify_as_opencv(ask, flags, intrinsics):
    """OpenCV keeps the corners that it averages for cx and cy in float32. We round where it rounds; a last bit that falls
    the other way (3e-5 px at 512 px and above, a quarter of it in the mean) is allowed in one rig of ten."""
    off, rig_count = 0, 0
    for rig in rigs():
        k1, d1, k2, d2, r, t, size = rig
        r1, r2, p1, p2, q, *_ = cv2.stereoRectify(k1, d1, k2, d2, size, r, t[:, None], flags=flags, alpha=-1)
        got = rectify(ask, *rig, intrinsics=intrinsics)
        np.testing.assert_allclose(got["r1"], r1, rtol=0, atol=RAD)
        np.testing.assert_allclose(got["r2"], r2, rtol=0, atol=RAD)
        for name, expected in (("p1", p1), ("p2", p2), ("q", q)):
            np.testing.assert_allclose(got[name], expected, rtol=1e-9, atol=5e-5, err_msg=name)
        off += max(np.abs(np.array(got[n]) - e).max() for n, e in (("p1", p1), ("p2", p2))) > PX
        rig_count += 1
        assert got["baseline"] == pytest.approx(np.linalg.norm(t), abs=1e-15)
    print(f"{rig_count - off} of {rig_count} rigs within {PX} px")
    assert off <= rig_count / 10


def test_rectification_of_exports(ask):
    """Left and right of every real export, by the transforms that DepthAI's library gives (cm; float32)."""
    if not DATA:
        pytest.skip("OAKTWIN_TEST_DATA is not set")
    golden = json.loads((Path(DATA) / "data/depthai-golden/calibration_handler.json").read_text())
    compared = 0
    for content in golden["files"].values():
        cams, transform = content.get("cams", {}), content.get("pairs", {}).get("CAM_B->CAM_C", {}).get("calib")
        if not isinstance(transform, list):
            continue
        left, right, m = cams["CAM_B"], cams["CAM_C"], np.array(transform)
        size = (left["w"], left["h"])
        fisheye = left["model"] == "Fisheye"
        # For a fisheye pair only the rotations can be compared, and they do not depend on the lens.
        d1, d2 = (np.zeros(14), np.zeros(14)) if fisheye else (np.array(left["dist"]), np.array(right["dist"]))
        k1, k2 = np.array(left["K"]), np.array(right["K"])
        r1, r2, p1, p2, *_ = cv2.stereoRectify(k1, d1, k2, d2, size, m[:3, :3], m[:3, 3:])
        got = rectify(ask, k1, d1, k2, d2, m[:3, :3], m[:3, 3], size)
        np.testing.assert_allclose(got["r1"], r1, rtol=0, atol=RAD)
        np.testing.assert_allclose(got["r2"], r2, rtol=0, atol=RAD)
        np.testing.assert_allclose(got["p1"], p1, rtol=1e-9, atol=5e-5)
        np.testing.assert_allclose(got["p2"], p2, rtol=1e-9, atol=5e-5)
        if fisheye:
            lenses = [camera(k1, left["dist"][:4], "opencv_fisheye", size), camera(k2, right["dist"][:4], "opencv_fisheye", size)]
            got = ask("rectify", left=lenses[0], right=lenses[1], right_from_left=m.tolist())
            np.testing.assert_allclose(got["r1"], r1, rtol=0, atol=RAD)
        compared += 1
    assert compared >= 5


def map_of(ask, ours, rotation, target, size):
    answer = ask("map", camera=ours, rectified_from_camera=rotation.tolist(),
                 rectified={"size": list(size), "k": target.tolist()})
    return pairs(answer, 2).reshape(size[1], size[0], 2).astype(np.float32)


def test_map_as_opencv(ask):
    """Both maps are float32, so they differ by at most one unit in the last place (1.2e-4 px beyond 1024 px)."""
    size = (160, 100)
    scale = np.diag([0.125, 0.125, 1])
    for k1, d1, k2, d2, r, t, full in rigs():
        r1, _, p1, *_ = cv2.stereoRectify(k1, d1, k2, d2, full, r, t[:, None])
        target = scale @ p1[:, :3]
        expected = np.dstack(cv2.initUndistortRectifyMap(k1, d1, r1, target, size, cv2.CV_32FC1))
        got = map_of(ask, camera(k1, d1), r1, target, size)
        ulp = np.spacing(np.abs(expected))
        assert (np.abs(got - expected) <= 1.01 * np.maximum(ulp, PX)).all()
    for k, c, full in fisheye_cases():
        rotation = cv2.Rodrigues(np.array([0.01, -0.02, 0.005]))[0]
        target = matrix(60, 60, 80, 50)
        expected = np.dstack(cv2.fisheye.initUndistortRectifyMap(k, c, rotation, target, size, cv2.CV_32FC1))
        got = map_of(ask, camera(k, c, "opencv_fisheye", full), rotation, target, size)
        assert (np.abs(got - expected) <= 1.01 * np.maximum(np.spacing(np.abs(expected)), PX)).all()


def test_tilt_error(ask):
    """The worst pixel when τx and τy are dropped, from OpenCV's projection of the rays of every eighth pixel."""
    for k, c in list(factory_like(np.random.default_rng(8), 5)):
        grid = np.stack(np.meshgrid(np.r_[0:1280:8, 1279], np.r_[0:800:8, 799]), -1).reshape(-1, 2).astype(float)
        flat = pairs(ask("undistort", camera=camera(k, c), pixels=grid.tolist()), 2)
        known = ~np.isnan(flat[:, 0])
        points = np.column_stack([flat[known], np.ones(known.sum())])
        without = np.r_[c[:12], 0, 0]
        moved = cv2.projectPoints(points, np.zeros(3), np.zeros(3), k, without)[0][:, 0]
        worst = np.linalg.norm(moved - grid[known], axis=1).max()
        largest = ask("tilt_error", camera=camera(k, c))
        assert known.mean() > 0.95 and largest >= worst - PX
        if known.all():
            assert largest == pytest.approx(worst, abs=1e-3)


def test_usd_optics_in_gfcamera(ask):
    """pxr's own camera: field of view, the direction that the offsets move the window, and the intrinsics we read back."""
    Gf = pytest.importorskip("pxr.Gf")
    rng = np.random.default_rng(9)
    for _ in range(50):
        (w, h), k = (1280, 800), matrix(*[rng.uniform(500, 900)] * 2, *rng.uniform(-40, 40, 2) + (640, 400))
        intrinsics = {"size": [w, h], "k": k.tolist()}
        optics = ask("usd_optics", intrinsics=intrinsics, pixel_size_um=3.0, offsets="openusd")
        gf = Gf.Camera()
        gf.focalLength = optics["focal_length"]
        gf.horizontalAperture, gf.verticalAperture = optics["horizontal_aperture"], optics["vertical_aperture"]
        gf.horizontalApertureOffset = optics["horizontal_aperture_offset"]
        gf.verticalApertureOffset = optics["vertical_aperture_offset"]
        # GfCamera keeps float32: 1e-7 of the image's width.
        float32 = 3e-4
        assert np.radians(gf.GetFieldOfView(Gf.Camera.FOVHorizontal)) == pytest.approx(optics["hfov"], abs=1e-6)
        fov = ask("fov", intrinsics=intrinsics)
        assert optics["hfov"] == pytest.approx(fov["hfov"], abs=1e-12)
        assert np.radians(gf.GetFieldOfView(Gf.Camera.FOVVertical)) == pytest.approx(fov["vfov"], abs=1e-6)

        # A point at OpenCV's (x, y, 1) is (x, −y, −1) for OpenUSD; its place in the window is its place in the image.
        matrix4 = gf.frustum.ComputeProjectionMatrix()
        for x, y in rng.uniform(-0.5, 0.5, (5, 2)):
            ndc = matrix4.Transform(Gf.Vec3d(x, -y, -1.0))
            usd = np.array([(ndc[0] + 1) / 2 * w, (1 - ndc[1]) / 2 * h])
            (ours,) = ask("project", camera={"intrinsics": intrinsics, "lens": {"model": "pinhole"}}, points=[[x, y, 1.0]])
            assert np.abs(usd - (np.array(ours) + 0.5)).max() < float32
        np.testing.assert_allclose(optics["openusd"], k, rtol=0, atol=1e-9)
        # Isaac Sim ignores the offsets and centres the image.
        centred = matrix(k[0, 0], k[0, 0], w / 2 - 0.5, h / 2 - 0.5)
        np.testing.assert_allclose(optics["isaac"], centred, rtol=0, atol=1e-9)


def test_hfov(ask):
    for hfov in np.radians([64, 77, 80, 97, 127]):
        k = np.array(ask("from_hfov", size=list(SIZE), hfov=hfov))
        np.testing.assert_allclose(k[:2, 2], (639.5, 399.5), rtol=0, atol=1e-12)
        # OpenCV adds the angles to both edges, (0, W) in its pixel coordinates, whose middle is half a pixel from ours.
        centred = matrix(k[0, 0], k[1, 1], 640, 400)
        fov, *_ = cv2.calibrationMatrixValues(centred, SIZE, 1, 1)
        assert np.radians(fov) == pytest.approx(hfov, abs=RAD)


def test_a_bad_line_is_told_not_fatal():
    lines = '{"op": "fly"}\nnot json\n{"op": "from_hfov", "size": [4, 2], "hfov": 1.0}\n'
    out = subprocess.run([EVAL], input=lines, capture_output=True, text=True, check=True).stdout.splitlines()
    assert ["error" in line for line in out] == [True, True, False]
