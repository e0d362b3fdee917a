"""Draws docs/images/why.png: what Gaussian noise, Isaac Sim's sensor and two engines make of the depth of one room.

    python docs/draw_why.py target/release/oaktwin docs/images/why.png

Needs numpy, matplotlib, pillow. The program renders and senses; this compares and lays out. The room is the demo's with a plain
white cupboard in it, and the camera is an OAK-D Pro PoE without its dots.
"""

import io
import json
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

import matplotlib
import numpy as np
from PIL import Image

matplotlib.use("Agg")
from matplotlib import pyplot as plt  # noqa: E402

ROOM = """#usda 1.0
(
    defaultPrim = "Room"
    metersPerUnit = 1
    subLayers = [@demo_room.usda@]
    upAxis = "Z"
)

over "Room"
{
    def Cube "Cupboard"
    {
        double size = 1
        float3 xformOp:scale = (0.6, 0.9, 1.8)
        double3 xformOp:translate = (2.5, -1.8, 0.9)
        uniform token[] xformOpOrder = ["xformOp:translate", "xformOp:scale"]
        rel material:binding = </Room/Looks/White>
    }
}
"""
EYE, TARGET = np.array([-0.7, 0.0, 1.15]), np.array([1.0, 0.0, 0.99])
SIGMA_M = 0.02
# Rows and columns: what is shown, and a part of the cupboard's front.
SHOWN, CUPBOARD = (slice(100, 563), slice(360, 1100)), (slice(200, 560), slice(1060, 1240))
TITLES = {
    "gaussian": ("Gaussian noise, σ = 2 cm", "Gaussian", "#8a6d00"),
    "single-view": ("Isaac Sim's sensor (single-view)", "Isaac\nSim", "#1f7a4d"),
    "stereo-noise": ("oaktwin, stereo-noise", "stereo-\nnoise", "#7b3fa0"),
    "stereo-matching": ("oaktwin, stereo-matching", "stereo-\nmatching", "#c2410c"),
}
# The colours of errors, in metres, and of pixels without a value.
LEVELS, NO_VALUE = np.linspace(-0.15, 0.15, 14), (0.2, 0.2, 0.2)
METRES = np.arange(2, 9)


@dataclass
class Shot:
    """Depth as measured, 0 where it is not; the truth in the same view; and what the other camera of the pair does not see."""

    depth: np.ndarray
    truth: np.ndarray
    hidden: np.ndarray

    def error(self) -> np.ndarray:
        """Metres, NaN without a value or a surface."""
        return np.where((self.depth > 0) & np.isfinite(self.truth), self.depth, np.nan) - np.where(np.isfinite(self.truth), self.truth, 0)

    def growth(self) -> list[float]:
        """The median of the absolute error at each of the metres, in centimetres."""
        error, metre = np.abs(self.error()), np.rint(self.truth)
        return [100 * float(np.nanmedian(error[metre == one])) for one in METRES]

    def shares(self) -> list[float]:
        """Of the pixels that one camera does not see, and of the cupboard's, the share with a value; of those up to 4 px to the
        right of something nearer, the share whose depth is closer to it than to the truth."""
        left = np.pad(self.truth, ((0, 0), (4, 0)), mode="edge")
        near = np.minimum.reduce([left[:, 4 - n : left.shape[1] - n] for n in range(1, 5)])
        beside = (near < 0.75 * self.truth) & np.isfinite(self.truth) & (self.depth > 0)
        widened = self.depth < (near + self.truth) / 2
        return [float(part.mean()) for part in ((self.depth > 0)[self.hidden], (self.depth > 0)[CUPBOARD], widened[beside])]


def look(program: Path, room: Path, out: Path, aside: float, annotators: str, *options: str) -> np.ndarray:
    """Renders the room from a point that is moved to the left, in metres; returns the truth."""
    at = [*(EYE + [0, aside, 0]), *(TARGET + [0, aside, 0])]
    words = [program, "render", room, "--model", "OAK-D-Pro-PoE", "--look-at", *at, "-o", out, *options]
    annotators = f"distance_to_image_plane,camera_params{annotators}"
    subprocess.run([str(word) for word in [*words, "--annotators", annotators]], check=True, stdout=subprocess.DEVNULL)
    return np.load(out / "distance_to_image_plane_0000.npy")


def camera(file: Path) -> tuple[float, float]:
    """The focal length in pixels, and how far left the camera is, in metres."""
    values = json.loads(file.read_text())
    world_from_camera = np.linalg.inv(np.reshape(values["cameraViewTransform"], (4, 4)).T)
    return values["cameraProjection"][0] * values["renderProductResolution"][0] / 2, world_from_camera[1, 3]


