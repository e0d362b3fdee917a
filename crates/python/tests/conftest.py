"""Fixtures and helpers of all tests of the package."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

import oaktwin

ROOT = Path(__file__).resolve().parents[3]
# The NumPy models of the sensors.
sys.path.append(str(ROOT / "tests/oracles"))


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--slow", action="store_true", help="also run the tests marked slow")


def pytest_configure(config: pytest.Config) -> None:
    config.addinivalue_line("markers", "slow: left out without --slow")


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    if not config.getoption("--slow"):
        for item in items:
            if item.get_closest_marker("slow"):
                item.add_marker(pytest.mark.skip(reason="slow: run with --slow"))


def run_and_interrupt(text):
    """Runs a script that prints "ready" and returns what it prints after being interrupted."""
    # Processes started in the background of a script ignore SIGINT, and their children inherit that.
    script = "import signal; signal.signal(signal.SIGINT, signal.default_int_handler)\n" + text
    with subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE, text=True) as process:
        try:
            assert process.stdout.readline() == "ready\n"
            time.sleep(0.3)
            process.send_signal(signal.SIGINT)
            answer, _ = process.communicate(timeout=120)
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
    """Depth of a wall with a pole before it and a hole, metres, 60 x 106; and a picture of it."""
    random = np.random.default_rng(3)
    depth = np.full((60, 106), 3.0, np.float32) + np.linspace(0, 1, 106, dtype=np.float32)
    depth[10:50, 40:52] = 1.1
    depth[30:36, 80:90] = np.inf
    depth[0, :3] = [np.nan, 0, -1]
    return depth, random.integers(0, 256, (60, 106, 3)).astype(np.uint8)
