"""Every value of the sheet, read back by OpenUSD."""

import math
from pathlib import Path

import pytest
from pxr import Gf, Usd, UsdGeom

import sheet
from assets import CASES, NOMINAL, Builder, Case

HALF_A_DIGIT = 5e-5


def stage_of(builder: Builder, case: Case) -> Usd.Stage:
    return Usd.Stage.Open(str(builder.asset(case)))


def prim_of(stage: Usd.Stage, case: Case, name: str) -> Usd.Prim:
    prim = stage.GetPrimAtPath(f"/Root/{case.model.prim}/{name}")
    assert prim, f"no {name} among {[p.GetName() for p in stage.GetPrimAtPath(f'/Root/{case.model.prim}').GetChildren()]}"
    return prim


def applied(prim: Usd.Prim) -> list[str]:
    """The API schemas as authored: OpenUSD itself drops those that it does not know."""
    listed = prim.GetMetadata("apiSchemas")
    return list(listed.GetAddedOrExplicitItems()) if listed else []


def cameras(case: Case) -> list[tuple[str, sheet.Camera, str]]:
    """Every camera prim with its name, its column in the sheet and its stereoRole."""
    real = [(camera.prim, camera, camera.stereo_role) for camera in case.model.cameras]
    return real + [(depth.prim, case.model.camera(depth.camera), "mono") for depth in case.model.depths]


@pytest.mark.parametrize("case", CASES, ids=str)
def test_stage(builder: Builder, case: Case) -> None:
    stage = stage_of(builder, case)
    assert stage.GetDefaultPrim().GetPath() == "/Root"
    assert UsdGeom.GetStageUpAxis(stage) == UsdGeom.Tokens.z
    assert UsdGeom.GetStageMetersPerUnit(stage) == 1.0
    for path, kind in (("/Root", "Xform"), (f"/Root/{case.model.prim}", "Xform")):
        assert stage.GetPrimAtPath(path).GetTypeName() == kind
    found = {prim.GetName() for prim in stage.Traverse() if prim.IsA(UsdGeom.Camera)}
    assert found == {name for name, _, _ in cameras(case)}
    body = {name: bool(stage.GetPrimAtPath(f"/Root/{case.model.prim}/{name}")) for name in ("visuals", "Looks")}
    assert body == {"visuals": case.variant.body, "Looks": case.variant.body}


@pytest.mark.parametrize("case", NOMINAL, ids=str)
def test_cameras(builder: Builder, case: Case) -> None:
    stage = stage_of(builder, case)
    for name, column, role in cameras(case):
        camera = UsdGeom.Camera(prim_of(stage, case, name))
        assert camera.GetFocalLengthAttr().Get() == pytest.approx(column.focal_length, abs=HALF_A_DIGIT)
        assert camera.GetHorizontalApertureAttr().Get() == Gf.Vec2f(column.aperture)[0]
        assert camera.GetVerticalApertureAttr().Get() == Gf.Vec2f(column.aperture)[1]
        assert camera.GetHorizontalApertureOffsetAttr().Get() == 0.0
        assert camera.GetVerticalApertureOffsetAttr().Get() == 0.0
        assert camera.GetFocusDistanceAttr().Get() == column.focus_distance
        assert camera.GetFStopAttr().Get() == 0.0
        assert camera.GetProjectionAttr().Get() == "perspective"
        assert camera.GetStereoRoleAttr().Get() == role
        assert camera.GetClippingRangeAttr().Get() == Gf.Vec2f(*sheet.CLIPPING_RANGE)
        authored = {"focalLength", "horizontalAperture", "verticalAperture", "focusDistance", "fStop", "clippingRange"}
        assert authored <= set(camera.GetPrim().GetAuthoredPropertyNames())


@pytest.mark.parametrize("case", NOMINAL, ids=str)
def test_field_of_view(builder: Builder, case: Case) -> None:
    stage = stage_of(builder, case)
    for name, column, _ in cameras(case):
        view = UsdGeom.Camera(prim_of(stage, case, name)).GetCamera()
        # Half of the fourth digit of the focal length is below 2e-3 degrees for every lens of the sheet.
        assert view.GetFieldOfView(Gf.Camera.FOVHorizontal) == pytest.approx(column.hfov_deg, abs=2e-3)
        width, height = column.size
        assert view.aspectRatio == pytest.approx(width / height, rel=1e-6)


