"""Skinned meshes, compared with the points that UsdSkel computes."""

import numpy as np
import pytest
from pxr import Gf, Usd, UsdGeom, UsdSkel, Vt

from usd_scenes import Dump, add_mesh, corners_of, new_stage

JOINTS = ["Hips", "Hips/Spine", "Hips/Spine/Head", "Hips/Leg", "Prop"]
TIMES = [None, 0.0, 3.5, 10.0]


def matrix(rng, scale=1.0) -> Gf.Matrix4d:
    rotation = Gf.Rotation(Gf.Vec3d(*rng.uniform(-1, 1, 3)), float(rng.uniform(-180, 180)))
    placed = Gf.Matrix4d().SetRotate(rotation)
    placed.SetTranslateOnly(Gf.Vec3d(*rng.uniform(-2, 2, 3)))
    return Gf.Matrix4d().SetScale(scale) * placed


def person(path, rng, extension, animated: bool, rest: bool = True, scale=0.01):
    stage = new_stage(path, unit=1.0)
    world = UsdGeom.Xform.Define(stage, "/World")
    world.AddTranslateOp().Set((1, 2, 3))
    root = UsdSkel.Root.Define(stage, "/World/Person")
    root.AddRotateZOp().Set(30)
    UsdGeom.Xform.Define(stage, "/World/Person/Rig").AddScaleOp().Set((2, 1, 1))
    skeleton = UsdSkel.Skeleton.Define(stage, "/World/Person/Rig/Skeleton")
    skeleton.AddTranslateOp().Set((0.5, 0, -1))
    skeleton.AddScaleOp().Set((scale, scale, scale))
    skeleton.CreateJointsAttr(JOINTS)
    skeleton.CreateBindTransformsAttr([matrix(rng) for _ in JOINTS])
    if rest:
        skeleton.CreateRestTransformsAttr([matrix(rng) for _ in JOINTS])
    if animated:
        animation = UsdSkel.Animation.Define(stage, "/World/Person/Animation")
        moved = ["Hips/Spine", "Hips", "Prop"]
        animation.CreateJointsAttr(moved)
        for time in (0, 4, 10):
            quaternions = [Gf.Quatf(*rng.normal(size=4).tolist()).GetNormalized() for _ in moved]
            animation.CreateTranslationsAttr().Set(Vt.Vec3fArray.FromNumpy(rng.normal(size=(3, 3)).astype("f")), time)
            animation.CreateRotationsAttr().Set(Vt.QuatfArray(quaternions), time)
            animation.CreateScalesAttr().Set(Vt.Vec3hArray.FromNumpy(rng.uniform(0.5, 2, (3, 3)).astype("e")), time)
        UsdSkel.BindingAPI.Apply(root.GetPrim()).CreateAnimationSourceRel().SetTargets([animation.GetPath()])
    UsdSkel.BindingAPI.Apply(root.GetPrim()).CreateSkeletonRel().SetTargets([skeleton.GetPath()])
    for at, (influences, interpolation, subset) in enumerate(
        [(1, "vertex", False), (3, "vertex", True), (2, "constant", False), (1, "constant", True)]
    ):
        mesh = add_mesh(stage, f"/World/Person/Mesh{at}", seed=at)
        mesh.AddTranslateOp().Set((9, 9, 9))
        binding = UsdSkel.BindingAPI.Apply(mesh.GetPrim())
        points = len(mesh.GetPointsAttr().Get()) if interpolation == "vertex" else 1
        joints = ["Hips/Leg", "Prop", "Hips/Spine"] if subset else JOINTS
        weights = rng.dirichlet(np.ones(influences), points).astype("f").ravel()
        constant = interpolation == "constant"
        indices = rng.integers(0, len(joints), points * influences)
        binding.CreateJointIndicesPrimvar(constant, influences).Set([int(index) for index in indices])
        binding.CreateJointWeightsPrimvar(constant, influences).Set([float(weight) for weight in weights])
        if subset:
            binding.CreateJointsAttr(joints)
        if at != 1:
            binding.CreateGeomBindTransformAttr(matrix(rng))
    stage.Save()
    return stage


