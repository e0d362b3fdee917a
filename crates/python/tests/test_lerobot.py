"""The package `lerobot_camera_oaktwin`: a simulated OAK that LeRobot finds by its type."""

import sys
from pathlib import Path

import numpy as np
import pytest

import oaktwin

pytest.importorskip("lerobot.cameras", reason="LeRobot is not installed, which requires Python 3.12: pip install lerobot")
FOLDER = Path(__file__).parents[3] / "lerobot_camera_oaktwin"


@pytest.fixture
def cameras(monkeypatch, tmp_path):
    monkeypatch.syspath_prepend(str(FOLDER))
    import lerobot_camera_oaktwin  # noqa: F401
    from lerobot.cameras import CameraConfig
    from lerobot.cameras.utils import make_cameras_from_configs

    wall = "v 0 -3 -3\nv 0 3 -3\nv 0 3 3\nv 0 -3 3\nf 1 2 3 4\n"
    (tmp_path / "wall.obj").write_text(wall)

    def make(**options):
        kind = CameraConfig.get_choice_class("oaktwin")
        config = kind(scene=str(tmp_path / "wall.obj"), eye=[2, 0, 0], target=[0, 0, 0], fps=200, **options)
        return make_cameras_from_configs({"front": config})["front"]

    return make


@pytest.mark.filterwarnings("ignore::oaktwin.FindingWarning")
def test_frames_of_a_scene(cameras):
    from lerobot.utils.errors import DeviceAlreadyConnectedError, DeviceNotConnectedError

    # A plain wall has no texture to match.
    camera = cameras(width=320, height=200, sensor={"parameters": {"confidenceThreshold": 0}})
    assert not camera.is_connected
    with pytest.raises(DeviceNotConnectedError):
        camera.read()
    with camera:
        with pytest.raises(DeviceAlreadyConnectedError):
            camera.connect()
        image = camera.read()
        assert image.shape == (200, 320, 3) and image.dtype == np.uint8
        depth = camera.read_depth()
        assert depth.dtype == np.uint16
        middle = depth[80:120, 140:180]
        assert abs(np.median(middle[middle > 0]) - 2000) < 60
        # Each frame has its own noise, and the device can be moved.
        camera.async_read()
        assert not np.array_equal(camera.read_depth(), depth)
        camera.world_from_body = camera.scene.look_at((1, 0, 0), (0, 0, 0), oaktwin.Device("OAK-D Lite"))
        camera.read()
        middle = camera.read_depth()[80:120, 140:180]
        assert abs(np.median(middle[middle > 0]) - 1000) < 30
        assert np.array_equal(camera.read_latest().shape, image.shape)
    assert not camera.is_connected
    assert {"type": "oaktwin", "name": "OAK-D Lite", "id": "OAK-D Lite"} in camera.find_cameras()


@pytest.mark.filterwarnings("ignore::oaktwin.FindingWarning")
def test_what_is_wrong(cameras):
    camera = cameras(use_depth=False, width=64, height=40)
    camera.connect()
    with pytest.raises(oaktwin.Error, match="use_depth: .* has no depth"):
        camera.read_depth()
    camera.fps, camera._due = 1, camera._due + 10
    with pytest.raises(TimeoutError, match="no frame within 1 ms"):
        camera.async_read(timeout_ms=1)
    with pytest.raises(ValueError, match="OAK9"):
        cameras(model="OAK9")
