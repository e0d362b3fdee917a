"""The measured cloud of a wall in Open3D."""

# pyright: reportUnknownMemberType=false
# Open3D's types are incomplete.

from typing import Any

import numpy as np
import open3d

import oaktwin

device = oaktwin.Device("OAK4-D")
scene = oaktwin.Scene.open("scene.usda", micro_texture=True)
pose = scene.look_at((3, 0, 0.6), (0, 0, 0.5), device)
sensor = oaktwin.DepthSensor(device, seed=1)
shot = sensor.shoot(scene, pose)

intrinsic = open3d.camera.PinholeCameraIntrinsic(**shot.camera.to_open3d())
depth: Any = shot.depth  # Open3D declares no arrays.
image = open3d.geometry.Image(depth)
cloud = open3d.geometry.PointCloud.create_from_depth_image(
    image, intrinsic, np.linalg.inv(shot.world_from_camera), depth_scale=1.0, depth_trunc=20.0
)
assert len(cloud.points) > 0.3 * shot.depth.size
