"""`python -m oaktwin.depthai`, and the fixture for pytest."""

import os
import subprocess
import sys

import pytest

pytest.importorskip("depthai")

from virtual_scene import MODEL, textured_scene  # noqa: E402

# Stands in for OpenCV where it is not installed: what the launcher replaces is set on any module of this name.
WINDOWS = "def imshow(name, image):\n    raise SystemExit('a window was opened')\n"
APP = """
import sys
import cv2
import depthai as dai

print("arguments", sys.argv[1:])
with dai.Pipeline() as pipeline:
    camera = pipeline.create(dai.node.Camera).build(dai.CameraBoardSocket.CAM_B)
    queue = camera.requestOutput((80, 50)).createOutputQueue()
    pipeline.start()
    while pipeline.isRunning():
        cv2.imshow("video", queue.get().getCvFrame())
        if cv2.waitKey(1) == ord("q"):
            print("q was pressed")
            break
"""


@pytest.fixture
def launch(tmp_path):
    textured_scene().save_usd(tmp_path / "scene.usda")
    (tmp_path / "modules").mkdir()
    (tmp_path / "modules/cv2.py").write_text(WINDOWS, "utf-8")

    def run(app, *options, arguments=()):
        (tmp_path / "app.py").write_text(app, "utf-8")
        command = [sys.executable, "-m", "oaktwin.depthai", "--model", MODEL, "--scene", "scene.usda", *options, "--", "app.py", *arguments]
        environment = {**os.environ, "PYTHONPATH": str(tmp_path / "modules")}
        return subprocess.run(
            command, cwd=tmp_path, env=environment, capture_output=True, text=True, encoding="utf-8", timeout=300
        )

    return run


def test_windows_are_recorded_and_q_is_pressed(launch):
    done = launch(APP, "--fast", "--headless", "4", arguments=["--its-own", "argument"])
    assert done.returncode == 0, done.stderr
    assert "arguments ['--its-own', 'argument']" in done.stdout and "q was pressed" in done.stdout
    assert "oaktwin: window 'video': 4 images, 80x50 px" in done.stderr


@pytest.mark.parametrize("app", [APP, "import time\nwhile True:\n    time.sleep(0.05)\n"])
def test_a_program_ends_after_its_time(launch, app):
    done = launch(app, "--headless", "0", "--seconds", "2")
    assert done.returncode == 0, done.stderr


def test_the_exit_code_is_the_programs(launch):
    assert launch("raise SystemExit(3)").returncode == 3
    assert launch("print('done')").returncode == 0
    done = launch("raise KeyError('missing')")
    assert done.returncode == 1 and "KeyError: 'missing'" in done.stderr
    done = launch("import depthai as dai\ndai.Pipeline().create(dai.node.NeuralNetwork)")
    assert done.returncode == 1 and "NeuralNetwork: this node cannot be simulated" in done.stderr


def test_an_asynchronous_program_and_one_that_ends_the_process(launch):
    app = """
import asyncio
import depthai as dai

async def main():
    with dai.Pipeline() as pipeline:
        queue = pipeline.create(dai.node.Camera).build(dai.CameraBoardSocket.CAM_B).requestOutput((80, 50)).createOutputQueue()
        pipeline.start()
        print((await asyncio.to_thread(queue.get)).getWidth())

asyncio.run(main())
"""
    done = launch(app, "--fast")
    assert done.returncode == 0 and done.stdout.split()[-1] == "80", done.stderr
    assert launch("import os\nos._exit(5)").returncode == 5


VIEWERS = {
    "open3d.py": "class visualization:\n    class Visualizer:\n        def __init__(self):\n            raise SystemExit('a window was opened')\n",
    "rerun.py": "def init(name, spawn):\n    raise SystemExit('a viewer was started')\ndef log(path, value):\n    raise SystemExit('no')\n",
}


