"""A walk through a small room, recorded for Rerun and ROS 2: colour, ground-truth and measured depth, points, poses.

    pip install rerun-sdk mcap-ros2-support matplotlib
    python examples/python/rerun_mcap.py -o walk/
    rerun walk/walk.rrd        # or walk/walk.mcap, which Rerun, Foxglove and ROS 2 open:
    ros2 bag play walk/walk.mcap

An OAK moves along an arc around a few objects on the floor. walk.rrd is written with Rerun's own package, walk.mcap with
`oaktwin.Recording`; walk.png is drawn from the messages of walk.mcap.
"""

import argparse
from pathlib import Path

import numpy as np
import rerun as rr
from mcap_ros2.reader import read_ros2_messages

import oaktwin

RATE = 10.0  # frames per second

THINGS = {  # centre and half extent, metres; colour
    "Floor": ((0, 0, -0.1), (3, 3, 0.1), (0.45, 0.42, 0.40)),
    "Back": ((3, 0, 1.2), (0.05, 3, 1.2), (0.75, 0.72, 0.65)),
    "Side": ((0, 3, 1.2), (3, 0.05, 1.2), (0.60, 0.68, 0.72)),
    "Crate": ((0.3, 0.2, 0.35), (0.35, 0.35, 0.35), (0.75, 0.50, 0.25)),
    "Box": ((0.25, 0.15, 0.85), (0.2, 0.2, 0.15), (0.20, 0.45, 0.75)),
    "Post": ((-0.4, -0.7, 0.6), (0.06, 0.06, 0.6), (0.80, 0.20, 0.20)),
    "Shelf": ((2.6, -1.4, 0.9), (0.3, 0.8, 0.03), (0.35, 0.60, 0.35)),
}


def stage():
    """The room as a USD stage: cubes are 2 units wide, so their scale is half the extent."""
    cube = """def Cube "{}"
{{
    color3f[] primvars:displayColor = [{}]
    double3 xformOp:translate = {}
    double3 xformOp:scale = {}
    uniform token[] xformOpOrder = ["xformOp:translate", "xformOp:scale"]
}}
"""
    head = '#usda 1.0\n(\n    metersPerUnit = 1\n    upAxis = "Z"\n)\n'
    return head + "".join(cube.format(name, color, at, size) for name, (at, size, color) in THINGS.items())


def walk(frames):
    """The poses of the camera, (frames, 4, 4): an arc of 80 degrees around the crate, facing it."""
    angles = np.radians(np.linspace(190, 270, frames))
    eyes = np.stack([2.2 * np.cos(angles), 2.2 * np.sin(angles), np.full(frames, 1.3)], axis=1)
    return np.stack([oaktwin.look_at(eye, (0.3, 0.2, 0.5)) for eye in eyes])


def points(depth, camera, rgb):
    """The measured points in the camera frame, metres, and their colours."""
    v, u = np.nonzero(depth)
    rays = np.stack([u, v, np.ones_like(u)], axis=1) @ np.linalg.inv(camera.K).T
    return rays * depth[v, u, None], rgb[v, u, :3]


def log_to_rerun(rec, camera, time, world_from_camera, seen, measured):
    """Logs a frame. The optical frame is the entity world/oak, which contains the frustum and the images."""
    rec.set_time("time", duration=time)
    rec.log(
        "world/oak", rr.Transform3D(translation=world_from_camera[:3, 3], mat3x3=world_from_camera[:3, :3])
    )
    pinhole = rr.Pinhole(image_from_camera=camera.K, resolution=camera.size, image_plane_distance=0.4)
    rec.log("world/oak/image", pinhole)
    rec.log("world/oak/image/rgb", rr.Image(seen["rgb"][..., :3]))
    rec.log("world/oak/image/depth", rr.DepthImage(seen["distance_to_image_plane"], meter=1.0))
    rec.log("world/oak/image/measured", rr.DepthImage(measured, meter=1.0))
    places, colors = points(measured, camera, seen["rgb"])
    rec.log("world/oak/points", rr.Points3D(places, colors=colors, radii=0.004))


def record(folder, device, size, frames, seed):
    """Renders the walk and writes both recordings."""
    (folder / "room.usda").write_text(stage())
    scene = oaktwin.Scene.open(folder / "room.usda")
    camera = device.depth_camera().resized(*size)
    sensor = oaktwin.DepthSensor(device, seed=seed)
    rec = rr.RecordingStream("oaktwin_walk")
    rec.save(folder / "walk.rrd")
    rec.log("world", rr.ViewCoordinates.RIGHT_HAND_Z_UP, static=True)
    with oaktwin.Recording(folder / "walk.mcap") as recording:
        for frame, world_from_camera in enumerate(walk(frames)):
            seen = scene.render(camera, world_from_camera, annotators=["rgb", "distance_to_image_plane"])
            depth, time = seen["distance_to_image_plane"], frame / RATE
            # Without the colour image, as with the projector on: every surface counts as textured.
            measured = sensor(depth, frame=frame)
            recording.log(
                camera, world_from_camera, time=time, depth=depth, measured=measured, rgb=seen["rgb"], name="oak"
            )
            log_to_rerun(rec, camera, time, world_from_camera, seen, measured)
    rec.disconnect()


