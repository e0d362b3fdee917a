"""Tests the package with only the oldest supported NumPy. Run by `cargo xtask test`; does not require pytest."""

import subprocess
import sys
import tempfile
import time
from importlib.metadata import distributions, requires
from pathlib import Path

import numpy as np

import oaktwin


def nothing_else_is_here():
    names = {distribution.metadata["Name"].lower() for distribution in distributions()}
    assert names <= {"oaktwin", "numpy", "pip", "setuptools", "wheel"}, names
    assert [line for line in requires("oaktwin") if "extra" not in line] == [f"numpy>={np.__version__.rsplit('.', 1)[0]}"]


def it_senses():
    sensor = oaktwin.DepthSensor(oaktwin.Device("OAK4-D"), seed=7)
    measured = sensor(np.full((60, 106), 2.0, np.float32))
    assert measured.dtype == np.float32 and abs(np.median(measured) - 2) < 0.05
    assert np.array_equal(measured, sensor(memoryview(np.full((60, 106), 2.0, np.float32)), frame=0))


class Producer:
    """An array of another library: its own protocol of DLPack, and `__array__`."""

    def __init__(self, values):
        self.values = values

    def __dlpack__(self, stream=None):
        return self.values.__dlpack__()

    def __dlpack_device__(self):
        return self.values.__dlpack_device__()

    def __array__(self, dtype=None):
        return self.values


class Versioned(Producer):
    """The same with the versioned protocol, which this NumPy does not have."""

    def __dlpack__(self, *, stream=None, max_version=None, dl_device=None, copy=None):
        return self.values.__dlpack__()


def it_writes_to_foreign_arrays():
    sensor = oaktwin.DepthSensor(oaktwin.Device("OAK4-D"), seed=7)
    depth = np.full((60, 106), 2.0, np.float32)
    for kind in [Producer, Versioned]:
        out = kind(np.zeros_like(depth))
        assert sensor(kind(depth), frame=0, out=out) is out
        assert np.array_equal(out.values, sensor(depth, frame=0))


def it_renders():
    scene = oaktwin.Scene.from_triangles(np.array([[-9, -9, 3], [9, -9, 3], [0, 9, 3]]), np.array([[0, 1, 2]]))
    camera = oaktwin.Camera((8, 6), hfov_deg=60)
    frames = scene.render(camera, np.eye(4), annotators=["distance_to_image_plane", "bounding_box_2d_tight"])
    assert np.allclose(frames["distance_to_image_plane"], 3) and len(frames["bounding_box_2d_tight"]) == 0


def it_measures_accuracy_without_matplotlib():
    measured = oaktwin.accuracy(oaktwin.Device("OAK4-D"), distances=[1], devices=2, captures=1)
    try:
        measured.plot()
    except ImportError as error:
        assert "pip install" in str(error)
    else:
        raise AssertionError("a plot without Matplotlib")


def the_program_runs():
    def run(*arguments):
        return subprocess.run([sys.executable, "-I", "-m", "oaktwin", *arguments], capture_output=True, text=True)

    assert run("--version").stdout == f"oaktwin {oaktwin.__version__}\n"
    assert run("mdels").returncode == 2
    with tempfile.TemporaryDirectory() as folder:
        asset = Path(folder, "oak.usda")
        done = run("asset", "OAK4-D", "-o", str(asset))
        assert done.returncode == 0 and asset.read_text().startswith("#usda 1.0"), done.stderr
    script = Path(sys.executable).with_name("oaktwin")
    assert subprocess.run([script, "--version"], capture_output=True, text=True).stdout.startswith("oaktwin ")


if __name__ == "__main__":
    start = time.perf_counter()
    tests = [nothing_else_is_here, it_senses, it_writes_to_foreign_arrays, it_renders, it_measures_accuracy_without_matplotlib, the_program_runs]
    failed = 0
    for test in tests:
        try:
            test()
        except Exception as error:
            failed += 1
            print(f"FAILED {test.__name__}: {error!r}")
    figures = ([f"{failed} failed"] if failed else []) + [f"{len(tests) - failed} passed"]
    print(f"{', '.join(figures)} in {time.perf_counter() - start:.2f}s")
    sys.exit(failed > 0)
