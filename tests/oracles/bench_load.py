"""OpenUSD's side of `cargo xtask bench load`.

`bench_load.py make FOLDER` writes the stages that are loaded; `bench_load.py arrays|triangles STAGE RUNS` opens one again
and again, printing a JSON object a run, the first being the warm-up. `arrays` takes what a renderer needs as it is
stored, which OpenUSD does not even copy; `triangles` makes world-space triangles of it, with NumPy.
"""

import json
import sys
import time
from pathlib import Path

import numpy as np
from pxr import Gf, Sdf, Usd, UsdGeom, UsdShade, Vt

from extract_triangles import extract

QUADS, REFERENCES, PARTS = 1000, 10_000, 7


def grid(stage: Usd.Stage, path: str, columns: int) -> UsdGeom.Mesh:
    """A wavy grid of squares."""
    side = np.linspace(-1, 1, columns + 1)
    x, y = np.meshgrid(side, side)
    points = np.stack([x, y, 0.1 * np.sin(7 * x) * np.cos(5 * y)], -1).reshape(-1, 3).astype(np.float32)
    corner = (np.arange(columns)[:, None] * (columns + 1) + np.arange(columns)).ravel()
    indices = np.stack([corner, corner + 1, corner + columns + 2, corner + columns + 1], -1).astype(np.int32)
    mesh = UsdGeom.Mesh.Define(stage, path)
    mesh.CreatePointsAttr(Vt.Vec3fArray.FromNumpy(points))
    mesh.CreateFaceVertexCountsAttr(Vt.IntArray.FromNumpy(np.full(len(indices), 4, np.int32)))
    mesh.CreateFaceVertexIndicesAttr(Vt.IntArray.FromNumpy(indices.ravel()))
    mesh.CreateSubdivisionSchemeAttr(UsdGeom.Tokens.none)
    mesh.CreateExtentAttr(UsdGeom.PointBased.ComputeExtent(mesh.GetPointsAttr().Get()))
    return mesh


def new(path: Path) -> Usd.Stage:
    """An empty stage, metres, z up."""
    path.unlink(missing_ok=True)
    stage = Usd.Stage.CreateNew(str(path))
    UsdGeom.SetStageUpAxis(stage, UsdGeom.Tokens.z)
    UsdGeom.SetStageMetersPerUnit(stage, 1.0)
    return stage


def make(folder: Path) -> None:
    """quads.usdc and quads.usda, a million squares; references.usda, 90 000 prims through 10 000 references."""
    stage = new(folder / "quads.usdc")
    grid(stage, "/Quads", QUADS)
    stage.GetRootLayer().Save()
    stage.GetRootLayer().Export(str(folder / "quads.usda"))

    part = new(folder / "part.usda")
    root = UsdGeom.Xform.Define(part, "/Part")
    part.SetDefaultPrim(root.GetPrim())
    inner = UsdGeom.Xform.Define(part, "/Part/Group")
    inner.AddTranslateOp().Set(Gf.Vec3d(0, 0, 1))
    for i in range(PARTS):
        mesh = grid(part, f"/Part/Group/Mesh_{i}", 1)
        mesh.AddTranslateOp().Set(Gf.Vec3d(0.1 * i, 0, 0))
    part.GetRootLayer().Save()

    layer = Sdf.Layer.CreateNew(str(folder / "references.usda"))
    with Sdf.ChangeBlock():
        for i in range(REFERENCES):
            prim = Sdf.CreatePrimInLayer(layer, f"/World/Part_{i}")
            prim.specifier, prim.typeName = Sdf.SpecifierDef, "Xform"
            prim.referenceList.Prepend(Sdf.Reference("./part.usda"))
            prim.instanceable = i % 2 == 0
            place = Sdf.AttributeSpec(prim, "xformOp:translate", Sdf.ValueTypeNames.Double3)
            place.default = Gf.Vec3d(3 * (i % 100), 3 * (i // 100), 0)
            order = Sdf.AttributeSpec(prim, "xformOpOrder", Sdf.ValueTypeNames.TokenArray, Sdf.VariabilityUniform)
            order.default = ["xformOp:translate"]
        world = layer.GetPrimAtPath("/World")
        world.specifier, world.typeName = Sdf.SpecifierDef, "Xform"
        layer.defaultPrim = "World"
    layer.Save()


def arrays(path: str) -> None:
    """Returns the mesh data that a renderer needs, as arrays: not triangulated, and with the paths of bound materials only."""
    stage = Usd.Stage.Open(path)
    transforms = UsdGeom.XformCache()
    for prim in Usd.PrimRange(stage.GetPseudoRoot(), Usd.TraverseInstanceProxies()):
        if not prim.IsA(UsdGeom.Mesh):
            continue
        mesh = UsdGeom.Mesh(prim)
        mesh.ComputeVisibility()
        mesh.ComputePurpose()
        np.array(transforms.GetLocalToWorldTransform(prim))
        for attribute in (mesh.GetPointsAttr(), mesh.GetFaceVertexCountsAttr(), mesh.GetFaceVertexIndicesAttr(), mesh.GetNormalsAttr()):
            np.asarray(attribute.Get())
        coordinates = UsdGeom.PrimvarsAPI(prim).GetPrimvar("st")
        if coordinates.HasValue():
            np.asarray(coordinates.Get()), np.asarray(coordinates.GetIndices())
        np.asarray(mesh.GetDisplayColorAttr().Get())
        UsdShade.MaterialBindingAPI(prim).ComputeBoundMaterial()


def main() -> None:
    if sys.argv[1] == "make":
        make(Path(sys.argv[2]))
        return
    load = {"arrays": arrays, "triangles": extract}[sys.argv[1]]
    path, runs = sys.argv[2:]
    for _ in range(int(runs)):
        start, cpu = time.perf_counter(), time.process_time()
        found = load(path)
        print(json.dumps({"wall_s": time.perf_counter() - start, "cpu_s": time.process_time() - cpu}))
        del found


if __name__ == "__main__":
    main()