def hidden(truth: np.ndarray, other: np.ndarray, focal_times_baseline: float) -> np.ndarray:
    """The pixels whose surface something nearer hides from the other camera, which is to the right if the baseline is positive."""
    rows, columns = np.indices(truth.shape)
    there = np.rint(columns - focal_times_baseline / truth).astype(int)
    inside = (there >= 0) & (there < truth.shape[1])
    return inside & np.isfinite(truth) & (other[rows, np.clip(there, 0, truth.shape[1] - 1)] < 0.9 * truth)


def measure(program: Path, folder: Path) -> tuple[np.ndarray, dict[str, Shot]]:
    """Returns the picture, and the shot of each of the titles."""
    quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    subprocess.run([program, "demo", "-o", folder / "demo"], check=True, **quiet)
    room = folder / "demo/demo_room/why.usda"
    room.write_text(ROOM)
    truth, depth = {}, {}
    for engine in list(TITLES)[1:]:
        truth[engine] = look(program, room, folder / engine, 0, ",rgb,depth_sensor_distance", "--engine", engine, "--seed", "3")
        depth[engine] = np.load(folder / engine / "depth_sensor_distance_0000.npy")
    # Isaac Sim's sensor sees from a second camera, to the left of the one that is rendered.
    focal, here = camera(folder / "single-view/camera_params_0000.json")
    baseline = camera(folder / "single-view/depth_sensor_camera_params_0000.json")[1] - here
    first = truth["stereo-noise"]
    second, right = (look(program, room, folder / name, aside, "") for name, aside in (("second", baseline), ("right", -baseline)))
    behind = hidden(first, right, focal * baseline)
    noisy = first + np.random.default_rng(7).normal(0, SIGMA_M, first.shape)
    shots = {
        "gaussian": Shot(np.where(np.isfinite(noisy), noisy, 0), first, behind),
        "single-view": Shot(depth["single-view"], second, hidden(second, first, focal * baseline)),
        **{engine: Shot(depth[engine], first, behind) for engine in ("stereo-noise", "stereo-matching")},
    }
    return np.array(Image.open(folder / "stereo-noise/rgb_0000.png").convert("RGB")), shots


def colours() -> matplotlib.colors.ListedColormap:
    return matplotlib.colormaps["RdBu_r"].resampled(len(LEVELS) - 1)


def show(axes: plt.Axes, image: np.ndarray, title: str, colour: str = "black") -> None:
    size = image.shape[1] // 2, image.shape[0] // 2
    axes.imshow(Image.fromarray(image).resize(size, Image.Resampling.BOX), extent=(0, 740, 463, 0), interpolation="none")
    axes.set_title(title, fontsize=14, fontweight="bold", color=colour, loc="left", pad=5)
    axes.set_axis_off()


def error_image(shot: Shot) -> np.ndarray:
    error = shot.error()
    level = np.clip(np.digitize(np.nan_to_num(error), LEVELS) - 1, 0, len(LEVELS) - 2)
    image = colours()(level)[..., :3]
    image[shot.depth <= 0] = NO_VALUE
    return (255 * image[SHOWN]).astype(np.uint8)


def point(axes: plt.Axes, text: str, at: tuple[int, int], *to: tuple[int, int]) -> None:
    box = {"boxstyle": "round,pad=0.25", "fc": "white", "ec": "#333333", "lw": 0.8}
    arrow = {"arrowstyle": "-|>", "color": "black", "lw": 1.5, "shrinkA": 0, "shrinkB": 0}
    for end in to:
        axes.annotate(text, end, at, fontsize=12, ha="center", va="center", bbox=box, arrowprops=arrow)


def key(figure: plt.Figure, bottom: float) -> None:
    """The colours of errors."""
    write = {"fontsize": 12.5, "va": "center"}
    figure.text(0.008, bottom, "error of the measured depth:", **write)
    figure.text(0.335, bottom, "15 cm too near", ha="right", **write)
    bar = figure.add_axes((0.345, bottom - 0.011, 0.25, 0.022))
    bar.imshow(np.linspace(0, 1, len(LEVELS) - 1)[None], cmap=colours(), aspect="auto", interpolation="none")
    bar.set_axis_off()
    figure.text(0.605, bottom, "15 cm too far", **write)
    figure.add_artist(plt.Rectangle((0.76, bottom - 0.011), 0.03, 0.022, color=NO_VALUE))
    figure.text(0.8, bottom, "no value", **write)


