"""The triangles of a USD stage as OpenUSD composes it: `extract_triangles.py STAGE POSITIONS TRIANGLES`.

Writes the world positions in metres as float32 (n, 3) and the corners as uint32 (m, 3), bare numbers, little-endian.
Meshes only: visible ones of purpose default and render, including those of PointInstancers, faces fanned from their
first vertex, holes left out.
"""

import sys
from collections.abc import Callable, Iterator

import numpy as np
from pxr import Gf, Usd, UsdGeom


def fanned(counts: np.ndarray, indices: np.ndarray, holes: np.ndarray) -> np.ndarray:
    """Polygons as triangles (m, 3), in the order of the faces."""
    starts = np.concatenate([[0], np.cumsum(counts)[:-1]])
    kept = np.ones(len(counts), bool)
    kept[holes] = False
    counts, starts = counts[kept], starts[kept]
    each = np.maximum(counts - 2, 0)
    face = np.repeat(np.arange(len(counts)), each)
    step = np.arange(each.sum()) - np.repeat(np.cumsum(each) - each, each)
    first = starts[face]
    return np.stack([indices[first], indices[first + step + 1], indices[first + step + 2]], -1)


Place = Callable[[Usd.Prim], Gf.Matrix4d]


def placed_meshes(root: Usd.Prim, place: Place) -> Iterator[tuple[UsdGeom.Mesh, Gf.Matrix4d]]:
    """The visible meshes below `root` with their world transforms for row vectors; `place` omits
    instancers."""
    prims = iter(Usd.PrimRange(root, Usd.TraverseInstanceProxies()))
    for prim in prims:
        if prim.IsA(UsdGeom.PointInstancer):
            prims.PruneChildren()
            yield from instances(UsdGeom.PointInstancer(prim), place)
        elif prim.IsA(UsdGeom.Mesh):
            mesh = UsdGeom.Mesh(prim)
            seen = mesh.ComputeVisibility() != UsdGeom.Tokens.invisible
            if seen and mesh.ComputePurpose() in (UsdGeom.Tokens.default_, UsdGeom.Tokens.render):
                yield mesh, place(prim)


def instances(instancer: UsdGeom.PointInstancer, place: Place) -> Iterator[tuple[UsdGeom.Mesh, Gf.Matrix4d]]:
    """The meshes of a PointInstancer."""
    stage, now = instancer.GetPrim().GetStage(), Usd.TimeCode.Default()
    prototypes = [stage.GetPrimAtPath(path) for path in instancer.GetPrototypesRel().GetForwardedTargets()]
    # Includes the prototype's own transform, excludes masked instances.
    transforms = instancer.ComputeInstanceTransformsAtTime(now, now)
    indices = instancer.GetProtoIndicesAttr().Get()
    shown = instancer.ComputeMaskAtTime(now) or [True] * len(indices)
    for index, transform in zip((i for i, kept in zip(indices, shown, strict=True) if kept), transforms, strict=True):
        prototype = prototypes[index]
        outside = place(prototype).GetInverse() * transform * place(instancer.GetPrim())
        yield from placed_meshes(prototype, lambda prim, outside=outside: place(prim) * outside)


def extract(path: str) -> tuple[np.ndarray, np.ndarray]:
    """Positions (n, 3) in float32 and triangles (m, 3) in uint32."""
    stage = Usd.Stage.Open(path)
    unit = UsdGeom.GetStageMetersPerUnit(stage)
    cache = UsdGeom.XformCache()
    positions, triangles, count = [], [], 0
    for mesh, world_from_mesh in placed_meshes(stage.GetPseudoRoot(), cache.GetLocalToWorldTransform):
        points = np.array(mesh.GetPointsAttr().Get() or np.zeros((0, 3)), float)
        counts = np.array(mesh.GetFaceVertexCountsAttr().Get() or [], int)
        indices = np.array(mesh.GetFaceVertexIndicesAttr().Get() or [], int)
        holes = np.array(mesh.GetHoleIndicesAttr().Get() or [], int)
        matrix = np.array(world_from_mesh)
        positions.append((points @ matrix[:3, :3] + matrix[3, :3]) * unit)
        triangles.append(fanned(counts, indices, holes) + count)
        count += len(points)
    return np.concatenate(positions).astype("<f4"), np.concatenate(triangles).astype("<u4")


def main() -> None:
    stage, positions, triangles = sys.argv[1:]
    points, corners = extract(stage)
    points.tofile(positions)
    corners.tofile(triangles)
    print(f"{len(corners)} triangles, {len(points)} vertices, {points.min(0)} to {points.max(0)} m")


if __name__ == "__main__":
    main()
