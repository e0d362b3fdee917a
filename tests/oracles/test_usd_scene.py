"""What an extracted scene contains: visible meshes, cameras, shapes and lights, compared with OpenUSD."""

import os
from pathlib import Path

import numpy as np
import pytest
from pxr import Gf, Sdf, Usd, UsdGeom, UsdLux, UsdShade

from usd_scenes import FORMATS, add_mesh, compare, expected, instanced, is_drawn, new_stage, thing, vec, world


@pytest.mark.parametrize("extension", FORMATS)
def test_visible_meshes(tmp_path, scene_dump, extension):
    path = tmp_path / f"drawn.{extension}"
    stage = new_stage(path)
    for purpose in ["default", "render", "proxy", "guide"]:
        group = UsdGeom.Xform.Define(stage, f"/{purpose}")
        UsdGeom.Imageable(group).CreatePurposeAttr(purpose)
        add_mesh(stage, f"/{purpose}/heir")
        for own in ["default", "guide", "render"]:
            mesh = add_mesh(stage, f"/{purpose}/{own}")
            UsdGeom.Imageable(mesh).CreatePurposeAttr(own)
    unseen = UsdGeom.Xform.Define(stage, "/unseen")
    unseen.MakeInvisible()
    UsdGeom.Imageable(add_mesh(stage, "/unseen/mesh")).CreateVisibilityAttr("inherited")
    UsdGeom.Camera.Define(stage, "/unseen/camera")
    stage.CreateClassPrim("/class")
    add_mesh(stage, "/class/mesh")
    stage.OverridePrim("/over")
    add_mesh(stage, "/over/mesh")
    stage.Save()
    # Not compared with OpenUSD: nothing is visible.
    wanted = expected(stage)
    UsdGeom.Mesh.Define(stage, "/empty")
    stage.Save()
    got = scene_dump(path)
    assert len(wanted) == 11
    compare(got, wanted)
    assert [camera["path"] for camera in got.scene["cameras"]] == ["/unseen/camera"]


@pytest.mark.parametrize("extension", FORMATS)
@pytest.mark.parametrize("up", ["Y", "Z"])
def test_poses_of_cameras(tmp_path, scene_dump, extension, up):
    path = tmp_path / f"cameras.{extension}"
    stage = new_stage(path, up, unit=0.01)
    rng = np.random.default_rng(11)
    rig = UsdGeom.Xform.Define(stage, "/Rig")
    rig.AddTranslateOp().Set((100, -20, 35))
    rig.AddRotateXYZOp().Set((10, 200, -30))
    turning = UsdGeom.Camera.Define(stage, "/Rig/Turning")
    spin = turning.AddRotateYOp()
    spin.Set(10)
    for time, angle in [(0, 0), (10, 90)]:
        spin.Set(angle, time)
    scaled = UsdGeom.Camera.Define(stage, "/Rig/Scaled")
    scaled.AddTranslateOp().Set(vec(rng, Gf.Vec3d, -50, 50))
    scaled.AddScaleOp().Set((2, 3, 0.5))
    for i in range(3):
        camera = UsdGeom.Camera.Define(stage, f"/Rig/Free{i}")
        camera.AddTranslateOp().Set(vec(rng, Gf.Vec3d, -50, 50))
        camera.AddRotateZYXOp().Set(vec(rng, Gf.Vec3f, -180, 180))
    stage.Save()
    for time in [None, 3.3]:
        got = scene_dump(path, time)
        cache = UsdGeom.XformCache(Usd.TimeCode.Default() if time is None else time)
        assert len(got.scene["cameras"]) == 5
        for camera in got.scene["cameras"]:
            matrix = cache.GetLocalToWorldTransform(stage.GetPrimAtPath(camera["path"])).RemoveScaleShear()
            matrix = np.array(matrix).T
            wanted = np.column_stack([matrix[:3, 0], -matrix[:3, 1], -matrix[:3, 2], matrix[:3, 3] * 0.01])
            np.testing.assert_allclose(camera["world_from_camera"], wanted, atol=1e-9, err_msg=camera["path"])
        warned = got.findings("camera-transform")
        assert len(warned) == 1 and "/Rig/Scaled: its transform contains a scale" in warned[0]


