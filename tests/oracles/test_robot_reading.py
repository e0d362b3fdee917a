"""Robots that carry an OAK, as yourdfpy and MuJoCo read and move them."""

import json
import os
import subprocess
from pathlib import Path

import numpy as np
import pytest
import trimesh
import yourdfpy

os.environ.setdefault("MUJOCO_GL", "egl")
import mujoco  # noqa: E402, after the choice of its graphics

ROOM = """#usda 1.0
(
    upAxis = "Z"
    metersPerUnit = 1
)
def Xform "Room"
{
    def Cube "Floor"
    {
        double size = 1
        double3 xformOp:translate = (0, 0, -0.55)
        float3 xformOp:scale = (6, 6, 0.1)
        uniform token[] xformOpOrder = ["xformOp:translate", "xformOp:scale"]
    }
    def Cube "Wall"
    {
        double size = 1
        double3 xformOp:translate = (3.05, 0, 1)
        float3 xformOp:scale = (0.1, 6, 3)
        uniform token[] xformOpOrder = ["xformOp:translate", "xformOp:scale"]
    }
}
"""

URDF = """<?xml version="1.0"?>
<robot name="arm">
  <material name="blue"><color rgba="0.1 0.2 0.8 1"/></material>
  <joint name="wrist" type="continuous">
    <parent link="upper"/><child link="hand"/>
    <origin xyz="0.05 -0.02 0.4" rpy="0.3 -0.4 2.5"/><axis xyz="1 2 -0.5"/>
  </joint>
  <link name="base"><visual><geometry><cylinder radius="0.1" length="0.2"/></geometry></visual></link>
  <link name="upper">
    <visual><origin xyz="0 0 0.2"/><geometry><box size="0.06 0.08 0.4"/></geometry><material name="blue"/></visual>
  </link>
  <link name="hand"><visual><geometry><mesh filename="package://arm/meshes/hand.stl" scale="0.001 0.001 -0.001"/></geometry></visual></link>
  <link name="left_finger"><visual><geometry><sphere radius="0.02"/></geometry></visual></link>
  <link name="right_finger"/>
  <link name="oak"/>
  <joint name="shoulder" type="revolute">
    <parent link="base"/><child link="upper"/>
    <origin xyz="0 0.1 0.2" rpy="0 0.2 0"/><axis xyz="0 1 0"/><limit lower="-2" upper="2" effort="1" velocity="1"/>
  </joint>
  <joint name="left" type="prismatic">
    <parent link="hand"/><child link="left_finger"/>
    <origin xyz="0 0.02 0.1"/><axis xyz="0 1 0"/><limit lower="0" upper="0.04" effort="1" velocity="1"/>
  </joint>
  <joint name="right" type="prismatic">
    <parent link="hand"/><child link="right_finger"/>
    <origin xyz="0 -0.02 0.1" rpy="0 0 3.14"/><axis xyz="0 1 0"/><limit lower="0" upper="0.04" effort="1" velocity="1"/>
    <mimic joint="left" multiplier="0.5" offset="0.001"/>
  </joint>
  <joint name="oak_mount" type="fixed">
    <parent link="hand"/><child link="oak"/><origin xyz="0.1 0 0.03" rpy="0.2 -0.9 0.1"/>
  </joint>
</robot>
"""

