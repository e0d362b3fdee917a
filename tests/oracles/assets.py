"""The assets under test: models, options and formats, built by the program on first use."""

import json
import math
import os
import subprocess
import sys
from collections.abc import Iterable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

import sheet

FORMATS = ("usda", "usd", "usdz")
HERE = Path(__file__).parent


@dataclass(frozen=True)
class Variant:
    """A choice of options, and the expected content of the asset."""

    name: str
    args: tuple[str, ...] = ()
    isaac: str = "5.1"
    target: str = "isaac"
    legacy: bool = True
    extended: bool = False
    fisheye: bool = False
    body: bool = True
    rigid: bool = False
    offsets: str | None = None

    def suits(self, model: sheet.Model) -> bool:
        return (model.wide or not self.fisheye) and (model.has_extended_disparity or not self.extended)


PLAIN = Variant("plain")
CALIBRATED = tuple(
    Variant(f"calibrated-{sign}", ("--aperture-offsets", sign), offsets=sign) for sign in ("openusd", "document", "zero")
)
VARIANTS = (
    PLAIN,
    Variant("isaac-6", ("--isaac", "6"), isaac="6", legacy=False),
    Variant("isaac-6-legacy", ("--isaac", "6", "--legacy-distortion"), isaac="6"),
    Variant("ovrtx", ("--target", "ovrtx"), isaac="6", target="ovrtx", legacy=False),
    Variant("extended", ("--extended-disparity",), extended=True),
    Variant("fisheye", ("--lens", "fisheye"), fisheye=True),
    Variant("rigid-body", ("--rigid-body",), rigid=True),
    Variant("no-body", ("--no-body",), body=False),
    *CALIBRATED,
)


@dataclass(frozen=True)
class Case:
    """One model with one choice of options."""

    model: sheet.Model
    variant: Variant

    def __str__(self) -> str:
        return f"{self.model.stem}-{self.variant.name}"


def models_of(number: int) -> tuple[sheet.Model, ...]:
    """Returns the models that a variant is tested with.

    The plain variant and the first calibrated one are tested with every model that they suit, the others with two models each.
    """
    variant = VARIANTS[number]
    suited = tuple(model for model in sheet.MODELS if variant.suits(model))
    if variant in (PLAIN, CALIBRATED[0]):
        return suited
    return tuple(suited[(number + step) % len(suited)] for step in (0, len(suited) // 2))


CASES = tuple(Case(model, variant) for number, variant in enumerate(VARIANTS) for model in models_of(number))
NOMINAL = tuple(case for case in CASES if case.variant.offsets is None)


class Builder:
    """Runs the program, each combination once."""

    def __init__(self, program: Path, folder: Path) -> None:
        self.program = program
        self.folder = folder

    def run(self, *args: str | Path) -> str:
        done = subprocess.run([self.program, *args], capture_output=True, text=True, check=False)
        assert done.returncode == 0, f"oaktwin {' '.join(map(str, args))}: {done.returncode}\n{done.stdout}{done.stderr}"
        return done.stdout

    def asset(self, case: Case, extension: str = "usda") -> Path:
        folder = self.folder / str(case) / extension
        path = folder / f"{case.model.stem}.{extension}"
        if not path.exists():
            self.write(case, extension, folder)
            assert path.exists(), f"wrote {sorted(folder.iterdir())} and not {path.name}"
        return path

    def write(self, case: Case, extension: str, folder: Path) -> None:
        folder.mkdir(parents=True, exist_ok=True)
        args = ["asset", case.model.name, "-o", folder, "--format", extension, *case.variant.args]
        if case.variant.offsets is not None:
            args += ["--calibration", self.calibration(case.model)]
        self.run(*args)

    def calibration(self, model: sheet.Model) -> Path:
        """A synthetic unit of a model: its nominal calibration with every camera slightly displaced."""
        path = self.folder / "calibration" / f"{model.stem}.json"
        if not path.exists():
            path.parent.mkdir(exist_ok=True)
            nominal = path.with_suffix(".nominal.json")
            self.run("calibration", "export", model.name, "--to", "depthai", "-o", nominal)
            path.write_text(json.dumps(put_off(json.loads(nominal.read_text())), indent=4))
        return path


COEFFICIENTS = (
    # k1 k2 p1 p2 k3 k4 k5 k6 s1 s2 s3 s4, and no tilt: the schema cannot carry one.
    (7.5, -42.25, 0.00075, -0.00125, 118.5, 7.25, -41.5, 117.0, 0.0005, -0.00025, 0.001, -0.0015, 0.0, 0.0)
)


def put_off(calibration: dict) -> dict:
    """Other focal lengths, principal points and coefficients for each camera, none of them round."""
    for index, (_, camera) in enumerate(calibration["cameraData"]):
        matrix = camera["intrinsicMatrix"]
        matrix[0][0] *= 1.0 + 0.003 * (index + 1)
        matrix[1][1] *= 1.0 + 0.002 * (index + 1)
        matrix[0][2] += 5.75 + index
        matrix[1][2] -= 3.25 + 2 * index
        camera["distortionCoeff"] = list(COEFFICIENTS)
        camera["cameraType"] = 0
    return calibration


def unit(calibration: Path) -> dict[str, dict]:
    """The cameras of a DepthAI calibration by the role that the sheet's prims have: left, right, mono."""
    read = json.loads(calibration.read_text())
    stereo = read["stereoRectificationData"]
    sides = {stereo["leftCameraSocket"]: "left", stereo["rightCameraSocket"]: "right"}
    return {sides.get(socket, "mono"): camera for socket, camera in read["cameraData"]}


def schema_folder(isaac: str, folder: Path) -> Path:
    """The test schema in the form of one generation of Isaac Sim."""
    source = HERE / "schema"
    if isaac == "5.1":
        return source
    made = folder / f"schema-{isaac}"
    made.mkdir(exist_ok=True)
    text = (source / "generatedSchema.usda").read_text()
    old, new = "int omni:rtx:post:depthSensor:outlierRemovalEnabled = 3", "bool omni:rtx:post:depthSensor:outlierRemovalEnabled = 1"
    assert old in text
    (made / "generatedSchema.usda").write_text(text.replace(old, new))
    (made / "plugInfo.json").write_text((source / "plugInfo.json").read_text())
    return made


def openusd_says(paths: Iterable[Path], schema: Path | None, *checks: str) -> list[dict[str, list[str]]]:
    """The findings of each file by check, from processes that know the schema, or none."""
    every = list(paths)
    share = max(1, math.ceil(len(every) / (os.cpu_count() or 1)))
    shares = [every[start : start + share] for start in range(0, len(every), share)]
    with ThreadPoolExecutor() as pool:
        return [answer for answers in pool.map(lambda some: _says(some, schema, checks), shares) for answer in answers]


def _says(paths: list[Path], schema: Path | None, checks: tuple[str, ...]) -> list[dict[str, list[str]]]:
    environment = {name: value for name, value in os.environ.items() if not name.startswith(("PXR_", "TF_"))}
    if schema is not None:
        environment["PXR_PLUGINPATH_NAME"] = str(schema)
    done = subprocess.run(
        [sys.executable, HERE / "openusd_says.py", *checks],
        input="\n".join(map(str, paths)), env=environment, capture_output=True, text=True, check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return json.loads(done.stdout)
