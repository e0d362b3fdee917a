"""What a policy sees of a depth camera: frames with the camera's rate, delay and losses."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, NamedTuple, Protocol

import numpy as np
import numpy.typing as npt

from ._findings import Error
from ._latency import catalog_latency
from ._policy_image import PolicyImage
from ._random import seeds, uniforms
from ._settings import indices

if TYPE_CHECKING:
    from collections.abc import Sequence

__all__ = ["Observation", "Stream"]

# The uses of random numbers: the third word of a counter.
_EPISODE, _FRAME, _SEED = 0, 1, 2
# More frames than these on their way at once are a mistake in the units.
_MOST_SLOTS = 256
# The arrival of what was never sent, in seconds.
_NEVER = np.inf


class _Sensor(Protocol):
    def __call__(self, depth: Any, rgb: Any = None, *, frame: int | None = None, seed: Any = None) -> Any: ...


class Observation(NamedTuple):
    """What the policies see at one control step. Arrays are copies, which later steps leave alone.

    depth: (N, history, h, w) float32, the newest frames that have arrived, the newest last; metres, or normalized.
    age: (N, history) float32, the seconds since each of these frames was exposed.
    fresh: (N,) bool, whether a newer frame has arrived since the previous step.
    """

    depth: Any
    age: npt.NDArray[np.float32]
    fresh: npt.NDArray[np.bool_]


class Stream:
    """What the policies of many environments see of their depth cameras at each control step: the newest frames that have arrived.

    sensor: an `oaktwin.DepthSensor` or `oaktwin.warp.DepthSensor` without a temporal filter, which cannot follow environments
        whose cameras expose at different times.
    latency: the time from the exposure of a frame until the policy can use it, in seconds: a number, or (low, high), from which
        each episode of each environment draws one; or "catalog", the range of the device in the sensor's mode, from published
        measurements and estimates (`DepthSensor.latency`). There is no default, because it depends on the exposure, the device's
        mode and the connection; `oaktwin.fit_latency` measures yours.
    camera_hz: the rate of the camera, at most `control_hz`.
    control_hz: the rate of calls.
    jitter: the largest additional delay of a single frame, in seconds, uniformly distributed from 0; by default 0, or the catalog's.
    drop: the probability that a frame never arrives.
    history: the number of frames in an observation.
    crop: the pixels to remove from measured images, (top, bottom, left, right).
    resize: the (height, width) of observations; each pixel is the nearest one of the measured image, so that no depth is mixed.
    clip: the (near, far) limits of depth in metres, to which measured depth is clipped.
    normalize: whether `clip` becomes 0 to 1.
    invalid: the value of pixels where nothing was measured, in the unit of observations.
    seed: the seed of rates, delays, losses and the sensor's noise, which replaces the sensor's own.
    first_env: the number of the first environment. A batch split over processes gives the bytes of the whole.

    Raises oaktwin.Error for values out of range, and for a sensor with a temporal filter.

    A call, `stream(depth, rgb=None, *, env_ids=None)`, is one control step:

    depth: the exact depth of all environments at this step, (N, H, W) or (N, H, W, 1), float32 metres, as `sensor` takes it. A Warp array
        is read as a NumPy array on the CPU, and as a torch tensor on a GPU.
    rgb: the colour images, if the sensor uses them.
    env_ids: the environments for which time passes, numbers or a mask, such as those that were reset between two steps; the others
        observe what they observed before. By default all.

    Returns an `Observation`. The cameras expose at their rate, each environment with a phase of its own, at control steps. Only the
    environments whose cameras expose are measured. An episode begins as if its first view had stood still before: the frames of
    the first observation show it, as old as frames usually are.

    Observations are NumPy arrays, or torch tensors where the sensor returns torch tensors, on their device. Raises oaktwin.Error for
    images without a batch dimension, another dtype or N, or another size than at the previous step.

    Not thread-safe: each thread needs its own.
    """

    def __init__(
        self,
        sensor: _Sensor,
        *,
        latency: float | Sequence[float] | str,
        camera_hz: float = 30.0,
        control_hz: float = 50.0,
        jitter: float | None = None,
        drop: float = 0.0,
        history: int = 1,
        crop: Sequence[int] | None = None,
        resize: Sequence[int] | None = None,
        clip: Sequence[float] | None = None,
        normalize: bool = False,
        invalid: float = 0.0,
        seed: int = 0,
        first_env: int = 0,
    ) -> None:
        temporal = [text for text in getattr(sensor, "filters", []) if text.partition(":")[0] == "temporal"]
        if temporal:
            raise Error("sensor: has a temporal filter, but environments expose at different times; leave it out of filters=")
        self._sensor = sensor
        self._control_s = 1 / _number("control_hz", control_hz, above=0.0)
        camera = _number("camera_hz", camera_hz, above=0.0)
        if camera > control_hz:
            remedy = "call the stream at each simulated step, with its rate as control_hz, and use every nth observation"
            raise Error(f"camera_hz: {camera:g} exceeds control_hz, {control_hz:g}, but a step provides one image; {remedy}")
        self._frames_per_step = camera * self._control_s
        most = 0.0
        if isinstance(latency, str):
            if latency != "catalog":
                raise Error(f"latency: is {latency!r}; pass seconds, (low, high), or 'catalog'")
            latency, most = catalog_latency(sensor)
        bounds: list[Any] = list(latency) if isinstance(latency, (tuple, list, np.ndarray)) else [latency, latency]
        if len(bounds) != 2:
            raise Error(f"latency: has {len(bounds)} values; pass seconds, or (low, high)")
        self._latency = [_number("latency", bound) for bound in bounds]
        if self._latency[0] > self._latency[1]:
            raise Error(f"latency: low, {bounds[0]:g}, exceeds high, {bounds[1]:g}; pass (low, high)")
        self._jitter = _number("jitter", most if jitter is None else jitter)
        self._drop = _number("drop", drop)
        if self._drop >= 1:
            raise Error(f"drop: is {drop:g}, so that no frame arrives; pass a probability below 1")
        self._history = _whole("history", history, 1)
        self._image = PolicyImage(crop, resize, clip, normalize, invalid)
        self._seed = _whole("seed", seed, 0)
        self._first_env = _whole("first_env", first_env, 0)
        in_flight = math.ceil((self._latency[1] + self._jitter) * camera) + 1
        self._slots = in_flight + self._history
        if self._slots > _MOST_SLOTS:
            raise Error(
                f"latency: {self._latency[1] + self._jitter:g} s and a history of {self._history} keep {self._slots} frames of each"
                f" environment, more than {_MOST_SLOTS}; pass seconds"
            )
        self._step = 0
        self._shape: tuple[int, ...] | None = None
        self._ring: Any = None

    def __call__(self, depth: Any, rgb: Any = None, *, env_ids: Any = None) -> Observation:
        """Advances all environments by one control step; see the class."""
        depth = _indexable(depth)
        shape = _batch_shape(depth)
        # Also after a first step that failed.
        if self._ring is None:
            self._begin(shape)
        elif shape != self._shape:
            raise Error(f"depth: has the shape {shape}, but earlier steps had {self._shape}; use a stream for each")
        begins = self._age_steps == 0
        frame = np.floor(self._age_steps * self._frames_per_step + self._phase).astype(np.int64)
        steps = np.ones(shape[0], bool)
        if env_ids is not None and self._last is not None:
            steps[:] = False
            steps[indices("env_ids", env_ids, shape[0])] = True
        envs = np.flatnonzero(steps & (begins | (frame > self._last_frame)))
        if len(envs):
            frames = self._measure(envs, depth, rgb)
            if self._ring is None:
                self._ring = _empty((len(begins), self._slots, *frames.shape[1:]), frames)
            first = begins[envs]
            self._stand_still(envs[first], frames[_index(np.flatnonzero(first), frames)])
            self._send(envs[~first], frames[_index(np.flatnonzero(~first), frames)])
        self._last_frame[steps] = frame[steps]
        observation = self._observe(steps)
        self._age_steps[steps] += 1
        self._step += 1
        return observation

    def shape(self, height: int, width: int) -> tuple[int, int, int]:
        """The shape of the observation of one environment, (history, h, w), for images of `height` rows and `width` columns."""
        return (self._history, *self._image.size(height, width))

    def reset(self, env_ids: Any = None) -> None:
        """Starts a new episode of some environments at their next step: with new delays and phases, and without earlier frames.

        env_ids: the numbers of the environments within the batch, or a mask; by default all. The numbering of frames continues, so that
            no noise repeats.
        """
        if self._shape is None:
            return
        count = self._shape[0]
        ids = indices("env_ids", env_ids, count)
        self._episode[ids] += 1
        self._age_steps[ids] = 0
        self._draw(ids)

    def _begin(self, shape: tuple[int, ...]) -> None:
        count = shape[0]
        self._shape = shape
        self._envs = np.arange(count, dtype=np.int64) + self._first_env
        self._episode = np.zeros(count, np.int64)
        # Control steps since the beginning of the episode.
        self._age_steps = np.zeros(count, np.int64)
        self._last_frame = np.zeros(count, np.int64)
        self._phase, self._delay = np.zeros(count), np.zeros(count)
        # Of each slot: the times of exposure and arrival in the episode, and the number of the frame, the newest the highest.
        self._exposed = np.zeros((count, self._slots))
        self._arrives = np.full((count, self._slots), _NEVER)
        self._number = np.full((count, self._slots), -1, np.int64)
        self._next = np.zeros(count, np.int64)
        self._seen = np.full(count, -1, np.int64)
        # The slots and ages of the last observation.
        self._last: tuple[npt.NDArray[np.int64], npt.NDArray[np.float32]] | None = None
        self._all_seeds = seeds(self._seed, (self._envs, 0, _SEED, 0))
        self._seeds = np.array(self._all_seeds, np.uint64)
        self._draw(np.arange(count))

    def _draw(self, ids: npt.NDArray[np.int64]) -> None:
        """Draws what is constant in an episode."""
        phase, delay, _, _ = uniforms(self._seed, (self._envs[ids], self._episode[ids], _EPISODE, 0))
        low, high = self._latency
        self._phase[ids] = phase
        self._delay[ids] = low + delay * (high - low)

    def _measure(self, envs: npt.NDArray[np.int64], depth: Any, rgb: Any) -> Any:
        """Measures environments, and prepares their images for the policy."""
        if getattr(self._sensor, "prefers_whole_batches", False):
            measured = self._sensor(depth, rgb, frame=self._step, seed=self._all_seeds)
            return self._image(measured if len(envs) == len(self._envs) else measured[_index(envs, measured)])
        if len(envs) < len(self._envs):
            depth = depth[_index(envs, depth)]
            rgb = None if rgb is None else rgb[_index(envs, rgb)]
        # Each environment has a seed of its own, so that its noise depends on neither the batch nor the others.
        return self._image(self._sensor(depth, rgb, frame=self._step, seed=self._seeds[envs].tolist()))

    def _send(self, envs: npt.NDArray[np.int64], frames: Any) -> None:
        """Sends the frames that are exposed now on their way. Lost ones take no slot, so that they displace none that has arrived."""
        later, lost, _, _ = uniforms(self._seed, (self._envs[envs], self._step & 0xFFFFFFFF, _FRAME, self._step >> 32))
        now = self._age_steps[envs] * self._control_s
        arrives = now + self._delay[envs] + self._jitter * later
        kept = np.flatnonzero(lost >= self._drop)
        envs = envs[kept]
        slot = self._next[envs] % self._slots
        self._exposed[envs, slot] = now[kept]
        self._arrives[envs, slot] = arrives[kept]
        self._number[envs, slot] = self._next[envs]
        self._ring[_index(envs, self._ring), _index(slot, self._ring)] = frames[_index(kept, frames)]
        self._next[envs] += 1

    def _stand_still(self, envs: npt.NDArray[np.int64], views: Any) -> None:
        """Fills the slots of new episodes with frames of a view that stood still: exposed at the camera's rate, with their delays."""
        self._ring[_index(envs, self._ring)] = views[:, None]
        # The phase is the part of a period that has passed since the last exposure.
        before = np.arange(self._slots - 1, -1, -1) + self._phase[envs, None]
        self._exposed[envs] = -before * self._control_s / self._frames_per_step
        self._arrives[envs] = self._exposed[envs] + self._delay[envs, None]
        self._number[envs] = np.arange(self._slots)
        self._next[envs] = self._slots
        self._seen[envs] = -1

    def _observe(self, steps: npt.NDArray[np.bool_]) -> Observation:
        now = self._age_steps * self._control_s
        # Half a microsecond, so that a delay of whole steps does not depend on rounding.
        here = self._arrives <= now[:, None] + 5e-7
        numbers = np.where(here, self._number, -1)
        newest = np.argsort(numbers, axis=1, kind="stable")[:, -self._history :]
        rows = np.arange(len(now))[:, None]
        age = (now[:, None] - self._exposed[rows, newest]).astype(np.float32)
        number = numbers[rows, newest][:, -1] if len(now) else self._seen
        fresh = steps & (number > self._seen)
        if self._last is not None and not steps.all():
            newest = np.where(steps[:, None], newest, self._last[0])
            age = np.where(steps[:, None], age, self._last[1])
            number = np.where(steps, number, self._seen)
        self._seen, self._last = number, (newest, age)
        images = self._ring
        if images is None:  # no environments
            images = np.empty((0, self._slots, *self._image.size(*(self._shape or (0, 0, 0))[1:3])), np.float32)
        return Observation(images[_index(rows, images), _index(newest, images)], age.copy(), fresh)


