"""Frames that take time, and devices on moving prims."""

import math
import pickle

import numpy as np
import pytest

import oaktwin

SIZE = (320, 200)
STAGE = """#usda 1.0
(
    metersPerUnit = 1
    upAxis = "Z"
    startTimeCode = 0
    endTimeCode = 10
)
def Xform "Arm"
{
    float xformOp:rotateZ.timeSamples = { 0: 0, 10: 90 }
    uniform token[] xformOpOrder = ["xformOp:rotateZ"]
    def Xform "Hand"
    {
        double3 xformOp:translate = (2, 0, 1)
        uniform token[] xformOpOrder = ["xformOp:translate"]
    }
}
def Cube "Box"
{
    double size = 0.5
}
"""


@pytest.fixture(scope="module")
def device():
    return oaktwin.Device("OAK-D Pro PoE")


@pytest.fixture(scope="module")
def rod():
    """A rod of 60 mm, 2 m ahead."""
    corners = [(2, y, z) for y in (-0.03, 0.03) for z in (-5, 5)]
    return oaktwin.Scene.from_triangles(np.array(corners, float), np.array([(0, 1, 2), (1, 3, 2)]))


def rig(device, **options):
    return oaktwin.Rig(device, cameras=["left"], size=SIZE, annotators=["rgb", "distance_to_image_plane"], **options)


def test_exposure_blurs_by_the_way(device, rod):
    """A rod that passes at 3 m/s for 10 ms is longer by fx · 30 mm / 2 m; its depth is that of the middle."""
    pose = rod.look_at((0, 0, 0), (1, 0, 0), device)
    shot = rig(device, exposure_ms=10).shoot(rod, pose, velocity=(0, 3, 0, 0, 0, 0), frame=0)["left"]
    still = rig(device).shoot(rod, pose, frame=0)["left"]
    fx = rig(device).cameras["left"].K[0, 0]
    sharp = still["rgb"][100, :, 3] > 0
    blurred = shot["rgb"][100, :, 3] / 255
    assert abs(blurred.sum() - sharp.sum()) < 1
    way = fx * 0.03 / 2
    assert abs(np.count_nonzero(blurred) - (fx * 0.06 / 2 + way)) < 3
    np.testing.assert_array_equal(shot["distance_to_image_plane"], still["distance_to_image_plane"])


def test_a_frame_without_motion_is_a_moment(device, rod):
    pose = rod.look_at((0, 0, 0), (1, 0, 0), device)
    exposed = rig(device, exposure_ms=10).shoot(rod, pose, frame=0)["left"]
    resting = rig(device, exposure_ms=10).shoot(rod, pose, velocity=[0] * 6, frame=0)["left"]
    still = rig(device).shoot(rod, pose, frame=0)["left"]
    for shot in (exposed, resting):
        np.testing.assert_array_equal(shot["rgb"], still["rgb"])


def test_pickles_keep_the_shutter(device, rod):
    made = rig(device, exposure_ms=4, readout_ms=12)
    assert made.spec["shutter"] == {"exposure_ms": 4.0, "readout_ms": 12.0}
    assert pickle.loads(pickle.dumps(made)).spec == made.spec
    assert "shutter" not in rig(device).spec


@pytest.mark.parametrize(
    ("options", "velocity", "part"),
    [
        ({"exposure_ms": -1}, None, "out of range"),
        ({"exposure_ms": math.nan}, None, "out of range"),
        ({"readout_ms": 1e9}, None, "out of range"),
        ({}, [0, 1, 0, 0, 0, 0], "take no time"),
        ({"exposure_ms": 5}, [0, math.inf, 0, 0, 0, 0], "not finite"),
    ],
)
def test_rejects(device, rod, options, velocity, part):
    with pytest.raises(oaktwin.Error, match=part):
        made = rig(device, **options)
        made.shoot(rod, rod.look_at((0, 0, 0), (1, 0, 0), device), velocity=velocity)


def test_a_device_follows_its_prim(tmp_path, device):
    path = tmp_path / "stage.usda"
    path.write_text(STAGE)
    scene = oaktwin.Scene.open(path, time=0, mount="/Arm/Hand")
    np.testing.assert_allclose(scene.world_from_mount[:3, 3], (2, 0, 1))
    scene.set_time(10)
    mount = scene.world_from_mount
    np.testing.assert_allclose(mount[:3, 3], (0, 2, 1), atol=1e-12)
    np.testing.assert_allclose(mount[:3, 0], (0, 1, 0), atol=1e-12)
    # The hand looks outwards; turned back by half a turn, the device sees the box.
    back = np.diag([-1.0, -1, 1, 1])
    depth = rig(device).shoot(scene, mount @ back)["left"]["distance_to_image_plane"]
    assert np.isfinite(depth).any()
    again = pickle.loads(pickle.dumps(scene))
    np.testing.assert_array_equal(again.world_from_mount, mount)
    assert oaktwin.Scene.open(path).world_from_mount is None
    with pytest.raises(oaktwin.Error, match="/Arm/Hnad"):
        oaktwin.Scene.open(path, mount="/Arm/Hnad")
