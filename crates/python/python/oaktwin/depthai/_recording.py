"""Recordings in the format of DepthAI's holistic replay: a real device takes the images of a virtual one for its own."""

from __future__ import annotations

import time
from os import PathLike, fspath
from pathlib import Path
from typing import Any

import depthai as dai

from .._findings import Error
from ._frames import Type
from ._virtual import virtual_device

_Profile = dai.VideoEncoderProperties.Profile
# Stereo cameras match what compression leaves of the texture.
_QUALITY = 97
_IMU_RATE, _IMU_BATCH = 400, 20
# Seconds between two looks at whether the recorders have taken all that was sent.
_STEP_S = 0.02


def record(
    folder: str | PathLike[str],
    model_or_calibration: Any,
    *,
    seconds: float,
    fps: float = 30.0,
    sizes: dict[str, tuple[int, int]] | None = None,
    projector: float = 0.0,
    **world: Any,
) -> Path:
    """Records all cameras and the inertial sensor of a virtual device for `dai.Pipeline.enableHolisticReplay`, and returns the folder.

    folder: is created; for each camera it gets CameraCAM_X.mp4 (MJPEG) and .mcap, IMU.mcap, record_config.json and calibration.json.
    model_or_calibration: as for `virtual_device`.
    seconds: the length.
    fps: the images per second, a whole number.
    sizes: the sizes of the images, (width, height) px, by the roles of cameras: "rgb", "left", "right"; by default the sensors', even.
    projector: the intensity of the dot projector, from 0 to 1.
    world: scene, pose, look_at, update, seed and ambient of `virtual_device`.

    Raises oaktwin.Error for invalid arguments and for a folder that has files. Needs OpenCV.
    """
    target = Path(fspath(folder))
    if target.exists() and (not target.is_dir() or any(target.iterdir())):
        raise Error(f"{target}: it exists and is not an empty folder; choose another one")
    if not 0 < seconds < 1e6 or not 0 < fps <= 1000 or fps != round(fps):
        raise Error(f"seconds, fps: {seconds} and {fps}; pass a positive time and a positive whole rate")
    with virtual_device(model_or_calibration, fast=True, **world) as virtual:
        twin = virtual._twin
        unknown = set(sizes or {}) - {role for role, _ in twin.cameras.values()}
        if unknown:
            raise Error(f"sizes: {twin.device.name} has no camera {min(unknown)}; it has {', '.join(sorted(twin.device.cameras))}")
        twin.clock.end = seconds
        twin.light.dots = projector
        target.mkdir(parents=True, exist_ok=True)
        config = dai.RecordConfig()
        config.outputDir = target
        config.videoEncoding.enabled, config.videoEncoding.profile, config.videoEncoding.quality = True, _Profile.MJPEG, _QUALITY
        with dai.Pipeline() as pipeline:
            for socket, (role, lens) in twin.cameras.items():
                if role == "tof":
                    continue
                width, height = (sizes or {}).get(role, lens.size)
                camera = pipeline.create(dai.node.Camera).build(socket)
                camera.requestOutput((width // 2 * 2, height // 2 * 2), Type.NV12, fps=fps)
            if twin.report.get("imu"):
                imu = pipeline.create(dai.node.IMU)
                imu.enableIMUSensor([dai.IMUSensor.ACCELEROMETER_RAW, dai.IMUSensor.GYROSCOPE_RAW], _IMU_RATE)
                imu.setBatchReportThreshold(_IMU_BATCH)
                imu.setMaxBatchReports(_IMU_BATCH)
            pipeline.enableHolisticRecord(config)
            pipeline.start()
            _wait(pipeline)
    return target


def _wait(pipeline: Any) -> None:
    """Waits until the sensors have sent everything and the recorders have taken it."""
    while pipeline.isRunning():
        sources = [node for node in pipeline._nodes if getattr(node, "is_source", False)]
        ports = [port for node in pipeline._nodes for port in node.getInputs()]
        if all(node.has_ended for node in sources) and not any(port.getSize() for port in ports):
            # What is no longer in a queue is being written.
            time.sleep(10 * _STEP_S)
            if not any(port.getSize() for port in ports):
                return
        time.sleep(_STEP_S)
