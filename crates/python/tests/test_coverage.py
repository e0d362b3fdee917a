import json
import pickle

import numpy as np
import pytest

import oaktwin
from conftest import ROOT

ROOM = ROOT / "crates/cli/tests/cli/fixtures/room.usda"
PLATE = np.array([[2, -0.25, -0.25], [2, 0.25, -0.25], [2, 0.25, 0.25], [2, -0.25, 0.25]])
FACES = np.array([[0, 1, 2], [0, 2, 3]])
# A plate without texture.
PLAIN = {"confidenceThreshold": 0}
SMALL = {"size": (320, 200), "parameters": PLAIN}


@pytest.fixture(scope="module")
def plate():
    mesh = oaktwin.Mesh(PLATE, FACES)
    # The second one is hidden behind the first one.
    return oaktwin.Scene.from_meshes({"near": mesh, "far": mesh}, poses={"far": translation(x=0.5)})


def translation(x=0.0, y=0.0, z=0.0):
    matrix = np.eye(4)
    matrix[:3, 3] = x, y, z
    return matrix


def test_matches_the_program(program, device):
    scene = oaktwin.Scene.open(ROOM, micro_texture=True)
    eye = oaktwin.look_at((0, -2, 1), (0, 0, 0.25), frame="body")
    got = oaktwin.coverage(scene, [device, oaktwin.Device("OAK-D ToF")], eye, region="/World/Box", tilt_deg="10:30:20", samples=500,
                           size=(320, 200))
    said = ["coverage", ROOM, "--model", "OAK4-D", "--model", "OAK-D ToF", "--look-at", 0, -2, 1, 0, 0, 0.25, "--region", "/World/Box",
            "--tilt", "10:30:20", "--samples", 500, "--resolution", "320x200", "--json"]
    expected = json.loads(program(*said))
    # The pose went through a quaternion only there.
    for key in ["region", "ranking", "selection", "together"]:
        assert got.report[key] == expected[key]
    assert [one["measured"] for one in got.candidates] == [one["measured"] for one in expected["candidates"]]
    assert list(got.report) == [key for key in expected if key not in ["scene", "files"]]
    same = oaktwin.coverage(scene, [device, oaktwin.Device("OAK-D ToF")], eye, region=["/World/Box"], tilt_deg=[10, 30], samples=500,
                            size=(320, 200))
    assert same.report == got.report and same.points is None


def test_a_plate(plate, device):
    got = oaktwin.coverage(plate, device, np.eye(4), region="/World/near", samples=1000, **SMALL)
    assert got.best["seen"] == 1 and got.best["measured"] > 0.95
    assert got.report["region"]["area_m2"] == pytest.approx(0.25)
    assert repr(got).startswith("<oaktwin.Coverage of 0.25 m²: 1 candidates, best OAK4-D, pose 0, measures 9")
    table = got.to_numpy()
    assert table["seen"] == [1] and table["p95_absolute_error_mm"][0] == got.best["p95_absolute_error_mm"]
    assert got._repr_html_().count("<tr>") == 2
    assert pickle.loads(pickle.dumps(got)).report == got.report

    hidden = oaktwin.coverage(plate, device, np.eye(4), region="/World/far", samples=1000, **SMALL)
    # The near plate appears larger by a quarter.
    lost = hidden.best["lost"]
    assert lost.get("hidden", 0) + lost.get("faces_away", 0) > 0.99
    assert hidden.best["median_error_mm"] is None and np.isnan(hidden.to_numpy()["median_error_mm"]).all()
    half = oaktwin.coverage(plate, device, np.eye(4), region_box=[(0, 0, -1), (2.1, 1, 1)], samples=100, **SMALL)
    assert half.report["region"]["area_m2"] == pytest.approx(0.125)


def test_the_outcomes_at_each_point(plate, device):
    poses = np.stack([np.eye(4), translation(x=-5), translation(y=9)])
    got = oaktwin.coverage(plate, device, poses, samples=400, points=True, **SMALL)
    points = got.points
    assert points["position"].shape == points["normal"].shape == (400, 3)
    assert points["outcome"].shape == points["error_m"].shape == (3, 400) and points["outcome"].dtype == np.uint8
    assert points["prim_paths"] == ["/World/near", "/World/far"]
    assert np.allclose(np.abs(points["normal"]), [1, 0, 0])
    assert np.allclose(points["position"][:, 0], np.where(points["instance"] == 0, 2, 2.5))
    measured = points["outcome"] == 0
    assert np.array_equal(measured, np.isfinite(points["error_m"]))
    assert np.allclose(measured.mean(axis=1), [one["measured"] for one in got.candidates])
    assert measured.any(axis=0).mean() == got.together["measured"]
    assert points["reasons"][0] == "measured"
    assert {points["reasons"][code] for code in points["outcome"][2]} == {"outside_view"}
    # The plane of the near plate is where it is measured.
    assert np.abs(points["error_m"][0][measured[0]]).max() < 0.1


def test_a_tolerance(plate, device):
    eye = np.eye(4)
    free = oaktwin.coverage(plate, device, eye, samples=200, points=True, **SMALL)
    strict = oaktwin.coverage(plate, device, eye, samples=200, tolerance_mm=1, **SMALL)
    errors = free.points["error_m"][0]
    expected = np.mean(np.abs(errors[~np.isnan(errors)]) <= 1e-3) * np.mean(~np.isnan(errors))
    assert strict.candidates[0]["measured"] == pytest.approx(expected)
    assert strict.candidates[0]["lost"]["inaccurate"] > 0


