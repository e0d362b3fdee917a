"""Transforms, time samples, composition, instances and labels of an extracted scene, compared with OpenUSD."""

import numpy as np
import pytest
from pxr import Gf, Sdf, Usd, UsdGeom, Vt

from usd_scenes import FORMATS, add_mesh, compare, expected, instanced, new_stage, thing, vec, world


@pytest.mark.parametrize("extension", FORMATS)
def test_transform_ops_of_every_kind(tmp_path, scene_dump, extension):
    path = tmp_path / f"ops.{extension}"
    stage = new_stage(path, unit=0.01)
    rng = np.random.default_rng(1)
    operation = UsdGeom.XformOp
    single, double, half = operation.PrecisionFloat, operation.PrecisionDouble, operation.PrecisionHalf
    number = 0

    def prim(parent="/World"):
        nonlocal number
        number += 1
        return add_mesh(stage, f"{parent}/M{number}", seed=number)

    UsdGeom.Xform.Define(stage, "/World").AddScaleOp().Set((1.5, 0.7, -1.1))
    for precision, kind in [(single, Gf.Vec3f), (double, Gf.Vec3d), (half, Gf.Vec3h)]:
        for order in ["XYZ", "XZY", "YXZ", "YZX", "ZXY", "ZYX"]:
            getattr(prim(), f"AddRotate{order}Op")(precision).Set(vec(rng, kind, -200, 200))
        for axis in "XYZ":
            getattr(prim(), f"AddRotate{axis}Op")(precision).Set(float(rng.uniform(-400, 400)))
            for name in ["Translate", "Scale"]:
                if hasattr(UsdGeom.Xformable, f"Add{name}{axis}Op"):
                    getattr(prim(), f"Add{name}{axis}Op")(precision).Set(float(rng.uniform(0.5, 2)))
        prim().AddTranslateOp(precision).Set(vec(rng, kind))
        prim().AddScaleOp(precision).Set(vec(rng, kind))
    for precision, kind in [(single, Gf.Quatf), (double, Gf.Quatd), (half, Gf.Quath)]:
        quaternion = Gf.Quatd(0.3, Gf.Vec3d(0.4, -0.5, 0.7)).GetNormalized()
        prim().AddOrientOp(precision).Set(kind(quaternion))
        # Not of length 1.
        prim().AddOrientOp(precision).Set(kind(0.6, 0.2, 0.5, -0.3))
    matrix = Gf.Matrix4d(*rng.uniform(-1, 1, 16).tolist())
    matrix.SetColumn(3, Gf.Vec4d(0, 0, 0, 1))
    prim().AddTransformOp().Set(matrix)

    pivoted = prim()
    pivoted.AddTranslateOp().Set((1, 2, 3))
    pivot = pivoted.AddTranslateOp(single, "pivot")
    pivot.Set(Gf.Vec3f(0.5, -0.5, 1.0))
    pivoted.AddRotateXYZOp(single, "first").Set((10, 20, 30))
    pivoted.AddRotateXYZOp(single, "second").Set((-40, 20, 5))
    pivoted.AddTransformOp(double, "inverted", isInverseOp=False).Set(matrix)
    pivoted.AddScaleOp().Set((2, 1, 0.5))
    pivoted.AddTranslateOp(single, "pivot", isInverseOp=True)
    inverse = prim()
    operation = inverse.AddTransformOp()
    operation.Set(matrix)
    inverse.SetXformOpOrder([operation])
    inverse.GetPrim().GetAttribute("xformOpOrder").Set(["!invert!xformOp:transform"])

    reset = UsdGeom.Xform.Define(stage, "/World/Reset")
    reset.AddTranslateOp().Set((5, 6, 7))
    reset.SetResetXformStack(True)
    prim("/World/Reset").AddRotateXOp().Set(30)
    # Neither a scope nor a prim without a type has a transform.
    scope = UsdGeom.Scope.Define(stage, "/World/Scope")
    untyped = stage.DefinePrim("/World/Untyped")
    for inner in [scope.GetPrim(), untyped]:
        inner.CreateAttribute("xformOp:translate", Sdf.ValueTypeNames.Double3).Set((9, 9, 9))
        inner.CreateAttribute("xformOpOrder", Sdf.ValueTypeNames.TokenArray).Set(["xformOp:translate"])
        prim(str(inner.GetPath()))
    stage.Save()
    wanted = expected(stage)
    assert len(wanted) == number
    compare(scene_dump(path), wanted)


