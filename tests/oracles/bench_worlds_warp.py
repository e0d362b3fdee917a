"""The renderers of mujoco_warp and Newton on Warp's CPU device, as peers of `bench_worlds.py`. They render a few worlds in one call."""

import numpy as np

# The worlds that they render.
FEW = 32


def mujoco_warp(case):
    """mujoco_warp's ray tracer, which moves the links itself."""
    import mujoco_warp as mjw
    import warp as wp

    height, width = case.out.shape[1:]
    with wp.ScopedDevice("cpu"):
        model, data = mjw.put_model(case.model), mjw.make_data(case.model, nworld=FEW)
        active = [case.model.camera(number).name == "head" for number in range(case.model.ncam)]
        context = mjw.create_render_context(
            case.model, nworld=FEW, cam_res=(width, height), render_rgb=False, render_depth=True, use_shadows=False, cam_active=active
        )
        qpos = wp.array(case.qpos[:FEW].astype(np.float32), dtype=float)

    def render():
        with wp.ScopedDevice("cpu"):
            wp.copy(data.qpos, qpos)
            mjw.kinematics(model, data)
            mjw.com_pos(model, data)
            mjw.camlight(model, data)
            mjw.refit_bvh(model, data, context)
            mjw.render(model, data, context)
            depth = context.depth_data.numpy().reshape(FEW, height, width)
        return np.where(depth > 0, depth, np.inf)

    return render


def newton(case):
    """Newton's tiled camera on the same triangles; each moving part is a body."""
    import newton
    import warp as wp

    height, width = case.out.shape[1:]
    scene, robot, moving = newton.ModelBuilder(), newton.ModelBuilder(), []
    for geom, (vertices, faces) in case.meshes().items():
        mesh = newton.Mesh(np.asarray(vertices, np.float32), np.asarray(faces, np.int32).ravel(), compute_inertia=False)
        if geom in case.worlds.geoms:
            robot.add_shape_mesh(robot.add_body(), mesh=mesh)
            moving.append(geom)
        else:
            place = transforms(case.geom_xpos[0, [geom]], case.geom_xmat[0, [geom]])[0]
            scene.add_shape_mesh(-1, xform=wp.transform(*place.tolist()), mesh=mesh)
    scene.replicate(robot, FEW)
    model = scene.finalize(device="cpu")
    state, sensor = model.state(), newton.sensors.SensorTiledCamera(model)
    fov = 2 * np.arctan(0.5 * height / case.camera.K[1, 1])
    rays = sensor.utils.compute_camera_rays_pinhole(width, height, camera_fovs=float(fov))
    depth = sensor.utils.create_forward_depth_image_output(width, height)
    axes = case.views[:FEW, :3, :3] * (1, -1, -1)
    views = wp.array(transforms(case.views[:FEW, :3, 3], axes)[None], dtype=wp.transformf, device="cpu")

    def render():
        poses = transforms(case.geom_xpos[:FEW, moving].reshape(-1, 3), case.geom_xmat[:FEW, moving].reshape(-1, 9))
        state.body_q.assign(poses)
        model.bvh_refit_shapes(state)
        sensor.update(state, views, rays, forward_depth_image=depth)
        found = depth.numpy()[:, 0]
        return np.where(found > 0, found, np.inf)

    return render


def transforms(positions, rotations):
    """(N, 7) float32 of positions and rotations: quaternions (x, y, z, w)."""
    import mujoco

    found = np.empty((len(positions), 7), np.float32)
    found[:, :3] = positions
    quaternion = np.empty(4)
    for row, rotation in zip(found, np.asarray(rotations, np.float64).reshape(len(positions), 9)):
        mujoco.mju_mat2Quat(quaternion, rotation)
        row[3:] = quaternion[[1, 2, 3, 0]]
    return found


PEERS = [("mujoco_warp", mujoco_warp), ("Newton", newton)]
