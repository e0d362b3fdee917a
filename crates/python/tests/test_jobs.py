"""What people do with the package, each job as a short script: it runs, and is strictly typed."""

import json
import os
import re
import shutil
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

import pytest

from conftest import PEERS, ROOT, environment_with_libusb
from test_generate import RECIPE

JOBS = sorted(Path(__file__).with_name("jobs").glob("*.py"))
# The lines of a job, without its description and empty lines.
MOST_LINES = 25


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """The files that the jobs read."""
    folder = tmp_path_factory.mktemp("jobs")
    for name in ["depth_sensor.usda", "grid.png"]:
        shutil.copy(ROOT / "examples/depth_sensor" / name, folder)
    (folder / "depth_sensor.usda").rename(folder / "scene.usda")
    shutil.copy(ROOT / "crates/calibration/fixtures/example-oak-d-pro-poe.json", folder / "calibration.json")
    (folder / "recipe.toml").write_text(RECIPE)
    return folder


@pytest.mark.parametrize("job", JOBS, ids=lambda job: job.stem)
def test_a_job_runs(job, folder):
    text = job.read_text()
    for name in re.findall(r"^import (\w+)", text, re.MULTILINE):
        if name in PEERS | {"matplotlib", "mujoco"} and not find_spec(name):
            pytest.skip(f"{name} is not installed")
    lines = [line for line in text.splitlines()[1:] if line.strip()]
    assert len(lines) <= MOST_LINES
    done = subprocess.run([sys.executable, job], capture_output=True, text=True, cwd=folder, env=environment_with_libusb())
    assert done.returncode == 0, done.stderr


def test_there_are_ten():
    assert len(JOBS) == 10


def test_they_are_strictly_typed(tmp_path):
    pytest.importorskip("mypy")
    environment = {**os.environ, "MYPY_CACHE_DIR": str(tmp_path)}
    options = ["--strict", "--ignore-missing-imports", "--scripts-are-modules"]
    for files in [JOBS, [ROOT / "examples/python/neural_stereo.py"]]:
        command = [sys.executable, "-m", "mypy", *options, *map(str, files)]
        done = subprocess.run(command, capture_output=True, text=True, cwd=tmp_path, env=environment)
        assert done.returncode == 0, done.stdout + done.stderr


def test_pyright_is_content(tmp_path):
    pytest.importorskip("pyright")
    started = subprocess.run([sys.executable, "-m", "pyright", "--version"], capture_output=True, text=True)
    if started.returncode != 0:
        # The package loads the program from npm when it first runs.
        pytest.skip(f"pyright does not start: {started.stderr.strip()[-200:]}")
    shutil.copytree(JOBS[0].parent, tmp_path / "jobs")
    settings = {"include": ["jobs"], "typeCheckingMode": "strict"}
    (tmp_path / "pyrightconfig.json").write_text(json.dumps(settings))
    command = [sys.executable, "-m", "pyright", "--pythonpath", sys.executable, "--project", tmp_path]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
