"""OAK depth for a thousand environments at once: the noise hook of an Isaac Lab task.

    pip install torch matplotlib     # both optional
    python examples/python/isaac_lab_batch.py --envs 1024 --steps 10 -o batch/

Steps through synthetic depth of that many environments, (1024, 60, 106) float32 metres: torch tensors if torch is installed,
otherwise NumPy arrays. The sensor reads them without a copy, by DLPack, and writes to `out`. The noise of steps and environments
is independent; the same seed and step give the same noise.

In Isaac Lab, `OakDepth` below is a modifier of an observation term of a TiledCamera or a RayCasterCamera:

    from isaaclab.envs import mdp
    from isaaclab.managers import ObservationTermCfg, SceneEntityCfg
    from isaaclab.utils.modifiers import ModifierCfg

    depth = ObservationTermCfg(
        func=mdp.image,
        params={
            "sensor_cfg": SceneEntityCfg("tiled_camera"),
            "data_type": "distance_to_image_plane",  # z, as required by the sensor; not distance_to_camera
            "normalize": False,  # keeps inf for misses
        },
        modifiers=[ModifierCfg(func=OakDepth, params={"model": "OAK4-D", "hfov_deg": 77.0, "seed": 7})],
    )

with a camera whose PinholeCameraCfg(focal_length=..., horizontal_aperture=...) has the same field of view (printed by this
script). Isaac Lab itself was not run; names are from version 2. GPU tensors are copied to the CPU and back.
"""

import argparse
import time
from importlib.util import find_spec
from pathlib import Path

import numpy as np

import oaktwin

try:
    import torch
except ImportError:
    torch = None
try:
    from isaaclab.utils.modifiers import ModifierBase
except ImportError:
    ModifierBase = object


class OakDepth(ModifierBase):
    """A modifier of Isaac Lab: ground-truth depth (N, H, W, 1) in, an OAK's depth out, 0 where invalid.

    cfg.params: "model"; "hfov_deg", the images' field of view; "seed".
    """

    def __init__(self, cfg, data_dim, device="cpu"):
        self._cfg, self._data_dim, self._device = cfg, data_dim, device
        options = {"model": "OAK4-D", "hfov_deg": None, "seed": 0, **cfg.params}
        oak = oaktwin.Device(options["model"])
        self._sensor = oaktwin.DepthSensor(oak, hfov_deg=options["hfov_deg"], seed=options["seed"])
        self._step = 0
        # Has the images' size; created in the first call.
        self._exact = self._measured = None

    def reset(self, env_ids=None):
        """Does nothing: the noise depends only on the step."""

    def __call__(self, data):
        images = data.squeeze(-1)
        if self._measured is None:
            # Copies between pinned memory and the GPU are fast.
            self._measured = torch.empty(images.shape, pin_memory=data.is_cuda)
            self._exact = torch.empty_like(self._measured, pin_memory=True) if data.is_cuda else None
        exact = self._exact.copy_(images) if data.is_cuda else images.contiguous()
        self._sensor(exact, frame=self._step, out=self._measured)
        self._step += 1
        # Isaac Lab passes a separate copy to modifiers.
        return images.copy_(self._measured).unsqueeze(-1)


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
        for away in random.uniform(1, 4, 2):
            front = away / (cosine - y * sine)
            rows = (front * down > 0.6 - random.uniform(0.3, 0.7)) & (front * down < 0.6)
            left = random.integers(0, width)
            face = image[rows, left : left + round(focal * 0.5 / away)]
            image[rows, left : left + round(focal * 0.5 / away)] = np.minimum(face, front[rows, None])
    return depth


