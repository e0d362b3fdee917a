"""OpenUSD reads the asset of every model of the catalog: its cameras have the fields of view and places that the program shows."""

import json
import math
import subprocess
from pathlib import Path

import pytest
from pxr import Usd, UsdGeom


@pytest.fixture(scope="module")
def folder(program: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("models")
    for extension in ("usd", "usdz"):
        subprocess.run([program, "asset", "all", "-o", folder, "--format", extension], check=True, capture_output=True)
    return folder


def printed(program: Path, *args: str):
    return json.loads(subprocess.run([program, *args, "--json"], check=True, capture_output=True).stdout)


def test_every_model(program: Path, folder: Path):
    models = printed(program, "models")
    assert len(models) > 25
    for model in models:
        shown = printed(program, "show", model["id"])
        for extension in ("usd", "usdz"):
            stage = Usd.Stage.Open(str(folder / f"{model['id']}.{extension}"))
            assert UsdGeom.GetStageUpAxis(stage) == "Z" and UsdGeom.GetStageMetersPerUnit(stage) == 1
            device = stage.GetDefaultPrim().GetChildren()[0]
            assert device.GetName() == shown["prim"]
            cameras = {prim.GetName() for prim in device.GetChildren() if prim.IsA(UsdGeom.Camera)}
            assert cameras == {*model["depth_sensors"], *(camera["prim"] for camera in model["cameras"])}
            for camera in shown["cameras"]:
                prim = UsdGeom.Camera(device.GetChild(camera["prim"]))
                aperture, focal = prim.GetHorizontalApertureAttr().Get(), prim.GetFocalLengthAttr().Get()
                hfov = 2 * math.degrees(math.atan(aperture / (2 * focal)))
                assert hfov == pytest.approx(camera["nominal_hfov_deg"], abs=1e-4)
                body_from_camera = prim.GetLocalTransformation()
                assert [*body_from_camera.ExtractTranslation()] == pytest.approx(
                    [mm / 1000 for mm in camera["position_mm"]], abs=1e-7
                )
                forward = body_from_camera.TransformDir((0, 0, -1))
                pitch = math.degrees(math.asin(forward[2]))
                assert pitch == pytest.approx(camera["yaw_pitch_deg"][1], abs=1e-4)
