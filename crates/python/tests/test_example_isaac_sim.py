"""examples/python/isaac_sim.py, without Isaac Sim: every name is compared with the documentation,
the flow is run with mock objects that accept only the documented arguments, and the USD part with usd-core if installed."""

import ast
import importlib.util
import json
import subprocess
import sys
from types import ModuleType, SimpleNamespace

import numpy as np
import pytest

import oaktwin
from conftest import ROOT

SCRIPT = ROOT / "examples/python/isaac_sim.py"
TREE = ast.parse(SCRIPT.read_text(encoding="utf-8"))
FUNCTIONS = {node.name: node for node in TREE.body if isinstance(node, ast.FunctionDef)}

# Sources, in https://github.com/isaac-sim/IsaacSim.
SENSOR_5 = "5.1: isaacsim.sensors.camera, single_view_depth_sensor.py"
CAMERA_5 = "5.1: isaacsim.sensors.camera, camera.py"
EXAMPLE_5 = "5.1: standalone_examples/api/isaacsim.sensors.camera/camera_stereoscopic_depth.py"
SENSOR_6 = "6.0, 6.1: isaacsim.sensors.experimental.rtx, single_view_depth_camera_sensor.py"
CAMERA_6 = "6.0, 6.1: isaacsim.sensors.experimental.rtx, rtx_camera.py and _sensor_base.py"
SPEC_6 = "6.0, 6.1: isaacsim.sensors.experimental.rtx, _camera_common.py"
EXAMPLE_6 = "6.0: standalone_examples/api/isaacsim.sensors.experimental.rtx/camera_stereoscopic_depth.py"
USD = "OpenUSD"

IMPORTS = {
    ("isaacsim", "SimulationApp"): EXAMPLE_5,
    ("isaacsim.core.api", "World"): EXAMPLE_5,
    ("isaacsim.sensors.camera", "SingleViewDepthSensorAsset"): SENSOR_5,
    ("isaacsim.sensors.experimental.rtx", "RtxCamera"): CAMERA_6,
    ("isaacsim.sensors.experimental.rtx", "SingleViewDepthCameraSensor"): SENSOR_6,
    ("omni.replicator.core", None): SENSOR_6,
    ("omni.timeline", None): EXAMPLE_6,
    ("omni.usd", None): EXAMPLE_6,
}
# The members of Isaac Sim's objects that each function uses.
MEMBERS = {
    "isaac_5": {
        "get_context": SENSOR_5,
        "get_stage": SENSOR_5,
        "reset": EXAMPLE_5,
        "step": EXAMPLE_5,
        "initialize": SENSOR_5,
        "get_child_depth_sensor": SENSOR_5,
        "get_all_depth_sensor_paths": SENSOR_5,
        "attach_annotator": CAMERA_5,
        "get_current_frame": CAMERA_5,
        "usd": "omni.usd",
    },
    "isaac_6": {
        "get_context": EXAMPLE_6,
        "get_stage": EXAMPLE_6,
        "get_timeline_interface": EXAMPLE_6,
        "play": EXAMPLE_6,
        "update": EXAMPLE_6,
        "get_data": SENSOR_6,
        "numpy": EXAMPLE_6,
        "render_product": CAMERA_6,
        "set_enabled_post_processing": SENSOR_6,
        "AnnotatorRegistry": CAMERA_6,
        "get_annotator": CAMERA_6,
        "attach": CAMERA_6,
        "GetPrim": USD,
        "GetPrimAtPath": USD,
        "ApplyAPI": USD,
        "GetRelationship": USD,
        "GetTargets": USD,
        "GetAttributes": USD,
        "GetAttribute": USD,
        "HasAttribute": USD,
        "GetName": USD,
        "GetPath": USD,
        "Get": USD,
        "Set": USD,
        "usd": "omni.usd",
        "timeline": "omni.timeline",
    },
}
PYTHON = {"array", "items", "values", "get", "startswith"}
# All strings in these functions.
TEXTS = {
    "isaac_5": {"DepthSensorDistance": SENSOR_5, "distance_to_image_plane": EXAMPLE_5, "rgb": CAMERA_5},
    "isaac_6": {
        "depth_sensor_distance": SENSOR_6,
        "distance_to_image_plane": SENSOR_6,
        "rgb": SPEC_6,
        "OmniSensorAPI": CAMERA_6,
        "camera": SENSOR_6,
        "resolution": "5.1: isaacsim.sensors.camera, single_view_depth_sensor.py; the template's own attribute",
    },
}
KEYWORDS = {
    "World": {"stage_units_in_meters": EXAMPLE_5},
    "SingleViewDepthSensorAsset": {"prim_path": SENSOR_5, "asset_path": SENSOR_5, "position": SENSOR_5},
    "initialize": {"attach_rgb_annotator": SENSOR_5},
    "step": {"render": EXAMPLE_5},
    "RtxCamera": {"reset_xform_op_properties": CAMERA_6},
    "SingleViewDepthCameraSensor": {"resolution": SENSOR_6, "annotators": SENSOR_6},
}