@pytest.mark.parametrize("extension", FORMATS)
def test_time_samples_through_layer_offsets(tmp_path, scene_dump, extension):
    inner = new_stage(tmp_path / f"inner.{extension}")
    model = UsdGeom.Xform.Define(inner, "/Model")
    inner.SetDefaultPrim(model.GetPrim())
    move, turn = model.AddTranslateOp(), model.AddOrientOp()
    spin = model.AddRotateXYZOp()
    spin.Set((0, 0, 0))
    for time in [0, 10, 20]:
        move.Set((time, 0.1 * time * time, 0), time)
        angle = 0.05 * time
        turn.Set(Gf.Quatf(float(np.cos(angle)), float(np.sin(angle)), 0, 0), time)
        spin.Set((3 * time, time, 0), time)
    mesh = add_mesh(inner, "/Model/Mesh")
    still = np.array(mesh.GetPointsAttr().Get())
    for time in [0, 20]:
        mesh.GetPointsAttr().Set(Vt.Vec3fArray.FromNumpy((still * (1 + 0.1 * time)).astype(np.float32)), time)
    UsdGeom.Imageable(mesh).CreateVisibilityAttr().Set("inherited", 0)
    UsdGeom.Imageable(mesh).GetVisibilityAttr().Set("invisible", 18)
    inner.Save()
    middle = new_stage(tmp_path / f"middle.{extension}")
    holder = UsdGeom.Xform.Define(middle, "/Holder")
    middle.SetDefaultPrim(holder.GetPrim())
    holder.GetPrim().GetReferences().AddReference(f"./inner.{extension}", layerOffset=Sdf.LayerOffset(5, 2))
    middle.Save()
    path = tmp_path / f"root.{extension}"
    root = new_stage(path)
    root.GetRootLayer().subLayerPaths.append(f"./middle.{extension}")
    root.GetRootLayer().subLayerOffsets[0] = Sdf.LayerOffset(-3, 0.5)
    root.Save()
    root = Usd.Stage.Open(str(path))
    for time in [None, 0.0, 1.7, 4.0, 9.3, 15.0, 40.0]:
        if time is None:
            # At OpenUSD's default time there are no samples; ours then takes the first ones.
            got = scene_dump(path, time)
            first = min(root.GetPrimAtPath("/Holder").GetAttribute("xformOp:translate").GetTimeSamples())
            mesh = root.GetPrimAtPath("/Holder/Mesh")
            wanted = thing(mesh, world(mesh, first), 1, None)
            # `spin` and the points have defaults.
            defaults = UsdGeom.Xformable(root.GetPrimAtPath("/Holder"))
            assert defaults.GetPrim().GetAttribute("xformOp:rotateXYZ").Get() == Gf.Vec3f(0)
            compare(got, {"/Holder/Mesh": wanted})
        else:
            compare(scene_dump(path, time), expected(root, time))


@pytest.mark.parametrize("extension", FORMATS)
def test_composition(tmp_path, scene_dump, extension):
    weak = new_stage(tmp_path / f"weak.{extension}")
    add_mesh(weak, "/Sub/FromSublayer", seed=3)
    UsdGeom.Xform.Define(weak, "/Sub").AddTranslateOp().Set((0, 0, 1))
    weak.Save()
    part = new_stage(tmp_path / f"part.{extension}")
    model = UsdGeom.Xform.Define(part, "/Part")
    part.SetDefaultPrim(model.GetPrim())
    sets = model.GetPrim().GetVariantSets().AddVariantSet("shape")
    for i, name in enumerate(["one", "two"]):
        sets.AddVariant(name)
        sets.SetVariantSelection(name)
        with sets.GetVariantEditContext():
            add_mesh(part, f"/Part/{name}", counts=(3 + i, 5), seed=i)
            UsdGeom.Xformable(model).ClearXformOpOrder()
            UsdGeom.Xformable(model).AddTranslateOp(opSuffix=name).Set((i + 1, 0, 0))
    part.Save()
    path = tmp_path / f"root.{extension}"
    stage = new_stage(path, up="Y", unit=0.1)
    stage.GetRootLayer().subLayerPaths.append(f"./weak.{extension}")
    for i, name in enumerate(["one", "two"]):
        prim = UsdGeom.Xform.Define(stage, f"/World/Ref_{name}").GetPrim()
        prim.GetReferences().AddReference(f"./part.{extension}")
        prim.GetVariantSets().SetSelection("shape", name)
        payload = UsdGeom.Xform.Define(stage, f"/World/Pay_{name}").GetPrim()
        payload.GetPayloads().AddPayload(f"./part.{extension}", "/Part")
        UsdGeom.Xformable(payload).AddRotateZOp().Set(20 * i)
    stage.CreateClassPrim("/_class")
    add_mesh(stage, "/_class/Inherited", seed=8)
    UsdGeom.Xform.Define(stage, "/World/Heir").GetPrim().GetInherits().AddInherit("/_class")
    UsdGeom.Xform.Define(stage, "/World/Special").GetPrim().GetSpecializes().AddSpecialize("/_class")
    stage.OverridePrim("/World/Special/Inherited").GetAttribute("points").Set([(0, 0, 0)] * 7)
    add_mesh(stage, "/World/Off/Mesh")
    stage.GetPrimAtPath("/World/Off").SetActive(False)
    stage.OverridePrim("/World/Over")
    stage.OverridePrim("/World/Over/Nothing")
    stage.Save()
    stage = Usd.Stage.Open(str(path))
    wanted = expected(stage)
    assert len(wanted) == 7
    compare(scene_dump(path), wanted)
    assert scene_dump(path).scene["up"] == [0, 1, 0]


