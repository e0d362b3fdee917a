"""The application sees rooms that the tests build. No camera is needed."""

import app
import numpy as np
import oaktwin
import pytest


def room(wall_m):
    """A scene with a wall of noise at a distance in front of the device."""
    texture = np.repeat(np.random.default_rng(1).integers(30, 220, (256, 256, 1), np.uint8), 3, axis=2)
    corners = [(wall_m, 3, -2), (wall_m, -3, -2), (wall_m, -3, 2), (wall_m, 3, 2)]
    wall = oaktwin.Mesh(corners, [(0, 1, 2), (0, 2, 3)], uvs=[(0, 0), (1, 0), (1, 1), (0, 1)], texture=texture)
    return oaktwin.Scene.from_meshes({"wall": wall})


@pytest.mark.parametrize("wall_m", [0.6, 1.0, 2.5])
def test_the_distance_of_a_wall(virtual_oak, wall_m):
    virtual_oak("OAK-D Pro", scene=room(wall_m))
    assert app.main(frames=3) == [pytest.approx(wall_m, rel=0.03)] * 3


def test_it_warns_while_it_drives_towards_a_wall(virtual_oak, capsys):
    def pose(seconds):
        matrix = np.eye(4)
        matrix[0, 3] = 1.0 * seconds
        return matrix

    virtual_oak("OAK-D Pro", scene=room(1.2), pose=pose)
    app.main(frames=10)
    lines = capsys.readouterr().out.splitlines()
    assert "STOP" not in lines[0] and "STOP" in lines[-1]


def test_nothing_in_reach(virtual_oak):
    # A triangle behind the device.
    virtual_oak("OAK-D Pro", scene=oaktwin.Scene.from_triangles([(-2, 0, 0), (-2, 1, 0), (-2, 0, 1)], [(0, 1, 2)]))
    assert app.main(frames=1) == [None]
