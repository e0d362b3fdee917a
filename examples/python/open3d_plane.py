"""A wall in a noisy depth image: an Open3D point cloud, a RANSAC plane on it, and how wrong both are.

    pip install open3d matplotlib oaktwin
    python open3d_plane.py [-o plane/] [--tilt 30]

The wall stands obliquely, with a box before it that RANSAC has to ignore. At each distance its exact depth is rendered,
an OAK's stereo errors are put on it, and Open3D makes points of it with the camera's own K. The plane is fitted to those
points and held against the true one, and the scatter about it against what one error of disparity makes of depth:
z^2 / (f b) * sigma_d.
"""

import argparse
import csv
from pathlib import Path

import numpy as np
import open3d as o3d

import oaktwin

SIZE = (640, 400)
DISTANCES = (1, 2, 3, 4, 5, 6, 7, 8)
WALL_FACES = np.array([[0, 1, 2], [0, 2, 3]])


def tilted_wall(distance, tilt_deg):
    """A wall that the optical axis meets at `distance`, turned about the vertical, and a box before it.

    Returns the scene and the wall's plane (n, h) in the camera's frame: n . p = h. The world is the camera's frame.
    """
    turn = np.radians(tilt_deg)
    normal, along = np.array([np.sin(turn), 0, np.cos(turn)]), np.array([np.cos(turn), 0, -np.sin(turn)])
    middle, down = np.array([0, 0, distance]), np.array([0, 1.0, 0])
    wall = [middle + distance * (3 * x * along + 3 * y * down) for x, y in [(-1, -1), (1, -1), (1, 1), (-1, 1)]]
    # A face of the box a fifth nearer, parallel to the image.
    box = [distance * np.array([x, y, 0.8]) for x, y in [(-0.35, 0), (-0.1, 0), (-0.1, 0.45), (-0.35, 0.45)]]
    scene = oaktwin.Scene.from_triangles(np.array(wall + box), np.concatenate([WALL_FACES, WALL_FACES + 4]), up="y")
    return scene, (normal, float(normal @ middle))


def point_cloud(depth, camera):
    """Open3D's points of a depth image in metres; 0, not measured, gives none.

    Both count pixels from the centre of the first one, so K goes over as it is.
    """
    k = camera.K
    intrinsics = o3d.camera.PinholeCameraIntrinsic(*camera.size, k[0, 0], k[1, 1], k[0, 2], k[1, 2])
    image = o3d.geometry.Image(np.ascontiguousarray(depth))
    return o3d.geometry.PointCloud.create_from_depth_image(image, intrinsics, depth_scale=1.0, depth_trunc=1000.0)


def sigma_disparity(sensor, bits=5):
    """What one disparity is wrong by, px, as a standard deviation: jitter, pixel locking over its period, and the step."""
    told = {name: float(sensor.parameters[name]) for name in ("jitter", "pixelLocking")}
    return float(np.sqrt(told["jitter"] ** 2 + told["pixelLocking"] ** 2 / 2 + (2.0**-bits) ** 2 / 12))


def z_on_plane(points, plane):
    """The depth at which the rays through `points` meet the plane."""
    normal, offset = plane
    return offset * points[:, 2] / (points @ normal)


def fit(cloud, threshold):
    """The RANSAC plane (n, h), n away from the camera, and the numbers of its points."""
    o3d.utility.random.seed(0)
    (a, b, c, d), inliers = cloud.segment_plane(distance_threshold=threshold, ransac_n=3, num_iterations=500)
    normal = np.array([a, b, c]) * (-1 if d > 0 else 1)
    return (normal, abs(d)), np.asarray(inliers)


def measure(device, sensor, distance, tilt_deg):
    """One row of the table, the points in metres, and the plane."""
    camera = device.depth_camera().resized(*SIZE)
    scene, truth = tilted_wall(distance, tilt_deg)
    depth = scene.render(camera, np.eye(4))["distance_to_image_plane"]
    cloud = point_cloud(sensor(depth), camera)
    points = np.asarray(cloud.points)

    sensed = device.depth_sensors["stereo"]
    per_square = sigma_disparity(sensor) / (sensed["focal_length_px"] * sensed["baseline_m"])
    plane, inliers = fit(cloud, 4 * per_square * distance**2)
    # The scatter over all of the wall, also what RANSAC left out as too far away: what is not the box.
    expected = z_on_plane(points, truth)
    on_wall = points[np.abs(points[:, 2] - expected) < 0.1 * expected]
    z = z_on_plane(on_wall, truth)
    about_plane = on_wall[:, 2] - z_on_plane(on_wall, plane)
    row = {
        "distance_m": distance,
        "points": len(points),
        "inliers": len(inliers),
        "angle_deg": float(np.degrees(np.arccos(min(plane[0] @ truth[0], 1.0)))),
        "offset_mm": 1000 * (plane[1] - truth[1]),
        "rms_mm": 1000 * float(np.sqrt(np.mean(about_plane**2))),
        "theory_mm": 1000 * float(np.sqrt(np.mean((z**2 * per_square) ** 2))),
    }
    return row, points, plane