@pytest.fixture
def example():
    spec = importlib.util.spec_from_file_location("isaac_sim", SCRIPT)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def imports(tree):
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            yield from ((name.name, None) for name in node.names)
        elif isinstance(node, ast.ImportFrom):
            yield from ((node.module, name.name) for name in node.names)


def test_modules_are_those_of_the_sources():
    of_isaac = {(module, name) for module, name in imports(TREE) if module.split(".")[0] in ["isaacsim", "omni", "carb"]}
    assert of_isaac == set(IMPORTS)


@pytest.mark.parametrize("function", MEMBERS)
def test_members_annotators_and_arguments_are_those_of_the_sources(function):
    node = FUNCTIONS[function]
    members = {part.attr for part in ast.walk(node) if isinstance(part, ast.Attribute)}
    assert members - PYTHON == set(MEMBERS[function])
    texts = {part.value for part in ast.walk(node) if isinstance(part, ast.Constant) and isinstance(part.value, str)}
    assert texts - {ast.get_docstring(node, clean=False)} == set(TEXTS[function])
    for call in (part for part in ast.walk(node) if isinstance(part, ast.Call) and part.keywords):
        name = call.func.attr if isinstance(call.func, ast.Attribute) else call.func.id
        assert {keyword.arg for keyword in call.keywords} == set(KEYWORDS[name]), name


def test_nothing_of_isaac_sim_is_imported_before_it_is_started():
    at_once = [node for node in TREE.body if isinstance(node, (ast.Import, ast.ImportFrom))]
    assert {module for module, _ in imports(ast.Module(at_once, []))} == {"argparse", "pathlib", "numpy", "oaktwin"}
    names = [node for node in ast.walk(FUNCTIONS["main"]) if isinstance(node, ast.Name)]
    [started] = [node.lineno for node in names if node.id == "SimulationApp"]
    others = [
        node.lineno
        for node in ast.walk(FUNCTIONS["main"])
        if isinstance(node, ast.ImportFrom) and node.module.startswith("isaacsim.")
    ]
    assert others and min(others) > started


def test_help_needs_no_isaac_sim():
    done = subprocess.run([sys.executable, SCRIPT, "--help"], capture_output=True, text=True)
    assert done.returncode == 0 and "--compare" in done.stdout


@pytest.mark.parametrize("model", oaktwin.models(maker="Luxonis", depth="stereo"))
def test_the_assets_templates_by_our_own_check(model, tmp_path):
    """The prims that the loaders require, without OpenUSD's Python package."""
    device = oaktwin.Device(model)
    wanted = {sensor["prim"] for sensor in device.depth_sensors.values()}
    for isaac in ["5.1", "6"]:
        asset = tmp_path / f"{isaac}.usd"
        device.write_usd(asset, isaac=isaac)
        done = subprocess.run([sys.executable, "-m", "oaktwin", "check", asset, "--json"], capture_output=True, text=True)
        report = json.loads(done.stdout)
        assert done.returncode == 0 and report["stage"]["default_prim"] == "Root"
        cameras = {}
        for camera in report["cameras"]:
            if camera["resolution_from"] != "catalog" and "product" in camera["resolution_from"]:
                cameras[camera["path"].rsplit("/", 1)[-1]] = camera["resolution_from"]["product"]
        assert set(cameras) == wanted
        for name, product in cameras.items():
            assert product.endswith(f"/TemplateRenderProducts/{name}_render_product")