def table(axes: plt.Axes, shots: dict[str, Shot]) -> None:
    rows = [
        "hidden from one of the cameras:\npixels with a value",
        "plain surface (the cupboard):\npixels with a value",
        "just right of near objects: pixels\nwith the depth of the object",
    ]
    axes.set_axis_off()
    axes.set(xlim=(0, 100), ylim=(len(rows), -0.75))
    for x, (name, shot) in zip((54, 67, 80, 94), shots.items()):
        axes.text(x, -0.38, TITLES[name][1], ha="center", va="center", fontsize=12.5, fontweight="bold", color=TITLES[name][2])
        for row, share in enumerate(shot.shares()):
            axes.text(x, row + 0.5, f"{share:.0%}", ha="center", va="center", fontsize=14)
    for row, text in enumerate(rows):
        axes.axhline(row, color="#bbbbbb", lw=0.8)
        axes.text(0, row + 0.5, text, va="center", fontsize=12.5, linespacing=1.3)


def chart(axes: plt.Axes, shots: dict[str, Shot]) -> None:
    for name, shot in shots.items():
        axes.plot(METRES, shot.growth(), "o-", color=TITLES[name][2], lw=2, ms=4)
    scale = np.median(shots["stereo-noise"].growth() / METRES**2)
    smooth = np.linspace(1.5, 8.5)
    axes.plot(smooth, scale * smooth**2, "--", color="#555555", lw=1.2, zorder=0)
    for text, x, y, colour in (
        ("stereo-matching", 4.75, 8.6, TITLES["stereo-matching"][2]),
        ("stereo-noise", 6.4, 3.6, TITLES["stereo-noise"][2]),
        ("∝ distance²", 7.0, 9.9, "#555555"),
        ("Gaussian", 2.2, 2.6, TITLES["gaussian"][2]),
        ("Isaac Sim", 3.6, -0.7, TITLES["single-view"][2]),
    ):
        axes.text(x, y, text, color=colour, fontsize=11.5, fontweight="bold" if colour != "#555555" else "normal", ha="center", va="center")
    axes.set(xlim=(1.5, 8.5), ylim=(-1.4, 12))
    axes.set_xticks(METRES, [f"{one} m" for one in METRES], fontsize=11)
    axes.set_yticks(range(0, 12, 2), [f"{one} cm" for one in range(0, 12, 2)], fontsize=11)
    axes.set_title("median error by distance", fontsize=12.5, loc="left")
    axes.grid(color="#dddddd", lw=0.6)


def draw(picture: np.ndarray, shots: dict[str, Shot]) -> Image.Image:
    figure = plt.figure(figsize=(12, 8.8), dpi=100)
    grid = figure.add_gridspec(2, 3, left=0.006, right=0.994, top=0.968, bottom=0.385, wspace=0.02, hspace=0.12)
    panels = [figure.add_subplot(grid[number // 3, number % 3]) for number in range(6)]
    show(panels[0], picture[SHOWN], "The scene")
    near = np.clip(1.25 / shots["gaussian"].truth[SHOWN] - 0.1, 0, 1)
    show(panels[1], (255 * matplotlib.colormaps["turbo"](near)[..., :3]).astype(np.uint8), "Ground truth (red near, blue far)")
    for axes, (name, shot) in zip(panels[2:], shots.items()):
        show(axes, error_image(shot), TITLES[name][0], TITLES[name][2])
    point(panels[4], "hidden", (90, 425), (155, 325), (346, 338))
    point(panels[4], "plain surface", (612, 425), (685, 250))
    point(panels[4], "far away", (385, 60), (475, 130))
    point(panels[5], "widened edges", (150, 90), (92, 238), (178, 246))
    key(figure, 0.352)
    table(figure.add_axes((0.008, 0.012, 0.555, 0.31)), shots)
    chart(figure.add_axes((0.635, 0.04, 0.357, 0.25)), shots)
    with io.BytesIO() as file:
        figure.savefig(file, format="png")
        return Image.open(file).convert("RGB")


def main() -> None:
    program, out = Path(sys.argv[1]).resolve(), Path(sys.argv[2])
    with tempfile.TemporaryDirectory() as name:
        picture, shots = measure(program, Path(name))
    # Few colours: noise does not compress.
    draw(picture, shots).quantize(128, dither=Image.Dither.NONE).save(out, optimize=True)


if __name__ == "__main__":
    main()
