"""Holistic recording, as DepthAI calls it: every camera and the inertial sensor of a pipeline into one folder."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

import depthai as dai

from .._findings import Error
from ._frames import Type
from ._imu import IMU

if TYPE_CHECKING:
    from ._twin import Twin


def add_recorders(pipeline: Any, twin: Twin, config: dai.RecordConfig) -> None:
    """Adds a recorder to every camera and inertial sensor of a pipeline, and writes the configuration and the calibration."""
    folder = Path(config.outputDir)
    if not folder.is_dir():
        raise Error(f"Pipeline.enableHolisticRecord: {folder} is not a folder; create it first")
    for node in list(pipeline._nodes):
        if isinstance(node, IMU):
            recorder = pipeline.create(dai.node.RecordMetadataOnly)
            recorder.setRecordFile(folder / "IMU.mcap")
            recorder.setCompressionLevel(config.compressionLevel)
            node.out.link(recorder.input)
        elif getattr(node, "requests", None):
            _add_video(pipeline, node, folder, config)
    encoding = config.videoEncoding
    described = {
        "outputDir": str(folder),
        "videoEncoding": {
            "enabled": encoding.enabled,
            "bitrate": encoding.bitrate,
            "profile": encoding.profile.name,
            "lossless": encoding.lossless,
            "quality": encoding.quality,
        },
        "compressionLevel": int(config.compressionLevel),
        "syncCameraOutputs": config.syncCameraOutputs,
    }
    _write(folder / "record_config.json", described)
    _write(folder / "calibration.json", twin.calibration_json)


def _add_video(pipeline: Any, camera: Any, folder: Path, config: dai.RecordConfig) -> None:
    """Records the largest images that a program requests of a camera, as DepthAI does."""
    largest = max(camera.requests, key=lambda one: one.size[0] * one.size[1])
    rate = max(one.fps for one in camera.requests)
    source = camera.requestOutput(largest.size, Type.NV12, fps=rate)
    recorder = pipeline.create(dai.node.RecordVideo)
    path = folder / f"Camera{camera.socket.name}"
    recorder.setRecordVideoFile(path.with_suffix(".mp4"))
    recorder.setRecordMetadataFile(path.with_suffix(".mcap"))
    recorder.setCompressionLevel(config.compressionLevel)
    recorder.setFps(round(rate))
    if config.videoEncoding.enabled:
        encoding = config.videoEncoding
        encoder = pipeline.create(dai.node.VideoEncoder).build(source, encoding.bitrate, rate, encoding.profile)
        encoder.setQuality(encoding.quality)
        encoder.setLossless(encoding.lossless)
        source = encoder.out
    source.link(recorder.input)


def _write(path: Path, content: Any) -> None:
    # Written beside its target and renamed, so that nothing is left half-written.
    beside = path.with_suffix(".tmp")
    beside.write_text(json.dumps(content, indent=4), "utf-8")
    beside.replace(path)