MJCF = """<mujoco model="arm">
  <compiler angle="degree" eulerseq="XYz" meshdir="meshes"/>
  <default>
    <geom rgba="0.6 0.5 0.4 1"/>
    <default class="arm">
      <joint axis="0 1 0" range="-90 120"/>
      <geom type="capsule" size="0.03"/>
      <default class="slider"><joint type="slide" axis="1 0.5 0" range="-0.1 0.1"/></default>
    </default>
  </default>
  <asset>
    <mesh name="hand" file="hand.stl" scale="0.001 0.0012 0.001" refpos="5 -3 8" refquat="0.9 0.1 0.3 -0.2"/>
  </asset>
  <worldbody>
    <geom type="box" size="0.3 0.3 0.02" pos="0 0 -0.02"/>
    <body name="base" pos="0.1 0 0.1" euler="10 20 30" childclass="arm">
      <geom type="cylinder" size="0.08 0.1"/>
      <body name="upper" pos="0 0 0.1" axisangle="0 1 1 25">
        <joint name="shoulder" pos="0 0.02 0.01"/>
        <joint name="twist" axis="0.1 0 1" pos="0.01 0 0.2" ref="15"/>
        <geom fromto="0 0 0 0.05 0 0.4"/>
        <geom type="box" fromto="0.1 0.2 0 0.2 0.1 0.3" size="0.02"/>
        <frame pos="0.05 0 0.4" xyaxes="1 0.2 0 0 1 0.3">
          <body name="hand" zaxis="0.3 0.2 1">
            <joint name="slide" class="slider"/>
            <geom type="mesh" mesh="hand" pos="0.01 0.02 0.03" euler="5 6 7"/>
            <geom type="ellipsoid" size="0.02 0.03 0.05" pos="0 0 0.2"/>
            <geom type="sphere" size="0.5" group="3"/>
            <body name="oak" pos="0.12 0 0.05" euler="0 -40 20"/>
          </body>
        </frame>
      </body>
    </body>
  </worldbody>
</mujoco>
"""


class Workspace:
    """A folder with the room, and what the program says about robots in it."""

    def __init__(self, program: Path, folder: Path) -> None:
        self.program, self.folder = program, folder
        (folder / "room.usda").write_text(ROOM)
        (folder / "meshes").mkdir()
        hand = trimesh.creation.box(extents=[60, 90, 40])
        hand.apply_translation([10, 5, 30])
        hand.export(folder / "meshes/hand.stl")

    def run(self, *arguments: object) -> str:
        command = [self.program, *map(str, arguments)]
        return subprocess.run(command, check=True, capture_output=True, cwd=self.folder, text=True).stdout

    def table(self, names: list[str], rows: np.ndarray) -> None:
        lines = [",".join(names), *(",".join(repr(float(x)) for x in row) for row in rows)]
        (self.folder / "poses.csv").write_text("\n".join(lines) + "\n")

    def poses(self, robot: str, link: str) -> list[np.ndarray]:
        """The pose of a link in each posture, as the OAK's body that it carries has it."""
        said = self.run(
            "coverage", "room.usda", "--robot", robot, "--joints", "poses.csv", "--mount", link,
            "--model", "OAK-D-Lite", "--resolution", "64x48", "--samples", "1", "--json",
        )  # fmt: skip
        poses = []
        for posture in json.loads(said)["mounts"][0]["postures"]:
            pose = np.eye(4)
            w = np.array(posture["orientation"])[[3, 0, 1, 2]]
            matrix = np.zeros(9)
            mujoco.mju_quat2Mat(matrix, w)
            pose[:3, :3] = matrix.reshape(3, 3)
            pose[:3, 3] = posture["position_m"]
            poses.append(pose)
        return poses


@pytest.fixture
def workspace(program: Path, tmp_path: Path) -> Workspace:
    folder = tmp_path / "arm"
    folder.mkdir()
    return Workspace(program, folder)


def test_urdf_moves_as_in_yourdfpy(workspace: Workspace) -> None:
    path = workspace.folder / "arm.urdf"
    path.write_text(URDF)
    model = yourdfpy.URDF.load(str(path), load_meshes=False, build_scene_graph=True)
    names = ["wrist", "shoulder", "left"]
    rows = np.array([[0.0, 0.0, 0.0], [1.3, -1.9, 0.04], [-7.0, 0.6, 0.013]])
    workspace.table(names, rows)
    for link in model.link_map:
        for row, pose in zip(rows, workspace.poses("arm.urdf", link), strict=True):
            model.update_cfg(dict(zip(names, row, strict=True)))
            expected = model.get_transform(link, model.base_link)
            np.testing.assert_allclose(pose, expected, rtol=0, atol=1e-9, err_msg=link)


def saved(workspace: Workspace, name: str) -> str:
    """The file that MuJoCo saves of a model."""
    model = mujoco.MjModel.from_xml_path(str(workspace.folder / name))
    mujoco.mj_saveLastXML(str(workspace.folder / "saved.xml"), model)
    return "saved.xml"


POSTURES = np.array([[0.0, 0.3, 0.0], [1.2, -0.5, 0.09], [-1.5, 1.9, -0.05]])


