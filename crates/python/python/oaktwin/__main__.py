"""Runs the program as `python -m oaktwin`."""

import os
import signal
import sys

from . import _oaktwin


def main() -> int:
    """Runs the program with this process's arguments and returns its exit code."""
    # As in the standalone program, Ctrl-C terminates the process unless the program handles it.
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    os.environ.setdefault("OAKTWIN_PYTHON", sys.executable)
    return _oaktwin.main(sys.argv[1:])


if __name__ == "__main__":
    sys.exit(main())
