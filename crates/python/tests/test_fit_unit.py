"""Fits from Python, parameter files, typed parameters and the names of presets."""

import json
import tomllib

import numpy as np
import pytest

import oaktwin


@pytest.fixture(scope="module")
def recording(tmp_path_factory):
    """A flat wall as a unit with known errors measures it."""
    folder = tmp_path_factory.mktemp("wall")
    device = oaktwin.Device("OAK4-D")
    known = {"bias": -0.22, "pixelLocking": 0.08, "jitter": 0.05}
    sensor = oaktwin.DepthSensor(device, parameters=known)
    lines = ["file,distance_m"]
    for i, distance in enumerate(np.linspace(0.8, 4, 17)):
        wall = np.full((8, 200, 320), distance, np.float32)
        np.save(folder / f"{i:02}.npy", sensor(wall))
        lines.append(f"{i:02}.npy,{distance}")
    (folder / "distances.csv").write_text("\n".join(lines) + "\n")
    return device, folder, known


def test_a_fit_finds_the_known_parameters(recording, program, tmp_path):
    device, folder, known = recording
    fitted = oaktwin.fit(device, folder, engine="stereo-noise")
    for name, value in known.items():
        assert abs(fitted.parameters[name] - value) < 0.02, fitted
        low, high = fitted.intervals[name]
        assert low <= fitted.parameters[name] <= high
    report = json.loads(program("fit", folder, "--model", "OAK4-D", "--engine", "stereo-noise", "--json"))
    assert report == fitted.report and fitted.passed
    fitted.save(tmp_path / "unit.toml")
    stored = tomllib.loads((tmp_path / "unit.toml").read_text())
    assert stored["engine"] == "stereo-noise"
    assert stored["parameters"] == pytest.approx({**stored["parameters"], **fitted.parameters}, rel=1e-3)
    assert "bias" in repr(fitted)


def test_parameter_files(recording, tmp_path):
    device, folder, _ = recording
    path = tmp_path / "unit.toml"
    oaktwin.fit(device, [folder], engine="stereo-noise").save(path)
    sensor = oaktwin.DepthSensor(device, parameters=path)
    stored = tomllib.loads(path.read_text())["parameters"]
    for name, value in stored.items():
        assert sensor.parameters[name] == pytest.approx(value)
    same = oaktwin.DepthSensor(device, engine="stereo-noise", parameters=stored)
    wall = np.full((200, 320), 2.0, np.float32)
    assert np.array_equal(sensor(wall), same(wall))
    fitted = oaktwin.fit(device, [folder], engine="stereo-noise")
    assert oaktwin.DepthSensor(device, parameters={**fitted.parameters, "bias": 0.5}).parameters["bias"] == 0.5
    assert oaktwin.DepthSensor(device, parameters=fitted).parameters == sensor.parameters
    rows = oaktwin.accuracy(device, parameters=path, distances=[2.0], devices=1).rows
    assert rows == oaktwin.accuracy(device, engine="stereo-noise", parameters=stored, distances=[2.0], devices=1).rows
    with pytest.raises(FileNotFoundError):
        oaktwin.DepthSensor(device, parameters=tmp_path / "none.toml")
    with pytest.raises(oaktwin.Error, match="unit.toml"):
        oaktwin.DepthSensor(device, parameters=path, engine="single-view")
    path.write_text('engine = "stereo-noise"\n[parameters]\nbais = 1\n')
    with pytest.raises(oaktwin.Error, match="unit.toml: .*bais"):
        oaktwin.DepthSensor(device, parameters=path)


def test_bad_recordings(tmp_path):
    device = oaktwin.Device("OAK4-D")
    with pytest.raises(FileNotFoundError, match="none"):
        oaktwin.fit(device, tmp_path / "none")
    with pytest.raises(oaktwin.Error):
        oaktwin.fit(device, tmp_path, region=2.0)


