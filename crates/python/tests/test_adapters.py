"""Cameras and poses of other libraries."""

from types import SimpleNamespace

import numpy as np
import pytest

import oaktwin
from open3d_import import open3d

DISTORTED = {"distortion": [0.1, -0.02, 0.001, 0.002, 0.01]}


@pytest.mark.parametrize("options", [{}, DISTORTED, {"distortion": [0.1] * 8}, {"distortion": [0.1, 0.01], "lens": "fisheye"}])
def test_ros(options):
    camera = oaktwin.Camera((64, 48), hfov_deg=60, **options)
    fields = camera.to_ros()
    for info in [fields, SimpleNamespace(**fields), {key.upper() if len(key) == 1 else key: value for key, value in fields.items()}]:
        assert oaktwin.Camera.from_ros(info) == camera
    assert len(fields["p"]) == 12 and fields["width"] == 64


def test_cameras_that_others_do_not_have():
    prism = oaktwin.Camera((64, 48), hfov_deg=60, distortion=[0.1] * 12)
    with pytest.raises(oaktwin.Error, match="its lens .opencv. is not one of ROS's"):
        prism.to_ros()
    for call in [prism.to_open3d, prism.to_mujoco]:
        with pytest.raises(oaktwin.Error, match="pass a pinhole"):
            call()
    with pytest.raises(oaktwin.Error, match="info: has no distortion_model"):
        oaktwin.Camera.from_ros({})
    with pytest.raises(oaktwin.Error, match="intrinsic: int has no intrinsic_matrix"):
        oaktwin.Camera.from_open3d(3)
    with pytest.raises(oaktwin.Error, match="model: int has no cameras"):
        oaktwin.Camera.from_mujoco(3, "left")


def test_open3d(device):
    camera = device.depth_camera()
    made = SimpleNamespace(**camera.to_open3d())
    assert np.array_equal(oaktwin.Camera.from_open3d(made).K, camera.K)
    real = open3d().camera.PinholeCameraIntrinsic(**camera.to_open3d())
    assert np.allclose(oaktwin.Camera.from_open3d(real).K, camera.K)


def test_mujoco():
    mujoco = pytest.importorskip("mujoco")
    camera = oaktwin.Camera((64, 48), K=[[70, 0, 30.2], [0, 71, 25.1], [0, 0, 1]])
    spec = mujoco.MjSpec()
    pose = oaktwin.look_at((1, 2, 0.5), (0, 0, 0))
    body = spec.worldbody.add_body(name="robot")
    added = body.add_camera(name="left", **camera.to_mujoco())
    added.pos = pose[:3, 3]
    quaternion = np.empty(4)
    mujoco.mju_mat2Quat(quaternion, pose.to("mujoco")[:3, :3].ravel())
    added.quat = quaternion
    body.add_camera(name="simple", fovy=60)
    model = spec.compile()
    assert np.allclose(oaktwin.Camera.from_mujoco(model, "left").K, camera.K, atol=1e-4)
    simple = oaktwin.Camera.from_mujoco(model, "simple", size=(64, 48))
    assert simple.vfov_deg == pytest.approx(60) and simple.K[0, 2] == 31.5
    with pytest.raises(oaktwin.Error, match="size: the camera simple has no resolution"):
        oaktwin.Camera.from_mujoco(model, "simple")
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = data.camera("left").xmat.reshape(3, 3), data.camera("left").xpos
    assert np.allclose(oaktwin.CameraPose.of(matrix, "mujoco"), pose)


@pytest.mark.parametrize("convention", ["opengl", "mujoco", "ros", "open3d"])
def test_conventions_of_poses(convention):
    pose = oaktwin.look_at((1, 2, 3), (0.5, 0, 0))
    for one in [pose, np.stack([pose, pose])]:
        other = one.to(convention)
        assert type(other) is np.ndarray
        back = oaktwin.CameraPose.of(other, convention)
        assert type(back) is oaktwin.CameraPose and np.allclose(back, one)
    if convention == "ros":
        assert np.allclose(pose.to("ros"), oaktwin.look_at((1, 2, 3), (0.5, 0, 0), frame="body"))
    with pytest.raises(oaktwin.Error, match="convention: invalid value 'usd'; pass opengl, mujoco, ros or open3d"):
        pose.to("usd")


def test_isaac_lab():
    """Isaac Lab's own intrinsic matrix, but for the half pixel between its convention and OpenCV's."""
    from types import SimpleNamespace as Cfg

    spawn = Cfg(focal_length=24.0, horizontal_aperture=20.955, vertical_aperture=None, horizontal_aperture_offset=0.0)
    camera = oaktwin.Camera.from_isaac(Cfg(width=640, height=480, spawn=spawn))
    assert camera.size == (640, 480)
    assert np.allclose(camera.K, [[640 * 24 / 20.955, 0, 319.5], [0, 640 * 24 / 20.955, 239.5], [0, 0, 1]])
    wide = {"focal_length": 10.0, "horizontal_aperture": 20.0, "vertical_aperture": 10.0}
    assert np.allclose(np.diag(oaktwin.Camera.from_isaac(wide, size=(200, 150)).K), [100, 150, 1])
    pattern = Cfg(focal_length=24.0, horizontal_aperture=20.955, width=64, height=48)
    assert oaktwin.Camera.from_isaac(Cfg(pattern_cfg=pattern)).size == (64, 48)
    for wrong, message in [
        (Cfg(spawn=None), "cfg: SimpleNamespace has no focal_length"),
        (wide, "size: the configuration has no width and height"),
        (Cfg(width=6, height=4, spawn=Cfg(focal_length=1, horizontal_aperture=1, vertical_aperture_offset=0.1)), "aperture offset"),
    ]:
        with pytest.raises(oaktwin.Error, match=message):
            oaktwin.Camera.from_isaac(wrong)
