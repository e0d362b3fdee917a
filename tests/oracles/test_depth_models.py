"""The program's sensor models against plain NumPy."""


import numpy as np
import pytest

import depth_models

F = np.float32


class Evaluator:
    """The program's models over a pipe."""

    def __init__(self, ask, folder):
        self.ask = ask
        self.folder = folder

    def single_view(self, depth, rgb=None, positions=None, parameters=None, assumptions=None, **rest):
        """What the program makes of it: its outputs by name."""
        inputs = {"depth": depth, "rgb": rgb, "positions": positions}
        request = {}
        for name, array in inputs.items():
            if array is not None:
                request[name] = str(self.folder / f"{name}.npy")
                np.save(request[name], array)
        names = ["distance", "positions", "colors", "imager", "view"]
        out = {name: str(self.folder / f"out_{name}.npy") for name in names}
        texts = lambda values: {name: str(value) for name, value in (values or {}).items()}
        answer = self.ask(
            op="single_view",
            **request,
            out=out,
            parameters=texts(parameters),
            assumptions=texts(assumptions),
            **rest,
        )
        assert "error" not in answer, answer
        return {name: np.load(out[name]) for name in answer["written"]}


@pytest.fixture(scope="module")
def evaluator(depth_eval, tmp_path_factory):
    return Evaluator(depth_eval.answer, tmp_path_factory.mktemp("depth"))


def scene(random, height, width):
    """Depth, colours and positions: slanted and level objects before a background, with every kind of invalid value."""
    y, x = np.mgrid[0:height, 0:width].astype(F)
    z = np.full((height, width), random.uniform(3, 9), F)
    rgb = random.integers(0, 256, (height, width, 4)).astype(np.uint8)
    for _ in range(random.integers(2, 9)):
        x0, y0 = random.uniform(-10, width), random.uniform(-10, height)
        w, h = random.uniform(1, width), random.uniform(1, height)
        inside = (x >= x0) & (x < x0 + w) & (y >= y0) & (y < y0 + h)
        slant = random.choice([0, random.normal(0, 0.02)])
        z = np.where(inside, F(random.uniform(0.3, 6)) + F(slant) * (x - F(x0)), z).astype(F)
        rgb[inside] = random.integers(0, 256, 4) + random.integers(0, 30) * (x[inside, None].astype(int) % 2)
    wrong = random.random((height, width))
    for i, value in enumerate([np.nan, np.inf, -np.inf, 0, -1, 1e-30, 1e30]):
        z[(wrong > 0.002 * i) & (wrong < 0.002 * (i + 1))] = value
    return z, rgb, random.normal(0, 1, (height, width, 4)).astype(F)


def parameters(random):
    return {
        "baselineMM": random.choice([75, -75, 20, 0.5, 55, -3.25]),
        "focalLengthPixel": random.choice([805, 566, 897, 457]),
        "sensorSizePixel": random.choice([1280, 640, 2560]),
        "maxDisparityPixel": random.choice([95, 191, 10.5, 110]),
        "minDistance": random.choice([0, 0.6, 0.2, 2.5]),
        "maxDistance": random.choice([4.0, 12, 1e7, 1e39]),
        "noiseMean": random.choice([0, 0.25, 0.1, 8, 0.37]),
        "noiseSigma": random.choice([0, 0.2, 0.25, 1.7]),
        "noiseDownscaleFactorPixel": random.choice([1, 2, 3, 1.5, 7.3]),
        "confidenceThreshold": random.choice([0, 0.5, 0.8, 0.95, 1]),
        "outlierRemovalEnabled": int(random.choice([0, 1, 2, 3, 3, 5])),
        "rgbDepthOutputMode": int(random.integers(0, 8)),
    }


OTHERS = {
    "depth": ["recomputed"],
    "max-disparity-unit": ["sensor"],
    "max-disparity": ["clamp"],
    "range-cut": ["after"],
    "direction": ["left"],
    "target-rounding": ["floor"],
    "collision": ["last"],
    "confidence-at": ["target"],
    "confidence-comparison": ["strict", "literal"],
    "sobel-gain": [0.25, 3.7],
    "grain": [1, 2.5],
    "luma": ["rec601", "mean"],
    "luma-rounding": ["none"],
    "quantizer": ["floor"],
    "sigma-unit": ["steps"],
    "invalid": ["nan", "input"],
    "outlier-neighbourhood": ["4"],
}


def check(ours, expected, what):
    """The same pixels are valid and have the same values: NumPy rounds float32 as the program does."""
    assert ours.keys() == expected.keys(), what
    for name, array in expected.items():
        mine = ours[name]
        assert mine.dtype == array.dtype and mine.shape == array.shape, (name, what)
        if name == "distance":
            assert np.array_equal(mine > 0, array > 0), (np.count_nonzero((mine > 0) != (array > 0)), what)
        assert np.array_equal(mine, array, equal_nan=mine.dtype == F), (name, what)


