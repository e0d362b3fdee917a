"""`oaktwin bridge` over the loopback interface, with Eclipse Cyclone DDS as the publisher and the subscribers."""

import shutil
import subprocess
import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from ros_network import MODEL, Bridge, isolated, result, start_peer


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

        def peer(self, *arguments: str) -> subprocess.Popen:
            peer = start_peer(network, *arguments)
            processes.append(peer)
            return peer

    yield Run()
    for process in processes:
        process.kill()
        process.communicate()


def sensed(program: Path, depth: Path, stamp: list[int], folder: Path) -> np.ndarray:
    """What `oaktwin sense` makes of a depth image whose frame is the stamp."""
    image = folder / f"depth_{stamp[0] * 10**9 + stamp[1]}.npy"
    shutil.copy(depth, image)
    focal = str(0.625 * np.load(depth).shape[1])
    subprocess.run(
        [program, "sense", image, "--model", MODEL, "--input-kind", "z", "--fx", focal, "-o", folder],
        check=True,
        capture_output=True,
    )
    (found,) = folder.glob("*depth_sensor_distance*.npy")
    return np.load(found)


@pytest.mark.parametrize("encoding", ["16UC1", "32FC1"])
def test_images_are_those_of_sense(run, program, tmp_path, encoding):
    bridge = run.bridge("--encoding", encoding, "--points")
    depth, last, last_points = (tmp_path / name for name in ("exact.npy", "last.npy", "points.npy"))
    images = run.peer("subscribe", "--last", str(last))
    infos = run.peer("subscribe", "--topic", "/oak/stereo/camera_info", "--message", "info", "--last", str(tmp_path / "info"))
    clouds = run.peer("subscribe", "--topic", "/oak/points", "--message", "points", "--last", str(last_points))
    publisher = run.peer("publish", "--encoding", encoding, "--wait", "2", "--depth", str(depth))
    published = result(publisher)["published"]
    image, info, cloud = result(images), result(infos), result(clouds)
    state, findings = bridge.stop()
    assert state["received"] == state["published"] == published and state["rejected"] == 0, (state, findings)
    # A best-effort subscriber may miss some on a busy machine.
    assert image["received"] >= published * 0.9
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
    publisher = run.peer("publish", "--size", "320x240", "--wait", "2", "--seconds", "9")
    time.sleep(4)
    before = bridge.memory()
    dying.kill()
    late = run.peer("subscribe")
    published = result(publisher)["published"]
    received, joined = result(steady)["received"], result(late)["received"]
    after = bridge.memory()
    assert never.poll() is None
    state, _ = bridge.stop()
    assert state["published"] == published
    assert received >= published * 0.9
    assert 0 < joined <= published
    # A frame has 150 kB, and 150 were published in the meantime.
    assert after - before < 10 * 2**20, (before, after)


def test_what_is_wrong_is_reported(run):
    bridge = run.bridge()
    # Camera info of one size, images of another, then images that are no depth.
    infos = run.peer("publish", "--topic", "/other", "--size", "64x48", "--seconds", "4", "--wait", "1")
    wrong = run.peer("publish", "--info", "/nowhere", "--seconds", "2", "--wait", "2")
    result(wrong)
    result(infos)
    no_depth = run.peer("publish", "--info", "/nowhere", "--encoding", "8UC2", "--seconds", "1", "--wait", "1")
    result(no_depth)
    time.sleep(2.5)
    state, findings = bridge.stop()
    assert state["published"] == 0 and state["rejected"] > 0
    texts = {finding["code"]: f"{finding['place']}: {finding['message']}" for finding in findings}
    expected = "/camera/camera_info: is of images of 64x48, but the depth image is 160x120"
    assert texts["camera-info-size"] == expected
    assert texts["invalid-message"] == "/camera/depth/image_raw: encoding: '8UC2' is not an encoding of depth"
    assert texts["silence"] == "/camera/depth/image_raw: no image for 2 s"


def test_a_missing_topic_is_reported_with_near_names(run):
    bridge = run.bridge()
    run.peer("publish", "--topic", "/camera/depth/image", "--seconds", "8")
    time.sleep(6.5)
    _, findings = bridge.stop()
    (missing,) = [finding for finding in findings if finding["code"] == "no-publisher"]
    assert missing["message"] == "has no publisher after 5 s"
    assert missing["remedy"] == "did you mean '/camera/depth/image'?"


def test_parameters_change_while_the_bridge_runs(run, tmp_path):
    bridge = run.bridge("--stdin")
    last = tmp_path / "last.npy"
    images = run.peer("subscribe", "--last", str(last))
    publisher = run.peer("publish", "--wait", "2", "--seconds", "4")
    time.sleep(3)
    lines = ["engine=single-view", "parameters=noiseMean=0 noiseSigma=0 noiseDownscaleFactorPx=1", "presett=robotics", "seed=-2"]
    bridge.process.stdin.write("\n".join(lines) + "\n")
    bridge.process.stdin.flush()
    result(publisher)
    result(images)
    _, findings = bridge.stop()
    messages = [finding["message"] for finding in findings if finding["place"] == "standard input"]
    assert "did you mean 'preset'" in messages[-2] and "seed" in messages[-1], messages
    assert any(finding["code"] == "parameters" and finding["level"] == "note" for finding in findings)
    assert (np.load(last) > 0).any()
