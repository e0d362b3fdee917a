"""Installs a wheel or a source distribution in a new environment and tests it there.

    python .github/test_wheel.py dist/oaktwin-*.whl
"""

import subprocess
import sys
import tempfile
import venv
from pathlib import Path


def main(package: Path) -> None:
    with tempfile.TemporaryDirectory() as folder:
        venv.create(folder, with_pip=True)
        python = Path(folder) / ("Scripts/python.exe" if sys.platform == "win32" else "bin/python")
        # Only the package itself may be built from its source.
        built = [] if package.suffix == ".whl" else ["--no-binary", "oaktwin"]
        install = [python, "-I", "-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--only-binary", ":all:"]
        subprocess.run([*install, *built, package], check=True)
        # In another folder and isolated: nothing of the checkout is imported.
        subprocess.run([python, "-I", Path(__file__).resolve(), "--installed"], check=True, cwd=folder)


def test_installed() -> None:
    """Tests the metadata, the licences, a render, a measurement and the program."""
    from importlib.metadata import distribution

    import numpy as np
    import oaktwin

    wheel = distribution("oaktwin")
    assert "Tag: cp310-abi3-" in (wheel.read_text("WHEEL") or "")
    files = {str(file).replace("\\", "/").rsplit("/", 1)[-1]: file for file in wheel.files or []}
    for name in ("LICENSE-APACHE", "LICENSE-MIT", "THIRD-PARTY-LICENSES.txt", "_oaktwin.pyi", "py.typed"):
        assert name in files, f"the wheel has no {name}"
    notices = files["THIRD-PARTY-LICENSES.txt"].read_text(encoding="utf-8")
    assert "pyo3 " in notices and "draco-core " in notices and "Apache License" in notices
    assert len(wheel.metadata.get_payload() or wheel.metadata["Description"]) > 1000, "no long description"
    assert wheel.metadata["License-Expression"] and wheel.metadata.get_all("Project-URL")
    wall = oaktwin.Mesh(np.array([[-9, -9, 3], [9, -9, 3], [0, 9, 3]]), np.array([[0, 1, 2]]))
    scene = oaktwin.Scene.from_meshes({"wall": wall})
    camera = oaktwin.Camera((106, 60), hfov_deg=70)
    exact = scene.render(camera, np.eye(4), annotators=["distance_to_image_plane", "rgb"])
    assert np.allclose(exact["distance_to_image_plane"], 3)
    measured = oaktwin.DepthSensor(oaktwin.Device("OAK4-D"), seed=7)(exact["distance_to_image_plane"])
    assert abs(np.median(measured) - 3) < 0.1
    shown = run_program("models")
    assert "OAK4-D" in shown
    # What a program with few features lacks.
    for command in ("bridge", "studio"):
        assert "--model" in run_program(command, "--help")
    print(f"{wheel.metadata['Name']} {wheel.version}, Python {sys.version.split()[0]}: good")


def run_program(*arguments: str) -> str:
    command = [sys.executable, "-I", "-m", "oaktwin", *arguments]
    return subprocess.run(command, capture_output=True, text=True, encoding="utf-8", check=True).stdout


if __name__ == "__main__":
    test_installed() if sys.argv[1] == "--installed" else main(Path(sys.argv[1]).resolve())
