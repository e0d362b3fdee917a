"""Mirrors and glass, compared with Mitsuba: the colours of regions, and the lengths of mirrored and refracted paths as time of flight measures
them. Slow: its environment is large."""

import base64
import json
import subprocess
from pathlib import Path

import mitsuba as mi
import numpy as np
import pytest

pytestmark = pytest.mark.slow

mi.set_variant("scalar_rgb")

URI = "data:application/octet-stream;base64,"
SIZE = (240, 160)
VFOV = 60.0
# Emitted light of the panels, and how they are placed: the centre, and the half-width and half-height along two axes. glTF's y is up.
PANELS = {
    "ahead_left": ((0.8, 0.3, 0.1), (-2.0, 0.0, -4.0), (2.0, 0.0, 0.0), (0.0, 4.0, 0.0)),
    "ahead_right": ((0.1, 0.5, 0.7), (2.0, 0.0, -4.0), (2.0, 0.0, 0.0), (0.0, 4.0, 0.0)),
    "behind": ((0.6, 0.6, 0.2), (0.0, 0.0, 3.0), (6.0, 0.0, 0.0), (0.0, 6.0, 0.0)),
    "side": ((0.3, 0.7, 0.3), (-4.0, 0.0, -0.5), (0.0, 0.0, 3.4), (0.0, 6.0, 0.0)),
}
# In front of them: a mirror turned to the side on the left, a pane in the middle, and a block of glass, whose faces are tilted, on the right.
MIRROR = ((-0.85, 0.0, -2.0), (0.35, 0.0, 0.12), (0.0, 0.5, 0.0))
PANE = ((-0.05, 0.0, -2.0), (0.25, 0.0, 0.0), (0.0, 0.5, 0.0))
BLOCK = (((0.8, 0.0, -2.2), (0.35, 0.0, 0.1), (0.0, 0.5, 0.0)), (-0.06, 0.0, 0.22))
REFLECTANCE, INDEX = 0.9, 1.5
# Regions of the image, by column and row.
REGIONS = {
    "mirror": ((48, 70), (60, 100)),
    "pane": ((106, 126), (60, 100)),
    "block": ((160, 172), (65, 95)),
    "left": ((85, 95), (60, 100)),
    "above": ((140, 200), (4, 20)),
}


def rectangle(centre, across, up) -> tuple[np.ndarray, np.ndarray]:
    c, u, v = (np.array(one, np.float32) for one in (centre, across, up))
    return np.stack([c - u - v, c + u - v, c + u + v, c - u + v]), np.array([[0, 1, 2], [0, 2, 3]], np.uint32)


def block() -> tuple[np.ndarray, np.ndarray]:
    """A closed box: the front face, and the same behind."""
    front, depth = rectangle(*BLOCK[0])[0], -np.array(BLOCK[1], np.float32)
    corners = np.concatenate([front, front + depth])
    quads = [[0, 1, 2, 3], [5, 4, 7, 6], [4, 0, 3, 7], [1, 5, 6, 2], [3, 2, 6, 7], [4, 5, 1, 0]]
    triangles = [part for a, b, c, d in quads for part in ([a, b, c], [a, c, d])]
    return corners, np.array(triangles, np.uint32)


def shapes() -> dict[str, tuple[np.ndarray, np.ndarray]]:
    found = {name: rectangle(*place) for name, (_, *place) in PANELS.items()}
    return {**found, "mirror": rectangle(*MIRROR), "pane": rectangle(*PANE), "block": block()}


