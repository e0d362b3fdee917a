"""Recordings for the holistic replay of real devices, read back by DepthAI's own nodes."""

import json
import subprocess
import sys

import numpy as np
import pytest

dai = pytest.importorskip("depthai")
cv2 = pytest.importorskip("cv2")

import oaktwin  # noqa: E402
from oaktwin.depthai import record, virtual_device  # noqa: E402
from virtual_scene import MODEL, textured_scene  # noqa: E402

FPS, SECONDS, SIZE = 20, 0.5, (160, 100)
NAMES = ["CameraCAM_A", "CameraCAM_B", "CameraCAM_C"]


def to_the_left(seconds):
    pose = np.eye(4)
    pose[1, 3] = 0.2 * seconds
    return pose


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    folder = tmp_path_factory.mktemp("recordings") / "walk"
    sizes = dict.fromkeys(("rgb", "left", "right"), SIZE)
    return record(folder, MODEL, seconds=SECONDS, fps=FPS, sizes=sizes, scene=textured_scene(), pose=to_the_left)


def read(pipeline, replay, count):
    """The first messages of a replay. It is repeated, because its end closes the queue, with all that has not been read."""
    replay.setLoop(True)
    queue = replay.out.createOutputQueue(maxSize=100, blocking=True)
    pipeline.start()
    return [queue.get() for _ in range(count)]


def test_files(folder):
    assert sorted(path.name for path in folder.iterdir()) == sorted(
        [f"{name}.{kind}" for name in NAMES for kind in ("mp4", "mcap")] + ["IMU.mcap", "calibration.json", "record_config.json"]
    )
    handler = dai.CalibrationHandler(folder / "calibration.json")
    assert handler.getBaselineDistance() == pytest.approx(7.5, abs=1e-4)
    config = json.loads((folder / "record_config.json").read_text())
    assert config["videoEncoding"]["profile"] == "MJPEG" and config["videoEncoding"]["enabled"]


@pytest.mark.parametrize("name", NAMES)
def test_images_are_those_of_the_virtual_device(folder, name):
    with dai.Pipeline(createImplicitDevice=False) as pipeline:
        replay = pipeline.create(dai.node.ReplayVideo)
        replay.setReplayVideoFile(folder / f"{name}.mp4")
        replay.setReplayMetadataFile(folder / f"{name}.mcap")
        replay.setOutFrameType(dai.ImgFrame.Type.NV12)
        frames = read(pipeline, replay, 10)
    assert cv2.VideoCapture(str(folder / f"{name}.mp4")).get(cv2.CAP_PROP_FRAME_COUNT) == 10
    assert [frame.getTimestampDevice().total_seconds() for frame in frames] == pytest.approx(np.arange(10) / FPS, abs=1e-6)
    assert [frame.getSequenceNum() for frame in frames] == list(range(10))
    with virtual_device(MODEL, scene=textured_scene(), pose=to_the_left, fast=True), dai.Pipeline() as pipeline:
        camera = pipeline.create(dai.node.Camera).build(getattr(dai.CameraBoardSocket, name.removeprefix("Camera")))
        queue = camera.requestOutput(SIZE, dai.ImgFrame.Type.NV12, fps=FPS).createOutputQueue(maxSize=100, blocking=True)
        pipeline.start()
        expected = [queue.get() for _ in range(10)]
    for frame, one in zip(frames, expected):
        assert frame.getInstanceNum() == one.getInstanceNum()
        assert np.abs(frame.getCvFrame().astype(int) - one.getCvFrame()).mean() < 4
        assert np.allclose(frame.getTransformation().getIntrinsicMatrix(), one.getTransformation().getIntrinsicMatrix())


def test_the_inertial_sensor(folder):
    with dai.Pipeline(createImplicitDevice=False) as pipeline:
        replay = pipeline.create(dai.node.ReplayMetadataOnly)
        replay.setReplayFile(folder / "IMU.mcap")
        packets = [packet for message in read(pipeline, replay, 20) for packet in message.packets]
    times = [packet.acceleroMeter.getTimestampDevice().total_seconds() for packet in packets]
    end = 1 + int(np.argmax(np.diff(times) < 0))
    packets, times = packets[:end], times[:end]
    assert times == pytest.approx(np.arange(len(times)) / 400, abs=1e-5) and times[-1] == pytest.approx(SECONDS, abs=0.06)
    force = [[getattr(packet.acceleroMeter, axis) for axis in "xyz"] for packet in packets]
    assert np.linalg.norm(np.mean(force, axis=0)) == pytest.approx(9.81, rel=0.02)


def test_holistic_recording_of_a_program(tmp_path):
    with virtual_device(MODEL, scene=textured_scene(), fast=True), dai.Pipeline() as pipeline:
        config = dai.RecordConfig()
        config.outputDir = tmp_path
        pipeline.enableHolisticRecord(config)
        queue = pipeline.create(dai.node.Camera).build(dai.CameraBoardSocket.CAM_B).requestOutput(SIZE).createOutputQueue()
        pipeline.start()
        for _ in range(15):
            queue.get()
    assert {path.name for path in tmp_path.iterdir()} >= {"CameraCAM_B.mp4", "CameraCAM_B.mcap", "record_config.json", "calibration.json"}


def test_the_command_line(tmp_path):
    textured_scene().save_usd(tmp_path / "scene.usda")
    command = [sys.executable, "-m", "oaktwin.depthai", "--model", "OAK-D ToF", "--scene", "scene.usda", "--record", "out"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, encoding="utf-8")
    assert done.returncode == 2 and "--record takes --seconds, and no program" in done.stderr
    done = subprocess.run([*command, "--seconds", "0.1", "--fps", "10"], cwd=tmp_path, capture_output=True, text=True, encoding="utf-8")
    assert done.returncode == 0, done.stderr
    assert {"CameraCAM_B.mp4", "CameraCAM_C.mp4", "calibration.json"} <= {path.name for path in (tmp_path / "out").iterdir()}


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"seconds": 0}, "pass a positive time and a positive whole rate"),
        ({"fps": 12.5}, "pass a positive time and a positive whole rate"),
        ({"sizes": {"tof": (640, 480)}}, "OAK-D Pro PoE has no camera tof"),
    ],
)
def test_arguments(tmp_path, arguments, message):
    with pytest.raises(oaktwin.Error, match=message):
        record(tmp_path / "out", MODEL, **{"seconds": 1, "scene": textured_scene(), **arguments})


def test_a_folder_with_files_is_kept(tmp_path):
    (tmp_path / "notes.txt").write_text("keep")
    with pytest.raises(oaktwin.Error, match="is not an empty folder"):
        record(tmp_path, MODEL, seconds=1, scene=textured_scene())
