"""Draws docs/images/time_of_flight.png: what the OAK-D ToF's time of flight reports of the demo's room, beside the truth and
beside the document's parameters, by which Isaac Sim simulates it as stereo of 0.5 mm (depth computed from disparity).

    python docs/draw_time_of_flight.py target/release/oaktwin docs/images/time_of_flight.png

Needs numpy, opencv-python-headless, pillow. The program renders and senses; this only lays out.
"""

import subprocess
import sys
import tempfile
from pathlib import Path

import cv2
import numpy as np
from PIL import Image

CAMERA = ["--model", "OAK-D-ToF", "--camera", "tof", "--look-at", "0", "0", "1.15", "1", "0", "1.03", "--resolution", "640x480"]
NEAR, FAR = 0.6, 5.5
SIZE = 400, 300


def run(*arguments: object) -> None:
    subprocess.run([str(argument) for argument in arguments], check=True, stdout=subprocess.DEVNULL)


def colored(z: np.ndarray) -> np.ndarray:
    """Near is warm, far is cold; what was not measured is black."""
    part = np.clip((1 / np.maximum(z, 1e-3) - 1 / FAR) / (1 / NEAR - 1 / FAR), 0, 1)
    image = cv2.applyColorMap((255 * part).astype(np.uint8), cv2.COLORMAP_TURBO)
    image[~((z > 0) & np.isfinite(z))] = 0
    return cv2.resize(image, SIZE, interpolation=cv2.INTER_AREA)


def titled(image: np.ndarray, title: str) -> np.ndarray:
    strip = np.full((34, image.shape[1], 3), 255, np.uint8)
    cv2.putText(strip, title, (8, 23), cv2.FONT_HERSHEY_SIMPLEX, 0.55, (40, 40, 40), 1, cv2.LINE_AA)
    return np.vstack([strip, image])


def main() -> None:
    program, out = Path(sys.argv[1]).resolve(), Path(sys.argv[2])
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        run(program, "demo", "-o", folder / "demo")
        room = next((folder / "demo").rglob("demo_room.usda"))
        run(program, "render", room, *CAMERA, "--annotators", "rgb,distance_to_image_plane", "-o", folder / "true")
        depth = next((folder / "true").rglob("distance_to_image_plane*.npy"))
        rgb = next((folder / "true").rglob("rgb*.png"))
        sense = [program, "sense", depth, "--rgb", rgb, "--model", "OAK-D-ToF", "--sensor", "tof", "--seed", "3"]
        stereo = ["--engine", "single-view", "--param", "depth=recomputed", "--param", "maxDistance=20", "--param", "confidenceThreshold=1"]
        run(*sense, *stereo, "-o", folder / "stereo")
        run(*sense, "--engine", "time-of-flight", "-o", folder / "tof")
        reported = [next((folder / what).rglob("*.npy")) for what in ("stereo", "tof")]
        z, by_stereo, by_time = (np.load(path) for path in (depth, *reported))
        picture = cv2.resize(cv2.imread(str(rgb))[..., :3], SIZE, interpolation=cv2.INTER_AREA)
    for what, found in (("stereo of 0.5 mm", by_stereo), ("time of flight", by_time)):
        both = (found > 0) & np.isfinite(z) & (z > 0)
        error = np.abs(found - z)[both] / z[both]
        print(f"{what}: {both.mean():.1%} measured, half of them within {np.median(error):.2%}")
    panels = [
        titled(picture, "what it looks at"),
        titled(colored(z), "exact depth"),
        titled(colored(by_stereo), "single-view, 0.5 mm, recomputed"),
        titled(colored(by_time), "time-of-flight"),
    ]
    gap = np.full((panels[0].shape[0], 8, 3), 255, np.uint8)
    rows = [np.hstack([a, gap, b]) for a, b in (panels[:2], panels[2:])]
    # Few colours: noise does not compress.
    picture = Image.fromarray(cv2.cvtColor(np.vstack(rows), cv2.COLOR_BGR2RGB))
    picture.quantize(96, dither=Image.Dither.NONE).save(out, optimize=True)


if __name__ == "__main__":
    main()
