"""The scene of the tests of virtual devices: a wall with a random texture 2 m in front of the device, and a box in front of it."""

import depthai as dai
import numpy as np

import oaktwin
from oaktwin.depthai import virtual_device

WALL_M, BOX_M = 2.0, 1.2
MODEL = "OAK-D Pro PoE"
SIZE = (320, 200)


def quad(x, width, height, texture):
    """A rectangle across the x axis, which faces the device at the origin."""
    y, z = width / 2, height / 2
    vertices = [(x, y, -z), (x, -y, -z), (x, -y, z), (x, y, z)]
    uvs = [(0, 0), (1, 0), (1, 1), (0, 1)]
    return oaktwin.Mesh(vertices, [(0, 1, 2), (0, 2, 3)], uvs=uvs, texture=texture)


def textured_scene():
    random = np.random.default_rng(3)
    wall = np.repeat(random.integers(40, 220, (384, 512, 1), np.uint8), 3, axis=2)
    box = np.repeat(random.integers(40, 220, (64, 64, 1), np.uint8), 3, axis=2)
    return oaktwin.Scene.from_meshes({"wall": quad(WALL_M, 8.0, 6.0, wall), "box": quad(BOX_M, 0.5, 0.5, box)})


def first(queue, count=1):
    """The last of the first messages of a queue."""
    return [queue.get() for _ in range(count)][-1]


def run(program):
    """Runs a program in a pipeline of a virtual device, which puts DepthAI's names back."""
    names = dai.Device, dai.Pipeline, dai.node.Camera, dai.node.StereoDepth
    with virtual_device(MODEL, scene=textured_scene(), fast=True):
        with dai.Pipeline() as pipeline:
            program(pipeline)
    assert names == (dai.Device, dai.Pipeline, dai.node.Camera, dai.node.StereoDepth)
