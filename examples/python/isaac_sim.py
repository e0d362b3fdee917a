"""An OAK in Isaac Sim 5.1 or 6: its asset, the annotators of its depth sensor, and frames on disk.

Run it with Isaac Sim's own Python after installing this package once (an RTX GPU is required):

    ./python.sh -m pip install ./crates/python      # or the wheel
    ./python.sh examples/python/isaac_sim.py --model OAK4-D --frames 3 -o oak/ --compare

Writes the model's asset for the running version, places it in front of three boxes, creates depth sensors from the asset's
template render products like Isaac Sim's own asset loaders, and writes the files of a Replicator data set for each frame and
depth sensor: distance_to_image_plane_0000.npy (ground truth), depth_sensor_distance_0000.npy (Isaac Sim's depth sensor),
rgb_0000.png. `--compare` runs oaktwin's model of that sensor on the same ground truth and prints how well both agree; their
noise is independent.

NOT RUN by its authors in any version of Isaac Sim. Modules, classes, arguments and annotators are checked by name
against the sources of 5.1 and 6.0 to 6.1; the parts that require only USD (scene, reference, templates) are run with usd-core.
"""

import argparse
from pathlib import Path

import numpy as np

import oaktwin

OAK = "/World/oak"  # the asset's path in the stage: its body faces along x, z is up
PLACE = (-2.5, 0.0, 0.8)
PREFIX = "omni:rtx:post:depthSensor:"
WARM_UP = 20  # frames; the depth sensor may return empty images at first


# This part requires only USD.


def build_scene(stage) -> None:
    """A floor, three boxes at 2, 2.5 and 3.5 m from the OAK, and light."""
    from pxr import Gf, UsdGeom, UsdLux

    UsdGeom.SetStageUpAxis(stage, UsdGeom.Tokens.z)
    UsdGeom.SetStageMetersPerUnit(stage, 1.0)
    for name, centre, size, colour in [
        ("floor", (0, 0, -0.05), (12, 12, 0.1), (0.5, 0.5, 0.5)),
        ("red", (-0.25, -0.5, 0.4), (0.5, 0.5, 0.8), (0.8, 0.2, 0.2)),
        ("green", (0.25, 0.5, 0.5), (0.5, 0.5, 1.0), (0.2, 0.7, 0.2)),
        ("blue", (1.25, 0.0, 0.75), (0.5, 1.5, 1.5), (0.2, 0.3, 0.8)),
    ]:
        box = UsdGeom.Cube.Define(stage, f"/World/{name}")
        box.CreateSizeAttr(1.0)
        box.AddTranslateOp().Set(Gf.Vec3d(*centre))
        box.AddScaleOp().Set(Gf.Vec3f(*size))
        box.CreateDisplayColorAttr([Gf.Vec3f(*colour)])
    UsdLux.DomeLight.Define(stage, "/World/sky").CreateIntensityAttr(300.0)
    UsdLux.DistantLight.Define(stage, "/World/sun").CreateIntensityAttr(700.0)


def reference_asset(stage, asset: Path) -> None:
    """References the asset in the stage."""
    from pxr import Gf, UsdGeom

    prim = UsdGeom.Xform.Define(stage, OAK)
    prim.GetPrim().GetReferences().AddReference(str(asset))
    prim.AddTranslateOp().Set(Gf.Vec3d(*PLACE))


def templates(stage) -> list:
    """Finds the asset's template render products like Isaac Sim: prims of that type and schema with one camera."""
    from pxr import Usd

    found = []
    for prim in Usd.PrimRange(stage.GetPrimAtPath(OAK)):
        schemas = prim.GetMetadata("apiSchemas")
        has_schema = schemas is not None and "OmniSensorDepthSensorSingleViewAPI" in schemas.GetAddedOrExplicitItems()
        if prim.GetTypeName() == "RenderProduct" and has_schema:
            if len(prim.GetRelationship("camera").GetTargets()) == 1:
                found.append(prim)
    return found


# This part requires Isaac Sim. Each function creates the depth sensors and returns functions that render and read a frame:
# {path of the camera: (ground-truth depth, measured depth, colour image)}.


def isaac_5(app, asset: Path):
    """5.1: the loader finds the templates in the asset, creates a sensor for each and copies its parameters."""
    import omni.usd
    from isaacsim.core.api import World
    from isaacsim.sensors.camera import SingleViewDepthSensorAsset

    world = World(stage_units_in_meters=1.0)
    build_scene(omni.usd.get_context().get_stage())
    oak = SingleViewDepthSensorAsset(prim_path=OAK, asset_path=str(asset), position=np.array(PLACE))
    world.reset()
    oak.initialize(attach_rgb_annotator=True)
    sensors = {path: oak.get_child_depth_sensor(path) for path in oak.get_all_depth_sensor_paths()}
    for sensor in sensors.values():
        sensor.attach_annotator("DepthSensorDistance")
        sensor.attach_annotator("distance_to_image_plane")

    def read():
        frames = {path: sensor.get_current_frame() for path, sensor in sensors.items()}
        names = "distance_to_image_plane", "DepthSensorDistance", "rgb"
        return {path: tuple(frame.get(name) for name in names) for path, frame in frames.items()}

    return lambda: world.step(render=True), read


