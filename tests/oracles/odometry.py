"""How far ORB-SLAM3, which knows nothing of oaktwin, drifts on the images and the inertial samples of a twin.

    python odometry.py OAKTWIN SCENE FOLDER

Renders a walk of 10 m through SCENE, the demo room, by the stereo pair of an OAK-D Pro PoE at 640 x 400 and 20 frames/s, into FOLDER (minutes),
and follows it by ORB-SLAM3 in its stereo-inertial mode. Prints how much of the path was tracked, and the errors of its camera's positions.
With `--board-file`, ORB-SLAM3 is told the inertial sensor's axes of the board file instead of those of the samples, which must fail.

Needs pyorbslam3 (0.1.1) and OpenCV. The vocabulary of visual words is made of the images, because ORB-SLAM3's own is a download.
"""

from __future__ import annotations

import argparse
import json
import subprocess
import time
from pathlib import Path

import cv2
import numpy as np
from pyorbslam3 import Sensor, Slam

RATE = 20.0
SIDES = ("Camera_left_ov9282", "Camera_right_ov9282")


def rotation(quaternion):
    x, y, z, w = quaternion
    return np.array([
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
    ])


def transform(translation, quaternion):
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = rotation(quaternion), translation
    return matrix


def walk(seconds=15.5, radius=0.45, speed=0.7):
    """Rounds on a circle, with a nodding, turning head: time, position and quaternion of the body for each frame."""
    t = np.arange(0, seconds + 1e-9, 1 / RATE)
    way = np.where(t < 2, t**2 / 4, t - 1) * speed
    phi = way / radius
    position = np.stack(
        [-0.05 - radius + radius * np.cos(phi), radius * np.sin(phi), 1.2 + 0.03 * np.sin(2 * np.pi * 0.9 * t) * np.clip(t / 2, 0, 1)],
        axis=1,
    )
    roll, pitch, yaw = 0.015 * np.sin(1.9 * phi), 0.025 * np.sin(1.3 * phi), 0.175 * np.sin(0.7 * phi)
    (cr, sr), (cp, sp), (cy, sy) = ((np.cos(angle), np.sin(angle)) for angle in (roll, pitch, yaw))
    quaternion = np.stack([
        sr * cp * cy - cr * sp * sy, cr * sp * cy + sr * cp * sy, cr * cp * sy - sr * sp * cy, cr * cp * cy + sr * sp * sy,
    ], axis=1)
    return np.column_stack([t, position, quaternion])


def render(program, scene, folder):
    """Renders the walk, unless the folder has it."""
    folder.mkdir(parents=True, exist_ok=True)
    np.savetxt(folder / "walk.tum", walk(), fmt="%.9f")
    if (folder / "imu.csv").exists():
        return
    command = [program, "render", scene, "--model", "OAK-D-Pro-PoE", "--camera", "left", "--camera", "right", "--resolution", "640x400"]
    command += ["--trajectory", folder / "walk.tum", "--annotators", "rgb,camera_params", "--imu", folder / "imu.csv", "-o", folder / "seq"]
    subprocess.run(list(map(str, command)), check=True)


def camera(folder, side):
    """The pose of a camera in the world at the first frame, x right, y down, z forward, and its parameters."""
    parameters = json.loads((folder / "seq" / side / "camera_params/camera_params_0000.json").read_text())
    view = np.reshape(parameters["cameraViewTransform"], (4, 4)).T
    return np.linalg.inv(view) @ np.diag([1.0, -1.0, -1.0, 1.0]), parameters


def write_vocabulary(path, images, branches=9, depth=3):
    """Clusters features of the images by their bits, in the text format of DBoW2: parent, leaf, 32 bytes and weight."""
    random, orb = np.random.default_rng(1), cv2.ORB_create(1000)
    found = [orb.detectAndCompute(cv2.imread(str(image), cv2.IMREAD_GRAYSCALE), None)[1] for image in images[::10]]
    bits = np.unpackbits(np.vstack([one for one in found if one is not None]), axis=1).astype(np.float32)
    lines = [f"{branches} {depth} 0 0"]

    def split(members, parent, level):
        own = bits[members]
        centres = own[random.choice(len(own), min(branches, len(own)), replace=False)]
        for _ in range(5):
            nearest = np.argmin((own**2).sum(1)[:, None] - 2 * own @ centres.T + (centres**2).sum(1), axis=1)
            means = [own[nearest == at].mean(0) > 0.5 if (nearest == at).any() else centre for at, centre in enumerate(centres)]
            centres = np.array(means, np.float32)
        for at, centre in enumerate(centres):
            inside = members[nearest == at]
            is_leaf = level == depth or len(inside) <= branches
            word = " ".join(map(str, np.packbits(centre.astype(np.uint8))))
            lines.append(f"{parent} {int(is_leaf)} {word} {int(is_leaf)}")
            if not is_leaf:
                split(inside, len(lines) - 1, level + 1)

    split(np.arange(len(bits)), 0, 1)
    path.write_text("\n".join(lines) + "\n")


