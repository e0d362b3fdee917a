"""Normals, texture coordinates, colours and materials of an extracted scene, compared with OpenUSD."""

import numpy as np
import pytest
from pxr import Gf, Sdf, Usd, UsdGeom, UsdShade, Vt

from usd_scenes import FORMATS, add_mesh, compare, expected, new_stage


@pytest.mark.parametrize("extension", FORMATS)
@pytest.mark.parametrize("left_handed", [False, True])
def test_surface_values(tmp_path, scene_dump, extension, left_handed):
    path = tmp_path / f"values.{extension}"
    stage = new_stage(path)
    rng = np.random.default_rng(9)
    counts = (3, 4, 5, 4)
    sizes = {"constant": 1, "uniform": 4, "vertex": 16, "varying": 16, "faceVarying": 16}
    material = preview_material(stage, "/Looks/Painted", texture="missing.png")
    group = UsdGeom.Xform.Define(stage, "/Group")
    inherited = UsdGeom.PrimvarsAPI(group)
    inherited.CreatePrimvar("displayColor", Sdf.ValueTypeNames.Color3fArray, "constant").Set([(0.1, 0.2, 0.3)])
    inherited.CreatePrimvar("st", Sdf.ValueTypeNames.TexCoord2fArray, "constant").Set([(0.5, 0.25)])
    # Only constants are inherited.
    inherited.CreatePrimvar("normals", Sdf.ValueTypeNames.Normal3fArray, "vertex").Set([(0, 0, 1)])
    for interpolation, size in sizes.items():
        for indexed in [False, True]:
            mesh = add_mesh(stage, f"/Group/{interpolation}_{'indexed' if indexed else 'flat'}", counts, seed=size)
            if left_handed:
                mesh.CreateOrientationAttr("leftHanded")
            mesh.CreateHoleIndicesAttr([1])
            primvars = UsdGeom.PrimvarsAPI(mesh)
            for name, kind, width in [("st", "TexCoord2fArray", 2), ("displayColor", "Color3fArray", 3)]:
                primvar = primvars.CreatePrimvar(name, getattr(Sdf.ValueTypeNames, kind), interpolation)
                count = 5 if indexed else size
                vector = Gf.Vec2f if width == 2 else Gf.Vec3f
                primvar.Set([vector(*map(float, rng.random(width))) for _ in range(count)])
                if indexed:
                    primvar.SetIndices(Vt.IntArray([int(i) for i in rng.integers(0, 5, size)]))
    add_mesh(stage, "/Group/heir", counts)
    half = add_mesh(stage, "/Group/half", counts)
    UsdGeom.PrimvarsAPI(half).CreatePrimvar("st", Sdf.ValueTypeNames.TexCoord2hArray, "vertex").Set(
        [Gf.Vec2h(float(i), 0.5) for i in range(16)]
    )
    UsdGeom.PrimvarsAPI(half).CreatePrimvar("displayColor", Sdf.ValueTypeNames.Color3dArray, "constant").Set(
        [Gf.Vec3d(0.5, 0.25, 0.125)]
    )
    stage.Save()
    stage = Usd.Stage.Open(str(path))
    compare(scene_dump(path), expected(stage), ["colors"])
    # Texture coordinates are read where a material asks for them; its file is missing, so none does.
    UsdShade.MaterialBindingAPI.Apply(stage.GetPrimAtPath("/Group")).Bind(material)
    stage.Save()
    got = scene_dump(path)
    assert len(got.findings("missing-texture")) == 1
    assert all(thing["uvs"] is None for thing in got.things().values())
    write_png(tmp_path / "missing.png")
    got = scene_dump(path)
    assert not got.findings("missing-texture")
    compare(got, expected(stage), ["uvs"])


def write_png(path):
    """A PNG of one pixel, written by hand."""
    import struct
    import zlib

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", 1, 1, 8, 2, 0, 0, 0)
    path.parent.mkdir(exist_ok=True, parents=True)
    path.write_bytes(
        b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(b"\0abc")) + chunk(b"IEND", b"")
    )


