"""An OAK above a table in MuJoCo: ground-truth depth in, the depth that the camera would measure out.

    pip install mujoco matplotlib
    python examples/python/mujoco_table.py -o table/

MuJoCo renders off screen with its own OpenGL renderer, or by ray casting if no OpenGL context is available
(`--renderer rays`). Writes frames.npz (ground-truth and measured depth, colour, the camera) and table.png.
"""

import argparse
import os
import sys
from collections.abc import Callable
from importlib.util import find_spec
from pathlib import Path

import numpy as np

import oaktwin

# Renders without a window, by EGL unless configured otherwise. Must be set before MuJoCo is imported.
if sys.platform == "linux":
    os.environ.setdefault("MUJOCO_GL", "egl")
try:
    import mujoco
except AttributeError:  # the OpenGL library in MUJOCO_GL is not installed
    os.environ["MUJOCO_GL"] = "off"
    import mujoco

EYE, TARGET = (0.8, -0.62, 0.78), (-0.01, 0.0, 0.03)
STEPS_PER_FRAME = 40  # of 2.5 ms each
View = Callable[[mujoco.MjData], tuple[np.ndarray, np.ndarray]]

SCENE = """
<mujoco>
  <option timestep="0.0025"/>
  <statistic extent="1" center="0 0 0"/>
  <visual>
    <global offwidth="{width}" offheight="{height}"/>
    <quality shadowsize="2048"/>
    <map znear="0.05" zfar="30"/>
    <headlight ambient="0.5 0.5 0.5" diffuse="0.3 0.3 0.3" specular="0 0 0"/>
  </visual>
  <asset>
    <!-- Random marks: stereo needs texture. -->
    <texture type="skybox" builtin="gradient" rgb1="0.75 0.82 0.9" rgb2="0.9 0.92 0.95" width="64" height="64"/>
    <texture name="wood" type="2d" builtin="checker" rgb1="1 1 1" rgb2="0.93 0.9 0.88" mark="random"
             markrgb="0.6 0.5 0.45" random="0.25" width="160" height="160"/>
    <texture name="floor" type="2d" builtin="checker" rgb1="1 1 1" rgb2="0.85 0.85 0.85" mark="random"
             markrgb="0.7 0.7 0.7" random="0.1" width="160" height="160"/>
    <texture name="speckled" type="cube" builtin="flat" rgb1="1 1 1" mark="random" markrgb="0.35 0.35 0.35"
             random="0.2" width="32" height="32"/>
    <material name="wood" texture="wood" texrepeat="2 2" rgba="0.8 0.6 0.42 1" specular="0.1"/>
    <material name="floor" texture="floor" texrepeat="2 2" texuniform="true" rgba="0.62 0.66 0.7 1"/>
    <material name="red" texture="speckled" rgba="0.85 0.25 0.2 1"/>
    <material name="green" texture="speckled" rgba="0.3 0.7 0.35 1"/>
    <material name="blue" texture="speckled" rgba="0.25 0.45 0.85 1"/>
    <material name="yellow" texture="speckled" rgba="0.95 0.75 0.2 1"/>
    <material name="plain" rgba="0.9 0.9 0.92 1"/>
  </asset>
  <worldbody>
    <light pos="0.6 -0.6 2.2" dir="-0.3 0.3 -1" diffuse="0.55 0.55 0.55" castshadow="true"/>
    <geom name="floor" type="plane" size="3 3 0.1" pos="0 0 -0.75" material="floor"/>
    <geom name="table" type="box" size="0.6 0.45 0.02" pos="0 0 -0.02" material="wood"/>
    <geom name="marker" type="sphere" size="0.02" pos="0.4 0.3 0.02" rgba="0.9 0 0.9 1"/>
    <camera name="oak" pos="{position}" xyaxes="{xyaxes}" fovy="{fovy}"/>
    <body pos="-0.25 0.2 0">
      <geom type="cylinder" size="0.07 0.03" pos="0 0 0.03" material="plain"/>
      <body pos="0 0 0.06">
        <joint name="turn" axis="0 0 1" damping="2"/>
        <geom type="capsule" size="0.035" fromto="0 0 0 0 0 0.3" material="plain"/>
        <body pos="0 0 0.3">
          <joint name="lift" axis="0 1 0" damping="2"/>
          <geom type="capsule" size="0.03" fromto="0 0 0 0.32 0 0.06" material="blue"/>
          <geom type="box" size="0.02 0.06 0.04" pos="0.35 0 0.02" material="plain"/>
        </body>
      </body>
    </body>
    <body pos="0.2 -0.05 0.35"><freejoint/><geom name="ball" type="sphere" size="0.06" material="red" mass="0.2"/></body>
    <body pos="0.05 -0.25 0.3" euler="30 20 10"><freejoint/>
      <geom type="box" size="0.08 0.05 0.05" material="yellow" mass="0.3"/></body>
    <body pos="0.33 -0.3 0.25" euler="70 0 0"><freejoint/>
      <geom type="cylinder" size="0.04 0.08" material="green" mass="0.2"/></body>
  </worldbody>
  <actuator>
    <position joint="turn" kp="60"/>
    <position joint="lift" kp="60"/>
  </actuator>
</mujoco>
"""


