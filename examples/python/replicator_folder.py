r"""Adds the depth that an OAK would measure to a Replicator data set, in place.

    pip install pillow               # to read rgb_*.png; without it, or with --no-rgb, every surface counts as textured
    python -m oaktwin render scene.usd --model OAK4-D --look-at 2 -1 1.2  0 0 0.5 \
        --annotators distance_to_image_plane,rgb,camera_params -o frames/
    python examples/python/replicator_folder.py frames/ --model OAK4-D

Walks a folder written by Replicator's BasicWriter or `oaktwin render`: the files of one camera, or of several in folders by camera,
or by camera and annotator. Beside each distance_to_image_plane_0007.npy (float32 metres, inf for a miss) it writes
depth_sensor_distance_0007.npy (float32 metres, 0 where invalid) atomically. The result is identical to the output of
`oaktwin sense frames/ --model OAK4-D`; a script is useful for what the command does not support: other names, other arrays,
several sensors at once.
"""

import argparse
import json
import os
import re
from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path

import numpy as np

import oaktwin

ANNOTATOR = "distance_to_image_plane"


def cameras(folder: Path) -> Iterator[tuple[str, Path, bool]]:
    """Yields name, folder and whether each annotator has its own subfolder, for each camera with depth."""
    if any(folder.glob(f"{ANNOTATOR}_*.npy")):
        yield "", folder, False
    for camera in sorted(path for path in folder.iterdir() if path.is_dir()):
        if any(camera.glob(f"{ANNOTATOR}_*.npy")):
            yield camera.name, camera, False
        elif any((camera / ANNOTATOR).glob(f"{ANNOTATOR}_*.npy")):
            yield camera.name, camera, True


def image_camera(params: Path) -> oaktwin.Camera | None:
    """The camera of the images, from a camera_params_*.json; None if the file does not exist. Distortion is ignored, because a
    depth sensor's images are rectified."""
    if not params.is_file():
        return None
    params_json = json.loads(params.read_text(encoding="utf-8"))
    width, height = params_json["renderProductResolution"]
    if params_json.get("cameraModel", "pinhole") == "pinhole":
        p = params_json["cameraProjection"]
        fx, fy = p[0] * width / 2, p[5] * height / 2
        # From normalized device coordinates, with y up and the origin at the border instead of the centre of the first pixel.
        cx, cy = (1 - p[8]) * width / 2 - 0.5, (1 + p[9]) * height / 2 - 0.5
    else:
        fx, fy = params_json["cameraOpenCVFx"], params_json["cameraOpenCVFy"]
        cx, cy = params_json["cameraFisheyeOpticalCentre"]
    return oaktwin.Camera((width, height), K=[[fx, 0, cx], [0, fy, cy], [0, 0, 1]])


def read_picture(path: Path) -> np.ndarray | None:
    """Reads (H, W, 4) uint8; None if the file or Pillow is missing."""
    if not path.is_file() or not find_spec("PIL"):
        return None
    from PIL import Image

    return np.array(Image.open(path).convert("RGBA"))


def write_whole(path: Path, array: np.ndarray) -> None:
    """Writes a file atomically: under a temporary name, then renamed."""
    path.parent.mkdir(exist_ok=True)
    beside = path.with_name(f".{path.name}.{os.getpid()}")
    try:
        with open(beside, "wb") as file:
            np.save(file, array)
            file.flush()
            os.fsync(file.fileno())
        os.replace(beside, path)
    finally:
        beside.unlink(missing_ok=True)


