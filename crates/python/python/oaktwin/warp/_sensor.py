# mypy: ignore-errors
"""Depth sensors in Warp's kernels."""

import warnings
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import warp as wp

from .._findings import Error, FindingWarning
from .._sensors import DepthSensor as RustSensor
from .._settings import indices
from ._arrays import Images, returned
from ._chain import Chain, to_metres, to_millimetres
from ._drift import pairs_of
from ._filters import decimated, parsed
from ._single_view import SingleView
from ._stereo_noise import StereoNoise
from ._time_of_flight import TimeOfFlight

wp.set_module_options({"enable_backward": False, "fast_math": False, "fuse_fp": False})

ENGINES: dict[str, Any] = {"stereo-noise": StereoNoise, "single-view": SingleView, "time-of-flight": TimeOfFlight}


@wp.kernel
def _advance(frame: wp.array(dtype=wp.uint32)):
    frame[0] = frame[0] + wp.uint32(1)


class DepthSensor:
    """The depth sensor of a device, on arrays of Warp, PyTorch, JAX or NumPy on the device where they are.

    It measures the same bits as `oaktwin.DepthSensor` with the same arguments, and compares itself with it for every new image size:
    what it cannot reproduce is an error, never another result.

    device: the `oaktwin.Device`.
    on: Warp's device, such as "cuda:0" or "cpu"; by default Warp's preferred one.
    parameters: as of `oaktwin.DepthSensor`, a mapping. A value can be a sequence of N numbers, one for each environment: most numbers of
        "time-of-flight" and "single-view", and "bias", "pixelLocking", "jitter", "closeRangeFactor" and "dropout" of "stereo-noise".
    device_seed: the seed of the unit's calibration error, or N seeds, one for each environment.
    drift: the change of the pair since its calibration, as of `oaktwin.DepthSensor`, or N of them, one for each environment.
    options: the other arguments of `oaktwin.DepthSensor`: sensor, fx, hfov_deg, camera, name, engine, preset, filters, extended_disparity,
        isaac, seed. "brightness" needs colours, and has no effect.

    Raises oaktwin.Error as `oaktwin.DepthSensor` does, and for what Warp does not compute: engines that match pairs, and in the
        first call multipath of "time-of-flight".

    A call, `sensor(depth, *, frame=None, seed=None, out=None, reasons=None)`, measures a batch:

    depth: (N, H, W) or (N, H, W, 1), float32 metres or uint16 millimetres, C-contiguous, on the sensor's device.
    frame: the number of the frame, as of `oaktwin.DepthSensor`. By default, calls are numbered from 0 on, in the memory of the device, so that a
        captured CUDA graph measures a new frame each time it is launched.
    seed: N seeds. Environment i is measured like the image of a sensor with `seed[i]`.
    out: the output array, float32 metres or uint16 millimetres; it may be `depth`.
    reasons: a uint8 array (N, H, W), or of the size of decimated images, on the same device, for the codes why pixels have no value; see `oaktwin.DepthSensor.annotate`.

    Returns `out`, or a new array of the library of `depth`, with its shape, which decimation reduces, and its unit; 0 where invalid. After the first call with a
    size, nothing is allocated if `out` is given, nothing is copied to the host, and nothing waits for the device. A temporal filter remembers
    the images of each environment until the size or the number of the images changes; see `reset()`.

    Raises TypeError for an object that is not an array or has another dtype, oaktwin.Error for an array on another device, with
    gradients, not contiguous or of another shape, for colour images, and for a wrong number of seeds or parameters.
    """

    def __init__(
        self,
        device: Any,
        *,
        on: str | None = None,
        parameters: Mapping[str, Any] | None = None,
        device_seed: int | Sequence[int] | None = None,
        drift: Mapping[str, float] | Sequence[Mapping[str, float]] | None = None,
        **options: Any,
    ) -> None:
        wp.init()
        try:
            self._on = wp.get_device(on)
        except Exception as error:
            known = ", ".join(str(known) for known in wp.get_devices())
            raise Error(f"on: '{on}' is not a device of Warp; expected one of {known}") from error
        scalars, worlds = _split(parameters)
        seeds = None if device_seed is None or isinstance(device_seed, (int, np.integer)) else [int(seed) for seed in device_seed]
        drifts = None if drift is None or isinstance(drift, Mapping) else list(drift)
        if seeds == [] or drifts == []:
            raise Error(f"{'drift' if drifts == [] else 'device_seed'}: is empty; pass one for each environment")
        if seeds and drifts and len(seeds) != len(drifts):
            raise Error(f"drift: has {len(drifts)} values, and device_seed {len(seeds)}; pass one for each environment")
        units: list[Any] = []
        if seeds or drifts:
            both = zip(seeds or [device_seed] * len(drifts), drifts or [drift] * len(seeds))
            units = [RustSensor(device, parameters=scalars, device_seed=seed, drift=own, **options) for seed, own in both]
            if seeds and "bias" not in units[0].parameters:
                raise Error(f"device_seed: has a seed for each environment, but {units[0].engine} has no bias of units; leave it out")
            device_seed = seeds[0] if seeds else device_seed
            drift = drifts[0] if drifts else drift
        options["drift"] = drift
        # The engine checks the smallest and the largest value of the environments against its own limits.
        if worlds:
            RustSensor(device, parameters=_with(scalars, worlds, np.max), device_seed=device_seed, **options)
        self._rust = RustSensor(device, parameters=_with(scalars, worlds, np.min), device_seed=device_seed, **options)
        self._units = units
        name = self._rust.engine
        if name not in ENGINES:
            raise Error(f"engine: '{name}' does not run in Warp; expected {', '.join(ENGINES)}, or use oaktwin.DepthSensor")
        self._engine = ENGINES[name]
        new = set(self._rust.parameters) - self._engine.PARAMETERS - self._engine.COLOURS
        if new:
            raise Error(f"parameters: {', '.join(sorted(new))} are unknown to Warp's {name}; use oaktwin.DepthSensor")
        unknown = set(worlds) - set(self._engine.PER_WORLD)
        if unknown:
            known = ", ".join(self._engine.PER_WORLD) or "none"
            raise Error(f"parameters: {', '.join(sorted(unknown))} cannot differ between environments; those that can: {known}")
        lengths = {name: len(values) for name, values in worlds.items()} | ({"units": len(units)} if units else {})
        if len(set(lengths.values())) > 1:
            raise Error(f"parameters: have different lengths, {lengths}; pass a number for each environment")
        self._worlds, self._count = worlds, next(iter(lengths.values()), None)
        self._camera = options.get("name") or device.depth_camera(options.get("sensor")).name
        self._seed = self._rust.seed
        self._shape: tuple[int, ...] | None = None
        self._kernels: Chain | None = None
        self._keys_of: Any = None
        self._numbered = wp.zeros(1, dtype=wp.uint32, device=self._on)
        self._named = wp.zeros(1, dtype=wp.uint32, device=self._on)
        self._no_reasons = wp.empty((0, 0, 0), dtype=wp.uint8, device=self._on)

    # A batch of one size needs no new memory: a `Stream` does not leave environments out.
    prefers_whole_batches = True

    @property
    def engine(self) -> str:
        """The name of the engine."""
        return self._rust.engine

    @property
    def filters(self) -> list[str]:
        """The filters, as of `oaktwin.DepthSensor`."""
        return self._rust.filters

    def latency(self, connection: str | None = None) -> Any:
        """The latency of the device, as of `oaktwin.DepthSensor`."""
        return self._rust.latency(connection)

    @property
    def parameters(self) -> dict[str, Any]:
        """The engine's parameters by name, for the most recent image size; arrays where they differ between environments."""
        return {**self._rust.parameters, **self._of_units(), **self._worlds}

    @property
    def seed(self) -> int:
        """The noise seed; of a sensor with `seed=None`, the one that was drawn."""
        return self._seed

    def reset(self, items: Any = None, *, seed: int | None = None) -> None:
        """Starts a new sequence, as `oaktwin.DepthSensor.reset` does: temporal filters forget earlier images.

        items: the numbers of the environments that start a new sequence, or a mask; the others go on.
        seed: the new noise seed, with which frames are numbered from 0 on. Without it, their numbering continues.
        """
        if self._kernels is not None:
            numbers = indices("items", items, self._shape[0])
            self._kernels.reset(wp.array(numbers, dtype=int, device=self._on))
        if seed is not None:
            self._rust.reset(seed=seed)
            self._seed = self._rust.seed
            self._keys_of = None
            self._numbered.zero_()

    def __call__(
        self, depth: Any, rgb: Any = None, *, frame: int | None = None, seed: Any = None, out: Any = None, reasons: Any = None
    ) -> Any:
        """Measures a batch; see the class."""
        if rgb is not None:
            raise Error("rgb: colour images are not used in Warp; leave them out, or use oaktwin.DepthSensor")
        images = Images("depth", depth, self._on)
        if self._count is not None and images.shape[0] != self._count:
            raise Error(f"depth: has {images.shape[0]} images, but parameters have {self._count} values; pass one for each")
        if frame is not None and (isinstance(frame, bool) or not isinstance(frame, (int, np.integer)) or not 0 <= frame < 1 << 64):
            raise Error(f"frame: is {frame!r}; pass a whole number from 0 to 2^64 - 1")
        shape = (images.shape[0], *decimated(self._rust.filters, *images.shape[1:]))
        dims = (*shape, *images.dims[3:])
        if out is None:
            out = images.empty(dims)
        for name, written in [("out", out), ("reasons", reasons)]:
            if isinstance(written, np.ndarray) and not written.flags.writeable:
                raise Error(f"{name}: is read-only; pass an array that can be written to")
        # Some libraries have arrays that cannot be written.
        given = wp.empty(dims, dtype=images.array.dtype, device=self._on) if out is None else out
        target = Images("out", given, self._on)
        if target.shape != shape:
            raise Error(f"out: has the shape {target.dims}, and measured depth {dims}; pass an array of this shape")
        codes = self._reasons(reasons, shape)
        with images.stream():
            self._prepare(images.shape)
            keys, items = self._random(seed, images.shape[0])
            if frame is None:
                number = self._numbered
            else:
                number = self._named
                number.fill_(int(frame) & 0xFFFFFFFF)
            self._measure(images, target, keys, items, number, codes)
            if frame is None:
                wp.launch(_advance, 1, [], [self._numbered], device=self._on)
        return returned(target.array.reshape(dims), images.library) if out is None else out

    def _reasons(self, reasons: Any, shape: tuple[int, ...]) -> Any:
        if reasons is None:
            return self._no_reasons
        if isinstance(reasons, np.ndarray):
            reasons = wp.array(reasons, device="cpu", copy=False) if reasons.flags.c_contiguous else None
        elif type(reasons).__module__.partition(".")[0] == "torch":
            reasons = wp.from_torch(reasons) if reasons.is_contiguous() else None
        is_array = isinstance(reasons, wp.array)
        if not is_array or reasons.dtype != wp.uint8 or reasons.shape != shape or reasons.device != self._on:
            raise Error(f"reasons: pass a C-contiguous uint8 array of shape {shape} on {self._on}")
        return reasons

    def _measure(self, images: Images, target: Images, keys: Any, items: Any, number: Any, codes: Any) -> None:
        if 0 in images.shape:
            return
        shape, on = images.shape, self._on
        depth = images.array
        if images.millimetres:
            wp.launch(to_metres, shape, [depth], [self._metres_in], device=on)
            depth = self._metres_in
        out = self._metres_out if target.millimetres else target.array
        self._kernels.launch(depth, keys, items, number, out, codes)
        if target.millimetres:
            wp.launch(to_millimetres, target.shape, [out], [target.array], device=on)

    def _prepare(self, shape: tuple[int, ...]) -> None:
        """Allocates what images of a size need, and compares one with the reference."""
        if shape == self._shape:
            return
        if 0 not in shape:
            if self._shape is None or shape[1:] != self._shape[1:]:
                self._compare(shape[1:])
            # The drift of a size has to be known before the parameters that follow from it.
            pairs = pairs_of(self._units or [self._rust], shape[1:], self._on)
            kernels = self._engine(self._rust.parameters, {**self._of_units(), **self._worlds}, shape, self._on)
            self._kernels = Chain(kernels, self._rust.filters, shape, self._on, pairs)
            self._metres_in = wp.empty(shape, dtype=float, device=self._on)
            self._metres_out = wp.empty(self._kernels.shape, dtype=float, device=self._on)
            self._items = wp.array(np.arange(shape[0], dtype=np.uint32), device=self._on)
            self._no_items = wp.zeros(shape[0], dtype=wp.uint32, device=self._on)
        self._keys_of = None
        self._shape = shape

    def _of_units(self) -> dict[str, Any]:
        """What follows from the seed of a unit and its drift, such as the bias and the share of pixels that its matcher loses."""
        all_values = {name: [unit.parameters[name] for unit in self._units] for name in self._engine.PER_WORLD}
        return {name: np.array(values, np.float64) for name, values in all_values.items() if len(set(values)) > 1}

    def _random(self, seed: Any, count: int) -> tuple[Any, Any]:
        """The keys and items of the random numbers."""
        if count == 0:
            return None, None
        wanted = self._seed if seed is None else list(seed)
        if isinstance(wanted, list) and len(wanted) != count:
            raise Error(f"seed: has {len(wanted)} values for {count} images; pass one for each")
        if self._keys_of != wanted:
            seeds = wanted if isinstance(wanted, list) else [wanted]
            if any(isinstance(one, bool) or not isinstance(one, (int, np.integer)) or not 0 <= one < 1 << 64 for one in seeds):
                raise Error("seed: pass whole numbers from 0 to 2^64 - 1")
            keys = [self._engine.keys(int(one), self._camera) for one in seeds]
            self._keys = wp.array(np.array(keys, np.uint32), device=self._on)
            self._keys_of = wanted
        return self._keys, self._items if seed is None else self._no_items

    def _compare(self, size: tuple[int, ...]) -> None:
        """Compares an image with the reference, which also resolves the parameters for its size."""
        exact = _test_image(*size)
        # A filter with a memory shows in later frames.
        numbers = (5, 6, 7) if any(parsed(text)[0] == "temporal" for text in self._rust.filters) else (5,)
        self._rust.reset()
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", FindingWarning)
            expected = [self._rust(exact, frame=number) for number in numbers]
        shape = (1, *size)
        pairs = pairs_of([self._rust], size, self._on)
        kernels = Chain(self._engine(self._rust.parameters, {}, shape, self._on), self._rust.filters, shape, self._on, pairs)
        keys = wp.array(np.array([self._engine.keys(self._seed, self._camera)], np.uint32), device=self._on)
        items, frame = (wp.zeros(1, dtype=wp.uint32, device=self._on) for _ in range(2))
        out = wp.empty(kernels.shape, dtype=float, device=self._on)
        for number, wanted in zip(numbers, expected, strict=True):
            frame.fill_(number)
            kernels.launch(wp.array(exact[None], dtype=float, device=self._on), keys, items, frame, out, self._no_reasons)
            differ = int((out.numpy()[0] != wanted).sum())
            if differ:
                raise Error(
                    f"device: {differ} of {wanted.size} pixels of a test image differ from oaktwin.DepthSensor on {self._on};"
                    " use oaktwin.DepthSensor"
                )


