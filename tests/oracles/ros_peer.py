"""ROS 2 messages over Eclipse Cyclone DDS, without ROS: an independent peer of `oaktwin bridge` on the loopback interface."""

import argparse
import json
import os
import struct
import sys
import threading
import time
from dataclasses import dataclass, field
from pathlib import Path

from ros_network import DOMAIN

# Discovery without multicast in one machine, Cyclone's own between machines, and room for a burst of datagrams.
LOCAL = """<General><Interfaces><NetworkInterface address="127.0.0.1" multicast="false"/></Interfaces><AllowMulticast>false</AllowMulticast></General>
<Discovery><ParticipantIndex>auto</ParticipantIndex><MaxAutoParticipantIndex>9</MaxAutoParticipantIndex>
<Peers><Peer address="127.0.0.1"/></Peers></Discovery>"""
os.environ["CYCLONEDDS_URI"] = """<CycloneDDS><Domain>%s
<Internal><SocketReceiveBufferSize min="%s"/></Internal>
</Domain></CycloneDDS>""" % ("" if os.environ.get("ROS_LOCALHOST_ONLY") == "0" else LOCAL, os.environ.get("OAKTWIN_PEER_BUFFER", "4MB"))

import numpy as np
from cyclonedds._clayer import ddspy_take, ddspy_write
from cyclonedds.core import Policy, Qos
from cyclonedds.domain import DomainParticipant
from cyclonedds.idl import IdlStruct
from cyclonedds.idl.annotations import final
from cyclonedds.idl.types import array, float64, int32, sequence, uint8, uint32
from cyclonedds.pub import DataWriter
from cyclonedds.sub import DataReader
from cyclonedds.topic import Topic
from cyclonedds.util import duration


@final
@dataclass
class Time(IdlStruct, typename="builtin_interfaces::msg::dds_::Time_"):
    sec: int32 = 0
    nanosec: uint32 = 0


@final
@dataclass
class Header(IdlStruct, typename="std_msgs::msg::dds_::Header_"):
    stamp: Time = field(default_factory=Time)
    frame_id: str = ""


@final
@dataclass
class Image(IdlStruct, typename="sensor_msgs::msg::dds_::Image_"):
    header: Header = field(default_factory=Header)
    height: uint32 = 0
    width: uint32 = 0
    encoding: str = ""
    is_bigendian: uint8 = 0
    step: uint32 = 0
    data: sequence[uint8] = b""


@final
@dataclass
class RegionOfInterest(IdlStruct, typename="sensor_msgs::msg::dds_::RegionOfInterest_"):
    x_offset: uint32 = 0
    y_offset: uint32 = 0
    height: uint32 = 0
    width: uint32 = 0
    do_rectify: bool = False


@final
@dataclass
class CameraInfo(IdlStruct, typename="sensor_msgs::msg::dds_::CameraInfo_"):
    header: Header = field(default_factory=Header)
    height: uint32 = 0
    width: uint32 = 0
    distortion_model: str = "plumb_bob"
    d: sequence[float64] = field(default_factory=lambda: [0.0] * 5)
    k: array[float64, 9] = field(default_factory=lambda: [0.0] * 9)
    r: array[float64, 9] = field(default_factory=lambda: [1.0, 0, 0, 0, 1.0, 0, 0, 0, 1.0])
    p: array[float64, 12] = field(default_factory=lambda: [0.0] * 12)
    binning_x: uint32 = 0
    binning_y: uint32 = 0
    roi: RegionOfInterest = field(default_factory=RegionOfInterest)


@final
@dataclass
class PointField(IdlStruct, typename="sensor_msgs::msg::dds_::PointField_"):
    name: str = ""
    offset: uint32 = 0
    datatype: uint8 = 0
    count: uint32 = 0


@final
@dataclass
class PointCloud2(IdlStruct, typename="sensor_msgs::msg::dds_::PointCloud2_"):
    header: Header = field(default_factory=Header)
    height: uint32 = 0
    width: uint32 = 0
    fields: sequence[PointField] = field(default_factory=list)
    is_bigendian: bool = False
    point_step: uint32 = 0
    row_step: uint32 = 0
    data: sequence[uint8] = b""
    is_dense: bool = False


def qos(*, reliable: bool = False, latched: bool = False, depth: int = 1) -> Qos:
    """ROS's profile of sensor data, of a reliable topic, or of one whose last message is kept for late subscribers."""
    reliability = Policy.Reliability.Reliable(duration(milliseconds=100)) if reliable else Policy.Reliability.BestEffort
    durability = Policy.Durability.TransientLocal if latched else Policy.Durability.Volatile
    return Qos(reliability, durability, Policy.History.KeepLast(depth))