@pytest.mark.parametrize("model", oaktwin.models(maker="Luxonis", depth="stereo"))
def test_the_usd_half(example, model, tmp_path):
    pytest.importorskip("pxr", reason="usd-core is not installed")
    from pxr import Usd, UsdGeom

    device = oaktwin.Device(model)
    for isaac in ["5.1", "6"]:
        asset = tmp_path / f"{isaac}.usd"
        device.write_usd(asset, isaac=isaac)
        stage = Usd.Stage.CreateInMemory()
        example.build_scene(stage)
        example.reference_asset(stage, asset)
        assert UsdGeom.GetStageUpAxis(stage) == "Z" and UsdGeom.GetStageMetersPerUnit(stage) == 1
        cameras = {}
        for template in example.templates(stage):
            [path] = template.GetRelationship("camera").GetTargets()
            camera = stage.GetPrimAtPath(path)
            assert camera.GetTypeName() == "Camera"
            width, height = template.GetAttribute("resolution").Get()
            cameras[camera.GetName()] = width, height
            # The camera is at the OAK's position and faces along the stage's x axis; z is up in its image.
            world_from_camera = UsdGeom.Xformable(camera).ComputeLocalToWorldTransform(0)
            assert np.allclose(world_from_camera.TransformDir((0, 0, -1)), [1, 0, 0], atol=1e-6)
            assert np.allclose(world_from_camera.TransformDir((0, 1, 0)), [0, 0, 1], atol=1e-6)
            assert np.linalg.norm(world_from_camera.ExtractTranslation() - np.array(example.PLACE)) < 0.06
            copied = [name.GetName() for name in template.GetAttributes() if name.GetName().startswith(example.PREFIX)]
            assert len(copied) == 11 and f"{example.PREFIX}baselineMM" in copied
        assert set(cameras) == {sensor["prim"] for sensor in device.depth_sensors.values()}
        assert cameras.get("Camera_pseudo_depth_tof", (640, 480)) == (640, 480)
        box = UsdGeom.Imageable(stage.GetPrimAtPath("/World/red")).ComputeWorldBound(0, "default").ComputeAlignedRange()
        assert np.allclose(box.GetMin(), [-0.5, -0.75, 0]) and np.allclose(box.GetMax(), [0, -0.25, 0.8])
        # The OAK measures the fronts of the boxes at 2, 2.5 and 3.5 m.
        stage.Flatten().Export(str(tmp_path / "scene.usda"))
        camera, world_from_body = device.depth_camera(), np.eye(4)
        world_from_body[:3, 3] = example.PLACE
        scene = oaktwin.Scene.open(tmp_path / "scene.usda")
        exact = scene.render(camera, world_from_body @ camera.body_from_camera)["distance_to_image_plane"]
        for distance in [2.0, 2.5, 3.5]:
            assert np.mean(np.abs(exact - distance) < 1e-5) > 0.01


# Mock objects with only the documented arguments, and frames of a wall from oaktwin's model.


class Wall:
    def __init__(self, device):
        self.exact = np.full((800, 1280), 3.0, np.float32)
        self.exact[200:500, 500:700] = 1.5
        self.measured = oaktwin.DepthSensor(device, engine="single-view", seed=9)(self.exact)


class App:
    def __init__(self, options):
        assert set(options) == {"headless"}
        self.is_open = True
        App.last = self

    def update(self):
        pass

    def close(self):
        self.is_open = False


