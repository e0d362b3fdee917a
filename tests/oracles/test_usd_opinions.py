"""Which layer's opinion gives an attribute its value, at the default time and over time, in random stacks of layers."""

import random

import numpy as np
import pytest
from pxr import Sdf, Usd, UsdGeom, Vt

from usd_scenes import add_mesh, compare, thing, value

TIMES = [None, -3.0, 0.0, 4.0, 7.5, 12.0, 40.0]


def author(draw: random.Random, layer: Sdf.Layer, path: str, animated: bool = True):
    """Gives a layer an opinion on the attribute, or none."""
    kind = draw.choice(["nothing", "default", "samples", "both", "block", "default", "samples"])
    if kind == "nothing" or not animated and kind == "samples":
        return
    prim = Sdf.CreatePrimInLayer(layer, Sdf.Path(path).GetPrimPath())
    name = Sdf.Path(path).name
    attribute = prim.attributes.get(name) or Sdf.AttributeSpec(prim, name, Sdf.ValueTypeNames.Double3)

    def vector():
        return tuple(draw.uniform(-5, 5) for _ in range(3))

    if kind == "block":
        attribute.default = Sdf.ValueBlock()
    if kind in ("default", "both"):
        attribute.default = vector()
    if kind in ("samples", "both") and animated:
        for time in sorted(draw.sample(range(-5, 25), draw.choice([1, 2, 4]))):
            layer.SetTimeSample(attribute.path, time, vector())


def new(folder, name: str, extension: str) -> Sdf.Layer:
    layer = Sdf.Layer.CreateNew(str(folder / f"{name}.{extension}"))
    layer.comment = name
    return layer


def offset(draw: random.Random) -> Sdf.LayerOffset:
    return Sdf.LayerOffset(draw.choice([0, 0, 3, -2.5]), draw.choice([1, 1, 2, 0.5]))


def asset(draw: random.Random, folder, name: str, extension: str, depth: int) -> Sdf.Layer:
    """A layer with the model /Model, sublayers, a variant and a reference to another asset."""
    layer = new(folder, name, extension)
    prim = Sdf.CreatePrimInLayer(layer, "/Model")
    prim.specifier = Sdf.SpecifierDef
    author(draw, layer, "/Model/M.xformOp:translate")
    for at in range(draw.choice([0, 1, 2])):
        below = new(folder, f"{name}_sub{at}", extension)
        author(draw, below, "/Model/M.xformOp:translate")
        below.Save()
        layer.subLayerPaths.append(f"./{name}_sub{at}.{extension}")
        layer.subLayerOffsets[at] = offset(draw)
    if draw.random() < 0.4:
        variants = Sdf.VariantSetSpec(prim, "look")
        for choice in ("a", "b"):
            variant = Sdf.VariantSpec(variants, choice)
            over = Sdf.PrimSpec(variant.primSpec, "M", Sdf.SpecifierOver)
            attribute = Sdf.AttributeSpec(over, "xformOp:translate", Sdf.ValueTypeNames.Double3)
            if draw.random() < 0.5:
                attribute.default = (draw.uniform(-5, 5), 0, 1)
            else:
                layer.SetTimeSample(attribute.path, 1, (draw.uniform(-5, 5), 0, 1))
                layer.SetTimeSample(attribute.path, 9, (draw.uniform(-5, 5), 0, 1))
        prim.variantSetNameList.prependedItems.append("look")
        prim.variantSelections["look"] = draw.choice("ab")
    if depth:
        inner = asset(draw, folder, f"{name}_ref", extension, depth - 1)
        reference = Sdf.Reference(f"./{name}_ref.{extension}", "/Model", offset(draw))
        prim.referenceList.prependedItems.append(reference)
        inner.Save()
    else:
        stage = Usd.Stage.Open(layer)
        mesh = add_mesh(stage, "/Model/M", seed=3)
        order = mesh.GetPrim().CreateAttribute("xformOpOrder", Sdf.ValueTypeNames.TokenArray, False)
        order.Set(["xformOp:translate"])
        if not mesh.GetPrim().HasAttribute("xformOp:translate"):
            mesh.GetPrim().CreateAttribute("xformOp:translate", Sdf.ValueTypeNames.Double3, False)
    layer.Save()
    return layer


