import sys
from pathlib import Path

from oaktwin.depthai.pytest import virtual_oak  # noqa: F401

sys.path.insert(0, str(Path(__file__).parents[1]))
