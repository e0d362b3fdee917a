"""Animated stages, compared with OpenUSD at every time code: the cameras of `render --frames`, and the prims that carry a device."""

import json
import subprocess
from pathlib import Path

import numpy as np
import pytest
from pxr import Gf, Sdf, Usd, UsdGeom

FRAMES = [0.0, 1.5, 3.0, 4.5, 6.0, 7.5, 9.0]


def animated(attribute, values):
    for time, value in values:
        attribute.Set(value, time)


def stage_of(path, seed):
    """A robot of random joints with every kind of transform: pivots, quaternions, resets, references and instances."""
    rng = np.random.default_rng(seed)
    part = Usd.Stage.CreateNew(str(path / "part.usda"))
    root = UsdGeom.Xform.Define(part, "/Part")
    part.SetDefaultPrim(root.GetPrim())
    inner = UsdGeom.Xform.Define(part, "/Part/Inner")
    animated(inner.AddRotateYOp(), [(0, 5.0), (9, 50.0)])
    UsdGeom.Camera.Define(part, "/Part/Inner/Eye").AddTranslateOp().Set(Gf.Vec3d(0, 0.1, 0.2))
    part.Save()
    stage = Usd.Stage.CreateNew(str(path / "stage.usda"))
    UsdGeom.SetStageMetersPerUnit(stage, 0.01)
    UsdGeom.SetStageUpAxis(stage, UsdGeom.Tokens.z)
    stage.SetStartTimeCode(0)
    stage.SetEndTimeCode(9)
    vector = lambda low, high: Gf.Vec3d(*rng.uniform(low, high, 3))  # noqa: E731
    prim = ""
    for number in range(6):
        prim += f"/Link{number}"
        link = UsdGeom.Xform.Define(stage, prim)
        animated(link.AddTranslateOp(), [(0, vector(-50, 50)), (4, vector(-50, 50)), (9, vector(-50, 50))])
        if number % 3 == 0:
            pivot = vector(-5, 5)
            link.AddTranslateOp(opSuffix="pivot").Set(pivot)
            animated(link.AddRotateXYZOp(), [(0, Gf.Vec3f(*rng.uniform(-90, 90, 3))), (9, Gf.Vec3f(*rng.uniform(-90, 90, 3)))])
            link.AddTranslateOp(opSuffix="pivot", isInverseOp=True)
        elif number % 3 == 1:
            turns = [Gf.Rotation(Gf.Vec3d(*rng.normal(size=3)), float(rng.uniform(0, 170))).GetQuat() for _ in range(2)]
            animated(link.AddOrientOp(UsdGeom.XformOp.PrecisionDouble), list(zip((0, 9), turns)))
        else:
            animated(link.AddRotateZOp(), [(2, -40.0), (7, 80.0)])
    camera = UsdGeom.Camera.Define(stage, prim + "/Eye")
    camera.AddRotateXOp().Set(20.0)
    reset = UsdGeom.Camera.Define(stage, "/Link0/Reset")
    animated(reset.AddTranslateOp(), [(0, vector(-50, 50)), (9, vector(-50, 50))])
    reset.SetResetXformStack(True)
    for number in range(2):
        copy = stage.DefinePrim(f"/Link0/Link1/Copy{number}", "Xform")
        copy.GetReferences().AddReference("./part.usda")
        copy.SetInstanceable(True)
        UsdGeom.Xformable(copy).AddTranslateOp().Set(vector(-20, 20))
    UsdGeom.Cube.Define(stage, "/Link0/Link1/Box").CreateSizeAttr(10)
    stage.Save()
    return stage, prim


