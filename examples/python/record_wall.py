"""Records a flat wall with a real OAK at several distances and fits the twin to this unit.

    pip install depthai
    python examples/python/record_wall.py wall/ [--model OAK4-D] [--device 192.168.1.20] [--projector 0.8]

It needs a wall with texture (or a Pro's dot projector), a tape measure or laser rangefinder, and ten minutes. For each
distance it says where to place the camera, shows the distance and the tilt that the camera sees until you press Enter, asks
for the true distance and records. The folder then has the layout that `oaktwin.fit` reads: one NPY batch of depth images per distance,
the table distances.csv, and the unit's calibration.json; the fit adds unit.toml and curve.png. Run it again to add distances,
or with --fit-only to fit again.
"""

import argparse
import contextlib
import csv
import threading
from pathlib import Path

import numpy as np

import oaktwin

SIZE = (1280, 800)
FPS = 10.0
SUBPIXEL_BITS = 5
# What the guide accepts without a remark.
MAX_TILT_DEG, MIN_FILL = 1.0, 0.8
TABLE = "distances.csv"


def pipeline_of(dai, device, size=SIZE):
    """Stereo without post-processing: the pipeline, and the queue of its depth images."""
    pipeline = dai.Pipeline(device)
    stereo = pipeline.create(dai.node.StereoDepth)
    for socket, entry in [(dai.CameraBoardSocket.CAM_B, stereo.left), (dai.CameraBoardSocket.CAM_C, stereo.right)]:
        camera = pipeline.create(dai.node.Camera).build(socket)
        camera.requestOutput(size, dai.ImgFrame.Type.GRAY8, fps=FPS).link(entry)
    stereo.setRectification(True)
    stereo.setLeftRightCheck(True)
    stereo.setExtendedDisparity(False)
    stereo.setSubpixel(True)
    if device.getPlatform() == dai.Platform.RVC2:
        stereo.setSubpixelFractionalBits(SUBPIXEL_BITS)
    # Filters hide the noise that is to be fitted.
    stereo.initialConfig.setMedianFilter(dai.StereoDepthConfig.MedianFilter.MEDIAN_OFF)
    filters = stereo.initialConfig.postProcessing
    for one in (filters.speckleFilter, filters.spatialFilter, filters.temporalFilter):
        one.enable = False
    filters.decimationFilter.decimationFactor = 1
    stereo.initialConfig.postProcessing = filters
    return pipeline, stereo.depth.createOutputQueue(maxSize=4, blocking=False)


@contextlib.contextmanager
def oak(name, projector, folder):
    """Opens an OAK, stores its calibration, and yields a function that returns the next depth image, millimetres."""
    import depthai as dai  # noqa: PLC0415

    with dai.Device(dai.DeviceInfo(name)) if name else dai.Device() as device:
        device.readCalibration().eepromToJsonFile(str(folder / "calibration.json"))
        if projector and not device.setIrLaserDotProjectorIntensity(projector):
            raise SystemExit("this OAK has no dot projector: leave out --projector")
        pipeline, queue = pipeline_of(dai, device)
        with pipeline:
            pipeline.start()
            yield lambda: queue.get().getFrame()


def suggested(device, count=16, farthest=4.0):
    """Distances whose disparities have all phases of a pixel, on which the error depends, metres; near ones first."""
    camera = device.depth_camera().resized(*SIZE, rule="depthai")
    strength = camera.K[0, 0] * device.rectification().baseline
    # The maximum disparity is 95 px.
    disparities = np.linspace(min(88.0, strength / 0.4), strength / farthest, count)
    # The golden ratio spreads any number of phases evenly.
    phases = np.arange(count) * 0.6180339887 % 1.0
    return [round(float(strength / d), 2) for d in np.floor(disparities) + phases]


