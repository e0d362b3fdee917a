"""Tests an installed wheel: its metadata, its licences, a render, a measurement and the program."""

import subprocess
import sys
from importlib.metadata import distribution

import numpy as np

import oaktwin


def main() -> None:
    wheel = distribution("oaktwin")
    files = {str(file).replace("\\", "/").rsplit("/", 1)[-1]: file for file in wheel.files or []}
    for name in ("LICENSE-APACHE", "LICENSE-MIT", "THIRD-PARTY-LICENSES.txt", "_oaktwin.pyi", "py.typed"):
        assert name in files, f"the wheel has no {name}"
    notices = files["THIRD-PARTY-LICENSES.txt"].read_text(encoding="utf-8")
    assert "pyo3 " in notices and "draco-core " in notices and "Apache License" in notices
    assert len(wheel.metadata.get_payload() or wheel.metadata["Description"]) > 1000, "no long description"
    assert wheel.metadata.get_all("Project-URL")
    wall = oaktwin.Mesh(np.array([[-9, -9, 3], [9, -9, 3], [0, 9, 3]]), np.array([[0, 1, 2]]))
    scene = oaktwin.Scene.from_meshes({"wall": wall})
    camera = oaktwin.Camera((106, 60), hfov_deg=70)
    exact = scene.render(camera, np.eye(4), annotators=["distance_to_image_plane", "rgb"])
    assert np.allclose(exact["distance_to_image_plane"], 3)
    measured = oaktwin.DepthSensor(oaktwin.Device("OAK4-D"), seed=7)(exact["distance_to_image_plane"])
    assert abs(np.median(measured) - 3) < 0.1
    shown = subprocess.run([sys.executable, "-m", "oaktwin", "models"], capture_output=True, text=True, check=True)
    assert "OAK4-D" in shown.stdout
    print(f"{wheel.metadata['Name']} {wheel.version}: good")


if __name__ == "__main__":
    main()