@pytest.mark.parametrize("extension", FORMATS)
def test_instances_share_meshes(tmp_path, scene_dump, extension):
    path = tmp_path / f"instances.{extension}"
    stage = new_stage(path)
    UsdGeom.Xform.Define(stage, "/Library/Leaf").AddTranslateOp().Set((1, 1, 0))
    add_mesh(stage, "/Library/Leaf/Mesh", seed=4)
    branch = UsdGeom.Xform.Define(stage, "/Library/Branch")
    branch.AddRotateXOp().Set(15)
    for i in range(2):
        leaf = UsdGeom.Xform.Define(stage, f"/Library/Branch/Leaf{i}")
        leaf.GetPrim().GetReferences().AddInternalReference("/Library/Leaf")
        leaf.GetPrim().SetInstanceable(True)
        leaf.AddTranslateOp(opSuffix="mine").Set((i, 0, 2))
    add_mesh(stage, "/Library/Branch/Wood", seed=5)
    stage.DefinePrim("/Library", "Scope")
    UsdGeom.Imageable(stage.GetPrimAtPath("/Library")).MakeInvisible()
    for i in range(4):
        tree = UsdGeom.Xform.Define(stage, f"/World/Tree{i}")
        tree.GetPrim().GetReferences().AddInternalReference("/Library/Branch")
        tree.GetPrim().SetInstanceable(True)
        tree.AddTranslateOp(opSuffix="tree").Set((3 * i, 1, 0))
        if i == 1:
            UsdGeom.PrimvarsAPI(tree).CreatePrimvar(
                "displayColor", Sdf.ValueTypeNames.Color3fArray, "constant"
            ).Set([(0.9, 0.1, 0.2)])
        if i == 2:
            tree.MakeInvisible()
        if i == 3:
            label(tree.GetPrim(), "class", ["tree", "plant"])
            UsdGeom.Imageable(tree).CreatePurposeAttr("render")
    # Opinions below an instance do not count.
    lost = Sdf.CreatePrimInLayer(stage.GetRootLayer(), "/World/Tree0/Wood")
    Sdf.AttributeSpec(lost, "visibility", Sdf.ValueTypeNames.Token).default = "invisible"
    stage.Save()
    stage = Usd.Stage.Open(str(path))
    wanted = expected(stage)
    assert len(wanted) == 9
    got = scene_dump(path)
    compare(got, wanted)
    things = got.things()
    meshes = {path: thing["mesh"] for path, thing in things.items()}
    assert meshes["/World/Tree0/Wood"] == meshes["/World/Tree3/Wood"]
    assert meshes["/World/Tree0/Leaf0/Mesh"] == meshes["/World/Tree3/Leaf1/Mesh"]
    assert meshes["/World/Tree0/Wood"] != meshes["/World/Tree1/Wood"], "it inherits a colour"
    assert np.allclose(things["/World/Tree1/Leaf0/Mesh"]["colors"].reshape(-1, 3), (0.9, 0.1, 0.2))
    assert len(got.scene["meshes"]) == 4


def label(prim, taxonomy, labels):
    """As `SemanticsLabelsAPI` writes it; older OpenUSD has no class for it."""
    prim.AddAppliedSchema(f"SemanticsLabelsAPI:{taxonomy}")
    prim.CreateAttribute(f"semantics:labels:{taxonomy}", Sdf.ValueTypeNames.TokenArray).Set(labels)


def isaac_label(prim, name, kind, data):
    prim.AddAppliedSchema(f"SemanticsAPI:{name}")
    prim.CreateAttribute(f"semantic:{name}:params:semanticType", Sdf.ValueTypeNames.String).Set(kind)
    prim.CreateAttribute(f"semantic:{name}:params:semanticData", Sdf.ValueTypeNames.String).Set(data)


