"""A unit's calibration in its asset, written completely and as overrides on the vendor's asset."""

import json
from pathlib import Path

import pytest
from pxr import Gf, Sdf, Usd, UsdGeom

import sheet
from assets import CALIBRATED, CASES, PLAIN, Builder, Case, unit
from test_usd_values import applied, cameras, prim_of, stage_of

CASES_CALIBRATED = [case for case in CASES if case.variant.offsets is not None]
LENS = "omni:lensdistortion:opencvPinhole:"
NAMES = ("k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6", "s1", "s2", "s3", "s4")


def intrinsics(camera: dict) -> tuple[float, float, float, float]:
    (fx, _, cx), (_, fy, cy), _ = camera["intrinsicMatrix"]
    return fx, fy, cx, cy


def offsets(camera: dict, column: sheet.Camera, sign: str) -> tuple[float, float]:
    """The offsets that each option authors: OpenUSD's window, the sheet's formula, or none."""
    _, _, cx, cy = intrinsics(camera)
    (width, height), pitch = column.size, column.pixel_um * 1e-3
    if sign == "openusd":
        return -(cx + 0.5 - width / 2) * pitch, (cy + 0.5 - height / 2) * pitch
    if sign == "document":
        return (cx - width / 2) * pitch, (cy - height / 2) * pitch
    return 0.0, 0.0


def rectified_role(case: Case, role: str) -> str:
    """The camera whose intrinsics a rectified image has: on RVC2 both images have the right one's."""
    return "right" if role == "left" and "4" not in case.model.name else role


def assert_calibrated(stage: Usd.Stage, case: Case, cameras_of_unit: dict[str, dict], sign: str) -> None:
    for name, column, _ in cameras(case):
        prim = prim_of(stage, case, name)
        camera = UsdGeom.Camera(prim)
        is_real = any(name == column.prim for column in case.model.cameras)
        data = cameras_of_unit[column.stereo_role if is_real else rectified_role(case, column.stereo_role)]
        fx, fy, cx, cy = intrinsics(data)
        pitch = column.pixel_um * 1e-3
        assert camera.GetFocalLengthAttr().Get() == pytest.approx(pitch * (fx + fy) / 2, rel=1e-5), name
        assert camera.GetHorizontalApertureAttr().Get() == pytest.approx(column.aperture[0], rel=1e-6)
        assert camera.GetVerticalApertureAttr().Get() == pytest.approx(column.aperture[1], rel=1e-6)
        expected = offsets(data, column, sign)
        assert camera.GetHorizontalApertureOffsetAttr().Get() == pytest.approx(expected[0], abs=1e-6), name
        assert camera.GetVerticalApertureOffsetAttr().Get() == pytest.approx(expected[1], abs=1e-6), name

        assert "OmniLensDistortionOpenCvPinholeAPI" in applied(prim), name
        assert prim.GetAttribute("omni:lensdistortion:model").Get() == "opencvPinhole"
        # Depth images are rectified: the virtual camera has a principal point and no distortion.
        coefficients = data["distortionCoeff"] if is_real else [0.0] * 14
        values = dict(zip(NAMES, coefficients, strict=False)) | {"fx": fx, "fy": fy, "cx": cx, "cy": cy}
        for attribute, value in values.items():
            assert prim.GetAttribute(LENS + attribute).Get() == pytest.approx(value, rel=1e-6, abs=1e-9), attribute
        assert prim.GetAttribute(LENS + "imageSize").Get() == Gf.Vec2i(column.size)


@pytest.mark.parametrize("case", CASES_CALIBRATED, ids=str)
def test_intrinsics(builder: Builder, case: Case) -> None:
    cameras_of_unit = unit(builder.calibration(case.model))
    assert case.variant.offsets is not None
    assert_calibrated(stage_of(builder, case), case, cameras_of_unit, case.variant.offsets)


@pytest.mark.parametrize("case", CASES_CALIBRATED, ids=str)
def test_depth_sensors(builder: Builder, case: Case) -> None:
    stage = stage_of(builder, case)
    cameras_of_unit = unit(builder.calibration(case.model))
    for depth in case.model.depths:
        prim = prim_of(stage, case, f"TemplateRenderProducts/{depth.prim}_render_product")
        role = rectified_role(case, case.model.camera(depth.camera).stereo_role)
        fx, _, _, _ = intrinsics(cameras_of_unit[role])
        expected = {name: value for name, (_, value) in depth.attributes("5.1").items()}
        expected["focalLengthPixel"] = float(round(fx))
        for name, value in expected.items():
            if name != "baselineMM":
                assert prim.GetAttribute(sheet.DEPTH_PREFIX + name).Get() == pytest.approx(value, rel=1e-6), name


