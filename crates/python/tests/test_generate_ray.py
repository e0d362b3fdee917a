"""Data sets whose frames Ray distributes: the bytes are the same as with one process, even if a worker is killed."""

import json
import os
import resource
import shutil
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import pytest

import oaktwin
from conftest import PATIENCE_S, ROOT, files

ray = pytest.importorskip("ray", reason="Ray is not installed", exc_type=ImportError)
from oaktwin import _ray  # noqa: E402

RECIPES = ROOT / "examples/recipes"
FRAMES = 48
RECIPE = f"""
frames = {FRAMES}
frames_per_scene = 2
scene = '{RECIPES}/table.usda'
[[objects]]
files = '{RECIPES}/objects/'
count = 3
on = '/World/Table'
[unit]
drift = {{ pitch_mrad = {{ normal = [0, 0.5] }} }}
[camera]
resolution = [160, 100]
[output]
formats = ['bop', 'webdataset']
shard_frames = 10
"""


@pytest.fixture(scope="module")
def recipe(tmp_path_factory):
    path = tmp_path_factory.mktemp("recipe") / "recipe.toml"
    path.write_text(RECIPE)
    return path


@pytest.fixture(scope="module")
def whole(recipe):
    oaktwin.generate(recipe, recipe.parent / "whole")
    return files(recipe.parent / "whole")


@pytest.fixture(autouse=True)
def no_cluster(monkeypatch):
    monkeypatch.delenv("RAY_ADDRESS", raising=False)


@pytest.fixture(scope="module")
def cluster():
    """A connection to a cluster on this machine, which takes seconds to start."""
    ray.init(num_cpus=3, include_dashboard=False, log_to_driver=False, object_store_memory=80 << 20)
    yield
    ray.shutdown()


def workers() -> list[int]:
    """Returns the processes that make frames, whichever program started them."""
    found = []
    for folder in Path("/proc").glob("[0-9]*"):
        try:
            if (folder / "cmdline").read_bytes().startswith(b"ray::make"):
                found.append(int(folder.name))
        except OSError:
            pass  # The process has ended.
    return found


def is_ours(process: int) -> bool:
    """Whether this process started another, or a parent of it. Not if that has ended."""
    try:
        while process > 1 and process != os.getpid():
            process = int(Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[1])
    except OSError:
        return False
    return process > 1


def kill_one(folder: Path, killed: list[int], is_over: threading.Event) -> None:
    """Kills our first worker that is found once some frames are complete; keeps the number of these."""
    while not killed and not is_over.wait(0.01):
        complete = len(list(folder.glob(".oaktwin/frames/*.json")))
        for worker in filter(is_ours, workers() if complete >= 4 else []):
            os.kill(worker, signal.SIGKILL)
            killed.append(complete)
            break


@pytest.mark.skipif(sys.platform != "linux", reason="workers are found in /proc")
def test_a_killed_worker_changes_nothing(recipe, whole, tmp_path):
    """Here in a cluster that starts and ends with the data set."""
    killed: list[int] = []
    is_over = threading.Event()
    killer = threading.Thread(target=kill_one, args=(tmp_path / "set", killed, is_over))
    killer.start()
    done = oaktwin.generate(recipe, tmp_path / "set", ray=True, workers=2)
    is_over.set()
    killer.join()
    assert done["frames"] == FRAMES and killed and killed[0] < FRAMES - 2
    left = {name: content for name, content in files(tmp_path / "set").items() if not name.endswith(".part")}
    assert left == whole
    again = oaktwin.generate(recipe, tmp_path / "set", ray=True, resume=True)
    assert (again["frames"], again["skipped"]) == (0, FRAMES) and not ray.is_initialized()


def test_a_missing_cluster(recipe, tmp_path):
    with pytest.raises(oaktwin.Error, match=r"cannot connect to 127.0.0.1:9 \(.*\); start a cluster"):
        oaktwin.generate(recipe, tmp_path / "set", ray="127.0.0.1:9")


# The tests of the program start one cluster of two workers, and one of one.
@pytest.mark.parametrize("count", [1, 3])
def test_the_bytes_do_not_depend_on_the_workers(cluster, recipe, whole, tmp_path, count):
    done = oaktwin.generate(recipe, tmp_path / "set", ray=True, workers=count)
    assert (done["frames"], done["skipped"], done["missing"]) == (FRAMES, 0, 0)
    assert files(tmp_path / "set") == whole