@pytest.mark.parametrize("axis", ["X", "Y", "Z"])
def test_shapes_fill_their_extent(tmp_path, scene_dump, axis):
    path = tmp_path / "shapes.usda"
    stage = new_stage(path)
    kinds = ["Cube", "Sphere", "Cylinder", "Cone", "Capsule", "Plane"]
    kinds = [kind for kind in kinds if hasattr(UsdGeom, kind)]
    sizes = {"size": 3.0, "radius": 0.75, "height": 2.5, "width": 1.25, "length": 0.5}
    for kind in kinds:
        for measured in [False, True]:
            shape = getattr(UsdGeom, kind).Define(stage, f"/{kind}{int(measured)}")
            if hasattr(shape, "CreateAxisAttr"):
                shape.CreateAxisAttr(axis)
            for name, size in sizes.items() if measured else []:
                attribute = shape.GetPrim().GetAttribute(name)
                if attribute:
                    attribute.Set(size)
    stage.Save()
    things = scene_dump(path).things()
    assert len(things) == 2 * len(kinds)
    for name, thing in things.items():
        shape = UsdGeom.Boundable(stage.GetPrimAtPath(name))
        low, high = UsdGeom.Boundable.ComputeExtentFromPlugins(shape, Usd.TimeCode.Default())
        points = thing["triangles"].reshape(-1, 3)
        np.testing.assert_allclose(points.min(axis=0), low, atol=1e-6, err_msg=name)
        np.testing.assert_allclose(points.max(axis=0), high, atol=1e-6, err_msg=name)
        outward(thing["triangles"], name, axis)
    cone = things["/Cone1"]["triangles"].reshape(-1, 3)
    tip = cone[cone[:, "XYZ".index(axis)].argmax()]
    assert np.allclose(np.delete(tip, "XYZ".index(axis)), 0), "its tip points along the axis"


def outward(triangles, name, axis):
    normals = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    if "Plane" in name:
        assert (normals[:, "XYZ".index(axis)] > 0).all(), name
    else:
        assert ((normals * triangles.mean(axis=1)).sum(axis=1) > 0).all(), name


def test_lights(tmp_path, scene_dump):
    path = tmp_path / "lights.usda"
    stage = new_stage(path, unit=0.5)
    sun = UsdLux.DistantLight.Define(stage, "/Sun")
    sun.AddRotateXOp().Set(-40)
    sun.CreateIntensityAttr(3000)
    sun.CreateExposureAttr(-1)
    sun.CreateColorAttr((1, 0.5, 0.25))
    sun.CreateAngleAttr(2)
    lamp = UsdLux.SphereLight.Define(stage, "/Lamp")
    lamp.CreateRadiusAttr(0.2)
    lamp.CreateNormalizeAttr(True)
    lamp.CreateEnableColorTemperatureAttr(True)
    lamp.CreateColorTemperatureAttr(3000)
    lamp.AddTranslateOp().Set((2, 4, 6))
    panel = UsdLux.RectLight.Define(stage, "/Panel")
    panel.CreateWidthAttr(3)
    panel.CreateHeightAttr(2)
    UsdLux.DiskLight.Define(stage, "/Disk")
    UsdLux.DomeLight.Define(stage, "/Sky").CreateTextureFileAttr("./sky.hdr")
    UsdLux.CylinderLight.Define(stage, "/Tube")
    UsdLux.SphereLight.Define(stage, "/Off").MakeInvisible()
    old = stage.DefinePrim("/Old", "SphereLight")
    old.CreateAttribute("intensity", Sdf.ValueTypeNames.Float).Set(7)
    stage.Save()
    (tmp_path / "sky.hdr").write_bytes(b"#?RADIANCE\n")
    got = scene_dump(path)
    lights = {light["path"]: light for light in got.scene["lights"]}
    assert list(lights) == ["/Sun", "/Lamp", "/Panel", "/Disk", "/Sky", "/Tube", "/Old"]
    assert np.allclose(lights["/Sun"]["radiance"], [1500, 750, 375])
    assert np.allclose(lights["/Sun"]["measures"], np.radians(2))
    matrix = np.array(UsdGeom.XformCache().GetLocalToWorldTransform(sun.GetPrim())).T * 0.5
    assert np.allclose(lights["/Sun"]["world_from_light"], matrix[:3])
    assert lights["/Lamp"]["normalize"] and np.allclose(np.array(lights["/Lamp"]["world_from_light"])[:, 3], (1, 2, 3))
    blackbody = np.array(UsdLux.BlackbodyTemperatureAsRgb(3000))
    assert np.allclose(lights["/Lamp"]["radiance"], blackbody, atol=0.05)
    assert lights["/Panel"]["measures"] == [3, 2]
    assert lights["/Old"]["radiance"] == [7, 7, 7]
    assert got.scene["textures"][lights["/Sky"]["texture"]]["source"] == str((tmp_path / "sky.hdr").resolve())
    assert len(got.findings("unsupported-prim")) == 1


