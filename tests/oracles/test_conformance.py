"""The program against Isaac Sim's own output, where OAKTWIN_TEST_DATA has it."""

import os
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import conformance


DATA = Path(os.environ.get("OAKTWIN_TEST_DATA", "no-such-folder")) / "conformance"


@pytest.mark.parametrize("compare", [conformance.point_clouds, conformance.camera_parameters])
def test_the_program_renders_what_isaac_sim_rendered(program: Path, compare: Callable) -> None:
    done = list(compare(program, DATA))
    if not done:
        pytest.skip("OAKTWIN_TEST_DATA has no conformance data")
    assert not [comparison for comparison in done if not comparison.is_same]


def test_points_are_paired_one_to_one() -> None:
    rng = np.random.default_rng(3)
    ours = rng.uniform(-1, 1, (500, 3))
    shuffled = rng.permutation(ours) + 1e-6
    missing, worst = conformance.matched(ours, shuffled, 2e-5)
    assert missing == 0 and 1e-6 < worst < 2e-6
    # Each column alone would still sort to the same numbers.
    mixed = np.stack([ours[:, 0], np.roll(ours[:, 1], 1), ours[:, 2]], -1)
    assert conformance.matched(ours, mixed, 2e-5)[0] > 490
    # A point that stands in for two leaves one without a partner.
    twice = np.concatenate([ours[:-1], ours[:1]])
    assert conformance.matched(ours, twice, 2e-5)[0] == 1
    assert conformance.matched(ours[:-1], ours, 2e-5)[0] >= 1
