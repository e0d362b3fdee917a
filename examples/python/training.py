"""What the policies of a thousand environments see of their OAKs at each control step: noise, rate, delay and losses.

    pip install warp-lang matplotlib     # both optional
    python examples/python/training.py --envs 1024 --steps 50 -o training/

Robots drive towards boxes at up to 1 m/s. Each has an OAK with a calibration error and a delay of its own, drawn anew for each
episode. `oaktwin.Stream` is given the exact depth of all environments at each step, (N, 60, 106) float32 metres, measures those
whose cameras expose, and returns the newest frames that have arrived, cropped, resized, clipped and normalized. With `--warp`, the kernels
of `oaktwin.warp` measure; on a GPU, nothing is then copied to the host.
"""

import argparse
import time
from importlib.util import find_spec
from pathlib import Path

import numpy as np

import oaktwin

CONTROL_HZ, CAMERA_HZ, LATENCY_S = 50, 30, (0.03, 0.09)
CLIP_M, SEEN = (0.3, 4.0), (58, 87)


def made_up_depth(envs: int, height: int, width: int, hfov_deg: float) -> np.ndarray:
    """The depth of cameras 0.6 m above the ground that face two boxes, 20 degrees down: (N, H, W), metres, inf in the sky."""
    random = np.random.default_rng(1)
    focal = width / 2 / np.tan(np.radians(hfov_deg) / 2)
    sine, cosine = np.sin(np.radians(20)), np.cos(np.radians(20))
    y = (np.arange(height) + 0.5 - height / 2) / focal
    down = sine + y * cosine  # of a ray, per metre along the axis
    ground = np.where(down > 0.03, 0.6 / np.maximum(down, 0.03), np.inf)
    depth = np.empty((envs, height, width), np.float32)
    depth[:] = ground[:, None]
    for image in depth:
        for away in random.uniform(1.5, 4, 2):
            front = away / (cosine - y * sine)
            rows = (front * down > 0.6 - random.uniform(0.3, 0.7)) & (front * down < 0.6)
            left = random.integers(0, width)
            face = image[rows, left : left + round(focal * 0.5 / away)]
            image[rows, left : left + round(focal * 0.5 / away)] = np.minimum(face, front[rows, None])
    return depth


def make_sensor(envs: int, hfov_deg: float, model: str, uses_warp: bool):
    """The sensor: with Warp, each environment has a unit of its own; otherwise all have one."""
    device = oaktwin.Device(model)
    if not uses_warp:
        return oaktwin.DepthSensor(device, hfov_deg=hfov_deg, device_seed=1)
    from oaktwin import warp

    return warp.DepthSensor(device, hfov_deg=hfov_deg, device_seed=range(envs))


def picture(path: Path, exact: np.ndarray, seen: np.ndarray, age: np.ndarray) -> None:
    """Plots the input of some policies without and with the model."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    columns = min(3, len(exact))
    figure, axes = plt.subplots(2, columns, figsize=(2.9 * columns, 4.1), layout="constrained", squeeze=False)
    for env in range(columns):
        axes[0, env].imshow(exact[env], "viridis", vmin=0, vmax=1, interpolation="nearest")
        drawn = axes[1, env].imshow(np.where(seen[env] < 0, np.nan, seen[env]), "viridis", vmin=0, vmax=1, interpolation="nearest")
        axes[0, env].set_title(f"environment {env}", fontsize=10)
        axes[1, env].set_xlabel(f"{1000 * age[env]:.0f} ms old", fontsize=9)
        for place in axes[:, env]:
            place.set(xticks=[], yticks=[], facecolor="black")
    axes[0, 0].set_ylabel("exact")
    axes[1, 0].set_ylabel("what the policy sees")
    figure.colorbar(drawn, ax=axes, label="normalized depth (black: invalid)", shrink=0.8)
    figure.savefig(path, dpi=80)


def main() -> None:
    parser = argparse.ArgumentParser(description="What policies see of their OAKs.")
    parser.add_argument("--envs", type=int, default=1024)
    parser.add_argument("--steps", type=int, default=50)
    parser.add_argument("--model", default="OAK4-D", help="one of oaktwin.models()")
    parser.add_argument("--seed", type=int, default=7)
    parser.add_argument("--warp", action="store_true", help="measure with oaktwin.warp")
    parser.add_argument("-o", "--output", type=Path, help="folder for training.npz and training.png")
    options = parser.parse_args()

    hfov = oaktwin.Device(options.model).depth_camera().hfov_deg
    there = made_up_depth(options.envs, 60, 106, hfov)
    speed = np.random.default_rng(2).uniform(0, 1, options.envs).astype(np.float32)  # m/s
    image = dict(crop=(2, 0, 8, 8), resize=SEEN, clip=CLIP_M, normalize=True, invalid=-1.0)
    stream = oaktwin.Stream(
        make_sensor(options.envs, hfov, options.model, options.warp),
        camera_hz=CAMERA_HZ, control_hz=CONTROL_HZ, latency=LATENCY_S, jitter=0.01, drop=0.02, seed=options.seed, **image,
    )  # fmt: skip
    exact = oaktwin.Stream(lambda depth, *_, **__: depth, latency=0.0, camera_hz=CONTROL_HZ, control_hz=CONTROL_HZ, **image)

    times, ages, fresh = [], [], []
    for step in range(options.steps):
        depth = np.maximum(there - (speed * step / CONTROL_HZ)[:, None, None], 0.05)  # the simulator's step
        began = time.perf_counter()
        seen = stream(depth)  # <- what the policies get
        times.append(time.perf_counter() - began)
        ages.append(seen.age[:, -1])
        fresh.append(seen.fresh)
        if step % 25 == 24:
            stream.reset(np.arange(step % 2, options.envs, 2))  # half of the episodes end
    age, share = np.mean(ages), np.mean(fresh[1:])
    print(f"{options.envs} environments, observations {seen.depth.shape} of {type(seen.depth).__module__.split('.')[0]}")
    print(f"age {1000 * age:.0f} ms on average, {1000 * np.max(ages):.0f} ms at most; {100 * share:.0f} % of steps have a new frame")
    late = speed * seen.age[:, -1]
    print(f"at up to 1 m/s, a policy sees obstacles {1000 * np.mean(late):.0f} mm farther away than they are on average")
    print(f"median {1000 * np.median(times):.1f} ms a step")
    if options.output:
        options.output.mkdir(parents=True, exist_ok=True)
        truth = exact(depth)
        first = slice(0, 16)
        np.savez_compressed(
            options.output / "training.npz", exact=truth.depth[first, -1], seen=seen.depth[first, -1], age=seen.age[first, -1]
        )
        if find_spec("matplotlib"):
            picture(options.output / "training.png", truth.depth[:, -1], seen.depth[:, -1], seen.age[:, -1])
        print(f"wrote {options.output}")


if __name__ == "__main__":
    main()
