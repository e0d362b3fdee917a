"""Arrays of every kind as input and output, without copies where documented."""

import array
import ctypes
import tracemalloc

import numpy as np
import pytest

import oaktwin
from oaktwin._oaktwin import _read_from


@pytest.fixture(scope="module")
def sensor(device):
    return oaktwin.DepthSensor(device, seed=1)


class Interface:
    """An object with only NumPy's array interface."""

    def __init__(self, values):
        self.values = values

    @property
    def __array_interface__(self):
        return self.values.__array_interface__


class Capsule:
    """An object with only DLPack."""

    def __init__(self, values, device=(1, 0)):
        self.values, self.device = values, device

    def __dlpack__(self, **options):
        return self.values.__dlpack__(**options)

    def __dlpack_device__(self):
        return self.device


def test_nothing_is_copied(sensor, room):
    depth, _ = room
    address = depth.ctypes.data
    for same in [depth, memoryview(depth), Interface(depth), Capsule(depth.copy())]:
        if isinstance(same, Capsule):
            address = same.values.ctypes.data
        assert _read_from(same) == address
        assert np.array_equal(sensor(same, frame=0), sensor(depth, frame=0))
    millimetres = np.full((4, 5), 700, np.uint16)
    assert _read_from(millimetres) == millimetres.ctypes.data
    batch = np.stack([depth, depth])
    assert _read_from(batch[1:]) == batch[1].ctypes.data
    read_only = depth.copy()
    read_only.flags.writeable = False
    assert _read_from(read_only) == read_only.ctypes.data
    plain = array.array("f", depth.ravel())
    shaped = memoryview(plain).cast("B").cast("f", depth.shape)
    assert _read_from(shaped) == plain.buffer_info()[0]


def test_non_contiguous_arrays_are_copied(sensor, room):
    depth, _ = room
    raw = np.zeros(depth.nbytes + 1, np.uint8)
    crooked = raw[1:].view(np.float32).reshape(depth.shape)
    crooked[...] = depth
    wide = np.repeat(depth, 2, axis=1)[:, ::2]
    for other in [np.asfortranarray(depth), depth[::-1][::-1].copy(order="F"), wide, depth.astype(">f4"), crooked]:
        assert _read_from(other) != other.ctypes.data
        assert np.array_equal(sensor(other, frame=0), sensor(depth, frame=0))
    column = np.full((5, 1), 2.0, np.float32)
    assert np.array_equal(sensor(np.asfortranarray(column), frame=0), sensor(column, frame=0))


def test_results_are_written_in_place(sensor, room):
    depth, _ = room
    out = np.full(depth.shape, -1, np.float32)
    expected = sensor(depth, frame=0)
    assert sensor(depth, out=out, frame=0) is out and np.array_equal(out, expected)
    plain = array.array("f", bytes(4 * depth.size))
    view = memoryview(plain).cast("B").cast("f", depth.shape)
    assert sensor(depth, out=view, frame=0) is view
    assert np.array_equal(np.frombuffer(plain, np.float32).reshape(depth.shape), expected)
    # Consecutive rows of a larger array.
    whole = np.zeros((3, *depth.shape), np.float32)
    sensor(depth, out=whole[1])
    assert np.array_equal(whole[1], expected) and not whole[[0, 2]].any()
    with pytest.raises(TypeError, match="list is not an array"):
        sensor(depth, out=[[0.0]])
    with pytest.raises(oaktwin.Error):
        sensor(depth, out=bytes(depth.nbytes))


class Tensor(Capsule):
    """An object with the old protocol of DLPack, whose memory NumPy shares read-only, and with `__array__`: a tensor of PyTorch
    2.8 and older.
    """

    def __dlpack__(self, stream=None):
        return self.values.__dlpack__()

    def __array__(self, dtype=None, copy=None):
        return self.values


class Copies(Tensor):
    """The same, except that `__array__` makes copies."""

    def __array__(self, dtype=None, copy=None):
        return self.values.copy()


class Old(Capsule):
    """An object with the old protocol of DLPack alone."""

    def __dlpack__(self, stream=None):
        return self.values.__dlpack__()


def test_results_are_written_to_foreign_arrays(sensor, room):
    depth, _ = room
    expected = sensor(depth, frame=0)
    filtered = oaktwin.filters.median(depth)
    for kind in [Capsule, Tensor, Interface]:
        out = kind(np.full(depth.shape, -1, np.float32))
        assert sensor(depth, frame=0, out=out) is out and np.array_equal(out.values, expected), kind
        out = kind(np.full(depth.shape, -1, np.float32))
        assert oaktwin.filters.median(depth, out=out) is out and np.array_equal(out.values, filtered), kind
        assert np.array_equal(sensor(kind(depth.copy()), frame=0), expected), kind


def test_each_reason_not_to_write_has_its_message(sensor, room):
    depth, _ = room
    out = np.empty_like(depth)
    frozen = out.copy()
    frozen.flags.writeable = False
    for other, message in [
        (frozen, "out: is read-only; pass an array that can be written to"),
        (memoryview(frozen), "out: is read-only"),
        (depth, "out: overlaps the input; pass a separate array"),
        (Copies(out), "out: gives NumPy copies of its memory; pass a NumPy array"),
        (Old(out), r"out: shares its memory with NumPy [0-9.]+ by DLPack, read-only; pass a NumPy array"),
        (out.T.copy().T, "out: is not C-contiguous"),
    ]:
        with pytest.raises(oaktwin.Error, match=message):
            sensor(depth, out=other)


def test_overlapping_output_is_rejected(sensor, room):
    both = np.zeros((3, *room[0].shape), np.float32)
    for depth, out in [(both[0], both[0]), (Capsule(both[0]), both[0]), (both[:2], both[1:]),
                       (Interface(both[0]), both[0]), (memoryview(both[0]), both[0])]:
        with pytest.raises(oaktwin.Error, match="pass a separate array"):
            sensor(depth, out=out)


def test_allocates_no_temporary_image(device):
    sensor = oaktwin.DepthSensor(device)
    depth = np.full((64, 60, 106), 2.0, np.float32)
    out = np.empty_like(depth)
    sensor(depth, out=out)
    tracemalloc.start()
    sensor(depth, out=out)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 10_000


def test_memory_of_another_device(sensor, room):
    with pytest.raises(oaktwin.Error, match="memory of another device .*copy it to the CPU first"):
        sensor(Capsule(room[0], device=(2, 0)))


def test_jax(sensor, room):
    jax = pytest.importorskip("jax")
    depth = jax.numpy.asarray(room[0])
    own = depth.unsafe_buffer_pointer()
    assert _read_from(depth) == own
    expected = sensor(room[0], frame=0)
    assert np.array_equal(sensor(depth, frame=0), expected)
    # The result can be read by DLPack without a copy.
    back = jax.dlpack.from_dlpack(expected, copy=None)
    assert np.array_equal(back, expected)
    with pytest.raises(oaktwin.Error, match="read-only"):
        sensor(room[0], out=depth)
    whole = jax.numpy.asarray((np.nan_to_num(room[0], posinf=0, neginf=0) * 1000).clip(0).astype(np.uint16))
    assert sensor(whole).dtype == np.uint16


def test_addresses_are_real(room):
    depth, _ = room
    first = ctypes.c_float.from_address(_read_from(depth) + 4 * depth.shape[1])
    assert first.value == depth[1, 0]
