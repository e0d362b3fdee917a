"""The time-of-flight engine, compared with a NumPy implementation of the documented steps, and its filter with DepthAI's."""

from dataclasses import asdict, replace
from functools import partial
from pathlib import Path

import numpy as np
import pytest

import time_of_flight_model as model

SETTINGS = [
    {},
    {"enableBurstMode": True, "bias": 0.02},
    {"enablePhaseShuffleTemporalFilter": False, "ambient": 500.0},
    {"phaseUnwrappingLevel": 0, "enableWiggleCorrection": False},
    {"phaseUnwrappingLevel": 1, "phaseUnwrapErrorThreshold": 50},
    {"phaseUnwrappingLevel": 2, "phaseUnwrapErrorThreshold": 300},
    {"phaseUnwrappingLevel": 3, "enableOpticalCorrection": False},
    {"phaseUnwrappingLevel": 5, "pixelMixing": 0.0},
    {"enablePhaseUnwrapping": False, "pixelMixing": 0.25},
    {"modulationFrequencies": (20.0, 100.0)},
    {"modulationFrequencies": (60.0, 81.0), "wiggling": 0.2, "wigglingResidual": 0.05},
    {"enableFPPNCorrection": False, "fixedPattern": 0.03},
    {"radialVelocity": 2.0, "measurementInterval": 0.03},
    {"principalPoint": (300.0, 251.5), "focalLength": 380.0},
    {"signal": 300.0, "minAmplitude": 0.0, "readNoise": 15.0},
    {"confidenceThreshold": 60.0, "albedo": 0.9, "fullWell": 20000.0},
    {"confidenceThreshold": 0.0, "contrast": 0.5},
    {"multipath": 1.0, "albedo": 0.9},
    {"multipath": 3.0, "radialVelocity": -1.0, "bias": 0.1},
]

SIZES = [(96, 640), (60, 106), (70, 333), (9, 1), (1, 65), (30, 1280)]


@pytest.fixture
def ask(depth_eval):
    return partial(depth_eval, "time_of_flight")


def scene(random, height, width):
    """A wall, a floor, boxes and poles at any depth, and invalid depth."""
    x = np.linspace(0, 1, width)[None, :]
    y = np.linspace(0, 1, height)[:, None]
    z = random.uniform(1, 6) + random.uniform(-1.5, 1.5) * x + random.uniform(-0.5, 0.5) * y
    with np.errstate(divide="ignore"):
        z = np.minimum(z, np.where(y > 0.6, random.uniform(0.2, 0.9) / (y - 0.5), np.inf))
    for _ in range(random.integers(2, 20)):
        left, top = random.uniform(-0.1, 1, 2)
        wide, high = random.choice([0.004, 0.03, 0.2]), random.uniform(0.05, 0.7)
        inside = (x >= left) & (x < left + wide) & (y >= top) & (y < top + high)
        z = np.where(inside, random.uniform(0.15, 5) + random.uniform(-1, 1) * (x - left), z)
    nothing = [np.nan, np.inf, -np.inf, 0, -1, 1e-3, 30.0, 1e30]
    z = np.where(random.random(z.shape) < 0.01, random.choice(nothing, z.shape), z)
    return z.astype(np.float32)


def wire(p):
    fields = asdict(p)
    pairs = {"principalPoint": fields["principalPoint"], "modulationFrequencies": fields["modulationFrequencies"]}
    for name, pair in pairs.items():
        fields[name] = "center" if pair is None else f"{pair[0]},{pair[1]}"
    return {"parameters": fields}


@pytest.mark.parametrize("size", SIZES, ids=str)
def test_depth_amplitude_and_confidence(ask, tmp_path: Path, size):
    """All alike but what single precision rounds otherwise: a millimetre or an electron, and what is all but undecided."""
    random = np.random.default_rng([9, *size])
    pixels = kept_pixels = rounded = undecided_pixels = 0
    for number, settings in enumerate(SETTINGS):
        depth = scene(random, *size)
        p = replace(model.Parameters(), **settings)
        arguments = {"seed": 2**63 + number, "camera": "tof", "frame": 2**32 + 3 * number, "item": number}
        files = {"depth": depth}
        if number % 2 == 0:
            files["rgb"] = random.integers(0, 256, (*size, 4), dtype=np.uint8)
        if number % 3 == 0:
            files["velocity"] = random.normal(0, 1, size).astype(np.float32)
        for name, array in files.items():
            np.save(tmp_path / f"{name}.npy", array)
        names = [*files, "distance", "amplitude", "confidence"]
        ask(**{name: str(tmp_path / f"{name}.npy") for name in names}, **wire(p), **arguments)
        distance, amplitude, confidence = (np.load(tmp_path / f"{name}.npy") for name in names[-3:])
        del files["depth"]
        millimetres, kept, undecided, expected = model.measured(depth, p, **arguments, **files)
        settled = undecided > 1e-3
        found = np.rint(distance.astype(np.float64) * 1000).astype(np.uint16)
        # The filter works on the program's integers.
        whole = np.where(kept, np.rint(millimetres), 0)
        by_confidence, _ = model.confidences(whole.astype(np.uint16), amplitude, p.confidenceThreshold)
        differ = settled & ((found > 0) != (by_confidence > 0))
        # A depth that differs by a millimetre may have a confidence on the other side of the threshold.
        assert differ.sum() <= 1e-4 * differ.size + 1, (settings, differ.sum())
        both = settled & (found > 0) & (by_confidence > 0)
        off = np.abs(found - millimetres)
        assert (off[both] < 0.52).all(), (settings, off[both].max())
        limited = np.minimum(expected, 65535)
        # A slope is the difference of two inverse depths of single precision; which side is the flatter one may change.
        wrong = np.abs(amplitude - limited) > 0.5 + 5e-4 * limited
        assert wrong.sum() <= 1e-4 * wrong.size, (settings, amplitude[wrong], limited[wrong])
        unfiltered = (found > 0) & both
        wanted = model.confidences(found, amplitude, p.confidenceThreshold)[1]
        np.testing.assert_array_equal(confidence[unfiltered], wanted[unfiltered])
        pixels += found.size
        kept_pixels += both.sum()
        rounded += (found[both] != by_confidence[both]).sum()
        undecided_pixels += (~settled).sum()
    print(f"{size}: {pixels} pixels, {kept_pixels} compared, {rounded} rounded otherwise, {undecided_pixels} undecided")
    assert kept_pixels > 0.25 * pixels and rounded < 0.02 * pixels + 2 and undecided_pixels < 0.03 * pixels + 2