@pytest.mark.parametrize("case", [case for case in NOMINAL if case.variant.target == "isaac"], ids=str)
def test_distortion_columns(builder: Builder, case: Case) -> None:
    stage = stage_of(builder, case)
    for column in case.model.cameras:
        prim = prim_of(stage, case, column.prim)
        authored = set(prim.GetAuthoredPropertyNames())
        assert not authored & {"physicalDistortionModel", "physicalDistortionCoefficients"}
        fisheye = case.variant.fisheye and column.stereo_role != "mono"
        if not case.variant.legacy:
            assert not authored & (sheet.legacy(column).keys() | {"cameraProjectionType"})
        elif not fisheye:
            assert prim.GetAttribute("cameraProjectionType").Get() == "pinhole"
            for name, value in sheet.legacy(column).items():
                assert prim.GetAttribute(name).Get() == pytest.approx(value, rel=1e-6), name
                assert prim.GetAttribute(name).GetTypeName() == "float", name
        if not fisheye:
            assert not any(name.startswith("omni:lensdistortion") for name in authored)


@pytest.mark.parametrize("case", [case for case in CASES if case.variant.fisheye], ids=str)
def test_fisheye(builder: Builder, case: Case) -> None:
    stage = stage_of(builder, case)
    prefix = "omni:lensdistortion:opencvFisheye:"
    # An equidistant lens: the sensor's width over the angle that the vendor gives.
    focal = 1280 / math.radians(127)
    values = {"fx": focal, "fy": focal, "cx": 640.0, "cy": 400.0, "k1": 0.0, "k2": 0.0, "k3": 0.0, "k4": 0.0}
    for column in case.model.cameras:
        prim = prim_of(stage, case, column.prim)
        has = "OmniLensDistortionOpenCvFisheyeAPI" in applied(prim)
        assert has == (column.stereo_role != "mono")
        if has:
            assert prim.GetAttribute("omni:lensdistortion:model").Get() == "opencvFisheye"
            assert prim.GetAttribute(prefix + "imageSize").Get() == Gf.Vec2i(1280, 800)
            for name, value in values.items():
                # Centred: 639.5 in OpenCV's convention, 640 in USD's.
                tolerance = 0.5 if name in ("cx", "cy") else 1e-3
                assert prim.GetAttribute(prefix + name).Get() == pytest.approx(value, abs=tolerance), name
    for depth in case.model.depths:
        assert not applied(prim_of(stage, case, depth.prim))


@pytest.mark.parametrize("case", [case for case in NOMINAL if case.variant.target == "isaac"], ids=str)
def test_depth_sensors(builder: Builder, case: Case) -> None:
    stage = stage_of(builder, case)
    for depth in case.model.depths:
        prim = prim_of(stage, case, f"TemplateRenderProducts/{depth.prim}_render_product")
        expected = depth.attributes(case.variant.isaac, case.variant.extended)
        authored = {
            name.removeprefix(sheet.DEPTH_PREFIX)
            for name in prim.GetAuthoredPropertyNames()
            if name.startswith(sheet.DEPTH_PREFIX)
        }
        assert authored == expected.keys(), "the sheet's attributes and no others"
        for name, (kind, value) in expected.items():
            attribute = prim.GetAttribute(sheet.DEPTH_PREFIX + name)
            assert attribute.GetTypeName() == kind, name
            assert attribute.Get() == pytest.approx(value, rel=1e-6), name
            assert not attribute.IsCustom(), name
            assert attribute.GetVariability().displayName == "Varying", name
        assert prim.GetAttribute("resolution").Get() == Gf.Vec2i(case.model.camera(depth.camera).size)


