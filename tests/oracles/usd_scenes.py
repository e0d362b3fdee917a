"""Scenes that oaktwin extracts from stages, and what OpenUSD reads in the same stages: world-space triangles, texture
coordinates, colours, materials and labels."""

import json
from pathlib import Path

import numpy as np
from pxr import Gf, Usd, UsdGeom

# Single-precision rotations are interpolated by OpenUSD in single precision.
TOLERANCE = 2e-6
FORMATS = ["usda", "usdc"]


class Dump:
    """A scene as `scene-dump` wrote it."""

    def __init__(self, folder: Path):
        self.scene = json.loads((folder / "scene.json").read_text())
        self.data = (folder / "arrays.bin").read_bytes()

    def array(self, where):
        if where is None:
            return None
        count = int(np.prod(where["shape"]))
        flat = np.frombuffer(self.data, where["dtype"], count, where["offset"])
        return flat.reshape(where["shape"])

    def things(self):
        """Instances by path: world triangles with their surface values."""
        found = {}
        for instance in self.scene["instances"]:
            mesh = self.scene["meshes"][instance["mesh"]]
            matrix = np.array(instance["world_from_mesh"])
            points = self.array(mesh["positions"]).astype(np.float64) @ matrix[:, :3].T + matrix[:, 3]
            triangles = points[self.array(mesh["triangles"])]
            assert instance["path"] not in found
            found[instance["path"]] = {
                "triangles": triangles,
                "uvs": self.array(mesh["uvs"]),
                "colors": self.array(mesh["colors"]),
                "normals": self.array(mesh["normals"]),
                "materials": self.array(mesh["materials"])[:, 0],
                "labels": [tuple(label[1:]) for label in instance["labels"]],
                "labelled": [label[0] for label in instance["labels"]],
                "mesh": instance["mesh"],
            }
        return found

    def findings(self, code):
        return [finding for finding in self.scene["findings"] if f"[{code}]" in finding]


def value(attribute, time):
    """oaktwin's rule: at the time, or the default, or the first sample."""
    if time is not None:
        return attribute.Get(time)
    default = attribute.Get(Usd.TimeCode.Default())
    if default is None and attribute.GetNumTimeSamples():
        return attribute.Get(attribute.GetTimeSamples()[0])
    return default


def is_drawn(prim, time):
    imageable = UsdGeom.Imageable(prim)
    if not imageable or imageable.ComputePurpose() not in ("default", "render"):
        return False
    return imageable.ComputeVisibility(Usd.TimeCode.Default() if time is None else time) != "invisible"


def corners_of(mesh, time):
    """Faces fanned from their first corner: (face, corner, point) of each triangle's corners."""
    counts = value(mesh.GetFaceVertexCountsAttr(), time) or []
    indices = value(mesh.GetFaceVertexIndicesAttr(), time) or []
    holes = set(value(mesh.GetHoleIndicesAttr(), time) or [])
    flip = value(mesh.GetOrientationAttr(), time) == "leftHanded"
    counts, indices = (np.asarray(of).astype(np.int64).reshape(-1) for of in (counts, indices))
    starts = np.concatenate([[0], np.cumsum(counts)[:-1]]) if len(counts) else counts
    fans = np.maximum(counts - 2, 0) * ~np.isin(np.arange(len(counts)), list(holes))
    face = np.repeat(np.arange(len(counts)), fans)
    within = np.arange(fans.sum()) - np.repeat(np.cumsum(fans) - fans, fans)
    first = starts[face]
    second, third = first + within + 1, first + within + 2
    corners = np.stack([first, third, second] if flip else [first, second, third], axis=1)
    faces = np.broadcast_to(face[:, None], corners.shape)
    return np.stack([faces, corners, indices[corners]], axis=2)


def primvar_at(prim, name, corners, time):
    primvar = UsdGeom.PrimvarsAPI(prim).FindPrimvarWithInheritance(name)
    if not primvar or not primvar.HasValue():
        return None
    flat = np.asarray(primvar.ComputeFlattened(Usd.TimeCode.Default() if time is None else time)).astype(np.float64)
    flat = flat.reshape(len(flat), -1)
    column = {"constant": None, "uniform": 0, "faceVarying": 1, "vertex": 2, "varying": 2}
    column = column[primvar.GetInterpolation()]
    if column is None:
        return np.broadcast_to(flat[0], (*corners.shape[:2], flat.shape[1]))
    return flat[corners[:, :, column]]


def world(prim, time):
    cache = UsdGeom.XformCache(Usd.TimeCode.Default() if time is None else time)
    return np.array(cache.GetLocalToWorldTransform(prim))


def labels_of(prim):
    found = []
    while prim and not prim.IsPseudoRoot():
        for name in prim.GetPropertyNames():
            if name.startswith("semantics:labels:"):
                found += [(name.split(":")[-1], label) for label in prim.GetAttribute(name).Get()]
            elif name.startswith("semantic:") and name.endswith(":params:semanticData"):
                kind = prim.GetAttribute(name.replace("semanticData", "semanticType")).Get()
                found.append((kind, prim.GetAttribute(name).Get()))
        prim = prim.GetParent()
    return found


