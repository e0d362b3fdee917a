"""Every command and snippet of the README, the manual, the examples and their docstrings runs."""

import json
import os
import shutil
import struct
import subprocess

import numpy as np
import pytest

import documentation
import oaktwin
from conftest import ROOT

SCENE = ROOT / "examples/depth_sensor/depth_sensor.usda"
# Commands that do not run here, by how they start, with the reason.
NOT_RUN = {
    "cargo xtask ": "it runs this test",
    "pip install ": "the package and its peers are installed",
    "./python.sh ": "it needs Isaac Sim",
    "./render.sh ": "the test of the rig runs it",
    "oaktwin calibration import ": "it reads other tools' files, and has its own tests",
    "oaktwin studio": "it serves a page until it is stopped, and has its own tests",
    "oaktwin bridge": "it runs until it is stopped, and has its own tests",
    "rerun ": "it opens a window",
    "ros2 ": "it needs ROS 2",
    "python examples/python/": "the program has its own test",
}
# Commands that end with 1 where they report findings, as they may about these inputs.
REPORTS_FINDINGS = {"accuracy", "check", "fit", "stereo"}
# Pages whose snippets are excerpts of an example's program, which has its own test: only their syntax is checked.
EXCERPTS = {
    "docs/python/imu.md",
    "docs/python/record_wall.md",
    "docs/python/training.md",
    "docs/python/isaac_sim.md",
    "docs/python/many_worlds.md",
    "docs/python/mujoco_table.md",
    "docs/python/neural_stereo.md",
    "docs/python/open3d_plane.md",
    "docs/python/ray_frames.md",
    "docs/python/replicator_folder.md",
    "docs/python/rerun_mcap.md",
}
PAGES = documentation.pages()
PROGRAMS = [page for page in documentation.docstrings() if page.shell]


@pytest.fixture(scope="module")
def inputs(tmp_path_factory, program):
    """A folder with every file that the commands and snippets read, under the names that they use."""
    folder = tmp_path_factory.mktemp("inputs")
    for name in ["scene.usd", "room.usd", "depth_sensor.usda"]:
        # A fifteenth of the pixels, which is faster, and the camera's name in the manual.
        text = SCENE.read_text().replace("(1920, 1080)", "(480, 270)")
        (folder / name).write_text(text.replace("Camera_pseudo_depth", "Cam"))
    shutil.copy(SCENE.with_name("grid.png"), folder)
    for name in ["cal.json", "mine.json", "rig.json", "unit.json"]:
        shutil.copy(ROOT / "crates/calibration/fixtures/example-oak-d-pro-poe.json", folder / name)
    robots = folder / "examples/robots"
    robots.mkdir(parents=True)
    for name in ["gripper.urdf", "gripper_poses.csv"]:
        shutil.copy(ROOT / "examples/robots" / name, robots)
    write_triangle(folder / "room.glb")
    np.save(folder / "depth.npy", np.full((40, 64), 2.0, np.float32))
    (folder / "poses.tum").write_text("0 2 -1 1.2 0 0 0 1\n0.1 2.1 -1 1.2 0 0 0 1\n")
    (folder / "measured.csv").write_text("distance_m,depth_error_percent\n3,1.1\n4,1.5\n5,2.1\n6,2.9\n7,3.2\n")
    (folder / "cups.toml").write_text("frames = 20\n[camera]\nresolution = [64, 40]\n")
    record_wall(folder / "wall")
    program("asset", "OAK-D-Pro-PoE", "-o", folder / "oak_d_pro_poe.usd")
    program("demo", "-o", folder / "oaktwin-demo")
    program(
        "render", folder / "scene.usd", "--model", "OAK4-D", "--look-at", 3, 0, 0.6, 0, 0, 0.3, "-o", folder / "frames",
        "--annotators", "rgb,distance_to_image_plane,camera_params", "--resolution", "320x200",
    )
    body = oaktwin.look_at((3, 0, 0.6), (0, 0, 0.3), frame="body")
    pair = oaktwin.Scene.open(str(folder / "scene.usd")).render_pair(oaktwin.Device.from_calibration(folder / "cal.json"), body)
    image = pytest.importorskip("PIL.Image")
    for side in ["left", "right"]:
        image.fromarray(pair[side]).save(folder / f"{side}.png")
    return folder