def test_a_batch(ask, tmp_path: Path):
    random = np.random.default_rng(7)
    p = model.Parameters(enableBurstMode=True)
    depth = np.stack([scene(random, 60, 106) for _ in range(6)])
    np.save(tmp_path / "depth.npy", depth)
    paths = {"depth": str(tmp_path / "depth.npy"), "distance": str(tmp_path / "distance.npy")}
    ask(**paths, **wire(p), seed=3, camera="batch", frame=9)
    found = np.load(tmp_path / "distance.npy")
    for item, (image, sensed) in enumerate(zip(depth, found, strict=True)):
        expected = model.time_of_flight(image, p, 3, "batch", 9, item)
        assert np.mean(np.abs(sensed - expected) > 0.0011) < 2e-3


def confidence_frames(random, count):
    """Depths and amplitudes of all kinds."""
    for number in range(count):
        height, width = random.integers(1, 60, 2)
        top = random.choice([6, 300, 65535], 2)
        frames = random.integers(0, top[:, None, None], (2, height, width), endpoint=True).astype(np.uint16)
        yield random.choice([0.0, 0.1, 0.2, 0.3, 5.0, 100.0, 1e4, 5e6]), frames[0], frames[1]


def test_confidence_is_depthais(depth_eval, tmp_path: Path):
    dai = pytest.importorskip("depthai")
    random = np.random.default_rng(11)
    pipelines = {}

    def theirs(threshold, depth, amplitude):
        if threshold not in pipelines:
            pipeline = dai.Pipeline(False)
            node = pipeline.create(dai.node.ToFDepthConfidenceFilter)
            node.setRunOnHost(True)
            node.initialConfig.confidenceThreshold = threshold
            queues = [node.depth.createInputQueue(), node.amplitude.createInputQueue()]
            queues += [node.filteredDepth.createOutputQueue(), node.confidence.createOutputQueue()]
            pipeline.start()
            pipelines[threshold] = pipeline, node, queues
        queues = pipelines[threshold][2]
        for queue, pixels in zip(queues, (depth, amplitude)):
            frame = dai.ImgFrame()
            frame.setType(dai.ImgFrame.Type.RAW16)
            frame.setWidth(pixels.shape[1])
            frame.setHeight(pixels.shape[0])
            frame.setData(np.ascontiguousarray(pixels).view(np.uint8).reshape(-1))
            queue.send(frame)
        got = [np.array(queue.get().getData()).view(np.uint16)[: depth.size] for queue in queues[2:]]
        return [pixels.reshape(depth.shape) for pixels in got]

    kept = lost = 0
    for threshold, depth, amplitude in confidence_frames(random, 120):
        np.save(tmp_path / "depth.npy", depth)
        np.save(tmp_path / "amplitude.npy", amplitude)
        names = ("depth", "amplitude", "filtered", "confidence")
        depth_eval("depth_confidence", threshold=threshold, **{name: str(tmp_path / f"{name}.npy") for name in names})
        wanted = theirs(threshold, depth, amplitude)
        for name, pixels in zip(names[2:], wanted):
            np.testing.assert_array_equal(np.load(tmp_path / f"{name}.npy"), pixels, err_msg=f"{name} {threshold}")
        kept += np.count_nonzero(wanted[0])
        lost += np.count_nonzero(depth) - np.count_nonzero(wanted[0])
    assert kept > 1000 and lost > 1000
    for pipeline, *_ in pipelines.values():
        pipeline.stop()
    STOPPED.append(pipelines)


# Destroying a stopped pipeline can hang.
STOPPED = []
