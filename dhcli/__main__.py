"""`python -m dhcli`, and where the installed command begins."""

import gc
import sys


def main() -> int:
    """Run the command line; see `dhcli.cli.main`."""
    # A command lives for a moment and what it imports stays: looking for garbage on the way finds none.
    gc.set_threshold(100_000)
    from dhcli.cli.main import main as run

    return run()


if __name__ == "__main__":
    sys.exit(main())
