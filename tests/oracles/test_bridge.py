"""`oaktwin bridge` over the loopback interface, with Eclipse Cyclone DDS as the publisher and the subscribers."""

import json
import shutil
import subprocess
import time
from collections.abc import Iterator
from pathlib import Path

import cv2
import numpy as np
import pytest

from ros_network import IN_NETWORK, MODEL, Bridge, isolated, lan, result, start_peer, wait_for_peer


@pytest.fixture(scope="module")
def network() -> Iterator[list[str]]:
    with isolated() as start:
        yield start


@pytest.fixture
def run(network, program):
    """Starts bridges and peers, and ends those that still run."""
    processes = []

    class Run:
        def bridge(self, *options: str) -> Bridge:
            bridge = Bridge(network, program, *options)
            processes.append(bridge.process)
            return bridge

        def peer(self, *arguments: str, script: str = "ros_peer.py") -> subprocess.Popen:
            peer = start_peer(network, *arguments, script=script)
            processes.append(peer)
            return peer

        def call(self, *calls: str) -> list[dict]:
            """Calls services of the bridge, such as `get_parameters ["seed"]`."""
            return result(self.peer("/oaktwin_bridge", *calls, script="ros_services.py"))

    yield Run()
    for process in processes:
        process.kill()
        process.wait()


def sensed(program: Path, depth: Path, stamp: list[int], folder: Path, *options: str) -> np.ndarray:
    """What `oaktwin sense` makes of a depth image whose frame is the stamp."""
    image = folder / f"depth_{stamp[0] * 10**9 + stamp[1]}.npy"
    shutil.copy(depth, image)
    focal = str(0.625 * np.load(depth).shape[1])
    subprocess.run(
        [program, "sense", image, "--model", MODEL, "--input-kind", "z", "--fx", focal, "-o", folder, *options],
        check=True,
        capture_output=True,
    )
    (found,) = folder.glob("*depth_sensor_distance*.npy")
    return np.load(found)


def assert_counts(state: dict, published: int, findings: list[dict]) -> None:
    """A busy machine may lose images on the way, or replace them while they wait; at most one waits at the end."""
    assert 0 < state["published"] and state["received"] <= published and state["rejected"] == 0, (state, findings)
    assert 0 <= state["received"] - state["published"] - state["dropped"] <= 1, (state, findings)


@pytest.mark.parametrize("encoding", ["16UC1", "32FC1"])
def test_images_are_those_of_sense(run, program, tmp_path, encoding):
    bridge = run.bridge("--encoding", encoding, "--points")
    depth, last, last_points = (tmp_path / name for name in ("exact.npy", "last.npy", "points.npy"))
    images = run.peer("subscribe", "--last", str(last))
    infos = run.peer("subscribe", "--topic", "/oak/stereo/camera_info", "--message", "info", "--last", str(tmp_path / "info"))
    clouds = run.peer("subscribe", "--topic", "/oak/points", "--message", "points", "--last", str(last_points))
    publisher = run.peer("publish", "--encoding", encoding, "--matched", "--depth", str(depth))
    for subscriber in (images, infos, clouds):
        wait_for_peer(subscriber)
    published = result(publisher)["published"]
    image, info, cloud = result(images), result(infos), result(clouds)
    state, findings = bridge.stop()
    assert_counts(state, published, findings)
    assert image["encoding"] == encoding and image["frame_id"] == info["frame_id"] == "sim_depth_optical"
    assert info["size"] == [160, 120]
    assert np.allclose(info["k"], [100, 0, 79.5, 0, 100, 59.5, 0, 0, 1])

    expected = sensed(program, depth, image["stamp"], tmp_path)
    measured = np.load(last)
    assert (expected > 0).mean() > 0.5
    if encoding == "16UC1":
        assert np.array_equal(measured, np.round(expected * np.float32(1000)).astype(np.uint16))
    else:
        assert np.array_equal(np.isnan(measured), expected == 0)
        assert np.array_equal(np.nan_to_num(measured), expected)

    assert cloud["fields"] == ["x", "y", "z"] and cloud["point_step"] == 12 and cloud["size"] == [160, 120]
    points = np.load(last_points)
    v, u = np.nonzero(points[..., 2] > 0)
    x, y, z = points[v, u].T
    assert len(z) > 1000
    assert np.allclose(x / z * 100 + 79.5, u, atol=1e-3) and np.allclose(y / z * 100 + 59.5, v, atol=1e-3)


