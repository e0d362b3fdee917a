"""Latencies: of the catalog, in a stream, and from a moving edge."""

import numpy as np
import pytest

import oaktwin


def test_the_catalogs_latency_follows_the_mode(device):
    lite = oaktwin.Device("OAK-D Lite")
    latency = oaktwin.DepthSensor(lite).latency()
    assert latency["connection"] == "usb" and latency["mode"] == "subpixel+left-right" and latency["width_px"] == 640
    assert [stage["stage"] for stage in latency["stages"]] == ["exposure", "depth", "transfer"]
    assert np.allclose(latency["ms"], np.sum([stage["ms"] for stage in latency["stages"]], axis=0))
    assert all(stage["source"] and stage["from"] for stage in latency["stages"])
    plain = oaktwin.DepthSensor(lite, parameters={"subpixel": False, "leftRightCheck": False}).latency()
    assert plain["mode"] == "standard" and plain["ms"][0] < latency["ms"][0]
    wide = oaktwin.DepthSensor(oaktwin.Device("OAK-D Pro PoE"), extended_disparity=True)
    assert wide.latency()["connection"] == "poe" and "extended" in wide.latency()["mode"]
    assert wide.latency("usb")["ms"][1] < wide.latency()["ms"][1]
    narrow = oaktwin.DepthSensor(oaktwin.Device("OAK-D Pro PoE"), parameters={"width": 640})
    assert narrow.latency()["ms"][1] < oaktwin.DepthSensor(oaktwin.Device("OAK-D Pro PoE")).latency()["ms"][0] + 20
    flight = oaktwin.DepthSensor(oaktwin.Device("OAK-D ToF")).latency()
    assert (flight["mode"], flight["connection"]) == ("time-of-flight", "poe")
    assert {stage["source"] for stage in flight["stages"][:2]} == {"estimate"}
    assert oaktwin.DepthSensor(oaktwin.Device("RealSense D435i")).latency() is None
    with pytest.raises(oaktwin.Error, match="connection"):
        wide.latency("wifi")


def test_a_stream_with_the_catalogs_latency(device):
    sensor = oaktwin.DepthSensor(device, hfov_deg=70)
    latency = sensor.latency()
    stream = oaktwin.Stream(sensor, latency="catalog", camera_hz=50, control_hz=200)
    low, high = np.array(latency["ms"]) / 1000
    named = oaktwin.Stream(sensor, latency=(low, high), jitter=latency["jitter_ms"] / 1000 * 12**0.5, camera_hz=50, control_hz=200)
    ages = []
    for step in range(60):
        depth = np.full((50, 6, 8), 1 + step / 100, np.float32)
        seen, expected = stream(depth), named(depth)
        assert np.array_equal(seen.depth, expected.depth) and np.array_equal(seen.age, expected.age)
        ages.append(seen.age[:, 0])
    # Frames are between the latency and a period of the camera, a step and the jitter more old.
    ages = np.array(ages[30:])
    assert ages.min() >= low - 1e-6 and ages.max() <= high + 0.02 + 0.005 + 0.002
    fixed = oaktwin.Stream(sensor, latency="catalog", jitter=0.0, camera_hz=50, control_hz=200)
    assert fixed._jitter == 0
    for bad, message in [("soon", "latency: is 'soon'; pass seconds, .low, high., or 'catalog'"), (None, "latency: is None")]:
        with pytest.raises(oaktwin.Error, match=message):
            oaktwin.Stream(sensor, latency=bad)
    with pytest.raises(oaktwin.Error, match="latency: the catalog has none of this sensor"):
        oaktwin.Stream(oaktwin.DepthSensor(oaktwin.Device("RealSense D435i")), latency="catalog")


def edge(seconds):
    return 0.3 * np.sin(4.4 * seconds) + 0.2 * np.sin(7.1 * seconds + 0.4)


def test_a_latency_from_a_moving_edge():
    random = np.random.default_rng(1)
    encoder = np.arange(0, 10, 1e-3)
    exposed = np.arange(1, 9, 1 / 30)
    for latency in (0.0123, 0.0815):
        arrived = exposed + latency + random.normal(0, 0.002, len(exposed))
        seen = 320 - 400 * edge(exposed) + random.normal(0, 0.5, len(exposed))
        found = oaktwin.fit_latency((arrived, seen), (encoder, edge(encoder)))
        assert abs(found["latency_s"] - latency) < 1e-3 and found["passed"]
        assert abs(found["jitter_s"] - 0.002) < 1e-3
        low, high = found["confidence_interval_95"]
        assert low < found["latency_s"] < high
    for camera, message in [
        ((arrived[::-1], seen), "camera: sample 1: time_s: .* is not after"),
        ((arrived, seen[1:]), "camera: has 240 times and 239 positions"),
        ((arrived, np.full_like(seen, np.nan)), "camera: sample 0: .* is not finite"),
        ((arrived[:5], seen[:5]), "camera: has 5 images"),
        ((arrived, random.normal(size=len(arrived))), "camera: correlates with reference by"),
    ]:
        with pytest.raises(oaktwin.Error, match=message):
            oaktwin.fit_latency(camera, (encoder, edge(encoder)))
    with pytest.raises(oaktwin.Error, match="longest.*0: is out of range"):
        oaktwin.fit_latency((arrived, seen), (encoder, edge(encoder)), longest=0)
    with pytest.warns(oaktwin.FindingWarning, match="latency-ambiguous"):
        oaktwin.fit_latency((exposed + 0.05, np.sin(25 * exposed)), (encoder, np.sin(25 * encoder)))