def preview_material(stage, path, color=None, texture=None, uv="st"):
    material = UsdShade.Material.Define(stage, path)
    shader = UsdShade.Shader.Define(stage, f"{path}/Surface")
    shader.CreateIdAttr("UsdPreviewSurface")
    material.CreateSurfaceOutput().ConnectToSource(shader.ConnectableAPI(), "surface")
    diffuse = shader.CreateInput("diffuseColor", Sdf.ValueTypeNames.Color3f)
    if color:
        diffuse.Set(color)
    if texture:
        # The primvar's name comes through the material's interface.
        name = material.CreateInput("stName", Sdf.ValueTypeNames.String)
        name.Set(uv)
        reader = UsdShade.Shader.Define(stage, f"{path}/Reader")
        reader.CreateIdAttr("UsdPrimvarReader_float2")
        reader.CreateInput("varname", Sdf.ValueTypeNames.String).ConnectToSource(name)
        place = UsdShade.Shader.Define(stage, f"{path}/Place")
        place.CreateIdAttr("UsdTransform2d")
        place.CreateInput("in", Sdf.ValueTypeNames.Float2).ConnectToSource(reader.ConnectableAPI(), "result")
        place.CreateInput("rotation", Sdf.ValueTypeNames.Float).Set(90)
        place.CreateInput("scale", Sdf.ValueTypeNames.Float2).Set((2, 3))
        place.CreateInput("translation", Sdf.ValueTypeNames.Float2).Set((0.5, 0.25))
        image = UsdShade.Shader.Define(stage, f"{path}/Image")
        image.CreateIdAttr("UsdUVTexture")
        image.CreateInput("file", Sdf.ValueTypeNames.Asset).Set(texture)
        image.CreateInput("st", Sdf.ValueTypeNames.Float2).ConnectToSource(place.ConnectableAPI(), "result")
        image.CreateInput("wrapS", Sdf.ValueTypeNames.Token).Set("clamp")
        image.CreateInput("wrapT", Sdf.ValueTypeNames.Token).Set("mirror")
        image.CreateInput("scale", Sdf.ValueTypeNames.Float4).Set((0.5, 0.6, 0.7, 1))
        image.CreateInput("bias", Sdf.ValueTypeNames.Float4).Set((0.1, 0.2, 0.3, 0))
        image.CreateInput("sourceColorSpace", Sdf.ValueTypeNames.Token).Set("sRGB")
        diffuse.ConnectToSource(image.ConnectableAPI(), "rgb")
    return material


