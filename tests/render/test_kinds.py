"""The registry of renderers, and output that does not depend on the window."""

import re
import subprocess
import sys
from importlib import import_module
from pathlib import Path

import pytest

from dhcli.errors import UnknownNameError
from dhcli.render import kinds
from tests.cli.running import run
from tests.row_by_row import row_by_row

ROOT = Path(__file__).parents[2]


@row_by_row("where", sorted({*kinds._RENDERERS.values(), *(one.content for one in kinds._KINDS.values())}))
def test_every_renderer_that_is_registered_exists(where: str) -> None:
    """They are imported late, so a misspelling would show late."""
    module, _, function = where.partition(":")
    assert callable(getattr(import_module(f"dhcli.render.{module}"), function))


def test_every_kind_has_a_table_and_json() -> None:
    """The two formats that always exist; a function is code, for which the terminal has no better form."""
    for kind in kinds._KINDS.keys() - {"function", "inverse function"}:
        assert {"json", "table"} <= set(kinds.formats(kind))


def test_an_unknown_pair_lists_the_formats_there_are() -> None:
    """By the noun of the kind."""
    with pytest.raises(UnknownNameError, match=r"no format matlab for a robot .*json, table, latex, csv"):
        kinds.check_format("robot", "matlab")


@pytest.fixture(autouse=True)
def bare_environment(monkeypatch: pytest.MonkeyPatch) -> None:
    """Nothing is said of a window or of colours but by the test itself."""
    for name in ("COLUMNS", "LINES", "NO_COLOR", "TERM"):
        monkeypatch.delenv(name)


def _piped(words: str, **environment: str) -> str:
    done = run(*words.split(), **environment)
    assert done.code == 0, done.err
    return done.out


@pytest.mark.parametrize("words", ["fk puma560 -s", "fk scara -s --frames", "show puma560", "list robots"])
def test_piped_output_depends_neither_on_the_window_nor_on_colours(words: str) -> None:
    """A script reads the same everywhere."""
    narrow = _piped(words, COLUMNS="40", TERM="xterm-256color")
    assert narrow == _piped(words, COLUMNS="200", TERM="dumb", NO_COLOR="1")
    assert "\x1b" not in narrow


@pytest.mark.parametrize(
    "words", ["fk puma560 -s", "fk scara --pose pick --as rpy", "show puma560", "list robots", "fk --help"]
)
def test_a_stream_without_unicode_gets_ascii(words: str) -> None:
    """Letters by name, brackets and lines from the keyboard, and no question marks."""
    text = _piped(words, PYTHONIOENCODING="ascii")
    assert text.isascii()
    assert text.count("?") == _piped(words).count("?")


def test_a_process_writes_to_its_streams_as_the_tests_above_do() -> None:
    """With nothing in its environment but how its stream is encoded."""
    words = "fk scara -s"
    done = subprocess.run(
        [sys.executable, "-m", "dhcli", *words.split()],
        cwd=ROOT,
        env={"PYTHONIOENCODING": "ascii"},
        stdin=subprocess.DEVNULL,
        capture_output=True,
        encoding="ascii",
        timeout=60,
        check=True,
    )
    assert done.stdout == _piped(words, PYTHONIOENCODING="ascii")


def test_colours_can_be_forced_through_a_pipe() -> None:
    """For `less -R`; the text is the same."""
    coloured = _piped("fk scara -s", FORCE_COLOR="1")
    assert "\x1b[" in coloured
    assert re.sub(r"\x1b\[[0-9;]*m", "", coloured) == _piped("fk scara -s")


def test_joint_variables_are_underlined_in_the_table() -> None:
    """And lengths are not."""
    coloured = _piped("show planar-2r", FORCE_COLOR="1")
    assert "\x1b[4mtheta1\x1b[0m" in coloured
    assert "\x1b[4ma1" not in coloured
