"""Animated stages."""

import pickle
import subprocess
import sys

import numpy as np
import pytest

import oaktwin
from conftest import PATIENCE_S

STAGE = """#usda 1.0
(
    metersPerUnit = 1
    upAxis = "Z"
    startTimeCode = 0
    endTimeCode = 10
)
def Xform "Arm"
{
    float xformOp:rotateZ.timeSamples = { 0: 0, 10: 90 }
    uniform token[] xformOpOrder = ["xformOp:rotateZ"]
    def Cube "Link"
    {
        double size = 0.5
        double3 xformOp:translate = (2, 0, 0)
        uniform token[] xformOpOrder = ["xformOp:translate"]
    }
    def Camera "Eye"
    {
        float focalLength = 20
        float horizontalAperture = 20
        double3 xformOp:translate = (2, 0, 3)
        uniform token[] xformOpOrder = ["xformOp:translate"]
    }
}
def Mesh "Sheet"
{
    int[] faceVertexCounts = [3]
    int[] faceVertexIndices = [0, 1, 2]
    point3f[] points = [(-9, -9, -1), (9, -9, -1), (0, 9, -1)]
}
"""


@pytest.fixture(params=["moves", "deforms"])
def path(request, tmp_path):
    text = STAGE
    if request.param == "deforms":
        flat, raised = "[(-9, -9, -1), (9, -9, -1), (0, 9, -1)]", "[(-9, -9, 0), (9, -9, 0), (0, 9, 0)]"
        text = text.replace(f"points = {flat}", f"points.timeSamples = {{ 0: {flat}, 10: {raised} }}")
    path = tmp_path / "stage.usda"
    path.write_text(text)
    return path


def render(scene):
    camera, pose = scene.cameras["/Arm/Eye"]
    return scene.render(camera.resized(64, 40), pose)["distance_to_image_plane"]


def test_a_time_is_that_of_opening_at_it(path):
    scene = oaktwin.Scene.open(path)
    assert scene.time is None
    for time in (0.0, 5.0, 10.0, 2.5, None):
        scene.set_time(time)
        other = oaktwin.Scene.open(path, time=time)
        assert scene.time == time
        assert np.array_equal(render(scene), render(other))
        assert np.array_equal(scene.cameras["/Arm/Eye"][1], other.cameras["/Arm/Eye"][1])
        assert np.array_equal(scene.poses["/Arm/Link"], other.poses["/Arm/Link"])
    angle = np.radians(45)
    scene.set_time(5)
    assert np.allclose(scene.poses["/Arm/Link"][:3, 3], [2 * np.cos(angle), 2 * np.sin(angle), 0])


def test_pickles_and_poses(path):
    scene = oaktwin.Scene.open(path, time=3)
    scene.set_time(7)
    scene.set_pose("/Arm/Link", np.eye(4))
    other = pickle.loads(pickle.dumps(scene))
    assert other.time == 7 and np.array_equal(other.poses["/Arm/Link"], np.eye(4))
    assert np.array_equal(render(other), render(scene))
    scene.set_time(7)
    assert not np.array_equal(scene.poses["/Arm/Link"], np.eye(4)), "an animated part follows its animation"


def test_threads_ask_while_others_change_the_time(path):
    """In a process of its own, because threads that wait for each other stop all."""
    script = f"""
import pickle, threading, oaktwin
scene = oaktwin.Scene.open({str(path)!r}, time=0)
def change(first):
    for step in range(60):
        scene.set_time((first + step) % 11)
threads = [threading.Thread(target=change, args=(first,)) for first in range(3)]
for thread in threads:
    thread.start()
asked = 0
while any(thread.is_alive() for thread in threads):
    scene.render(*scene.cameras["/Arm/Eye"])
    assert pickle.loads(pickle.dumps(scene)).time in range(11) and scene.time in range(11)
    asked += 1
print(asked > 0)
"""
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=PATIENCE_S)
    assert done.stdout == "True\n", done.stderr


def test_what_has_no_time(path, tmp_path):
    with pytest.raises(oaktwin.Error, match="time: does not apply to a scene of meshes"):
        oaktwin.Scene.from_triangles(np.eye(3), [[0, 1, 2]]).set_time(1)
    scene = oaktwin.Scene.open(path)
    with pytest.raises(oaktwin.Error, match="time: is NaN"):
        scene.set_time(float("nan"))
    mesh = tmp_path / "mesh.obj"
    mesh.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    with pytest.raises(oaktwin.Error, match="only USD stages and glTF files are"):
        oaktwin.Scene.open(mesh).set_time(1)
    path.unlink()
    with pytest.raises(FileNotFoundError):
        scene.set_time(1)


def test_a_time_outside_the_range_is_reported(path):
    scene = oaktwin.Scene.open(path, time=0)
    with pytest.warns(oaktwin.FindingWarning, match="from 0 to 10; the time code 11 is outside"):
        scene.set_time(11)
    (found,) = oaktwin.Scene.open(path, time=-2).findings
    assert "the time code -2 is outside" in found.message
