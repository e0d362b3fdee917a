"""The filters, compared bit for bit with DepthAI's on random images, or with OpenCV and NumPy where DepthAI has none."""

import multiprocessing
from collections.abc import Iterator
from multiprocessing.connection import Connection
from pathlib import Path

import cv2
import depthai as dai
import numpy as np
import pytest

from depth_eval import DepthEval

PARAMS = dai.filters.params
KERNELS = {3: PARAMS.MedianFilter.KERNEL_3x3, 5: PARAMS.MedianFilter.KERNEL_5x5}
MODES = PARAMS.TemporalFilter.PersistencyMode

# Stopped pipelines, kept because destroying one can hang.
STOPPED = []

# Seconds after which an answer, which takes a few, does not come any more, however busy the machine is.
HANGS_S = 600

# A filter: its name and its settings under DepthAI's names.
Filter = tuple[str, dict]


class Ours:
    """Our filters."""

    def __init__(self, program: DepthEval, folder: Path) -> None:
        self.program = program
        self.folder = folder

    def ask(self, filters: list[str], frames: np.ndarray) -> dict:
        np.save(self.folder / "in.npy", frames)
        files = {"frames": str(self.folder / "in.npy"), "filtered": str(self.folder / "out.npy")}
        return self.program.answer("filters", filters=filters, **files)

    def run(self, filters: list[Filter], frames: np.ndarray) -> np.ndarray:
        answer = self.ask([text(*f) for f in filters], frames)
        assert "error" not in answer, answer
        return np.load(self.folder / "out.npy")


def text(name: str, settings: dict) -> str:
    return f"{name}:" + ",".join(f"{key}={value}" for key, value in settings.items())


@pytest.fixture(scope="module")
def ours(depth_eval: DepthEval, tmp_path_factory: pytest.TempPathFactory) -> Ours:
    return Ours(depth_eval, tmp_path_factory.mktemp("filters"))


def depthai_filter(name: str, settings: dict) -> object:
    if name == "median":
        return KERNELS[settings["size"]]
    made = {"spatial": PARAMS.SpatialFilter, "temporal": PARAMS.TemporalFilter, "speckle": PARAMS.SpeckleFilter}[name]()
    made.enable = True
    for key, value in settings.items():
        setattr(made, key, MODES(value) if key == "persistencyMode" else value)
    return made


def depthai_filtered(filters: list[Filter], frames: np.ndarray) -> np.ndarray:
    """DepthAI's host filters, without a device."""
    pipeline = dai.Pipeline(False)
    node = pipeline.create(dai.node.ImageFilters)
    node.setRunOnHost(True)
    for f in filters:
        node.initialConfig.insertFilter(depthai_filter(*f))
    # All frames at once: that takes half as long as waiting for each. Queues that block lose none.
    size = len(frames)
    node.input.setBlocking(True)
    node.input.setMaxSize(size)
    into, out = node.input.createInputQueue(size, True), node.output.createOutputQueue(size, True)
    pipeline.start()
    for pixels in frames:
        frame = dai.ImgFrame()
        frame.setType(dai.ImgFrame.Type.RAW8 if pixels.dtype == np.uint8 else dai.ImgFrame.Type.RAW16)
        frame.setWidth(pixels.shape[1])
        frame.setHeight(pixels.shape[0])
        frame.setData(np.ascontiguousarray(pixels).view(np.uint8).reshape(-1))
        into.send(frame)
    results = [np.array(out.get().getData()).view(frames.dtype).reshape(frames.shape[1:]) for _ in frames]
    pipeline.stop()
    STOPPED.append((pipeline, node, into, out))
    return np.stack(results)


# Filters, and the frames that pass them.
Request = tuple[list[Filter], np.ndarray]


def serve(there: Connection) -> None:
    """Says that it has started, and serves requests until the input ends."""
    there.send(None)
    while True:
        try:
            requests = there.recv()
        except EOFError:
            return
        there.send([depthai_filtered(*request) for request in requests])


class DepthAI:
    """DepthAI's filters in their own process, because its threads could hang or crash it."""

    def __init__(self) -> None:
        self.start()

    def start(self) -> None:
        context = multiprocessing.get_context("spawn")
        self.here, there = context.Pipe()
        self.process = context.Process(target=serve, args=(there,), daemon=True)
        self.process.start()
        there.close()
        # Without a limit: beside other processes, the start can take minutes.
        self.here.recv()

    def restart(self) -> None:
        self.process.kill()
        self.process.join()
        self.start()

    def filtered(self, requests: list[Request]) -> list[np.ndarray]:
        for _ in range(3):
            try:
                self.here.send(requests)
                if self.here.poll(HANGS_S):
                    return self.here.recv()
            except (EOFError, OSError):
                pass
            print("DepthAI did not answer")
            self.restart()
        raise AssertionError("DepthAI did not answer three times")


