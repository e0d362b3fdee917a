"""Rendered and matched pairs, compared with the ground truth, OpenCV and the program, and invalid input."""

import copy
import json
import pickle

import numpy as np
import pytest

import oaktwin
from conftest import BASELINE, FX, same

PRO = "OAK-D Pro PoE"


def test_known_disparity(matcher, textured):
    left, right, truth, both = textured
    seen = matcher(left, right)
    assert seen["findings"] == [] and list(seen) == [
        "depth", "disparity", "confidence", "rectified_left", "rectified_right", "findings"
    ]
    disparity, depth = seen["disparity"], seen["depth"]
    assert disparity.dtype == depth.dtype == np.float32 and seen["confidence"].dtype == np.uint8
    assert disparity.shape == depth.shape == seen["confidence"].shape == (120, 320)
    measured = disparity > 0
    assert np.array_equal(measured, depth > 0) and measured[both].mean() > 0.9
    error = np.abs(disparity - truth)[measured & both]
    assert np.median(error) < 0.2 and np.mean(error > 1) < 0.01
    # Depth follows from disparity, in integer millimetres.
    assert np.abs(depth - FX * BASELINE / np.where(measured, disparity, 1))[measured].max() < 5.1e-4
    assert np.array_equal(seen["rectified_left"], left) and np.array_equal(seen["rectified_right"], right)
    assert seen["confidence"][measured].min() > 0


def test_beside_opencv(matcher, textured):
    cv2 = pytest.importorskip("cv2", reason="OpenCV is not installed here")
    left, right, truth, both = textured
    sgbm = cv2.StereoSGBM_create(
        0, 96, 5, P1=8 * 25, P2=32 * 25, disp12MaxDiff=1, uniquenessRatio=10, mode=cv2.STEREO_SGBM_MODE_HH
    )
    theirs = sgbm.compute(left, right).astype(np.float32) / 16
    ours = matcher(left, right)["disparity"]
    both = both & (ours > 0) & (theirs > 0)
    # OpenCV finds nothing in the first 96 columns.
    assert both.sum() > 0.6 * ours.size
    assert np.median(np.abs(ours - theirs)[both]) < 0.2 and np.mean(np.abs(ours - theirs)[both] > 1) < 0.02
    assert np.median(np.abs(ours - truth)[both]) < 1.2 * np.median(np.abs(theirs - truth)[both])


def written(folder, left, right):
    image = pytest.importorskip("PIL.Image", reason="Pillow is not installed here")
    for name, pixels in [("left", left), ("right", right)]:
        image.fromarray(pixels).save(folder / f"{name}.png")
    return folder / "left.png", folder / "right.png"


def by_program(program, folder, left, right, *options, code=0):
    out = folder / "out"
    text = program("stereo", *written(folder, left, right), "-o", out, "--annotators", "disparity,confidence", *options, code=code)
    names = {"depth": "depth_sensor_distance", "disparity": "disparity", "confidence": "confidence"}
    return {name: np.load(out / f"{file}.npy") for name, file in names.items()}, text