def skinned(stage, time):
    """The triangles of each mesh in the world, by UsdSkel."""
    when = Usd.TimeCode.Default() if time is None else Usd.TimeCode(time)
    cache, transforms = UsdSkel.Cache(), UsdGeom.XformCache(when)
    for root in [prim for prim in stage.Traverse() if prim.IsA(UsdSkel.Root)]:
        cache.Populate(UsdSkel.Root(root), Usd.PrimDefaultPredicate)
        for binding in cache.ComputeSkelBindings(UsdSkel.Root(root), Usd.PrimDefaultPredicate):
            skeleton = cache.GetSkelQuery(binding.GetSkeleton())
            world = np.array(transforms.GetLocalToWorldTransform(binding.GetSkeleton().GetPrim()))
            for query in binding.GetSkinningTargets():
                mesh = UsdGeom.Mesh(query.GetPrim())
                motions = skeleton.ComputeSkinningTransforms(when)
                assert motions
                points = Vt.Vec3fArray(mesh.GetPointsAttr().Get())
                if query.IsRigidlyDeformed():
                    moved = np.array(query.ComputeSkinnedTransform(motions, when))
                    points = np.asarray(points) @ moved[:3, :3] + moved[3, :3]
                else:
                    assert query.ComputeSkinnedPoints(motions, points, when)
                points = np.asarray(points, dtype=np.float64) @ world[:3, :3] + world[3, :3]
                yield str(query.GetPrim().GetPath()), points[corners_of(mesh, time)[:, :, 2]]


def agrees(got: Dump, stage, time):
    things = got.things()
    wanted = dict(skinned(stage, time))
    assert sorted(things) == sorted(wanted)
    for path, triangles in wanted.items():
        scale = 1.0 + np.abs(triangles).max(initial=0.0)
        # A face that the pose makes concave is cut along its other diagonal.
        found, expected = things[path]["triangles"].reshape(-1, 3), triangles.reshape(-1, 3)
        distances = np.linalg.norm(found[:, None] - expected, axis=2)
        # Between samples, OpenUSD rounds scales to half precision.
        tolerance = (1e-3 if time == 3.5 else 5e-6) * scale
        assert max(distances.min(axis=0).max(), distances.min(axis=1).max()) < tolerance, path


@pytest.mark.parametrize("animated", [False, True])
@pytest.mark.parametrize("extension", ["usda", "usdc"])
@pytest.mark.parametrize("seed", range(4))
def test_points_are_usdskels(tmp_path, scene_dump, seed, extension, animated):
    path = tmp_path / f"person.{extension}"
    stage = person(path, np.random.default_rng(seed), extension, animated, scale=[0.01, 1.0][seed % 2])
    for time in TIMES:
        dump = scene_dump(path, time)
        assert not dump.findings("skin") and not dump.findings("unsupported-prim")
        agrees(dump, stage, time)


def test_instances_of_a_person_are_skinned(tmp_path, scene_dump):
    person(tmp_path / "person.usda", np.random.default_rng(5), "usda", animated=True)
    path = tmp_path / "crowd.usda"
    stage = new_stage(path, unit=1.0)
    for at in range(2):
        copy = UsdGeom.Xform.Define(stage, f"/P{at}")
        copy.AddTranslateOp().Set((at, 0, 0))
        copy.GetPrim().GetReferences().AddReference("./person.usda", "/World")
        copy.GetPrim().SetInstanceable(True)
    stage.Save()
    alone = scene_dump(tmp_path / "person.usda", 3.5).things()
    # A reference replaces the translation of its target.
    for path, thing in scene_dump(path, 3.5).things().items():
        wanted = alone[path.replace("/P0", "/World").replace("/P1", "/World")]["triangles"]
        shift = np.array([int(path[2]) - 1, -2, -3])
        np.testing.assert_allclose(thing["triangles"], wanted + shift, rtol=0, atol=1e-4)


def test_what_cannot_be_skinned_is_reported(tmp_path, scene_dump):
    path = tmp_path / "person.usda"
    stage = person(path, np.random.default_rng(5), "usda", animated=False)
    meshes = [stage.GetPrimAtPath(f"/World/Person/Mesh{at}") for at in range(4)]
    meshes[0].GetAttribute("primvars:skel:jointIndices").Set([1, 2])
    meshes[1].GetAttribute("skel:joints").Set(["Nobody"])
    meshes[2].GetAttribute("primvars:skel:jointIndices").Set([99, 0])
    stage.GetPrimAtPath("/World/Person").GetRelationship("skel:skeleton").SetTargets([])
    UsdSkel.BindingAPI(meshes[3]).CreateSkeletonRel().SetTargets(["/World/Nowhere"])
    for mesh in meshes[:3]:
        UsdSkel.BindingAPI(mesh).CreateSkeletonRel().SetTargets(["/World/Person/Rig/Skeleton"])
    stage.Save()
    assert len(scene_dump(path).findings("skin")) == 4