@pytest.mark.parametrize("case", [case for case in CASES_CALIBRATED if case.variant.offsets == "openusd"], ids=str)
def test_openusd_sees_the_principal_point(builder: Builder, case: Case) -> None:
    """The offsets' sign, by OpenUSD's own frustum: a ray straight ahead meets the picture at (cx + ½, cy + ½)."""
    stage = stage_of(builder, case)
    cameras_of_unit = unit(builder.calibration(case.model))
    for column in case.model.cameras:
        window = UsdGeom.Camera(prim_of(stage, case, column.prim)).GetCamera().frustum.GetWindow()
        low, high = window.GetMin(), window.GetMax()
        width, height = column.size
        _, _, cx, cy = intrinsics(cameras_of_unit[column.stereo_role])
        assert width * -low[0] / (high[0] - low[0]) == pytest.approx(cx + 0.5, abs=1e-2)
        assert height * high[1] / (high[1] - low[1]) == pytest.approx(cy + 0.5, abs=1e-2)


# The prims of the asset that Isaac Sim ships, where they are not the sheet's.
SHIPPED = {"Camera_tof_33d": "Camera_33d", "Camera_pseudo_depth_stereo": "Camera_pseudo_depth"}


OVERRIDDEN = [pytest.param(model, {}, id=model.stem) for model in sheet.MODELS]
OVERRIDDEN += [pytest.param(m, SHIPPED, id=f"{m.stem}-shipped") for m in sheet.MODELS if m.stem == "oak_d_tof"]


@pytest.mark.parametrize(("model", "renamed"), OVERRIDDEN)
def test_overrides(builder: Builder, model: sheet.Model, renamed: dict[str, str], tmp_path: Path) -> None:
    text = builder.asset(Case(model, PLAIN)).read_text()
    for ours, theirs in renamed.items():
        text = text.replace(f'"{ours}"', f'"{theirs}"').replace(f"/{ours}>", f"/{theirs}>")
        text = text.replace(f'"{ours}_render_product"', f'"{theirs}_render_product"')
    vendor = tmp_path / f"{model.stem}.usd"
    vendor.write_text(text)
    unit_file, over = builder.calibration(model), tmp_path / "unit.usda"
    builder.run("asset", model.name, "--calibration", unit_file, "--over", vendor, "--format", "usda", "-o", over)
    assert vendor.read_text() == text, "the vendor's asset has changed"

    layer = Sdf.Layer.FindOrOpen(str(over))
    specifiers: list[tuple[str, Sdf.Specifier]] = []
    layer.Traverse("/", lambda path: path.IsPrimPath() and specifiers.append((str(path), layer.GetPrimAtPath(path).specifier)))
    assert specifiers and {kind for _, kind in specifiers} <= {Sdf.SpecifierOver}, "nothing is defined again"

    stage, before = Usd.Stage.Open(str(over)), Usd.Stage.Open(str(vendor))
    assert stage.GetDefaultPrim().GetPath() == before.GetDefaultPrim().GetPath()
    assert UsdGeom.GetStageMetersPerUnit(stage) == 1.0 and UsdGeom.GetStageUpAxis(stage) == "Z"
    assert [str(p.GetPath()) for p in stage.TraverseAll()] == [str(p.GetPath()) for p in before.TraverseAll()]
    cameras_of_unit = unit(unit_file)
    for column in model.cameras:
        prim = stage.GetPrimAtPath(f"/Root/{model.prim}/{renamed.get(column.prim, column.prim)}")
        fx, fy, _, _ = intrinsics(cameras_of_unit[column.stereo_role])
        assert prim.GetAttribute("focalLength").Get() == pytest.approx(column.pixel_um * 1e-3 * (fx + fy) / 2, rel=1e-5)
        assert prim.GetAttribute("horizontalAperture").Get() == pytest.approx(column.aperture[0], rel=1e-6)
        assert prim.GetAttribute("clippingRange").Get() == Gf.Vec2f(*sheet.CLIPPING_RANGE)


def test_the_made_up_units_differ_from_the_nominal_ones(builder: Builder) -> None:
    for model in sheet.MODELS:
        nominal = json.loads(builder.calibration(model).with_suffix(".nominal.json").read_text())
        assert nominal["cameraData"] != json.loads(builder.calibration(model).read_text())["cameraData"]
    assert len(CALIBRATED) == 3