def view_of(device, image):
    """What the camera sees in the middle: the distance along its axis in metres, the tilt in degrees (to the right, up), and the
    share of valid pixels."""
    height, width = image.shape
    camera = device.depth_camera().resized(width, height, rule="depthai")
    rows, columns = (slice(side // 4, 3 * side // 4) for side in image.shape)
    points = camera.unproject(np.ascontiguousarray(image))[rows, columns].reshape(-1, 3)
    valid = np.isfinite(points).all(axis=1)
    if valid.sum() < 100:
        return None, (0.0, 0.0), float(valid.mean())
    points = points[valid].astype(float)
    near = np.abs(points[:, 2] / np.median(points[:, 2]) - 1) < 0.1
    x, y, z = points[near].T
    (slope_x, slope_y, at_axis), *_ = np.linalg.lstsq(np.stack([x, y, np.ones_like(x)], axis=1), z, rcond=None)
    return float(at_axis), (float(np.degrees(np.arctan(slope_x))), float(np.degrees(np.arctan(slope_y)))), float(valid.mean())


def advice(tilt, fill):
    """What to correct, in words; empty if nothing."""
    across, down = tilt
    parts = []
    if abs(across) > MAX_TILT_DEG:
        parts.append(f"turn the camera {abs(across):.1f} deg to the {'left' if across > 0 else 'right'}")
    if abs(down) > MAX_TILT_DEG:
        parts.append(f"tilt it {abs(down):.1f} deg {'up' if down > 0 else 'down'}")
    if fill < MIN_FILL:
        parts.append(f"only {fill:.0%} of the middle is measured: add texture or light, or use --projector")
    return "; ".join(parts)


def watch_until_enter(device, next_image):
    """Shows what the camera sees until Enter is pressed."""
    pressed = threading.Event()

    def wait():
        input()
        pressed.set()

    threading.Thread(target=wait, daemon=True).start()
    while not pressed.is_set():
        distance, tilt, fill = view_of(device, next_image())
        seen = "no depth" if distance is None else f"{distance:6.3f} m, tilt {tilt[0]:+5.1f} {tilt[1]:+5.1f} deg"
        print(f"\r  {seen}  {advice(tilt, fill) or 'good: press Enter':<90}", end="", flush=True)
    print()


def recorded(folder):
    """The rows of the table: file and distance."""
    table = folder / TABLE
    if not table.is_file():
        return []
    with table.open(newline="", encoding="utf-8") as lines:
        return [(row["file"], float(row["distance_m"])) for row in csv.DictReader(lines)]


def store(folder, images, distance):
    """Adds a batch of depth images (N, H, W), millimetres, at a true distance, metres."""
    rows = recorded(folder)
    name = f"{len(rows):02}_{distance:.3f}m.npy"
    np.save(folder / name, np.stack(images).astype(np.float32) / 1000)
    with (folder / TABLE).open("w", newline="", encoding="utf-8") as lines:
        writer = csv.writer(lines)
        writer.writerows([("file", "distance_m"), *rows, (name, distance)])


def guide(device, next_image, folder, distances, frames, ask=input, watch=watch_until_enter):
    """Leads through the distances. `q` ends early, `s` skips one."""
    for number, planned in enumerate(distances, 1):
        print(f"[{number}/{len(distances)}] Place the camera {planned:.2f} m from the wall, square to it.")
        watch(device, next_image)
        answer = ask(f"  True distance from lens to wall in metres [{planned:.2f}], s to skip, q to finish: ").strip().lower()
        if answer == "q":
            break
        if answer == "s":
            continue
        images = [next_image() for _ in range(frames)]
        store(folder, images, float(answer.replace(",", ".")) if answer else planned)
        print(f"  recorded {frames} images")


def fit_and_show(device, folder, parameters):
    """Fits, prints the unit's curve and draws it."""
    fitted = oaktwin.fit(device, folder, engine="stereo-noise", parameters=parameters)
    fitted.save(folder / "unit.toml")
    for name, value in fitted.parameters.items():
        interval = fitted.intervals[name]
        print(f"{name:<16}{value:9.4f}" + (f"   95 %: {interval[0]:.4f} to {interval[1]:.4f}" if interval else ""))
    print("distance   measured      fitted")
    for point in sorted(fitted.report["points"], key=lambda point: point["distance_m"]):
        curve = point["fitted_percent"]
        print(f"{point['distance_m']:6.3f} m {point['error_percent']:+8.3f} % " + ("" if curve is None else f"{curve:+9.3f} %"))
    with contextlib.suppress(ImportError):
        fitted.plot().figure.savefig(folder / "curve.png", dpi=150)
    print(f"use it: oaktwin.DepthSensor(device, parameters={str(folder / 'unit.toml')!r})")
    return fitted


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--model", help="the model, if the calibration does not name it")
    parser.add_argument("--device", help="the IP address or id of the OAK; by default the first one found")
    parser.add_argument("--distances", type=float, nargs="+", help="metres; by default 16 up to 4")
    parser.add_argument("--frames", type=int, default=20, help="images per distance; default 20")
    parser.add_argument("--projector", type=float, default=0.0, help="intensity of the dot projector, 0 to 1; default 0")
    parser.add_argument("--fit-only", action="store_true", help="fit an existing recording")
    args = parser.parse_args()
    args.folder.mkdir(parents=True, exist_ok=True)
    calibration = args.folder / "calibration.json"
    if args.fit_only:
        device = oaktwin.Device.from_calibration(calibration, args.model)
    else:
        with oak(args.device, args.projector, args.folder) as next_image:
            device = oaktwin.Device.from_calibration(calibration, args.model)
            guide(device, next_image, args.folder, args.distances or suggested(device), args.frames)
    # RVC4 has no such setting.
    is_rvc2 = device.report()["generation"] == "RVC2"
    fit_and_show(device, args.folder, {"subpixelFractionalBits": SUBPIXEL_BITS} if is_rvc2 else {})


if __name__ == "__main__":
    main()