@pytest.mark.parametrize("is_saved", [False, True])
def test_mjcf_moves_as_in_mujoco(workspace: Workspace, is_saved: bool) -> None:
    path = workspace.folder / "arm.xml"
    path.write_text(MJCF)
    model = mujoco.MjModel.from_xml_path(str(path))
    robot = saved(workspace, "arm.xml") if is_saved else "arm.xml"
    data = mujoco.MjData(model)
    workspace.table(["shoulder", "twist", "slide"], POSTURES)
    # A saved file has numbers of six digits.
    tolerance = 1e-5 if is_saved else 1e-9
    for link in ("world", "base", "upper", "hand", "oak"):
        for row, pose in zip(POSTURES, workspace.poses(robot, link), strict=True):
            data.qpos[:] = row
            mujoco.mj_kinematics(model, data)
            body = data.body(link)
            np.testing.assert_allclose(pose[:3, 3], body.xpos, rtol=0, atol=tolerance, err_msg=link)
            np.testing.assert_allclose(pose[:3, :3].ravel(), body.xmat, rtol=0, atol=tolerance, err_msg=link)


@pytest.mark.parametrize("is_saved", [False, True])
def test_the_oak_sees_what_mujocos_rays_hit(workspace: Workspace, is_saved: bool) -> None:
    """Depth of the robot and the room, by rays of MuJoCo; shapes are tessellated here, so pixels at edges may differ."""
    path = workspace.folder / "arm.xml"
    path.write_text(MJCF)
    robot = saved(workspace, "arm.xml") if is_saved else "arm.xml"
    # The room of the other file.
    room = '<geom type="box" size="3 3 0.05" pos="0 0 -0.55"/><geom type="box" size="0.05 3 1.5" pos="3.05 0 1"/>'
    path.write_text(MJCF.replace("<worldbody>", "<worldbody>" + room))
    model = mujoco.MjModel.from_xml_path(str(path))
    data = mujoco.MjData(model)
    workspace.table(["shoulder", "twist", "slide"], POSTURES)
    workspace.run(
        "render", "room.usda", "--robot", robot, "--joints", "poses.csv", "--model", "OAK4-D", "--camera", "left",
        "--mount", "base", "--pose", "-0.9", "-0.3", "0.1", "0", "0", "0.1736481776669", "0.984807753012",
        "--resolution", "160x100", "--annotators", "distance_to_camera,camera_params",
    )  # fmt: skip
    groups = np.array([1, 1, 1, 0, 0, 0], dtype=np.uint8)
    for number, row in enumerate(POSTURES):
        frame = workspace.folder / "oaktwin-render"
        range_m = np.load(frame / f"distance_to_camera_{number:04}.npy")
        camera = json.loads((frame / f"camera_params_{number:04}.json").read_text())
        data.qpos[:] = row
        mujoco.mj_kinematics(model, data)
        world_from_usd = np.linalg.inv(np.array(camera["cameraViewTransform"]).reshape(4, 4).T)
        height, width = range_m.shape
        projection = np.array(camera["cameraProjection"]).reshape(4, 4)
        x, y = np.meshgrid((np.arange(width) + 0.5) / width * 2 - 1, 1 - (np.arange(height) + 0.5) / height * 2)
        x, y = (x + projection[2, 0]) / projection[0, 0], (y + projection[2, 1]) / projection[1, 1]
        rays = np.stack([x, y, np.full_like(x, -1)], axis=-1)
        rays /= np.linalg.norm(rays, axis=-1, keepdims=True)
        rays = rays @ world_from_usd[:3, :3].T
        expected = np.full(range_m.shape, np.inf)
        geom = np.zeros(1, dtype=np.int32)
        for index in np.ndindex(range_m.shape):
            distance = mujoco.mj_ray(model, data, world_from_usd[:3, 3], rays[index], groups, 1, -1, geom)
            expected[index] = distance if distance >= 0 else np.inf
        both = np.isfinite(expected) & np.isfinite(range_m)
        assert both.mean() > 0.5
        off = np.isfinite(expected) != np.isfinite(range_m)
        off[both] = np.abs(range_m[both] - expected[both]) > 5e-4
        assert off.mean() < 0.01, (number, off.mean())
        # The arm is nearer than the room.
        assert (expected < 1.5).mean() > 0.02

