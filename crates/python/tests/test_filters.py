import numpy as np
import pytest

import oaktwin


@pytest.fixture(scope="module")
def image():
    random = np.random.default_rng(0)
    image = (random.integers(900, 1100, (40, 60)) + 500 * (np.arange(60) > 30)).astype(np.uint16)
    image[random.random(image.shape) < 0.1] = 0
    return image


def test_each_filter(image):
    filters = oaktwin.filters
    calls = {
        "median:size=5": filters.median(image, size=5),
        "spatial:alpha=0.3,delta=40": filters.spatial(image, alpha=0.3, delta=40),
        "speckle:range=8,difference=20": filters.speckle(image, range=8, difference=20),
        "decimation:factor=3": filters.decimation(image, factor=3),
        "threshold:min=950,max=1050": filters.threshold(image, min=950, max=1050),
    }
    for text, got in calls.items():
        expected = oaktwin.Filter(text)(image)
        assert got.dtype == np.uint16 and np.array_equal(got, expected), text
        assert not np.array_equal(got, image), text
        batch = oaktwin.Filter(text)(np.stack([image, image[::-1]]))
        assert np.array_equal(batch[0], got)
        metres = oaktwin.Filter(text)((image / 1000).astype(np.float32))
        assert metres.dtype == np.float32 and np.array_equal(np.rint(metres * 1000), got)
    inside = (image >= 950) & (image <= 1050)
    assert np.array_equal(calls["threshold:min=950,max=1050"], np.where(inside, image, 0))


def test_a_median_is_numpys(image):
    # Only where all pixels are valid, because DepthAI's filter treats 0 specially.
    image = np.where(image == 0, 1000, image).astype(np.uint16)
    windows = np.lib.stride_tricks.sliding_window_view(image, (3, 3)).reshape(38, 58, 9)
    expected = np.median(windows, axis=-1)
    assert np.array_equal(oaktwin.filters.median(image, size=3)[1:-1, 1:-1], expected)


def test_bytes_and_pictures(image):
    small = (image >> 3).astype(np.uint8)
    assert oaktwin.filters.median(small).dtype == np.uint8
    rgb = np.zeros((*image.shape, 3), np.uint8)
    rgb[:, :30] = 200
    got = oaktwin.filters.brightness(image, rgb, min=100, max=250)
    assert np.array_equal(got[:, :30], image[:, :30]) and not got[:, 30:].any()
    batch = oaktwin.filters.brightness(np.stack([image, image]), np.stack([rgb, rgb]), min=100, max=250)
    assert np.array_equal(batch[1], got)


def test_temporal_state(image):
    temporal = oaktwin.filters.temporal(alpha=0.4, persistency=3)
    assert str(temporal).startswith("temporal:alpha=0.4,delta=") and repr(temporal).startswith("<oaktwin.Filter temporal")
    frames = [image, np.zeros_like(image), image + np.uint16(1)]
    first = [temporal(frame) for frame in frames]
    temporal.reset()
    assert np.array_equal([temporal(frame) for frame in frames], first)
    assert not np.array_equal(first[2], frames[2])
    alone = oaktwin.Filter("temporal:alpha=0.4,persistency=3")(np.stack(frames))
    assert np.array_equal(alone[2], oaktwin.Filter("temporal:alpha=0.4,persistency=3")(frames[2]))


@pytest.mark.parametrize("kind", [np.uint16, np.uint8, np.float32])
def test_each_item_of_a_batch_has_a_state(image, kind):
    image = (image / 1000 if kind == np.float32 else image >> 3 if kind == np.uint8 else image).astype(kind)
    frames = [image, np.zeros_like(image), image + kind(1 if kind != np.float32 else 0.001), image]
    temporal = oaktwin.filters.temporal(alpha=0.4, persistency=3)
    one = oaktwin.filters.temporal(alpha=0.4, persistency=3)
    for frame in frames[:2]:
        # The items see the frames in different orders.
        assert np.array_equal(temporal(np.stack([frame, image]))[0], one(frame))
    temporal.reset([1])
    got = temporal(np.stack([frames[2], frames[1]]))
    assert np.array_equal(got[0], one(frames[2])) and not got[1].any()
    temporal.reset(np.array([True, False]))
    assert np.array_equal(temporal(np.stack([frames[2]] * 2))[0], oaktwin.Filter()(frames[2]))
    with pytest.raises(oaktwin.Error, match="items: .*pass the numbers of items, or a mask"):
        temporal.reset([-1])


