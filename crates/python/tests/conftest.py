"""Fixtures and helpers of all tests of the package."""

import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from importlib.util import find_spec
from pathlib import Path

import numpy as np
import pytest

import oaktwin

ROOT = Path(__file__).resolve().parents[3]
# The NumPy models of the sensors.
sys.path.append(str(ROOT / "tests/oracles"))
# Without these, Ray keeps a token in the home folder; DepthAI sends usage statistics, and its processes wait for each other at a
# lock in the home folder.
os.environ |= {"RAY_AUTH_MODE": "disabled", "DEPTHAI_TELEMETRY": "0"}
# Packages that only some environments have, by the names of their modules. A test, or a snippet of the manual, that imports a
# missing one is skipped.
PEERS = {"cv2", "gymnasium", "mjlab", "open3d", "pxr", "ray", "rerun", "torch", "warp"}
# Seconds in which everything happens, however busy the machine is.
PATIENCE_S = 300
# The focal length in px and the baseline in metres of `matcher`.
FX, BASELINE = 300.0, 0.075


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--slow", action="store_true", help="also run the tests marked slow")


def pytest_configure(config: pytest.Config) -> None:
    config.addinivalue_line("markers", "slow: left out without --slow")


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    if not config.getoption("--slow"):
        for item in items:
            if item.get_closest_marker("slow"):
                item.add_marker(pytest.mark.skip(reason="slow: run with --slow"))


def environment_with_libusb() -> dict[str, str]:
    """The environment of a program that imports Open3D, whose library requires a libusb: a Python package has one if the system has none."""
    environment = dict(os.environ)
    if find_spec("libusb_package"):
        import libusb_package

        environment["LD_PRELOAD"] = str(libusb_package.get_library_path())
    return environment


@contextmanager
def skipped_without_peers() -> Iterator[None]:
    """Turns the error about a missing peer, or an error that one caused, into a skipped test."""
    try:
        yield
    except ImportError as error:
        cause: BaseException | None = error
        while cause is not None:
            peer = (getattr(cause, "name", None) or "").partition(".")[0]
            if isinstance(cause, ModuleNotFoundError) and peer in PEERS and not find_spec(peer):
                pytest.skip(f"{peer} is not installed")
            cause = cause.__cause__ or cause.__context__
        raise


@pytest.hookimpl(wrapper=True)
def pytest_runtest_setup() -> Iterator[None]:
    with skipped_without_peers():
        return (yield)


@pytest.hookimpl(wrapper=True)
def pytest_runtest_call() -> Iterator[None]:
    with skipped_without_peers():
        return (yield)


def files(folder: Path) -> dict[str, bytes]:
    """The bytes of all files below a folder, by their paths in it."""
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def ticks_during(call):
    """How often another thread gets the interpreter during a call. Nobody has to give it up: only the call can release it."""
    ticks, started, done = 0, threading.Event(), threading.Event()

    def count():
        nonlocal ticks
        started.set()
        while not done.is_set():
            ticks += 1
            time.sleep(1e-4)

    interval = sys.getswitchinterval()
    sys.setswitchinterval(1000)
    counter = threading.Thread(target=count)
    try:
        counter.start()
        started.wait()
        before = ticks
        call()
        return ticks - before
    finally:
        done.set()
        counter.join()
        sys.setswitchinterval(interval)


def run_and_interrupt(text):
    """Runs a script that prints "ready" where it can be interrupted, and returns what it prints after that."""
    # Processes started in the background of a script ignore SIGINT, and their children inherit that. The alarm ends a script that
    # outlives the tests.
    script = f"import signal; signal.signal(signal.SIGINT, signal.default_int_handler); signal.alarm({2 * PATIENCE_S})\n" + text
    with subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE, text=True) as process:
        try:
            assert process.stdout.readline() == "ready\n"
            time.sleep(0.3)
            process.send_signal(signal.SIGINT)
            answer, _ = process.communicate(timeout=PATIENCE_S)
            return answer
        finally:
            process.kill()


@pytest.fixture(scope="session")
def device():
    return oaktwin.Device("OAK4-D")


@pytest.fixture(scope="session")
def calibration():
    """One unit's calibration."""
    return ROOT / "crates/calibration/fixtures/example-oak-d-pro-poe.json"


@pytest.fixture(scope="session")
def program():
    """Runs the program and returns its standard output."""
    named = os.environ.get("OAKTWIN_BIN")
    if not named:
        pytest.skip("OAKTWIN_BIN names no program: run by cargo xtask test")

    def run(*arguments, code=0):
        command = [named, *map(str, arguments)]
        done = subprocess.run(command, capture_output=True, text=True, encoding="utf-8")
        assert done.returncode == code, done.stderr
        return done.stderr if code == 2 else done.stdout

    return run


@pytest.fixture(scope="session")
def room():
    """Depth of a wall with a pole in front of it and a hole, metres, 60 x 106; and its colour image."""
    random = np.random.default_rng(3)
    depth = np.full((60, 106), 3.0, np.float32) + np.linspace(0, 1, 106, dtype=np.float32)
    depth[10:50, 40:52] = 1.1
    depth[30:36, 80:90] = np.inf
    depth[0, :3] = [np.nan, 0, -1]
    return depth, random.integers(0, 256, (60, 106, 3)).astype(np.uint8)


@pytest.fixture(scope="session")
def textured():
    """A slanted ground with a box in front of it, 120 x 320: left, right, disparity, and the mask without occlusions."""
    from stereo_scenes import box, everywhere, pair

    layers = [(everywhere, (9.3, 0.01, 0.02)), (box(140, 30, 220, 90), (31.7, 0.0, 0.0))]
    return pair(np.random.default_rng(5), 120, 320, layers, sigma=1.0)


@pytest.fixture(scope="module")
def matcher():
    return oaktwin.StereoMatcher(fx=FX, baseline=BASELINE)


def same(a, b):
    """Whether two results of a matcher are equal."""
    assert a.keys() == b.keys()
    assert [str(finding) for finding in a["findings"]] == [str(finding) for finding in b["findings"]]
    return all(a[name].dtype == b[name].dtype and np.array_equal(a[name], b[name]) for name in a if name != "findings")
