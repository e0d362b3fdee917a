"""A wall in a noisy depth image: an Open3D point cloud, a plane fitted by RANSAC, and the errors of both.

    pip install open3d matplotlib
    python examples/python/open3d_plane.py [-o plane/] [--tilt 30]

The wall is oblique, with a box in front of it that RANSAC has to ignore. At each distance its ground-truth depth is rendered,
an OAK's stereo errors are applied, and Open3D converts it to points with the camera's own K. The plane is fitted to these
points and compared with the true one, and the scatter about it with the depth error that follows from the disparity error:
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
    """A wall that the optical axis meets at `distance`, rotated about the vertical, with a box in front of it.

    The world is the camera's frame. Returns the scene and the wall's plane (n, h): n . p = h.
    """
    turn = np.radians(tilt_deg)
    normal, along = np.array([np.sin(turn), 0, np.cos(turn)]), np.array([np.cos(turn), 0, -np.sin(turn)])
    middle, down = np.array([0, 0, distance]), np.array([0, 1.0, 0])
    wall = [middle + distance * (3 * x * along + 3 * y * down) for x, y in [(-1, -1), (1, -1), (1, 1), (-1, 1)]]
    # The front of the box at 80 % of the distance, parallel to the image.
    box = [distance * np.array([x, y, 0.8]) for x, y in [(-0.35, 0), (-0.1, 0), (-0.1, 0.45), (-0.35, 0.45)]]
    scene = oaktwin.Scene.from_triangles(np.array(wall + box), np.concatenate([WALL_FACES, WALL_FACES + 4]), up="y")
    return scene, (normal, float(normal @ middle))


def point_cloud(depth, camera):
    """Open3D's points of a depth image in metres; invalid pixels, 0, give none.

    Both use the same pixel convention, so K is passed unchanged.
    """
    k = camera.K
    intrinsics = o3d.camera.PinholeCameraIntrinsic(*camera.size, k[0, 0], k[1, 1], k[0, 2], k[1, 2])
    image = o3d.geometry.Image(np.ascontiguousarray(depth))
    return o3d.geometry.PointCloud.create_from_depth_image(image, intrinsics, depth_scale=1.0, depth_trunc=1000.0)


def error_of_depth(sensor):
    """The standard deviation of depth per squared distance, 1/m: sigma_d / (f b).

    The disparity error consists of jitter, pixel locking (a sine with a period of a pixel) and rounding to the subpixel step.
    """
    names = ("focalLength", "baseline", "jitter", "pixelLocking", "subpixelFractionalBits")
    focal_length, baseline, jitter, locking, bits = (float(sensor.parameters[name]) for name in names)
    sigma_disparity = np.sqrt(jitter**2 + locking**2 / 2 + (2.0**-bits) ** 2 / 12)
    return float(sigma_disparity / (focal_length * baseline))


def z_on_plane(points, plane):
    """The depth at which the rays through `points` intersect the plane."""
    normal, offset = plane
    return offset * points[:, 2] / (points @ normal)


def fit(cloud, threshold):
    """The RANSAC plane (n, h), with n away from the camera, and the indices of its points."""
    o3d.utility.random.seed(0)
    (a, b, c, d), inliers = cloud.segment_plane(distance_threshold=threshold, ransac_n=3, num_iterations=500)
    normal = np.array([a, b, c]) * (-1 if d > 0 else 1)
    return (normal, abs(d)), np.asarray(inliers)


def measure(device, sensor, distance, tilt_deg):
    """A row of the table, the points (metres, in the camera frame), the fitted plane and the true one."""
    camera = device.depth_camera().resized(*SIZE)
    scene, truth = tilted_wall(distance, tilt_deg)
    depth = scene.render(camera, np.eye(4))["distance_to_image_plane"]
    cloud = point_cloud(sensor(depth, frame=0), camera)
    points = np.asarray(cloud.points)

    per_square = error_of_depth(sensor)
    plane, inliers = fit(cloud, 4 * per_square * distance**2)
    # The scatter over the whole wall, including RANSAC's outliers, but without the box.
    expected = z_on_plane(points, truth)
    on_wall = points[np.abs(points[:, 2] - expected) < 0.1 * expected]
    z = z_on_plane(on_wall, truth)
    about_plane = on_wall[:, 2] - z_on_plane(on_wall, plane)
    row = {
        "distance_m": distance,
        "points": len(points),
        "inliers": len(inliers),
        "angle_deg": float(np.degrees(np.arccos(min(plane[0] @ truth[0], 1.0)))),
        "offset_mm": 1000 * float(plane[1] - truth[1]),
        "rms_mm": 1000 * float(np.sqrt(np.mean(about_plane**2))),
        "theory_mm": 1000 * float(np.sqrt(np.mean((z**2 * per_square) ** 2))),
    }
    return row, points, plane, truth


def draw(path, rows, shown):
    """The cloud of one distance coloured by its error, with the fitted plane; and the scatter over all distances."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    row, points, plane, truth = shown
    some = points[np.random.default_rng(0).choice(len(points), 15000, replace=False)]
    error = 1000 * (some[:, 2] - z_on_plane(some, truth))
    on_wall = np.abs(error) < 100 * some[:, 2]

    figure = plt.figure(figsize=(11, 4.8))
    space = figure.add_axes((0.0, 0.02, 0.53, 0.92), projection="3d", computed_zorder=False)
    # The figure's axes: right, forward, up.
    x, y, z = some[:, 0], some[:, 2], -some[:, 1]
    limit = 2.5 * row["rms_mm"]
    (a, b, c), offset = plane
    across, down = np.meshgrid([x[on_wall].min(), x[on_wall].max()], [-z.max(), -z.min()])
    space.plot_surface(across, (offset - a * across - b * down) / c, -down, color="0.2", alpha=0.15, edgecolor="0.2")
    dots = space.scatter(
        x[on_wall], y[on_wall], z[on_wall], s=0.6, c=error[on_wall], cmap="coolwarm", vmin=-limit, vmax=limit
    )
    space.scatter(x[~on_wall], y[~on_wall], z[~on_wall], s=0.6, color="0.15", label="the box before it")
    space.set(xlabel="right [m]", ylabel="forward [m]", zlabel="up [m]")
    space.set_title(f"Wall at {row['distance_m']} m: plane {row['angle_deg']:.3f}° and {row['offset_mm']:+.1f} mm off", y=1.0)
    for axis in (space.xaxis, space.yaxis, space.zaxis):
        axis.set_major_locator(plt.MultipleLocator(2))
    space.set_box_aspect((np.ptp(x), np.ptp(y), np.ptp(z)))
    space.view_init(elev=22, azim=-105)
    space.legend(loc="upper right", bbox_to_anchor=(1.0, 0.9), markerscale=6, frameon=False)
    figure.colorbar(dots, cax=figure.add_axes((0.54, 0.25, 0.012, 0.5)), label="error of depth [mm]", extend="both")

    chart = figure.add_axes((0.68, 0.12, 0.3, 0.78))
    distances = [row["distance_m"] for row in rows]
    chart.plot(distances, [row["theory_mm"] for row in rows], color="0.3", label="z²/(f·b)·σ_d")
    chart.plot(distances, [row["rms_mm"] for row in rows], "o", color="tab:red", label="about the fitted plane")
    chart.set(xlabel="distance along the optical axis [m]", ylabel="RMS of depth [mm]", xlim=(0, None), ylim=(0, None))
    chart.set_title("Scatter of the wall's points")
    chart.grid(alpha=0.3)
    chart.legend()
    figure.savefig(path, dpi=100)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("-o", "--output", type=Path, default=Path("oaktwin-plane"), help="folder for table and figure")
    parser.add_argument("--model", default="OAK-D Pro PoE")
    parser.add_argument("--tilt", type=float, default=30.0, help="rotation of the wall about the vertical, degrees")
    parser.add_argument("--seed", type=int, default=7)
    arguments = parser.parse_args()

    device = oaktwin.Device(arguments.model)
    sensor = oaktwin.DepthSensor(device, sensor="stereo", seed=arguments.seed)
    found = [measure(device, sensor, distance, arguments.tilt) for distance in DISTANCES]
    rows = [row for row, *_ in found]
    print(f"{device.name}, a wall turned by {arguments.tilt:g} degrees, {SIZE[0]}x{SIZE[1]}")
    print("distance  inliers   angle off  offset off  RMS about plane  z^2/(f b) sigma_d")
    for row in rows:
        print(
            f"{row['distance_m']:6} m {row['inliers'] / row['points']:7.1%} {row['angle_deg']:9.3f} deg"
            f" {row['offset_mm']:+8.1f} mm {row['rms_mm']:13.1f} mm {row['theory_mm']:15.1f} mm"
        )
    arguments.output.mkdir(parents=True, exist_ok=True)
    with open(arguments.output / "plane.csv", "w", newline="") as file:
        table = csv.DictWriter(file, rows[0])
        table.writeheader()
        table.writerows(rows)
    draw(arguments.output / "plane.png", rows, found[DISTANCES.index(4)])
    print(f"{arguments.output / 'plane.csv'} and plane.png")


if __name__ == "__main__":
    main()
