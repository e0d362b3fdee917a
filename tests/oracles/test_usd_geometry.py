"""The poses of the cameras, and the dimensions of the body."""

import json
from pathlib import Path

import pytest
from pxr import Gf, Usd, UsdGeom, UsdPhysics, UsdShade

from assets import CASES, NOMINAL, PLAIN, Builder, Case
from test_usd_values import cameras, prim_of, stage_of

WITH_BODY = [case for case in CASES if case.variant.body and case.variant.name in ("plain", "rigid-body")]


def axes(world: Gf.Matrix4d) -> tuple[Gf.Vec3d, Gf.Vec3d]:
    """A camera's viewing direction and the up direction of its image."""
    return world.TransformDir(Gf.Vec3d(0, 0, -1)).GetNormalized(), world.TransformDir(Gf.Vec3d(0, 1, 0)).GetNormalized()


@pytest.mark.parametrize("case", NOMINAL, ids=str)
def test_cameras_stand_and_look_as_on_the_device(builder: Builder, case: Case) -> None:
    stage = stage_of(builder, case)
    cache = UsdGeom.XformCache()
    place = {}
    for name, column, _ in cameras(case):
        world = cache.GetLocalToWorldTransform(prim_of(stage, case, name))
        place[name] = world.ExtractTranslation()
        assert Gf.IsClose(place[name], Gf.Vec3d(*column.place_mm) / 1e3, 1e-7), name
        forward, up = axes(world)
        assert Gf.IsClose(forward, Gf.Vec3d(1, 0, 0), 1e-6), name
        assert Gf.IsClose(up, Gf.Vec3d(0, 0, 1), 1e-6), name
    [left] = [place[c.prim] for c in case.model.cameras if c.stereo_role == "left"]
    [right] = [place[c.prim] for c in case.model.cameras if c.stereo_role == "right"]
    assert Gf.IsClose(left - right, Gf.Vec3d(0, case.model.baseline_mm / 1e3, 0), 1e-7), "left is on the +y side"
    assert Gf.IsClose(left + right, Gf.Vec3d(0), 1e-7), "the origin is midway"


@pytest.mark.parametrize("case", [case for case in CASES if case.variant is PLAIN], ids=str)
def test_two_of_them_scaled_and_rotated(builder: Builder, case: Case, tmp_path: Path) -> None:
    stage = Usd.Stage.CreateNew(str(tmp_path / "two.usda"))
    for index, name in enumerate(("a", "b")):
        holder = UsdGeom.Xform.Define(stage, f"/World/{name}")
        holder.AddTranslateOp().Set(Gf.Vec3d(1.0 + index, -2.0, 0.5))
        holder.AddRotateXYZOp().Set(Gf.Vec3f(10.0, -20.0 * index, 75.0))
        holder.AddScaleOp().Set(Gf.Vec3f(1.0 + index))
        camera = stage.DefinePrim(f"/World/{name}/oak")
        camera.GetReferences().AddReference(str(builder.asset(case)))
    assert not getattr(stage, "GetCompositionErrors", list)()

    alone = stage_of(builder, case)
    cache, alone_cache = UsdGeom.XformCache(), UsdGeom.XformCache()
    for name in ("a", "b"):
        holder = cache.GetLocalToWorldTransform(stage.GetPrimAtPath(f"/World/{name}"))
        for camera, _, _ in cameras(case):
            expected = alone_cache.GetLocalToWorldTransform(prim_of(alone, case, camera)) * holder
            prim = stage.GetPrimAtPath(f"/World/{name}/oak/{case.model.prim}/{camera}")
            assert Gf.IsClose(cache.GetLocalToWorldTransform(prim), expected, 1e-9)
        for depth in case.model.depths:
            base = f"/World/{name}/oak/{case.model.prim}"
            product = stage.GetPrimAtPath(f"{base}/TemplateRenderProducts/{depth.prim}_render_product")
            assert product.GetRelationship("camera").GetTargets() == [f"{base}/{depth.prim}"]
        for mesh in (prim for prim in stage.Traverse() if prim.IsA(UsdGeom.Mesh)):
            material, _ = UsdShade.MaterialBindingAPI(mesh).ComputeBoundMaterial()
            visible = UsdGeom.Imageable(mesh).ComputePurpose() != "guide"
            assert not visible or (material and material.GetPath().HasPrefix(mesh.GetPath().GetCommonPrefix(material.GetPath())))


