"""PyTorch tensors as input and output, without copies."""

import numpy as np
import pytest

import oaktwin
from oaktwin._oaktwin import _read_from

torch = pytest.importorskip("torch")


@pytest.fixture(scope="module")
def sensor(device):
    return oaktwin.DepthSensor(device, seed=1)


def test_in_without_a_copy(sensor, room):
    depth = torch.from_numpy(room[0].copy())
    assert _read_from(depth) == depth.data_ptr()
    assert np.array_equal(sensor(depth, frame=0), sensor(room[0], frame=0))
    millimetres = torch.full((4, 5), 700, dtype=torch.uint16)
    assert _read_from(millimetres) == millimetres.data_ptr()
    assert sensor(millimetres).dtype == np.uint16
    part = torch.stack([depth, depth])[1:]
    assert _read_from(part) == part.data_ptr()


def test_back_without_a_copy(sensor, room):
    measured = sensor(torch.from_numpy(room[0]))
    assert torch.from_numpy(measured).data_ptr() == measured.ctypes.data
    assert torch.from_dlpack(measured).data_ptr() == measured.ctypes.data


def test_results_are_written_in_the_tensor(sensor, room):
    depth = torch.from_numpy(room[0])
    out = torch.full(depth.shape, -1.0)
    address = out.data_ptr()
    assert sensor(depth, out=out) is out and out.data_ptr() == address
    assert np.array_equal(out.numpy(), sensor(room[0], frame=0))
    with pytest.raises(oaktwin.Error, match="pass a separate array"):
        sensor(out, out=out)


def test_a_batch(sensor):
    batch = torch.linspace(1, 4, 106).repeat(256, 60, 1)
    out = torch.empty_like(batch)
    assert sensor(batch, frame=3, out=out) is out
    assert np.array_equal(out.numpy(), sensor(batch.numpy(), frame=3))
    assert not torch.equal(out[0], out[1])


def test_non_contiguous_tensors(sensor, room):
    depth = torch.from_numpy(room[0])
    turned = depth.T.contiguous().T
    assert _read_from(turned) != turned.data_ptr()
    assert np.array_equal(sensor(turned, frame=0), sensor(depth, frame=0))
    with pytest.raises(oaktwin.Error, match="C-contiguous"):
        sensor(depth, out=turned)
    with pytest.raises(TypeError, match="pass float32 metres"):
        sensor(depth.double())


def test_tensors_with_gradients(sensor, room):
    depth = torch.from_numpy(room[0].copy()).requires_grad_()
    # PyTorch's own message.
    with pytest.raises(RuntimeError, match="detach"):
        sensor(depth)
    assert sensor(depth.detach()).shape == room[0].shape


@pytest.mark.skipif(not torch.cuda.is_available(), reason="no CUDA here")
def test_memory_of_the_gpu(sensor, room):
    with pytest.raises(oaktwin.Error, match="copy it to the CPU first"):
        sensor(torch.from_numpy(room[0]).cuda())