def install(monkeypatch, modules):
    for name, members in modules.items():
        module = ModuleType(name)
        module.__path__ = []
        vars(module).update(members)
        monkeypatch.setitem(sys.modules, name, module)
    for name in modules:
        if "." in name:
            parent, child = name.rsplit(".", 1)
            if parent in sys.modules:
                setattr(sys.modules[parent], child, sys.modules[name])


def context(stage):
    return {"get_context": lambda: SimpleNamespace(get_stage=lambda: stage)}


def run(example, monkeypatch, capsys, folder):
    monkeypatch.setattr(sys, "argv", ["isaac_sim.py", "-o", str(folder), "--frames", "2", "--compare", "--/app/kit=1"])
    example.main()
    assert not App.last.is_open
    return capsys.readouterr().out


def is_written(folder, wall):
    camera = folder / "Camera_pseudo_depth"
    assert sorted(file.name for file in camera.iterdir()) == sorted(
        f"{name}_{frame:04}.{kind}"
        for name, kind in [("distance_to_image_plane", "npy"), ("depth_sensor_distance", "npy"), ("rgb", "png")]
        for frame in [0, 1]
    )
    assert np.array_equal(np.load(camera / "distance_to_image_plane_0001.npy"), wall.exact)
    assert np.array_equal(np.load(camera / "depth_sensor_distance_0000.npy"), wall.measured)


def test_the_flow_of_5_with_doubles(example, monkeypatch, capsys, tmp_path, device):
    pytest.importorskip("PIL", reason="Pillow is not installed")
    wall, done = Wall(device), []

    class World:
        def __init__(self, stage_units_in_meters):
            done.append(("world", stage_units_in_meters))

        def reset(self):
            done.append("reset")

        def step(self, render):
            assert render

    class Sensor:
        annotators = []

        def attach_annotator(self, annotator_name):
            self.annotators.append(annotator_name)

        def get_current_frame(self, clone=False):
            frame = {"DepthSensorDistance": wall.measured, "distance_to_image_plane": wall.exact}
            assert set(self.annotators) == set(frame)
            return {**frame, "rgb": np.full((800, 1280, 3), 128, np.uint8)}

    class Asset:
        def __init__(self, prim_path, asset_path, position=None, translation=None, orientation=None):
            assert asset_path.endswith("oak4-d.usd") and oaktwin.Scene.open(asset_path).up == "z"
            self.path = f"{prim_path}/oak4_d/Camera_pseudo_depth"

        def initialize(self, physics_sim_view=None, attach_rgb_annotator=False):
            assert "reset" in done and attach_rgb_annotator

        def get_all_depth_sensor_paths(self):
            return [self.path]

        def get_child_depth_sensor(self, camera_prim_path):
            return {self.path: Sensor()}[camera_prim_path]

    install(
        monkeypatch,
        {
            "isaacsim": {"SimulationApp": App},
            "isaacsim.core": {},
            "isaacsim.core.api": {"World": World},
            "isaacsim.sensors": {},
            "isaacsim.sensors.camera": {"SingleViewDepthSensorAsset": Asset},
            "omni": {},
            "omni.usd": context(None),
        },
    )
    monkeypatch.setattr(example, "build_scene", lambda stage: done.append("scene"))
    printed = run(example, monkeypatch, capsys, tmp_path)
    assert done == [("world", 1.0), "scene", "reset"]
    is_written(tmp_path, wall)
    assert printed.count("1280x800") == 2 and printed.count("by ours") == 2


