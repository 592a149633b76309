"""What every test stands on: a fixed environment, hypothesis without a clock, and no user folders but its own.

typer reads some of these variables when it is imported, so they are set here, before any test module is.
"""

import os
import signal
from pathlib import Path

import pytest
from hypothesis import HealthCheck, settings

collect_ignore = ["bench"]  # programs of their own, not modules with examples to run

_FIXED = {
    "COLUMNS": "80",
    "LINES": "24",
    "NO_COLOR": "1",
    "PYTHONIOENCODING": "utf-8",  # of the processes that tests start; those about other encodings set their own
    "TERM": "xterm-256color",
}
_UNSET = (
    # each of these makes typer or rich take a pipe for a terminal, or change the width or the colours
    *("CLICOLOR_FORCE", "COLORTERM", "FORCE_COLOR", "GITHUB_ACTIONS", "PY_COLORS", "TERMINAL_WIDTH"),
    *("TTY_COMPATIBLE", "TTY_INTERACTIVE", "_TYPER_FORCE_DISABLE_TERMINAL"),
    *("TYPER_STANDARD_TRACEBACK", "_TYPER_STANDARD_TRACEBACK", "TYPER_USE_RICH"),
    # a warning turned into an error by the caller would change what a command writes to stderr
    *("PYTHONDEVMODE", "PYTHONWARNINGS"),
)

os.environ.update(_FIXED)
for _name in _UNSET:
    os.environ.pop(_name, None)

# A shell that starts the tests in the background has them ignore Ctrl-C, nohup has them ignore the end of a terminal,
# and so would every process that a test stops.
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)
if hasattr(signal, "SIGHUP") and signal.getsignal(signal.SIGHUP) is signal.SIG_IGN:
    signal.signal(signal.SIGHUP, signal.SIG_DFL)

# A busy machine is not a failure: no deadline, and no health check that looks at the clock.
_PATIENT = settings(deadline=None, suppress_health_check=[HealthCheck.too_slow])
settings.register_profile("default", _PATIENT)
settings.register_profile("ci", _PATIENT, database=None, derandomize=True, print_blob=True)
settings.load_profile("ci" if os.environ.get("CI") else "default")


@pytest.fixture(autouse=True)
def user_data(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Path:
    """The test's own folder for user data, not made yet; no robots of the person who runs the tests."""
    folder = tmp_path / "user-data"
    monkeypatch.setenv("XDG_DATA_HOME", str(folder))
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "user-cache"))
    monkeypatch.delenv("DHCLI_PATH", raising=False)
    return folder
