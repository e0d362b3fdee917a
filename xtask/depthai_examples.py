"""Runs DepthAI's own examples on a virtual device, and prints a table for the manual. Run by `cargo xtask depthai-examples`.

EXAMPLES is the folder examples/python of a checkout of luxonis/depthai-core. Needs oaktwin, depthai and OpenCV 4.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
from pathlib import Path

# What examples expect on their command lines, and the models that some folders need. CALIBRATION stands for a file of the model.
ARGUMENTS = {
    "calibration_load.py": ["CALIBRATION"],
    "camera_multiple_outputs.py": "640 480 0 30 CAM_A 300 300 0 30 CAM_A 300 300 1 30 CAM_A".split(),
    "camera_timings.py": "640 480 0 30".split(),
}
MODELS = {"ToF": "OAK-D ToF"}
NETWORKS = (
    "runs a neural network",
    "without a network of yours",
    "getModelFromZoo",
    "NNArchive",
    "NNModelDescription",
    "blobconverter",
    "Failed to download",
)


def main() -> None:
    parser = argparse.ArgumentParser(description="Run DepthAI's examples on a virtual device.")
    parser.add_argument("examples", type=Path, help="examples/python of a checkout of luxonis/depthai-core")
    parser.add_argument("--scene", required=True, help="the scene that they see")
    parser.add_argument("--model", default="OAK-D-Pro-PoE", help="the model (default: %(default)s)")
    parser.add_argument("--seconds", type=float, default=20.0, help="the time of each (default: %(default)s)")
    parser.add_argument("--calibration", type=Path, default="calibration.json", help="a calibration of the model (default: %(default)s)")
    options = parser.parse_args()
    counts: dict[str, int] = {}
    print("| example | result |\n|---|---|")
    for script in sorted(options.examples.rglob("*.py")):
        result = run(script, options)
        kind = result.partition(":")[0]
        counts[kind] = counts.get(kind, 0) + 1
        print(f"| `{script.relative_to(options.examples)}` | {result} |", flush=True)
    print("\n" + ", ".join(f"{kind}: {count}" for kind, count in sorted(counts.items())))


def run(script: Path, options: argparse.Namespace) -> str:
    """Runs one example and says what became of it."""
    place = ["--look-at", "0", "0", "1.15", "1", "0", "1.03"]
    model = next((model for folder, model in MODELS.items() if folder in script.parts), options.model)
    command = [sys.executable, "-m", "oaktwin.depthai", "--model", model, "--scene", str(Path(options.scene).resolve()), *place]
    command += ["--engine", "stereo-noise", "--headless", "3", "--seconds", str(options.seconds)]
    calibration = str(options.calibration.resolve())
    command += ["--", script.name, *(calibration if one == "CALIBRATION" else one for one in ARGUMENTS.get(script.name, []))]
    try:
        done = subprocess.run(
            command,
            cwd=script.parent,
            env={**os.environ, "DEPTHAI_TELEMETRY": "0"},
            capture_output=True,
            text=True,
            errors="replace",
            timeout=options.seconds + 60,
        )
    except subprocess.TimeoutExpired:
        return "why not: it does not end"
    if done.returncode == 0:
        return "runs"
    if any(sign in done.stderr + done.stdout for sign in NETWORKS):
        return "needs a network"
    lines = [line.strip() for line in done.stderr.splitlines() if line.strip()]
    reason = lines[-1] if lines else f"exit code {done.returncode}"
    return "why not: " + reason.replace("|", "/")[:160]


if __name__ == "__main__":
    main()
