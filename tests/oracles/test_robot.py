"""Descriptions for robots, as other programs read them: yourdfpy, xacro, Drake, Isaac Sim's URDF converter and MuJoCo."""

import json
import math
import os
import shutil
import subprocess
import xml.etree.ElementTree as ET
from pathlib import Path

import numpy as np
import pytest
import urdf_usd_converter
import xacro
import yourdfpy
from pxr import Usd, UsdGeom
from pydrake.all import AddMultibodyPlantSceneGraph, DiagramBuilder, GeometrySet, Parser, Role, RollPitchYaw

os.environ.setdefault("MUJOCO_GL", "egl")
import mujoco  # noqa: E402, after the choice of its graphics

MODELS = ["OAK-D Pro PoE", "OAK-D Pro W PoE", "OAK4-D", "OAK-D ToF"]
OPTICAL = np.array([[0, 0, 1], [-1, 0, 0], [0, -1, 0]], dtype=float)
MOUNT = ["--parent", "wrist", "--mount", "bottom", "--xyz", "0.1", "-0.2", "0.3", "--rpy", "0.4", "-0.5", "2.6"]


class Exports:
    """Exports by the program, made on first use."""

    def __init__(self, program: Path, folder: Path) -> None:
        self.program, self.folder, self.made = program, folder, {}

    def __call__(self, model: str, to: str, *options: str) -> Path:
        key = (model, to, options)
        if key not in self.made:
            folder = self.folder / str(len(self.made))
            command = [self.program, "export", model, "--to", to, "-o", folder, *options]
            subprocess.run(command, check=True, capture_output=True)
            self.made[key] = folder
        return self.made[key]

    def show(self, model: str) -> dict:
        command = [self.program, "show", model, "--json"]
        return json.loads(subprocess.run(command, check=True, capture_output=True).stdout)


@pytest.fixture(scope="session")
def exports(program: Path, tmp_path_factory: pytest.TempPathFactory) -> Exports:
    return Exports(program, tmp_path_factory.mktemp("robots"))


def frames(shown: dict) -> dict[str, np.ndarray]:
    """The nominal poses of the optical frames in the body: parallel cameras at the catalog's positions."""
    expected = {}
    for camera in shown["cameras"]:
        pose = np.eye(4)
        pose[:3, :3] = OPTICAL
        pose[:3, 3] = np.array(camera["position_mm"]) * 1e-3
        expected[f"oak_{camera['role']}_camera_optical_frame"] = pose
    imu = np.eye(4)
    imu[:3, :3] = shown["imu"]["rotation"]
    imu[:3, 3] = np.array(shown["imu"]["position_mm"]) * 1e-3
    expected["oak_imu_frame"] = imu
    sensor = shown["depth_sensors"][0]
    role = "tof_depth" if sensor["kind"] == "tof" else "stereo_depth"
    expected[f"oak_{role}_camera_optical_frame"] = expected[f"oak_{sensor['camera']}_camera_optical_frame"]
    return expected


def mounted(shown: dict) -> np.ndarray:
    """The pose of the body in the frame of the wrist, with `MOUNT`."""
    width, height, depth = np.array(shown["body"]["dimensions_mm"]) * 1e-3
    front = np.array(shown["body"]["front_mm"]) * 1e-3
    bottom = front + [-depth / 2, 0, -height / 2]
    pose = np.eye(4)
    pose[:3, :3] = RollPitchYaw(0.4, -0.5, 2.6).ToRotationMatrix().matrix()
    pose[:3, 3] = np.array([0.1, -0.2, 0.3]) - pose[:3, :3] @ bottom
    return pose


@pytest.mark.parametrize("model", MODELS)
def test_urdf_has_the_frames_of_the_twin(exports: Exports, model: str) -> None:
    robot = yourdfpy.URDF.load(str(exports(model, "urdf") / "oak.urdf"))
    for name, pose in frames(exports.show(model)).items():
        assert robot.get_transform(name, "oak") == pytest.approx(pose, abs=2e-9), name
    assert {"oak_model_origin", "oak_left_camera_frame"} <= set(robot.link_map) or model == "OAK-D ToF"