def write_triangle(path):
    """Writes a binary glTF file of one triangle."""
    corners = np.array([(-2, 0, -2), (2, 0, -2), (0, 2, -2)], np.float32)
    data = corners.tobytes()
    limits = {"min": corners.min(0).tolist(), "max": corners.max(0).tolist()}
    document = {
        "asset": {"version": "2.0"},
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", **limits}],
        "bufferViews": [{"buffer": 0, "byteLength": len(data)}],
        "buffers": [{"byteLength": len(data)}],
    }
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(data), b"BIN\0") + data
    path.write_bytes(struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks)


def record_wall(folder):
    """Records a wall at many distances with a simulated unit."""
    folder.mkdir()
    sensor = oaktwin.DepthSensor(oaktwin.Device("OAK-D-Pro-PoE"), parameters={"bias": -0.1})
    rows = ["file,distance_m"]
    for number, distance in enumerate(np.geomspace(1.0, 5.0, 20)):
        walls = [sensor(np.full((400, 640), distance, np.float32), frame=10 * number + frame) for frame in range(4)]
        np.save(folder / f"{number}.npy", np.stack(walls))
        rows.append(f"{number}.npy,{distance}")
    (folder / "distances.csv").write_text("\n".join(rows) + "\n")


@pytest.fixture
def run(inputs, tmp_path, monkeypatch):
    """Runs a command in a copy of the inputs."""
    folder = tmp_path / "work"
    shutil.copytree(inputs, folder)
    monkeypatch.chdir(folder)
    named = os.environ["OAKTWIN_BIN"]

    def run(command):
        items, standard_input, standard_output = documentation.words(command)
        if items[:2] == ["cargo", "run"]:
            assert items[-2:] == ["--", "demo"]
            return  # The demo is among the inputs.
        items = [named, *items[1 if items[0] == "oaktwin" else 3 :]]
        read = standard_input.read_bytes() if standard_input else b""
        done = subprocess.run(items, input=read, capture_output=True)
        allowed = {0, 1} if REPORTS_FINDINGS & set(items[1:2]) else {0}
        assert done.returncode in allowed, f"{command}\n{done.stderr.decode()}"
        if standard_output:
            standard_output.write_bytes(done.stdout)

    return run


def is_run(command):
    return not any(command.startswith(start) for start in NOT_RUN)


@pytest.mark.parametrize("page", [page for page in PAGES + PROGRAMS if any(map(is_run, page.shell))], ids=lambda page: page.name)
def test_commands_run(page, run):
    for command in filter(is_run, page.shell):
        run(command)


@pytest.mark.parametrize("start", NOT_RUN)
def test_every_exception_is_in_use(start):
    assert any(command.startswith(start) for page in PAGES + PROGRAMS for command in page.shell)


@pytest.mark.parametrize("command", [c for page in PAGES + PROGRAMS for c in page.shell if c.startswith("python examples/python/")])
def test_commands_of_examples_name_existing_options(command):
    items, _, _ = documentation.words(command)
    text = (ROOT / items[1]).read_text()
    assert all(f'"{item}"' in text for item in items[2:] if item.startswith("-"))
    assert (ROOT / "crates/python/tests" / f"test_example_{items[1].rpartition('/')[2]}").exists()


@pytest.mark.parametrize("page", [page for page in PAGES if page.python], ids=lambda page: page.name)
def test_snippets_run(page, run):
    names = {}
    if page.name == "docs/python/stereo_projector.md":
        names = {
            "oaktwin": oaktwin,
            "scene": oaktwin.Scene.open("scene.usd"),
            "world_from_body": oaktwin.look_at((3, 0, 0.6), (0, 0, 0.3), frame="body"),
        }
    if page.name == "docs/python/depthai_calibration.md":
        depthai = pytest.importorskip("depthai")
        names = {"oaktwin": oaktwin, "depthai": depthai}
        names |= {f"CAM_{letter}": getattr(depthai.CameraBoardSocket, f"CAM_{letter}") for letter in "BC"}
    for number, text in enumerate(page.python):
        code = compile(text, f"{page.name}, snippet {number + 1}", "exec")
        if page.name not in EXCERPTS:
            exec(code, names)
