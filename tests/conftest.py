"""What every test stands on: a fixed environment, hypothesis without a clock, and no user folders but its own.

typer reads some of these variables when it is imported, so they are set here, before any test module is.
"""

import atexit
import gc
import os
import re
import signal
import sys
from collections.abc import Generator
from contextlib import suppress
from importlib import import_module
from importlib.util import find_spec
from itertools import count
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest

os.environ["HYPOTHESIS_NO_PLUGINS"] = "1"  # that of trio, which comes with selenium, imports all of trio
from hypothesis import HealthCheck, settings

from tests import once, reporting

collect_ignore = ["bench"]  # programs of their own, not modules with examples to run

_FIXED = {
    "COLUMNS": "80",
    "LINES": "24",
    "NO_COLOR": "1",
    "OPENBLAS_NUM_THREADS": "1",  # as in every command; workers have all cores, and a thread that waits keeps one busy
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
    # every worker, and every process that a test starts, would compile all of dhcli and of the tests for itself
    "PYTHONDONTWRITEBYTECODE",
)

os.environ.update(_FIXED)
for _name in _UNSET:
    os.environ.pop(_name, None)
sys.dont_write_bytecode = False

# A shell that starts the tests in the background has them ignore Ctrl-C, nohup has them ignore the end of a terminal,
# and so would every process that a test stops.
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)
if hasattr(signal, "SIGHUP") and signal.getsignal(signal.SIGHUP) is signal.SIG_IGN:
    signal.signal(signal.SIGHUP, signal.SIG_DFL)

gc.set_threshold(200_000, 10, 10)  # while thousands of tests are made, of which none is garbage

once.remember()

# A busy machine is not a failure: no deadline, and no health check that looks at the clock. At the desk other examples
# are tried each time, in CI always the same few; `--hypothesis-profile nightly` tries many, and runs what is nightly.
_PATIENT = settings(max_examples=15, deadline=None, suppress_health_check=[HealthCheck.too_slow])
settings.register_profile("default", _PATIENT)
settings.register_profile("ci", _PATIENT, database=None, derandomize=True, print_blob=True)
settings.register_profile("nightly", settings.get_profile("ci"), max_examples=500)
settings.load_profile("ci" if os.environ.get("CI") else "default")


def pytest_configure(config: pytest.Config) -> None:
    """Look for examples where there are some, and tell of tests shortly; a worker ends as soon as it has told all."""
    config.pluginmanager.register(Examples())
    reporting.pytest_configure(config)
    if hasattr(config, "workerinput"):
        atexit.register(os._exit, 0)  # what registers later is done before; then Python would take all apart


@pytest.hookimpl(tryfirst=True)
def pytest_unconfigure(config: pytest.Config) -> None:
    """Search for no garbage in a worker that has told all: what is found there nobody hears of."""
    _HOMES.cleanup()
    if hasattr(config, "workerinput"):
        gc.freeze()


@pytest.hookimpl(tryfirst=True)
def pytest_collection(session: pytest.Session) -> None:
    """Have every other worker import all tests from the last to the first, so that none compiles what another has."""
    config = session.config
    number = getattr(config, "workerinput", {"workerid": "0"})["workerid"].removeprefix("gw")
    if int(number) % 2 and config.args_source is pytest.Config.ArgsSource.TESTPATHS:
        for path in sorted(Path(__file__).parent.rglob("test_*.py"), reverse=True):
            with suppress(Exception, pytest.skip.Exception):  # told where it is collected
                import_module(".".join(path.relative_to(config.rootpath).with_suffix("").parts))


class Examples:
    """Finds no doctests where there are none, which pytest would look for in every function of every module."""

    @pytest.hookimpl(wrapper=True)
    def pytest_collect_file(self, file_path: Path) -> Generator[None, list[pytest.Collector], list[pytest.Collector]]:
        """Keep what is found in a file but its doctests, unless an example stands in it."""
        found = yield
        if file_path.suffix != ".py" or b">>>" in file_path.read_bytes():
            return found
        return [collector for collector in found if type(collector) is pytest.Module]


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Leave out what is marked nightly, unless it is night."""
    if settings.get_current_profile_name() == "nightly":
        return
    _draw_no_literals()
    left_out = [item for item in items if item.get_closest_marker("nightly")]
    if left_out:
        config.hook.pytest_deselected(items=left_out)
        items[:] = [item for item in items if not item.get_closest_marker("nightly")]


def _draw_no_literals() -> None:
    """Have hypothesis draw no literal of our own code, which it would search in all modules that are imported by then.

    That takes it seconds, and which examples it tries would depend on what is imported. It has no setting for it.
    """
    providers = sys.modules.get("hypothesis.internal.conjecture.providers")
    literals = getattr(providers, "_local_constants", None)
    if hasattr(providers, "_get_local_constants"):
        providers._get_local_constants = lambda: literals


def pytest_collection_finish() -> None:
    """Spare the collector of garbage the thousands of tests that were found, which live to the end."""
    gc.freeze()
    gc.set_threshold(50_000, 20, 20)


_FOUND = set(os.listdir())  # where the tests are started: a checkout


def pytest_sessionfinish(session: pytest.Session) -> None:
    """Fail where a test wrote beside the project's own files and left it there; its own folder is `tmp_path`."""
    if hasattr(session.config, "workerinput"):
        return  # told once, by the process that sees all workers end
    left = sorted(name for name in set(os.listdir(session.config.invocation_params.dir)) - _FOUND if name[0] != ".")
    if left:
        session.exitstatus = pytest.ExitCode.TESTS_FAILED
        sys.stderr.write(f"\nleft behind by a test in the folder of the project: {', '.join(left)}\n")


_HOMES = TemporaryDirectory(prefix="dhcli-tests-")
_NUMBERS = count()


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_setup() -> None:
    """Give each test its own folders for user data, not made yet, and no robots of the person who runs the tests.

    A fixture for each test would cost seconds in all, and so would folders.
    """
    folder = f"{_HOMES.name}/user-data-{next(_NUMBERS)}"
    os.environ["XDG_DATA_HOME"], os.environ["XDG_CACHE_HOME"] = folder, f"{folder}-cache"  # until the next test
    os.environ.pop("DHCLI_PATH", None)


@pytest.fixture
def user_data() -> Path:
    """The test's own folder for user data."""
    return Path(os.environ["XDG_DATA_HOME"])


@pytest.fixture
def tmp_path(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder for the test. pytest's own looks for a free number among the folders of all tests before."""
    name = re.sub(r"\W", "_", request.node.name)[:30]
    return tmp_path_factory.mktemp(f"{name}{next(_NUMBERS)}", numbered=False)


_NEEDS_ORJSON = pytest.mark.skipif(find_spec("orjson") is None, reason="the extra [fast] is not installed")


@pytest.fixture(params=["Python", pytest.param("orjson", marks=_NEEDS_ORJSON)])
def json_by(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    """Numbers are read and written in the plain way, and by orjson where it is installed."""
    from dhcli.notation import decimals  # numpy, which few tests need

    if request.param == "Python":
        monkeypatch.setattr(decimals, "quick_json", lambda: None)
