"""Many threads, other processes, Ctrl-C, memory."""

import gc
import multiprocessing
import os
import sys
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

import oaktwin
from conftest import PATIENCE_S, run_and_interrupt, ticks_during


def test_many_threads_and_one_sensor(device):
    sensor = oaktwin.DepthSensor(device, seed=3)
    filtered = oaktwin.DepthSensor(device, seed=3, filters=["temporal"])
    images = [np.full((60, 106), 1 + 0.1 * i, np.float32) for i in range(8)]
    sizes = [np.full((30, 40 + i), 2, np.float32) for i in range(4)]
    expected = [sensor(image, frame=i) for i, image in enumerate(images)]
    others = [sensor(image, frame=0) for image in sizes]

    def work(number):
        for _ in range(20):
            i = number % 8
            assert np.array_equal(sensor(images[i], frame=i), expected[i])
            assert np.array_equal(sensor(sizes[i % 4], frame=0), others[i % 4])
            # The order is undefined, but calls do not interfere.
            assert filtered(images[i]).shape == (60, 106)
            assert np.array_equal(sensor(np.stack(images[:1] * 3), frame=0)[0], expected[0])

    with ThreadPoolExecutor(8) as pool:
        list(pool.map(work, range(16)))


def test_the_interpreter_runs_meanwhile(device):
    sensor = oaktwin.DepthSensor(device)
    batch = np.full((64, 400, 640), 2, np.float32)
    # A busy machine may run the other thread too late.
    assert any(ticks_during(lambda: sensor(batch)) > 3 for _ in range(20))
    assert ticks_during(lambda: sum(range(1_000_000))) == 0, "the call that counts keeps the interpreter"


def child(queue):
    device = oaktwin.Device("OAK4-D")
    queue.put(oaktwin.DepthSensor(device, seed=1)(np.full((60, 106), 2, np.float32)))


@pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork here")
@pytest.mark.filterwarnings("ignore:.*fork.*:DeprecationWarning", "ignore:.*fork.*:RuntimeWarning")
def test_a_forked_process_has_threads_of_its_own(device):
    depth = np.full((60, 106), 2, np.float32)
    expected = oaktwin.DepthSensor(device, seed=1)(depth)
    context = multiprocessing.get_context("fork")
    queue = context.Queue()
    process = context.Process(target=child, args=(queue,))
    process.start()
    assert np.array_equal(queue.get(timeout=PATIENCE_S), expected)
    process.join(timeout=PATIENCE_S)
    assert process.exitcode == 0


@pytest.mark.skipif(sys.platform == "win32", reason="no SIGINT to send")
@pytest.mark.parametrize(
    "call",
    [
        "oaktwin.DepthSensor(device, filters=['spatial', 'median:size=7', 'speckle'])(np.ones((20000, 60, 106), np.float32))",
        "oaktwin.accuracy(device, devices=2000, captures=1000)",
        "scene.render(camera, np.stack([np.eye(4)] * 1000))",
    ],
)
def test_ctrl_c(call):
    text = f"""
import numpy as np, oaktwin
device = oaktwin.Device("OAK4-D")
camera = oaktwin.Camera((1000, 500), hfov_deg=60)
scene = oaktwin.Scene.from_triangles(np.eye(3), np.array([[0, 1, 2]]))
try:
    print("ready", flush=True)
    {call}
    print("finished")
except KeyboardInterrupt:
    print("interrupted")
"""
    assert run_and_interrupt(text) == "interrupted\n"


def resident():
    with open("/proc/self/status") as status:
        return next(int(line.split()[1]) for line in status if line.startswith("VmRSS:")) * 1024


@pytest.mark.skipif(not os.path.exists("/proc/self/status"), reason="requires /proc/self/status")
def test_memory_does_not_grow(device, room):
    depth, rgb = (np.ascontiguousarray(image[:20, :30]) for image in room)
    sensor = oaktwin.DepthSensor(device, filters=["temporal", "median"])
    plain = oaktwin.DepthSensor(device)
    scene = oaktwin.Scene.from_triangles(np.eye(3), np.array([[0, 1, 2]]))
    camera = oaktwin.Camera((8, 8), hfov_deg=60)
    out = np.empty_like(depth)

    def calls(count):
        for frame in range(count):
            sensor(depth, rgb, frame=frame)
            plain(depth, frame=frame, out=out)
            plain(memoryview(depth))
            oaktwin.filters.median(depth)
            scene.render(camera, np.eye(4), annotators=["rgb", "pointcloud"])
            device.cameras["left"].K
            with pytest.raises(oaktwin.Error):
                plain(depth[0])
        gc.collect()

    def growth(count):
        before = resident()
        calls(count)
        return resident() - before

    calls(1000)
    # Less than a hundred bytes a round; one image is 2400. A leak grows every time, the caches of an allocator do not.
    assert any(growth(10_000) < 10_000 * 100 for _ in range(3))