def test_subscribers_that_are_late_die_or_never_read(run):
    bridge = run.bridge()
    dying = run.peer("subscribe")
    never = run.peer("subscribe", "--never")
    steady = run.peer("subscribe")
    publisher = run.peer("publish", "--size", "320x240", "--matched")
    wait_for_peer(dying)
    wait_for_peer(steady)
    time.sleep(2)
    before = bridge.memory()
    dying.kill()
    late = run.peer("subscribe")
    wait_for_peer(late)
    time.sleep(5)
    published = result(publisher)["published"]
    received, joined = result(steady)["received"], result(late)["received"]
    after = bridge.memory()
    assert never.poll() is None
    state, findings = bridge.stop()
    assert_counts(state, published, findings)
    assert 0 < received <= published and 0 < joined <= published
    # A frame has 150 kB, and 150 were published in the meantime.
    assert after - before < 10 * 2**20, (before, after)


def test_what_is_wrong_is_reported(run):
    bridge = run.bridge()
    # Camera info of one size, images of another, then images that are no depth.
    infos = run.peer("publish", "--topic", "/other", "--size", "64x48")
    wrong = run.peer("publish", "--info", "/nowhere")
    bridge.wait_for_finding("camera-info-size")
    result(wrong)
    result(infos)
    no_depth = run.peer("publish", "--info", "/nowhere", "--encoding", "8UC2")
    bridge.wait_for_finding("invalid-message")
    result(no_depth)
    bridge.wait_for_finding("silence")
    state, findings = bridge.stop()
    assert state["published"] == 0 and state["rejected"] > 0
    texts = {finding["code"]: f"{finding['place']}: {finding['message']}" for finding in findings}
    expected = "/camera/camera_info: describes images of 64x48, but the depth image is 160x120"
    assert texts["camera-info-size"] == expected
    assert texts["invalid-message"] == "/camera/depth/image_raw: encoding: '8UC2' is not an encoding of depth"
    assert texts["silence"] == "/camera/depth/image_raw: no image for 2 s"


def test_a_missing_topic_is_reported_with_near_names(run):
    wait_for_peer(run.peer("publish", "--topic", "/camera/depth/image"))
    bridge = run.bridge()
    bridge.wait_for_finding("no-publisher")
    _, findings = bridge.stop()
    (missing,) = [finding for finding in findings if finding["code"] == "no-publisher"]
    assert missing["message"] == "has no publisher after 5 s"
    assert missing["remedy"] == "did you mean '/camera/depth/image'?"


def test_parameters_change_while_the_bridge_runs(run, tmp_path):
    bridge = run.bridge("--stdin")
    last = tmp_path / "last.npy"
    images = run.peer("subscribe", "--last", str(last))
    publisher = run.peer("publish")
    wait_for_peer(images)
    lines = ["engine=single-view", "parameters=noiseMean=0 noiseSigma=0 noiseDownscaleFactorPx=1", "presett=robotics", "seed=-2"]
    bridge.process.stdin.write("\n".join(lines) + "\n")
    bridge.process.stdin.flush()
    bridge.wait(lambda event: event.get("place") == "standard input" and "seed" in event["message"])
    result(publisher)
    result(images)
    _, findings = bridge.stop()
    messages = [finding["message"] for finding in findings if finding["place"] == "standard input"]
    assert "did you mean 'preset'" in messages[-2] and "seed" in messages[-1], messages
    assert any(finding["code"] == "parameters" and finding["level"] == "note" for finding in findings)
    assert (np.load(last) > 0).any()


