"""Draws docs/images/first.png: what the README's Python gives, in the room of `oaktwin demo`.

    oaktwin demo && python docs/draw_first.py docs/images/first.png

Needs the package oaktwin, numpy, matplotlib, pillow. It runs the lines of the README and colours what they return.
"""

import io
import re
import sys
from pathlib import Path

import matplotlib
import numpy as np
from PIL import Image

matplotlib.use("Agg")
from matplotlib import pyplot as plt  # noqa: E402

README = Path(__file__).resolve().parents[1] / "README.md"
NEAR_M, FAR_M = 1.2, 9.0


def colored(depth: np.ndarray) -> np.ndarray:
    """Near is red, far is blue; what was not measured is dark."""
    near = (1 / np.maximum(depth, 1e-3) - 1 / FAR_M) / (1 / NEAR_M - 1 / FAR_M)
    image = matplotlib.colormaps["turbo"](0.05 + 0.9 * np.clip(near, 0, 1))[..., :3]
    image[~((depth > 0) & np.isfinite(depth))] = 0.2
    return (255 * image).astype(np.uint8)


def main() -> None:
    names = {}
    exec(re.search(r"^```python\n(.*?)^```$", README.read_text("utf-8"), re.M | re.S)[1], names)
    exact, measured = names["exact"], names["measured"]
    images = {
        'exact["rgb"]': exact["rgb"][..., :3],
        'exact["distance_to_image_plane"]': colored(exact["distance_to_image_plane"]),
        "measured": colored(measured),
    }
    figure, panels = plt.subplots(1, 3, figsize=(12, 2.85), dpi=100)
    figure.subplots_adjust(left=0.006, right=0.994, top=0.88, bottom=0.01, wspace=0.02)
    for axes, (title, image) in zip(panels, images.items()):
        axes.imshow(Image.fromarray(image).resize((390, 244), Image.Resampling.BOX), interpolation="none", aspect="auto")
        axes.set_title(title, fontsize=13, loc="left", pad=5, family="monospace")
        axes.set_axis_off()
    with io.BytesIO() as file:
        figure.savefig(file, format="png")
        Image.open(file).convert("RGB").quantize(192, dither=Image.Dither.NONE).save(sys.argv[1], optimize=True)


if __name__ == "__main__":
    main()