@pytest.mark.parametrize("model", MODELS)
def test_drake_reads_urdf_sdf_and_mjcf(exports: Exports, model: str) -> None:
    shown = exports.show(model)
    for to, file in [("urdf", "oak.urdf"), ("drake", "model.sdf"), ("mjcf", "oak.xml")]:
        # With a scene graph, colliders are read as well.
        plant, scene = AddMultibodyPlantSceneGraph(DiagramBuilder(), 0.0)
        Parser(plant).AddModels(str(exports(model, to) / file))
        plant.Finalize()
        colliders = scene.model_inspector().GetGeometryIds(GeometrySet(scene.model_inspector().GetAllGeometryIds()), Role.kProximity)
        assert len(colliders) == 1, to
        context = plant.CreateDefaultContext()
        body = plant.GetFrameByName("oak")
        # Drake reads no cameras of MJCF.
        for name, pose in frames(shown).items() if to != "mjcf" else ():
            found = plant.GetFrameByName(name).CalcPose(context, body).GetAsMatrix4()
            assert found == pytest.approx(pose, abs=2e-9), (to, name)
        mass = sum(plant.get_body(index).default_mass() for index in plant.GetBodyIndices(plant.GetModelInstanceByName("oak")))
        assert mass == pytest.approx(shown["body"]["mass_g"] * 1e-3, rel=1e-9)


def test_the_mount_and_the_parent(exports: Exports) -> None:
    model = "OAK-D Pro PoE"
    shown = exports.show(model)
    expected = mounted(shown)
    robot = yourdfpy.URDF.load(str(exports(model, "urdf", *MOUNT) / "oak.urdf"))
    assert robot.get_transform("oak", "wrist") == pytest.approx(expected, abs=2e-9)
    model_of = mujoco.MjModel.from_xml_path(str(exports(model, "mjcf", *MOUNT) / "oak.xml"))
    data = mujoco.MjData(model_of)
    mujoco.mj_forward(model_of, data)
    body = data.body("oak")
    assert body.xpos == pytest.approx(expected[:3, 3], abs=1e-8)
    assert body.xmat.reshape(3, 3) == pytest.approx(expected[:3, :3], abs=1e-8)


def test_the_macro_equals_the_plain_file(exports: Exports, tmp_path: Path) -> None:
    model = "OAK-D Pro PoE"
    folder = exports(model, "urdf", *MOUNT)
    plain = ET.fromstring((folder / "oak.urdf").read_text())
    [joint] = [joint for joint in plain.findall("joint") if joint.get("name") == "oak_center_joint"]
    origin = ET.tostring(joint.find("origin"), encoding="unicode")
    robot = tmp_path / "robot.xacro"
    robot.write_text(
        f'<robot name="oak" xmlns:xacro="http://www.ros.org/wiki/xacro"><link name="wrist"/>'
        f'<xacro:include filename="{folder}/oak_d_pro_poe.urdf.xacro"/>'
        f'<xacro:oak_d_pro_poe parent="wrist">{origin}</xacro:oak_d_pro_poe></robot>'
    )
    made = ET.fromstring(xacro.process_file(str(robot)).toxml())

    def elements(root: ET.Element) -> set[str]:
        for element in root.iter():
            element.text = element.tail = None
        return {ET.canonicalize(ET.tostring(child, encoding="unicode")) for child in root if isinstance(child.tag, str)}

    assert elements(made) == elements(plain)


def test_isaac_sims_converter_keeps_the_frames(exports: Exports, tmp_path: Path) -> None:
    model = "OAK-D Pro PoE"
    converter = urdf_usd_converter.Converter()
    asset = converter.convert(str(exports(model, "urdf", *MOUNT) / "oak.urdf"), str(tmp_path / "usd"))
    stage = Usd.Stage.Open(asset.path)
    prims = {prim.GetName(): prim for prim in stage.Traverse() if prim.IsA(UsdGeom.Xformable)}
    poses = {name: np.array(UsdGeom.Xformable(prim).ComputeLocalToWorldTransform(0)).T for name, prim in prims.items()}
    for name, expected in frames(exports.show(model)).items():
        assert np.linalg.inv(poses["oak"]) @ poses[name] == pytest.approx(expected, abs=1e-6), name


@pytest.mark.parametrize("model", MODELS)
def test_sdf_has_the_intrinsics_of_the_twin(exports: Exports, model: str) -> None:
    root = ET.parse(exports(model, "sdf") / "model.sdf").getroot()
    assert root.get("version") == "1.9"
    sensors = {sensor.get("name"): sensor for sensor in root.iter("sensor")}
    for camera in exports.show(model)["cameras"]:
        optics = sensors[f"oak_{camera['role']}"].find("camera")
        found = [float(optics.find(f"lens/intrinsics/{name}").text) for name in ("fx", "fy", "cx", "cy", "s")]
        centre = camera["principal_point_usd"]
        assert found == pytest.approx([camera["fx"], camera["fy"], centre["x"], centre["y"], 0.0], abs=1e-8)
        assert math.degrees(float(optics.find("horizontal_fov").text)) == pytest.approx(camera["fov_deg"][0], abs=1e-6)
    depths = [sensor for sensor in sensors.values() if sensor.get("type") == "rgbd_camera"]
    assert len(depths) == len(exports.show(model)["depth_sensors"])
    assert all(depth.find("camera/noise") is None for depth in depths)