def table_scene(camera: oaktwin.Camera, world_from_camera: np.ndarray) -> mujoco.MjModel:
    """The scene with a MuJoCo camera equivalent to `camera`."""

    def text(*numbers: float) -> str:
        return " ".join(f"{number:.12g}" for number in numbers)

    # MuJoCo's camera faces along its -z axis with y up, OpenCV's along +z with y down. Its only field of view is the
    # vertical one in degrees, centred on the image.
    x, y = world_from_camera[:3, 0], world_from_camera[:3, 1]
    scene = SCENE.format(
        width=camera.width,
        height=camera.height,
        position=text(*world_from_camera[:3, 3]),
        xyaxes=text(*x, *-y),
        fovy=text(camera.vfov_deg),
    )
    return mujoco.MjModel.from_xml_string(scene)


def opengl_view(model: mujoco.MjModel, camera: oaktwin.Camera) -> View:
    """Renders depth (H, W), metres along the axis, inf for a miss, and colour (H, W, 3), with MuJoCo's renderer."""
    renderer = mujoco.Renderer(model, camera.height, camera.width)
    far = model.vis.map.zfar * model.stat.extent

    def view(data: mujoco.MjData) -> tuple[np.ndarray, np.ndarray]:
        renderer.update_scene(data, "oak")
        rgb = renderer.render().copy()
        renderer.enable_depth_rendering()
        depth = renderer.render().copy()
        renderer.disable_depth_rendering()
        # For a miss MuJoCo returns the distance of the far plane.
        depth[depth >= 0.999 * far] = np.inf
        return depth, rgb

    return view


def ray_view(model: mujoco.MjModel, camera: oaktwin.Camera) -> View:
    """Renders the same by ray casting; the colours of geoms are shaded, without textures."""
    # Rays through pixel centres in MuJoCo's camera, scaled to 1 along the axis, so that distances are depth.
    x, y = np.meshgrid(np.arange(camera.width), np.arange(camera.height))
    k = camera.K
    rays = np.stack([(x - k[0, 2]) / k[0, 0], (k[1, 2] - y) / k[1, 1], -np.ones_like(x)], -1).reshape(-1, 3)
    own = np.where(model.geom_matid >= 0, model.geom_matid, 0)
    colour = np.where((model.geom_matid >= 0)[:, None], model.mat_rgba[own], model.geom_rgba)[:, :3]

    def view(data: mujoco.MjData) -> tuple[np.ndarray, np.ndarray]:
        seen_from = data.camera("oak")
        vec = rays @ seen_from.xmat.reshape(3, 3).T
        geom, distance, normal = np.empty(len(vec), np.int32), np.empty(len(vec)), np.empty((len(vec), 3))
        mujoco.mj_multiRay(
            model, data, pnt=seen_from.xpos, vec=vec.ravel(), geomgroup=None, flg_static=True, bodyexclude=-1,
            geomid=geom, dist=distance, normal=normal.ravel(), nray=len(vec), cutoff=mujoco.mjMAXVAL,
        )  # fmt: skip
        hit = geom >= 0
        depth = np.where(hit, distance, np.inf).astype(np.float32)
        facing = np.abs((normal * vec).sum(1)) / np.linalg.norm(vec, axis=1)
        rgb = np.where(hit[:, None], 255 * colour[geom] * (0.35 + 0.65 * facing[:, None]), 30).astype(np.uint8)
        size = camera.height, camera.width
        return depth.reshape(size), rgb.reshape(*size, 3)

    return view


def choose_view(asked: str, model: mujoco.MjModel, camera: oaktwin.Camera) -> tuple[str, View]:
    """Returns the requested renderer; `auto` is OpenGL if available, otherwise ray casting."""
    if asked != "rays":
        try:
            return f"OpenGL ({os.environ.get('MUJOCO_GL') or 'default'})", opengl_view(model, camera)
        except (ImportError, AttributeError, RuntimeError, mujoco.FatalError) as error:
            if asked == "gl":
                raise SystemExit(f"no OpenGL context ({error}); use --renderer rays") from error
            reason = str(error).splitlines()[0][:80]
            print(f"no OpenGL context ({reason}): MuJoCo's ray casting serves, colour has no textures")
    return "ray casting", ray_view(model, camera)