def isaac_6(app, asset: Path):
    """6: creates a sensor for each template's camera, and copies the template's parameters, which some versions do not."""
    import omni.replicator.core as rep
    import omni.timeline
    import omni.usd
    from isaacsim.sensors.experimental.rtx import RtxCamera, SingleViewDepthCameraSensor

    stage = omni.usd.get_context().get_stage()
    build_scene(stage)
    # RtxCamera.create(usd_path=...) would only wrap the asset's first camera.
    reference_asset(stage, asset)
    sensors, pictures = {}, {}
    for template in templates(stage):
        path = str(template.GetRelationship("camera").GetTargets()[0])
        # Required by 6.0; 6.1 applies it itself.
        stage.GetPrimAtPath(path).ApplyAPI("OmniSensorAPI")
        width, height = template.GetAttribute("resolution").Get()
        sensor = SingleViewDepthCameraSensor(
            RtxCamera(path, reset_xform_op_properties=False),
            resolution=(height, width),
            annotators=["depth_sensor_distance", "distance_to_image_plane"],
        )
        product = sensor.render_product.GetPrim()
        for attribute in template.GetAttributes():
            if attribute.GetName().startswith(PREFIX) and product.HasAttribute(attribute.GetName()):
                product.GetAttribute(attribute.GetName()).Set(attribute.Get())
        sensor.set_enabled_post_processing(True)
        # The depth sensor has no annotator for the colour image.
        pictures[path] = rep.AnnotatorRegistry.get_annotator("rgb")
        pictures[path].attach([str(product.GetPath())])
        sensors[path] = sensor
    omni.timeline.get_timeline_interface().play()

    def array(sensor, annotator):
        data, _ = sensor.get_data(annotator)
        return None if data is None else data.numpy()

    def read():
        return {
            path: (
                array(sensor, "distance_to_image_plane"),
                array(sensor, "depth_sensor_distance"),
                pictures[path].get_data(),
            )
            for path, sensor in sensors.items()
        }

    return app.update, read


# This part requires oaktwin.


def compare(device: oaktwin.Device, camera: str, isaac: str, exact, measured, rgb) -> str:
    """Compares Isaac Sim's depth sensor with oaktwin's model of it, for the same ground truth and colour image."""
    kind = next((kind for kind, about in device.depth_sensors.items() if about["prim"] == camera), None)
    sensor = oaktwin.DepthSensor(device, sensor=kind, engine="single-view", isaac=isaac)
    ours = sensor(exact, rgb)
    both = (ours > 0) & (measured > 0)
    near = np.abs(ours - measured)[both] <= 0.001 + 0.005 * measured[both]
    return (
        f"{camera}: measured by Isaac Sim {100 * np.mean(measured > 0):.1f} %, by ours {100 * np.mean(ours > 0):.1f} %, "
        f"by both {100 * both.mean():.1f} %; of these {100 * near.mean() if near.size else 0:.1f} % within 0.5 % of each other"
    )


def main() -> None:
    parser = argparse.ArgumentParser(description="An OAK's depth sensor in Isaac Sim 5.1 or 6.")
    parser.add_argument("--model", default="OAK4-D", help="one of oaktwin.models()")
    parser.add_argument("--frames", type=int, default=3)
    parser.add_argument("-o", "--output", type=Path, default=Path("isaac-sim-oak"), help="folder for the asset and the frames")
    parser.add_argument("--compare", action="store_true", help="also run oaktwin's model of Isaac Sim's sensor on the ground truth")
    parser.add_argument("--window", action="store_true", help="show Isaac Sim's window")
    options, _ = parser.parse_known_args()

    from isaacsim import SimulationApp  # before any other module of Isaac Sim

    app = SimulationApp({"headless": not options.window})
    try:
        from isaacsim.sensors.experimental.rtx import SingleViewDepthCameraSensor  # noqa: F401

        isaac = "6"
    except ImportError:
        isaac = "5.1"

    from PIL import Image

    device = oaktwin.Device(options.model)
    options.output.mkdir(parents=True, exist_ok=True)
    # Not .usda: a loader of Isaac Sim 6 turns the root of such an asset into a camera.
    asset = (options.output / f"{options.model.lower().replace(' ', '_')}.usd").resolve()
    device.write_usd(asset, isaac=isaac)

    step, read = (isaac_6 if isaac == "6" else isaac_5)(app, asset)
    for _ in range(WARM_UP):
        step()
    for frame in range(options.frames):
        step()
        for path, (exact, measured, rgb) in read().items():
            camera = path.rsplit("/", 1)[-1]
            if exact is None or measured is None or not exact.size or not measured.size:
                print(f"{camera} {frame}: no image yet")
                continue
            exact, measured = (np.squeeze(np.asarray(image, np.float32)) for image in (exact, measured))
            rgb = None if rgb is None or not rgb.size else np.ascontiguousarray(rgb, np.uint8)
            folder = options.output / camera
            folder.mkdir(exist_ok=True)
            np.save(folder / f"distance_to_image_plane_{frame:04}.npy", exact)
            np.save(folder / f"depth_sensor_distance_{frame:04}.npy", measured)
            if rgb is not None:
                Image.fromarray(rgb).save(folder / f"rgb_{frame:04}.png")
            print(f"{camera} {frame}: {exact.shape[1]}x{exact.shape[0]}, {100 * np.mean(measured > 0):.1f} % measured")
            if options.compare:
                print(compare(device, camera, isaac, exact, measured, rgb))
    app.close()


if __name__ == "__main__":
    main()