def test_chains(image):
    chain = oaktwin.Filter("median:size=3", "decimation:factor=2")
    expected = oaktwin.filters.decimation(oaktwin.filters.median(image, size=3), factor=2)
    assert np.array_equal(chain(image), expected)
    assert np.array_equal(oaktwin.Filter()(image), image)
    assert chain(np.empty((0, 40, 60), np.uint16)).shape[0] == 0


def test_results_are_written_in_place(image):
    metres, small = (image / 1000).astype(np.float32), (image >> 3).astype(np.uint8)
    for text in ["median:size=5", "decimation:factor=3"]:
        for one in [image, metres, small]:
            chain = oaktwin.Filter(text)
            batch = np.stack([one, one[::-1], one])
            for what in [one, batch, batch[:0]]:
                expected = chain(what)
                whole = np.full((2, *expected.shape), 7, one.dtype)
                assert chain(what, out=whole[0]) is not None
                assert np.array_equal(whole[0], expected) and (whole[1] == 7).all()
    out = np.zeros_like(image)
    assert oaktwin.filters.median(image, size=3, out=out) is out
    assert np.array_equal(out, oaktwin.filters.median(image, size=3))
    rgb = np.full((*image.shape, 3), 200, np.uint8)
    assert oaktwin.filters.brightness(image, rgb, min=100, max=250, out=out) is out and np.array_equal(out, image)


def test_invalid_outputs(image):
    median = oaktwin.Filter("median")
    frozen = np.zeros_like(image)
    frozen.flags.writeable = False
    for error, text, out in [
        (oaktwin.Error, "out: has shape", np.zeros((3, 3), np.uint16)),
        (oaktwin.Error, "out: has shape", np.zeros((1, *image.shape), np.uint16)),
        (TypeError, "pass the image's dtype, uint16", np.zeros(image.shape, np.float32)),
        (TypeError, "pass the image's dtype, uint16", np.zeros(image.shape, ">u2")),
        (TypeError, "list is not an array", [[0]]),
        (oaktwin.Error, "C-contiguous", np.zeros(image.shape, np.uint16, order="F")),
        (oaktwin.Error, "read-only", frozen),
        (oaktwin.Error, "pass a separate array", image),
        (oaktwin.Error, "pass a separate array", memoryview(image)),
    ]:
        with pytest.raises(error) as raised:
            median(image, out=out)
        assert text in str(raised.value)
    both = np.zeros((3, *image.shape), np.uint16)
    with pytest.raises(oaktwin.Error, match="pass a separate array"):
        median(both[:2], out=both[1:])
    assert not frozen.any()


def test_bad_filters(image):
    for text, call in [
        ("unknown filter 'medium'; did you mean 'median'?", lambda: oaktwin.Filter("medium")),
        ("expected 3, 5 or 7", lambda: oaktwin.filters.median(image, size=4)),
        ("alpha: 2 is out of range", lambda: oaktwin.filters.spatial(image, alpha=2)),
        ("9 is above max", lambda: oaktwin.filters.threshold(image, min=9, max=3)),
        ("has shape [60]", lambda: oaktwin.filters.median(image[0])),
        ("rgb: has shape", lambda: oaktwin.filters.brightness(image, np.zeros((3, 3, 3), np.uint8))),
    ]:
        with pytest.raises(oaktwin.Error) as raised:
            call()
        assert text in str(raised.value)
    with pytest.raises(TypeError, match="pass uint16, uint8 or floating-point"):
        oaktwin.filters.median(image.astype(np.int32))
    with pytest.raises(TypeError):
        oaktwin.Filter(3)
