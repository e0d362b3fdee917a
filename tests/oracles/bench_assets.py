"""The five assets, written with OpenUSD's Python API: the peer of `cargo xtask bench assets`.

`bench_assets.py DIR RUNS` writes the five assets into DIR, RUNS times, and prints the seconds of each run.
The content matches the program's: cameras, products with every depth attribute, legacy distortion, IMU, body.
"""

import math
import sys
import time
from functools import cache
from pathlib import Path

from pxr import Gf, Kind, Sdf, Usd, UsdGeom, UsdRender, UsdShade, Vt

import sheet

# Camera looks along −Z with +Y up; the body's x is forward and z is up.
FORWARD = Gf.Quatf(0.5, 0.5, -0.5, -0.5)
SEGMENTS, BEVEL = 16, 5


def place(prim: UsdGeom.Xformable, position: Gf.Vec3d, orientation: Gf.Quatf) -> None:
    prim.AddTranslateOp().Set(position)
    prim.AddOrientOp().Set(orientation)


def add_camera(stage: Usd.Stage, path: Sdf.Path, camera: sheet.Camera, role: str) -> UsdGeom.Camera:
    prim = UsdGeom.Camera.Define(stage, path)
    place(prim, Gf.Vec3d(*camera.place_mm) / 1e3, FORWARD)
    prim.CreateProjectionAttr(UsdGeom.Tokens.perspective)
    prim.CreateFocalLengthAttr(camera.focal_length)
    prim.CreateHorizontalApertureAttr(camera.aperture[0])
    prim.CreateVerticalApertureAttr(camera.aperture[1])
    prim.CreateHorizontalApertureOffsetAttr(0.0)
    prim.CreateVerticalApertureOffsetAttr(0.0)
    prim.CreateFocusDistanceAttr(camera.focus_distance)
    prim.CreateFStopAttr(0.0)
    prim.CreateStereoRoleAttr(role)
    prim.CreateClippingRangeAttr(Gf.Vec2f(*sheet.CLIPPING_RANGE))
    prim.GetPrim().CreateAttribute("cameraProjectionType", Sdf.ValueTypeNames.Token, False).Set("pinhole")
    for name, value in sheet.legacy(camera).items():
        prim.GetPrim().CreateAttribute(name, Sdf.ValueTypeNames.Float, False).Set(value)
    return prim


def add_product(stage: Usd.Stage, path: Sdf.Path, depth: sheet.Depth, camera: Sdf.Path, size: tuple[int, int]) -> None:
    product = UsdRender.Product.Define(stage, path)
    prim = product.GetPrim()
    prim.AddAppliedSchema(sheet.DEPTH_API)
    product.CreateCameraRel().SetTargets([camera])
    product.CreateResolutionAttr(Gf.Vec2i(*size))
    types = {"float": Sdf.ValueTypeNames.Float, "int": Sdf.ValueTypeNames.Int, "bool": Sdf.ValueTypeNames.Bool}
    for name, (kind, value) in depth.attributes("5.1").items():
        prim.CreateAttribute(sheet.DEPTH_PREFIX + name, types[kind], False).Set(value)


def add_material(stage: Usd.Stage, path: Sdf.Path, color: tuple[float, float, float], rough: float) -> UsdShade.Material:
    material = UsdShade.Material.Define(stage, path)
    shader = UsdShade.Shader.Define(stage, path.AppendChild("Shader"))
    shader.CreateIdAttr("UsdPreviewSurface")
    shader.CreateInput("diffuseColor", Sdf.ValueTypeNames.Color3f).Set(Gf.Vec3f(*color))
    shader.CreateInput("roughness", Sdf.ValueTypeNames.Float).Set(rough)
    material.CreateSurfaceOutput().ConnectToSource(shader.ConnectableAPI(), "surface")
    return material


Ring = tuple[float, tuple[tuple[float, float], ...]]


def rounded_outline(half_width: float, half_height: float, radius: float, y: float = 0.0) -> tuple[tuple[float, float], ...]:
    """A rectangle in the y–z plane with round corners, counter-clockwise."""
    corners = ((1, 1), (-1, 1), (-1, -1), (1, -1))
    return tuple(
        (
            y + sign_y * (half_width - radius) + radius * math.cos(math.pi / 2 * (corner + (step + 0.5) / SEGMENTS)),
            sign_z * (half_height - radius) + radius * math.sin(math.pi / 2 * (corner + (step + 0.5) / SEGMENTS)),
        )
        for corner, (sign_y, sign_z) in enumerate(corners)
        for step in range(SEGMENTS)
    )


def rounded_box(width: float, height: float, corner: float, edge: float, back: float, front: float, y: float = 0.0) -> list[Ring]:
    """Rings from back to front of a box with round corners and round edges."""
    rings = []
    for end, sign in ((back, -1), (front, 1)):
        steps = range(BEVEL + 1) if sign < 0 else range(BEVEL, -1, -1)
        for angle in (math.pi / 2 * step / BEVEL for step in steps):
            inset = edge * (1 - math.sin(angle))
            x = end - sign * edge * (1 - math.cos(angle))
            rings.append((x, rounded_outline(width / 2 - inset, height / 2 - inset, corner - inset, y)))
    return rings


