"""The soak test runs for a few seconds here: its outputs repeat; and its verdicts, on samples made up for them."""

import importlib.util
import os
import sys
from pathlib import Path

import pytest

SCRIPT = Path(__file__).parents[3] / "tests/soak/soak.py"
sys.path.insert(0, str(SCRIPT.parent))
SPEC = importlib.util.spec_from_file_location("soak", SCRIPT)
soak = importlib.util.module_from_spec(SPEC)
SPEC.loader.exec_module(soak)

pytestmark = pytest.mark.skipif(not Path("/proc/self/statm").exists(), reason="needs Linux's /proc")


@pytest.mark.parametrize("name", soak.LOADS)
def test_outputs_of_a_load_repeat(name, tmp_path):
    if not os.environ.get("OAKTWIN_BIN"):
        pytest.skip("OAKTWIN_BIN names no program: run by cargo xtask test")
    load = soak.LOADS[name](os.environ["OAKTWIN_BIN"], 15, tmp_path)
    assert load.compared > 0
    assert not load.faults
    assert len(load.samples) > 20


def judged(samples, outputs=(b"a", b"a")):
    load = soak.Load("load", "outputs", 1, ["true"])
    load.process.wait()
    load.samples = samples
    for output in outputs:
        load.compare("key", output)
    load.row()
    return set(load.faults)


def test_verdicts():
    flat = [(100.0, 5)] * 40
    assert judged(flat) == set()
    assert judged([(100.0 + k, 5) for k in range(40)]) == {"memory grew"}
    assert judged([(100.0 + k, 5) for k in range(10)] + [(109.0, 5)] * 30) == set(), "the warm-up may grow"
    assert judged([(100.0, 5)] * 30 + [(100.0, 6)] * 10) == {"descriptors leaked"}
    assert judged(flat, (b"a", b"b")) == {"changed bytes"}
    assert judged(flat, (b"a",)) == {"too short to judge"}
    assert judged([(100.0, 5)]) == {"too short to judge"}