def read_back(path):
    """The messages of an .mcap by topic, in order of time."""
    topics = {}
    for message in read_ros2_messages(path):
        topics.setdefault(message.channel.topic, []).append(message.ros_msg)
    return topics


def image(message):
    """A sensor_msgs/Image as an array."""
    kind, channels = {"rgb8": (np.uint8, 3), "32FC1": (np.float32, 1), "16UC1": (np.uint16, 1)}[message.encoding]
    array = np.frombuffer(message.data, kind).reshape(message.height, message.width, channels)
    return array if channels > 1 else array[..., 0]


def draw(path, topics):
    """Plots three frames of the recording, and the path from above."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    count = len(topics["/oak/rgb"])
    shown = [0, count // 2, count - 1]
    figure = plt.figure(figsize=(11, 5.6))
    grid = figure.add_gridspec(3, 5, left=0.04, right=0.93, top=0.94, bottom=0.12, wspace=0.06, hspace=0.12)
    for column, (name, title) in enumerate([("rgb", "colour"), ("depth", "exact depth"), ("measured", "measured depth")]):
        for row, frame in enumerate(shown):
            axes = figure.add_subplot(grid[row, column])
            message = topics[f"/oak/{name}"][frame]
            colours = {} if name == "rgb" else {"cmap": "turbo", "vmin": 1, "vmax": 6}
            drawn = axes.imshow(image(message), **colours)
            axes.set(xticks=[], yticks=[], facecolor="black")
            if row == 0:
                axes.set_title(title, fontsize=10)
            if column == 0:
                axes.set_ylabel(f"{message.header.stamp.sec + message.header.stamp.nanosec / 1e9:g} s")
    above = figure.add_subplot(grid[:, 3:])
    places = np.array([[t.transform.translation.x, t.transform.translation.y] for m in topics["/tf"] for t in m.transforms])
    for at, size, color in THINGS.values():
        corner = (at[0] - size[0], at[1] - size[1])
        above.add_patch(plt.Rectangle(corner, 2 * size[0], 2 * size[1], facecolor=color, edgecolor="0.3", linewidth=0.5))
    above.plot(*places.T, color="white", linewidth=1)
    marks = above.scatter(*places.T, c=np.arange(count) / RATE, cmap="plasma", zorder=3, edgecolor="white", s=30)
    above.set(xlabel="x [m]", xlim=(-3, 3.1), ylim=(-3, 3.1), aspect="equal")
    above.yaxis.tick_right()
    above.set_title("/tf from above: time [s]", fontsize=10)
    figure.colorbar(marks, ax=above, location="bottom", shrink=0.7, pad=0.1)
    bar = figure.colorbar(drawn, cax=figure.add_axes((0.4, 0.055, 0.17, 0.012)), orientation="horizontal")
    bar.ax.tick_params(labelsize=7)
    bar.ax.set_title("depth [m]", fontsize=7, pad=2)
    figure.savefig(path, dpi=80)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("-o", "--output", type=Path, default=Path("oaktwin-walk"), help="folder for the recordings")
    parser.add_argument("--model", default="OAK4-D")
    parser.add_argument("--frames", type=int, default=12)
    parser.add_argument("--size", type=int, nargs=2, default=(320, 200), metavar=("WIDTH", "HEIGHT"))
    parser.add_argument("--seed", type=int, default=7)
    arguments = parser.parse_args()

    folder = arguments.output
    folder.mkdir(parents=True, exist_ok=True)
    record(folder, oaktwin.Device(arguments.model), arguments.size, arguments.frames, arguments.seed)
    for name in ["walk.rrd", "walk.mcap"]:
        print(f"{folder / name}: {(folder / name).stat().st_size / 1e6:.1f} MB")
    topics = read_back(folder / "walk.mcap")
    for topic, messages in sorted(topics.items()):
        print(f"  {topic:22} {len(messages):3} {type(messages[0]).__name__}")
    exact, measured = (np.stack([image(m) for m in topics[f"/oak/{name}"]]) for name in ["depth", "measured"])
    error = np.abs(measured - exact)[np.isfinite(exact) & ~np.isnan(measured)]
    print(f"measured {np.mean(~np.isnan(measured)):.1%} of the pixels, median error {1000 * np.median(error):.1f} mm")
    draw(folder / "walk.png", topics)


if __name__ == "__main__":
    main()
