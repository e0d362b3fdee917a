"""Draws docs/images/imu.png: the Allan deviation of four hours of a BNO086 at rest, beside the numbers of the catalog.

    printf '0 0 0 0 0 0 0 1\\n14400 0 0 0 0 0 0 1\\n' > rest.tum
    oaktwin render SCENE --model OAK-D-Pro-PoE --trajectory rest.tum --imu rest.csv --imu-rate 100 --seed 1
    python docs/draw_imu.py rest.csv
"""

import sys
from pathlib import Path

import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt

RATE = 100.0
# The catalog's BNO086 in SI units, x, y, z.
UG, MDPS = 9.80665e-6, np.pi / 180e3
CHANNELS = {
    "linear_acceleration": ("accelerometer, m/s²", [117.68, 126.12, 144.80], [4.704, 10.263, 3.675], UG),
    "angular_velocity": ("gyroscope, rad/s", [7.754, 9.767, 6.512], [0.01366, 0.02726, 0.01694], MDPS),
}


def allan(samples, sizes):
    sums = np.concatenate([[0.0], np.cumsum(samples - samples.mean())])
    second = (sums[2 * n :] - 2 * sums[n:-n] + sums[: -2 * n] for n in sizes)
    return [np.sqrt(np.mean((change / n) ** 2) / 2) for n, change in zip(sizes, second)]


table = np.loadtxt(sys.argv[1], delimiter=",", skiprows=1)
samples = {"angular_velocity": table[:, 1:4], "linear_acceleration": table[:, 4:7]}
sizes = np.unique(np.geomspace(1, len(table) / 6, 60).astype(int))
tau = sizes / RATE
figure, panels = plt.subplots(1, 2, figsize=(10, 4), dpi=120)
for panel, (name, (title, densities, walks, unit)) in zip(panels, CHANNELS.items()):
    for axis, density, walk, color in zip("xyz", densities, walks, ["#c0392b", "#27824a", "#2c5fa8"]):
        column = samples[name][:, "xyz".index(axis)]
        panel.loglog(tau, allan(column, sizes), color=color, label=axis)
        theory = np.sqrt((density * unit) ** 2 / tau + (walk * unit) ** 2 * tau / 3)
        panel.loglog(tau, theory, color=color, linestyle=":", linewidth=1)
    panel.set(title=title, xlabel="averaging time, s")
    panel.grid(True, which="both", alpha=0.25)
    panel.legend(title="axis; dotted: catalog")
panels[0].set_ylabel("Allan deviation")
figure.tight_layout()
figure.savefig(Path(__file__).parent / "images/imu.png")