def gltf(folder: Path) -> Path:
    """The scene for the program: black panels that emit light, a metal and two kinds of glass."""
    black = {"pbrMetallicRoughness": {"baseColorFactor": [0, 0, 0, 1], "metallicFactor": 0, "roughnessFactor": 1}}
    clear = {"pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, 1], "metallicFactor": 0, "roughnessFactor": 0}}
    transmission = {"KHR_materials_transmission": {"transmissionFactor": 1}, "KHR_materials_ior": {"ior": INDEX}}
    metal = {"baseColorFactor": [REFLECTANCE] * 3 + [1], "metallicFactor": 1, "roughnessFactor": 0}
    materials = {name: {**black, "emissiveFactor": list(light)} for name, (light, *_) in PANELS.items()}
    materials["mirror"] = {"pbrMetallicRoughness": metal}
    materials["pane"] = {**clear, "extensions": transmission}
    volume = {"KHR_materials_volume": {"thicknessFactor": 0.2}}
    materials["block"] = {**clear, "extensions": {**transmission, **volume}}
    data, views, accessors, meshes = b"", [], [], []
    for index, (name, (corners, triangles)) in enumerate(shapes().items()):
        for array, kind, component in ((corners, "VEC3", 5126), (triangles.ravel(), "SCALAR", 5125)):
            views.append({"buffer": 0, "byteOffset": len(data), "byteLength": array.nbytes})
            accessor = {"bufferView": len(views) - 1, "componentType": component, "count": len(array), "type": kind}
            if kind == "VEC3":
                accessor |= {"min": array.min(0).tolist(), "max": array.max(0).tolist()}
            accessors.append(accessor)
            data += array.tobytes()
        last = len(accessors) - 1
        meshes.append({"primitives": [{"attributes": {"POSITION": last - 1}, "indices": last, "material": index}]})
        materials[name]["name"] = name
    nodes = [{"mesh": index, "name": name} for index, name in enumerate(shapes())]
    camera = {"type": "perspective", "perspective": {"yfov": np.radians(VFOV), "znear": 0.01, "aspectRatio": 1.5}}
    lamp = {"translation": [0, -90, 0], "extensions": {"KHR_lights_punctual": {"light": 0}}}
    document = {
        "asset": {"version": "2.0"},
        "extensionsUsed": [
            "KHR_lights_punctual",
            "KHR_materials_ior",
            "KHR_materials_transmission",
            "KHR_materials_volume",
        ],
        # Far away, so that the program does not add a sky of its own.
        "extensions": {"KHR_lights_punctual": {"lights": [{"type": "point", "intensity": 1.0}]}},
        "buffers": [{"byteLength": len(data), "uri": URI + base64.b64encode(data).decode()}],
        "bufferViews": views,
        "accessors": accessors,
        "materials": list(materials.values()),
        "meshes": meshes,
        "cameras": [camera],
        "nodes": [*nodes, {"camera": 0, "name": "Camera"}, lamp],
        "scenes": [{"nodes": list(range(len(nodes) + 2))}],
    }
    path = folder / "scene.gltf"
    path.write_text(json.dumps(document))
    return path


def peer() -> mi.Scene:
    """The same scene for Mitsuba."""
    scene = {"type": "scene", "integrator": {"type": "path", "max_depth": 16}}
    optics = {
        "mirror": {"type": "twosided", "bsdf": {"type": "conductor", "material": "none", "specular_reflectance": REFLECTANCE}},
        "pane": {"type": "thindielectric", "int_ior": INDEX, "ext_ior": 1.0},
        "block": {"type": "dielectric", "int_ior": INDEX, "ext_ior": 1.0},
    }
    black = {"type": "twosided", "bsdf": {"type": "diffuse", "reflectance": 0.0}}
    for name, (corners, triangles) in shapes().items():
        properties = mi.Properties()
        properties["bsdf"] = mi.load_dict(optics.get(name, black))
        if name in PANELS:
            light = {"type": "rgb", "value": list(PANELS[name][0])}
            properties["emitter"] = mi.load_dict({"type": "area", "radiance": light})
            # Emitters have one side, which shall be the visible one.
            centre = corners.mean(0)
            normal = np.cross(corners[1] - corners[0], corners[2] - corners[0])
            if np.dot(normal, -centre) < 0:
                triangles = triangles[:, ::-1]
        mesh = mi.Mesh(name, len(corners), len(triangles), props=properties)
        parameters = mi.traverse(mesh)
        parameters["vertex_positions"] = corners.ravel()
        parameters["faces"] = np.ascontiguousarray(triangles).ravel()
        parameters.update()
        scene[name] = mesh
    scene["sensor"] = {
        "type": "perspective",
        "fov_axis": "y",
        "fov": VFOV,
        "to_world": mi.ScalarTransform4f().look_at([0, 0, 0], [0, 0, -1], [0, 1, 0]),
        "film": {"type": "hdrfilm", "width": SIZE[0], "height": SIZE[1], "rfilter": {"type": "box"}},
        "sampler": {"type": "independent", "sample_count": 64},
    }
    return mi.load_dict(scene)


def test_regions_have_the_same_colours(program: Path, tmp_path: Path) -> None:
    exact = ["autoExposure=false", "noise=false", "lensBlur=0", "exposure=0.8", "maxExposureTime=1"]
    command = [program, "render", gltf(tmp_path), "-o", tmp_path / "out", "--annotators", "rgb"]
    command += ["--resolution", f"{SIZE[0]}x{SIZE[1]}"]
    command += [word for one in exact for word in ("--rgb-imager", one)]
    subprocess.run(command, check=True, capture_output=True)
    coded = np.array(mi.Bitmap(str(tmp_path / "out/rgb_0000.png")))[..., :3] / 255.0
    ours = np.where(coded <= 0.04045, coded / 12.92, ((coded + 0.055) / 1.055) ** 2.4)
    theirs = np.array(mi.render(peer(), seed=1))[..., :3]
    for name, ((left, right), (top, bottom)) in REGIONS.items():
        own, other = (image[top:bottom, left:right].reshape(-1, 3).mean(0) for image in (ours, theirs))
        # Dull black surfaces reflect 0.04 of their surroundings here, which is at most 0.01.
        assert np.all(np.abs(own - other) < 0.05 * other + 0.011), (name, own, other)
        assert np.abs(own - other).sum() < 0.05 * other.sum() + 0.02, (name, own, other)


def unit(direction: np.ndarray) -> list[float]:
    return (direction / np.linalg.norm(direction)).tolist()


def path_length(scene: mi.Scene, ray: mi.Ray3f) -> float | None:
    """The length of the path of a ray to the first panel, counted as in a vacuum; glass is passed. None if there is no panel."""
    length, index = 0.0, 1.0
    for _ in range(8):
        seen = scene.ray_intersect(ray)
        if not seen.is_valid():
            return None
        length += seen.t * index
        if seen.shape.is_emitter():
            return length
        # The first number chooses between reflection and transmission.
        sample, _ = seen.bsdf().sample(mi.BSDFContext(), seen, 0.9999, [0.5, 0.5])
        if seen.shape.id() == "block":
            index = INDEX if sample.eta > 1.0 else 1.0
        ray = seen.spawn_ray(seen.to_world(sample.wo))
    return None


def test_time_of_flight_measures_the_same_paths(program: Path, tmp_path: Path) -> None:
    exact = ["wiggling=0", "wigglingResidual=0", "ambient=0", "readNoise=0", "signal=1e6", "fullWell=1e9"]
    exact += ["pixelMixing=0", "minAmplitude=0", "confidenceThreshold=0", "fixedPattern=0"]
    exact += ["enableOpticalCorrection=false", "phaseUnwrappingLevel=4"]
    command = [program, "render", gltf(tmp_path), "-o", tmp_path / "out", "--model", "OAK-D-ToF"]
    command += ["--camera", "Camera_pseudo_depth_tof", "--look-at", "0", "0", "0.3", "0", "0", "-1"]
    command += ["--annotators", "depth_sensor_distance,camera_params", "--engine", "time-of-flight"]
    command += [word for one in exact for word in ("--param", one)]
    command += [word for name in PANELS for word in ("--infrared", f"{name}=1")]
    subprocess.run(command, check=True, capture_output=True)
    measured = np.load(tmp_path / "out/depth_sensor_distance_0000.npy")
    params = json.loads((tmp_path / "out/camera_params_0000.json").read_text())
    assert params["transparent"] == "surface"
    width, height = params["renderProductResolution"]
    focal = params["cameraFocalLength"] / params["cameraAperture"][0] * width
    world_from_camera = np.linalg.inv(np.array(params["cameraViewTransform"]).reshape(4, 4))
    origin = world_from_camera[3, :3]
    scene = peer()
    errors: dict[str, list[float]] = {"mirror": [], "pane": [], "block": [], "ahead_left": []}
    for y in range(2, height - 2, 5):
        for x in range(2, width - 2, 5):
            in_camera = np.array([(x + 0.5 - width / 2) / focal, (height / 2 - y - 0.5) / focal, -1.0])
            ray = mi.Ray3f(origin.tolist(), unit(in_camera @ world_from_camera[:3, :3]))
            seen = scene.ray_intersect(ray)
            name = seen.shape.id() if seen.is_valid() else ""
            length = path_length(scene, ray) if name in errors else None
            if length is not None:
                errors[name].append(abs(float(measured[y, x]) - length))
    for name, found in errors.items():
        # A pane reflects 1 % of what is behind the camera, whose phasor moves the sum by up to 3 mm.
        assert len(found) > 20 and np.quantile(found, 0.9) < 0.006, (name, len(found), np.quantile(found, [0.5, 0.9]))