def stacked(draw: random.Random, folder, extension: str, sublayers: int = 2) -> str:
    asset(draw, folder, "asset", extension, draw.choice([0, 1, 2]))
    root = new(folder, "root", extension)
    UsdGeom.SetStageMetersPerUnit(Usd.Stage.Open(root), 1.0)
    for at in range(draw.randint(0, sublayers)):
        layer = new(folder, f"sub{at}", extension)
        author(draw, layer, "/World/M.xformOp:translate")
        layer.Save()
        root.subLayerPaths.append(f"./sub{at}.{extension}")
        root.subLayerOffsets[at] = offset(draw)
    author(draw, root, "/World/M.xformOp:translate")
    prim = Sdf.CreatePrimInLayer(root, "/World")
    prim.specifier = Sdf.SpecifierDef
    arcs, kind = draw.choice([(prim.referenceList, Sdf.Reference), (prim.payloadList, Sdf.Payload)])
    arcs.prependedItems.append(kind(f"./asset.{extension}", "/Model", offset(draw)))
    root.Save()
    return root.realPath


def agrees(scene_dump, path: str):
    stage = Usd.Stage.Open(path)
    mesh = stage.GetPrimAtPath("/World/M")
    for time in TIMES:
        # Without a time, XformCache ignores time samples.
        moved = value(mesh.GetAttribute("xformOp:translate"), time)
        matrix = np.eye(4)
        matrix[3, :3] = (0, 0, 0) if moved is None else moved
        compare(scene_dump(path, time), {"/World/M": thing(mesh, matrix, 1.0, time)})


@pytest.mark.parametrize("extension", ["usda", "usdc"])
@pytest.mark.parametrize("seed", range(40))
def test_the_strongest_opinion_counts(tmp_path, scene_dump, seed, extension):
    agrees(scene_dump, stacked(random.Random(seed), tmp_path, extension))


@pytest.mark.parametrize("seed", range(60))
def test_value_clips_follow_the_layer_that_has_them(tmp_path, scene_dump, seed):
    draw = random.Random(1000 + seed)
    clip = new(tmp_path, "clip", "usda")
    model = Sdf.CreatePrimInLayer(clip, "/Model/M")
    attribute = Sdf.AttributeSpec(model, "xformOp:translate", Sdf.ValueTypeNames.Double3)
    for time in (0, 10, 20):
        clip.SetTimeSample(attribute.path, time, (draw.uniform(-5, 5), time, 0))
    clip.Save()
    # A default in a sublayer of the stage hides clips of a stronger layer, against OpenUSD.
    path = stacked(draw, tmp_path, "usda", sublayers=0)
    layer = Sdf.Layer.FindOrOpen(path)
    # The layers with clips: the root layer, or one that it reaches.
    where, prim = draw.choice([(layer, "/World"), (Sdf.Layer.FindOrOpen(str(tmp_path / "asset.usda")), "/Model")])
    # Time samples of a referenced layer that has clips for the same attribute lose, against OpenUSD.
    own = where.GetAttributeAtPath(f"{prim}/M.xformOp:translate")
    if own and where != layer:
        own.ClearInfo("timeSamples")
    where.GetPrimAtPath(prim).SetInfo(
        "clips",
        {
            "default": {
                "primPath": "/Model",
                "assetPaths": Sdf.AssetPathArray([Sdf.AssetPath("./clip.usda")]),
                "active": Vt.Vec2dArray([(0, 0)]),
                "times": Vt.Vec2dArray([(0, 0), (20, 20)]),
            }
        },
    )
    where.Save()
    agrees(scene_dump, path)
