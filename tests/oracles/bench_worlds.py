"""Depth of many worlds at once, compared with MuJoCo's renderer and rays and with Open3D's, in turns.

Run by `cargo xtask bench worlds`. A robot of four legs stands on a height field, its joints differ in each world, and a camera on its head
looks down. The time contains moving the links and the images of all worlds. Peers render a few of the worlds, one after another.
"""

import os
import statistics
import sys
import time

# MuJoCo chooses its OpenGL when it is imported.
os.environ.setdefault("MUJOCO_GL", "egl")

import mujoco  # noqa: E402
import numpy as np  # noqa: E402

import oaktwin  # noqa: E402
import oaktwin.mujoco  # noqa: E402
from oaktwin import _mujoco_shapes as shapes  # noqa: E402


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


def poses_of(positions, rotations):
    """The camera on the head of each robot, which looks down by 40 degrees."""
    tilt = np.radians(40)
    forward, right = np.array([np.cos(tilt), 0, -np.sin(tilt)]), np.array([0, -1, 0])
    axes = np.stack([right, np.cross(forward, right), forward], 1)
    poses = np.tile(np.eye(4), (len(positions), 1, 1))
    poses[:, :3, :3] = rotations @ axes
    poses[:, :3, 3] = positions + rotations @ np.array([0.3, 0, 0.02])
    return poses


class Case:
    def __init__(self, count, width, height):
        self.model = mujoco.MjModel.from_xml_string(MODEL)
        rng = np.random.default_rng(0)
        x, y = np.meshgrid(np.linspace(0, 9, 64), np.linspace(0, 7, 64))
        self.model.hfield_data[:] = (0.5 + 0.25 * np.sin(x) * np.cos(y) + 0.1 * rng.uniform(-1, 1, x.shape)).ravel()
        self.camera = oaktwin.Camera((width, height), hfov_deg=80)
        self.count, self.data = count, mujoco.MjData(self.model)
        qpos = np.tile(self.model.qpos0, (count, 1))
        qpos[:, :2] += rng.uniform(-2, 2, (count, 2))
        qpos[:, 7:] = rng.uniform(-0.6, 0.6, (count, qpos.shape[1] - 7))
        self.qpos = qpos
        trunk = self.model.body("trunk").id
        states = []
        for own in qpos:
            self.data.qpos[:] = own
            mujoco.mj_kinematics(self.model, self.data)
            states.append((self.data.geom_xpos.copy(), self.data.geom_xmat.copy(), self.data.xpos[trunk].copy(), self.data.xmat[trunk].copy()))
        self.geom_xpos, self.geom_xmat, positions, rotations = map(np.array, zip(*states))
        self.views = poses_of(positions, rotations.reshape(-1, 3, 3))
        self.worlds = oaktwin.mujoco.Worlds(self.model, count)
        self.out = np.empty((count, height, width), np.float32)

    def ours(self, backend="auto"):
        self.worlds.update(geom_xpos=self.geom_xpos, geom_xmat=self.geom_xmat)
        return self.worlds.render(self.camera, self.views, backend=backend, out=self.out)

    def rays(self):
        """MuJoCo's ray caster, which shows the exact shapes."""
        directions = np.ascontiguousarray(self.camera.rays().reshape(-1, 3), np.float64)
        along = directions[:, 2]
        depth = np.empty((FEW, len(along)))
        geom, distance = np.empty(len(along), np.int32), np.empty(len(along))
        for number in range(FEW):
            self.data.qpos[:] = self.qpos[number]
            mujoco.mj_kinematics(self.model, self.data)
            turned = np.ascontiguousarray(directions @ self.views[number, :3, :3].T).ravel()
            start = np.ascontiguousarray(self.views[number, :3, 3])
            mujoco.mj_multiRay(self.model, self.data, start, turned, None, True, -1, geom, distance, None, len(along), 1e10)
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
        all_shapes = (shapes.shape_of(self.model, geom) for geom in range(self.model.ngeom))
        return {geom: (vertices, np.asarray(faces, np.uint32)) for geom, (vertices, faces) in enumerate(all_shapes)}

    def renderer(self):
        """MuJoCo's renderer, with OpenGL."""
        height, width = self.out.shape[1:]
        if not hasattr(self, "gl"):
            self.gl = mujoco.Renderer(self.model, height, width)
            self.gl.enable_depth_rendering()
        view = mujoco.MjvCamera()
        for number in range(FEW):
            self.data.qpos[:] = self.qpos[number]
            mujoco.mj_kinematics(self.model, self.data)
            view.lookat[:] = self.views[number, :3, 3]
            view.distance = 0.01
            self.gl.update_scene(self.data, view)
            self.gl.render()


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


def main():
    least_s = float(sys.argv[1]) if len(sys.argv) > 1 else 1.0
    print(f"{os.cpu_count()} processors; images per second, moving the links included")
    for width, height in ((64, 64), (106, 60)):
        for count in (256, 4096):
            case = Case(count, width, height)
            ours, exact = case.ours(), case.rays()
            both = np.isfinite(exact) & np.isfinite(ours[:FEW])
            errors = np.abs(ours[:FEW][both] - exact[both])
            own = rate(case.ours, count, least_s)
            print(f"\n{count} worlds of {width}x{height}; {np.mean(errors < 0.01):.2%} within 1 cm of MuJoCo's rays, median {np.median(errors):.1e} m")
            print(f"  oaktwin          {own:9.0f}")
            for backend in ("raster", "ray"):
                print(f"    {backend:14} {rate(lambda: case.ours(backend), count, least_s):9.0f}")
            for name, call in (("MuJoCo, rays", case.rays), ("MuJoCo, OpenGL", case.renderer), ("Open3D", case.open3d)):
                try:
                    call()
                except Exception as error:  # A peer that is missing, or a machine without OpenGL.
                    print(f"  {name:16} {type(error).__name__}: {str(error).splitlines()[0][:80] if str(error) else ''}")
                    continue
                peer = rate(call, FEW, least_s)
                print(f"  {name:16} {peer:9.0f}   {own / peer:6.1f} x")


if __name__ == "__main__":
    main()
