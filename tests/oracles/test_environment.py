"""The environment has the pinned packages."""

import os
from pathlib import Path


def test_program_is_there() -> None:
    assert Path(os.environ["OAKTWIN_BIN"]).is_file()


def test_openusd_is_one_of_the_two() -> None:
    from pxr import Usd

    assert Usd.GetVersion() in {(0, 24, 5), (0, 26, 11)}