@pytest.fixture(scope="module")
def depthai() -> Iterator[DepthAI]:
    peer = DepthAI()
    yield peer
    peer.process.kill()


def images(rng: np.random.Generator, dtype: type, frames: int, height: int, width: int, kind: str) -> np.ndarray:
    """A sequence: of one kind, with and without holes."""
    top = np.iinfo(dtype).max
    shape = (frames, height, width)
    y, x = np.mgrid[:height, :width]
    if kind == "random":
        values = rng.integers(0, top, shape, endpoint=True)
    elif kind == "slope":
        slope = rng.uniform(-3, 3, 2)
        values = 60 + x * slope[0] + y * slope[1] + rng.normal(0, rng.uniform(0, 12), shape)
        if dtype == np.uint16:
            values += rng.choice([0, 800, 32700, 65000])
    elif kind == "steps":
        values = np.kron(rng.integers(0, top, (frames, height // 5 + 1, width // 7 + 1)), np.ones((1, 5, 7)))
        values = values[:, :height, :width] + rng.integers(-2, 3, shape)
    elif kind == "small":
        values = rng.integers(0, 6, shape)
    else:
        values = rng.choice([0, 1, 2, top // 2, top // 2 + 1, top - 1, top], shape)
    values = np.clip(values, 0, top).astype(dtype)
    values[rng.random(shape) < rng.choice([0, 0.02, 0.3, 0.9])] = 0
    return values


KINDS = ["random", "slope", "steps", "small", "extremes"]
SIZES = [(1, 1), (1, 2), (2, 1), (1, 3), (3, 1), (1, 40), (37, 1), (2, 2), (3, 5), (33, 31), (64, 130), (35, 67)]


def cases(seed: int, count: int) -> Iterator[tuple[np.random.Generator, np.ndarray]]:
    """Sequences of all kinds and sizes."""
    rng = np.random.default_rng(seed)
    for number in range(count):
        height, width = SIZES[number % len(SIZES)]
        if rng.random() < 0.4:
            height, width = rng.integers(1, 90, 2)
        dtype = np.uint16 if rng.random() < 0.7 else np.uint8
        kind = KINDS[int(rng.integers(len(KINDS)))]
        yield rng, images(rng, dtype, int(rng.integers(1, 12)), int(height), int(width), kind)


def alpha(rng: np.random.Generator) -> float:
    return float(rng.choice([0, 1, 0.5, 0.4, 0.1, 0.7, rng.random()]))


def spatial(rng: np.random.Generator) -> Filter:
    settings = {
        "alpha": alpha(rng),
        "delta": int(rng.choice([0, 1, 3, 20, 255, rng.integers(256)])),
        "holeFillingRadius": int(rng.choice([0, 1, 2, 3, 9, 255])),
        "numIterations": int(rng.integers(0, 4)),
    }
    return "spatial", settings


def temporal(rng: np.random.Generator) -> Filter:
    delta = int(rng.choice([0, 1, 3, 20, 60, 255, rng.integers(256)]))
    return "temporal", {"alpha": alpha(rng), "delta": delta, "persistencyMode": int(rng.integers(9))}


def speckle(rng: np.random.Generator) -> Filter:
    threshold = int(rng.choice([0, 1, 2, 11, 130, 255, 40000, 65535, 100000, rng.integers(500)]))
    return "speckle", {"speckleRange": int(rng.choice([0, 1, 4, 14, 50, 200, 5000])), "differenceThreshold": threshold}


def median(rng: np.random.Generator) -> Filter:
    return "median", {"size": int(rng.choice([3, 5]))}


def compare(ours: Ours, depthai: DepthAI, requests: list[Request]) -> None:
    for (filters, frames), wanted in zip(requests, depthai.filtered(requests), strict=True):
        got = ours.run(filters, frames)
        assert got.dtype == wanted.dtype
        np.testing.assert_array_equal(got, wanted, err_msg=f"{filters} of {frames.dtype} {frames.shape}")


MAKES = [median, spatial, temporal, speckle]


@pytest.mark.parametrize("make", MAKES)
def test_each_is_depthais(ours: Ours, depthai: DepthAI, make) -> None:
    compare(ours, depthai, [([make(rng)], frames) for rng, frames in cases(1, 120)])


def test_several_in_a_row_are_depthais(ours: Ours, depthai: DepthAI) -> None:
    several = lambda rng: [MAKES[int(rng.integers(4))](rng) for _ in range(int(rng.integers(2, 6)))]
    compare(ours, depthai, [(several(rng), frames) for rng, frames in cases(2, 120)])


def test_each_is_depthais_at_full_size(ours: Ours, depthai: DepthAI) -> None:
    rng = np.random.default_rng(3)
    for dtype in (np.uint8, np.uint16):
        for kind in KINDS:
            frames = images(rng, dtype, 3, 800, 1280, kind)
            compare(ours, depthai, [([make(rng)], frames) for make in MAKES])


@pytest.mark.parametrize("size", [3, 5, 7])
def test_median_is_opencvs_or_sorting(ours: Ours, size: int) -> None:
    for _, frames in cases(4, 60):
        got = ours.run([("median", {"size": size})], frames)
        for before, after in zip(frames, got):
            padded = np.pad(before, size // 2, mode="edge")
            windows = np.lib.stride_tricks.sliding_window_view(padded, (size, size))
            np.testing.assert_array_equal(after, np.median(windows, axis=(2, 3)).astype(before.dtype))
            if size < 7 or before.dtype == np.uint8:
                np.testing.assert_array_equal(after, cv2.medianBlur(before, size))


def test_speckles_are_opencvs(ours: Ours) -> None:
    for rng, frames in cases(5, 60):
        made = speckle(rng)
        # Larger values wrap in this version of OpenCV but not in DepthAI's.
        top = 255 if frames.dtype == np.uint8 else 32767
        made[1]["differenceThreshold"] = min(made[1]["differenceThreshold"], top)
        got = ours.run([made], frames)
        for before, after in zip(frames, got):
            wanted = before.copy()
            signed = wanted.view(np.int16) if wanted.dtype == np.uint16 else wanted
            cv2.filterSpeckles(signed, 0, made[1]["speckleRange"], made[1]["differenceThreshold"])
            np.testing.assert_array_equal(after, wanted, err_msg=f"{made} of {frames.dtype} {frames.shape}")


@pytest.mark.parametrize("mode", ["PIXEL_SKIPPING", "NON_ZERO_MEDIAN", "NON_ZERO_MEAN"])
def test_decimation_is_numpys(ours: Ours, mode: str) -> None:
    for number, (_, frames) in enumerate(cases(6, 40)):
        factor = number % 4 + 1
        height, width = (max(length // factor, 1) for length in frames.shape[1:])
        wanted = np.zeros((len(frames), height, width), frames.dtype)
        for n, y, x in np.ndindex(wanted.shape):
            block = frames[n, y * factor : (y + 1) * factor, x * factor : (x + 1) * factor]
            values = np.sort(block[block > 0])
            if mode == "PIXEL_SKIPPING":
                wanted[n, y, x] = block[0, 0]
            elif len(values):
                middle = values[(len(values) - 1) // 2]
                wanted[n, y, x] = middle if mode == "NON_ZERO_MEDIAN" else int(values.sum()) // len(values)
        got = ours.run([("decimation", {"factor": factor, "mode": mode})], frames)
        np.testing.assert_array_equal(got, wanted)


def test_threshold_is_numpys(ours: Ours) -> None:
    for rng, frames in cases(7, 40):
        low, high = sorted(int(v) for v in rng.integers(0, np.iinfo(frames.dtype).max, 2, endpoint=True))
        got = ours.run([("threshold", {"minRange": low, "maxRange": high})], frames)
        np.testing.assert_array_equal(got, np.where((frames < low) | (frames > high), 0, frames))


def test_defaults_are_depthais(ours: Ours) -> None:
    frame = np.zeros((1, 2, 2), np.uint16)
    said = ours.ask(["median", "spatial", "temporal", "speckle", "decimation", "threshold", "brightness"], frame)
    post = dai.StereoDepthConfig().postProcessing
    s, t, k = PARAMS.SpatialFilter(), PARAMS.TemporalFilter(), PARAMS.SpeckleFilter()
    for own, of_stereo in ((s, post.spatialFilter), (t, post.temporalFilter), (k, post.speckleFilter)):
        for setting in (name for name in dir(own) if name[0].islower() and name != "enable"):
            assert getattr(own, setting) == getattr(of_stereo, setting)
    d, r, b = post.decimationFilter, post.thresholdFilter, post.brightnessFilter
    assert said["filters"][1:] == [
        f"spatial:alpha={short(s.alpha)},delta={s.delta},radius={s.holeFillingRadius},iterations={s.numIterations}",
        f"temporal:alpha={short(t.alpha)},delta={t.delta},persistency={t.persistencyMode.name}",
        f"speckle:range={k.speckleRange},difference={k.differenceThreshold}",
        f"decimation:factor={d.decimationFactor},mode={d.decimationMode.name}",
        f"threshold:min={r.minRange},max={r.maxRange}",
        f"brightness:min={b.minBrightness},max={b.maxBrightness}",
    ]


def short(number: float) -> str:
    """The shortest text of a single-precision number."""
    return str(np.float32(number))
