"""Batches of image pairs, threads and interruption of the stereo matcher."""

import json
import sys
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

import oaktwin
from conftest import BASELINE, FX, run_and_interrupt, same, ticks_during


def test_many_threads(matcher, textured):
    left, right, _, _ = textured
    pairs = [(left, right), (left[:60].copy(), right[:60].copy()), (right, right), (left[:, :200].copy(), right[:, :200].copy())]
    expected = [matcher(*one) for one in pairs]
    own = oaktwin.StereoMatcher(fx=FX, baseline=BASELINE)

    def work(number):
        for i in range(2):
            for one in [matcher, own]:
                assert same(one(*pairs[(number + i) % 4]), expected[(number + i) % 4])

    with ThreadPoolExecutor(8) as pool:
        list(pool.map(work, range(8)))


def test_the_interpreter_runs_meanwhile(textured):
    left, right = (np.tile(image, (6, 4)) for image in textured[:2])
    matcher = oaktwin.StereoMatcher(fx=FX, baseline=BASELINE)
    # A busy machine may run the other thread too late.
    assert any(ticks_during(lambda: matcher(left, right)) > 3 for _ in range(20))


@pytest.mark.skipif(sys.platform == "win32", reason="no SIGINT to send")
def test_ctrl_c():
    text = """
import numpy as np, oaktwin
matcher = oaktwin.StereoMatcher(fx=400, baseline=0.075)
image = np.random.default_rng(0).integers(0, 255, (200, 320)).astype(np.uint8)
try:
    print("ready", flush=True)
    list(map(matcher, [image] * 100000, [image] * 100000))
    print("finished")
except KeyboardInterrupt:
    print("interrupted")
"""
    assert run_and_interrupt(text) == "interrupted\n"


def test_accuracy_of_matching(program):
    measured = oaktwin.accuracy(
        oaktwin.Device("OAK4-D"), engine="stereo-matching", distances=[1.5], devices=1, captures=1
    )
    text = program(
        "accuracy", "OAK4-D", "--engine", "stereo-matching", "--distances", 1.5, "--devices", 1, "--captures", 1, "--json"
    )
    assert measured.report["distances"] == json.loads(text)["distances"]
    assert measured.rows[0]["error_percent"] < 2


def test_a_batch_equals_single_pairs(textured):
    left, right, _, _ = textured
    lefts = np.stack([np.roll(left, 7 * k, axis=0) for k in range(5)])
    rights = np.stack([np.roll(right, 7 * k, axis=0) for k in range(5)])
    lefts[2] = rights[2] = 90
    for options in [{}, {"platform": "rvc4"}, {"preset": "default"}, {"preset": "robotics", "platform": "rvc4"}]:
        matcher = oaktwin.StereoMatcher(fx=FX, baseline=BASELINE, **options)
        seen = matcher(lefts, rights)
        for k in range(5):
            alone = oaktwin.StereoMatcher(fx=FX, baseline=BASELINE, **options)(lefts[k], rights[k])
            for name in set(alone) - {"findings"}:
                assert seen[name].dtype == alone[name].dtype
                assert np.array_equal(seen[name][k], alone[name]), (options, k, name)
        assert [(finding.code, finding.place[:7]) for finding in seen["findings"]] == [("no-texture", "pair 2:")]
        # A batch leaves no state.
        assert same(matcher(lefts[0], rights[0]), oaktwin.StereoMatcher(fx=FX, baseline=BASELINE, **options)(left, right))


def test_dtypes_and_shapes_of_batches(matcher, textured):
    left, right, _, _ = textured
    seen = matcher(left, right)
    ten = matcher(left[None].astype(np.uint16) * 4, right[None].astype(np.uint16) * 4)
    assert ten["rectified_left"].dtype == np.uint16 and ten["depth"].shape == (1, 120, 320)
    colours = matcher(np.stack([left] * 3, -1)[None], np.stack([right] * 3, -1)[None])
    assert np.array_equal(colours["depth"][0], seen["depth"])
    none = matcher(np.zeros((0, 12, 20), np.uint8), np.zeros((0, 12, 20), np.uint8))
    assert {name: array.shape for name, array in none.items() if name != "findings"} == dict.fromkeys(
        ["depth", "disparity", "confidence", "rectified_left", "rectified_right"], (0, 12, 20)
    )
    wrong = [
        ((left[None], right), "a batch of 1"),
        ((left[None], np.stack([right, right])), "a batch of 2"),
        ((left[None], right[None, :, :-1]), "same size"),
        ((left[None], right[None].astype(np.uint16)), "same size and dtype"),
        ((left[None, None], right[None, None]), "batch"),
    ]
    for images, message in wrong:
        with pytest.raises(oaktwin.Error, match=message):
            matcher(*images)