def test_mujoco_sees_what_the_twin_sees(exports: Exports, tmp_path: Path) -> None:
    """The camera's range finder, which needs no graphics, against the program's depth of the same boxes."""
    model, folder = "OAK-D Pro PoE", exports("OAK-D Pro PoE", "mjcf")
    boxes = [((2.0, 0.3, 0.1), (0.2, 0.3, 0.1), 0.5), ((3.0, -0.6, -0.2), (0.4, 0.2, 0.5), -0.3), ((5.0, 0, 0), (0.1, 9, 9), 0.0)]
    geoms, obj, count = "", "", 0
    for (x, y, z), size, yaw in boxes:
        geoms += f'<geom type="box" pos="{x} {y} {z}" size="{" ".join(map(str, size))}" euler="0 0 {yaw}"/>'
        turn = np.array([[math.cos(yaw), -math.sin(yaw), 0], [math.sin(yaw), math.cos(yaw), 0], [0, 0, 1]])
        for i in range(8):
            corner = [size[axis] * (1 if i >> axis & 1 else -1) for axis in range(3)]
            obj += "v {:.9f} {:.9f} {:.9f}\n".format(*(turn @ corner + [x, y, z]))
        for face in [(0, 4, 6, 2), (1, 3, 7, 5), (0, 1, 5, 4), (2, 6, 7, 3), (0, 2, 3, 1), (4, 5, 7, 6)]:
            obj += "f " + " ".join(str(count + i + 1) for i in face) + "\n"
        count += 8
    (tmp_path / "boxes.obj").write_text(obj)
    text = f"""<mujoco><compiler angle="radian"/><size memory="500M"/>
      <asset><model name="oak" file="{folder}/oak.xml"/></asset>
      <worldbody>{geoms}<attach model="oak" body="oak" prefix=""/></worldbody></mujoco>"""
    spec = mujoco.MjSpec.from_string(text)
    camera = spec.camera("oak_left")
    width, height = (int(size) for size in camera.resolution)
    # The range finder, unlike the renderer, takes the principal point as a place in the image.
    assert list(camera.principal_pixel) == [0, 0]
    camera.principal_pixel = [width / 2, height / 2]
    spec.add_sensor(
        name="depth", type=mujoco.mjtSensor.mjSENS_RANGEFINDER, objtype=mujoco.mjtObj.mjOBJ_CAMERA, objname="oak_left",
        intprm=[1 << int(mujoco.mjtRayDataField.mjRAYDATA_DEPTH), 0, 0],
    )
    compiled = spec.compile()
    data = mujoco.MjData(compiled)
    mujoco.mj_forward(compiled, data)
    theirs = data.sensor("depth").data.reshape(height, width)
    out = tmp_path / "depth"
    command = [exports.program, "render", tmp_path / "boxes.obj", "--up", "z", "--model", model, "--camera", "left"]
    command += ["--pose", "0", "0", "0", "0", "0", "0", "1"]
    subprocess.run([*command, "--annotators", "distance_to_image_plane", "-o", out], check=True, capture_output=True)
    [file] = out.rglob("distance_to_image_plane*.npy")
    ours = np.load(file)
    assert (theirs < 4).mean() > 0.05
    near = np.isclose(ours, theirs, rtol=0, atol=1e-5)
    # Only rays along an edge may differ.
    assert near.mean() > 0.9999
    assert ours.shape == theirs.shape == (800, 1280)