def picture(path: Path, exact: np.ndarray, measured: np.ndarray) -> None:
    """Plots ground-truth depth, measured depth and error of several environments."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    rows = min(4, len(exact))
    figure, axes = plt.subplots(3, rows + 1, figsize=(2.4 * rows + 0.9, 4.4), layout="constrained",
                                width_ratios=[1.0] * rows + [0.05])  # fmt: skip
    colours, diverging = plt.get_cmap("turbo").copy(), plt.get_cmap("RdBu").copy()
    colours.set_bad("black")
    diverging.set_bad("black")
    for env in range(rows):
        both = np.isfinite(exact[env]) & (measured[env] > 0)
        shown = [
            np.where(np.isfinite(exact[env]), exact[env], np.nan),
            np.where(measured[env] > 0, measured[env], np.nan),
            np.where(both, 1000 * (measured[env] - exact[env]), np.nan),
        ]
        drawn = [
            axes[0, env].imshow(shown[0], colours, vmin=0.5, vmax=6),
            axes[1, env].imshow(shown[1], colours, vmin=0.5, vmax=6),
            axes[2, env].imshow(shown[2], diverging, vmin=-40, vmax=40),
        ]
        axes[0, env].set_title(f"environment {env}", fontsize=10)
        for place in axes[:, env]:
            place.set(xticks=[], yticks=[])
    for place, name in zip(axes[:, 0], ["exact", "OAK", "error"]):
        place.set_ylabel(name)
    for place, image, name in zip(axes[:, -1], drawn, ["depth [m]", "depth [m]", "error [mm]"]):
        figure.colorbar(image, cax=place, label=name)
    figure.savefig(path, dpi=100)


def main() -> None:
    parser = argparse.ArgumentParser(description="OAK depth for many environments at once.")
    parser.add_argument("--envs", type=int, default=1024)
    parser.add_argument("--steps", type=int, default=10)
    parser.add_argument("--size", type=int, nargs=2, default=[106, 60], metavar=("WIDTH", "HEIGHT"))
    parser.add_argument("--model", default="OAK4-D", help="one of oaktwin.models()")
    parser.add_argument("--seed", type=int, default=7)
    parser.add_argument("--numpy", action="store_true", help="use NumPy arrays even if torch is installed")
    parser.add_argument("-o", "--output", type=Path, help="folder for batch.npz (of the first environments) and batch.png")
    options = parser.parse_args()
    width, height = options.size
    uses_torch = torch is not None and not options.numpy

    device = oaktwin.Device(options.model)
    hfov = device.depth_camera().hfov_deg
    print(f"{options.model}: PinholeCameraCfg(focal_length=24.0, horizontal_aperture={48 * np.tan(np.radians(hfov) / 2):.4f})")

    there = made_up_depth(options.envs, height, width, hfov)
    depth, out = there.copy(), np.empty_like(there)
    if uses_torch:
        there, depth, out = (torch.from_numpy(array) for array in (there, depth, out))
    print(f"{tuple(depth.shape)} of {type(depth).__module__.split('.')[0]}")

    sensor = oaktwin.DepthSensor(device, hfov_deg=hfov, seed=options.seed)
    times = []
    for step in range(options.steps):
        depth[:] = there * (1 - 0.01 * step)  # the simulator's step: everything approaches

        began = time.perf_counter()
        sensor(depth, frame=step, out=out)  # <- the noise hook
        times.append(time.perf_counter() - began)

        measured = float((out > 0).sum()) / (options.envs * height * width)
        print(f"step {step}: {1000 * times[-1]:.1f} ms, {100 * measured:.2f} % measured")
    median = float(np.median(times))
    rate = options.envs / median
    print(f"median {1000 * median:.1f} ms a step: {rate:.0f} images/s, {rate * height * width / 1e6:.0f} Mpx/s")

    if uses_torch:
        # Like a call by Isaac Lab: with a last axis of one channel, and a separate copy.
        cfg = argparse.Namespace(params={"model": options.model, "hfov_deg": hfov, "seed": options.seed})
        modifier = OakDepth(cfg, (*depth.shape, 1))
        for step in range(options.steps):
            observed = modifier((there * (1 - 0.01 * step)).unsqueeze(-1))
        print(f"as a modifier: {'the same' if torch.equal(observed.squeeze(-1), out) else 'NOT the same'}")

    if options.output:
        options.output.mkdir(parents=True, exist_ok=True)
        exact, measured = np.asarray(depth)[:16], np.asarray(out)[:16]
        np.savez_compressed(options.output / "batch.npz", exact=exact, measured=measured, frame=options.steps - 1)
        if find_spec("matplotlib"):
            picture(options.output / "batch.png", exact, measured)
        print(f"wrote {options.output}")


if __name__ == "__main__":
    main()
