"""`python -m dhcli`, and where the installed command begins."""

import gc
import os
import sys


def main() -> int:
    """Run the command line; see `dhcli.cli.main`."""
    # A command lives for a moment and what it imports stays: looking for garbage on the way finds none.
    gc.set_threshold(100_000)
    # The matrices are small: more threads of numpy's than one do nothing for them but be started, or get in the way.
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    try:
        from dhcli.cli.main import main as run

        return run()
    except KeyboardInterrupt:  # so early that nothing is there yet to say it
        return 130
    finally:
        gc.freeze()  # all goes with the process: Python, when it ends, need not look through it for garbage, twice


if __name__ == "__main__":
    sys.exit(main())