@pytest.mark.parametrize("kind", ["grey", "ten bits", "colours"])
@pytest.mark.parametrize(
    "options, arguments",
    [
        ({}, []),
        ({"preset": "robotics", "platform": "rvc4"}, ["--preset", "robotics", "--platform", "rvc4"]),
        (
            {
                "filters": ["decimation:factor=2", "median:size=5"],
                "parameters": {"subpixelFractionalBits": 3, "leftRightCheck": False},
                "extended_disparity": True,
            },
            ["--filter", "decimation:factor=2", "--filter", "median:size=5", "--param", "subpixelFractionalBits=3",
             "--param", "leftRightCheck=false", "--extended-disparity"],
        ),
    ],
)
def test_results_match_the_program(program, tmp_path, textured, kind, options, arguments):
    left, right, _, _ = textured
    if kind == "ten bits":
        left, right = (image.astype(np.uint16) * 4 + 3 for image in (left, right))
    elif kind == "colours":
        left, right = (np.stack([image, image // 2, 255 - image], axis=-1) for image in (left, right))
    expected, _ = by_program(program, tmp_path, left, right, "--hfov", 61.7, "--baseline", 0.05, *arguments)
    seen = oaktwin.StereoMatcher(hfov_deg=61.7, baseline=0.05, **options)(left, right)
    for name, array in expected.items():
        assert array.dtype == seen[name].dtype and array.tobytes() == seen[name].tobytes(), name


@pytest.fixture(scope="module")
def wall():
    """A wall at x = 2 m, and a smaller object in front of it."""
    corners = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    vertices = [[x, half * y, half * z] for x, half in [(2.0, 9), (1.2, 0.2)] for y, z in corners]
    return oaktwin.Scene.from_triangles(np.array(vertices), np.array([[0, 1, 2], [0, 2, 3], [4, 5, 6], [4, 6, 7]]))


@pytest.fixture(scope="module")
def unit(calibration):
    return oaktwin.Device.from_calibration(calibration)


AHEAD = oaktwin.look_at((0, 0, 0), (1, 0, 0), frame="body")


def test_a_unit_matches_the_program(program, tmp_path, wall, unit, calibration):
    taken = wall.render_pair(unit, AHEAD, size=(320, 200), projector=1, seed=3, frame=0)
    for arguments, options in [([], {}), (["--rectify", "full"], {"rectify": "full"}), (["--rectified"], {"raw": False})]:
        expected, _ = by_program(
            program, tmp_path, taken["left"], taken["right"], "--calibration", calibration, *arguments
        )
        seen = oaktwin.StereoMatcher(unit, **options)(taken["left"], taken["right"])
        for name, array in expected.items():
            assert array.tobytes() == seen[name].tobytes(), (name, options)


def test_rendered_matched_and_compared(wall, unit):
    # For the unit, a homography does not remove the lens distortion, which the ground truth does not have, and depth is computed with
    # the baseline of the design.
    for device, most in [(oaktwin.Device(PRO), 0.02), (oaktwin.Device("OAK-D Pro W PoE", lens="fisheye"), 0.02), (unit, 0.06)]:
        taken = wall.render_pair(device, AHEAD, size=(640, 400), projector=1.0, frame=0)
        assert all(image.shape == (400, 640) for image in taken.values() if isinstance(image, np.ndarray))
        matcher = oaktwin.StereoMatcher(device)
        seen = matcher(taken["left"], taken["right"])
        for side in ["rectified_left", "rectified_right"]:
            assert np.array_equal(seen[side], taken[side])
        again = oaktwin.StereoMatcher(device, raw=False)(taken["rectified_left"], taken["rectified_right"])
        assert same(again, seen)
        depth, z = seen["depth"], taken["z"]
        assert z.dtype == np.float32 and depth.shape == z.shape
        measured = depth > 0
        # Occlusions, the border and gaps between the dots are invalid.
        assert measured.mean() > 0.5 and np.median(np.abs(depth / z - 1)[measured]) < most
        # The ground truth is in the frame of the matcher's camera.
        assert matcher.camera.size == (640, 400) and matcher.baseline == pytest.approx(0.075, rel=0.02)
        truth = wall.render(matcher.camera, AHEAD @ matcher.camera.body_from_camera)["distance_to_image_plane"]
        assert np.array_equal(truth, z)


def test_a_nominal_pair_is_rectified(wall):
    device = oaktwin.Device(PRO)
    taken = wall.render_pair(device, AHEAD, size=(320, 200), projector=0.5, frame=0)
    for side in ["left", "right"]:
        assert np.array_equal(taken[side], taken[f"rectified_{side}"])
    matcher = oaktwin.StereoMatcher(device)
    assert matcher.rectify is None and oaktwin.StereoMatcher(device, raw=True).rectify == "homography"
    rectification, camera = device.rectification(), matcher.camera
    assert camera.size == (1280, 800) and np.allclose(camera.K, rectification.P1[:, :3], rtol=1e-9)
    assert np.allclose(camera.body_from_camera, device.cameras["left"].body_from_camera)


@pytest.mark.parametrize("sensor, baseline", [(None, 0.15), ("Camera_pseudo_depth_100mm", 0.1), ("Camera_pseudo_depth_50mm", 0.05)])
def test_pairs_of_a_device_with_three(wall, sensor, baseline):
    device = oaktwin.Device("OAK-D LR")
    taken = wall.render_pair(device, AHEAD, sensor=sensor, size=(640, 400), imager={"noise": False})
    matcher = oaktwin.StereoMatcher(device, sensor=sensor)
    assert matcher.baseline == pytest.approx(baseline)
    seen = matcher(taken["left"], taken["right"])
    assert np.allclose(matcher.camera.body_from_camera, device.depth_camera(sensor).body_from_camera)
    truth = wall.render(matcher.camera, AHEAD @ matcher.camera.body_from_camera)["distance_to_image_plane"]
    assert np.array_equal(truth, taken["z"])
    assert same(pickle.loads(pickle.dumps(matcher))(taken["left"], taken["right"]), seen)


def test_pairs_that_a_device_lacks(wall):
    with pytest.raises(oaktwin.Error, match="has no depth sensor 'Camera_pseudo_depth_60mm'; did you mean"):
        oaktwin.StereoMatcher(oaktwin.Device("OAK-D LR"), sensor="Camera_pseudo_depth_60mm")
    with pytest.raises(oaktwin.Error, match="is not a stereo pair; choose Camera_pseudo_depth_stereo"):
        wall.render_pair(oaktwin.Device("OAK-D ToF"), AHEAD, sensor="tof")


def test_options_of_rendered_pairs(wall):
    device = oaktwin.Device(PRO)
    take = lambda **options: wall.render_pair(device, AHEAD, size=(320, 200), **{"frame": 0, **options})
    plain = take(projector=1)
    again = take(projector=1)
    assert all(np.array_equal(again[name], image) for name, image in plain.items() if isinstance(image, np.ndarray))
    assert not np.array_equal(take(projector=1, frame=1)["left"], plain["left"])
    assert not np.array_equal(take(projector=1, seed=1)["left"], plain["left"])
    assert np.array_equal(take(projector=1, seed=1)["z"], plain["z"])
    ten = take(projector=1, imager={"bits": 10})
    assert ten["left"].dtype == ten["rectified_right"].dtype == np.uint16 and 255 < ten["left"].max() < 1024
    still = [take(projector=1, frame=frame, imager={"noise": False})["left"] for frame in (0, 1)]
    assert np.array_equal(*still)
    # A calibration error changes the measured depth.
    off = take(projector=1, device_seed=5)
    matcher = oaktwin.StereoMatcher(device)
    assert np.array_equal(off["z"], plain["z"]) and not np.array_equal(off["right"], plain["right"])
    depths = [matcher(one["left"], one["right"])["depth"] for one in (plain, off)]
    assert abs(np.subtract(*[np.median(depth[depth > 0]) for depth in depths])) > 1e-3
    # Neither darkness nor a blank wall without dots can be matched.
    assert plain["left"].std() > 4 > take()["left"][90:110, 10:60].std()


def test_invalid_options_of_rendered_pairs(wall):
    device = oaktwin.Device(PRO)
    for call, said in [
        (lambda: wall.render_pair(oaktwin.Device("OAK4-D"), AHEAD, projector=1), "OAK4-D: projector: the model has no dot projector"),
        (lambda: wall.render_pair(device, AHEAD, projector=2), "projector: 2 is out of range; give 0 to 1"),
        (lambda: wall.render_pair(device, AHEAD, projector=float("nan")), "projector: NaN is out of range"),
        (lambda: wall.render_pair(device, AHEAD, ambient=-1), "ambient: -1 is out of range"),
        (lambda: wall.render_pair(device, AHEAD, imager={"fullwell": 0}), "fullWell"),
        (lambda: wall.render_pair(device, AHEAD, imager={"bit": 10}), "imager: .*bit"),
        (lambda: wall.render_pair(device, AHEAD, imager=10), "imager: invalid value 10; pass a dictionary"),
        (lambda: wall.render_pair(device, AHEAD, size=(0, 4)), "has no pixel"),
        (lambda: wall.render_pair(device, AHEAD, size=(1 << 20, 1 << 20)), "more than 2.31 pixels"),
        (lambda: wall.render_pair(device, np.stack([AHEAD] * 2)), "world_from_body: contains several poses"),
        (lambda: wall.render_pair(device, AHEAD * np.nan), "world_from_body: has non-finite values"),
    ]:
        with pytest.raises(oaktwin.Error, match=said):
            call()
    with pytest.raises(oaktwin.Error, match="device: invalid value None; pass oaktwin.Device"):
        wall.render_pair(None, AHEAD)


def test_image_types(matcher, textured):
    left, right, _, _ = textured
    expected = matcher(left, right)
    wide = np.zeros((240, 640), np.uint8)
    wide[::2, ::2] = left
    for one, two in [
        (np.asfortranarray(left), wide[::2, ::2]),
        (memoryview(left), left[:, ::-1][:, ::-1]),
        (left[..., None], left),
        (np.repeat(left[..., None], 3, axis=2), np.repeat(left[..., None], 4, axis=2)),
    ]:
        assert same(matcher(one, right), expected) and same(matcher(two, right), expected)
    # The luma of the program.
    colours = np.random.default_rng(0).integers(0, 256, (120, 320, 3)).astype(np.uint8)
    grey = (colours.astype(int) @ [299, 587, 114] + 500) // 1000
    assert np.array_equal(matcher(colours, colours)["rectified_left"], grey)
    ten = [image.astype(">u2") for image in (left, right)]
    assert matcher(*ten)["rectified_left"].dtype == np.uint16
    read_only = left.copy()
    read_only.flags.writeable = False
    assert same(matcher(read_only, right), expected)


@pytest.mark.parametrize(
    "left, right, kind, said",
    [
        (np.zeros((9, 12), np.uint8), np.zeros((9, 13), np.uint8), oaktwin.Error, "left image is 12x9, the right one 13x9"),
        (np.zeros((9, 12), np.uint8), np.zeros((9, 12), np.uint16), oaktwin.Error, "8 bits, the right one 10"),
        (np.zeros((9, 12), np.float32), np.zeros((9, 12), np.uint8), TypeError, "left: unsupported dtype float32; pass uint8"),
        (np.zeros((9, 12), np.uint8), np.full((9, 12), np.nan), TypeError, "right: unsupported dtype float64"),
        (np.zeros((9, 12), np.int16), np.zeros((9, 12), np.int16), TypeError, "left: unsupported dtype int16"),
        (np.zeros((9, 12), bool), np.zeros((9, 12), bool), TypeError, "left: unsupported dtype bool"),
        (np.zeros((0, 12), np.uint8), np.zeros((0, 12), np.uint8), oaktwin.Error, "left: .*has no pixel"),
        (np.zeros((1, 2, 9, 12), np.uint8), np.zeros((2, 9, 12), np.uint8), oaktwin.Error, r"left: has shape \[1, 2, 9, 12\]; pass an image"),
        (np.zeros(12, np.uint8), np.zeros(12, np.uint8), oaktwin.Error, r"left: has shape \[12\]"),
        (np.zeros((9, 12, 3), np.uint16), np.zeros((9, 12, 3), np.uint16), TypeError, "left: unsupported dtype uint16 for colours"),
        (np.full((9, 12), 1024, np.uint16), np.zeros((9, 12), np.uint16), oaktwin.Error, "left: .*up to 1024; .*>> 6"),
        ([[1, 2], [3, 4]], np.zeros((2, 2), np.uint8), TypeError, "left: unsupported dtype int64"),
        (np.zeros((2, 2), np.uint8), None, TypeError, "right: NoneType is not an array"),
    ],
)
def test_wrong_images(matcher, textured, left, right, kind, said):
    before = matcher(*textured[:2])
    with pytest.raises(kind, match=said):
        matcher(left, right)
    assert same(matcher(*textured[:2]), before)


def test_small_images(matcher):
    for height, width in [(1, 1), (1, 200), (200, 1), (3, 5)]:
        image = np.arange(height * width, dtype=np.uint8).reshape(height, width)
        seen = matcher(image, image)
        assert seen["depth"].shape == (height, width)


@pytest.mark.parametrize(
    "options, said",
    [
        ({}, "device: the camera of the images is unknown; pass a device, or fx"),
        ({"fx": 300}, "camera of the images is unknown"),
        ({"baseline": 0.1}, "camera of the images is unknown"),
        ({"fx": 300, "hfov_deg": 60, "baseline": 0.1}, "fx, hfov_deg: only one of them"),
        ({"fx": float("nan"), "baseline": 0.1}, "fx: NaN is out of range"),
        ({"fx": 0, "baseline": 0.1}, "fx: 0 is out of range"),
        ({"hfov_deg": 180, "baseline": 0.1}, "hfov"),
        ({"fx": 300, "baseline": 0}, "baseline"),
        ({"fx": 300, "baseline": float("inf")}, "baseline"),
        ({"fx": 300, "baseline": 0.1, "raw": True}, "sensor, raw, rectify: require a device"),
        ({"fx": 300, "baseline": 0.1, "rectify": "full"}, "sensor, raw, rectify: require a device"),
        ({"fx": 300, "baseline": 0.1, "platform": "rvc5"}, "platform: invalid value 'rvc5'; did you mean 'rvc"),
        ({"fx": 300, "baseline": 0.1, "preset": "robotic"}, "robotic"),
        ({"fx": 300, "baseline": 0.1, "filters": ["medium"]}, "median"),
        ({"fx": 300, "baseline": 0.1, "parameters": {"path": 3}}, "paths"),
        ({"fx": 300, "baseline": 0.1, "parameters": {"bias": 1}}, "the error of their own calibration"),
        ({"device": PRO, "fx": 300}, "device: conflicts with fx, hfov_deg and baseline; omit fx"),
        ({"device": PRO, "raw": False, "rectify": "full"}, "rectify: raw=False means"),
        ({"device": PRO, "rectify": "ful"}, "rectify: invalid value 'ful'; did you mean 'full"),
    ],
)
def test_invalid_options(options, said):
    device = options.get("device")
    options = {**options, "device": device and oaktwin.Device(device)}
    with pytest.raises(oaktwin.Error, match=said):
        oaktwin.StereoMatcher(**options)


def test_the_depth_sensor_rejects_stereo_matching(device, room):
    sensor = oaktwin.DepthSensor(device, engine="stereo-matching")
    for call in [sensor, lambda depth: sensor.annotate(depth, annotators=["depth_sensor_distance"])]:
        with pytest.raises(oaktwin.Error, match="engine: stereo-matching matches image pairs.*use shoot.*or StereoMatcher"):
            call(room[0])


def codes(seen):
    return [finding.code for finding in seen["findings"]]


def test_findings(matcher, textured, program, tmp_path):
    left, right, _, _ = textured
    assert codes(matcher(right, left)) == ["pair-swapped"]
    lower = np.roll(right, 4, axis=0)
    assert codes(matcher(left, lower)) == ["vertical-offset"]
    assert codes(matcher(np.full_like(left, 90), right)) == ["no-texture"]
    bright = np.maximum(left, np.where(np.arange(320) % 320 < 200, 255, 0)).astype(np.uint8)
    assert "saturated" in codes(matcher(bright, bright))
    assert "range-beyond-image" in codes(matcher(left[:, :60].copy(), right[:, :60].copy()))
    finding = matcher(right, left)["findings"][0]
    assert finding.level == "warning" and finding.remedy == "swap the left and the right image"
    _, text = by_program(program, tmp_path, right, left, "--fx", FX, "--baseline", BASELINE, "--json", code=1)
    assert finding.message in text


def test_temporal_filters_have_a_state(textured):
    left, right, _, _ = textured
    matcher = oaktwin.StereoMatcher(fx=FX, baseline=BASELINE, filters=["temporal:alpha=0.3"])
    other = right + np.random.default_rng(0).integers(0, 9, right.shape).astype(np.uint8)
    first, second = matcher(left, right)["depth"], matcher(left, other)["depth"]
    fresh = copy.copy(matcher)(left, other)["depth"]
    assert not np.array_equal(second, fresh)
    # Invalid images do not change the state.
    with pytest.raises(oaktwin.Error):
        matcher(left, right[:50])
    matcher.reset()
    assert np.array_equal(matcher(left, right)["depth"], first) and np.array_equal(matcher(left, other)["depth"], second)
    matcher(left[:50].copy(), right[:50].copy())
    assert np.array_equal(matcher(left, other)["depth"], fresh)


@pytest.mark.parametrize(
    "options",
    [
        {"fx": 299.9, "baseline": 0.05, "platform": "rvc4"},
        {"hfov_deg": 70, "baseline": 0.075, "preset": "robotics", "extended_disparity": True},
        {"filters": ["median:size=3"], "parameters": {"paths": 3, "leftRightCheck": False}},
        {"raw": True, "rectify": "mesh", "platform": "rvc4"},
    ],
)
def test_pickles(textured, options):
    left, right, _, _ = textured
    device = None if "baseline" in options else oaktwin.Device(PRO)
    matcher = oaktwin.StereoMatcher(device, **options)
    expected = matcher(left, right)
    for other in [pickle.loads(pickle.dumps(matcher)), copy.copy(matcher), copy.deepcopy(matcher)]:
        assert same(other(left, right), expected)
        assert repr(other) == repr(matcher) and other.filters == matcher.filters
        assert other.parameters == matcher.parameters and other.rectify == matcher.rectify


def test_pickling_includes_the_calibration(tmp_path, textured, calibration, unit):
    file = tmp_path / calibration.name
    file.write_bytes(calibration.read_bytes())
    matcher = oaktwin.StereoMatcher(oaktwin.Device.from_calibration(file))
    text = pickle.dumps(matcher)
    file.unlink()
    assert same(pickle.loads(text)(*textured[:2]), oaktwin.StereoMatcher(unit)(*textured[:2]))
    assert matcher.rectify == "homography" and "homography" in repr(matcher)


def test_a_calibration_without_the_pair(tmp_path, calibration):
    told = json.loads(calibration.read_text("utf-8"))
    for _, camera in told["cameraData"]:
        camera["extrinsics"]["toCameraSocket"] = -1
    file = tmp_path / "apart.json"
    file.write_text(json.dumps(told))
    device = oaktwin.Device.from_calibration(file, force=True)
    assert "pair-nominal" in [finding.code for finding in device.findings]
    with pytest.raises(oaktwin.Error, match="apart.json: .*calibrate the stereo pair"):
        oaktwin.StereoMatcher(device)


def test_parameters():
    matcher = oaktwin.StereoMatcher(fx=400, baseline=0.05, parameters={"paths": 3})
    assert matcher.parameters["paths"] == "3" and float(matcher.parameters["focalLength"]) == 400
    assert float(matcher.parameters["baseline"]) == matcher.baseline == 0.05 and matcher.findings == []
    assert matcher.filters == [] and np.array_equal(matcher.camera.body_from_camera, np.eye(4))
    again = oaktwin.StereoMatcher(fx=400, baseline=0.05, parameters=matcher.parameters)
    assert again.parameters == matcher.parameters
    assert oaktwin.StereoMatcher(fx=400, baseline=0.05, preset="default").filters != []


def test_a_field_of_view_in_radians_is_reported():
    with pytest.warns(oaktwin.FindingWarning, match="looks like radians"):
        oaktwin.StereoMatcher(hfov_deg=1.2, baseline=0.075)


def test_the_distortion_that_a_homography_leaves_is_reported(unit):
    for rectify in ["homography", "mesh", "full"]:
        matcher = oaktwin.StereoMatcher(unit, raw=True, rectify=rectify)
        found = [finding for finding in matcher.findings if finding.code == "rectified-distortion"]
        assert len(found) == (rectify == "homography")
    (found,) = [one for one in oaktwin.StereoMatcher(unit, rectify="homography").findings if one.code == "rectified-distortion"]
    assert "% of the pixels are off by more than 1 px" in found.message and 'rectify="mesh"' in found.remedy
