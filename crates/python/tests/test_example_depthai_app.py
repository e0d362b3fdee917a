"""The repository of an application that is tested without a camera: `examples/depthai_app`."""

import subprocess
import sys

import pytest

from conftest import ROOT

pytest.importorskip("depthai")

APP = ROOT / "examples/depthai_app"


def test_its_tests_pass(tmp_path):
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", "tests"]
    done = subprocess.run(command, cwd=APP, capture_output=True, text=True, encoding="utf-8")
    assert done.returncode == 0, done.stdout + done.stderr
    assert "5 passed" in done.stdout


def test_its_workflow_runs_the_tests_without_more():
    """It installs the tests' requirements, which contain the application's with the DepthAI that virtual devices are tested with."""
    from oaktwin.depthai import TESTED

    workflow = (APP / ".github/workflows/test.yml").read_text("utf-8")
    assert "pip install -r requirements-test.txt" in workflow and "run: pytest" in workflow
    assert f"depthai=={TESTED}.*" in (APP / "requirements.txt").read_text("utf-8")
    assert (APP / "requirements-test.txt").read_text("utf-8").startswith("-r requirements.txt\n")
