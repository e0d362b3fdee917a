"""Compressed video: one packet for each image."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import depthai as dai
import numpy as np

from .._findings import Error

_Properties = dai.VideoEncoderProperties
_Encoded = dai.EncodedFrame
# The codec of PyAV, and the profile of the stream.
_CODECS: dict[Any, tuple[str, str]] = {
    _Properties.Profile.H264_BASELINE: ("libx264", "baseline"),
    _Properties.Profile.H264_MAIN: ("libx264", "main"),
    _Properties.Profile.H264_HIGH: ("libx264", "high"),
    _Properties.Profile.H265_MAIN: ("libx265", "main"),
}


class Video:
    """A stream of H.264 or H.265 by PyAV, which has a packet for each image, without waiting for later ones.

    bitrate: bits per second, or 0 for the encoder's own quality.
    keyframes: the number of frames from one key frame to the next.
    """

    def __init__(self, profile: Any, rate: float, bitrate: int, keyframes: int) -> None:
        try:
            import av
        except ImportError as error:
            raise Error(f"VideoEncoder: the profile {profile.name} needs PyAV; install it: pip install av, or use MJPEG") from error
        self._av: Any = av
        self._codec, self._profile = _CODECS[profile]
        self._rate, self._bitrate, self._keyframes = Fraction(rate).limit_denominator(1000), bitrate, max(keyframes, 1)
        self._context: Any = None
        self._count = 0
        self.profile = _Encoded.Profile.HEVC if self._codec == "libx265" else _Encoded.Profile.AVC

    def encode(self, bgr: Any) -> tuple[bytes, Any]:
        """The bytes of one image, (H, W, 3) BGR or (H, W) grey uint8 with even sizes, and the kind of its frame."""
        height, width = bgr.shape[:2]
        if self._context is None:
            self._open(width, height)
        image = np.ascontiguousarray(bgr)
        frame = self._av.VideoFrame.from_ndarray(image, format="gray" if image.ndim == 2 else "bgr24").reformat(format="yuv420p")
        frame.pts = self._count
        self._count += 1
        packets = self._context.encode(frame)
        is_key = any(packet.is_keyframe for packet in packets)
        return b"".join(bytes(packet) for packet in packets), _Encoded.FrameType.I if is_key else _Encoded.FrameType.P

    def _open(self, width: int, height: int) -> None:
        if width % 2 or height % 2:
            raise Error(f"VideoEncoder: the size {width}x{height} is odd; video needs even sizes")
        context = self._av.CodecContext.create(self._codec, "w")
        context.width, context.height, context.pix_fmt = width, height, "yuv420p"
        context.framerate, context.time_base = self._rate, 1 / self._rate
        context.gop_size, context.max_b_frames = self._keyframes, 0
        context.options = {"profile": self._profile, "tune": "zerolatency", "preset": "veryfast"}
        if self._codec == "libx265":
            context.options |= {"x265-params": "log-level=none:pools=none:frame-threads=1"}
        if self._bitrate:
            context.bit_rate = self._bitrate
        self._context = context
