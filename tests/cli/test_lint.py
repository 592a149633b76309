"""`dhcli lint`: what an author sees, what an editor or a script reads, and the exit code."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from tests.cli.running import Run
from tests.cli.terminal import Terminal
from tests.lint.linting import ONE_JOINT

ENVELOPE = ["dhcli", "command", "ok", "data", "problems"]
DATA = ["files", "errors", "warnings", "findings"]
FINDING = ["severity", "message", "hint", "source", "line", "column"]


def put(name: str, text: str = ONE_JOINT) -> None:
    """A file in this folder."""
    Path(name).write_text(text, "utf-8")


def test_nothing_to_mend_ends_with_0(dhcli: Run) -> None:
    """One line says what was looked at."""
    put("arm.yaml")
    done = dhcli("lint", "arm.yaml")
    assert (done.code, done.out, done.err) == (0, "1 file: nothing to mend\n", "")


def test_an_error_ends_with_1_and_points_at_its_place(dhcli: Run) -> None:
    """As compilers do, so that editors jump to it; the result of lint is its findings, so they stand on stdout."""
    put("arm.yaml", ONE_JOINT.replace("0.4 m}", "0.4 m, a2: 1 m}"))
    done = dhcli("lint", "arm.yaml")
    assert (done.code, done.err) == (1, "")
    assert done.out.splitlines() == [
        "arm.yaml:6:29: error: a2: no link uses it",
        "  parameters: {a1: 0.4 m, a2: 1 m}",
        "                              ^",
        "  hint: delete it, or put it into the table",
        "1 file: 1 error, 0 warnings",
    ]


def test_a_warning_alone_ends_with_0(dhcli: Run) -> None:
    """An author may leave it."""
    put("arm.yaml", ONE_JOINT.replace("0.4 m", "0 m"))
    done = dhcli("lint", "arm.yaml")
    assert done.code == 0
    assert done.out.startswith("arm.yaml:6:18: warning: a1: is 0\n")
    assert done.out.endswith("\n1 file: 0 errors, 1 warning\n")


def test_bad_usage_ends_with_2_and_an_empty_stdout(dhcli: Run) -> None:
    """A path that leads nowhere, a format that does not exist, and no path where there is no content."""
    put("arm.yaml")
    for words, told in (
        (("arm.yaml", "leg.yaml"), "dhcli: leg.yaml: there is no such file\n"),
        (("arm.yaml", "--format", "csv"), "dhcli: there is no format csv for findings\n  hint: formats: json, table\n"),
        ((), "dhcli: there is no ./robots and no ./exercises here\n"),
    ):
        done = dhcli("lint", *words)
        assert (done.code, done.out) == (2, "")
        assert done.err.startswith(told)


def test_json_has_the_same_keys_with_and_without_findings(dhcli: Run) -> None:
    """And the command worked, whatever it found: `ok` is about dhcli, the exit code about the content."""
    put("good.yaml")
    clean = dhcli("lint", "good.yaml", "--format", "json")
    assert clean.code == 0
    put("arm.yaml", ONE_JOINT.replace("An arm", "TODO").replace("0.4 m", "0 m"))
    put("broken.yaml", "format: 1\ntitle: [\n")
    found = dhcli("lint", ".", "--format", "json")
    assert (found.code, found.err) == (1, "")
    for done in (clean, found):
        assert list(done.envelope) == ENVELOPE
        assert list(done.envelope["data"]) == DATA
        assert (done.envelope["ok"], done.envelope["command"], done.envelope["problems"]) == (True, "lint", [])
    assert clean.envelope["data"] == {"files": ["good.yaml"], "errors": 0, "warnings": 0, "findings": []}
    data = found.envelope["data"]
    assert data["files"] == ["arm.yaml", "broken.yaml", "good.yaml"]
    assert (data["errors"], data["warnings"]) == (2, 1)
    assert [list(one) for one in data["findings"]] == [FINDING] * 3
    assert [(one["severity"], one["source"], one["line"], one["column"]) for one in data["findings"]] == [
        ("error", "arm.yaml", 2, 8),
        ("warning", "arm.yaml", 6, 18),
        ("error", "broken.yaml", 3, 1),
    ]
    assert data["findings"][0]["message"] == "title: still says 'TODO'"
    assert data["findings"][0]["hint"] == "write what belongs there"


def test_json_tells_bad_usage_too(dhcli: Run) -> None:
    """On stdout, where a script looks."""
    done = dhcli("lint", "leg.yaml", "--format", "json")
    assert done.code == 2
    assert list(done.envelope) == ENVELOPE
    assert (done.envelope["ok"], done.envelope["data"]) == (False, None)
    assert [(one["source"], one["message"]) for one in done.envelope["problems"]] == [
        ("leg.yaml", "there is no such file")
    ]


def test_findings_can_be_written_to_a_file(dhcli: Run) -> None:
    """The exit code stays."""
    put("arm.yaml", ONE_JOINT.replace("An arm", "TODO"))
    assert dhcli("lint", "arm.yaml", "-o", "found.json").code == 1
    assert '"errors": 1' in Path("found.json").read_text("utf-8")


def test_a_pipe_gets_plain_text_and_whole_lines(dhcli: Run, tmp_path: Path) -> None:
    """No colour, and no line folded, however long; where there is no Unicode, letters that there are."""
    name = "arm-with-a-name-that-is-so-long-that-no-terminal-of-eighty-columns-could-hold-a-line-with-it.yaml"
    (tmp_path / name).write_text(
        ONE_JOINT.replace("theta: theta1", "theta: 3*theta1").replace("An arm", "TODO θ"), "utf-8"
    )
    done = dhcli("lint", name)
    assert (done.code, done.err) == (1, "")
    assert "\x1b" not in done.out
    assert f"{name}:2:8: error: title: still says 'TODO'\n  title: TODO θ\n" in done.out
    assert f"{name}:8:36: warning: theta of row 1: one degree of theta1 turns the joint by 3\n" in done.out
    ascii_only = dhcli("lint", name, PYTHONIOENCODING="ascii")
    assert ascii_only.code == 1
    assert ascii_only.out.isascii()
    assert "title: TODO" in ascii_only.out


def test_control_characters_of_a_file_never_reach_the_terminal(dhcli: Run) -> None:
    """Neither those of a message nor those of the line that is shown."""
    put("arm.yaml", ONE_JOINT.replace("title: An arm", 'title: "TODO \\e[2J"').replace("a test", "TODO \u202e"))
    done = dhcli("lint", "arm.yaml")
    assert done.code == 1
    assert not set(done.out) & {"\x1b", "\u202e"}


@pytest.mark.skipif(os.name == "nt", reason="pseudo-terminals as Unix knows them")
@pytest.mark.parametrize(("no_color", "colour"), [("1", False), ("", True)])
def test_a_terminal_gets_colour_unless_it_is_not_wanted(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, no_color: str, *, colour: bool
) -> None:
    """Severity is a word, never colour alone."""
    (tmp_path / "arm.yaml").write_text(ONE_JOINT.replace("An arm", "TODO"), "utf-8")
    monkeypatch.setenv("TERM", "xterm-256color")
    with Terminal(tmp_path, "lint", "arm.yaml", no_color=no_color) as screen:
        seen = screen.until("1 file: 1 error, 0 warnings")
        assert screen.end() == 1
    assert ("\x1b[" in seen) is colour
    assert "error:" in seen


@pytest.mark.parametrize("path", [".", "arm.yaml"])
def test_lint_shows_every_finding_of_a_folder(dhcli: Run, path: str) -> None:
    """A file that cannot be read stands beside those that can."""
    put("arm.yaml", ONE_JOINT.replace("An arm", "TODO"))
    Path("other.yaml").write_bytes(b"\xff\xfe")
    done = dhcli("lint", path, "other.yaml")
    assert done.code == 1
    assert "arm.yaml:2:8: error: title: still says 'TODO'" in done.out
    assert "other.yaml: error: is written in UTF-16\n  hint: save it as UTF-8\n" in done.out
    assert done.out.endswith("2 files: 2 errors, 0 warnings\n")
