"""Depth of many worlds at once, compared with the renderers of MuJoCo, mujoco_warp and Newton, MuJoCo's rays and Open3D's, in turns.

Run by `cargo xtask bench worlds`. A robot stands on a height field, its joints differ in each world, and a camera on its head looks down: a Go1 of the
package mjlab if it is installed, otherwise a robot of four legs made of simple shapes. The time contains moving the links and the images of all
worlds. Peers render a few of the worlds, those of MuJoCo and Open3D one after another.
"""

import importlib.util
import os
import statistics
import sys
import time
from pathlib import Path

# MuJoCo chooses its OpenGL when it is imported.
os.environ.setdefault("MUJOCO_GL", "egl")

import mujoco  # noqa: E402
import numpy as np  # noqa: E402

import oaktwin  # noqa: E402
import oaktwin.mujoco  # noqa: E402
from oaktwin import _mujoco_shapes as shapes  # noqa: E402
from bench_worlds_warp import PEERS  # noqa: E402


LEG = """
<body pos="{x} {y} 0">
  <joint type="hinge" axis="1 0 0"/><geom type="sphere" size="0.06"/>
  <body pos="0 0 -0.02">
    <joint type="hinge" axis="0 1 0"/><geom type="capsule" size="0.03" fromto="0 0 0 -0.05 0 -0.2"/>
    <body pos="-0.05 0 -0.2"><joint type="hinge" axis="0 1 0"/><geom type="capsule" size="0.02" fromto="0 0 0 0.05 0 -0.2"/></body>
  </body>
</body>
"""
MODEL = f"""
<mujoco>
  <asset><hfield name="ground" nrow="64" ncol="64" size="4 4 0.15 0.1"/></asset>
  <worldbody>
    <geom type="hfield" hfield="ground"/>
    <body name="trunk" pos="0 0 0.55">
      <freejoint/>
      <geom type="box" size="0.2 0.1 0.06"/><geom type="box" size="0.05 0.05 0.05" pos="0.23 0 0.02"/>
      {"".join(LEG.format(x=x, y=y) for x in (-0.18, 0.18) for y in (-0.12, 0.12))}
    </body>
  </worldbody>
</mujoco>
"""
# The peers render so many worlds.
FEW = 32


def go1():
    """The Go1 of the package mjlab on the same ground, or None."""
    package = importlib.util.find_spec("mjlab")
    if package is None:
        return None
    folder = Path(package.submodule_search_locations[0]) / "asset_zoo/robots/unitree_go1/xmls"
    spec = mujoco.MjSpec.from_file(str(folder / "go1.xml"))
    spec.meshdir = str(folder / "assets")
    spec.add_hfield(name="ground", nrow=64, ncol=64, size=[4, 4, 0.15, 0.1], userdata=np.zeros(64 * 64))
    spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_HFIELD, hfieldname="ground")
    return spec


def model_of(name, width, height):
    """The robot on its ground, with a camera on its head that looks down by 40 degrees."""
    spec = mujoco.MjSpec.from_string(MODEL) if name == "legs" else go1()
    if spec is None:
        return None
    tilt = np.radians(40)
    forward, right = np.array([np.cos(tilt), 0, -np.sin(tilt)]), np.array([0, -1, 0])
    fovy = 2 * np.degrees(np.arctan(np.tan(np.radians(40)) * height / width))
    axes = [*right, *np.cross(right, forward)]
    spec.body("trunk").add_camera(name="head", pos=[0.3, 0, 0.02], xyaxes=axes, fovy=fovy)
    return spec.compile()