def test_the_plot(recording):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    device, folder, _ = recording
    axes = oaktwin.fit(device, folder).plot()
    assert len(axes.lines) == 3 and axes.get_title().startswith("OAK4-D")


@pytest.mark.parametrize("engine", ["stereo-noise", "time-of-flight", "single-view"])
def test_parameters_have_the_types_of_their_declarations(engine):
    device = oaktwin.Device("OAK-D ToF" if engine == "time-of-flight" else "OAK4-D")
    types = {"boolean": bool, "integer": int, "number": float, "enum": str, "string": str}
    declared = {one["name"]: one for one in oaktwin.parameters(engine, platform="rvc4")}
    for one in declared.values():
        assert type(one["default"]) is types[one["type"]] or one["default"] in ("auto", "none", ""), one
    values = oaktwin.DepthSensor(device, engine=engine).parameters
    assert values.keys() <= declared.keys() and len(values) > 5
    typed = {name: value for name, value in values.items() if type(value) is types[declared[name]["type"]]}
    assert len(typed) > 0.8 * len(values)
    # What is returned is accepted.
    again = oaktwin.DepthSensor(device, engine=engine, parameters=values)
    assert again.parameters == values


def test_presets():
    assert "default" in oaktwin.presets() and "high-detail" in oaktwin.presets()
    for platform, model in {"rvc2": "OAK-D Pro PoE", "rvc4": "OAK4-D", "tof": "OAK-D ToF"}.items():
        names = oaktwin.presets(platform)
        assert len(names) == len(set(names)) > 1
        for name in names:
            oaktwin.DepthSensor(oaktwin.Device(model), preset=name)
    with pytest.raises(oaktwin.Error, match="platform: invalid value 'rvc3'"):
        oaktwin.presets("rvc3")


def test_images_in_memory(tmp_path):
    """Fitting to arrays is fitting to their files."""
    device = oaktwin.Device("OAK4-D")
    unit = oaktwin.DepthSensor(device, parameters={"bias": 0.2, "jitter": 0.06})
    rgb = np.random.default_rng(0).integers(0, 256, (400, 640, 3)).astype(np.uint8)
    images = {z: [unit(np.full((400, 640), z, np.float32), rgb) for _ in range(3)] for z in (3.0, 0.8, 1.2, 2.0)}
    found = oaktwin.fit(device, images)
    assert abs(found.parameters["bias"] - 0.2) < 0.02 and abs(found.parameters["jitter"] - 0.06) < 0.02
    assert found.report["sources"] == [f"images at {z} m" for z in ("3", "0.8", "1.2", "2")]
    table = "file,distance_m\n"
    for z, stack in images.items():
        np.save(tmp_path / f"{z}.npy", np.stack(stack))
        table += f"{z}.npy,{z}\n"
    (tmp_path / "distances.csv").write_text(table)
    assert oaktwin.fit(device, tmp_path).parameters == found.parameters
    millimetres = {z: np.rint(1000 * np.stack(stack)).astype(np.uint16) for z, stack in images.items()}
    assert abs(oaktwin.fit(device, millimetres).parameters["bias"] - 0.2) < 0.05


@pytest.mark.parametrize(
    ("recordings", "message"),
    [
        ({}, "recordings: is empty; pass at least one folder or CSV file, or images by their distance"),
        ({-1.0: np.ones((2, 40, 60), np.float32)}, "images at -1 m is no distance; give metres above 0"),
        ({1.0: [np.ones((40, 60)), np.ones((40, 50))]}, "recordings: 1.0 m: .*; pass images of one size"),
        ({1.0: np.ones((2, 40, 60), int)}, "is int64 of shape .*; pass float32 metres or uint16"),
        ({1.0: np.ones((40, 60), np.float32), 2.0: np.ones((40, 50), np.float32)}, "images at 2 m: it is 50x40"),
    ],
)
def test_what_are_no_images(recordings, message):
    with pytest.raises(oaktwin.Error, match=message):
        oaktwin.fit(oaktwin.Device("OAK4-D"), recordings)