def test_unsupported_contents_are_reported(tmp_path, scene_dump):
    path = tmp_path / "odd.usda"
    stage = new_stage(path)
    for kind in ["BasisCurves", "Points", "NurbsPatch", "TetMesh", "Volume"]:
        stage.DefinePrim(f"/{kind}", kind)
    material = UsdShade.Material.Define(stage, "/Mdl")
    shader = UsdShade.Shader.Define(stage, "/Mdl/Shader")
    shader.GetPrim().CreateAttribute("info:implementationSource", Sdf.ValueTypeNames.Token).Set("sourceAsset")
    shader.GetPrim().CreateAttribute("info:mdl:sourceAsset", Sdf.ValueTypeNames.Asset).Set("x.mdl")
    material.CreateSurfaceOutput("mdl").ConnectToSource(shader.ConnectableAPI(), "out")
    mesh = add_mesh(stage, "/Mesh")
    UsdShade.MaterialBindingAPI.Apply(mesh.GetPrim()).Bind(material)
    squashed = add_mesh(stage, "/Squashed")
    squashed.AddScaleOp().Set((1, 0, 1))
    gone = add_mesh(stage, "/Gone")
    gone.AddScaleOp().Set((0, 0, 0))
    broken = add_mesh(stage, "/Broken")
    broken.GetPointsAttr().Set([(float("nan"), 0, 0)] * 7)
    stage.GetRootLayer().subLayerPaths.append("./missing.usda")
    stage.DefinePrim("/Lost", "Xform").GetReferences().AddReference("./nowhere.usd")
    stage.Save()
    got = scene_dump(path)
    things = got.things()
    assert list(things) == ["/Mesh", "/Squashed"]
    places = [finding.split(": ")[1] for finding in got.findings("unsupported-prim")]
    assert places == ["/BasisCurves", "/Points", "/NurbsPatch", "/TetMesh", "/Volume"]
    assert ["/Mdl" in finding for finding in got.findings("unsupported-material")] == [True]
    assert len(got.findings("singular-transform")) == 2
    assert np.allclose(things["/Squashed"]["triangles"][:, :, 1], 0)
    assert len(got.findings("composition")) >= 1
    assert any("/Broken" in finding for finding in got.scene["findings"])


def test_the_chess_set(scene_dump):
    data = os.environ.get("OAKTWIN_TEST_DATA")
    path = Path(data or "") / "data/scenes/OpenChessSet/chess_set.usda"
    if not data or not path.exists():
        pytest.skip("OAKTWIN_TEST_DATA has no chess set")
    got = scene_dump(path)
    assert len(got.scene["meshes"]) == 21
    assert sum(mesh["triangles"]["shape"][0] for mesh in got.scene["meshes"]) == 799_384
    things = got.things()
    points = np.concatenate([one["triangles"].reshape(-1, 3) for one in things.values()])
    assert np.allclose(np.abs(points[:, [0, 2]]).max(axis=0), 0.353, atol=5e-4)
    assert np.allclose([points[:, 1].min(), points[:, 1].max()], [0, 0.169], atol=5e-4)
    stage = Usd.Stage.Open(str(path))
    wanted = {}
    walk = iter(Usd.PrimRange.Stage(stage, Usd.TraverseInstanceProxies()))
    for prim in walk:
        if prim.IsA(UsdGeom.PointInstancer):
            instancer = UsdGeom.PointInstancer(prim)
            instanced(instancer, str(prim.GetPath()), None, world(prim, None), 1.0, wanted)
            walk.PruneChildren()
        elif prim.IsA(UsdGeom.Mesh) and is_drawn(prim, None):
            wanted[str(prim.GetPath())] = thing(prim, world(prim, None), 1.0, None)
    assert len(wanted) == len(things) == 49
    assert list(things) == list(wanted)
    # Sorting so large a set would find ties, but faces keep their order. Meshes without a texture have no
    # coordinates, and a few faces are concave: fans are wrong there.
    for name, one in wanted.items():
        values = ["triangles"] if things[name]["uvs"] is None else ["triangles", "uvs"]
        off = [np.abs(things[name][value].reshape(-1, 3, 2 + (value == "triangles")) -
                      one[value].reshape(-1, 3, 2 + (value == "triangles"))) for value in values]
        differ = np.any([(d > 1e-6).any(axis=(1, 2)) for d in off], axis=0)
        assert differ.mean() < 1e-3, name
    # Every piece has a texture, except the white and black tops of pawns.
    for name, one in things.items():
        material = got.scene["materials"][one["materials"][0]]
        assert material["texture"] is not None or "Geom_Top" in name, name
    assert not got.scene["findings"]
