"""`python -m oaktwin`: the program."""

import signal
import sys

from . import _oaktwin


def main() -> int:
    """Runs the program with this process's arguments; its exit code."""
    # As of a program of its own: Ctrl-C ends it where it does not watch for it itself.
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    return _oaktwin.main(sys.argv[1:])


if __name__ == "__main__":
    sys.exit(main())
