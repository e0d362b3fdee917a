"""Units of a population, and a pair that has drifted."""

import pickle

import numpy as np
import pytest

import oaktwin


def test_units_are_calibrated_devices(tmp_path):
    nominal = oaktwin.Device("OAK-D Pro PoE")
    units = nominal.population(40, seed=2)
    assert len(units) == 40 and units[7].origin == "oak_d_pro_poe_000007.json"
    focal = np.array([unit.cameras["left"].K[0, 0] for unit in units])
    assert 0.003 < focal.std() / focal.mean() < 0.008 and len(set(focal)) == 40
    # A unit does not depend on how many there are, and differs from the units of another seed.
    again, other = nominal.population(8, seed=2)[7], nominal.population(8)[7]
    assert np.array_equal(again.extrinsics("left", "right"), units[7].extrinsics("left", "right"))
    assert not np.array_equal(other.extrinsics("left", "right"), units[7].extrinsics("left", "right"))
    copy = pickle.loads(pickle.dumps(units[7]))
    assert np.array_equal(copy.cameras["rgb"].K, units[7].cameras["rgb"].K)
    assert any("factory calibrations" in finding.message for finding in units[7].findings)
    units[7].write_usd(tmp_path / "unit.usda")


def test_drift_moves_depth():
    device = oaktwin.Device("OAK-D Pro PoE")
    depth = np.full((80, 128), 2.0, np.float32)
    exact = {"jitter": 0, "pixelLocking": 0, "subpixelFractionalBits": 5, "occlusion": False, "dropout": 0}
    measured = oaktwin.DepthSensor(device, drift="baseline=1500", parameters=exact)(depth)
    # A baseline of 76.5 instead of 75 mm, as far as steps of 1/32 px allow.
    assert np.allclose(measured, 2 / 1.02, atol=2e-3)
    assert np.array_equal(
        oaktwin.DepthSensor(device, drift="", parameters=exact)(depth), oaktwin.DepthSensor(device, parameters=exact)(depth)
    )
    batch = oaktwin.DepthSensor(device, drift="baseline=1500", parameters=exact)(np.stack([depth] * 3))
    assert np.array_equal(batch[2], measured)
    lost = oaktwin.DepthSensor(device, drift="pitch=3")(depth) == 0
    assert 0.2 < lost[:, 20:].mean() < 0.6


def test_the_accuracy_of_a_population():
    device = oaktwin.Device("OAK-D Pro PoE")
    report = oaktwin.accuracy(device, population=True, devices=20, distances=[2.0], captures=1, drift="yaw=0.5").report
    assert report["devices"] == {"kind": "factory", "count": 20}
    low, high = report["distances"][0]["error_5_to_95_percent"]
    assert low < report["distances"][0]["error_percent"] < high


def test_errors():
    device = oaktwin.Device("OAK-D Pro PoE")
    for problem, call in [
        ("count: 0 is out of range; give 1 to 10000", lambda: device.population(0)),
        ("is the device of a calibration", lambda: device.population(1)[0].population(2)),
        ("did you mean", lambda: oaktwin.DepthSensor(device, drift="yawn=1")),
        ("from -50 to 50 mrad", lambda: oaktwin.DepthSensor(device, drift="yaw=inf")),
    ]:
        with pytest.raises(oaktwin.Error, match=problem):
            call()