def dimensions_mm(builder: Builder, case: Case) -> Gf.Vec3d:
    """Depth, width and height (x, y, z), as the program's own catalog has them."""
    shown = json.loads(builder.run("show", case.model.name, "--json"))
    body = shown.get("body") or shown["device"]["body"]
    width, height, depth = body["dimensions_mm"]
    if case.model.dimensions_mm is not None:
        assert (width, height, depth) == case.model.dimensions_mm
    return Gf.Vec3d(depth, width, height)


@pytest.mark.parametrize("case", WITH_BODY, ids=str)
def test_body_measures_what_the_device_does(builder: Builder, case: Case) -> None:
    stage = stage_of(builder, case)
    boxes = UsdGeom.BBoxCache(Usd.TimeCode.Default(), [UsdGeom.Tokens.default_, UsdGeom.Tokens.render])
    box = boxes.ComputeWorldBound(prim_of(stage, case, "visuals")).ComputeAlignedRange()
    assert Gf.IsClose(box.GetSize() * 1e3, dimensions_mm(builder, case), 0.01)
    for column in case.model.cameras:
        _, y, z = (value / 1e3 for value in column.place_mm)
        low, high = box.GetMin(), box.GetMax()
        assert low[1] < y < high[1] and low[2] < z < high[2], f"{column.prim} is behind the front"


@pytest.mark.parametrize("case", WITH_BODY, ids=str)
def test_body_is_light_and_sound(builder: Builder, case: Case) -> None:
    stage = stage_of(builder, case)
    triangles = 0
    meshes = [prim for prim in stage.Traverse() if prim.IsA(UsdGeom.Mesh)]
    assert meshes
    for prim in meshes:
        mesh = UsdGeom.Mesh(prim)
        counts, indices = mesh.GetFaceVertexCountsAttr().Get(), mesh.GetFaceVertexIndicesAttr().Get()
        points = mesh.GetPointsAttr().Get()
        triangles += sum(count - 2 for count in counts)
        valid, why = UsdGeom.Mesh.ValidateTopology(indices, counts, len(points))
        assert valid, f"{prim.GetPath()}: {why}"
        extent = UsdGeom.PointBased.ComputeExtent(points)
        assert [Gf.Vec3f(e) for e in mesh.GetExtentAttr().Get()] == pytest.approx([Gf.Vec3f(e) for e in extent], abs=1e-7)
        # A closed mesh that is wound outwards holds a positive volume.
        assert volume(points, counts, indices) > 0, prim.GetPath()
    assert 100 < triangles < 20_000


def volume(points: list[Gf.Vec3f], counts: list[int], indices: list[int]) -> float:
    total, start = 0.0, 0
    for count in counts:
        face = [points[i] for i in indices[start : start + count]]
        total += sum(Gf.Dot(face[0], Gf.Cross(face[k], face[k + 1])) for k in range(1, count - 1))
        start += count
    return total / 6


@pytest.mark.parametrize("case", WITH_BODY, ids=str)
def test_visible_meshes_have_a_preview_surface(builder: Builder, case: Case) -> None:
    stage = stage_of(builder, case)
    for prim in Usd.PrimRange(prim_of(stage, case, "visuals")):
        if prim.IsA(UsdGeom.Mesh):
            material, _ = UsdShade.MaterialBindingAPI(prim).ComputeBoundMaterial()
            assert material, prim.GetPath()
            shader, _, _ = material.ComputeSurfaceSource()
            assert shader.GetIdAttr().Get() == "UsdPreviewSurface"


@pytest.mark.parametrize("case", CASES, ids=str)
def test_rigid_body_only_when_asked_for(builder: Builder, case: Case) -> None:
    stage = stage_of(builder, case)
    bodies = [prim for prim in stage.Traverse() if prim.HasAPI(UsdPhysics.RigidBodyAPI)]
    colliders = [prim for prim in stage.Traverse() if prim.HasAPI(UsdPhysics.CollisionAPI)]
    assert bool(bodies) == bool(colliders) == case.variant.rigid
    if case.variant.rigid:
        [body] = bodies
        assert prim_of(stage, case, "Imu_Sensor").GetPath().HasPrefix(body.GetPath()), "Isaac's IMU wants one above it"
        assert all(collider.GetPath().HasPrefix(body.GetPath()) for collider in colliders)
        assert 0.05 < UsdPhysics.MassAPI(body).GetMassAttr().Get() < 2.0, "kilograms"
        for collider in colliders:
            if collider.IsA(UsdGeom.Mesh):
                assert UsdPhysics.MeshCollisionAPI(collider).GetApproximationAttr().Get() == "convexHull"