def _split(parameters: Any) -> tuple[Any, dict[str, Any]]:
    """The parameters that all environments share, and those that have a value for each."""
    if not isinstance(parameters, Mapping):
        return parameters, {}
    worlds = {}
    for name, value in parameters.items():
        if not isinstance(value, (str, bool, int, float)) and np.ndim(_host(value)) > 0:
            array = np.asarray(_host(value), np.float64)
            if array.ndim != 1 or not len(array):
                raise Error(f"parameters: {name} has the shape {array.shape}; pass a number for each environment")
            worlds[name] = array
    return {name: value for name, value in parameters.items() if name not in worlds}, worlds


def _host(value: Any) -> Any:
    return value.detach().cpu().numpy() if hasattr(value, "detach") else value.numpy() if isinstance(value, wp.array) else value


def _with(scalars: Any, worlds: dict[str, Any], choose: Any) -> Any:
    if not worlds:
        return scalars
    return {**(scalars or {}), **{name: float(choose(values)) for name, values in worlds.items()}}


def _test_image(height: int, width: int) -> Any:
    """Depth with slopes, near objects, holes and what is too near or too far."""
    y, x = np.mgrid[0:height, 0:width]
    depth = 2.0 + 3.0 * x / width + 0.5 * np.sin(y / 3.0)
    near = (x * 7 // max(width, 1)) % 2 == 1
    depth = np.where(near & (y % 5 > 1), 0.4 + 0.1 * (x % 11), depth)
    depth[(x * 13 + y * 7) % 29 == 0] = np.inf
    depth[(x * 5 + y * 11) % 37 == 0] = 0.05
    return depth.astype(np.float32)
