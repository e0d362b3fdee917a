"""Many MuJoCo worlds at once: what the OAK of each robot of a reinforcement-learning batch sees.

    pip install mujoco matplotlib
    python examples/python/many_worlds.py [-o worlds/] [--count 256]

A robot with an arm stands before a table in each world; joints differ. One call renders the depth of all worlds, a second one turns
it into what an OAK would have measured, each world with its own noise.
"""

import argparse
import time
from pathlib import Path

import mujoco
import numpy as np

import oaktwin
import oaktwin.mujoco

SIZE = (106, 60)
MODEL = """
<mujoco>
  <asset><hfield name="ground" nrow="24" ncol="24" size="3 3 0.08 0.1"/></asset>
  <worldbody>
    <geom type="hfield" hfield="ground"/>
    <geom type="box" size="0.3 0.5 0.02" pos="0.9 0 0.5" rgba="0.5 0.35 0.2 1"/>
    <geom type="cylinder" size="0.05 0.1" pos="0.8 0.15 0.62" rgba="0.8 0.2 0.2 1"/>
    <body pos="0.4 0 0.5">
      <joint name="turn" type="hinge" axis="0 0 1"/>
      <geom type="capsule" size="0.04" fromto="0 0 0 0 0 0.25"/>
      <body pos="0 0 0.25">
        <joint name="lift" type="hinge" axis="0 1 0"/>
        <geom type="capsule" size="0.03" fromto="0 0 0 0.3 0 0"/>
        <body pos="0.3 0 0"><joint name="wrist" type="hinge" axis="0 1 0"/><geom type="capsule" size="0.02" fromto="0 0 0 0.2 0 0"/></body>
      </body>
    </body>
  </worldbody>
</mujoco>
"""


def simulate(count, seed=0):
    """The ground truth of all worlds and what the OAKs measure: two (N, H, W) arrays, metres."""
    model = mujoco.MjModel.from_xml_string(MODEL)
    rng = np.random.default_rng(seed)
    model.hfield_data[:] = rng.uniform(0, 1, model.hfield_data.shape)
    worlds = oaktwin.mujoco.Worlds(model, count)
    worlds.update(rng.uniform((-0.8, -0.2, -0.5), (0.8, 0.9, 0.9), (count, model.nq)))
    camera = oaktwin.Camera(SIZE, hfov_deg=70)
    views = np.stack([oaktwin.look_at(rng.normal((-0.2, 0, 1.1), 0.02), (0.8, 0, 0.5)) for _ in range(count)])
    depth = worlds.render(camera, views)
    sensor = oaktwin.DepthSensor(oaktwin.Device("OAK-D Pro PoE"), fx=camera.K[0, 0], extended_disparity=True, seed=seed)
    return depth, sensor(depth)


def draw(depth, measured, path):
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(2, 6, figsize=(12, 2.9), constrained_layout=True)
    for column in range(6):
        for row, (name, images) in enumerate((("ground truth", depth), ("measured", measured))):
            shown = np.where((images[column] > 0) & np.isfinite(images[column]), images[column], np.nan)
            axes[row, column].imshow(shown, cmap="turbo", vmin=0.4, vmax=2.0, interpolation="nearest")
            axes[row, column].set(xticks=[], yticks=[], ylabel=name if column == 0 else "")
        axes[0, column].set_title(f"world {column}")
    figure.savefig(path, dpi=110)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("-o", "--output", type=Path, default=Path("worlds"))
    parser.add_argument("--count", type=int, default=256)
    arguments = parser.parse_args()
    start = time.perf_counter()
    depth, measured = simulate(arguments.count)
    print(f"{arguments.count} worlds of {SIZE[0]}x{SIZE[1]} in {time.perf_counter() - start:.2f} s")
    valid = (measured > 0) & np.isfinite(depth)
    error = np.abs(measured - depth)[valid]
    print(f"{np.mean(valid[np.isfinite(depth)]):.1%} measured, median error {1000 * np.median(error):.1f} mm")
    arguments.output.mkdir(parents=True, exist_ok=True)
    np.savez_compressed(arguments.output / "worlds.npz", depth=depth, measured=measured)
    draw(depth, measured, arguments.output / "worlds.png")
    print(f"wrote {arguments.output / 'worlds.png'}")


if __name__ == "__main__":
    main()
