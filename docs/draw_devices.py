"""Draws docs/images/real_rig.webp and real_rvc3.webp: depth of real devices beside their twin's.

    OAKTWIN_TEST_DATA=FOLDER python docs/draw_devices.py target/release/oaktwin docs/images

Needs numpy, matplotlib, pillow, and the public test data, of which only plots are shown.
"""

import io
import os
import subprocess
import sys
import tempfile
from pathlib import Path

import matplotlib
import numpy as np
from PIL import Image

matplotlib.use("Agg")
from matplotlib import pyplot as plt  # noqa: E402

RIG = Path(__file__).resolve().parents[1] / "examples/board_rig/render.sh"
UNIT = "board/unit05_0_depth_mm.png"
NO_VALUE = "#202020"
# The constants of the rig, with a census window that the RVC3 device agrees with better.
OF_RIG = ["paths=3", "blockRows=1", "penaltyShift=2", "kernelSize=KERNEL_7x9"]


def save(images, titles, limits, label, path):
    """Draws images side by side, 0 as no value."""
    colours = plt.get_cmap("viridis").copy()
    colours.set_bad(NO_VALUE)
    figure, axes = plt.subplots(1, len(images), figsize=(4.6 * len(images), 2.9), layout="constrained", dpi=110)
    for axis, image, title in zip(axes, images, titles):
        shown = axis.imshow(np.ma.masked_equal(image, 0), cmap=colours, vmin=limits[0], vmax=limits[1], interpolation="nearest")
        axis.set_title(title, fontsize=10)
        axis.set_axis_off()
    figure.colorbar(shown, ax=axes, shrink=0.8, label=label)
    drawn = io.BytesIO()
    figure.savefig(drawn)
    plt.close(figure)
    Image.open(drawn).convert("RGB").save(path, quality=60, method=6)


def rig(program, real, folder):
    subprocess.run([RIG, folder / "rig"], check=True, capture_output=True, env=os.environ | {"OAKTWIN": program})
    paths = [real / UNIT, folder / "rig/depth_mm.png"]
    return [np.asarray(Image.open(path)).astype(float) for path in paths]


def rvc3(program, real, folder):
    # Grey as three equal channels.
    device = np.asarray(Image.open(real / "keembay/disparity_left_device.png")).reshape(720, 1280, -1)[:, :, 0].astype(float)
    images = [device]
    for parameters in ([], OF_RIG):
        chosen = [word for parameter in ["confidenceThreshold=0", *parameters] for word in ("--param", parameter)]
        # The disparity does not depend on the focal length and the baseline.
        command = [program, "stereo", *(real / f"keembay/{side}.png" for side in ("left", "right")), "--fx", "880",
                   "--baseline", "0.075", "--annotators", "disparity", "-o", folder / "rvc3", *chosen]
        ended = subprocess.run(list(map(str, command)), capture_output=True, text=True)
        assert ended.returncode in (0, 1), ended.stderr
        # Truncated, as the device's.
        images.append(np.floor(np.load(next((folder / "rvc3").glob("*disparity.npy")))))
    return images


def main():
    program, out = str(Path(sys.argv[1]).resolve()), Path(sys.argv[2])
    real = Path(os.environ["OAKTWIN_TEST_DATA"]) / "data/real"
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        save(rig(program, real, folder), ["A unit", "The twin"], (500, 800), "mm", out / "real_rig.webp")
        titles = ["An RVC3 device", "The twin: defaults, all kept", "The twin: constants of the rig, census of 7×9"]
        save(rvc3(program, real, folder), titles, (0, 95), "px", out / "real_rvc3.webp")


main()