def products_as_isaac_finds_them(stage: Usd.Stage, root: str) -> dict[str, Usd.Prim]:
    """The template lookup of Isaac Sim: products with the schema and one camera, by the camera's path."""
    found = {}
    for prim in Usd.PrimRange(stage.GetPrimAtPath(root)):
        if prim.GetTypeName() != "RenderProduct" or sheet.DEPTH_API not in applied(prim):
            continue
        targets = prim.GetRelationship("camera").GetTargets()
        if len(targets) == 1 and stage.GetPrimAtPath(targets[0]).IsA(UsdGeom.Camera):
            found[str(targets[0])] = prim
    return found


@pytest.mark.parametrize("case", [case for case in CASES if case.variant.target == "isaac"], ids=str)
def test_isaac_finds_the_products(builder: Builder, case: Case, tmp_path: Path) -> None:
    base = f"/Root/{case.model.prim}"
    stage = stage_of(builder, case)
    found = products_as_isaac_finds_them(stage, "/")
    assert found.keys() == {f"{base}/{depth.prim}" for depth in case.model.depths}

    # Referenced below another prim, as in a robot's stage.
    robot = Usd.Stage.CreateNew(str(tmp_path / "robot.usda"))
    robot.DefinePrim("/Robot/head").GetReferences().AddReference(str(builder.asset(case)))
    found = products_as_isaac_finds_them(robot, "/Robot")
    assert found.keys() == {f"/Robot/head/{case.model.prim}/{depth.prim}" for depth in case.model.depths}


INPUT_VARS = {"LdrColor", "DistanceToImagePlaneSD", "Camera3dPositionSD"}
SENSOR_VARS = {"DepthSensorDistance", "DepthSensorImager", "DepthSensorPointCloudColor", "DepthSensorPointCloudPosition"}


@pytest.mark.parametrize("case", [case for case in CASES if case.variant.isaac == "6"], ids=str)
def test_render_vars(builder: Builder, case: Case) -> None:
    stage = stage_of(builder, case)
    needed = SENSOR_VARS
    if case.variant.target == "ovrtx":
        needed = INPUT_VARS | SENSOR_VARS | {"DepthSensorOutputVisualization"}
    products = [prim for prim in stage.Traverse() if prim.GetTypeName() == "RenderProduct"]
    assert len(products) == len(case.model.depths)
    for product in products:
        targets = product.GetRelationship("orderedVars").GetTargets()
        prims = [stage.GetPrimAtPath(target) for target in targets]
        assert all(prim and prim.GetTypeName() == "RenderVar" for prim in prims), targets
        names = [prim.GetAttribute("sourceName").Get() for prim in prims]
        assert len(names) == len(set(names))
        assert needed <= set(names) <= needed | INPUT_VARS


@pytest.mark.parametrize("case", [case for case in CASES if case.variant.target == "ovrtx"], ids=str)
def test_ovrtx(builder: Builder, case: Case) -> None:
    stage = stage_of(builder, case)
    prefix = "omni:sensor:depthSensor:"
    for depth in case.model.depths:
        prim = prim_of(stage, case, depth.prim)
        assert applied(prim) == ["OmniSensorGenericDepthSensorSingleViewAPI"]
        values = depth.attributes("6")
        authored = [name for name in prim.GetAuthoredPropertyNames() if name.startswith(prefix)]
        assert {"noiseMean", "noiseSigma", "noiseDownscaleFactorPixel"} <= {n.removeprefix(prefix) for n in authored}
        for name in authored:
            kind, value = values[name.removeprefix(prefix)]
            assert prim.GetAttribute(name).GetTypeName() == kind
            assert prim.GetAttribute(name).Get() == pytest.approx(value, rel=1e-6)
    for prim in stage.Traverse():
        assert sheet.DEPTH_API not in applied(prim)
        if prim.GetTypeName() == "RenderProduct":
            [target] = prim.GetRelationship("camera").GetTargets()
            assert stage.GetPrimAtPath(target).GetName() in {depth.prim for depth in case.model.depths}


@pytest.mark.parametrize("case", CASES, ids=str)
def test_imu(builder: Builder, case: Case) -> None:
    stage = stage_of(builder, case)
    prim = prim_of(stage, case, "Imu_Sensor")
    assert prim.GetTypeName() == "IsaacImuSensor"
