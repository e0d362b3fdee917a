"""Runs a program for DepthAI with a virtual device: `python -m oaktwin.depthai --model OAK4-D --scene room.usd -- my_app.py`."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

import numpy as np

from .._findings import Error
from ._recording import record
from ._run import Run, run_program
from ._twin import ENGINES
from ._world import Pose


def main(arguments: list[str] | None = None) -> int:
    """Runs the program and returns its exit code."""
    given = list(sys.argv[1:] if arguments is None else arguments)
    if "--" in given:
        split = given.index("--")
        given, program = given[:split], given[split + 1 :]
    else:
        program = []
    parser = _parser()
    options = parser.parse_args(given)
    if options.record is not None:
        if program or options.seconds is None:
            parser.error("--record takes --seconds, and no program")
    elif not program:
        parser.error("the program is missing; put it after --: ... -- my_app.py")
    elif not Path(program[0]).is_file():
        parser.error(f"{program[0]}: this file does not exist; put the program after --")
    try:
        pose = _pose(options)
        settings = {
            "scene": options.scene,
            "pose": pose,
            "look_at": options.look_at,
            "engine": options.engine,
            "fast": options.fast,
            "seed": options.seed,
            "ambient": options.ambient,
            "networks": dict(map(_network, options.network)),
        }
        device = options.calibration or options.model
        if options.record is not None:
            world = {name: settings[name] for name in ("scene", "pose", "look_at", "seed", "ambient")}
            record(options.record, device, seconds=options.seconds, fps=options.fps, **world)
            return 0
        run = Run(device, settings, program, options.headless, options.seconds)
        return run_program(run)
    except (Error, OSError) as error:
        print(f"oaktwin: {error}", file=sys.stderr)
        return 1


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="python -m oaktwin.depthai",
        description="Run a program for DepthAI with a virtual device.",
        usage="%(prog)s --model MODEL --scene FILE [options] -- my_app.py [its arguments]",
        allow_abbrev=False,
    )
    which = parser.add_mutually_exclusive_group(required=True)
    which.add_argument("--model", help="the name of a model, see `oaktwin models`")
    which.add_argument("--calibration", metavar="FILE", help="the calibration of one unit, .json")
    parser.add_argument("--scene", metavar="FILE", required=True, help="the scene: USD, glTF, Collada, OBJ, STL or PLY")
    where = parser.add_mutually_exclusive_group()
    where.add_argument(
        "--look-at", nargs=6, type=float, metavar="M", help="the position of the device and the point that it faces, in metres"
    )
    where.add_argument("--trajectory", metavar="FILE", help="poses of the body in the TUM format; they begin at time 0")
    parser.add_argument("--engine", choices=ENGINES, default=ENGINES[0], help="how StereoDepth measures (default: %(default)s)")
    parser.add_argument("--fast", action="store_true", help="do not wait between frames, and drop none")
    parser.add_argument("--headless", type=int, metavar="N", help="do not open windows, and press q after N frames; 0 for never")
    parser.add_argument("--seconds", type=float, metavar="T", help="end the program after T seconds, with the exit code 0")
    parser.add_argument("--network", metavar="NAME=FILE", action="append", default=[], help="an ONNX file for the model or node NAME; repeatable")
    parser.add_argument("--record", metavar="DIR", help="record T seconds for DepthAI's holistic replay instead of running a program")
    parser.add_argument("--fps", type=float, default=30.0, help="the images per second of --record (default: %(default)s)")
    parser.add_argument("--seed", type=int, default=0, help="the noise seed (default: %(default)s)")
    parser.add_argument("--ambient", type=float, default=1.0, help="the scale of the scene's lights (default: %(default)s)")
    return parser


def _network(text: str) -> tuple[str, str]:
    name, separator, path = text.partition("=")
    if not (name and separator and path):
        raise Error(f"--network: {text!r}; write NAME=FILE.onnx, where NAME is the model that the program asks for, or the node")
    return name, path


def _pose(options: argparse.Namespace) -> Pose | None:
    if options.trajectory is None:
        return None
    try:
        table = np.loadtxt(options.trajectory, ndmin=2)
    except ValueError as error:
        raise Error(f"{options.trajectory}: {error}; write lines of: time x y z qx qy qz qw") from error
    if table.shape[1] != 8:
        raise Error(f"{options.trajectory}: its lines have {table.shape[1]} numbers; write: time x y z qx qy qz qw")
    poses = np.tile(np.eye(4), (len(table), 1, 1))
    poses[:, :3, 3] = table[:, 1:4]
    poses[:, :3, :3] = [_rotation(*one) for one in table[:, 4:]]
    return table[:, 0] - table[0, 0], poses


def _rotation(x: float, y: float, z: float, w: float) -> np.ndarray:
    length = (x * x + y * y + z * z + w * w) ** 0.5
    if not 0.5 < length < 2:
        raise Error("trajectory: a quaternion has no length of 1; write: time x y z qx qy qz qw")
    x, y, z, w = x / length, y / length, z / length, w / length
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )


if __name__ == "__main__":
    sys.exit(main())