def _number(name: str, value: float, above: float | None = None) -> float:
    least = 0.0 if above is None else above
    if not isinstance(value, (int, float, np.number)) or not math.isfinite(value) or value < least or value == above:
        needed = "at least 0" if above is None else f"above {above:g}"
        raise Error(f"{name}: is {value!r}; pass a number {needed}")
    return float(value)


def _whole(name: str, value: int, least: int) -> int:
    if isinstance(value, bool) or not isinstance(value, (int, np.integer)) or not least <= value < 1 << 64:
        raise Error(f"{name}: is {value!r}; pass a whole number of at least {least}")
    return int(value)


def _indexable(depth: Any) -> Any:
    """The depth, in a view of NumPy or PyTorch if it is a Warp array, which cannot be indexed by numbers."""
    if type(depth).__module__.partition(".")[0] != "warp" or not hasattr(depth, "numpy"):
        return depth
    if depth.device.is_cpu:
        return depth.numpy()
    import warp  # type: ignore[import-not-found, import-untyped, unused-ignore]

    return warp.to_torch(depth)


def _batch_shape(depth: Any) -> tuple[int, ...]:
    shape = tuple(getattr(depth, "shape", ()))
    if len(shape) == 4 and shape[3] == 1:
        shape = shape[:3]
    if len(shape) != 3:
        raise Error(f"depth: has the shape {shape}; pass the images of all environments, (N, H, W) or (N, H, W, 1)")
    if "float32" not in str(depth.dtype):
        raise Error(f"depth: has the dtype {depth.dtype}; pass float32 metres")
    return shape


def _index(ids: npt.NDArray[np.int64], of: Any) -> Any:
    """An index into an array: a tensor on the array's device for torch."""
    if type(of).__module__.partition(".")[0] == "torch":
        import torch  # type: ignore[import-not-found, unused-ignore]

        return torch.from_numpy(ids).to(of.device)
    return ids


def _empty(shape: tuple[int, ...], like: Any) -> Any:
    return like.new_empty(shape) if hasattr(like, "new_empty") else np.empty(shape, np.float32)