def write_settings(path, folder, imu_from_left):
    left, parameters = camera(folder, SIDES[0])
    right, _ = camera(folder, SIDES[1])
    width, height = parameters["renderProductResolution"]
    focal = parameters["cameraFocalLength"] / parameters["cameraAperture"][0] * width
    baseline = (np.linalg.inv(left) @ right)[0, 3]
    values = {"Camera.fx": focal, "Camera.fy": focal, "Camera.cx": (width - 1) / 2, "Camera.cy": (height - 1) / 2}
    values |= {"Camera.k1": 0.0, "Camera.k2": 0.0, "Camera.p1": 0.0, "Camera.p2": 0.0, "Camera.bf": baseline * focal, "ThDepth": 60.0}
    values |= {"Camera.width": width, "Camera.height": height, "Camera.fps": RATE, "Camera.RGB": 1}
    # The noise of the part, with what the discrete samples and the interpolated motion add.
    values |= {"IMU.NoiseGyro": 1e-3, "IMU.NoiseAcc": 1e-2, "IMU.GyroWalk": 1e-5, "IMU.AccWalk": 1e-3, "IMU.Frequency": 400}
    # The walk begins gently; without this, ORB-SLAM3 waits for a jolt.
    values["IMU.fastInit"] = 1
    values |= {"ORBextractor.nFeatures": 1200, "ORBextractor.scaleFactor": 1.2, "ORBextractor.nLevels": 8}
    values |= {"ORBextractor.iniThFAST": 20, "ORBextractor.minThFAST": 7}
    # The viewer, which does not run, must have settings.
    values |= {f"Viewer.{name}": 1.0 for name in ("KeyFrameSize", "KeyFrameLineWidth", "GraphLineWidth", "PointSize", "CameraSize", "CameraLineWidth")}
    values |= {"Viewer.ViewpointX": 0.0, "Viewer.ViewpointY": -1.0, "Viewer.ViewpointZ": -1.0, "Viewer.ViewpointF": 500.0}
    numbers = ", ".join(f"{value:.9f}" for value in imu_from_left.flat)
    text = '%YAML:1.0\n---\nCamera.type: "PinHole"\n' + "".join(f"{name}: {value}\n" for name, value in values.items())
    text += f"Tbc: !!opencv-matrix\n   rows: 4\n   cols: 4\n   dt: f\n   data: [ {numbers} ]\n"
    path.write_text(text)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=Path)
    parser.add_argument("scene", type=Path)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--board-file", action="store_true")
    options = parser.parse_args()
    folder = options.folder
    render(options.program, options.scene, folder)
    left, right = (sorted((folder / "seq" / side / "rgb").glob("*.png")) for side in SIDES)
    poses = np.loadtxt(folder / "walk.tum")
    bodies = [transform(pose[1:4], pose[4:8]) for pose in poses]
    body_from_left = np.linalg.inv(bodies[0]) @ camera(folder, SIDES[0])[0]
    shown = json.loads(subprocess.check_output([options.program, "show", "OAK-D-Pro-PoE", "--json"]))["imu"]
    body_from_imu = np.eye(4)
    body_from_imu[:3, :3] = shown["board_file_rotation" if options.board_file else "rotation"]
    body_from_imu[:3, 3] = np.array(shown["position_mm"]) / 1000
    write_vocabulary(folder / "words.txt", left)
    write_settings(folder / "settings.yaml", folder, np.linalg.inv(body_from_imu) @ body_from_left)
    slam = Slam(folder / "words.txt", folder / "settings.yaml", Sensor.IMU_STEREO)
    samples = np.loadtxt(folder / "imu.csv", delimiter=",", comments="#")
    samples[:, 0] *= 1e-9
    before, tracked = -np.inf, 0
    for at, (one, other) in enumerate(zip(left, right)):
        begun, now = time.monotonic(), poses[at, 0]
        images = [cv2.imread(str(image), cv2.IMREAD_GRAYSCALE) for image in (one, other)]
        tracked += slam.track_stereo(*images, now, samples[(samples[:, 0] > before) & (samples[:, 0] <= now)]).pose_valid
        before = now
        # ORB-SLAM3 makes its map in other threads, in real time.
        time.sleep(max(0.0, 1 / RATE - (time.monotonic() - begun)))
    print(f"tracked {tracked} of {len(left)} frames, {slam.time_from_imu_init():.1f} s of them with the inertial sensor")
    slam.shutdown()
    slam.save_trajectory_tum(str(folder / "estimated.tum"))
    report(np.loadtxt(folder / "estimated.tum"), [body @ body_from_left for body in bodies])


def report(estimated, cameras):
    true = np.array([cameras[at] for at in np.round(estimated[:, 0] * RATE).astype(int)])
    places, found = true[:, :3, 3], estimated[:, 1:4]
    length = np.linalg.norm(np.diff(places, axis=0), axis=1).sum()
    # The rigid motion with the least squares of errors (Umeyama 1991, without a scale).
    means = places.mean(0), found.mean(0)
    u, _, v = np.linalg.svd((places - means[0]).T @ (found - means[1]))
    turn = u @ np.diag([1, 1, np.sign(np.linalg.det(u @ v))]) @ v
    errors = np.linalg.norm((found - means[1]) @ turn.T + means[0] - places, axis=1)
    first = true[0] @ np.linalg.inv(transform(found[0], estimated[0, 4:8]))
    end = np.linalg.norm((first @ np.append(found[-1], 1))[:3] - places[-1])
    print(f"path {length:.2f} m; absolute error {1000 * np.sqrt((errors**2).mean()):.1f} mm rms, {1000 * errors.max():.1f} mm at most")
    print(f"from the first pose, the last one is {1000 * end:.1f} mm off: {100 * end / length:.2f} % of the path")


if __name__ == "__main__":
    main()