def render(program, *arguments):
    done = subprocess.run([str(program), "render", *map(str, arguments)], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done


def world_from_camera(params, metres):
    """The pose in metres with OpenUSD's axes, for row vectors: Replicator's view transform is its inverse."""
    view = np.array(params["cameraViewTransform"]).reshape(4, 4)
    pose = np.linalg.inv(view)
    pose[3, :3] *= metres
    return pose


def expected(stage, path, time, metres):
    matrix = UsdGeom.Xformable(stage.GetPrimAtPath(path)).ComputeLocalToWorldTransform(time)
    pose = np.array(matrix.RemoveScaleShear())
    pose[3, :3] *= metres
    return pose


@pytest.mark.parametrize("hides", [False, True], ids=["moves", "deforms"])
@pytest.mark.parametrize("seed", [1, 2, 3])
def test_cameras_are_where_openusd_puts_them(program, tmp_path, seed, hides):
    stage, _ = stage_of(tmp_path, seed)
    if hides:
        box = UsdGeom.Imageable(stage.GetPrimAtPath("/Link0/Link1/Box"))
        animated(box.GetVisibilityAttr(), [(0, "inherited"), (5, "invisible")])
        stage.Save()
    prims = Usd.PrimRange(stage.GetPseudoRoot(), Usd.TraverseInstanceProxies())
    cameras = [str(prim.GetPath()) for prim in prims if prim.IsA(UsdGeom.Camera)]
    assert len(cameras) == 4
    out = tmp_path / "out"
    chosen = [word for camera in cameras for word in ("--camera", camera)]
    outputs = ("--annotators", "camera_params", "--resolution", "16x10", "-o", out, "--json")
    done = render(program, tmp_path / "stage.usda", "--frames", "0:9:1.5", *outputs, *chosen)
    report = json.loads(done.stdout)
    assert report["frames"] == len(FRAMES)
    folders = {one["path"]: one["folder"] for one in report["cameras"]}
    for camera in cameras:
        for number, time in enumerate(FRAMES):
            (file,) = Path(folders[camera]).rglob(f"camera_params_{number:04}.json")
            found = world_from_camera(json.loads(file.read_text()), 0.01)
            assert np.allclose(found, expected(stage, camera, time, 0.01), atol=1e-9), (camera, time)


@pytest.mark.parametrize("seed", [4, 5])
def test_devices_follow_their_prim(program, tmp_path, seed):
    stage, hand = stage_of(tmp_path, seed)
    out = tmp_path / "out"
    arguments = ("--model", "OAK4-D", "--camera", "left", "--annotators", "camera_params", "--resolution", "16x10")
    mount = ("--mount", hand, "--pose", 0.1, -0.2, 0.3, 0, 0, 0, 1)
    render(program, tmp_path / "stage.usda", "--frames", "0:9:1.5", *arguments, *mount, "-o", out)
    render(program, tmp_path / "stage.usda", "--time", "0", *arguments, "--pose", 0, 0, 0, 0, 0, 0, 1, "-o", tmp_path / "still")
    # Where the camera is on the body, whose frame is that of the prim.
    body_from_camera = world_from_camera(json.loads((tmp_path / "still/camera_params_0000.json").read_text()), 0.01)
    offset = np.eye(4)
    offset[3, :3] = (0.1, -0.2, 0.3)
    for number, time in enumerate(FRAMES):
        found = world_from_camera(json.loads((out / f"camera_params_{number:04}.json").read_text()), 0.01)
        # Row vectors: from the camera to the body, to the prim, to the world.
        assert np.allclose(found, body_from_camera @ offset @ expected(stage, hand, time, 0.01), atol=1e-9), time


def test_single_samples_do_not_move(program, tmp_path):
    stage, _ = stage_of(tmp_path, 6)
    box = stage.GetPrimAtPath("/Link0/Link1/Box")
    box.CreateAttribute("size", Sdf.ValueTypeNames.Double).Set(12.0, 3)
    stage.Save()
    outputs = ("--resolution", "16x10", "-o", tmp_path / "out")
    done = render(program, tmp_path / "stage.usda", "--frames", "0:20:10", "--camera", "/Link0/Reset", *outputs)
    assert "is animated from 0 to 9; 2 of 3 time codes are outside" in done.stderr