class Peer:
    """A participant with topics of ROS."""

    def __init__(self) -> None:
        self.participant = DomainParticipant(DOMAIN)

    def publisher(self, topic: str, message: type, **profile) -> DataWriter:
        return DataWriter(self.participant, Topic(self.participant, "rt" + topic, message), qos=qos(**profile))

    def subscription(self, topic: str, message: type, **profile) -> DataReader:
        return DataReader(self.participant, Topic(self.participant, "rt" + topic, message), qos=qos(**profile))


class Raw(bytes):
    """A message that is serialized already: Cyclone's Python types take 0.1 s for an image of 2 MB."""

    def serialize(self, **_) -> bytes:
        return self


def raw_image(header: Header, width: int, height: int, encoding: str, data: bytes) -> Raw:
    """An image without padding between its rows."""
    head = Image(header, height, width, encoding, 0, len(data) // height, b"").serialize()
    # The length of the data comes last.
    return Raw(head[:-4] + len(data).to_bytes(4, "little") + data)


def write(writer: DataWriter, message: Raw) -> None:
    result = ddspy_write(writer._ref, message.ljust(len(message) + -len(message) % 4, b"\0"))
    assert result >= 0, result


def stamp_of(message: bytes) -> float:
    """The time of a serialized message that begins with a header, seconds."""
    sec, nanosec = struct.unpack_from("<iI", message, 4)
    return sec + nanosec * 1e-9


def take_raw(reader: DataReader) -> list[bytes]:
    """The serialized messages that have arrived."""
    taken = ddspy_take(reader._ref, 0, 100)
    return [data for data, info in taken if info.valid_data]


@final
@dataclass
class CompressedImage(IdlStruct, typename="sensor_msgs::msg::dds_::CompressedImage_"):
    header: Header = field(default_factory=Header)
    format: str = ""
    data: sequence[uint8] = b""


@final
@dataclass
class Vector3(IdlStruct, typename="geometry_msgs::msg::dds_::Vector3_"):
    x: float64 = 0
    y: float64 = 0
    z: float64 = 0


@final
@dataclass
class Quaternion(IdlStruct, typename="geometry_msgs::msg::dds_::Quaternion_"):
    x: float64 = 0
    y: float64 = 0
    z: float64 = 0
    w: float64 = 1


@final
@dataclass
class Transform(IdlStruct, typename="geometry_msgs::msg::dds_::Transform_"):
    translation: Vector3 = field(default_factory=Vector3)
    rotation: Quaternion = field(default_factory=Quaternion)


@final
@dataclass
class TransformStamped(IdlStruct, typename="geometry_msgs::msg::dds_::TransformStamped_"):
    header: Header = field(default_factory=Header)
    child_frame_id: str = ""
    transform: Transform = field(default_factory=Transform)


@final
@dataclass
class TFMessage(IdlStruct, typename="tf2_msgs::msg::dds_::TFMessage_"):
    transforms: sequence[TransformStamped] = field(default_factory=list)


MESSAGES = {"image": Image, "points": PointCloud2, "info": CameraInfo, "compressed": CompressedImage, "tf": TFMessage}


def now() -> Header:
    time_ns = time.time_ns()
    return Header(Time(time_ns // 10**9, time_ns % 10**9), "sim_depth_optical")


def end_of_input() -> threading.Event:
    """An event that is set once the standard input has ended."""
    ended = threading.Event()

    def read() -> None:
        sys.stdin.read()
        ended.set()

    threading.Thread(target=read, daemon=True).start()
    return ended


def publish(arguments: argparse.Namespace) -> dict:
    """Publishes depth images of a slope and their camera info at a steady rate, until the input ends."""
    peer = Peer()
    images = peer.publisher(arguments.topic, Image)
    infos = peer.publisher(arguments.info, CameraInfo)
    width, height = map(int, arguments.size.split("x"))
    metres = np.tile(np.linspace(0.8, 4.0, width, dtype=np.float32), (height, 1))
    # Texture on the left, a plain colour on the right.
    rgb = np.full((height, width, 3), [200, 90, 30], np.uint8)
    rgb[:, : width // 2] = np.random.default_rng(0).integers(0, 256, (height, width // 2, 3))
    colors = peer.publisher(arguments.rgb, Image) if arguments.rgb else None
    if arguments.color:
        np.save(arguments.color, rgb)
    data = metres.tobytes() if arguments.encoding == "32FC1" else (metres * 1000).astype("<u2").tobytes()
    focal = 0.625 * width
    k = [focal, 0, (width - 1) / 2, 0, focal, (height - 1) / 2, 0, 0, 1]
    if arguments.depth:
        np.save(arguments.depth, metres if arguments.encoding == "32FC1" else (metres * 1000).astype(np.uint16))
    print("ready", flush=True)
    writers = [writer for writer in (images, infos, colors) if writer]
    while arguments.matched and not all(writer.get_matched_subscriptions() for writer in writers):
        time.sleep(0.01)
    time.sleep(arguments.wait)
    ended = end_of_input()
    last = round(arguments.seconds * arguments.rate) if arguments.seconds else sys.maxsize
    start, count = time.monotonic(), 0
    while count < last:
        if ended.is_set() and not arguments.seconds:
            # A second more, for what begins with the last request.
            last = min(last, count + round(arguments.rate))
        time.sleep(max(0.0, start + count / arguments.rate - time.monotonic()))
        header = now()
        infos.write(CameraInfo(header, height, width, k=k))
        if colors:
            write(colors, raw_image(header, width, height, "rgb8", rgb.tobytes()))
        write(images, raw_image(header, width, height, arguments.encoding, data))
        count += 1
    # A dying writer takes its unsent data with it.
    time.sleep(0.5)
    return {"published": count, "late_s": time.monotonic() - start - 0.5 - (count - 1) / arguments.rate}


def pixels_of(message: Image) -> np.ndarray:
    kind = {"16UC1": "<u2", "32FC1": "<f4"}[message.encoding]
    return np.frombuffer(bytes(message.data), kind).reshape(message.height, message.width)


def subscribe(arguments: argparse.Namespace) -> dict:
    """Receives messages until the input has ended and none arrives any more."""
    peer = Peer()
    profile = {"reliable": arguments.reliable or arguments.latched, "latched": arguments.latched}
    reader = peer.subscription(arguments.topic, MESSAGES[arguments.message], depth=10, **profile)
    if arguments.never:
        time.sleep(3600)
    latencies, farthest, last = [], [], None
    ended, quiet_since = end_of_input(), time.monotonic()
    while not ended.is_set() or time.monotonic() < quiet_since + arguments.silence:
        if not ended.is_set():
            quiet_since = time.monotonic()
        for data in take_raw(reader):
            if not latencies:
                print("ready", flush=True)
            # Transforms have no header.
            latencies.append(time.time() - stamp_of(data) if arguments.message != "tf" else 0)
            if arguments.farthest:
                farthest.append([stamp_of(data), int(pixels_of(Image.deserialize(data)).max())])
            last, quiet_since = data, time.monotonic()
        time.sleep(0.0005)
    result = {"received": len(latencies), "farthest": farthest}
    if latencies:
        median, p95 = np.percentile(latencies, [50, 95]) * 1e3
        result |= {"median_ms": median, "p95_ms": p95}
    if last is not None and arguments.last:
        # Cyclone decodes it, not this module.
        message = MESSAGES[arguments.message].deserialize(last)
        if arguments.message == "tf":
            return result | {"frames": [[one.header.frame_id, one.child_frame_id] for one in message.transforms]}
        result["stamp"] = [message.header.stamp.sec, message.header.stamp.nanosec]
        result["frame_id"] = message.header.frame_id
        if arguments.message == "image":
            np.save(arguments.last, pixels_of(message))
            result |= {"encoding": message.encoding, "step": message.step}
        elif arguments.message == "compressed":
            Path(arguments.last).write_bytes(bytes(message.data)[12:])
            result |= {"format": message.format, "quantization": list(bytes(message.data)[:12])}
        elif arguments.message == "info":
            result |= {"k": list(message.k), "size": [message.width, message.height]}
        else:
            fields = [one.name for one in message.fields]
            result |= {"fields": fields, "point_step": message.point_step, "size": [message.width, message.height]}
            points = np.frombuffer(bytes(message.data), "<f4").reshape(message.height, message.width, -1)
            np.save(arguments.last, points)
    return result


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    commands = parser.add_subparsers(required=True)
    command = commands.add_parser("publish")
    command.set_defaults(run=publish)
    command.add_argument("--topic", default="/camera/depth/image_raw")
    command.add_argument("--info", default="/camera/camera_info")
    command.add_argument("--rgb", help="the topic of colour images")
    command.add_argument("--size", default="160x120")
    command.add_argument("--encoding", default="16UC1")
    command.add_argument("--seconds", type=float, help="instead of until the input ends")
    command.add_argument("--rate", type=float, default=30)
    command.add_argument("--matched", action="store_true", help="wait for subscribers of all topics")
    command.add_argument("--wait", type=float, default=0, help="seconds before the first image")
    command.add_argument("--depth", help="where the published depth is saved")
    command.add_argument("--color", help="where the published colours are saved")
    command = commands.add_parser("subscribe")
    command.set_defaults(run=subscribe)
    command.add_argument("--topic", default="/oak/stereo/image_raw")
    command.add_argument("--message", choices=MESSAGES, default="image")
    command.add_argument("--silence", type=float, default=1, help="seconds without a message that end it after the input has ended")
    command.add_argument("--never", action="store_true", help="never read")
    command.add_argument("--reliable", action="store_true", help="require reliable delivery")
    command.add_argument("--latched", action="store_true", help="require the last message before the subscription, too")
    command.add_argument("--last", help="where the last message is saved")
    command.add_argument("--farthest", action="store_true", help="report the stamp and the largest value of each image")
    arguments = parser.parse_args()
    print(json.dumps(arguments.run(arguments)))


if __name__ == "__main__":
    main()