def test_errors(cluster, recipe, tmp_path, monkeypatch):
    crowded = tmp_path / "crowded.toml"
    crowded.write_text(RECIPE.replace("count = 3", "count = 400"))
    with pytest.raises(oaktwin.Error) as here:
        oaktwin.generate(crowded, tmp_path / "here", frames=(0, 1))
    with pytest.raises(oaktwin.Error) as there:
        oaktwin.generate(crowded, tmp_path / "there", frames=(0, 1), ray=True, workers=1)
    assert str(here.value) == str(there.value)
    with pytest.raises(oaktwin.Error, match="only_frames: has no effect with Ray"):
        oaktwin.generate(recipe, tmp_path / "set", ray=True, only_frames=True)
    monkeypatch.setattr(_ray, "frames", lambda batches, job, **_: iter(batches))
    with pytest.raises(oaktwin.Error, match="frame 0 was made on another machine, but is not here; choose a folder that all"):
        oaktwin.generate(recipe, tmp_path / "set", ray=True, resume=True)


def test_a_recipe_may_change_between_runs(cluster, recipe, tmp_path):
    """Also if the workers, which keep a recipe open, are from the previous run."""
    changed = tmp_path / "recipe.toml"
    for height in [100, 90]:
        changed.write_text(RECIPE.replace("[160, 100]", f"[160, {height}]"))
        shutil.rmtree(tmp_path / "set", ignore_errors=True)
        oaktwin.generate(changed, tmp_path / "set", frames=(0, 4), ray=True, workers=1)
        assert json.loads((tmp_path / "set/bop/camera.json").read_text())["height"] == height
    assert ray.is_initialized()


def test_the_program_makes_the_same(recipe, whole, tmp_path):
    run = [sys.executable, "-m", "oaktwin", "generate", recipe, "-o", tmp_path / "set"]
    done = subprocess.run([*run, "--ray", "local", "--workers", "2"], capture_output=True, text=True)
    assert done.returncode == 0 and f"{FRAMES} frames" in done.stdout, done.stderr
    assert files(tmp_path / "set") == whole
    wrong = subprocess.run([*run[:-1], tmp_path / "other", "--ray", "127.0.0.1:9"], capture_output=True, text=True)
    assert wrong.returncode == 2 and wrong.stderr.startswith("error: ray: cannot connect to 127.0.0.1:9")


def test_an_interrupted_program_resumes(recipe, whole, tmp_path):
    run = [sys.executable, "-m", "oaktwin", "generate", recipe, "-o", tmp_path / "set", "--ray", "local", "--workers", "1"]
    with subprocess.Popen(run, stdout=subprocess.PIPE, text=True) as process:
        while len(list(tmp_path.glob("set/.oaktwin/frames/*.json"))) < 4:
            assert process.poll() is None
            time.sleep(0.01)
        process.send_signal(signal.SIGINT)
        output, _ = process.communicate(timeout=PATIENCE_S)
    assert process.returncode == 130 and "interrupted: continue with --resume" in output
    # Ray's worker ends when its driver does; until then it may complete the frames that it is making.
    deadline = time.monotonic() + 30
    while workers() and time.monotonic() < deadline:
        time.sleep(0.1)
    resumed = oaktwin.generate(recipe, tmp_path / "set", resume=True)
    assert resumed["frames"] > 0 and resumed["skipped"] >= 4
    assert files(tmp_path / "set") == whole


def test_the_driver_stays_small(cluster):
    """100 000 planned frames: neither memory nor the time for a task grows with their number."""
    batches = [(first, first + 16) for first in range(0, 100_000, 16)]

    # Defined here, so that workers do not need this module.
    def nothing(batch, job, version):
        return batch

    memory, times, done = [], [time.perf_counter()], set()
    for batch in _ray.frames(batches, {}, workers=2, task=nothing):
        done.add(batch)
        if len(done) % 1250 == 0:
            memory.append(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024)
            times.append(time.perf_counter())
    assert done == set(batches)
    steps = [f"{after - before:.1f} s" for before, after in zip(times, times[1:])]
    print(f"\n1250 tasks: {', '.join(steps)}; memory: {', '.join(f'{size:.0f}' for size in memory)} MiB")
    assert memory[-1] - memory[0] < 16