def test_random_numbers(evaluator):
    """The words of Philox equal Random123's reference; normal numbers equal the exact transform."""
    words = depth_models.philox(([0x243F6A88], [0x85A308D3], [0x13198A2E], [0x03707344]), (0xA4093822, 0x299F31D0))
    assert [int(w[0]) for w in words] == [0xD16CFE09, 0x94FDCCEB, 0x5001E420, 0x24126EA1]
    key = depth_models.plane_key(1, "left", depth_models.STAGE_JITTER)
    words = depth_models.row_words(key, 0, 0, 50, 64).astype(float).reshape(50, 2, 2, 16)
    u = (np.floor(words[:, :, 0] / 2) + 0.5) / 2**31
    angle = words[:, :, 1] / 2**32 * 2 * np.pi
    exact = np.stack([np.cos(angle), np.sin(angle)], axis=2) * np.sqrt(-2 * np.log(u))[:, :, None]
    normals = depth_models.normals(key, 0, 0, 50, 64)
    assert np.abs(normals - exact.reshape(50, 64)).max() < 2e-5


def test_single_view_of_random_scenes(evaluator):
    """Many settings, with and without a colour image, and sizes that are not multiples of a register."""
    random = np.random.default_rng(5)
    assumptions = {name: [depth_models.ASSUMPTIONS[name], *values] for name, values in OTHERS.items()}
    measured = 0
    for i in range(150):
        height, width = int(random.integers(1, 50)), int(random.choice([1, 2, 3, 17, 64, 65, 106, 320]))
        z, rgb, positions = scene(random, height, width)
        changed = random.choice(list(assumptions), random.integers(0, 4), replace=False)
        case = {
            "rgb": rgb if i % 3 else None,
            "positions": positions if i % 2 else None,
            "parameters": parameters(random),
            "assumptions": {name: str(random.choice(assumptions[name])) for name in changed},
            "seed": int(random.integers(0, 2**63)),
            "camera": str(random.choice(["", "left", "Camera_pseudo_depth"])),
            "frame": int(random.integers(0, 2**40)),
            "item": int(random.integers(0, 2**32)),
        }
        expected = depth_models.single_view(z, **numbers(case))
        expected = {name: value for name, value in expected.items() if value is not None}
        check(evaluator.single_view(z, **case), expected, (i, case["parameters"], case["assumptions"]))
        measured += np.count_nonzero(expected["distance"])
    assert measured > 100_000


def numbers(case):
    """Parameters and assumptions, as numbers where possible."""
    assumptions = case.get("assumptions", {})
    of = {name: float(value) if name in ("sobel-gain", "grain") else value for name, value in assumptions.items()}
    parameters = {name: float(value) for name, value in case["parameters"].items()}
    return case | {"parameters": parameters, "assumptions": of}


@pytest.mark.parametrize("name, value", [(name, value) for name, values in OTHERS.items() for value in values])
def test_each_assumption_changes_something(evaluator, name, value):
    """Every assumption is compared, and each changes the result of some scene."""
    random = np.random.default_rng(6)
    changed = False
    for i in range(8):
        z, rgb, positions = scene(random, 40, 320)
        case = {
            "rgb": rgb,
            "positions": positions,
            "parameters": {
                "baselineMM": 75,
                "focalLengthPixel": 805,
                "maxDisparityPixel": [95, 8][i % 2],
                "maxDistance": 5,
                "noiseMean": [0.25, 4][i % 2],
                "outlierRemovalEnabled": 1 + i % 3,
                "confidenceThreshold": [0.8, 1, 0.3, 0][i % 4],
            },
            "seed": i,
            "camera": "left",
            "frame": i,
        }
        usual = depth_models.single_view(z, **numbers(case))
        case["assumptions"] = {name: value}
        expected = depth_models.single_view(z, **numbers(case))
        check(evaluator.single_view(z, **case), expected, case["parameters"])
        changed |= any(not np.array_equal(usual[o], expected[o], equal_nan=o == "positions") for o in usual)
    assert changed


def test_an_oak_d_pro_at_full_size(evaluator):
    """The parameter sheet's OAK-D Pro, at the size of its imagers."""
    random = np.random.default_rng(7)
    z, rgb, positions = scene(random, 800, 1280)
    sheet = {
        "baselineMM": 75,
        "focalLengthPixel": 805,
        "maxDisparityPixel": 95,
        "minDistance": 0.6,
        "maxDistance": 12,
        "noiseMean": 0.25,
        "noiseSigma": 0.2,
        "noiseDownscaleFactorPixel": 2,
        "confidenceThreshold": 0.8,
        "outlierRemovalEnabled": 3,
    }
    case = {"rgb": rgb, "positions": positions, "parameters": sheet, "seed": 1, "camera": "left", "frame": 2}
    check(evaluator.single_view(z, **case), depth_models.single_view(z, **numbers(case)), "sheet")


def test_errors(evaluator):
    np.save(evaluator.folder / "depth.npy", np.ones((2, 3), F))
    np.save(evaluator.folder / "rgb.npy", np.ones((3, 2, 4), np.uint8))
    base = {
        "op": "single_view",
        "depth": str(evaluator.folder / "depth.npy"),
        "out": {"distance": str(evaluator.folder / "distance.npy")},
        "seed": 0,
        "camera": "",
        "frame": 0,
    }
    assert "did you mean" in evaluator.ask(**base, parameters={"maxDist": "3"})["error"]
    assert "baselineMM: 0" in evaluator.ask(**base, parameters={"baselineMM": "0"})["error"]
    error = evaluator.ask(**base, rgb=str(evaluator.folder / "rgb.npy"))["error"]
    assert error == "the colour image is 2x3, the depth 3x2; give both in one size"