def test_parameter_services(run):
    """Listed, described, read and set over the network; what is refused changes nothing, what is set counts from the next frame."""
    bridge = run.bridge()
    images = run.peer("subscribe", "--farthest")
    publisher = run.peer("publish", "--rate", "20")
    wait_for_peer(images)
    listed = run.call("list_parameters")[0]["answer"]
    names = sorted(listed["names"])
    assert {"engine", "preset", "filters", "parameters", "seed", "device_seed", "extended_disparity"} <= set(names)
    # Files of the machine are not for others on the network.
    assert "params" not in names

    wanted = ["engine", "seed", "device_seed", "extended_disparity", "filters", "nonsense"]
    read, types, described = (call["answer"] for call in run.call(
        f"get_parameters {json.dumps(wanted)}", f"get_parameter_types {json.dumps(wanted)}", f"describe_parameters {json.dumps(wanted[:5])}"
    ))
    assert read == ["", 0, -1, False, [], None], read
    # String, integer, integer, Boolean, strings, and not set.
    assert types == [4, 2, 2, 1, 9, 0]
    assert [(one["name"], one["type"], one["read_only"]) for one in described] == [
        (name, kind, False) for name, kind in zip(wanted, types) if kind
    ]

    far = {"filters": ["threshold:max=1000"]}
    calls = run.call(
        'set_parameters {"engine": "stereo-nose", "seed": 7}',
        'set_parameters {"seed": "7", "presett": "robotics"}',
        f'set_parameters_atomically {json.dumps(far | {"seed": -2})}',
        'get_parameters ["engine", "seed", "filters"]',
        f"set_parameters {json.dumps(far)}",
        'get_parameters ["filters"]',
    )
    (wrong, right), (no_number, no_parameter), atomic, kept, (good,), new = (call["answer"] for call in calls)
    assert not wrong["successful"] and "stereo-noise" in wrong["reason"], wrong
    assert right["successful"]
    assert not no_number["successful"] and "type" in no_number["reason"], no_number
    assert not no_parameter["successful"] and no_parameter["reason"], no_parameter
    assert not atomic["successful"] and "seed" in atomic["reason"], atomic
    assert kept == ["", 7, []]
    assert good["successful"] and new == [far["filters"]]

    result(publisher)
    farthest = result(images)["farthest"]
    set_at = calls[4]
    before = [value for stamp, value in farthest if stamp < set_at["called"] - 0.5]
    after = [value for stamp, value in farthest if stamp > set_at["answered"]]
    assert len(before) >= 3 and min(before) > 3000, before[-5:]
    assert len(after) >= 3 and 0 < max(after) <= 1000, after[:5]
    state, findings = bridge.stop()
    assert state["rejected"] == 0
    assert any(finding["code"] == "parameters" for finding in findings)


def test_colours_reach_the_engine_and_the_cloud(run, program, tmp_path):
    """Plain faces are dropped for lack of texture, as `sense` does, and points have the colours of their pixels."""
    bridge = run.bridge("--rgb", "/camera/color/image_raw", "--points")
    depth, color, last, last_points = (tmp_path / name for name in ("exact.npy", "color.npy", "last.npy", "points.npy"))
    images = run.peer("subscribe", "--last", str(last))
    clouds = run.peer("subscribe", "--topic", "/oak/points", "--message", "points", "--last", str(last_points))
    publisher = run.peer(
        "publish", "--rgb", "/camera/color/image_raw", "--matched", "--depth", str(depth), "--color", str(color)
    )
    wait_for_peer(images)
    wait_for_peer(clouds)
    published = result(publisher)["published"]
    image, cloud = result(images), result(clouds)
    state, findings = bridge.stop()
    assert_counts(state, published, findings)

    colors = np.load(color)
    cv2.imwrite(str(tmp_path / "color.png"), colors[..., ::-1])
    expected = sensed(program, depth, image["stamp"], tmp_path, "--rgb", str(tmp_path / "color.png"))
    measured = np.load(last)
    assert np.array_equal(measured, np.round(expected * np.float32(1000)).astype(np.uint16))
    textured, plain = measured[:, 20:70] > 0, measured[:, 100:] > 0
    assert textured.mean() > 0.9 and plain.mean() == 0

    assert cloud["fields"] == ["x", "y", "z", "rgb"] and cloud["point_step"] == 16
    points = np.load(last_points)
    packed = np.ascontiguousarray(points[..., 3]).view(np.uint8).reshape(*points.shape[:2], 4)
    seen = points[..., 2] > 0
    assert seen.sum() > 3000
    assert np.array_equal(packed[seen][:, 2::-1], colors[seen])


