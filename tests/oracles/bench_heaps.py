"""The processor time in which `oaktwin generate` makes a heap of 30 objects, and in which MuJoCo does.

    python bench_heaps.py PROGRAM

A third of the objects are cups, of 17 convex parts in MuJoCo. MuJoCo drops them in layers until none is faster than 2 cm/s, or for 5 s. The time of the program
is measured for a process that places the objects and lets them fall, minus the time of a process that only divides a cup into parts.
"""

import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import mujoco
import numpy as np

from test_heaps import PARTS, RECIPE, model, write_files

FRAMES = 10
COUNT = 30


def ours(program: str, folder: Path, recipe: str) -> float:
    """The mean processor time of a process, seconds."""
    (folder / "recipe.toml").write_text(recipe)
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    for frame in range(FRAMES):
        command = [program, "generate", folder / "recipe.toml", "--explain", str(frame)]
        subprocess.run(command, check=True, capture_output=True)
    return (resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before) / FRAMES


def theirs(seed: int) -> float:
    """The processor time of a heap, seconds."""
    random = np.random.default_rng(seed)
    objects = []
    for index in range(COUNT):
        place = [0.11 * (index % 3 - 1), 0.11 * (index // 3 % 2 - 0.5), 0.08 + 0.11 * (index // 6)]
        turn = random.normal(size=4)
        pose = {"position": place, "orientation": list(turn / np.linalg.norm(turn))}
        objects.append({"label": list(PARTS)[random.integers(len(PARTS))], "world_from_object": pose})
    compiled = model(objects)
    data = mujoco.MjData(compiled)
    start = time.process_time()
    while data.time < 5:
        mujoco.mj_step(compiled, data, nstep=50)
        if np.abs(data.qvel.reshape(-1, 6)[:, :3]).max() < 0.02:
            break
    return time.process_time() - start


def main() -> None:
    program = sys.argv[1]
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        write_files(folder)
        cup = RECIPE.format(frames=FRAMES, count=1).replace("'block.obj', 'can.obj', ", "")
        once = ours(program, folder, cup)
        heap = ours(program, folder, RECIPE.format(frames=FRAMES, count=COUNT)) - once
    peer = float(np.mean([theirs(seed) for seed in range(FRAMES)]))
    print(f"heap of {COUNT} objects: {heap:.2f} s; MuJoCo: {peer:.2f} s; ratio {peer / heap:.1f}")
    print(f"start of a process that divides a cup into convex parts: {once:.2f} s")


main()
