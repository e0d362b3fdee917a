"""Stereo depth of a blank wall, with the dot projector off and on.

    pip install matplotlib
    python examples/python/stereo_projector.py [-o projector/]

A matcher requires texture. The infrared image pair of an OAK-D Pro in front of a plain wall with a few plain objects is rendered
without and with the dots of its projector. Both pairs are matched like on the device, and the measured depth is compared with the
ground truth.
"""

import argparse
import csv
from pathlib import Path

import numpy as np

import oaktwin

THINGS = {  # kind; centre and half extent in metres, with the device at the origin facing along x; reflectance
    "Wall": ("Cube", (2.6, 0, 0), (0.05, 4, 3), 0.6),
    "Floor": ("Cube", (0, 0, -0.85), (4, 4, 0.05), 0.35),
    "Crate": ("Cube", (1.9, 0.45, -0.5), (0.25, 0.25, 0.3), 0.5),
    "Ball": ("Sphere", (1.5, -0.15, -0.55), (0.25, 0.25, 0.25), 0.7),
    "Post": ("Cylinder", (2.0, -0.75, 0), (0.08, 0.08, 0.8), 0.4),
}


def stage():
    """The objects as a USD stage; each is 2 units wide, so its scale is half the extent."""
    thing = """def {} "{}"
{{
    color3f[] primvars:displayColor = [({grey}, {grey}, {grey})]
    double3 xformOp:translate = {}
    double3 xformOp:scale = {}
    uniform token[] xformOpOrder = ["xformOp:translate", "xformOp:scale"]
}}
"""
    head = '#usda 1.0\n(\n    metersPerUnit = 1\n    upAxis = "Z"\n)\n'
    return head + "".join(thing.format(kind, name, at, size, grey=grey) for name, (kind, at, size, grey) in THINGS.items())


def compare(depth, z):
    """The share of valid pixels, their median error, and the share of outliers: errors above a twentieth of the distance."""
    measured = (depth > 0) & np.isfinite(z)
    error = np.abs(depth[measured] - z[measured])
    is_outlier = error > 0.05 * z[measured]
    return {
        "density": float(measured.mean()),
        "median_error_mm": 1000 * float(np.median(error)) if error.size else float("nan"),
        "outliers": float(is_outlier.mean()) if error.size else float("nan"),
    }


def draw(path, seen):
    """Plots the left image, measured depth and its error, one row per projector intensity."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, rows = plt.subplots(2, 3, figsize=(11, 4.5), layout="constrained")
    for row, (power, pair, depth, found) in zip(rows, seen):
        left, z = pair["rectified_left"], pair["z"]
        row[0].imshow(left, cmap="gray", interpolation="nearest", vmin=0, vmax=np.percentile(left, 99.5))
        row[0].set_title(f"left image, projector {'on' if power else 'off'}", fontsize=10)
        measured = np.where(depth > 0, depth, np.nan)
        drawn = row[1].imshow(measured, cmap="turbo", vmin=1.0, vmax=3.0, interpolation="nearest")
        row[1].set_title(f"measured depth: {found['density']:.0%} of the pixels", fontsize=10)
        error = row[2].imshow(100 * (measured / z - 1), cmap="coolwarm", vmin=-5, vmax=5, interpolation="nearest")
        row[2].set_title(f"error: median {found['median_error_mm']:.0f} mm, {found['outliers']:.1%} outliers", fontsize=10)
        figure.colorbar(drawn, ax=row[1], label="m", fraction=0.03, pad=0.02)
        figure.colorbar(error, ax=row[2], label="%", fraction=0.03, pad=0.02, extend="both")
        for axes in row:
            axes.set(xticks=[], yticks=[], facecolor="black")
    figure.savefig(path, dpi=72)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("-o", "--output", type=Path, default=Path("oaktwin-projector"), help="folder for table and figure")
    parser.add_argument("--model", default="OAK-D Pro PoE")
    parser.add_argument("--size", type=int, nargs=2, default=(640, 400), metavar=("WIDTH", "HEIGHT"))
    parser.add_argument("--power", type=float, default=1.0, help="projector intensity when on, above 0, up to 1")
    parser.add_argument("--ambient", type=float, default=0.3, help="ambient light scale; 0 is darkness")
    parser.add_argument("--seed", type=int, default=7)
    arguments = parser.parse_args()

    folder = arguments.output
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "room.usda").write_text(stage())
    scene = oaktwin.Scene.open(folder / "room.usda")
    device = oaktwin.Device(arguments.model)
    matcher = oaktwin.StereoMatcher(device)
    world_from_body = oaktwin.look_at((0, 0, 0), (1, 0, -0.1), frame="body")

    print(f"{device.name}, {arguments.size[0]}x{arguments.size[1]}, ambient light {arguments.ambient:g}")
    print("projector   density  median error  outliers")
    seen = []
    for power in (0.0, arguments.power):
        pair = scene.render_pair(
            device,
            world_from_body,
            size=tuple(arguments.size),
            projector=power,
            ambient=arguments.ambient,
            seed=arguments.seed,
            frame=0,
        )
        matched = matcher(pair["left"], pair["right"])
        found = compare(matched["depth"], pair["z"])
        seen.append((power, pair, matched["depth"], found))
        print(f"{power:9g} {found['density']:9.1%} {found['median_error_mm']:10.1f} mm {found['outliers']:9.1%}")
        for finding in matched["findings"]:
            print(f"          {finding}")
    with open(folder / "projector.csv", "w", newline="") as file:
        table = csv.DictWriter(file, ["projector", *seen[0][-1]])
        table.writeheader()
        table.writerows({"projector": power, **found} for power, _, _, found in seen)
    draw(folder / "projector.png", seen)
    print(f"{folder / 'projector.csv'} and projector.png")


if __name__ == "__main__":
    main()
