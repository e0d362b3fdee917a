"""Fixtures of all oracle tests."""

import os
import subprocess
from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path

import pytest

from assets import Builder
from depth_eval import DepthEval

# Without this, DepthAI sends usage statistics, and its processes wait for each other at a lock in the home folder.
os.environ["DEPTHAI_TELEMETRY"] = "0"
# Not every environment has these packages; tests that need them do not depend on the version of OpenUSD.
NEEDS = {
    "test_bad_pairs.py": ("cv2",),
    "test_blender.py": ("bpy",),
    "test_board_rig.py": ("cv2",),
    "test_bridge.py": ("cv2", "cyclonedds"),
    "test_calibration.py": ("cv2", "depthai", "yaml"),
    "test_camera_maths.py": ("cv2",),
    "test_collada.py": ("collada", "trimesh", "yourdfpy"),
    "test_dataset.py": ("cv2",),
    "test_filters.py": ("cv2", "depthai"),
    "test_generate.py": ("cv2", "evo", "pycocotools", "pycolmap", "trimesh", "webdataset"),
    "test_generate_annotations.py": ("cv2", "evo", "pycocotools", "pycolmap", "trimesh", "webdataset"),
    "test_generate_files.py": ("cv2", "evo", "pycocotools", "pycolmap", "trimesh", "webdataset"),
    "test_generate_stereo.py": ("cv2", "evo", "pycocotools", "pycolmap", "trimesh", "webdataset"),
    "test_heaps.py": ("mujoco",),
    "test_imu.py": ("allantools", "rosbags", "scipy"),
    "test_importers.py": ("trimesh",),
    "test_mitsuba.py": ("mitsuba",),
    "test_population.py": ("depthai",),
    "test_rectify.py": ("cv2", "depthai"),
    "test_render.py": ("open3d", "libusb_package"),
    "test_robot.py": ("mujoco", "pydrake", "urdf_usd_converter", "xacro", "yourdfpy"),
    "test_robot_reading.py": ("mujoco", "trimesh", "yourdfpy"),
    "test_robot_usd.py": ("mujoco", "pxr", "trimesh", "urdf_usd_converter", "yourdfpy"),
    "test_stereo_matching.py": ("cv2",),
    "test_stereo_photographs.py": ("cv2",),
    "test_stereo_rendered.py": ("cv2",),
    "test_usd_opacity.py": ("cv2",),
}
collect_ignore = [name for name, packages in NEEDS.items() if not all(map(find_spec, packages))]


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--slow", action="store_true", help="also run the tests marked slow")


def pytest_configure(config: pytest.Config) -> None:
    config.addinivalue_line("markers", "slow: left out without --slow")


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    if not config.getoption("--slow"):
        for item in items:
            if item.get_closest_marker("slow"):
                item.add_marker(pytest.mark.skip(reason="slow: run with --slow"))


@pytest.fixture(scope="session")
def program() -> Path:
    """The program under test."""
    named = os.environ.get("OAKTWIN_BIN")
    if not named:
        pytest.skip("OAKTWIN_BIN names no program: run by cargo xtask test")
    return Path(named)


@pytest.fixture(scope="session")
def builder(program: Path, tmp_path_factory: pytest.TempPathFactory) -> Builder:
    """Assets, built on first use."""
    return Builder(program, tmp_path_factory.mktemp("assets"))


@pytest.fixture(scope="session")
def depth_eval() -> Iterator[DepthEval]:
    named = os.environ.get("OAKTWIN_DEPTH_EVAL")
    if not named:
        pytest.skip("OAKTWIN_DEPTH_EVAL names no program: run by cargo xtask test")
    program = DepthEval(named)
    yield program
    program.close()


@pytest.fixture(scope="session")
def scene_dump(tmp_path_factory):
    program = os.environ.get("OAKTWIN_SCENE_DUMP")
    if not program:
        pytest.skip("OAKTWIN_SCENE_DUMP names no program: run by cargo xtask test")

    # Not every environment has OpenUSD.
    from usd_scenes import Dump

    def dump(stage: Path, time=None, subdivide=0) -> Dump:
        folder = tmp_path_factory.mktemp("dump")
        options = [] if time is None else ["--time", str(time)]
        options += ["--subdivide", str(subdivide)]
        subprocess.run([program, str(stage), str(folder), *options], check=True)
        return Dump(folder)

    return dump