def test_nonsense(plate, device):
    eye = np.eye(4)
    for text, options in {
        "region: the scene has no geometry at '/World/Near'; did you mean '/World/near'": {"region": "/World/Near"},
        "region: invalid value 3": {"region": 3},
        "region_box: it contains no surface": {"region_box": [(5, 5, 5), (6, 6, 6)]},
        "region_box: the minimum of x, 1, is above": {"region_box": [(1, 0, 0), (0, 1, 1)]},
        "region_box: y is NaN": {"region_box": [(0, np.nan, 0), (1, 1, 1)]},
        "region_box: has 1 items": {"region_box": [(0, 0, 0)]},
        "samples: 0 points": {"samples": 0},
        "tolerance_mm: 0 mm is out of range": {"tolerance_mm": 0},
        "height: NaN is not finite": {"height": [np.nan]},
        "height: 'x' is not a number": {"height": "x"},
        "tilt_deg: 91 is out of range": {"tilt_deg": [91]},
        "poses: .* candidates are too many": {"height": list(range(1, 200)), "tilt_deg": "0:90:0.5"},
        "sensor: OAK4-D has no depth sensor 'tof'": {"sensor": "tof"},
        "an image of 0x5 has no pixels": {"size": (0, 5)},
    }.items():
        with pytest.raises(oaktwin.Error, match=text):
            oaktwin.coverage(plate, device, eye, **options)
    with pytest.raises(oaktwin.Error, match="poses: has shape"):
        oaktwin.coverage(plate, device, np.eye(3))
    for nothing in [dict(devices=[], poses=eye), dict(devices=device, poses=np.empty((0, 4, 4)))]:
        with pytest.raises(oaktwin.Error, match="no candidates"):
            oaktwin.coverage(plate, **nothing)
    with pytest.raises(TypeError, match="unexpected keyword argument 'sede'"):
        oaktwin.coverage(plate, device, eye, sede=1)


def crosses(origin, ends, triangles):
    """Whether anything lies between the origin and each end, by Moeller and Trumbore's intersection: a boolean for each."""
    a, ab, ac = triangles[:, 0], triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]
    direction = (ends - origin)[:, None]
    across = np.cross(direction, ac)
    determinant = (across * ab).sum(-1)
    with np.errstate(divide="ignore", invalid="ignore"):
        u = (across * (origin - a)).sum(-1) / determinant
        turned = np.cross(origin - a, ab)
        v = (direction * turned).sum(-1) / determinant
        t = (ac * turned).sum(-1) / determinant
    return ((u >= 0) & (v >= 0) & (u + v <= 1) & (t > 1e-9) & (t < 1 - 1e-6)).any(axis=1)


def test_visibility_matches_another_ray_caster(device):
    """Tumbled boxes, some of which hide others, from several poses."""
    random = np.random.default_rng(5)
    corners = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]) * 0.12
    sides = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    faces = np.array([triangle for a, b, c, d in sides for triangle in ((a, b, c), (a, c, d))])
    mesh, poses, triangles = oaktwin.Mesh(corners, faces), {}, []
    for number in range(30):
        turn, _ = np.linalg.qr(random.normal(size=(3, 3)))
        pose = np.eye(4)
        pose[:3, :3], pose[:3, 3] = turn * np.sign(np.linalg.det(turn)), random.uniform(-0.6, 0.6, 3)
        poses[f"box_{number}"] = pose
        triangles.append((corners.astype(np.float32).astype(float) @ pose[:3, :3].T + pose[:3, 3])[faces])
    triangles = np.concatenate(triangles)
    scene = oaktwin.Scene.from_meshes(dict.fromkeys(poses, mesh), poses=poses)
    eyes = [oaktwin.look_at(eye, (0.3, 0, 0), frame="body") for eye in [(2, 0, 0), (-1, 1.5, 0.5), (0.5, -1, 1.4), (0.1, 0.1, 0.1)]]
    got = oaktwin.coverage(scene, device, np.stack(eyes), samples=4000, points=True, **SMALL)
    camera = device.depth_camera().resized(320, 200, rule="depthai")
    position, normal = got.points["position"], got.points["normal"]
    names = np.vectorize(got.points["reasons"].get)(got.points["outcome"])
    for found, body in zip(names, eyes):
        world_from_camera = body @ camera.body_from_camera
        pixels, depths = camera.project(position, world_from_camera)
        x, y = pixels[:, 0], pixels[:, 1]
        inside = (depths >= camera.clip[0]) & (x >= -0.5) & (x < 319.5) & (y >= -0.5) & (y < 199.5)
        centre = world_from_camera[:3, 3]
        faces_camera = (normal * (centre - position)).sum(axis=1) > 0
        free = ~crosses(centre, position, triangles)
        expected = np.where(~inside, "outside_view", np.where(free, "seen", np.where(faces_camera, "hidden", "faces_away")))
        lost = np.isin(found, ["outside_view", "hidden", "faces_away"])
        # Points on an edge, or at the border of the image, may differ by rounding.
        assert (np.where(lost, found, "seen") != expected).mean() < 0.001
    assert 0.1 < (names == "hidden").mean() and (names == "faces_away").any() and (names == "outside_view").any()