def test_a_calibrated_unit(exports: Exports, tmp_path: Path) -> None:
    """The pose between the cameras and the principal point match the calibration file."""
    command = [exports.program, "calibration", "export", "OAK-D Pro PoE", "--to", "depthai"]
    calibration = json.loads(subprocess.run(command, check=True, capture_output=True).stdout)
    cameras = dict(calibration["cameraData"])
    stereo = calibration["stereoRectificationData"]
    left, right = stereo["leftCameraSocket"], stereo["rightCameraSocket"]
    turn = RollPitchYaw(0.004, -0.006, 0.009).ToRotationMatrix().matrix()
    # The left camera's points in the right camera's frame, in centimetres.
    link = cameras[left]["extrinsics"]
    sign = 1 if link["toCameraSocket"] == right else None
    if sign is None:
        link = cameras[right]["extrinsics"]
    link["rotationMatrix"] = turn.tolist()
    cameras[right]["intrinsicMatrix"][0][2] += 7.0
    cameras[right]["intrinsicMatrix"][1][2] -= 5.0
    file = tmp_path / "unit.json"
    file.write_text(json.dumps(calibration))
    folder = exports(str(file), "urdf")
    robot = yourdfpy.URDF.load(str(folder / "oak.urdf"))
    names = [f"oak_{side}_camera_optical_frame" for side in ("left", "right")]
    source, target = names if sign else names[::-1]
    if link["toCameraSocket"] in (left, right):
        found = robot.get_transform(source, target)
        assert found[:3, :3] == pytest.approx(np.array(link["rotationMatrix"]), abs=1e-7)
        translation = np.array([link["translation"][axis] for axis in "xyz"]) * 1e-2
        assert found[:3, 3] == pytest.approx(translation, abs=1e-7)
    else:
        pytest.fail("the calibration links its cameras in another way")
    mjcf = mujoco.MjModel.from_xml_path(str(exports(str(file), "mjcf") / "oak.xml"))
    camera = mjcf.camera("oak_right")
    density = mjcf.cam_resolution[camera.id] / mjcf.cam_sensorsize[camera.id]
    fx, fy, px, py = mjcf.cam_intrinsic[camera.id] * np.tile(density, 2)
    (k_fx, _, cx), (_, k_fy, cy), _ = cameras[right]["intrinsicMatrix"]
    width, height = mjcf.cam_resolution[camera.id]
    assert [fx, fy] == pytest.approx([k_fx, k_fy], rel=1e-5)
    assert [px, py] == pytest.approx([width / 2 - cx - 0.5, height / 2 - cy - 0.5], abs=1e-3)


def test_mujocos_renderer_has_the_principal_point(exports: Exports) -> None:
    """A sphere on the optical axis appears at the principal point."""
    folder = exports("OAK-D Pro PoE", "mjcf")
    spec = mujoco.MjSpec.from_string(
        f'''<mujoco><visual><global offwidth="1280" offheight="800"/></visual>
        <asset><model name="oak" file="{folder}/oak.xml"/></asset>
        <worldbody><geom type="sphere" pos="2 0.0375 0" size="0.1"/><attach model="oak" body="oak" prefix=""/></worldbody></mujoco>'''
    )
    spec.camera("oak_left").principal_pixel = [30, -20]
    model = spec.compile()
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    try:
        renderer = mujoco.Renderer(model, 800, 1280)
    except Exception as error:  # The library raises what its graphics raise.
        pytest.skip(f"MuJoCo cannot render here: {error}")
    renderer.enable_depth_rendering()
    renderer.update_scene(data, "oak_left")
    depth = renderer.render()
    y, x = np.nonzero((depth > 1.85) & (depth < 2.05))
    # The export writes W/2 - cx and H/2 - cy.
    assert x.mean() + 0.5 == pytest.approx(640 - 30, abs=0.1)
    assert y.mean() + 0.5 == pytest.approx(400 + 20, abs=0.1)


def test_the_same_oak_on_the_same_arm(exports: Exports, tmp_path: Path) -> None:
    """The example in three formats, in the posture of the USD file."""
    model, arm = "OAK-D Pro PoE", tmp_path / "arm"
    shutil.copytree(Path(__file__).parents[2] / "examples/robots", arm)
    for to in ("urdf", "mjcf"):
        shutil.copytree(exports(model, to), arm / "oak", dirs_exist_ok=True)
    subprocess.run([exports.program, "asset", model, "-o", arm / "oak/"], check=True, capture_output=True)
    angles = np.radians([-20.0, 35.0, 0.0])

    described = mujoco.MjModel.from_xml_path(str(arm / "arm.xml"))
    data = mujoco.MjData(described)
    data.qpos[:] = angles
    mujoco.mj_forward(described, data)
    places = [data.cam_xpos[described.camera("oak_left").id]]

    (arm / "arm.urdf").write_text(xacro.process_file(str(arm / "arm.urdf.xacro")).toxml())
    robot = yourdfpy.URDF.load(str(arm / "arm.urdf"))
    robot.update_cfg(angles)
    places.append(robot.get_transform("oak_left_camera_optical_frame", "base")[:3, 3])

    stage = Usd.Stage.Open(str(arm / "arm.usda"))
    [camera] = [prim for prim in stage.Traverse() if prim.GetName() == "Camera_left_ov9282"]
    places.append(np.array(UsdGeom.Xformable(camera).ComputeLocalToWorldTransform(0).ExtractTranslation()))
    assert places[0] == pytest.approx(places[1], abs=1e-7)
    assert places[2] == pytest.approx(places[1], abs=1e-7)