@cache
def loft(*rings: Ring) -> tuple[Vt.Vec3fArray, Vt.IntArray, Vt.IntArray, Vt.Vec3fArray]:
    """Points, counts, indices and one normal per corner. Cached, so that only the first run pays for Python's loops."""
    count = len(rings[0][1])
    points = [Gf.Vec3f(x, y, z) for x, outline in rings for y, z in outline]
    counts, indices, normals = [], [], []
    for ring in range(len(rings) - 1):
        for i in range(count):
            j = (i + 1) % count
            face = [ring * count + i, ring * count + j, (ring + 1) * count + j, (ring + 1) * count + i]
            a, b, c, d = (points[k] for k in face)
            normal = Gf.Cross(c - a, d - b).GetNormalized()
            counts.append(4)
            indices += face
            normals += [normal] * 4
    for start, x in ((0, -1.0), ((len(rings) - 1) * count, 1.0)):
        face = range(start, start + count)
        counts.append(count)
        indices += face if x > 0 else reversed(face)
        normals += [Gf.Vec3f(x, 0, 0)] * count
    return Vt.Vec3fArray(points), Vt.IntArray(counts), Vt.IntArray(indices), Vt.Vec3fArray(normals)


def add_mesh(stage: Usd.Stage, path: Sdf.Path, rings: list[Ring], material: UsdShade.Material) -> None:
    points, counts, indices, normals = loft(*rings)
    mesh = UsdGeom.Mesh.Define(stage, path)
    mesh.CreateSubdivisionSchemeAttr(UsdGeom.Tokens.none)
    mesh.CreatePointsAttr(points)
    mesh.CreateFaceVertexCountsAttr(counts)
    mesh.CreateFaceVertexIndicesAttr(indices)
    mesh.CreateNormalsAttr(normals)
    mesh.SetNormalsInterpolation(UsdGeom.Tokens.faceVarying)
    mesh.CreateExtentAttr(UsdGeom.PointBased.ComputeExtent(points))
    UsdShade.MaterialBindingAPI.Apply(mesh.GetPrim()).Bind(material)


def author(model: sheet.Model, folder: Path, extension: str = "usd") -> None:
    target = folder / f"{model.stem}.{extension}"
    stage = Usd.Stage.CreateNew(str(target)) if extension == "usda" else Usd.Stage.CreateInMemory()
    UsdGeom.SetStageUpAxis(stage, UsdGeom.Tokens.z)
    UsdGeom.SetStageMetersPerUnit(stage, 1.0)
    root = UsdGeom.Xform.Define(stage, "/Root")
    stage.SetDefaultPrim(root.GetPrim())
    Usd.ModelAPI(root).SetKind(Kind.Tokens.component)
    body = UsdGeom.Xform.Define(stage, root.GetPath().AppendChild(model.prim))
    base = body.GetPath()

    for camera in model.cameras:
        add_camera(stage, base.AppendChild(camera.prim), camera, camera.stereo_role)
    scope = UsdGeom.Scope.Define(stage, base.AppendChild("TemplateRenderProducts"))
    for depth in model.depths:
        copied = model.camera(depth.camera)
        pseudo = base.AppendChild(depth.prim)
        add_camera(stage, pseudo, copied, "mono")
        product = scope.GetPath().AppendChild(f"{depth.prim}_render_product")
        add_product(stage, product, depth, pseudo, copied.size)
    imu = stage.DefinePrim(base.AppendChild("Imu_Sensor"), "IsaacImuSensor")
    UsdGeom.Xformable(imu).AddTranslateOp().Set(Gf.Vec3d(-0.01, 0, 0))

    looks = UsdGeom.Scope.Define(stage, base.AppendChild("Looks")).GetPath()
    shell = add_material(stage, looks.AppendChild("Shell"), (0.05, 0.05, 0.05), 0.4)
    glass = add_material(stage, looks.AppendChild("Glass"), (0.0, 0.0, 0.0), 0.05)
    visuals = UsdGeom.Xform.Define(stage, base.AppendChild("visuals")).GetPath()
    width, height, depth_mm = model.dimensions_mm or (111.0, 40.0, 31.3)
    shell_rings = rounded_box(width / 1e3, height / 1e3, 0.006, 0.003, -depth_mm / 1e3, -0.001)
    add_mesh(stage, visuals.AppendChild("Shell"), shell_rings, shell)
    front_rings = rounded_box(width / 1.1e3, height / 1.2e3, 0.005, 0.0004, -0.001, 0.0)
    add_mesh(stage, visuals.AppendChild("Glass"), front_rings, glass)
    for camera in model.cameras:
        lens_rings = rounded_box(0.008, 0.008, 0.004, 0.0002, 0.0, 0.0005, camera.place_mm[1] / 1e3)
        add_mesh(stage, visuals.AppendChild(f"Lens_{camera.prim}"), lens_rings, glass)

    if extension == "usda":
        stage.GetRootLayer().Save()
    else:
        # Text in a .usd file, as the program writes it, rather than OpenUSD's faster binary format.
        stage.GetRootLayer().Export(str(target), args={"format": "usda"})


def main() -> None:
    folder, runs = Path(sys.argv[1]), int(sys.argv[2])
    for _ in range(runs):
        start = time.perf_counter()
        for model in sheet.MODELS:
            author(model, folder)
        print(time.perf_counter() - start)


if __name__ == "__main__":
    main()