def picture(path: Path, frames: dict[str, np.ndarray], shown: list[int]) -> None:
    """Plots colour, ground-truth depth, measured depth and its error, one row per frame."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    titles = "what the camera sees", "exact depth", "OAK depth", "error"
    figure, axes = plt.subplots(len(shown) + 1, 4, figsize=(12, 2.0 * len(shown) + 0.6), layout="constrained",
                                height_ratios=[1.0] * len(shown) + [0.07])  # fmt: skip
    near, far = np.percentile(frames["exact"][np.isfinite(frames["exact"])], [0.5, 90])
    depth_colours, error_colours = plt.get_cmap("turbo").copy(), plt.get_cmap("RdBu").copy()
    depth_colours.set_bad("black")
    error_colours.set_bad("black")
    for row, frame in zip(axes, shown):
        exact, measured = frames["exact"][frame], frames["measured"][frame]
        both = np.isfinite(exact) & (measured > 0)
        error = np.where(both, 1000 * (measured - exact), np.nan)
        row[0].imshow(frames["rgb"][frame])
        depths = row[1].imshow(np.where(np.isfinite(exact), exact, np.nan), depth_colours, vmin=near, vmax=far)
        row[2].imshow(np.where(measured > 0, measured, np.nan), depth_colours, vmin=near, vmax=far)
        errors = row[3].imshow(error, error_colours, vmin=-10, vmax=10)
        row[0].set_ylabel(f"at {frames['time'][frame]:.1f} s")
        for place in row:
            place.set(xticks=[], yticks=[])
    for place, title in zip(axes[0], titles):
        place.set_title(title, fontsize=11, pad=5)
    for place in axes[-1]:
        place.set_axis_off()
    figure.colorbar(depths, cax=figure.add_subplot(axes[0, 0].get_gridspec()[-1, 1:3]), orientation="horizontal",
                    label="depth [m]; black: no surface, or not measured")  # fmt: skip
    figure.colorbar(errors, cax=figure.add_subplot(axes[0, 0].get_gridspec()[-1, 3]), orientation="horizontal",
                    label="measured - exact [mm]")  # fmt: skip
    figure.savefig(path, dpi=100)


def main() -> None:
    parser = argparse.ArgumentParser(description="An OAK above a table in MuJoCo.")
    parser.add_argument("-o", "--output", type=Path, default=Path("mujoco-table"), help="folder for frames.npz and table.png")
    parser.add_argument("--model", default="OAK4-D", help="one of oaktwin.models()")
    parser.add_argument("--frames", type=int, default=8, help="number of frames, a tenth of a second apart")
    parser.add_argument("--width", type=int, default=640, help="width of the images, px")
    parser.add_argument("--renderer", choices=["auto", "gl", "rays"], default="auto")
    parser.add_argument("--seed", type=int, default=7, help="noise seed")
    options = parser.parse_args()

    device = oaktwin.Device(options.model)
    own = device.depth_camera()
    # The OAK's field of view in a smaller image, centred like MuJoCo's cameras. (`own.resized` would follow DepthAI and shift
    # the principal point a quarter of a pixel from the centre.)
    size = options.width, round(options.width * own.height / own.width)
    camera = oaktwin.Camera(size, hfov_deg=own.hfov_deg)
    model = table_scene(camera, oaktwin.look_at(EYE, TARGET))
    data = mujoco.MjData(model)
    renderer, view = choose_view(options.renderer, model, camera)
    print(f"{options.model} {camera.width}x{camera.height}, fx {camera.K[0, 0]:.2f} px, fovy {camera.vfov_deg:.3f} deg")
    print(f"rendered by {renderer}")

    oak = oaktwin.DepthSensor(device, seed=options.seed, fx=camera.K[0, 0])
    frames: dict[str, list] = {"time": [], "rgb": [], "exact": [], "measured": []}
    for frame in range(options.frames):
        data.ctrl[:] = -0.9 + 0.2 * frame, 0.5 * np.sin(0.6 * frame)
        mujoco.mj_step(model, data, nstep=STEPS_PER_FRAME if frame else 1)
        depth, rgb = view(data)

        measured = oak(depth, frame=frame)  # <- the one line: an OAK's depth instead of the ground truth

        for name, value in zip(frames, (data.time, rgb, depth, measured)):
            frames[name].append(value)
        both = np.isfinite(depth) & (measured > 0)
        error = 1000 * np.abs(measured[both] - depth[both])
        print(f"frame {frame}: {100 * both.mean():.1f} % measured, median error {np.median(error):.2f} mm")

    options.output.mkdir(parents=True, exist_ok=True)
    arrays = {name: np.array(values) for name, values in frames.items()}
    pose = oaktwin.look_at(EYE, TARGET)
    np.savez_compressed(options.output / "frames.npz", K=camera.K, world_from_camera=pose, **arrays)
    if find_spec("matplotlib"):
        picture(options.output / "table.png", arrays, sorted({0, options.frames // 2, options.frames - 1}))
    print(f"wrote {options.output}")


if __name__ == "__main__":
    main()
