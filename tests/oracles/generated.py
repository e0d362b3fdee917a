"""Readers of generated data sets, and ray casting in NumPy."""

import json
from pathlib import Path

import numpy as np
import trimesh
from PIL import Image


def image(path: Path) -> np.ndarray:
    return np.array(Image.open(path))


def pfm(path: Path) -> np.ndarray:
    kind, size, scale, data = path.read_bytes().split(b"\n", 3)
    assert kind == b"Pf" and float(scale) < 0
    width, height = map(int, size.split())
    return np.frombuffer(data, "<f4").reshape(height, width)[::-1]


class Bop:
    """A data set in BOP's layout; lengths in millimetres."""

    def __init__(self, root: Path) -> None:
        self.root = root
        self.models = {}
        self.frames = {}
        for scene in sorted((root / "train").iterdir()):
            read = lambda name: json.loads((scene / f"scene_{name}.json").read_text())
            cameras, poses, infos = read("camera"), read("gt"), read("gt_info")
            for key, camera in cameras.items():
                self.frames[int(key)] = (scene, camera, poses[key], infos[key])

    def model(self, number: int) -> trimesh.Trimesh:
        if number not in self.models:
            path = self.root / f"models/obj_{number:06}.ply"
            self.models[number] = trimesh.load(path, process=False)
        return self.models[number]

    def triangles(self, pose: dict) -> np.ndarray:
        """The triangles of an object in the camera's frame."""
        rotation = np.array(pose["cam_R_m2c"]).reshape(3, 3)
        return self.model(pose["obj_id"]).triangles @ rotation.T + np.array(pose["cam_t_m2c"])


def cast(triangles: np.ndarray, matrix: np.ndarray, pixels: np.ndarray) -> np.ndarray:
    """The depth of the first triangle behind each pixel's centre, infinite for a miss: Moeller and Trumbore's test."""
    rays = np.column_stack([pixels, np.ones(len(pixels))]) @ np.linalg.inv(matrix).T
    a = triangles[:, 0]
    e1, e2 = triangles[:, 1] - a, triangles[:, 2] - a
    p = np.cross(rays[:, None], e2[None])
    det = np.einsum("rti,ti->rt", p, e1)
    with np.errstate(divide="ignore", invalid="ignore"):
        u = np.einsum("rti,ti->rt", p, -a) / det
        q = np.cross(-a, e1)
        v = rays @ q.T / det
        t = np.einsum("ti,ti->t", e2, q)[None] / det
    inside = (u >= 0) & (v >= 0) & (u + v <= 1) & (t > 0)
    return np.where(inside, t, np.inf).min(axis=1)


def matrix_of(camera: dict) -> np.ndarray:
    return np.array(camera["cam_K"]).reshape(3, 3)


def world_from_camera(camera: dict) -> np.ndarray:
    """In metres."""
    pose = np.eye(4)
    rotation = np.array(camera["cam_R_w2c"]).reshape(3, 3)
    pose[:3, :3] = rotation.T
    pose[:3, 3] = -rotation.T @ np.array(camera["cam_t_w2c"]) * 1e-3
    return pose