@pytest.mark.parametrize("extension", FORMATS)
def test_bound_materials(tmp_path, scene_dump, extension):
    write_png(tmp_path / "model" / "tex" / "wood.png")
    model = new_stage(tmp_path / "model" / f"model.{extension}")
    UsdGeom.Xform.Define(model, "/Model")
    model.SetDefaultPrim(model.GetPrimAtPath("/Model"))
    wood = preview_material(model, "/Model/Looks/Wood", texture="./tex/wood.png", uv="map2")
    seat = add_mesh(model, "/Model/Seat")
    UsdShade.MaterialBindingAPI.Apply(seat.GetPrim()).Bind(wood)
    primvar = UsdGeom.PrimvarsAPI(seat).CreatePrimvar("map2", Sdf.ValueTypeNames.TexCoord2fArray, "vertex")
    primvar.Set([(0.1 * i, 0.5) for i in range(7)])
    model.Save()

    path = tmp_path / f"root.{extension}"
    stage = new_stage(path)
    red = preview_material(stage, "/Looks/Red", (1, 0, 0))
    green = preview_material(stage, "/Looks/Green", (0, 1, 0))
    blue = preview_material(stage, "/Looks/Blue", (0, 0, 1))
    bind = lambda prim: UsdShade.MaterialBindingAPI.Apply(prim.GetPrim())
    strong, full = UsdShade.Tokens.strongerThanDescendants, UsdShade.Tokens.full
    for i in range(2):
        chair = UsdGeom.Xform.Define(stage, f"/World/Chair{i}")
        chair.GetPrim().GetReferences().AddReference(f"./model/model.{extension}")
        chair.GetPrim().SetInstanceable(True)
    weak = UsdGeom.Xform.Define(stage, "/World/Weak")
    bind(weak).Bind(red)
    add_mesh(stage, "/World/Weak/Heir")
    bind(add_mesh(stage, "/World/Weak/Own")).Bind(green)
    firm = UsdGeom.Xform.Define(stage, "/World/Firm")
    bind(firm).Bind(red, strong)
    bind(add_mesh(stage, "/World/Firm/Own")).Bind(green)
    both = add_mesh(stage, "/World/Both")
    bind(both).Bind(red)
    bind(both).Bind(blue, materialPurpose=full)
    add_mesh(stage, "/World/Bare")
    many = UsdGeom.Xform.Define(stage, "/World/Many")
    for name in ["A", "B", "B/Deep", "B/Not", "C"]:
        add_mesh(stage, f"/World/Many/{name}")
    collection = Usd.CollectionAPI.Apply(many.GetPrim(), "some")
    collection.IncludePath("/World/Many/A")
    collection.IncludePath("/World/Many/B")
    collection.ExcludePath("/World/Many/B/Not")
    bind(many).Bind(red)
    bind(many).Bind(collection, green, "some")
    bind(UsdGeom.Imageable(stage.GetPrimAtPath("/World/Many/B/Deep"))).Bind(blue)
    parts = add_mesh(stage, "/World/Parts", counts=(3, 4, 5, 3))
    bind(parts).Bind(red)
    for name, material, faces in [("some", green, [1, 3]), ("other", blue, [2])]:
        subset = UsdGeom.Subset.CreateGeomSubset(parts, name, "face", Vt.IntArray(faces), "materialBind")
        bind(subset).Bind(material)
    stage.Save()
    stage = Usd.Stage.Open(str(path))
    got = scene_dump(path)
    things = got.things()
    names = [material["name"] for material in got.scene["materials"]]
    for name, thing in things.items():
        if name == "/World/Parts":
            continue
        bound, _ = UsdShade.MaterialBindingAPI(stage.GetPrimAtPath(name)).ComputeBoundMaterial(full)
        wanted = str(bound.GetPath()) if bound else None
        used = {None if index < 0 else names[index] for index in thing["materials"]}
        # What instances share is named after the first of them.
        assert used == {wanted and wanted.replace("Chair1", "Chair0")}, name
    compare(got, expected(stage))
    table = got.scene["materials"]
    used = np.unique(things["/World/Parts"]["materials"], return_counts=True)
    counts = {table[i]["name"]: int(n) for i, n in zip(*used)}
    assert counts == {"/Looks/Red": 1, "/Looks/Green": 3, "/Looks/Blue": 3}
    assert table[names.index("/Looks/Green")]["base_color"] == [0, 1, 0]

    seat = things["/World/Chair1/Seat"]
    assert seat["mesh"] == things["/World/Chair0/Seat"]["mesh"]
    assert np.allclose(np.sort(np.unique(seat["uvs"].reshape(-1, 2)[:, 0])), 0.1 * np.arange(7))
    wood = table[names.index("/World/Chair0/Looks/Wood")]["texture"]
    assert got.scene["textures"][wood["texture"]]["source"] == str((tmp_path / "model/tex/wood.png").resolve())
    assert got.scene["textures"][wood["texture"]]["color_space"] == "Srgb"
    assert wood["wrap"] == ["Clamp", "Mirror"]
    # Scaled by (2, 3), turned by 90° counter-clockwise, moved.
    assert np.allclose(wood["image_from_uv"], [[0, -3, 0.5], [2, 0, 0.25]], atol=1e-6)
    assert np.allclose(wood["scale"] + wood["bias"], [0.5, 0.6, 0.7, 1, 0.1, 0.2, 0.3, 0])
