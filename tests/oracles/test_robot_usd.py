"""Robots of UsdPhysics, as OpenUSD's reader of physics understands them, and as NVIDIA's converter makes them of URDF."""

from pathlib import Path

import numpy as np
import pytest
import urdf_usd_converter
import yourdfpy
from pxr import Gf, Usd, UsdGeom, UsdPhysics

from test_robot_reading import URDF, Workspace, workspace  # noqa: F401, a fixture


def test_a_converted_urdf_moves_as_in_yourdfpy(workspace: Workspace) -> None:  # noqa: F811
    # The converter writes a schema of a vendor for joints that follow others.
    urdf = "\n".join(line for line in URDF.splitlines() if "<mimic" not in line)
    path = workspace.folder / "arm.urdf"
    path.write_text(urdf)
    packages = [{"name": "arm", "path": str(workspace.folder)}]
    converter = urdf_usd_converter.Converter(ros_packages=packages)
    asset = converter.convert(str(path), str(workspace.folder / "usd"))
    model = yourdfpy.URDF.load(str(path), load_meshes=False, build_scene_graph=True)
    names = ["wrist", "shoulder", "left", "right"]
    rows = np.array([[0.0, 0.0, 0.0, 0.0], [1.3, -1.9, 0.04, 0.01], [-7.0, 0.6, 0.013, 0.04]])
    workspace.table(names, rows)
    # The converter makes a plain prim of a fixed link without shapes.
    for link in set(model.link_map) - {"oak"}:
        for row, pose in zip(rows, workspace.poses(asset.path, link), strict=True):
            model.update_cfg(dict(zip(names, row, strict=True)))
            # Stages store the frames of joints in single precision.
            expected = model.get_transform(link, model.base_link)
            np.testing.assert_allclose(pose, expected, rtol=0, atol=2e-6, err_msg=link)


def random_pose(random: np.random.Generator) -> tuple[Gf.Vec3f, Gf.Quatf]:
    w, x, y, z = random.standard_normal(4)
    return Gf.Vec3f(*(30 * random.standard_normal(3))), Gf.Quatf(w, x, y, z).GetNormalized()


def make(path: Path, seed: int) -> None:
    """A chain of four bodies with scales, in centimetres; some joints name a prim below their body, or run towards the base."""
    random = np.random.default_rng(seed)
    stage = Usd.Stage.CreateNew(str(path))
    UsdGeom.SetStageMetersPerUnit(stage, 0.01)
    UsdGeom.SetStageUpAxis(stage, UsdGeom.Tokens.z)
    root = UsdGeom.Xform.Define(stage, "/Robot")
    stage.SetDefaultPrim(root.GetPrim())
    UsdPhysics.ArticulationRootAPI.Apply(root.GetPrim())
    for number in range(4):
        body = UsdGeom.Xform.Define(stage, f"/Robot/link_{number}")
        UsdPhysics.RigidBodyAPI.Apply(body.GetPrim())
        position, rotation = random_pose(random)
        body.AddTranslateOp().Set(Gf.Vec3d(position))
        body.AddOrientOp().Set(rotation)
        # Below a scale that differs by axis, turned prims are sheared.
        body.AddScaleOp().Set(Gf.Vec3f(float(random.uniform(0.5, 2))))
        UsdGeom.Cube.Define(stage, f"/Robot/link_{number}/shape")
        flange = UsdGeom.Xform.Define(stage, f"/Robot/link_{number}/flange")
        flange.AddTranslateOp().Set(Gf.Vec3d(*random.standard_normal(3)))
        flange.AddRotateXOp().Set(random.uniform(-90, 90))
    kinds = [UsdPhysics.FixedJoint, UsdPhysics.RevoluteJoint, UsdPhysics.PrismaticJoint, UsdPhysics.RevoluteJoint]
    for number, kind in enumerate(kinds):
        joint = kind.Define(stage, f"/Robot/joint_{number}")
        ends = [None if number == 0 else f"/Robot/link_{number - 1}", f"/Robot/link_{number}"]
        if number == 2:
            ends[0] += "/flange"
        if number == 3:
            ends.reverse()
        for end, (relation, place, turn) in zip(
            ends,
            [
                (joint.GetBody0Rel(), joint.GetLocalPos0Attr(), joint.GetLocalRot0Attr()),
                (joint.GetBody1Rel(), joint.GetLocalPos1Attr(), joint.GetLocalRot1Attr()),
            ],
            strict=True,
        ):
            if end is not None:
                relation.SetTargets([end])
            position, rotation = random_pose(random)
            place.Set(position)
            turn.Set(rotation)
        if number > 0:
            joint.CreateAxisAttr("XYZ"[random.integers(3)])
    stage.Save()


def matrix(position: Gf.Vec3f, rotation: Gf.Quatf) -> np.ndarray:
    pose = np.eye(4)
    pose[:3, :3] = np.array(Gf.Matrix3d(Gf.Rotation(Gf.Quatd(rotation)))).T
    pose[:3, 3] = 0.01 * np.array(position)
    return pose


def motion(joint, axis: str, position: float) -> np.ndarray:
    vector = np.eye(3)["XYZ".index(axis)]
    if joint.type == UsdPhysics.ObjectType.PrismaticJoint:
        return matrix(Gf.Vec3f(*(100 * position * vector)), Gf.Quatf(1))
    rotation = Gf.Rotation(Gf.Vec3d(*vector), np.degrees(position))
    pose = np.eye(4)
    pose[:3, :3] = np.array(Gf.Matrix3d(rotation)).T
    return pose


@pytest.mark.parametrize("seed", range(4))
def test_a_stage_moves_as_its_joints_say(workspace: Workspace, seed: int) -> None:  # noqa: F811
    path = workspace.folder / "robot.usda"
    make(path, seed)
    stage = Usd.Stage.Open(str(path))
    parsed = UsdPhysics.LoadUsdPhysicsFromRange(stage, ["/Robot"])
    joints = {}
    for kind in ("FixedJoint", "RevoluteJoint", "PrismaticJoint"):
        for joint in parsed[getattr(UsdPhysics.ObjectType, kind)][1]:
            joints[str(joint.primPath)] = joint
    rows = np.random.default_rng(seed).uniform(-1, 1, (3, 3))
    workspace.table(["joint_1", "joint_2", "joint_3"], rows)
    expected = []
    for row in rows:
        poses = []
        for number in range(4):
            joint = joints[f"/Robot/joint_{number}"]
            first = matrix(joint.localPose0Position, joint.localPose0Orientation)
            second = matrix(joint.localPose1Position, joint.localPose1Orientation)
            moved = np.eye(4)
            if number > 0:
                axis = stage.GetPrimAtPath(joint.primPath).GetAttribute("physics:axis").Get()
                moved = motion(joint, axis, row[number - 1])
            second_from_first = first @ moved @ np.linalg.inv(second)
            assert str(joint.body1).endswith("link_2" if number == 3 else f"link_{number}")
            above = poses[-1] if poses else np.eye(4)
            poses.append(above @ (np.linalg.inv(second_from_first) if number == 3 else second_from_first))
        expected.append(poses)
    for number in range(4):
        for poses, pose in zip(expected, workspace.poses("robot.usda", f"link_{number}"), strict=True):
            np.testing.assert_allclose(pose, poses[number], rtol=0, atol=2e-6, err_msg=f"link_{number}")