def picture(path: Path, frames: list[tuple[str, np.ndarray | None, np.ndarray, np.ndarray]]) -> None:
    """Plots colour image, ground-truth depth and measured depth, one row per frame. Requires Matplotlib."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(len(frames) + 1, 3, figsize=(10.2, 2.1 * len(frames) + 0.6), layout="constrained",
                                squeeze=False, height_ratios=[1.0] * len(frames) + [0.06])  # fmt: skip
    colours = plt.get_cmap("turbo").copy()
    colours.set_bad("black")
    far = max(np.percentile(exact[np.isfinite(exact)], 98) for _, _, exact, _ in frames)
    for row, (title, rgb, exact, measured) in zip(axes, frames):
        row[0].imshow(np.zeros((*exact.shape, 3), np.uint8) if rgb is None else rgb)
        row[1].imshow(np.where(np.isfinite(exact), exact, np.nan), colours, vmin=0, vmax=far)
        drawn = row[2].imshow(np.where(measured > 0, measured, np.nan), colours, vmin=0, vmax=far)
        row[0].set_ylabel(title)
        for place in row:
            place.set(xticks=[], yticks=[])
    for place, name in zip(axes[0], ["rgb", ANNOTATOR, "depth_sensor_distance"]):
        place.set_title(name, fontsize=10)
    for place in axes[-1]:
        place.set_axis_off()
    below = figure.add_subplot(axes[0, 0].get_gridspec()[-1, 1:])
    figure.colorbar(drawn, cax=below, orientation="horizontal", label="depth [m]; black: no surface, or not measured")
    figure.savefig(path, dpi=100)


def main() -> None:
    parser = argparse.ArgumentParser(description="Adds an OAK's depth to a Replicator data set.")
    parser.add_argument("folder", type=Path)
    parser.add_argument("--model", default="OAK4-D", help="one of oaktwin.models()")
    parser.add_argument("--preset", help="DepthAI preset with filters: default, robotics, ...")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--no-rgb", action="store_true", help="ignore colour images: every surface counts as textured")
    parser.add_argument("--picture", type=Path, help="write a figure of the first frames")
    options = parser.parse_args()

    device = oaktwin.Device(options.model)
    prims = {about["prim"]: kind for kind, about in device.depth_sensors.items()}
    found = list(cameras(options.folder))
    # If folders are named after the model's depth sensors, only those are processed.
    own = [camera for camera in found if camera[0] in prims]
    count, shown = 0, []
    for name, folder, by_annotator in own or found:

        def beside(annotator: str, number: str, extension: str) -> Path:
            place = folder / annotator if by_annotator else folder
            return place / f"{annotator}_{number}.{extension}"

        depth_files = sorted((beside(ANNOTATOR, "", "npy").parent).glob(f"{ANNOTATOR}_*.npy"))
        numbers = [match[1] for file in depth_files if (match := re.fullmatch(rf"{ANNOTATOR}_(\d+)\.npy", file.name))]
        sensor, params = None, None
        for number in sorted(numbers, key=int):
            depth = np.load(beside(ANNOTATOR, number, "npy"))
            rgb = None if options.no_rgb else read_picture(beside("rgb", number, "png"))
            # One sensor per camera, with its frames in order, for temporal filters.
            camera = image_camera(beside("camera_params", number, "json"))
            its_params = camera and (camera.size, camera.K.tolist())
            if sensor is None or its_params != params:
                params = its_params
                sensor = oaktwin.DepthSensor(
                    device,
                    sensor=prims.get(name),
                    preset=options.preset,
                    seed=options.seed,
                    camera=camera,
                    name=name if name and not own else None,
                )
            measured = sensor(depth, rgb, frame=int(number))
            write_whole(beside("depth_sensor_distance", number, "npy"), measured)
            share = 100 * (measured > 0).mean()
            picture_too = "" if rgb is None else ", with its picture"
            print(f"{name or '.'} {number}: {depth.shape[1]}x{depth.shape[0]}, {share:.1f} % measured{picture_too}")
            count += 1
            if options.picture and len(shown) < 3:
                shown.append((f"{name} {number}".strip(), rgb, depth, measured))
    if not count:
        raise SystemExit(f"{options.folder}: holds no {ANNOTATOR}_0000.npy, flat, by camera, or by camera and annotator")
    print(f"{count} frames, {len(own or found)} {'camera' if len(own or found) == 1 else 'cameras'}")
    if options.picture:
        picture(options.picture, shown)


if __name__ == "__main__":
    main()