def expected(stage, time=None, uv="st"):
    """Everything visible, by path."""
    unit = UsdGeom.GetStageMetersPerUnit(stage)
    found = {}
    walk = iter(Usd.PrimRange.Stage(stage, Usd.TraverseInstanceProxies()))
    for prim in walk:
        if prim.IsA(UsdGeom.PointInstancer):
            walk.PruneChildren()
        elif prim.IsA(UsdGeom.Mesh) and is_drawn(prim, time):
            found[str(prim.GetPath())] = thing(prim, world(prim, time), unit, time, uv)
    return found


def thing(prim, matrix, unit, time, uv="st"):
    mesh = UsdGeom.Mesh(prim)
    corners = corners_of(mesh, time)
    points = np.asarray(value(mesh.GetPointsAttr(), time)).astype(np.float64).reshape(-1, 3)
    points = (points @ matrix[:3, :3] + matrix[3, :3]) * unit
    return {
        "triangles": points[corners[:, :, 2]],
        "uvs": primvar_at(prim, uv, corners, time),
        "colors": primvar_at(prim, "displayColor", corners, time),
        "labels": labels_of(prim),
    }


def instanced(instancer, path, time, parent, unit, found, uv="st"):
    """The instances of a point instancer, by OpenUSD's own matrices."""
    stage = instancer.GetPrim().GetStage()
    when = Usd.TimeCode.Default() if time is None else time
    matrices = instancer.ComputeInstanceTransformsAtTime(
        when, when, UsdGeom.PointInstancer.IncludeProtoXform, UsdGeom.PointInstancer.IgnoreMask
    )
    mask = instancer.ComputeMaskAtTime(when) or [True] * len(matrices)
    targets = instancer.GetPrototypesRel().GetForwardedTargets()
    for i, (index, keep) in enumerate(zip(value(instancer.GetProtoIndicesAttr(), time), mask)):
        if not keep:
            continue
        prototype = stage.GetPrimAtPath(targets[index])
        outer = np.array(matrices[i]) @ parent
        below(prototype, f"{path}[{i}]/{prototype.GetName()}", prototype, outer, time, unit, found, uv)


def below(prim, path, prototype, outer, time, unit, found, uv):
    when = Usd.TimeCode.Default() if time is None else time
    if not prim.IsActive() or UsdGeom.Imageable(prim) and (
        value(UsdGeom.Imageable(prim).GetVisibilityAttr(), time) == "invisible"
        or UsdGeom.Imageable(prim).ComputePurpose() not in ("default", "render")
    ):
        return
    cache = UsdGeom.XformCache(when)
    if prim == prototype:
        matrix = outer
    else:
        matrix = np.array(cache.ComputeRelativeTransform(prim, prototype)[0]) @ outer
    if prim.IsA(UsdGeom.PointInstancer):
        instanced(UsdGeom.PointInstancer(prim), path, time, matrix, unit, found, uv)
        return
    if prim.IsA(UsdGeom.Mesh):
        found[path] = thing(prim, matrix, unit, time, uv)
    for child in prim.GetFilteredChildren(Usd.PrimAllPrimsPredicate):
        below(child, f"{path}/{child.GetName()}", prototype, outer, time, unit, found, uv)


def rows(thing, names):
    """Triangles with surface values, in an order that does not depend on how they were stored."""
    parts = [thing["triangles"].reshape(-1, 9)]
    for name in names:
        parts.append(np.asarray(thing[name]).reshape(len(parts[0]), -1))
    table = np.concatenate(parts, axis=1)
    return table[np.lexsort(np.round(table, 4).T[::-1])]


def compare(got: Dump, wanted: dict, names=()):
    things = got.things()
    assert list(things) == list(wanted), "the same things in the order of traversal"
    for path, thing in wanted.items():
        scale = 1.0 + np.abs(thing["triangles"]).max(initial=0.0)
        np.testing.assert_allclose(
            rows(things[path], names), rows(thing, names), rtol=0, atol=TOLERANCE * scale, err_msg=path
        )
        assert things[path]["labels"] == thing["labels"], path


def new_stage(path: Path, up="Z", unit=1.0):
    stage = Usd.Stage.CreateNew(str(path))
    UsdGeom.SetStageUpAxis(stage, up)
    UsdGeom.SetStageMetersPerUnit(stage, unit)
    return stage


def add_mesh(stage, path, counts=(3, 4), scheme="none", seed=0):
    """A strip of convex faces in the plane, bent a little."""
    rng = np.random.default_rng(seed)
    mesh = UsdGeom.Mesh.Define(stage, path)
    points, indices = [], []
    for i, count in enumerate(counts):
        angle = 2 * np.pi * np.arange(count) / count
        indices += list(range(len(points), len(points) + count))
        points += [(np.cos(a) + 2.5 * i, np.sin(a), 0.1 * rng.random()) for a in angle]
    mesh.CreatePointsAttr([Gf.Vec3f(*map(float, point)) for point in points])
    mesh.CreateFaceVertexCountsAttr(list(counts))
    mesh.CreateFaceVertexIndicesAttr(indices)
    mesh.CreateSubdivisionSchemeAttr(scheme)
    return mesh


def vec(rng, kind, low=-2.0, high=2.0):
    return kind(*map(float, rng.uniform(low, high, 3)))
