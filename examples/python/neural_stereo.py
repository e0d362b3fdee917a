"""A stereo network as the engine of an OAK, compared with the classical matcher.

    pip install onnxruntime pillow
    oaktwin demo
    python examples/python/neural_stereo.py network.onnx oaktwin-demo/demo_room/demo_room.usda

The network is an ONNX file of yours: two images in, (1, 1 or 3, H, W) float32, and the disparity of the left one out, (1, 1, H, W) or
(1, H, W). It gets the rectified image pair that the OAK's cameras record, and its disparities become the depth of the depth sensor, with
filters and alignment as on the device. The accuracy of both engines is measured with a textured board, and in a room.
"""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import onnxruntime
from PIL import Image

import oaktwin

Float32 = npt.NDArray[np.float32]


class StereoNetwork:
    """A stereo network in an ONNX file. It is called with the rectified pair and returns the disparity of the left image, px.

    path: the ONNX file.
    white: the value of white in the network's input: 255, or 1 for inputs from 0 to 1.
    multiple: what the sides of images are divisible by, for networks that accept images of any size.
    """

    def __init__(self, path: str | Path, white: float = 255, multiple: int = 32) -> None:
        self.name = Path(path).stem
        self.white, self.multiple = white, multiple
        try:
            self.session = onnxruntime.InferenceSession(str(path), providers=onnxruntime.get_available_providers())
        except Exception as error:
            raise SystemExit(f"{path}: cannot be loaded; give an ONNX file ({error})") from error
        inputs = self.session.get_inputs()
        if len(inputs) != 2 or any(len(one.shape) != 4 for one in inputs):
            shapes = ", ".join(f"{one.name} {one.shape}" for one in inputs)
            raise SystemExit(f"{path}: its inputs are {shapes}; use a network of two images (1, C, H, W)")
        self.names = [one.name for one in inputs]
        _, self.channels, self.height, self.width = inputs[0].shape

    def __call__(self, left: npt.NDArray[Any], right: npt.NDArray[Any]) -> Float32:
        rows, columns = left.shape
        pair = [self.prepared(image) for image in (left, right)]
        output = self.session.run(None, dict(zip(self.names, pair)))[0]
        # Networks that were made of optical flow report how far a pixel moves to the right.
        disparity: Float32 = np.abs(np.asarray(output, np.float32).reshape(-1, *output.shape[-2:])[0])
        if not isinstance(self.width, int):
            return disparity[:rows, :columns]
        resized = Image.fromarray(disparity).resize((columns, rows), Image.Resampling.BILINEAR)
        return np.asarray(resized, np.float32) * np.float32(columns / self.width)

    def prepared(self, image: npt.NDArray[Any]) -> Float32:
        """The network's input (1, C, H, W): resized if it has a size of its own, otherwise padded at the right and the bottom."""
        values = image.astype(np.float32) * (self.white / (255 if image.dtype == np.uint8 else 1023))
        if isinstance(self.width, int):
            values = np.asarray(Image.fromarray(values).resize((self.width, self.height), Image.Resampling.BILINEAR))
        else:
            padding = [(0, -side % self.multiple) for side in values.shape]
            values = np.pad(values, padding, mode="edge")
        channels = self.channels if isinstance(self.channels, int) else 3
        return np.ascontiguousarray(np.broadcast_to(values, (1, channels, *values.shape)))


def compare(measured: Float32, exact: Float32) -> tuple[float, float, float]:
    """The share of measured pixels, their median error in mm, and the share of outliers: errors above a twentieth of the distance."""
    both = (measured > 0) & np.isfinite(exact)
    error = np.abs(measured[both] - exact[both])
    if not error.size:
        return 0.0, float("nan"), float("nan")
    return float(both.mean()), 1000 * float(np.median(error)), float(np.mean(error > 0.05 * exact[both]))


def draw(path: Path, shots: dict[str, oaktwin.Shot], exact: Float32) -> None:
    """Plots the measured depth and its error, one row per engine."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, rows = plt.subplots(len(shots), 2, figsize=(9, 3 * len(shots)), layout="constrained")
    for (name, shot), (depth, error) in zip(shots.items(), rows):
        shot.plot(depth)
        depth.set_title(f"{name}: {np.mean(shot.depth > 0):.0%} of the pixels", fontsize=10)
        relative = 100 * (np.where(shot.depth > 0, shot.depth, np.nan) / exact - 1)
        figure.colorbar(error.imshow(relative, cmap="coolwarm", vmin=-10, vmax=10, interpolation="nearest"), ax=error, label="%")
        error.set_title("error", fontsize=10)
    figure.savefig(path, dpi=80)


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("network", type=Path, help="ONNX file")
    parser.add_argument("scene", type=Path, help="USD, glTF, OBJ, STL or PLY")
    parser.add_argument("-o", "--output", type=Path, default=Path("oaktwin-neural"), help="folder for the figure")
    parser.add_argument("--model", default="OAK4-D")
    parser.add_argument("--eye", type=float, nargs=3, default=(0.0, 0.0, 1.15), metavar=("X", "Y", "Z"))
    parser.add_argument("--target", type=float, nargs=3, default=(1.0, 0.0, 1.03), metavar=("X", "Y", "Z"))
    parser.add_argument("--white", type=float, default=255, help="value of white in the network's input")
    parser.add_argument("--distances", type=float, nargs="*", default=(1.0, 2.0, 4.0), help="distances of the board, metres")
    parser.add_argument("--filters", nargs="*", default=(), help='filters of both engines, such as "spatial"')
    parser.add_argument("--figure", action="store_true", help="also draw a figure, with Matplotlib")
    arguments = parser.parse_args()

    device = oaktwin.Device(arguments.model)
    scene = oaktwin.Scene.open(arguments.scene, micro_texture=True)
    pose = scene.look_at(arguments.eye, arguments.target, device)
    network = StereoNetwork(arguments.network, arguments.white)
    sensors = {
        network.name: oaktwin.DepthSensor(device, engine=network, filters=arguments.filters),
        "stereo-matching": oaktwin.DepthSensor(device, engine="stereo-matching", filters=arguments.filters),
    }

    print(f"{device.name}, a textured board: median error of depth")
    print("engine          " + "".join(f"{distance:8g} m" for distance in arguments.distances))
    for name, sensor in sensors.items():
        errors = oaktwin.accuracy(sensor, distances=arguments.distances, devices=1, captures=1).to_numpy()["error_percent"]
        print(f"{name:16}" + "".join(f"{error:8.2f} %" for error in errors))

    print(f"{arguments.scene.name}: density, median error, outliers")
    shots = {name: sensor.shoot(scene, pose, frame=0) for name, sensor in sensors.items()}
    exact = scene.render(shots[network.name].camera, shots[network.name].world_from_camera)["distance_to_image_plane"]
    for name, shot in shots.items():
        density, median_mm, outliers = compare(shot.depth, exact)
        print(f"{name:16}{density:8.1%} {median_mm:8.1f} mm {outliers:8.1%}")
    if arguments.figure:
        arguments.output.mkdir(parents=True, exist_ok=True)
        draw(arguments.output / "neural.png", shots, exact)
        print(arguments.output / "neural.png")


if __name__ == "__main__":
    main()