def test_the_flow_of_6_with_doubles(example, monkeypatch, capsys, tmp_path, device):
    pytest.importorskip("PIL", reason="Pillow is not installed")
    wall, values, schemas, done = Wall(device), {"omni:rtx:post:depthSensor:enabled": False}, [], []

    class Attribute:
        def __init__(self, store, name):
            self.store, self.name = store, name

        def GetName(self):
            return self.name

        def Get(self):
            return self.store[self.name]

        def Set(self, value):
            self.store[self.name] = value

    class Prim:
        def __init__(self, store):
            self.store = store

        def GetPrim(self):
            return self

        def GetPath(self):
            return "/Render/product"

        def HasAttribute(self, name):
            return name in ["omni:rtx:post:depthSensor:baselineMM", "omni:rtx:post:depthSensor:enabled"]

        def GetAttribute(self, name):
            return Attribute(self.store, name)

        def GetAttributes(self):
            return [Attribute(self.store, name) for name in self.store]

        def GetRelationship(self, name):
            assert name == "camera"
            return SimpleNamespace(GetTargets=lambda: ["/World/oak/oak4_d/Camera_pseudo_depth"])

    template = Prim({"resolution": (1280, 800), "omni:rtx:post:depthSensor:baselineMM": 75.0, "other": 1})
    stage = SimpleNamespace(GetPrimAtPath=lambda path: SimpleNamespace(ApplyAPI=lambda name: schemas.append((path, name))))

    class RtxCamera:
        def __init__(self, path, *, tick_rate=None, schemas=None, attributes=None, reset_xform_op_properties=True):
            self.path = path

    class Sensor:
        def __init__(self, path, *, resolution, annotators):
            assert isinstance(path, RtxCamera) and (path.path, "OmniSensorAPI") in schemas and resolution == (800, 1280)
            self.annotators, self.calls = annotators, 0

        @property
        def render_product(self):
            return Prim(values)

        def set_enabled_post_processing(self, enabled):
            values["omni:rtx:post:depthSensor:enabled"] = enabled

        def get_data(self, annotator, *, out=None):
            assert annotator in self.annotators
            image = {"depth_sensor_distance": wall.measured, "distance_to_image_plane": wall.exact}[annotator]
            return SimpleNamespace(numpy=lambda: image[..., None]), {}

    class Annotator:
        def attach(self, render_products):
            done.append(render_products)

        def get_data(self):
            return np.full((800, 1280, 4), 128, np.uint8)

    install(
        monkeypatch,
        {
            "isaacsim": {"SimulationApp": App},
            "isaacsim.sensors": {},
            "isaacsim.sensors.experimental": {},
            "isaacsim.sensors.experimental.rtx": {"RtxCamera": RtxCamera, "SingleViewDepthCameraSensor": Sensor},
            "omni": {},
            "omni.usd": context(stage),
            "omni.timeline": {"get_timeline_interface": lambda: SimpleNamespace(play=lambda: done.append("play"))},
            "omni.replicator": {},
            "omni.replicator.core": {
                "AnnotatorRegistry": SimpleNamespace(get_annotator=lambda name: {"rgb": Annotator()}[name])
            },
        },
    )
    monkeypatch.setattr(example, "build_scene", lambda stage: done.append("scene"))
    monkeypatch.setattr(example, "reference_asset", lambda stage, asset: done.append("asset"))
    monkeypatch.setattr(example, "templates", lambda stage: [template])
    printed = run(example, monkeypatch, capsys, tmp_path)
    assert done == ["scene", "asset", ["/Render/product"], "play"]
    assert values == {"omni:rtx:post:depthSensor:enabled": True, "omni:rtx:post:depthSensor:baselineMM": 75.0}
    is_written(tmp_path, wall)
    assert printed.count("1280x800") == 2 and printed.count("by ours") == 2


def test_our_model_beside_isaac_sims(example, device):
    """The same model with another noise seed agrees almost everywhere."""
    wall = Wall(device)
    same = example.compare(device, "Camera_pseudo_depth", "5.1", wall.exact, wall.measured, None)
    share = float(same.split("of these ")[1].split(" %")[0])
    assert same.startswith("Camera_pseudo_depth: measured by Isaac Sim ") and share > 95
    none = example.compare(device, "Camera_pseudo_depth", "6", wall.exact, np.zeros_like(wall.exact), None)
    assert "by both 0.0 %; of these 0.0 %" in none