def test_viewers_are_recorded(launch, tmp_path):
    for name, text in VIEWERS.items():
        (tmp_path / "modules" / name).write_text(text, "utf-8")
    app = """
import open3d as o3d
import rerun as rr

rr.init("app", spawn=True)
window = o3d.visualization.Visualizer()
window.create_window("points")
window.get_render_option().point_size = 2
window.get_view_control().set_zoom(0.3)
window.add_geometry(object())
while window.poll_events():
    window.update_geometry(object())
    window.update_renderer()
    rr.log("world/points", object())
"""
    done = launch(app, "--headless", "3")
    assert done.returncode == 0, done.stderr
    assert "oaktwin: Open3D window 'points': 3 updates" in done.stderr
    assert "oaktwin: Rerun path 'world/points': 2 updates" in done.stderr


def test_a_program_that_forks(launch):
    """The parent runs on; a child that does not use the device ends on its own."""
    if not hasattr(os, "fork"):
        pytest.skip("this system has no fork")
    app = """
import os
import depthai as dai

with dai.Pipeline() as pipeline:
    queue = pipeline.create(dai.node.Camera).build(dai.CameraBoardSocket.CAM_B).requestOutput((80, 50)).createOutputQueue()
    pipeline.start()
    queue.get()
    child = os.fork()
    if child == 0:
        os._exit(7)
    assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 7
    print("width", queue.get().getWidth())
"""
    done = launch(app, "--fast")
    assert done.returncode == 0 and "width 80" in done.stdout, done.stderr


def test_a_program_with_processes(launch):
    """A spawned process is a new one, without the virtual device; a forked one has its copy of the device, before a pipeline was started."""
    app = """
import multiprocessing
import depthai as dai

def width(_):
    with dai.Pipeline() as pipeline:
        queue = pipeline.create(dai.node.Camera).build(dai.CameraBoardSocket.CAM_B).requestOutput((80, 50)).createOutputQueue()
        pipeline.start()
        return queue.get().getWidth()

if __name__ == "__main__":
    with multiprocessing.get_context("fork").Pool(1) as pool:
        print("width", pool.map_async(width, [0]).get(60))
"""
    if not hasattr(os, "fork"):
        pytest.skip("this system has no fork")
    done = launch(app, "--fast")
    assert done.returncode == 0 and "width [80]" in done.stdout, done.stderr


def test_wrong_options(launch):
    done = launch("", "--network", "model.onnx")
    assert done.returncode == 1 and "write NAME=FILE.onnx" in done.stderr
    done = launch("", "--trajectory", "no.tum")
    assert done.returncode == 1 and "no.tum" in done.stderr
    command = [sys.executable, "-m", "oaktwin.depthai", "--model", MODEL, "--scene", "x.usd", "--", "no_app.py"]
    done = subprocess.run(command, capture_output=True, text=True, encoding="utf-8")
    assert done.returncode == 2 and "no_app.py: this file does not exist" in done.stderr
    done = subprocess.run([*command[:-2]], capture_output=True, text=True, encoding="utf-8")
    assert done.returncode == 2 and "the program is missing" in done.stderr


def test_the_fixture(tmp_path):
    (tmp_path / "conftest.py").write_text("from oaktwin.depthai.pytest import virtual_oak  # noqa: F401\n", "utf-8")
    textured_scene().save_usd(tmp_path / "scene.usda")
    (tmp_path / "test_app.py").write_text(
        """
import depthai as dai

def test_app(virtual_oak):
    virtual_oak("OAK-D Pro PoE", scene="scene.usda")
    with dai.Pipeline() as pipeline:
        queue = pipeline.create(dai.node.Camera).build(dai.CameraBoardSocket.CAM_B).requestOutput((80, 50)).createOutputQueue()
        pipeline.start()
        assert queue.get().getCvFrame().shape == (50, 80)
""",
        "utf-8",
    )
    done = subprocess.run(
        [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider"], cwd=tmp_path, capture_output=True, text=True, encoding="utf-8"
    )
    assert done.returncode == 0, done.stdout + done.stderr