class Case:
    def __init__(self, name, count, width, height):
        self.model = model_of(name, width, height)
        rng = np.random.default_rng(0)
        x, y = np.meshgrid(np.linspace(0, 9, 64), np.linspace(0, 7, 64))
        self.model.hfield_data[:] = (0.5 + 0.25 * np.sin(x) * np.cos(y) + 0.1 * rng.uniform(-1, 1, x.shape)).ravel()
        self.count, self.data = count, mujoco.MjData(self.model)
        qpos = np.tile(self.model.qpos0, (count, 1))
        qpos[:, :2] += rng.uniform(-2, 2, (count, 2))
        qpos[:, 7:] = rng.uniform(-0.6, 0.6, (count, qpos.shape[1] - 7))
        self.qpos = qpos
        states = []
        for own in qpos:
            self.data.qpos[:] = own
            mujoco.mj_kinematics(self.model, self.data)
            mujoco.mj_comPos(self.model, self.data)
            mujoco.mj_camlight(self.model, self.data)
            states.append([getattr(self.data, f"{kind}_{part}").copy() for kind in ("geom", "cam") for part in ("xpos", "xmat")])
        self.geom_xpos, self.geom_xmat, self.cam_xpos, self.cam_xmat = map(np.array, zip(*states))
        self.worlds = oaktwin.mujoco.Worlds(self.model, count)
        self.update()
        self.camera, head = self.worlds.camera("head", (width, height)), self.model.camera("head").id
        self.views = self.worlds.camera_poses[:, head]
        self.out = np.empty((count, height, width), np.float32)

    def update(self):
        self.worlds.update(geom_xpos=self.geom_xpos, geom_xmat=self.geom_xmat, cam_xpos=self.cam_xpos, cam_xmat=self.cam_xmat)

    def ours(self, backend="auto"):
        self.update()
        return self.worlds.render(self.camera, self.views, backend=backend, out=self.out)

    def rays(self):
        """MuJoCo's ray caster, which shows the exact shapes."""
        self.groups = np.array([1, 1, 1, 0, 0, 0], np.uint8)
        directions = np.ascontiguousarray(self.camera.rays().reshape(-1, 3), np.float64)
        along = directions[:, 2]
        depth = np.empty((FEW, len(along)))
        geom, distance = np.empty(len(along), np.int32), np.empty(len(along))
        for number in range(FEW):
            self.data.qpos[:] = self.qpos[number]
            mujoco.mj_kinematics(self.model, self.data)
            turned = np.ascontiguousarray(directions @ self.views[number, :3, :3].T).ravel()
            start = np.ascontiguousarray(self.views[number, :3, 3])
            mujoco.mj_multiRay(self.model, self.data, start, turned, self.groups, True, -1, geom, distance, None, len(along), 1e10)
            depth[number] = np.where(distance < 0, np.inf, distance * along)
        return depth.reshape(FEW, *self.out.shape[1:])

    def open3d(self):
        """Open3D's ray caster, whose scene is made for each world, because its meshes cannot be moved."""
        from open3d_import import open3d

        o3d = open3d()
        rays = self.camera.rays().astype(np.float32)
        meshes = self.meshes()
        depth = np.empty((FEW, *self.out.shape[1:]), np.float32)
        for number in range(FEW):
            scene = o3d.t.geometry.RaycastingScene()
            for geom, (vertices, faces) in meshes.items():
                rotation = self.geom_xmat[number, geom].reshape(3, 3)
                placed = (vertices @ rotation.T + self.geom_xpos[number, geom]).astype(np.float32)
                scene.add_triangles(o3d.core.Tensor(placed), o3d.core.Tensor(faces))
            view = self.views[number]
            turned = rays @ view[:3, :3].T.astype(np.float32)
            both = np.concatenate([np.broadcast_to(view[:3, 3].astype(np.float32), turned.shape), turned], -1)
            depth[number] = scene.cast_rays(o3d.core.Tensor(np.ascontiguousarray(both)))["t_hit"].numpy() * rays[..., 2]
        return depth

    def meshes(self):
        """The vertices and faces of the geoms, the same as ours."""
        shown = (geom for geom in range(self.model.ngeom) if not isinstance(shapes.mesh_of(self.model, geom), (str, type(None))))
        all_shapes = ((geom, shapes.shape_of(self.model, geom)) for geom in shown)
        return {geom: (vertices, np.asarray(faces, np.uint32)) for geom, (vertices, faces) in all_shapes}

    def renderer(self):
        """MuJoCo's renderer, with OpenGL."""
        height, width = self.out.shape[1:]
        if not hasattr(self, "gl"):
            self.gl = mujoco.Renderer(self.model, height, width)
            self.gl.enable_depth_rendering()
        depth = np.empty((FEW, height, width), np.float32)
        for number in range(FEW):
            self.data.qpos[:] = self.qpos[number]
            mujoco.mj_kinematics(self.model, self.data)
            mujoco.mj_comPos(self.model, self.data)
            mujoco.mj_camlight(self.model, self.data)
            self.gl.update_scene(self.data, "head")
            depth[number] = self.gl.render()
        return depth


def rate(call, images, least_s=1.0):
    """Images per second: the median of three rounds of at least this time."""
    rates = []
    for _ in range(3):
        calls, start = 0, time.perf_counter()
        while (spent := time.perf_counter() - start) < least_s or calls == 0:
            call()
            calls += 1
        rates.append(images * calls / spent)
    return statistics.median(rates)


def agreement(depth, exact):
    """How much of what both see agrees."""
    both = np.isfinite(exact) & np.isfinite(depth) & (depth < 1e3)
    errors = np.abs(depth[both] - exact[both])
    return f"{np.mean(errors < 0.01):7.2%} within 1 cm of MuJoCo's rays, median {np.median(errors):.1e} m"


def main():
    least_s = float(sys.argv[1]) if len(sys.argv) > 1 else 1.0
    print(f"{os.cpu_count()} processors; images per second, moving the links included")
    robots = ["legs", "Go1"] if go1() is not None else ["legs"]
    if len(robots) == 1:
        print("Go1: skipped, because mjlab is not installed, whose robot it is")
    for name, (width, height), count in ((name, size, count) for name in robots for size in ((64, 64), (106, 60)) for count in (256, 4096)):
        case = Case(name, count, width, height)
        ours, exact = case.ours(), case.rays()
        own = rate(case.ours, count, least_s)
        print(f"\n{name}: {count} worlds of {width}x{height}")
        print(f"  {'oaktwin':20} {own:9.0f}            {agreement(ours[:FEW], exact)}")
        for backend in ("raster", "ray"):
            print(f"    {backend:18} {rate(lambda: case.ours(backend), count, least_s):9.0f}")
        peers = [("MuJoCo, rays", lambda _: case.rays), ("MuJoCo, OpenGL", lambda _: case.renderer), ("Open3D", lambda _: case.open3d), *PEERS]
        for peer, make in peers:
            try:
                call = make(case)
                shown = call()
            except Exception as error:  # A peer that is missing, or a machine without OpenGL.
                print(f"  {peer:20} {type(error).__name__}: {str(error).splitlines()[0][:80] if str(error) else ''}")
                continue
            speed = rate(call, len(shown), least_s)
            print(f"  {peer:20} {speed:9.0f}   {own / speed:6.1f} x {agreement(shown, exact[: len(shown)])}")


if __name__ == "__main__":
    main()