def test_reliable_subscribers(run):
    """Without `--reliable`, they are told why nothing arrives; with it, they receive every image."""
    bridge = run.bridge()
    waiting = run.peer("subscribe", "--reliable")
    bridge.wait_for_finding("incompatible-qos")
    waiting.kill()
    _, findings = bridge.stop()
    (found,) = [finding for finding in findings if finding["code"] == "incompatible-qos"]
    assert found["place"] == "/oak/stereo/image_raw" and "reliable delivery" in found["message"]
    assert "reliable" in found["remedy"]

    bridge = run.bridge("--reliable")
    images = run.peer("subscribe", "--reliable")
    infos = run.peer("subscribe", "--topic", "/oak/stereo/camera_info", "--message", "info", "--reliable")
    publisher = run.peer("publish", "--matched")
    wait_for_peer(images)
    wait_for_peer(infos)
    published = result(publisher)["published"]
    received, described = result(images)["received"], result(infos)["received"]
    state, findings = bridge.stop()
    assert_counts(state, published, findings)
    assert received > 0 and described > 0


def test_transforms_compressed_depth_and_colours(run, tmp_path):
    """A late subscriber receives the frames; OpenCV decodes the depth; colours are passed on with their camera info."""
    bridge = run.bridge("--tf", "camera", "--compressed", "--rgb", "/camera/color/image_raw")
    compressed, last = tmp_path / "depth.png", tmp_path / "last.npy"
    topic = "/oak/stereo/image_raw/compressedDepth"
    pngs = run.peer("subscribe", "--topic", topic, "--message", "compressed", "--last", str(compressed))
    images = run.peer("subscribe", "--last", str(last))
    colours = run.peer("subscribe", "--topic", "/oak/rgb/image_raw")
    infos = run.peer("subscribe", "--topic", "/oak/rgb/camera_info", "--message", "info", "--last", str(tmp_path / "info"))
    publisher = run.peer("publish", "--rgb", "/camera/color/image_raw", "--matched")
    for subscriber in (pngs, images, colours, infos):
        wait_for_peer(subscriber)
    late = run.peer("subscribe", "--topic", "/tf_static", "--message", "tf", "--latched", "--last", str(tmp_path / "tf"))
    wait_for_peer(late)
    frames = result(late)["frames"]
    result(publisher)
    png, image, info = result(pngs), result(images), result(infos)
    assert result(colours)["received"] > 0
    bridge.stop()
    assert frames[0] == ["sim_depth_optical", "camera"]
    assert ["camera_left_camera_frame", "camera_left_camera_optical_frame"] in frames
    assert png["format"] == "16UC1; compressedDepth png" and png["quantization"] == [0] * 12
    assert info["size"] == [160, 120] and info["k"][0] == 100
    decoded = cv2.imread(str(compressed), cv2.IMREAD_UNCHANGED)
    assert decoded.dtype == np.uint16 and (decoded > 0).mean() > 0.3
    if png["stamp"] == image["stamp"]:
        assert np.array_equal(decoded, np.load(last))


@pytest.mark.parametrize("is_far", [False, True], ids=["same machine", "other machine"])
def test_data_is_not_multicast(program, is_far):
    """Discovery is; images go to their subscriber alone, and not onto the network if it is on the bridge's machine."""
    with lan() as network:
        if network is None:
            pytest.skip("network namespaces are not permitted")
        start = network.there if is_far else network.here
        bridge = Bridge(network.here, program, environment=IN_NETWORK)
        sniffer = start_peer(network.there, script="ros_sniffer.py", environment=IN_NETWORK)
        wait_for_peer(sniffer)
        images = start_peer(start, "subscribe", environment=IN_NETWORK)
        publisher = start_peer(network.here, "publish", environment=IN_NETWORK)
        wait_for_peer(images)
        time.sleep(2)
        result(publisher)
        received = result(images)["received"]
        counts = result(sniffer)
        bridge.stop()
    # An image has 38 kB, which are 28 datagrams on Ethernet. A few are left for the lists of each node's topics.
    assert received > 10 and counts["discovery"] > 0
    assert counts["multicast_data"] < 10, counts
    assert (counts["unicast"] >= 28 * received) == is_far, counts