def test_labels(tmp_path, scene_dump):
    path = tmp_path / "labels.usda"
    stage = new_stage(path)
    room = UsdGeom.Xform.Define(stage, "/Room").GetPrim()
    isaac_label(room, "Semantics_a1b2", "class", "room")
    table = UsdGeom.Xform.Define(stage, "/Room/Table").GetPrim()
    label(table, "class", ["table", "furniture"])
    label(table, "colour", ["brown"])
    top = add_mesh(stage, "/Room/Table/Top").GetPrim()
    isaac_label(top, "Semantics", "part", "top")
    add_mesh(stage, "/Room/Wall")
    stage.Save()
    got = scene_dump(path)
    compare(got, expected(stage))
    things = got.things()
    assert things["/Room/Table/Top"]["labelled"] == [
        "/Room/Table/Top",
        "/Room/Table",
        "/Room/Table",
        "/Room/Table",
        "/Room",
    ]
    assert things["/Room/Wall"]["labels"] == [("class", "room")]


@pytest.mark.parametrize("extension", FORMATS)
def test_point_instancers(tmp_path, scene_dump, extension):
    path = tmp_path / f"points.{extension}"
    stage = new_stage(path, unit=0.01)
    rng = np.random.default_rng(5)

    def fill(instancer, count, prototypes, start=0):
        instancer.CreatePrototypesRel().SetTargets(prototypes)
        instancer.CreateProtoIndicesAttr([int(i) for i in rng.integers(0, len(prototypes), count)])
        instancer.CreatePositionsAttr([vec(rng, Gf.Vec3f, -50, 50) for _ in range(count)])

    UsdGeom.Xform.Define(stage, "/World").AddRotateYOp().Set(33)
    outer = UsdGeom.PointInstancer.Define(stage, "/World/Outer")
    outer.AddTranslateOp().Set((1, 2, 3))
    label(outer.GetPrim(), "class", ["forest"])
    scope = stage.OverridePrim("/World/Outer/Prototypes")
    tree = UsdGeom.Xform.Define(stage, "/World/Outer/Prototypes/Tree")
    tree.AddTranslateOp().Set((0, 0, 4))
    label(tree.GetPrim(), "class", ["tree"])
    add_mesh(stage, "/World/Outer/Prototypes/Tree/Trunk", seed=1).AddRotateXOp().Set(10)
    hidden = add_mesh(stage, "/World/Outer/Prototypes/Tree/Hidden", seed=1)
    hidden.MakeInvisible()
    proxy = add_mesh(stage, "/World/Outer/Prototypes/Tree/Proxy", seed=1)
    UsdGeom.Imageable(proxy).CreatePurposeAttr("proxy")
    inner = UsdGeom.PointInstancer.Define(stage, "/World/Outer/Prototypes/Tree/Leaves")
    inner.AddRotateZOp().Set(70)
    add_mesh(stage, "/World/Outer/Prototypes/Tree/Leaves/Leaf", counts=(4,), seed=2).AddScaleOp().Set((2, 1, 1))
    fill(inner, 3, ["/World/Outer/Prototypes/Tree/Leaves/Leaf"])
    stone = add_mesh(stage, "/World/Outer/Stone", counts=(5,), seed=3)
    # A prototype elsewhere, which is itself rendered.
    elsewhere = UsdGeom.Xform.Define(stage, "/World/Elsewhere")
    elsewhere.AddTranslateOp().Set((100, 0, 0))
    add_mesh(stage, "/World/Elsewhere/Thing", seed=6).AddTranslateOp().Set((0, 7, 0))
    fill(outer, 12, [tree.GetPath(), stone.GetPath(), "/World/Elsewhere/Thing"])
    quaternions = rng.normal(size=(12, 4))
    quaternions /= np.linalg.norm(quaternions, axis=1)[:, None]
    outer.CreateOrientationsAttr([Gf.Quath(*map(float, q)) for q in quaternions])
    outer.CreateScalesAttr([vec(rng, Gf.Vec3f, 0.5, 2) for _ in range(12)])
    outer.CreateIdsAttr([100 + i for i in range(12)])
    outer.CreateInvisibleIdsAttr([103, 107, 5])
    if extension == "usdc":
        # Text with it cannot be read: the library refuses list edits that it does not know.
        outer.DeactivateId(110)
    stage.Save()
    stage = Usd.Stage.Open(str(path))
    wanted = expected(stage)
    assert list(wanted) == ["/World/Elsewhere/Thing"]
    found = {}
    instancer = UsdGeom.PointInstancer(stage.GetPrimAtPath("/World/Outer"))
    instanced(instancer, "/World/Outer", None, world(instancer.GetPrim(), None), 0.01, found)
    for path_, thing_ in found.items():
        thing_["labels"] = ([("class", "tree")] if "/Tree" in path_ else []) + [("class", "forest")]
    got = scene_dump(path)
    assert 12 < len(found) < 48
    compare(got, {**found, **wanted})
    inside = next(thing for path, thing in got.things().items() if path.endswith("/Trunk"))
    assert inside["labelled"][0].startswith("/World/Outer[") and inside["labelled"][0].endswith("]/Tree")
    assert inside["labelled"][1] == "/World/Outer"
    assert len(got.scene["meshes"]) == 5, "the thing elsewhere has its own"
